//! A picture of the cut of a piece, painted again now and then.

use egui::{TextureHandle, TextureOptions, Ui};
use saute_kitchen::Piece;
use saute_kitchen::heat::Layout;
use saute_picture::colour::map::TemperatureMap;
use saute_picture::cut::section::section_picture;
use saute_picture::view::View;

use saute_controls::context::PanelContext;

/// Pictures of the cut of a steak are painted at this scale [pixels/mm] (chosen: sharp in the panel, 4 ms a picture).
const PER_MM: f64 = 3.2;
/// Width of the picture's place in the panel [points]; narrower pieces are painted finer.
const PANEL_WIDTH: f64 = 276.0;
/// Interval at which the picture is repainted [wall s] (chosen).
const REPAINT_S: f64 = 0.4;

/// A picture of the cut, with what it was painted for.
#[derive(Default)]
pub struct CutPicture {
    texture: Option<TextureHandle>,
    painted_at: f64,
    painted_for: Option<Painted>,
}

/// What a picture of the cut was painted for.
#[derive(Clone, Debug, PartialEq)]
struct Painted {
    generation: u64,
    place: i64,
    view: View,
    map: TemperatureMap,
    scale: Option<String>,
    flipped: bool,
}

impl CutPicture {
    /// Paints the cut of a piece at a place (−1…1) again, at intervals and as soon as it should look different; returns true if it did.
    pub fn refresh(&mut self, state: &PanelContext, piece: &Piece, cut_at: f64, ui: &Ui) -> bool {
        let now = ui.input(|i| i.time);
        let wanted = Painted::wanted(state, piece, cut_at);
        if self.painted_for.as_ref() == Some(&wanted) && now - self.painted_at < REPAINT_S {
            return false;
        }
        self.paint(state, (piece, cut_at), ui, &wanted);
        (self.painted_at, self.painted_for) = (now, Some(wanted));
        true
    }

    /// The picture that was painted last.
    pub fn texture(&self) -> Option<&TextureHandle> {
        self.texture.as_ref()
    }

    fn paint(&mut self, state: &PanelContext, (piece, cut_at): (&Piece, f64), ui: &Ui, wanted: &Painted) {
        let x = cut_at * saute_picture::stage::half_length(piece);
        let colours = wanted.view.colour_map(wanted.map, state.scale().as_deref());
        let picture = section_picture(piece, x, wanted.view, colours.as_ref(), per_mm(piece));
        let image = egui::ColorImage::from_rgba_unmultiplied([picture.width, picture.height], &picture.rgba);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(ui.ctx().load_texture("cut", image, TextureOptions::LINEAR)),
        }
    }
}

impl Painted {
    fn wanted(state: &PanelContext, piece: &Piece, cut_at: f64) -> Self {
        Self {
            generation: state.session.generation,
            place: (cut_at * 1e4) as i64,
            view: state.settings.view,
            map: state.settings.map,
            scale: state.scale().map(|s| s.id.clone()),
            flipped: piece.upside_down(),
        }
    }
}

/// Fineness at which the cut of a piece is sharp in the panel [pixels/mm].
fn per_mm(piece: &Piece) -> f64 {
    let model = &piece.model;
    // A cut that follows a curved body shows all of its length.
    let across = 1e3
        * match model.mesh().layout() {
            Layout::Along(mesh, _) => mesh.thickness(),
            Layout::Upright(_) | Layout::Cells(_) => model.size()[0].min(model.size()[1]),
        };
    (PANEL_WIDTH / across).clamp(PER_MM, 8.0 * PER_MM)
}
