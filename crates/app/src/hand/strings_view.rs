//! The strings of a device over the scene, as if the table were of glass: where they run, and how hard they pull.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, vec2};
use glam::Vec3;
use saute_haptics::{Health, STRINGS, StringRig};

use super::hands::Role;
use crate::app::SauteApp;
use crate::layout::Pane;
use crate::palette::Palette;
use crate::scene::camera::Camera;
use crate::scene_view::on_screen;
use crate::theme;

/// Height of the worktop, below which a string is drawn in dashes [m].
const WORKTOP: f32 = crate::scene::props::COUNTER_Z;
/// Width of a slack string, and what the largest tension adds [points] (chosen: told apart at a glance).
const THIN: f32 = 1.2;
const THICKER: f32 = 5.3;
/// Tension at which a string is as thick and as light as can be [N] (chosen: half of what motors pull at most; a pan with food
/// in it asks for less).
const TIGHT_N: f64 = 6.0;
/// Where the number stands along a string, from the pan [-] (chosen: clear of pan and motors).
const NUMBER_AT: f32 = 0.55;
/// Dash and gap below the worktop [points].
const DASH: [f32; 2] = [5.0, 4.0];
/// Points in which a string is drawn.
const PIECES: usize = 24;

/// One string as it is seen.
struct Seen {
    from: Vec3,
    to: Vec3,
    tension: f64,
    /// Distance of its middle from the eye [m].
    away: f32,
    number: usize,
}

/// Dark and thin where a string is slack, light and thick where it is tight.
fn colour(tension: f64) -> Color32 {
    let share = (tension / TIGHT_N).clamp(0.0, 1.0) as f32;
    let between = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * share) as u8;
    let (slack, tight) = ([58u8, 96, 168], [255u8, 214, 92]);
    Color32::from_rgb(between(slack[0], tight[0]), between(slack[1], tight[1]), between(slack[2], tight[2]))
}

fn width(tension: f64) -> f32 {
    THIN + THICKER * (tension / TIGHT_N).clamp(0.0, 1.0) as f32
}

impl SauteApp {
    /// Draws the strings of the device that holds the pan, the farthest first.
    pub(crate) fn show_strings(&self, ui: &Ui, pane: &Pane) {
        let Some((rig, pose, tension)) = self.strings_now() else { return };
        let eye = self.eye();
        let place = |v: glam::DVec3| v.as_vec3();
        let mut strings: Vec<Seen> = (0..STRINGS)
            .map(|i| {
                let (from, to) = (place(pose.to_world(rig.attachment[i])), place(rig.motor[i]));
                let away = (0.5 * (from + to) - eye.eye()).length();
                Seen { from, to, tension: tension[i], away, number: i + 1 }
            })
            .collect();
        strings.sort_by(|a, b| b.away.total_cmp(&a.away));
        let painter = ui.painter().with_clip_rect(pane.rect);
        for string in &strings {
            draw(&painter, &eye, pane.rect, string, theme::of(ui));
        }
        strings.iter().for_each(|string| number(&painter, &eye, pane.rect, string, theme::of(ui)));
    }

    /// Strings, pose and tensions, while they are shown and known.
    fn strings_now(&self) -> Option<(StringRig, saute_haptics::Pose, [f64; STRINGS])> {
        let hands = &self.session.hands;
        let device = hands.device(Role::Pan).filter(|_| !hands.strings_hidden)?;
        let sample = &device.state().sample;
        let known = matches!(sample.health, Health::Running | Health::Stopped);
        Some((device.strings?, sample.pose, sample.tension_n.filter(|_| known)?))
    }
}

fn project(eye: &Camera, rect: Rect, at: Vec3) -> Option<Pos2> {
    eye.project(at, rect.width() / rect.height()).map(|ndc| on_screen(ndc, rect))
}

/// A line with a rim, so that it is seen on any ground; dashes where the worktop hides it.
fn draw(painter: &Painter, eye: &Camera, rect: Rect, string: &Seen, palette: &Palette) {
    let at = |k: usize| string.from.lerp(string.to, k as f32 / PIECES as f32);
    let points =
        |from: usize, to: usize| -> Vec<Pos2> { (from..=to).filter_map(|k| project(eye, rect, at(k))).collect() };
    let hidden = (0..=PIECES).find(|k| at(*k).z < WORKTOP).unwrap_or(PIECES);
    let (wide, ink) = (width(string.tension), colour(string.tension));
    let rim = Stroke::new(wide + 2.0, palette.solid.gamma_multiply(0.7));
    painter.add(Shape::line(points(0, hidden), rim));
    painter.add(Shape::line(points(0, hidden), Stroke::new(wide, ink)));
    if hidden < PIECES {
        painter.extend(Shape::dashed_line(&points(hidden, PIECES), rim, DASH[0], DASH[1]));
        painter.extend(Shape::dashed_line(&points(hidden, PIECES), Stroke::new(wide, ink), DASH[0], DASH[1]));
    }
    if let Some(motor) = project(eye, rect, string.to) {
        painter.rect_filled(Rect::from_center_size(motor, vec2(12.0, 12.0)), 2.0, palette.solid);
        painter.rect_filled(Rect::from_center_size(motor, vec2(8.0, 8.0)), 1.0, palette.text);
    }
    if let Some(end) = project(eye, rect, string.from) {
        painter.circle_filled(end, 4.0, palette.solid);
        painter.circle_filled(end, 2.5, palette.text);
    }
}

/// What a string pulls, in words.
fn number(painter: &Painter, eye: &Camera, rect: Rect, string: &Seen, palette: &Palette) {
    let Some(at) = project(eye, rect, string.from.lerp(string.to, NUMBER_AT)) else { return };
    let text = format!("{}: {:.1} N", string.number, string.tension);
    let galley = painter.layout_no_wrap(text, FontId::proportional(12.5), palette.text);
    let place = Align2::CENTER_CENTER.anchor_size(at, galley.size());
    painter.rect_filled(place.expand2(vec2(4.0, 1.0)), 4.0, palette.solid.gamma_multiply(0.9));
    painter.galley(place.min, galley, palette.text);
}

/// What thickness and lightness of a string say.
pub(super) fn legend(app: &SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 30.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, l.text("hand.legend")));
    const STEPS: usize = 40;
    let x = |share: f32| rect.left() + 4.0 + share * (rect.width() - 8.0);
    for k in 0..STEPS {
        let share = k as f32 / STEPS as f32;
        let tension = TIGHT_N * f64::from(share);
        let line = [Pos2::new(x(share), rect.top() + 7.0), Pos2::new(x(share + 1.0 / STEPS as f32), rect.top() + 7.0)];
        ui.painter().line_segment(line, Stroke::new(width(tension), colour(tension)));
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
        assert!(steps.windows(2).all(|t| width(t[1]) > width(t[0])));
        assert!(steps.windows(2).all(|t| luma(colour(t[1])) > luma(colour(t[0]))));
        assert_eq!(width(20.0), width(TIGHT_N));
    }
}
