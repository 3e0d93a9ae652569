//! The tutorial on the line: what to do now and why; below it how far one is, and a way out.

use egui::{RichText, Sense, Stroke, Ui, vec2};
use saute_kitchen::advice::Advice;

use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, CookAct, LearnAct};
use saute_controls::context::PanelContext;
use saute_controls::now::now_state::NowState;
use saute_controls::now::now_words::NowWords;
use saute_controls::tutorial::{self, Step, Tutorial};
use saute_words::clock::clock;

/// Size and distance of the dots [points].
const DOT: f32 = 3.5;
const APART: f32 = 12.0;
/// Height of the row [points].
const ROW: f32 = 28.0;

/// What to do now; the hob comes first where its advice is due, with the button that does it.
pub(super) fn words(tutorial: &Tutorial, state: &NowState) -> NowWords {
    let l = state.settings.language;
    if let Some(hob) = hob_first(tutorial, state) {
        let words = NowWords::without_time(hob, state);
        return NowWords { spoken: l.fill("tutorial.hob_first", &[("advice", &words.spoken)]), ..words };
    }
    let [verb, why] = keys(tutorial.step(), state.advice.first()).map(|key| l.text(key).to_owned());
    let is_due = !tutorial.step().waits() || verb != l.text(waiting(tutorial.step()));
    NowWords::told(verb, why, None, is_due, l)
}

/// The control that is meant.
pub(super) fn control(tutorial: &Tutorial, state: &NowState) -> Option<Act> {
    match (tutorial.step(), state.advice.first()) {
        (Step::TakeOut, Some(Advice::Flip)) => Some(Act::Cook(CookAct::Flip)),
        (step, _) => tutorial::control(step),
    }
}

/// Advice about the hob that is due while a step waits for the food.
fn hob_first(tutorial: &Tutorial, state: &NowState) -> Option<Advice> {
    let about_hob = |one: &&Advice| one.hob_w().is_some() && **one != Advice::TurnOff;
    state.advice.iter().find(about_hob).filter(|_| tutorial.step().waits()).copied()
}

/// Keys of the verb and of the reason at a step.
fn keys(step: Step, advice: Option<&Advice>) -> [&'static str; 2] {
    match (step, advice) {
        (Step::HobOn, _) => ["tutorial.hob_on", "tutorial.hob_on_why"],
        (Step::PutIn, _) => ["tutorial.put_in", "tutorial.put_in_why"],
        (Step::Inside, _) => ["tutorial.inside", "tutorial.inside_why"],
        (Step::Flip, Some(Advice::Flip)) => ["tutorial.flip_now", "tutorial.flip_now_why"],
        (Step::TakeOut, Some(Advice::Flip)) => ["tutorial.flip_again", "tutorial.flip_again_why"],
        (Step::TakeOut, Some(one)) if one.is_goal() => ["tutorial.take_out_now", "tutorial.take_out_now_why"],
        (Step::HobOff, _) => ["tutorial.hob_off", "tutorial.hob_off_why"],
        (Step::Halve, _) => ["tutorial.halve", "tutorial.halve_why"],
        (Step::Result, _) => ["tutorial.result", "tutorial.result_why"],
        (Step::Heat, _) => [waiting(step), "tutorial.heat_why"],
        (Step::Flip, _) => [waiting(step), "tutorial.flip_soon_why"],
        (Step::TakeOut, _) => [waiting(step), "tutorial.take_out_soon_why"],
        (Step::Rest, _) => [waiting(step), "tutorial.rest_why"],
    }
}

/// Key of the verb while one waits.
fn waiting(step: Step) -> &'static str {
    match step {
        Step::Flip => "tutorial.flip_soon",
        Step::TakeOut => "tutorial.take_out_soon",
        Step::Rest => "tutorial.rest",
        _ => "tutorial.heat",
    }
}

/// Height of the row below the line [points].
pub(super) fn height(ui: &Ui) -> f32 {
    fingers::height(ui, ROW)
}

/// Dots of the steps, how long it took so far, and the way out.
pub(super) fn show(tutorial: &Tutorial, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let (l, palette) = (state.settings.language, theme::of(ui));
    ui.horizontal_centered(|ui| {
        dots(tutorial, state, ui);
        let [simulated, wall] = tutorial.passed_s().map(clock);
        let words = l.fill("tutorial.passed", &[("simulated", &simulated), ("wall", &wall)]);
        ui.label(RichText::new(words).size(12.0).color(palette.quiet));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let skip = palette.button(l.text("tutorial.skip"), false).min_size(vec2(44.0, height(ui) - 2.0));
            if ui.add(skip).clicked() {
                acts.push(Act::Learn(LearnAct::Tutorial(false)));
            }
        });
    });
}

fn dots(tutorial: &Tutorial, state: &PanelContext, ui: &mut Ui) {
    let (l, palette) = (state.settings.language, theme::of(ui));
    let (count, place) = (Step::ALL.len(), tutorial.place());
    let (dots, response) = ui.allocate_exact_size(vec2(APART * count as f32, 2.0 * DOT + 4.0), Sense::hover());
    let spoken = l.fill("tutorial.step", &[("step", &(place + 1)), ("all", &count)]);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ProgressIndicator, true, &spoken));
    for dot in 0..count {
        let at = dots.left_center() + vec2(APART * (dot as f32 + 0.5), 0.0);
        match dot.cmp(&place) {
            core::cmp::Ordering::Less => ui.painter().circle_filled(at, DOT, palette.chosen),
            core::cmp::Ordering::Equal => {
                ui.painter().circle(at, DOT + 1.0, palette.chosen, Stroke::new(1.5, palette.text))
            }
            core::cmp::Ordering::Greater => ui.painter().circle_stroke(at, DOT, Stroke::new(1.0, palette.quiet)),
        };
    }
}
