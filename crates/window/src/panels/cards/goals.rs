//! The card of the goals: what a cook is judged by, the coach, and skill mode.

use egui::{Rect, RichText, Ui, vec2};
use saute_kitchen::data::goals::{Counted, GoalDescription};

use crate::panels::cards::frame::{Framed, list};
use crate::panels::cards::setting_row::{explained, row};
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card, Setting};
use saute_controls::context::PanelContext;
use saute_controls::goal_choice::{goals_for, named_goal};
use saute_words::doneness_words;

/// Width of the card at most, and below which its names are above their choices [points].
const WIDTH: f32 = 620.0;
const NARROW: f32 = 560.0;
/// Height of a button [points].
const HEIGHT: f32 = 34.0;

/// Shows the card; Esc, the button or a click beside it closes it.
pub fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Goals, id: "goals", title: "goals.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        list(ui, whole, |ui| {
            ui.label(RichText::new(state.settings.language.text("goals.how")).size(13.5).color(theme::of(ui).quiet));
            goals(state, ui, acts);
            ui.separator();
            switches(state, ui, acts);
        });
    });
}

fn goals(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let chosen = named_goal(state.session, state.settings).map(|goal| goal.id.as_str());
    let all = goals_for(state.session);
    if all.is_empty() {
        ui.label(l.text("goals.none"));
    }
    for goal in all {
        let is_on = chosen == Some(goal.id.as_str());
        let size = vec2(ui.available_width(), fingers::height(ui, HEIGHT));
        let name = l.named("goal", &goal.name, &goal.names);
        let button = ui.add(theme::of(ui).button(name, is_on).min_size(size));
        let spoken = l.fill("goals.spoken", &[("goal", &name)]);
        button.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, is_on, &spoken));
        if button.clicked() {
            acts.push(Act::App(AppAct::Set(Setting::GoalNamed(goal.id.clone()))));
        }
        ui.label(RichText::new(wants(state, goal)).size(12.5).color(theme::of(ui).quiet));
    }
}

/// What a goal requires, in words.
fn wants(state: &PanelContext, goal: &GoalDescription) -> String {
    let l = state.settings.language;
    let named = goal.scale.as_deref().and_then(|id| state.session.library.scale(id));
    let of_scale =
        |class| named.map_or_else(|| l.called("class", class), |scale| doneness_words::class(scale, class, l));
    let class = goal.class.as_deref().map_or("", of_scale);
    let share = match goal.counts {
        Counted::Section => {
            let key = if goal.core_counts { "goals.section_and_core" } else { "goals.section" };
            l.fill(key, &[("percent", &goal.least_share_pct), ("class", &class)])
        }
        Counted::Faces => l.fill("goals.faces", &[("percent", &goal.least_share_pct)]),
    };
    let crust = (goal.crust_pct > 0.0).then(|| l.fill("goals.crust", &[("percent", &goal.crust_pct)]));
    let charred =
        (goal.most_charred_pct < 100.0).then(|| l.fill("goals.charred", &[("percent", &goal.most_charred_pct)]));
    let scale = named.map(|scale| l.fill("goals.on_scale", &[("scale", &doneness_words::label(scale, l))]));
    let parts: Vec<String> = [Some(share), crust, charred, scale].into_iter().flatten().collect();
    parts.join(l.text("doneness.list_joint"))
}

/// The coach, forecasts, the result that opens by itself, and skill mode.
fn switches(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let (l, now, narrow) = (state.settings.language, state.settings, ui.available_width() < NARROW);
    let on_off = |on: bool| [(l.text("goals.on"), on), (l.text("goals.off"), !on)];
    if let Some(place) = row(ui, narrow, l.text("goals.coach"), &on_off(now.coach)) {
        acts.push(Act::App(AppAct::Set(Setting::Coach(place == 0))));
    }
    if let Some(place) = row(ui, narrow, l.text("goals.forecasts"), &on_off(now.forecasts)) {
        acts.push(Act::App(AppAct::Set(Setting::Forecasts(place == 0))));
    }
    if let Some(place) = row(ui, narrow, l.text("goals.result_opens"), &on_off(now.result_opens)) {
        acts.push(Act::App(AppAct::Set(Setting::ResultOpens(place == 0))));
    }
    if let Some(place) = row(ui, narrow, l.text("goals.skill"), &on_off(now.skill_mode)) {
        acts.push(Act::App(AppAct::Set(Setting::SkillMode(place == 0))));
    }
    explained(ui, narrow, l.text("goals.skill_how"));
}
