//! Layout of scene and panels.

use egui::{Pos2, Rect, pos2, vec2};

use crate::settings::Settings;

/// Below this width the panels gather in one drawer [points] (chosen: hob and clock still stand in one row).
const NARROW: f32 = 1080.0;
/// Width of the drawer beside the scene [points].
const DRAWER_WIDTH: f32 = 366.0;
/// Space around panels [points].
pub const GAP: f32 = 10.0;
const RIGHT_WIDTH: f32 = 318.0;
const LEFT_WIDTH: f32 = 276.0;
const BOTTOM_HEIGHT: f32 = 172.0;
const TOP_HEIGHT: f32 = 62.0;
/// Two rows of chips.
const NARROW_TOP_HEIGHT: f32 = 106.0;

/// A part of the window in which the scene is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pane {
    /// What the scene covers.
    pub rect: Rect,
    /// The part of it that no panel covers.
    pub free: Rect,
    /// True if it shows the look, whatever the view is.
    pub look: bool,
}

impl Pane {
    /// The lens shift that centres the pan in the free part [normalised device coordinates].
    pub fn lens_shift(&self) -> [f32; 2] {
        let centre: Pos2 = self.free.center();
        [
            2.0 * (centre.x - self.rect.center().x) / self.rect.width(),
            -2.0 * (centre.y - self.rect.center().y) / self.rect.height(),
        ]
    }
}

/// Rectangles of the window's parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Everything.
    pub whole: Rect,
    /// View chips and legend.
    pub top: Rect,
    /// Food and pan, or the list of the pieces, where open.
    pub left: Option<Rect>,
    /// What is inside now.
    pub right: Rect,
    /// Hob, hands and time.
    pub bottom: Rect,
    /// What no panel covers.
    pub free: Rect,
    /// One drawer instead of side panels.
    pub narrow: bool,
}

impl Layout {
    /// Lays out a window.
    pub fn new(whole: Rect, settings: &Settings) -> Self {
        let narrow = whole.width() < NARROW;
        let inner = whole.shrink(GAP);
        let mut layout = if narrow && whole.width() > whole.height() {
            Self::beside(whole, inner)
        } else if narrow {
            Self::below(whole, inner)
        } else {
            Self::wide(whole, inner, settings.pantry_open || settings.pieces_open)
        };
        if settings.panels_hidden {
            layout.free = whole;
        }
        layout
    }

    fn wide(whole: Rect, inner: Rect, open: bool) -> Self {
        let right = Rect::from_min_max(pos2(inner.right() - RIGHT_WIDTH, inner.top()), inner.max);
        let rest = right.left() - GAP;
        let top = Rect::from_min_max(inner.min, pos2(rest, inner.top() + TOP_HEIGHT));
        let bottom = Rect::from_min_max(pos2(inner.left(), inner.bottom() - BOTTOM_HEIGHT), pos2(rest, inner.bottom()));
        let middle = Rect::from_min_max(pos2(inner.left(), top.bottom() + GAP), pos2(rest, bottom.top() - GAP));
        let left = open.then(|| Rect::from_min_size(middle.min, vec2(LEFT_WIDTH, middle.height())));
        let free_left = left.map_or(whole.left(), |l| l.right());
        let free = Rect::from_min_max(pos2(free_left, top.bottom() - 0.4 * TOP_HEIGHT), pos2(rest, bottom.top()));
        Self { whole, top, left, right, bottom, free, narrow: false }
    }

    /// The drawer at the right, over the whole height.
    fn beside(whole: Rect, inner: Rect) -> Self {
        let drawer = Rect::from_min_max(pos2(inner.right() - DRAWER_WIDTH, inner.top()), inner.max);
        let left = drawer.left() - GAP;
        let top = Rect::from_min_max(inner.min, pos2(left, inner.top() + NARROW_TOP_HEIGHT));
        let free = Rect::from_min_max(pos2(whole.left(), top.bottom()), pos2(left, whole.bottom()));
        Self { whole, top, left: None, right: drawer, bottom: drawer, free, narrow: true }
    }

    /// The drawer at the bottom.
    fn below(whole: Rect, inner: Rect) -> Self {
        let split = whole.top() + (0.48 * whole.height()).max(240.0);
        let top = Rect::from_min_max(inner.min, pos2(inner.right(), inner.top() + NARROW_TOP_HEIGHT));
        let bottom = Rect::from_min_max(pos2(inner.left(), split), inner.max);
        let free = Rect::from_min_max(pos2(whole.left(), top.bottom()), pos2(whole.right(), split));
        Self { whole, top, left: None, right: bottom, bottom, free, narrow: true }
    }

    /// Where the scene is drawn: over the whole window, or, split, in two panes of one size that share what no panel
    /// covers, the look at the left. Both see the same with the same eye.
    pub fn panes(&self, split: bool) -> Vec<Pane> {
        if !split {
            return vec![Pane { rect: self.whole, free: self.free, look: false }];
        }
        let width = 0.5 * self.free.width();
        let half = |k: f32, look: bool| {
            let left = self.free.left() + k * width;
            let of = |rect: Rect| Rect::from_min_max(pos2(left, rect.top()), pos2(left + width, rect.bottom()));
            Pane { rect: of(self.whole), free: of(self.free), look }
        };
        vec![half(0.0, true), half(1.0, false)]
    }

    /// The pane that shows the view.
    pub fn field_pane(&self, split: bool) -> Pane {
        let panes = self.panes(split);
        panes[panes.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn split_panes_are_of_one_size_side_by_side_and_seen_with_one_eye() {
        for size in [vec2(1280.0, 720.0), vec2(390.0, 844.0)] {
            let l = Layout::new(Rect::from_min_size(Pos2::ZERO, size), &Settings::default());
            let [look, field] = l.panes(true)[..] else { panic!("two panes") };
            assert!(look.look && !field.look && (look.rect.right() - field.rect.left()).abs() < 0.01);
            assert!((look.rect.size() - field.rect.size()).length() < 0.01);
            let (a, b) = (look.lens_shift(), field.lens_shift());
            assert!((a[0] - b[0]).abs() < 1e-4 && (a[1] - b[1]).abs() < 1e-4, "{a:?} {b:?}");
            assert!(l.panes(false).len() == 1 && l.panes(false)[0].rect == l.whole);
        }
    }

    #[test]
    fn panels_do_not_overlap_at_any_size() {
        for size in [vec2(1280.0, 720.0), vec2(1920.0, 1080.0), vec2(900.0, 640.0), vec2(853.0, 480.0)] {
            for pantry_open in [false, true] {
                let settings = Settings { pantry_open, ..Settings::default() };
                let l = Layout::new(Rect::from_min_size(Pos2::ZERO, size), &settings);
                let mut parts = vec![l.top, l.right];
                // One drawer has both.
                assert_eq!(l.narrow, l.bottom == l.right);
                parts.extend((!l.narrow).then_some(l.bottom));
                parts.extend(l.left);
                for (i, a) in parts.iter().enumerate() {
                    assert!(parts[i + 1..].iter().all(|b| !a.intersects(*b)), "{size:?} {l:?}");
                }
            }
        }
    }
}
