//! The callout of the tutorial: what to do now, how far one is, and a way out.

use egui::{Align2, Area, Id, Rect, RichText, Sense, Stroke, StrokeKind, Ui, vec2};
use saute_kitchen::advice::Advice;

use crate::act::{Act, Acts, CookAct, LearnAct};
use crate::learn::tutorial::{Step, Tutorial, control};
use crate::panels::learn::advice_words::{advice_words, do_it_words};
use crate::panels::window_state::WindowState;
use crate::ui::layout::{GAP, Layout};
use crate::ui::theme;
use saute_words::clock::clock;

/// Width of the callout beside the pan, and over the scene of a narrow window [points].
const WIDTH: f32 = 236.0;
/// Size and distance of the dots [points].
const DOT: f32 = 3.5;
const APART: f32 = 12.0;

/// Shows the callout while the tutorial runs, and a ring round the control that is meant.
pub fn show(state: &WindowState, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    let Some(tutorial) = &state.tutorial else { return };
    if state.card.is_some() {
        return;
    }
    let narrow = layout.narrow;
    // Where it is narrow there is no room beside the pan: it stands over the chips of the views, while none of them is meant.
    let at = match narrow {
        true if tutorial.step() != Step::Inside => layout.top.min,
        true => layout.free.left_top() + vec2(GAP, GAP),
        false => layout.free.left_top() + vec2(GAP + 4.0, 36.0),
    };
    let width = if narrow { layout.free.width() - 44.0 } else { WIDTH };
    Area::new(Id::unique("tutorial")).fixed_pos(at).pivot(Align2::LEFT_TOP).show(ui.ctx(), |ui| {
        let palette = theme::of(ui);
        let frame = palette.panel().fill(palette.solid).stroke(Stroke::new(1.5, palette.accent)).inner_margin(10);
        frame.show(ui, |ui| {
            ui.set_width(width);
            ui.spacing_mut().item_spacing.y = 5.0;
            let hob = hob_first(state, tutorial);
            ui.label(RichText::new(words(state, tutorial, hob)).size(14.5));
            if let Some(watts) = hob.and_then(Advice::hob_w)
                && ui.button(do_it_words(watts, state)).clicked()
            {
                acts.push(Act::Cook(CookAct::HobSet(watts)));
            }
            foot(state, tutorial, ui, acts);
        });
    });
    ring(tutorial, ui);
}

/// Advice about the hob that is due while a step waits for the food.
fn hob_first(state: &WindowState, tutorial: &Tutorial) -> Option<Advice> {
    let about_hob = |one: &&Advice| one.hob_w().is_some() && **one != Advice::TurnOff;
    state.advice.iter().find(about_hob).filter(|_| tutorial.step().waits()).copied()
}

/// What to do now; the hob comes first where its advice is due.
fn words(state: &WindowState, tutorial: &Tutorial, hob: Option<Advice>) -> String {
    let l = state.settings.language;
    if let Some(hob) = hob {
        return l.fill("tutorial.hob_first", &[("advice", &advice_words(hob, state))]);
    }
    l.text(match tutorial.step() {
        Step::HobOn => "tutorial.hob_on",
        Step::Heat => "tutorial.heat",
        Step::PutIn => "tutorial.put_in",
        Step::Inside => "tutorial.inside",
        Step::Flip if state.advice.first() == Some(&Advice::Flip) => "tutorial.flip_now",
        Step::Flip => "tutorial.flip_soon",
        Step::TakeOut if state.advice.first().is_some_and(|one| one.is_goal()) => "tutorial.take_out_now",
        Step::TakeOut if state.advice.first() == Some(&Advice::Flip) => "tutorial.flip_again",
        Step::TakeOut => "tutorial.take_out_soon",
        Step::HobOff => "tutorial.hob_off",
        Step::Rest => "tutorial.rest",
        Step::Halve => "tutorial.halve",
        Step::Result => "tutorial.result",
    })
    .to_owned()
}

/// Dots of the steps, how long it took so far, and the way out.
fn foot(state: &WindowState, tutorial: &Tutorial, ui: &mut Ui, acts: &mut Acts) {
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
    ui.horizontal(|ui| {
        let [simulated, wall] = tutorial.passed_s().map(clock);
        let words = l.fill("tutorial.passed", &[("simulated", &simulated), ("wall", &wall)]);
        ui.label(RichText::new(words).size(12.0).color(palette.quiet));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button(l.text("tutorial.skip")).clicked() {
                acts.push(Act::Learn(LearnAct::Tutorial(false)));
            }
        });
    });
}

/// Notes where the control of an act is, for the ring of the tutorial.
pub fn note_control(ui: &Ui, act: &Act, rect: Rect) {
    ui.ctx().data_mut(|data| data.insert_temp(id_of(act), rect));
}

/// Where the control of an act is, if it was shown.
pub(crate) fn control_rect(ui: &Ui, act: &Act) -> Option<Rect> {
    ui.ctx().data(|data| data.get_temp::<Rect>(id_of(act)))
}

fn id_of(act: &Act) -> Id {
    Id::unique(("control", format!("{act:?}")))
}

/// A ring round the control that is meant.
fn ring(tutorial: &Tutorial, ui: &Ui) {
    let Some(act) = control(tutorial.step()) else { return };
    let Some(rect) = control_rect(ui, &act) else { return };
    let over = ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Foreground, Id::unique("tutorial-ring")));
    over.rect_stroke(rect.expand(3.0), 10.0, Stroke::new(2.5, theme::of(ui).accent), StrokeKind::Outside);
}
