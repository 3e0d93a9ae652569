//! Where ways are shown side by side: a column for each, and their curves below.

use egui::{Rect, Vec2, pos2, vec2};

use crate::ui::layout::GAP;
use saute_session::timeline::MOST_BESIDE;

/// Ways at most.
pub const MOST: usize = MOST_BESIDE + 1;
/// Columns on a narrow window (chosen: a pan is still seen in each).
const NARROW_COLUMNS: usize = 2;
/// Height of a column's name with its progress, and of a button for fingers beside them [points].
const HEAD: f32 = 44.0;
/// Height of its cut with the readings below it, and on a narrow window [points].
const CUT: f32 = 84.0;
const NARROW_CUT: f32 = 64.0;
/// Height of the curves with what is beside them, and width of that [points].
const CURVES: f32 = 184.0;
const BESIDE_CURVES: f32 = 268.0;
/// Height of the buttons of the eye above that [points].
const EYE_HEIGHT: f32 = 26.0;

/// A column: one way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayColumn {
    /// Its name and progress.
    pub head: Rect,
    /// The pan.
    pub picture: Rect,
    /// The cut and readings.
    pub cut: Rect,
}

/// Where ways side by side are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaysLayout {
    /// All of it.
    pub ground: Rect,
    /// The columns; the first `count` are used.
    columns: [WayColumn; MOST],
    count: usize,
    /// The column of the way that goes on.
    live: usize,
    /// The curves; where it is narrow they are in the drawer.
    pub curves: Option<Rect>,
    /// What is beside the curves.
    pub beside: Rect,
    /// The buttons of the eye; nothing where it is narrow.
    pub eye: Rect,
}

impl WaysLayout {
    /// Lays out so many ways, of which the one at the place `live` goes on; where there is no room for all, it comes first.
    pub fn new(ground: Rect, (ways, live): (usize, usize), narrow: bool) -> Self {
        let count = ways.clamp(1, if narrow { NARROW_COLUMNS } else { MOST });
        let live = if ways > count { 0 } else { live.min(count - 1) };
        let low = if narrow { ground.bottom() } else { ground.bottom() - CURVES - GAP };
        let upper = Rect::from_min_max(ground.min, pos2(ground.right(), low));
        let columns = std::array::from_fn(|place| column(upper, place.min(count - 1), count, narrow));
        let nowhere = Rect::from_min_size(ground.right_top(), Vec2::ZERO);
        let (mut curves, mut beside, mut eye) = (None, nowhere, nowhere);
        if !narrow {
            let lower = Rect::from_min_max(pos2(ground.left(), low + GAP), ground.max);
            let parted = lower.right() - BESIDE_CURVES;
            curves = Some(Rect::from_min_max(lower.min, pos2(parted - GAP, lower.bottom())));
            eye = Rect::from_min_size(pos2(parted, lower.top()), vec2(BESIDE_CURVES - GAP, EYE_HEIGHT));
            beside = Rect::from_min_max(pos2(parted, eye.bottom() + GAP), lower.max - vec2(GAP, 0.0));
        }
        Self { ground, columns, count, live, curves, beside, eye }
    }

    /// The columns.
    pub fn columns(&self) -> &[WayColumn] {
        &self.columns[..self.count]
    }

    /// The pan of the way that goes on.
    pub fn live_picture(&self) -> Rect {
        self.columns[self.live].picture
    }
}

fn column(upper: Rect, place: usize, count: usize, narrow: bool) -> WayColumn {
    let cut = if narrow { NARROW_CUT } else { CUT };
    let width = (upper.width() - GAP * (count + 1) as f32) / count as f32;
    let left = upper.left() + GAP + (width + GAP) * place as f32;
    let part = |from: f32, to: f32| Rect::from_min_size(pos2(left, from), Vec2::new(width, to - from));
    WayColumn {
        head: part(upper.top(), upper.top() + HEAD),
        picture: part(upper.top() + HEAD, upper.bottom() - cut),
        cut: part(upper.bottom() - cut, upper.bottom()),
    }
}

#[cfg(test)]
mod tests {
    use egui::Pos2;

    use super::*;
    use crate::ui::layout::Layout;
    use saute_controls::settings::Settings;

    #[test]
    fn every_way_has_a_pan_that_can_be_seen() {
        for (size, least, columns) in [
            ([1280.0, 720.0], 190.0, 4),
            ([1920.0, 1080.0], 300.0, 4),
            ([390.0, 844.0], 110.0, 2),
            ([844.0, 390.0], 110.0, 2),
        ] {
            for count in 1..=MOST {
                let whole = Rect::from_min_size(Pos2::ZERO, Vec2::from(size));
                let layout = Layout::new(whole, &Settings::default()).with_ways(count, 0);
                let ways = layout.ways.expect("ways");
                assert_eq!(ways.columns().len(), count.min(columns));
                for column in ways.columns() {
                    let picture = column.picture;
                    assert!(picture.width() >= least && picture.height() >= 100.0, "{size:?} {count} {picture:?}");
                    assert!(ways.ground.contains_rect(picture) && ways.ground.contains_rect(column.cut));
                }
                assert!(
                    layout
                        .panels()
                        .iter()
                        .filter(|part| **part != layout.eye)
                        .all(|part| !part.intersects(ways.ground))
                );
            }
        }
    }
}
