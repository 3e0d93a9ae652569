//! The dial of the hob: a slider over its power, with its settings marked.

use egui::{Align2, FontId, Rect, Response, Sense, Ui, pos2, vec2};

use crate::panels::cook::cook_state::CookState;
use crate::panels::now::control_place;
use crate::ui::aloud::{spoken_range, spoken_value};
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;

/// Width of the slider, and the least at which no two words meet [points].
const WIDTH: f32 = 262.0;
const NARROWEST: f32 = 204.0;
/// Room for the list of temperatures beside it [points].
const HOLD: f32 = 142.0;
/// Height of the track's part and of the marks' part [points].
const TRACK: f32 = 18.0;
const MARKS: f32 = 18.0;
/// Room for a mark's word at either end [points].
const END: f32 = 24.0;
/// How near to a setting the slider snaps to it [W] (chosen: a finger's width).
const SNAP_W: f64 = 45.0;
/// Step of the power between settings [W] (chosen: as fine as a dial is turned).
const STEP_W: f64 = 10.0;

/// Shows the slider; a click on a mark chooses its setting.
pub fn show(state: &CookState, ui: &mut Ui, acts: &mut Acts) {
    let kitchen = &state.session.kitchen;
    let settings = kitchen.hob().settings_w();
    let most = settings.iter().copied().fold(1.0, f64::max);
    let has_steps = kitchen.hob().plate.is_some();
    let held = kitchen.hob_holds().is_some();
    let now = if held { 0.0 } else { kitchen.hob_w() };
    // Room for the temperatures beside it, where there is no more.
    let width = (ui.available_width() - HOLD).clamp(NARROWEST, WIDTH);
    let (rect, _) = ui.allocate_exact_size(vec2(width, fingers::height(ui, TRACK + MARKS)), Sense::hover());
    let track = rect.shrink2(vec2(END, 0.0)).split_top_bottom_at_fraction(TRACK / (TRACK + MARKS)).0;
    let power = Power { track, whole: rect, most, settings, has_steps };
    if let Some(watts) = dragged(state, ui, &power, now) {
        acts.push(Act::Cook(CookAct::HobSet(watts)));
    }
    advised(state, ui, &power);
    for watts in settings {
        if mark(state, ui, &power, *watts, !held && (watts - now).abs() < 0.5) {
            acts.push(Act::Cook(CookAct::HobSet(*watts)));
        }
    }
}

/// Marks the power that is advised: a triangle on the track.
fn advised(state: &CookState, ui: &Ui, power: &Power) {
    let Some(watts) = state.advised_w.filter(|_| state.reads_out()) else { return };
    let (x, y) = (power.x(watts), power.track.center().y - 3.5);
    let corners = vec![pos2(x, y), pos2(x - 5.0, y - 8.0), pos2(x + 5.0, y - 8.0)];
    ui.painter().add(egui::Shape::convex_polygon(corners, theme::of(ui).accent, egui::Stroke::NONE));
}

/// Where powers are on the track.
struct Power<'a> {
    track: Rect,
    /// Track and marks.
    whole: Rect,
    most: f64,
    settings: &'a [f64],
    /// True for a switch with steps and nothing between them: they are side by side, by their numbers.
    has_steps: bool,
}

impl Power<'_> {
    fn x(&self, watts: f64) -> f32 {
        let share = match self.step(watts) {
            Some(step) => step as f64 / (self.settings.len() - 1).max(1) as f64,
            None => watts / self.most,
        };
        self.track.left() + self.track.width() * share.clamp(0.0, 1.0) as f32
    }

    /// Number of the step nearest to a power; none of a dial without steps.
    fn step(&self, watts: f64) -> Option<usize> {
        let off = |i: &usize| (self.settings[*i] - watts).abs();
        self.has_steps.then(|| (0..self.settings.len()).min_by(|a, b| off(a).total_cmp(&off(b))))?
    }

    /// The power at a place, that of a setting where one is near.
    fn at(&self, x: f32) -> f64 {
        let share = f64::from(((x - self.track.left()) / self.track.width()).clamp(0.0, 1.0));
        if self.has_steps {
            return self.settings[(share * (self.settings.len() - 1) as f64).round() as usize];
        }
        let watts = self.most * share;
        let near = self.settings.iter().copied().find(|w| (w - watts).abs() < SNAP_W);
        near.unwrap_or((watts / STEP_W).round() * STEP_W)
    }

    /// The power an arrow key away: the next step.
    fn beside(&self, watts: f64, steps: f64) -> f64 {
        if let Some(step) = self.step(watts) {
            let next = (step as f64 + steps).clamp(0.0, (self.settings.len() - 1) as f64);
            return self.settings[next as usize];
        }
        (watts + 10.0 * steps * STEP_W).clamp(0.0, self.most)
    }
}

/// The knob and the bar; returns the power that a drag, a click or an arrow key requests.
fn dragged(state: &PanelContext, ui: &mut Ui, power: &Power, now: f64) -> Option<f64> {
    let l = state.settings.language;
    let id = ui.scope_id().with("hob");
    // A drag may begin on a word below the track.
    let mut place = power.track.expand2(vec2(8.0, 0.0));
    place.max.y = power.whole.bottom();
    let response = ui.interact(place, id, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::slider(true, now, l.text("hob.power_spoken")));
    paint(ui, &response, power, now);
    spoken_value(ui, &response, format!("{now:.0} W"));
    let spoken = spoken_range(ui, &response, 0.0..=power.most, now);
    let by_key = if response.has_focus() { arrows(ui) } else { 0.0 };
    // A hand that is quick moves and lets go within one frame.
    let is_moved = response.dragged() || response.drag_stopped() || response.clicked();
    let at = response.interact_pointer_pos().filter(|_| is_moved);
    let wanted = at.map(|at| power.at(at.x)).or(spoken).or((by_key != 0.0).then(|| power.beside(now, by_key)));
    response.on_hover_text(l.text("hob.power"));
    wanted.filter(|watts| (watts - now).abs() > 0.5)
}

fn arrows(ui: &Ui) -> f64 {
    let pressed = |key| ui.input(|i| i.num_presses(key)) as f64;
    pressed(egui::Key::ArrowRight) - pressed(egui::Key::ArrowLeft)
}

fn paint(ui: &Ui, response: &Response, power: &Power, now: f64) {
    let (palette, painter, middle) = (theme::of(ui), ui.painter(), power.track.center().y);
    let bar = |right: f32| Rect::from_min_max(pos2(power.track.left(), middle - 3.5), pos2(right, middle + 3.5));
    painter.rect_filled(bar(power.track.right()), 3.5, palette.raised);
    painter.rect_filled(bar(power.x(now)), 3.5, palette.chosen);
    let edge = if response.has_focus() {
        egui::Stroke::new(3.0, palette.text)
    } else {
        ui.style().interact(response).fg_stroke
    };
    painter.circle(pos2(power.x(now), middle), 8.0, palette.hovered, edge);
}

/// A setting's tick and word; returns true if it was clicked.
fn mark(state: &PanelContext, ui: &mut Ui, power: &Power, watts: f64, on: bool) -> bool {
    let l = state.settings.language;
    let spoken = if watts == 0.0 { l.text("hob.off").to_owned() } else { format!("{watts:.0} W") };
    // There is no room for the watts of seven steps; a switch has their numbers too.
    let text = power.step(watts).filter(|step| *step > 0).map_or_else(|| spoken.clone(), |step| step.to_string());
    let palette = theme::of(ui);
    let (x, top) = (power.x(watts), power.track.bottom());
    let half = if watts == 0.0 { 11.0 } else { 18.0 };
    // A finger may miss the word upwards: a drag still moves the knob.
    let upper = if fingers::are_used(ui.ctx()) { power.whole.top() } else { top - 2.0 };
    let place = Rect::from_min_max(pos2(x - half, upper), pos2(x + half, power.whole.bottom()));
    let response = ui.interact(place, ui.scope_id().with(("setting", watts as i64)), Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, &spoken));
    control_place::note(ui, &Act::Cook(CookAct::HobSet(watts)), place);
    let ink = if on { palette.text } else { palette.quiet };
    let tick = [pos2(x, power.track.center().y + 5.0), pos2(x, top)];
    ui.painter().line_segment(tick, egui::Stroke::new(if on { 2.5 } else { 1.5 }, ink));
    if response.has_focus() {
        ui.painter().rect_stroke(place, 4.0, egui::Stroke::new(2.0, palette.text), egui::StrokeKind::Inside);
    }
    let font = FontId::proportional(if on || response.hovered() { 14.0 } else { 13.0 });
    ui.painter().text(pos2(x, 0.5 * (top + power.whole.bottom()) - 1.0), Align2::CENTER_CENTER, text, font, ink);
    response.on_hover_text(format!("{spoken}\n{}", l.text("hob.power"))).clicked()
}
