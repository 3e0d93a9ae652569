//! The card of plans: the request on its left, what was found on its right.

use egui::{Rect, RichText, ScrollArea, Ui};

use super::{answer, form};
use crate::panels::cards::frame::{Framed, part};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, Card, LearnAct};
use saute_controls::plan::PlanAct;
use saute_controls::plan::plan_state::PlanState;
use saute_session::plan::planning::SearchStatus;
use saute_words::clock::clock;
use saute_words::plan_words;

/// Width of the card at most, and of the request where the answer is beside it [points].
const WIDTH: f32 = 1000.0;
const FORM: f32 = 318.0;
/// Below this width the answer is below the request [points].
const NARROW: f32 = 760.0;

/// Shows the card over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &PlanState, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Plan, id: "plan", title: "plan.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        let height = whole.height() - 112.0;
        if whole.width() < NARROW {
            let scrolled = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
            scrolled.auto_shrink([false, true]).show(ui, |ui| narrow(state, ui, acts));
            return;
        }
        ui.horizontal_top(|ui| {
            part(ui, "asked", FORM, height, |ui| form::show(state, ui, acts));
            let rest = ui.available_width();
            part(ui, "answer", rest, height, |ui| found(state, ui, acts));
        });
    });
}

/// What was found comes first once there is something.
fn narrow(state: &PlanState, ui: &mut Ui, acts: &mut Acts) {
    if *state.planning.standing() == SearchStatus::Idle {
        form::show(state, ui, acts);
        ui.separator();
        found(state, ui, acts);
    } else {
        found(state, ui, acts);
        ui.separator();
        form::show(state, ui, acts);
    }
}

fn found(state: &PlanState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    match state.planning.standing() {
        SearchStatus::Idle => {
            ui.label(RichText::new(l.text("plan.how")).color(theme::of(ui).quiet));
        }
        SearchStatus::Searching(progress) => {
            let (share, count) = progress.map_or((0.0, 0), |progress| (progress.share, progress.candidates));
            let stage = progress.map_or("plan.stage_first", |progress| plan_words::stage(progress.stage));
            searching(state, ui, acts, share as f32, &l.fill(stage, &[("count", &count)]));
        }
        SearchStatus::Refused(why) => {
            ui.label(RichText::new(l.fill("plan.refused", &[("why", &why.words(l))])).color(theme::of(ui).accent));
        }
        SearchStatus::Found(plan) => answer::show(state, plan, ui, acts),
    }
}

/// The bar, what is done now, and the button that ends it.
fn searching(state: &PlanState, ui: &mut Ui, acts: &mut Acts, share: f32, doing: &str) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("plan.searching")).size(17.0));
    let bar = ui.add(egui::ProgressBar::new(share).desired_width(ui.available_width()).fill(theme::of(ui).chosen));
    let spoken = l.fill("plan.progress", &[("percent", &format!("{:.0}", 100.0 * share))]);
    bar.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ProgressIndicator, true, &spoken));
    ui.label(RichText::new(doing).color(theme::of(ui).quiet));
    let left = match state.planning.left_s() {
        Some(left_s) => l.fill("plan.left", &[("time", &clock(10.0 * (0.1 * left_s).ceil()))]),
        None => l.text("plan.usual_time").to_owned(),
    };
    ui.label(RichText::new(left).color(theme::of(ui).quiet));
    ui.label(RichText::new(l.text("plan.meanwhile")).size(13.0).color(theme::of(ui).quiet));
    let ends = if state.planning.has_so_far() { "plan.stop" } else { "plan.cancel" };
    if ui.add(theme::of(ui).button(l.text(ends), false)).clicked() {
        acts.push(Act::Learn(LearnAct::Plan(PlanAct::Stop)));
    }
}
