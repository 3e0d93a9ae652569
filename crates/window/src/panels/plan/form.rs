//! The request for a plan: food, size, start, target, crust, flips, pan and powers.

use egui::{RichText, TextEdit, Ui, vec2};
use saute_plan::schedule::asked::{scale_for, scales_for};

use crate::panels::pantry::{coldest, pans, sizes, slider, temperature};
use crate::ui::aloud::heading;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, LearnAct, Setting};
use saute_controls::context::PanelContext;
use saute_controls::plan::PlanAct;
use saute_controls::plan::plan_state::PlanState;
use saute_controls::settings::plan_choice::{MOST_FLIPS, PlanChoice};
use saute_session::FoodChoice;
use saute_words::doneness_words;

/// Height of the kinds of plans [points] (chosen: what follows keeps its room in a low window).
const CHIP: f32 = 34.0;

/// Shows the request, and the button that searches.
pub fn show(state: &PlanState, ui: &mut Ui, acts: &mut Acts) {
    let (l, settings) = (state.settings.language, state.settings);
    let (mut choice, mut plan) = (settings.choice.clone(), settings.plan.clone());
    find(state, ui, acts);
    kinds(state, ui, &mut plan);
    heading(ui, l.text("plan.food"));
    foods(state, ui, &mut choice, &mut plan);
    let library = &state.session.library;
    if let Some(food) = library.foods.get(&choice.kind) {
        sizes(ui, food, &mut choice.size_mm, l);
    }
    let coldest = coldest(library, &choice.kind);
    temperature(ui, l.text("pantry.start_temperature"), &mut choice.initial_c, coldest, 30.0, settings.fahrenheit);
    heading(ui, l.text("plan.target"));
    target(state, ui, &choice, &mut plan);
    crust_and_flips(state, ui, &choice, &mut plan);
    heading(ui, l.text("pantry.pan"));
    pans(ui, library, &mut choice, l);
    crate::panels::at_home::chip::show(state, ui, acts);
    powers(state, ui, &mut plan);
    if choice != settings.choice {
        acts.push(Act::App(AppAct::Set(Setting::Choice(choice))));
    }
    if plan != settings.plan {
        acts.push(Act::Learn(LearnAct::Plan(PlanAct::Choose(plan))));
    }
}

/// A plan that is easily followed, or the best one.
fn kinds(state: &PanelContext, ui: &mut Ui, plan: &mut PlanChoice) {
    let l = state.settings.language;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(5.0, 5.0);
        for (name, meaning, is_plain) in [("plan.plain", "plan.plain_is", true), ("plan.best", "plan.best_is", false)] {
            let (name, on) = (l.text(name), plan.plain == is_plain);
            let chip = theme::of(ui).button(name, on).min_size(vec2(0.0, CHIP));
            let response = ui.add(chip).on_hover_text(l.text(meaning));
            response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, name));
            if response.clicked() {
                plan.plain = is_plain;
            }
        }
    });
    let meaning = if plan.plain { "plan.plain_is" } else { "plan.best_is" };
    ui.label(RichText::new(l.text(meaning)).size(12.5).color(theme::of(ui).quiet));
}

fn find(state: &PlanState, ui: &mut Ui, acts: &mut Acts) {
    let text = state.settings.language.text("plan.find");
    let size = vec2(ui.available_width(), theme::TOUCH);
    let palette = theme::of(ui);
    // Beside the plan of this request its own button comes next.
    let button = if state.has_plan() { palette.button(text, false) } else { palette.primary(text) }.min_size(size);
    if ui.add_enabled(!state.planning.is_searching(), button).clicked() {
        acts.push(Act::Learn(LearnAct::Plan(PlanAct::Find)));
    }
}

/// The list of the foods; another one begins with its own size, and with the crust that is usual for it.
fn foods(state: &PanelContext, ui: &mut Ui, choice: &mut FoodChoice, plan: &mut PlanChoice) {
    let (library, l) = (&state.session.library, state.settings.language);
    let name = library.foods.get(&choice.kind).map_or(choice.kind.as_str(), |food| food.name_in(l.code()));
    let name = name.to_owned();
    let combo = egui::ComboBox::from_id_salt("plan-food").selected_text(&name).width(ui.available_width() - 8.0);
    let before = choice.kind.clone();
    let shown = combo.show_ui(ui, |ui| {
        for (id, food) in &library.foods {
            ui.selectable_value(&mut choice.kind, id.clone(), food.name_in(l.code()));
        }
    });
    let spoken = l.fill("plan.food_spoken", &[("food", &name)]);
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &spoken));
    if choice.kind != before {
        plan.crust_pct = None;
        if let Some(food) = library.foods.get(&choice.kind) {
            choice.size_mm.clone_from(&food.size.default_mm);
        }
    }
}

/// The classes of the scale, and a temperature of the core.
fn target(state: &PanelContext, ui: &mut Ui, choice: &FoodChoice, plan: &mut PlanChoice) {
    let (library, l) = (&state.session.library, state.settings.language);
    let scales = scales_for(library, &choice.kind);
    let scale = scale_for(library, &choice.kind, &plan.scale);
    if scales.len() > 1 {
        scale_list(state, ui, &scales, plan);
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(5.0, 5.0);
        if let Some(scale) = scale {
            let wanted = state.settings.class_of_plan(plan, scale).to_owned();
            for class in &scale.class {
                let on = !plan.by_core && class.name == wanted;
                if chip(ui, doneness_words::class(scale, &class.name, l), on) {
                    (plan.by_core, plan.class) = (false, class.name.clone());
                }
            }
        }
        if chip(ui, l.text("plan.by_core"), plan.by_core || scale.is_none()) {
            plan.by_core = true;
        }
    });
    if plan.by_core || scale.is_none() {
        temperature(ui, l.text("plan.core_wanted"), &mut plan.core_c, 35.0, 95.0, state.settings.fahrenheit);
    }
}

fn scale_list(
    state: &PanelContext,
    ui: &mut Ui,
    scales: &[&std::sync::Arc<saute_kitchen::food::Scale>],
    plan: &mut PlanChoice,
) {
    let l = state.settings.language;
    let here = scales.iter().find(|scale| scale.id == plan.scale).or(scales.first());
    let name = here.map_or("", |scale| doneness_words::label(scale, l));
    let combo = egui::ComboBox::from_id_salt("plan-scale").selected_text(name).width(ui.available_width() - 8.0);
    let shown = combo.show_ui(ui, |ui| {
        for scale in scales {
            ui.selectable_value(&mut plan.scale, scale.id.clone(), doneness_words::label(scale, l));
        }
    });
    let spoken = l.fill("plan.scale_spoken", &[("scale", &name)]);
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &spoken));
}

fn chip(ui: &mut Ui, text: &str, on: bool) -> bool {
    let response = ui.add(theme::of(ui).button(text, on));
    response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, text));
    response.clicked()
}

fn crust_and_flips(state: &PanelContext, ui: &mut Ui, choice: &FoodChoice, plan: &mut PlanChoice) {
    let l = state.settings.language;
    let usual = plan.crust_of(&state.session.library, &choice.kind);
    let mut crust = usual;
    slider(ui, l.text("plan.crust"), &mut crust, 0.0, 100.0, " %");
    if crust != usual {
        plan.crust_pct = Some(crust.round());
    }
    // A plain plan has one.
    if plan.plain {
        return;
    }
    let mut flips = plan.most_flips as f64;
    slider(ui, l.text("plan.flips"), &mut flips, 0.0, MOST_FLIPS as f64, "");
    plan.most_flips = flips.round() as usize;
}

/// The powers that the hob has, as they are typed.
fn powers(state: &PanelContext, ui: &mut Ui, plan: &mut PlanChoice) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("plan.powers")).size(13.0).color(theme::of(ui).quiet));
    let dial = PlanChoice::default().powers_w(state.settings.choice.hob(&state.session.library));
    let dial: Vec<String> = dial.iter().map(f64::to_string).collect();
    let field = TextEdit::singleline(&mut plan.powers).hint_text(dial.join(", ")).desired_width(ui.available_width());
    let spoken = l.text("plan.powers");
    theme::field(ui, field).widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::TextInput, true, spoken));
    ui.label(RichText::new(l.text("plan.powers_how")).size(12.5).color(theme::of(ui).quiet));
}
