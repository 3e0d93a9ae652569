//! Layout of scene and panels.

use egui::{Pos2, Rect, Vec2, pos2, vec2};

use crate::ui::theme::TOUCH;
use crate::ui::ways_layout::WaysLayout;
use saute_controls::settings::Settings;

/// Below this width the panels gather in one drawer [points] (chosen: hob and clock still fit in one row).
const NARROW: f32 = 1080.0;
/// A wide window narrower than this has room for the scene and for the line that states what to do [points] (chosen: the drawer beside
/// the scene, and three quarters as much for the scene).
pub const TINY: f32 = 640.0;
/// Width of the drawer beside the scene [points].
const DRAWER_WIDTH: f32 = 366.0;
/// Space around panels [points].
pub const GAP: f32 = 8.0;
const RIGHT_WIDTH: f32 = 296.0;
const LEFT_WIDTH: f32 = 276.0;
/// Height of what is inside without the curves [points]; with them it takes the whole height.
const INSIDE_HEIGHT: f32 = 410.0;
/// Heights of the few controls of a first cook: of one row, and of what is above them; and the size of *Plan*, *More* and their neighbours
/// [points].
const FEW_HEIGHT: f32 = 58.0;
const FEW_TOP: Vec2 = vec2(326.0, 46.0);
const FEW_TOP_NARROW: Vec2 = vec2(340.0, 58.0);
/// Height of their drawer [points]: the line that states what to do and three rows for fingers.
const FEW_DRAWER: f32 = 240.0;
/// Two rows of controls and a line of words.
const BOTTOM_HEIGHT: f32 = 110.0;
const TOP_HEIGHT: f32 = 46.0;
/// Size of the buttons of the views of the eye together [points].
const EYE: Vec2 = vec2(200.0, 26.0);
/// Two rows of chips.
const NARROW_TOP_HEIGHT: f32 = 106.0;
/// Rows of chips for fingers: of one where they fit into this width, else two; and the buttons of the views of the eye [points].
const ONE_ROW: f32 = 700.0;
const FINGER_TOP_HEIGHTS: [f32; 2] = [68.0, 118.0];
const FINGER_EYE: Vec2 = vec2(212.0, TOUCH);

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
    /// Views of the eye, over the scene.
    pub eye: Rect,
    /// What no panel covers.
    pub free: Rect,
    /// One drawer instead of side panels.
    pub narrow: bool,
    /// No panels at all: the scene, and the line that states what to do.
    pub tiny: bool,
    /// Ways side by side in place of the scene, where they are shown.
    pub ways: Option<WaysLayout>,
}

impl Layout {
    /// Lays out a window for a mouse.
    pub fn new(whole: Rect, settings: &Settings) -> Self {
        Self::used_by(whole, settings, (false, false))
    }

    /// Lays out a window for a mouse, or for fingers: the drawer has the room that they need, at any width. Whoever is guided has the
    /// controls in every window, since the line does not state what to do.
    pub fn used_by(whole: Rect, settings: &Settings, (fingers, guided): (bool, bool)) -> Self {
        let narrow = fingers || whole.width() < NARROW;
        let tiny = whole.width() > whole.height() && whole.width() < TINY && !(guided || settings.skill_mode);
        let inner = whole.shrink(GAP);
        let mut layout = if narrow && whole.width() > whole.height() {
            Self::beside(whole, inner, fingers)
        } else if narrow {
            Self::below(whole, inner, (fingers, settings.few))
        } else if settings.few {
            Self::few(whole, inner)
        } else {
            Self::wide(whole, inner, settings)
        };
        let eye = if fingers { FINGER_EYE } else { EYE };
        // Where it is narrow the legend needs the lower edge.
        let corner =
            if narrow { layout.free.right_top() + vec2(0.0, eye.y + 2.0 * GAP) } else { layout.free.right_bottom() };
        layout.eye = Rect::from_min_size(corner - eye - vec2(GAP, GAP), eye);
        if settings.few {
            layout = layout.with_few_on_top(fingers);
        }
        layout.tiny = tiny;
        if settings.hides_panels() || tiny {
            layout = layout.bare();
        }
        layout
    }

    /// *Plan*, *More* and their neighbours in the upper right corner instead of the chips, and no buttons of the eye.
    fn with_few_on_top(mut self, fingers: bool) -> Self {
        let size = match (self.narrow, fingers) {
            (false, _) => FEW_TOP,
            (true, false) => FEW_TOP_NARROW,
            (true, true) => vec2(FEW_TOP_NARROW.x, FINGER_TOP_HEIGHTS[0]),
        };
        let size = vec2(size.x.min(self.top.width()), size.y);
        self.top = Rect::from_min_size(pos2(self.top.right() - size.x, self.top.top()), size);
        self.free.min.y = self.whole.top();
        self.eye = Rect::NOTHING;
        self
    }

    /// The same window without the panel of what is inside; its room goes to its neighbours. A drawer keeps its own.
    pub fn without_inside(mut self) -> Self {
        if self.narrow || !self.right.is_positive() {
            return self;
        }
        let (edge, more) = (self.right.right(), vec2(self.right.width() + GAP, 0.0));
        (self.top.max.x, self.bottom.max.x, self.free.max.x) = (edge, edge, edge + GAP);
        (self.right, self.eye) = (Rect::NOTHING, self.eye.translate(more));
        self
    }

    /// The same window without panels.
    pub fn bare(self) -> Self {
        Self { free: self.whole, ..self }
    }

    fn wide(whole: Rect, inner: Rect, settings: &Settings) -> Self {
        let low = if settings.curves_open { inner.bottom() } else { inner.bottom().min(inner.top() + INSIDE_HEIGHT) };
        let right = Rect::from_min_max(pos2(inner.right() - RIGHT_WIDTH, inner.top()), pos2(inner.right(), low));
        let rest = right.left() - GAP;
        let top = Rect::from_min_max(inner.min, pos2(rest, inner.top() + TOP_HEIGHT));
        let bottom = Rect::from_min_max(pos2(inner.left(), inner.bottom() - BOTTOM_HEIGHT), pos2(rest, inner.bottom()));
        let middle = Rect::from_min_max(pos2(inner.left(), top.bottom() + GAP), pos2(rest, bottom.top() - GAP));
        let open = settings.pantry_open || settings.pieces_open;
        let left = open.then(|| Rect::from_min_size(middle.min, vec2(LEFT_WIDTH, middle.height())));
        let free_left = left.map_or(whole.left(), |l| l.right());
        let free = Rect::from_min_max(pos2(free_left, top.bottom() - 0.4 * TOP_HEIGHT), pos2(rest, bottom.top()));
        Self { whole, top, left, right, bottom, eye: Rect::NOTHING, free, narrow: false, tiny: false, ways: None }
    }

    /// One row of controls at the foot, and nothing at the right.
    fn few(whole: Rect, inner: Rect) -> Self {
        let bottom = Rect::from_min_max(pos2(inner.left(), inner.bottom() - FEW_HEIGHT), inner.max);
        let free = Rect::from_min_max(whole.min, pos2(whole.right(), bottom.top()));
        let [right, eye] = [Rect::NOTHING; 2];
        Self { whole, top: inner, left: None, right, bottom, eye, free, narrow: false, tiny: false, ways: None }
    }

    /// The drawer at the right, over the whole height.
    fn beside(whole: Rect, inner: Rect, fingers: bool) -> Self {
        let drawer = Rect::from_min_max(pos2(inner.right() - DRAWER_WIDTH, inner.top()), inner.max);
        let left = drawer.left() - GAP;
        let top = chips(inner, left, fingers);
        let free = Rect::from_min_max(pos2(whole.left(), top.bottom()), pos2(left, whole.bottom()));
        Self {
            whole,
            top,
            left: None,
            right: drawer,
            bottom: drawer,
            eye: Rect::NOTHING,
            free,
            narrow: true,
            tiny: false,
            ways: None,
        }
    }

    /// The drawer at the bottom.
    fn below(whole: Rect, inner: Rect, (fingers, few): (bool, bool)) -> Self {
        let split = whole.top() + (0.465 * whole.height()).max(240.0);
        let split = if few { split.max(inner.bottom() - FEW_DRAWER) } else { split };
        let top = chips(inner, inner.right(), fingers);
        let bottom = Rect::from_min_max(pos2(inner.left(), split), inner.max);
        let free = Rect::from_min_max(pos2(whole.left(), top.bottom()), pos2(whole.right(), split));
        Self {
            whole,
            top,
            left: None,
            right: bottom,
            bottom,
            eye: Rect::NOTHING,
            free,
            narrow: true,
            tiny: false,
            ways: None,
        }
    }

    /// Shows this many ways side by side in place of the scene; the one at the place `live` goes on.
    pub fn with_ways(mut self, count: usize, live: usize) -> Self {
        let top = if self.free == self.whole { self.whole.top() } else { self.top.bottom() };
        let ground = Rect::from_min_max(pos2(self.free.left(), top), self.free.max).shrink(GAP);
        let ways = WaysLayout::new(ground, (count, live), self.narrow);
        self.eye = ways.eye;
        self.ways = Some(ways);
        self
    }

    /// What covers the scene.
    pub fn panels(&self) -> Vec<Rect> {
        let mut panels: Vec<Rect> = [self.top, self.right, self.eye].into_iter().filter(Rect::is_positive).collect();
        // One drawer has both.
        panels.extend((!self.narrow).then_some(self.bottom));
        panels.extend(self.left);
        panels
    }

    /// Where the scene is drawn: in its column among ways side by side, else over the whole window, or, split, in two panes of one size that share what no panel
    /// covers, the look at the left. Both see the same with the same eye.
    pub fn panes(&self, split: bool) -> Vec<Pane> {
        if let Some(ways) = &self.ways {
            let live = ways.live_picture();
            return vec![Pane { rect: live, free: live, look: false }];
        }
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

/// The panel of the chips of a window with a drawer, up to a right edge.
fn chips(inner: Rect, right: f32, fingers: bool) -> Rect {
    let height = match (fingers, right - inner.left() >= ONE_ROW) {
        (false, _) => NARROW_TOP_HEIGHT,
        (true, true) => FINGER_TOP_HEIGHTS[0],
        (true, false) => FINGER_TOP_HEIGHTS[1],
    };
    Rect::from_min_max(inner.min, pos2(right, inner.top() + height))
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
    fn the_scene_has_seven_tenths_of_a_usual_window() {
        let whole = Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 720.0));
        let covered: f32 = Layout::new(whole, &Settings::default()).panels().iter().map(|part| part.area()).sum();
        let seen = 1.0 - covered / whole.area();
        assert!(seen >= 0.70, "{:.1} %", 100.0 * seen);
        let few = Settings { few: true, ..Settings::default() };
        let covered: f32 = Layout::new(whole, &few).panels().iter().map(|part| part.area()).sum();
        let seen = 1.0 - covered / whole.area();
        assert!(seen >= 0.90, "{:.1} %", 100.0 * seen);
    }

    #[test]
    fn panels_do_not_overlap_at_any_size() {
        let sizes = [
            [1280.0, 720.0],
            [1920.0, 1080.0],
            [900.0, 640.0],
            [853.0, 480.0],
            [390.0, 844.0],
            [844.0, 390.0],
            [320.0, 568.0],
            [400.0, 300.0],
            [320.0, 180.0],
        ];
        for size in sizes.map(Vec2::from) {
            for [pantry_open, curves_open, fingers, few] in [
                [false, false, false, false],
                [true, false, false, false],
                [false, true, false, false],
                [false, false, true, false],
                [false, false, false, true],
                [false, false, true, true],
            ] {
                let settings = Settings { pantry_open, curves_open, few, ..Settings::default() };
                let l = Layout::used_by(Rect::from_min_size(Pos2::ZERO, size), &settings, (fingers, false));
                assert_eq!(l.narrow, l.bottom == l.right);
                if l.tiny {
                    assert_eq!(l.free, l.whole, "nothing covers the scene");
                    continue;
                }
                let parts = l.panels();
                assert!(parts.iter().all(|part| l.whole.contains_rect(*part)), "{size:?} {l:?}");
                for (i, a) in parts.iter().enumerate() {
                    assert!(parts[i + 1..].iter().all(|b| !a.intersects(*b)), "{size:?} {l:?}");
                }
            }
        }
    }
}
