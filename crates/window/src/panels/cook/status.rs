//! A line of words under the controls: what is in the pan, why the hob gives no power, and how far the recipe is.

use egui::{Label, RichText, Ui, vec2};
use saute_kitchen::advice::NoPower;
use saute_kitchen::{EventKind, Holding, Kitchen};

use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;
use saute_controls::input::pouring::{danger, in_the_pan};

/// Size of the bar of a recipe's progress [points].
const BAR: egui::Vec2 = vec2(90.0, 8.0);

/// Shows the line: always of one height, so that nothing moves when a part of it comes or goes.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let kitchen = &state.session.kitchen;
    if let Some(key) = no_power(kitchen) {
        said(ui, RichText::new(l.text(key)).color(theme::of(ui).accent).strong());
    }
    // What is measured or advised is a read-out like any other.
    if state.is_blind() {
        return;
    }
    if kitchen.holding() == Some(Holding::Boils) {
        let text = EventKind::BoilsBelowDial.advice().unwrap_or_default();
        said(ui, RichText::new(l.called("event", text)).color(theme::of(ui).accent).strong());
    }
    if let Some(text) = danger(kitchen, l) {
        said(ui, RichText::new(text).color(theme::of(ui).accent).strong());
    }
    let text = l.fill("pour.in_the_pan", &[("what", &in_the_pan(kitchen, l))]);
    said(ui, RichText::new(text).color(theme::of(ui).quiet));
    recipe(state, ui, acts);
}

/// The recipe that plays with its next step, or the way back to the one that was left.
fn recipe(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    if let Some(title) = state.session.left_recipe() {
        let text = l.fill("hob.resume", &[("title", &l.called("recipe", title))]);
        ui.spacing_mut().button_padding.y = 0.0;
        let height = fingers::height(ui, 18.0);
        let button = egui::Button::new(RichText::new(text).size(13.0)).min_size(vec2(0.0, height));
        if ui.add(button).on_hover_text(l.text("hob.resume_hint")).clicked() {
            acts.push(Act::Cook(CookAct::ResumeRecipe));
        }
        return;
    }
    let Some(runner) = &state.session.runner else { return };
    let (done, all) = (runner.waiting_step(), runner.recipe().steps.len());
    bar(ui, done as f32 / all.max(1) as f32, &l.fill("hob.progress", &[("done", &done), ("all", &all)]));
    let title = l.called("recipe", &runner.recipe().title);
    let step = saute_words::next_step::words(runner, &state.session.library, state.settings.speech());
    let text = l.fill("hob.next_step", &[("title", &title), ("step", &step)]);
    said(ui, RichText::new(text).color(theme::of(ui).quiet));
}

/// How many steps of the recipe are done.
fn bar(ui: &mut Ui, share: f32, spoken: &str) {
    let (rect, response) = ui.allocate_exact_size(BAR, egui::Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ProgressIndicator, true, spoken));
    let palette = theme::of(ui);
    ui.painter().rect_filled(rect, 4.0, palette.raised);
    let full = egui::Rect::from_min_size(rect.min, vec2(rect.width() * share.clamp(0.0, 1.0), rect.height()));
    ui.painter().rect_filled(full, 4.0, palette.chosen);
    response.on_hover_text(spoken);
}

fn said(ui: &mut Ui, text: RichText) {
    ui.add(Label::new(text.size(13.0)).truncate());
}

/// Key of why the hob gives no power although it is on.
fn no_power(kitchen: &Kitchen) -> Option<&'static str> {
    Some(match NoPower::of(kitchen)? {
        NoPower::Cloth => "hob.no_power_cloth",
        NoPower::Limit => "hob.no_power_limit",
        NoPower::NearLimit => "hob.less_power_limit",
        NoPower::Lifted => "hob.no_power_lifted",
        NoPower::OffRing => "hob.no_power_off_ring",
    })
}
