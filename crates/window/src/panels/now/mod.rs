//! The line that says what to do now, over the foot of the scene: a verb, its reason or the time that is left, and the one button
//! that does it. While a plan or the tutorial leads, its own words stand instead.

mod now_words;
pub mod time_left;

use std::sync::Arc;

use egui::{Align2, Area, Color32, FontId, Galley, Id, Rect, Stroke, StrokeKind, Ui, Vec2, pos2, vec2};
use saute_kitchen::celsius;
use saute_kitchen::food::change::doneness::Measure;

use self::now_words::{Deed, NowWords};
use self::time_left::TimeLeft;
use crate::act::{Act, Acts, CookAct};
use crate::panels::learn::callout::control_rect;
use crate::panels::window_state::WindowState;
use crate::ui::layout::{GAP, Layout};
use crate::ui::theme::{self, TOUCH};

/// Its size over the scene [points].
const SIZE: Vec2 = vec2(520.0, 64.0);
/// Its height in the drawer of a narrow window [points].
const DRAWER_HEIGHT: f32 = 60.0;
/// Width of the column of the core [points].
const CORE_WIDTH: f32 = 76.0;
/// Distance of the words from the edge, and of columns from each other [points].
const PAD: f32 = 12.0;
/// Sizes among which a line takes the first in which it fits [points].
const VERB_SIZES: [f32; 4] = [20.0, 18.0, 16.0, 14.0];
const WHY_SIZES: [f32; 3] = [14.0, 13.0, 12.0];

/// Shows the line over the scene; a narrow window has it in the drawer.
pub fn show(state: &WindowState, memory: &mut TimeLeft, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if layout.narrow || layout.ways.is_some() {
        return;
    }
    let Some(words) = words(state, memory) else { return };
    let rect = place(state, layout);
    Area::new(Id::unique("now")).fixed_pos(rect.min).pivot(Align2::LEFT_TOP).show(ui.ctx(), |ui| {
        line(state, &words, ui, acts, rect.size());
    });
    // Behind a card nothing is to be pressed.
    if state.card.is_none() {
        ring(&words, ui);
    }
}

/// Shows the line in the drawer of a narrow window.
pub fn in_drawer(state: &WindowState, memory: &mut TimeLeft, ui: &mut Ui, acts: &mut Acts) {
    if let Some(words) = words(state, memory) {
        line(state, &words, ui, acts, vec2(ui.available_width(), DRAWER_HEIGHT));
    }
}

/// What the line says; nothing where readings are hidden or somebody else leads.
fn words(state: &WindowState, memory: &mut TimeLeft) -> Option<NowWords> {
    let advice = *state.advice.first().filter(|_| state.reads_out())?;
    let led = state.guide_leads && !advice.is_due() || state.tutorial.is_some() && !state.alarm;
    (!led).then(|| NowWords::of(advice, state, memory))
}

/// Where the line stands: at the foot of the free part, clear of the legend and of the buttons of the eye.
fn place(state: &WindowState, layout: &Layout) -> Rect {
    let free = layout.free;
    let size = vec2(SIZE.x.min(free.width() - 2.0 * GAP), SIZE.y);
    let left = free.center().x - 0.5 * size.x;
    let beside = left + size.x + GAP <= layout.eye.left() && !crate::panels::badge::says_what_holds(state);
    let foot = free.bottom() - if beside { PAD } else { PAD + 2.0 * GAP + layout.eye.height() };
    Rect::from_min_size(pos2(left, foot - size.y), size)
}

/// Core, verb and reason, button.
fn line(state: &WindowState, words: &NowWords, ui: &mut Ui, acts: &mut Acts, size: Vec2) {
    let (rect, ground) = ui.allocate_exact_size(size, egui::Sense::click_and_drag());
    ground.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &words.spoken));
    let palette = theme::of(ui);
    let edge = if words.is_due { Stroke::new(2.0, palette.accent) } else { Stroke::new(1.0, palette.line) };
    ui.painter().rect(rect, theme::CORNER, palette.solid, edge, StrokeKind::Inside);
    let mut room = rect.shrink2(vec2(PAD, 8.0));
    if let Some(deed) = &words.deed {
        room.max.x -= button(ui, acts, deed, room) + PAD;
    }
    if let Some([core, goal]) = core(state) {
        let column = Rect::from_min_size(room.min, vec2(CORE_WIDTH, room.height()));
        two_lines(ui, column, [(&core, &[24.0, 20.0], palette.text), (&goal, &WHY_SIZES, palette.quiet)]);
        room.min.x += CORE_WIDTH + PAD;
    }
    let verb = if words.is_due { palette.accent } else { palette.text };
    two_lines(ui, room, [(&words.verb, &VERB_SIZES, verb), (&words.why, &WHY_SIZES, palette.quiet)]);
}

/// Two lines over each other, each in the first of its sizes in which it fits the width.
fn two_lines(ui: &Ui, room: Rect, lines: [(&str, &[f32], Color32); 2]) {
    let galleys = lines.map(|(text, sizes, colour)| fitted(ui, text, sizes, room.width(), colour));
    let height: f32 = galleys.iter().map(|galley| galley.size().y).sum();
    let mut at = pos2(room.left(), room.center().y - 0.5 * height);
    for (galley, (_, _, colour)) in galleys.into_iter().zip(lines) {
        let down = galley.size().y;
        ui.painter().galley(at, galley, colour);
        at.y += down;
    }
}

/// The text in the first size in which it fits, else wrapped in the smallest.
fn fitted(ui: &Ui, text: &str, sizes: &[f32], width: f32, colour: Color32) -> Arc<Galley> {
    let painter = ui.painter();
    let font = |size: f32| FontId::proportional(size);
    let whole = |size: &f32| painter.layout_no_wrap(text.to_owned(), font(*size), colour);
    let fits = sizes.iter().map(whole).find(|galley| galley.size().x <= width);
    let smallest = sizes.last().copied().unwrap_or(12.0);
    fits.unwrap_or_else(|| painter.layout(text.to_owned(), font(smallest), colour, width))
}

/// The button at the right end; returns its width.
fn button(ui: &mut Ui, acts: &mut Acts, deed: &Deed, room: Rect) -> f32 {
    let palette = theme::of(ui);
    let words = egui::RichText::new(&deed.text).size(16.0).strong().color(palette.on_accent);
    let button = egui::Button::new(words).fill(palette.accent).min_size(vec2(96.0, TOUCH));
    let width = 24.0 + fitted(ui, &deed.text, &[16.0], f32::INFINITY, palette.on_accent).size().x;
    let width = width.max(96.0);
    let place = Rect::from_min_size(pos2(room.right() - width, room.center().y - 0.5 * TOUCH), vec2(width, TOUCH));
    let response = ui.put(place, button);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &deed.spoken));
    if response.clicked() {
        acts.push(deed.act.clone());
    }
    width
}

/// The temperature of the core, large, and the goal below it; none where doneness is told by something else.
fn core(state: &WindowState) -> Option<[String; 2]> {
    let scale = state.scale().filter(|scale| scale.measure() == Measure::Peak)?;
    let piece = state.session.steak()?;
    let goal = state.settings.temperature(state.settings.goal(&scale));
    let core = state.settings.temperature(celsius(piece.core()));
    Some([core, state.settings.language.fill("now.goal", &[("temperature", &goal)])])
}

/// Lights the control that the button stands for.
fn ring(words: &NowWords, ui: &Ui) {
    // Powers have a mark on the slider.
    let deed = words.deed.as_ref().filter(|deed| !matches!(deed.act, Act::Cook(CookAct::HobSet(_))));
    let Some(rect) = deed.and_then(|deed| control_rect(ui, &deed.act)) else { return };
    let over = ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Middle, Id::unique("now-ring")));
    over.rect_stroke(rect.expand(2.0), 9.0, Stroke::new(2.0, theme::of(ui).accent), StrokeKind::Outside);
}
