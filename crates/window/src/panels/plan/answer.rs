//! The plan that was found: what is promised, the time line, the steps, what changes it, and what to do with it.

use egui::{RichText, Ui, vec2};
use saute_plan::schedule::{Plan, Step};

use super::time_line;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::context::PanelContext;
use saute_controls::plan::plan_state::PlanState;
use saute_controls::plan::{PlanAct, PlanFile};
use saute_words::clock::clock;
use saute_words::{cue_words, plan_words};

/// Room for the time of a step, and for what is done [points].
const TIME: f32 = 44.0;
const DEED: f32 = 150.0;

/// Shows a plan.
pub fn show(state: &PlanState, plan: &Plan, ui: &mut Ui, acts: &mut Acts) {
    let (l, settings) = (state.settings.language, state.settings);
    ui.label(RichText::new(plan_words::heading(&plan.order, &state.session.library, settings.speech())).size(15.0));
    if let Some(why) = plan_words::why_not(plan, settings.speech()) {
        ui.label(RichText::new(why).color(theme::of(ui).accent).strong());
    }
    if !state.has_plan() {
        ui.label(RichText::new(l.text("plan.other_choice")).size(13.0).color(theme::of(ui).accent));
    }
    if plan.is_rough {
        ui.label(RichText::new(l.text("plan.rough")).size(13.0).color(theme::of(ui).quiet));
    }
    buttons(state, ui, acts);
    promise(state, plan, ui);
    time_line::show(state, plan, ui);
    plan.steps().iter().for_each(|step| row(state, plan, step, ui));
    ui.add_space(6.0);
    if !plan.sensitivity.is_empty() {
        ui.label(RichText::new(l.text("plan.if_different")).strong());
    }
    for s in &plan.sensitivity {
        ui.label(RichText::new(plan_words::sentence(s, &plan.order.goal, settings.speech())).size(13.5));
    }
    ui.add_space(4.0);
    ui.label(RichText::new(l.text("plan.honest")).size(12.5).color(theme::of(ui).quiet));
}

fn buttons(state: &PlanState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(6.0, 6.0);
        let mut button = |key: &'static str, hint: &'static str, is_next, act| {
            let palette = theme::of(ui);
            let button = if is_next { palette.primary(l.text(key)) } else { palette.button(l.text(key), false) };
            if ui.add(button).on_hover_text(l.text(hint)).clicked() {
                acts.push(Act::Learn(LearnAct::Plan(act)));
            }
        };
        button("plan.cook_live", "plan.cook_live_hint", state.has_plan(), PlanAct::CookLive);
        button("plan.cook_itself", "plan.cook_itself_hint", false, PlanAct::CookItself);
        button(PlanFile::Card.words(), "plan.save_card_hint", false, PlanAct::Save(PlanFile::Card));
        button(PlanFile::Recipe.words(), "plan.save_recipe_hint", false, PlanAct::Save(PlanFile::Recipe));
    });
}

fn promise(state: &PanelContext, plan: &Plan, ui: &mut Ui) {
    let (l, settings) = (state.settings.language, state.settings);
    let core = settings.fine_temperature(plan.promised.core_peak_c);
    ui.label(RichText::new(l.text("plan.promised")).strong());
    let joint = l.text("plan.sentence_joint");
    let words = [
        l.fill("plan.middle", &[("core", &core)]),
        plan_words::on_target(plan, l) + joint,
        plan_words::crust(&plan.promised, l) + joint,
    ];
    ui.label(RichText::new(words.join(l.text("plan.word_joint"))).size(14.0));
}

/// A step: when, what, and what there is to see, hear and feel.
fn row(state: &PanelContext, plan: &Plan, step: &Step, ui: &mut Ui) {
    let (l, settings) = (state.settings.language, state.settings);
    let sense = plan.sense(step, &state.session.library).map(|sense| cue_words::sense(&sense, settings.speech()));
    let narrow = ui.available_width() < 420.0;
    ui.horizontal_top(|ui| {
        let cell = |ui: &mut Ui, width: f32, text: RichText| {
            ui.allocate_ui(vec2(width, 18.0), |ui| {
                ui.set_min_width(width);
                ui.add(egui::Label::new(text).wrap());
            });
        };
        cell(ui, TIME, RichText::new(clock(f64::from(step.at_s))).size(14.5).strong());
        let deed = RichText::new(cue_words::deed(&step.deed, l)).size(14.5).strong();
        if narrow {
            ui.vertical(|ui| {
                ui.label(deed);
                if let Some(sense) = sense {
                    ui.label(RichText::new(sense).size(13.0).color(theme::of(ui).quiet));
                }
            });
        } else {
            cell(ui, DEED, deed);
            if let Some(sense) = sense {
                ui.add(egui::Label::new(RichText::new(sense).size(13.0)).wrap());
            }
        }
    });
}
