//! How every food looks from raw to burnt.

use std::borrow::Cow;

use include_dir::{Dir, include_dir};

use super::figure::{Book, Eye, Figure, Panel, look};

/// The cooks of the foods: for each one that fries it, and one that burns it, whose name ends in [`BURNT`].
static COOKS: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../gallery/looks");

/// Ending of the name of the cook that burns a food.
const BURNT: &str = "-burnt";

/// When the cook that fries a food is looked at, after the food went into the pan [s].
const FRIED_S: [f64; 8] = [2.0, 60.0, 120.0, 238.0, 246.0, 478.0, 598.0, 612.0];
/// When the cook that burns it is [s].
const BURNT_S: f64 = 612.0;

/// Every food at nine moments: raw, four while it fries, flipped, rested, cut, burnt.
pub fn looks() -> Book {
    let cooks = cooks();
    let burnt = |name: &str| cooks.iter().map(|(cook, _)| *cook).find(|cook| cook.strip_suffix(BURNT) == Some(name));
    let figures = cooks.iter().filter_map(|&(name, text)| Some(figure(name, burnt(name)?, text))).collect();
    Book {
        page: "looks.md",
        opening: "# Every food from raw to burnt\n\nDrawn by `saute gallery --looks`. Row by row: raw, 1 minute, 2 minutes; just before the flip at 4 minutes, just after it, 8\nminutes; rested, cut, and burnt in a pan at 1500 W. Every picture shows a moment of a cook in `gallery/looks/`; the numbers below\nit belong to the same moment.\n",
        folder: "gallery/looks",
        cooks,
        figures,
    }
}

/// Names and recipes of the cooks in the folder, in the order of their names.
fn cooks() -> Vec<(&'static str, &'static str)> {
    let named = COOKS.files().filter_map(|file| Some((file.path().file_stem()?.to_str()?, file.contents_utf8()?)));
    let mut cooks: Vec<_> = named.collect();
    cooks.sort_unstable();
    cooks
}

/// The nine moments of a food, under the title of the cook that fries it.
fn figure(name: &'static str, burnt: &'static str, text: &'static str) -> Figure {
    let title = text.lines().find_map(|line| line.strip_prefix("title = \"")?.strip_suffix('"'));
    let fried = FRIED_S.into_iter().map(|after_s| look(name, after_s, Eye::Piece));
    let panels: Vec<Panel> = fried.chain([look(burnt, BURNT_S, Eye::Piece)]).collect();
    Figure {
        name,
        title: title.unwrap_or(name),
        caption: "Raw, 1 min, 2 min; 4 min, flipped, 8 min; rested, cut, burnt.",
        panels: Cow::Owned(panels),
        columns: 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One cook that is too short stops the figures of all foods.
    #[test]
    fn every_cook_lasts_until_the_last_moment_that_is_drawn() {
        for (name, text) in cooks() {
            let waits = text.lines().filter_map(|line| line.strip_prefix("after_s = ")?.parse::<f64>().ok());
            let last = if name.ends_with(BURNT) { BURNT_S } else { FRIED_S[FRIED_S.len() - 1] };
            assert!(waits.sum::<f64>() >= last, "gallery/looks/{name}.toml ends before {last} s");
        }
    }
}
