//! The strings of a device in the scene: rods as thick and light as they pull, in dashes through the worktop, with
//! their newtons.

use crate::ui::layout::Pane;
use crate::ui::palette::Palette;
use crate::ui::scene_view::on_screen;
use crate::ui::theme;
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Sense, Stroke, Ui, vec2};
use glam::Vec3;
use saute_scene::camera::Camera;
use saute_scene::mesh::props::COUNTER_Z;
use saute_scene::mesh::strings::StringLook;
use saute_words::language::Language;

/// Radius of a slack string, and what the largest tension adds [m] (chosen: far thicker than the real 0.35 mm, distinct
/// at a glance).
const THIN: f32 = 0.0007;

const THICKER: f32 = 0.0023;

/// Tension at which a string is as thick and as light as can be [N] (chosen: half of what motors pull at most; a pan
/// with food in it needs less).
const TIGHT_N: f64 = 6.0;

/// How far beyond its motor a number is, and how far from a panel [points] (chosen: no two motors are as near).
const BEYOND: f32 = 22.0;

const CLEAR: f32 = 16.0;

/// Nearest place to the pan where the number of a motor out of view can be, and steps that look for one [-] (chosen).
const NEAREST: f32 = 0.3;

const STEP: f32 = 0.02;

const APART: usize = 6;

pub(crate) const STROKE: f32 = 1900.0;

/// One string as it is seen.
pub(crate) struct Seen {
    pub(crate) from: Vec3,
    pub(crate) to: Vec3,
    pub(crate) tension: f64,
    pub(crate) number: usize,
}

/// What share of the largest tension.
fn share(tension: f64) -> f32 {
    (tension / TIGHT_N).clamp(0.0, 1.0) as f32
}

/// Dark where a string is slack, light where it is tight.
pub(crate) fn colour(tension: f64) -> Color32 {
    let between = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * share(tension)) as u8;
    let (slack, tight) = ([64u8, 112, 196], [255u8, 222, 110]);
    Color32::from_rgb(between(slack[0], tight[0]), between(slack[1], tight[1]), between(slack[2], tight[2]))
}

pub(crate) fn radius(tension: f64) -> f32 {
    THIN + THICKER * share(tension)
}

impl Seen {
    /// Where it goes through the worktop, or its end.
    pub(crate) fn visible_end(&self) -> Vec3 {
        let fall = self.from.z - self.to.z;
        let part = if self.to.z < COUNTER_Z { (self.from.z - COUNTER_Z) / fall } else { 1.0 };
        self.from.lerp(self.to, part.clamp(0.0, 1.0))
    }

    pub(crate) fn look(&self) -> StringLook {
        let [r, g, b, _] = egui::Rgba::from(colour(self.tension)).to_array();
        StringLook { ends: [self.from, self.visible_end()], radius: radius(self.tension), colour: Vec3::new(r, g, b) }
    }
}

pub(crate) fn project(eye: &Camera, rect: Rect, at: Vec3) -> Option<Pos2> {
    eye.project(at, rect.width() / rect.height()).map(|ndc| on_screen(ndc, rect))
}

/// What a string pulls, in words.
pub(crate) fn number(painter: &Painter, eye: &Camera, pane: &Pane, string: &Seen, palette: &Palette) {
    let Some(at) = number_place(eye, pane, string) else { return };
    let text = format!("{}: {:.1} N", string.number, string.tension);
    let galley = painter.layout_no_wrap(text, FontId::proportional(12.5), palette.text);
    let place = Align2::CENTER_CENTER.anchor_size(at, galley.size());
    painter.rect_filled(place.expand2(vec2(4.0, 1.0)), 4.0, palette.solid.gamma_multiply(0.9));
    painter.galley(place.min, galley, palette.text);
}

/// Beyond the motor where that is in view, else as far along the string as no panel covers.
fn number_place(eye: &Camera, pane: &Pane, string: &Seen) -> Option<Pos2> {
    let free = pane.free.shrink(CLEAR);
    let at = |part: f32| project(eye, pane.rect, string.from.lerp(string.to, part));
    let beyond = at(1.0).zip(at(0.0)).map(|(motor, pan)| motor + BEYOND * (motor - pan).normalized());
    // Strings that cross stay distinct where their numbers are at different distances.
    let skipped = if string.number.is_multiple_of(2) { APART } else { 0 };
    let along = (0..).map(|k| 1.0 - STEP * k as f32).take_while(|part| *part >= NEAREST).filter_map(at);
    let seen = |place: &Pos2| free.contains(*place);
    beyond.filter(seen).or_else(|| along.filter(seen).nth(skipped))
}

/// What thickness and lightness of a string mean.
pub(crate) fn legend(l: Language, ui: &mut Ui) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 30.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, l.text("hand.legend")));
    const STEPS: usize = 40;
    let x = |share: f32| rect.left() + 4.0 + share * (rect.width() - 8.0);
    for k in 0..STEPS {
        let share = k as f32 / STEPS as f32;
        let tension = TIGHT_N * f64::from(share);
        let line = [Pos2::new(x(share), rect.top() + 7.0), Pos2::new(x(share + 1.0 / STEPS as f32), rect.top() + 7.0)];
        ui.painter().line_segment(line, Stroke::new(2.0 * STROKE * radius(tension), colour(tension)));
    }
    for (share, align) in [(0.0, Align2::LEFT_TOP), (0.5, Align2::CENTER_TOP), (1.0, Align2::RIGHT_TOP)] {
        let text = format!("{:.0} N", TIGHT_N * f64::from(share));
        let at = Pos2::new(x(share), rect.top() + 13.0);
        ui.painter().text(at, align, text, FontId::proportional(12.5), theme::of(ui).quiet);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Luma of a colour (0–255).
    fn luma(c: Color32) -> f64 {
        0.299 * f64::from(c.r()) + 0.587 * f64::from(c.g()) + 0.114 * f64::from(c.b())
    }

    #[test]
    fn a_tighter_string_is_thicker_and_lighter_not_only_of_another_hue() {
        let steps: Vec<f64> = (0..=12).map(|k| 0.5 * f64::from(k)).collect();
        assert!(steps.windows(2).all(|t| radius(t[1]) > radius(t[0])));
        assert!(steps.windows(2).all(|t| luma(colour(t[1])) > luma(colour(t[0]))));
        assert_eq!(radius(20.0), radius(TIGHT_N));
    }

    #[test]
    fn a_string_is_a_rod_down_to_the_worktop_and_dashes_below() {
        let through = Seen { from: Vec3::new(0.0, 0.0, 0.1), to: Vec3::new(0.3, 0.0, -0.2), tension: 1.0, number: 1 };
        assert!((through.visible_end().z - COUNTER_Z).abs() < 1e-6 && through.visible_end().x > 0.1);
        let above = Seen { to: Vec3::new(0.3, 0.0, 0.35), ..through };
        assert_eq!(above.visible_end(), above.to);
    }
}
