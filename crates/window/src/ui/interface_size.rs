//! The size of the interface: for the desk, for arm's length, for a projector.

use egui::gui_zoom::kb_shortcuts::{ZOOM_IN, ZOOM_IN_SECONDARY, ZOOM_OUT, ZOOM_RESET};
use egui::{Context, Vec2, vec2};

/// How large the interface is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum InterfaceSize {
    /// 100 %: a screen on a desk.
    #[default]
    Usual,
    /// 125 %: at arm's length.
    Large,
    /// 150 %: a projector.
    Largest,
}

/// Room that the panels need at least [points] (chosen: a phone, on which two rows hold all views; a window of 1280 ×
/// 720 at 150 %).
const ROOM: Vec2 = vec2(390.0, 470.0);

impl InterfaceSize {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Usual, Self::Large, Self::Largest];

    /// Size over the usual one [-].
    pub fn factor(self) -> f32 {
        match self {
            Self::Usual => 1.0,
            Self::Large => 1.25,
            Self::Largest => 1.5,
        }
    }

    /// The factor, or the largest smaller one that leaves the panels room in the window [-].
    pub fn fitting(self, ctx: &Context) -> f32 {
        let window = ctx.content_rect().size() * ctx.zoom_factor();
        let most = (window / ROOM).min_elem().max(1.0);
        self.factor().min(most)
    }

    /// The size after the keys that enlarge (Ctrl +) and shrink (Ctrl −) have been taken.
    pub fn by_keys(self, ctx: &Context) -> Self {
        let place = Self::ALL.iter().position(|size| *size == self).unwrap_or(0);
        let [larger, smaller, usual] = ctx.input_mut(|i| {
            let larger = i.consume_shortcut(&ZOOM_IN) || i.consume_shortcut(&ZOOM_IN_SECONDARY);
            [larger, i.consume_shortcut(&ZOOM_OUT), i.consume_shortcut(&ZOOM_RESET)]
        });
        match () {
            () if usual => Self::Usual,
            () if larger => Self::ALL[(place + 1).min(Self::ALL.len() - 1)],
            () if smaller => Self::ALL[place.saturating_sub(1)],
            () => self,
        }
    }
}
