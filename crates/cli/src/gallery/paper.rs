//! The figures of the 2013 paper.

use std::borrow::Cow;

use saute_picture::View;

use super::figure::{Book, Eye, Figure, Panel, look};

/// The figures of the 2013 paper with these foods.
pub fn paper() -> Book {
    Book {
        page: "gallery.md",
        opening: "# Gallery\n\nThe figures of the 2013 paper with this simulator's foods, drawn by `saute gallery`. Every picture shows a moment of a\ncook in `gallery/`; the numbers below it belong to the same moment.\n",
        folder: "gallery",
        cooks: COOKS.to_vec(),
        figures: FIGURES.into(),
    }
}

const fn panel(cook: &'static str, after_s: f64, view: View, eye: Eye) -> Panel {
    Panel { cook, after_s, view, eye }
}

const COOKS: [(&str, &str); 6] = [
    ("one-side", include_str!("../../../../gallery/one-side.toml")),
    ("turned", include_str!("../../../../gallery/turned.toml")),
    ("marbled", include_str!("../../../../gallery/marbled.toml")),
    ("untouched", include_str!("../../../../gallery/untouched.toml")),
    ("turned-often", include_str!("../../../../gallery/turned-often.toml")),
    ("stir-fried", include_str!("../../../../gallery/stir-fried.toml")),
];

const FIGURES: [Figure; 6] = [
    Figure {
        name: "1-one-side",
        title: "A steak heated from one side",
        caption: "The cut at four times. Heat rises from the pan; flesh turns from red through pink to grey-brown from below, and browns where it touches the pan.",
        panels: Cow::Borrowed(&[
            look("one-side", 10.0, Eye::Cut),
            look("one-side", 90.0, Eye::Cut),
            look("one-side", 180.0, Eye::Cut),
            look("one-side", 360.0, Eye::Cut),
        ]),
        columns: 2,
    },
    Figure {
        name: "2-turned",
        title: "The same steak, turned after three minutes",
        caption: "The cut just before the flip and at three times after it. The browned face is on top; the band below it keeps cooking by its own heat while the other face heats up.",
        panels: Cow::Borrowed(&[
            look("turned", 178.0, Eye::Cut),
            look("turned", 190.0, Eye::Cut),
            look("turned", 260.0, Eye::Cut),
            look("turned", 420.0, Eye::Cut),
        ]),
        columns: 2,
    },
    Figure {
        name: "3-temperature",
        title: "Temperature and look at one instant",
        caption: "Outside and cut, 80 seconds after the flip: temperature on the left, natural look on the right.",
        panels: Cow::Borrowed(&[
            panel("turned", 260.0, View::Temperature, Eye::Piece),
            look("turned", 260.0, Eye::Piece),
            panel("turned", 260.0, View::Temperature, Eye::Cut),
            look("turned", 260.0, Eye::Cut),
        ]),
        columns: 2,
    },
    Figure {
        name: "4-lean-and-marbled",
        title: "Lean and marbled",
        caption: "Left lean, right marbled: raw, the cut after 90 seconds, and its temperature. Fat conducts and stores less heat than flesh, so the isotherms bend around the seams.",
        panels: Cow::Borrowed(&[
            look("one-side", 2.0, Eye::Piece),
            look("marbled", 2.0, Eye::Piece),
            look("one-side", 90.0, Eye::Cut),
            look("marbled", 90.0, Eye::Cut),
            panel("one-side", 90.0, View::Temperature, Eye::Cut),
            panel("marbled", 90.0, View::Temperature, Eye::Cut),
        ]),
        columns: 2,
    },
    Figure {
        name: "5-untouched-and-turned",
        title: "Carrots, shrimps and leeks: untouched and turned",
        caption: "Left untouched, right every piece turned about once a minute: after one minute and after nearly four.",
        panels: Cow::Borrowed(&[
            look("untouched", 60.0, Eye::Pan),
            look("turned-often", 60.0, Eye::Pan),
            look("untouched", 230.0, Eye::Pan),
            look("turned-often", 230.0, Eye::Pan),
        ]),
        columns: 2,
    },
    Figure {
        name: "6-stir-fried",
        title: "Carrots, leeks and shrimps, stir-fried",
        caption: "Shaken and tossed throughout: in the air, halfway, and at the end.",
        panels: Cow::Borrowed(&[
            look("stir-fried", 20.0, Eye::Pan),
            look("stir-fried", 115.0, Eye::Pan),
            look("stir-fried", 240.0, Eye::Pan),
        ]),
        columns: 3,
    },
];
