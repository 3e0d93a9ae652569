//! A book of figures: panels, each a view of a cook at one time.

use std::borrow::Cow;

use saute_picture::View;

/// Position of the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Eye {
    /// Near one piece.
    Piece,
    /// Near one piece, on the side of its cut.
    Cut,
    /// Above the whole pan.
    Pan,
}

/// One picture of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// Name of the cook.
    pub cook: &'static str,
    /// Time after the first food went into the pan [s].
    pub after_s: f64,
    /// View: the meaning of the colours.
    pub view: View,
    /// Position of the camera.
    pub eye: Eye,
}

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Name of its file, without the extension.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// Caption.
    pub caption: &'static str,
    /// Panels, row by row.
    pub panels: Cow<'static, [Panel]>,
    /// Number of panels in a row.
    pub columns: usize,
}

/// Figures with the cooks that they show.
#[derive(Debug)]
pub struct Book {
    /// Name of the page with the numbers.
    pub page: &'static str,
    /// Beginning of the page.
    pub opening: &'static str,
    /// Folder of the cooks.
    pub folder: &'static str,
    /// Names and recipes of the cooks.
    pub cooks: Vec<(&'static str, &'static str)>,
    /// The figures in their order.
    pub figures: Vec<Figure>,
}

/// A panel of the natural look.
pub const fn look(cook: &'static str, after_s: f64, eye: Eye) -> Panel {
    Panel { cook, after_s, view: View::Look, eye }
}
