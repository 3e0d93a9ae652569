//! What the gallery shows: figures of panels, each a moment of a cook seen in one way.

use saute_picture::View;

/// Where the eye is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Eye {
    /// Near one piece.
    Piece,
    /// Near one piece, on the side to which its cut looks.
    Cut,
    /// Over the whole pan.
    Pan,
}

/// One picture of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// Which cook: the name of a file in `gallery/`.
    pub cook: &'static str,
    /// Time after the first food went into the pan [s].
    pub after_s: f64,
    /// What the colours mean.
    pub view: View,
    /// Where the eye is.
    pub eye: Eye,
}

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Name of its file, without the ending.
    pub name: &'static str,
    /// What it is of.
    pub title: &'static str,
    /// What there is to see.
    pub caption: &'static str,
    /// Its pictures, row by row.
    pub panels: Vec<Panel>,
    /// Pictures in a row.
    pub columns: usize,
}

/// The cooks of the gallery: names and recipes.
pub const COOKS: [(&str, &str); 6] = [
    ("one-side", include_str!("../../../../gallery/one-side.toml")),
    ("turned", include_str!("../../../../gallery/turned.toml")),
    ("marbled", include_str!("../../../../gallery/marbled.toml")),
    ("untouched", include_str!("../../../../gallery/untouched.toml")),
    ("turned-often", include_str!("../../../../gallery/turned-often.toml")),
    ("stir-fried", include_str!("../../../../gallery/stir-fried.toml")),
];

/// All figures, in the order of the paper's.
pub fn figures() -> Vec<Figure> {
    let panel = |cook, after_s, view, eye| Panel { cook, after_s, view, eye };
    let looks = |cook, times: &[f64], eye| times.iter().map(|t| panel(cook, *t, View::Look, eye)).collect::<Vec<_>>();
    vec![
        Figure {
            name: "1-one-side",
            title: "A steak heated from one side",
            caption: "The cut at four times. Heat rises from the pan; flesh turns from red through pink to grey-brown from below, and browns where it touches the pan.",
            panels: looks("one-side", &[10.0, 90.0, 180.0, 360.0], Eye::Cut),
            columns: 2,
        },
        Figure {
            name: "2-turned",
            title: "The same steak, turned after three minutes",
            caption: "The cut just before the flip and at three times after it. The browned face is on top; the band below it keeps cooking by its own heat while the other face heats up.",
            panels: looks("turned", &[178.0, 190.0, 260.0, 420.0], Eye::Cut),
            columns: 2,
        },
        Figure {
            name: "3-temperature",
            title: "Temperature and look at one instant",
            caption: "Outside and cut, 80 seconds after the flip: temperature on the left, natural look on the right.",
            panels: vec![
                panel("turned", 260.0, View::Temperature, Eye::Piece),
                panel("turned", 260.0, View::Look, Eye::Piece),
                panel("turned", 260.0, View::Temperature, Eye::Cut),
                panel("turned", 260.0, View::Look, Eye::Cut),
            ],
            columns: 2,
        },
        Figure {
            name: "4-lean-and-marbled",
            title: "Lean and marbled",
            caption: "Left lean, right marbled: raw, the cut after 90 seconds, and its temperature. Fat conducts and stores less heat than flesh, so the isotherms bend around the seams.",
            panels: vec![
                panel("one-side", 2.0, View::Look, Eye::Piece),
                panel("marbled", 2.0, View::Look, Eye::Piece),
                panel("one-side", 90.0, View::Look, Eye::Cut),
                panel("marbled", 90.0, View::Look, Eye::Cut),
                panel("one-side", 90.0, View::Temperature, Eye::Cut),
                panel("marbled", 90.0, View::Temperature, Eye::Cut),
            ],
            columns: 2,
        },
        Figure {
            name: "5-untouched-and-turned",
            title: "Carrots, shrimps and leeks: untouched and turned",
            caption: "Left untouched, right every piece turned about once a minute: after one minute and after nearly four.",
            panels: vec![
                panel("untouched", 60.0, View::Look, Eye::Pan),
                panel("turned-often", 60.0, View::Look, Eye::Pan),
                panel("untouched", 230.0, View::Look, Eye::Pan),
                panel("turned-often", 230.0, View::Look, Eye::Pan),
            ],
            columns: 2,
        },
        Figure {
            name: "6-stir-fried",
            title: "Carrots, leeks and shrimps, stir-fried",
            caption: "Shaken and tossed throughout: in the air, halfway, and at the end.",
            panels: looks("stir-fried", &[20.0, 115.0, 240.0], Eye::Pan),
            columns: 3,
        },
    ]
}
