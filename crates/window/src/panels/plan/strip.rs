//! The strip over the scene in a cook that follows a plan: the next step with its time, its cue and a bell, and what it gave in the end.

use egui::{Align2, Area, Id, RichText, Stroke, Ui, pos2, vec2};
use saute_plan::goal::Outcome;
use saute_plan::schedule::Deed;
use saute_plan::schedule::follow::{Followed, LATE_S, Left};
use saute_plan::schedule::voice::Keeping;

use crate::act::{Act, Acts, AppAct, Card, LearnAct, TimeAct};
use crate::panels::cook::hob_bar::capitalised;
use crate::panels::window_state::WindowState;
use crate::plan::PlanAct;
use crate::ui::bell::{self, Bell};
use crate::ui::layout::{GAP, Layout};
use crate::ui::{fingers, theme};
use saute_session::plan::live::{Guidance, Live, READY_S};
use saute_words::clock::clock;
use saute_words::language::Language;
use saute_words::{cue_words, plan_words};

/// Its width at most, and its height: always the same, so that nothing moves when the words change [points].
const WIDTH: f32 = 600.0;
const HEIGHT: f32 = 148.0;
/// Its height where the buttons stand on a line of their own [points].
const NARROW_HEIGHT: f32 = 192.0;
/// Height of a button, and of the bell [points].
const BUTTON: f32 = 34.0;
const BELL: f32 = 28.0;

/// Shows the strip where a cook follows a plan; returns the layout for messages, which stand below it.
pub fn show(state: &WindowState, ui: &Ui, acts: &mut Acts, layout: &Layout) -> Layout {
    let Some(live) = state.live.filter(|live| layout.ways.is_none() && !live.is_closed()) else { return *layout };
    let guidance = live.guidance(state.session);
    let top = layout.free.top() + if layout.narrow { layout.eye.height() + 2.0 * GAP } else { 12.0 + 2.0 * GAP };
    let width = WIDTH.min(layout.free.width() - 2.0 * GAP);
    let height = if layout.narrow { NARROW_HEIGHT } else { HEIGHT };
    let area = Area::new(Id::unique("plan-strip")).fixed_pos(pos2(layout.free.center().x, top));
    area.pivot(Align2::CENTER_TOP).show(ui.ctx(), |ui| {
        let is_due = guidance.due_in_s().is_some_and(|in_s| in_s <= 0.0);
        let palette = theme::of(ui);
        let edge = if is_due { Stroke::new(3.0, palette.accent) } else { Stroke::new(1.0, palette.line) };
        palette.panel().fill(palette.solid).stroke(edge).inner_margin(10).show(ui, |ui| {
            ui.set_min_size(vec2(width - 20.0, height - 20.0));
            ui.set_max_size(vec2(width - 20.0, height - 20.0));
            ui.spacing_mut().item_spacing.y = 3.0;
            match live.gave() {
                Some(gave) => verdict(state, live, gave, ui, acts),
                None => next(state, live, &guidance, ui, acts),
            }
        });
    });
    let mut below = *layout;
    below.free.min.y += height + GAP;
    below
}

/// The steps that come next.
fn next(state: &WindowState, live: &Live, guidance: &Guidance, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let due_in_s = guidance.due_in_s().unwrap_or_default();
    let deeds = cue_words::deeds(&guidance.next, l);
    ui.horizontal(|ui| {
        let rings = due_in_s <= 0.0;
        let spoken = state.settings.language.text(if rings { "plan.bell_rings" } else { "plan.bell_waits" });
        bell::show(ui, &Bell { size: BELL, spoken, rings, moves: !state.settings.moves_less() });
        ui.label(RichText::new(capitalised(&deeds)).size(18.0).strong());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| countdown(state, guidance, ui));
    });
    let senses: Vec<String> = guidance.next.iter().filter_map(|f| cue(state, live, f)).collect();
    let senses = RichText::new(senses.join(" ")).size(13.5).color(theme::of(ui).quiet);
    let lines = if ui.available_width() < 460.0 { 58.0 } else { 36.0 };
    ui.allocate_ui(vec2(ui.available_width(), lines), |ui| {
        ui.set_min_height(lines);
        ui.add(egui::Label::new(senses).wrap());
    });
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        // A step that is done early is none of the plan.
        let can_do = due_in_s <= 0.0 && guidance.next.iter().any(|f| f.step.deed != Deed::Serve);
        let words = l.fill("plan.do_it", &[("deed", &deeds)]);
        button(ui, acts, (l.text("plan.do_it_short"), &words), due_in_s <= 0.0, can_do, PlanAct::DoStep);
        let hurry = l.text("plan.hurry");
        // Doing the step starts the clock too: there is one way to go on.
        if state.session.paused && !can_do {
            let start = l.text("plan.start");
            let palette = theme::of(ui);
            let button = if due_in_s > 0.0 { palette.primary(start) } else { palette.button(start, false) };
            if ui.add(button.min_size(size(ui))).clicked() {
                acts.push(Act::Time(TimeAct::Pause));
            }
        } else {
            button(ui, acts, (hurry, hurry), false, due_in_s > READY_S && state.session.speed < 20.0, PlanAct::Hurry);
        }
        leave(state, ui, acts);
    });
    said(state, live, guidance, ui);
}

fn size(ui: &Ui) -> egui::Vec2 {
    vec2(44.0, fingers::height(ui, BUTTON))
}

fn button(ui: &mut Ui, acts: &mut Acts, (text, spoken): (&str, &str), on: bool, enabled: bool, act: PlanAct) {
    let palette = theme::of(ui);
    let button = if on && enabled { palette.primary(text) } else { palette.button(text, false) };
    let response = ui.add_enabled(enabled, button.min_size(size(ui)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, enabled, spoken));
    if response.clicked() {
        acts.push(Act::Learn(LearnAct::Plan(act)));
    }
}

fn leave(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let button = theme::of(ui).button(l.text("plan.leave"), false).min_size(size(ui));
    if ui.add(button).on_hover_text(l.text("plan.leave_hint")).clicked() {
        acts.push(Act::Learn(LearnAct::Plan(PlanAct::Leave)));
    }
}

fn cue(state: &WindowState, live: &Live, followed: &Followed) -> Option<String> {
    // Of food that is out there is nothing to feel.
    let followed = Some(followed).filter(|followed| followed.left != Left::Hob)?;
    let sense = live.plan().sense(&followed.step, &state.session.library)?;
    Some(cue_words::sense(&sense, state.settings.speech()))
}

/// In how long, now, or how late.
fn countdown(state: &WindowState, guidance: &Guidance, ui: &mut Ui) {
    let l = state.settings.language;
    let in_s = guidance.due_in_s().unwrap_or_default();
    let (text, colour) = match in_s {
        s if s > 0.0 => (l.fill("plan.in", &[("time", &clock(s.ceil()))]), theme::of(ui).text),
        s if s > -LATE_S => (l.text("plan.now").to_owned(), theme::of(ui).accent),
        s => (l.fill("plan.late_by", &[("seconds", &format!("{:.0}", -s))]), theme::of(ui).accent),
    };
    ui.label(RichText::new(text).size(18.0).strong().color(colour));
}

/// That the plan is left or time slowed down, else whether the last step was early or late and that the others keep their times.
fn said(state: &WindowState, live: &Live, guidance: &Guidance, ui: &mut Ui) {
    let l = state.settings.language;
    let [step, all] = guidance.place();
    let place = l.fill("plan.step_of", &[("step", &step), ("all", &all)]);
    // After the last step time stands still.
    let returns_to = live.returns_to().filter(|_| step < all);
    let (text, ink) = match (left_words(live.keeping(state.session), l), returns_to) {
        (Some(left), _) => (left, theme::of(ui).accent),
        (None, Some(speed)) => (l.fill("plan.returns_to", &[("speed", &format!("{speed:.0}"))]), theme::of(ui).quiet),
        (None, None) => (last_words(guidance, l), theme::of(ui).quiet),
    };
    let text = format!("{place} {text}");
    ui.add(egui::Label::new(RichText::new(&text).size(13.0).color(ink)).truncate()).on_hover_text(text);
}

/// How the plan was left, and who speaks then.
fn left_words(keeping: Keeping, l: Language) -> Option<String> {
    match keeping {
        Keeping::Kept => None,
        Keeping::Missed(deed) => Some(l.fill("plan.missed", &[("deed", &cue_words::deed(&deed, l))])),
        Keeping::OtherPower(w) => Some(l.fill("plan.other_power", &[("power", &format!("{w:.0}"))])),
    }
}

fn last_words(guidance: &Guidance, l: Language) -> String {
    guidance.last.map_or_else(
        || l.text("plan.begin_how").to_owned(),
        |(deed, late_s)| {
            let seconds = format!("{:.0}", late_s.abs());
            let key = match late_s {
                s if s > LATE_S => "plan.was_late",
                s if s < -LATE_S => "plan.was_early",
                _ => "plan.was_right",
            };
            l.fill(key, &[("deed", &cue_words::deed(&deed, l)), ("seconds", &seconds)])
        },
    )
}

/// What was promised beside what was reached.
fn verdict(state: &WindowState, live: &Live, gave: &Outcome, ui: &mut Ui, acts: &mut Acts) {
    let (l, settings, plan) = (state.settings.language, state.settings, live.plan());
    ui.label(RichText::new(l.text("plan.over")).size(18.0).strong());
    let line = |outcome: &Outcome, key: &'static str| {
        let (core, share) =
            (settings.fine_temperature(outcome.core_peak_c), format!("{:.0}", outcome.target_share_pct));
        let crust = format!("{:.0}", outcome.crust_pct);
        let class = plan_words::class(&plan.order.goal, l);
        l.fill(key, &[("core", &core), ("share", &share), ("class", &class), ("crust", &crust)])
    };
    ui.label(RichText::new(line(&plan.promised, "plan.was_promised")).size(14.0).color(theme::of(ui).quiet));
    ui.label(RichText::new(line(gave, "plan.was_reached")).size(14.0));
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let result = theme::of(ui).primary(l.text("result.title")).min_size(size(ui));
        if ui.add(result).on_hover_text(l.text("result.hint")).clicked() {
            acts.push(Act::App(AppAct::Open(Card::Result)));
        }
        leave(state, ui, acts);
    });
}
