//! Hob, cloth, hands and time.

use egui::{RichText, Ui};
use saute_kitchen::advice::NoPower;
use saute_kitchen::doneness::core_class;
use saute_kitchen::{Kitchen, Place, celsius};

use crate::act::{Act, Acts, hint};
use crate::panels::inside::clock;
use crate::panels::pour;
use crate::panels::window_state::WindowState;
use crate::session::SPEEDS;
use crate::ui::theme;

/// Shows the controls: in three rows, or wrapped where it is narrow.
pub fn show(state: &WindowState, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| hands(state, ui, acts));
        ui.horizontal_wrapped(|ui| pour::show(state, ui, acts));
        ui.horizontal_wrapped(|ui| hob(state, ui, acts));
        ui.horizontal_wrapped(|ui| time(state, ui, acts));
        ui.separator();
        temperatures(state, ui);
        crate::panels::inside::show_advice(state, ui);
        return;
    }
    ui.horizontal(|ui| {
        hob(state, ui, acts);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| time_right_to_left(state, ui, acts));
    });
    ui.horizontal(|ui| hands(state, ui, acts));
    ui.horizontal(|ui| pour::show(state, ui, acts));
}

/// Core and pan at a glance, where the panel with all readings is not open.
fn temperatures(state: &WindowState, ui: &mut Ui) {
    let Some(piece) = state.session.steak() else { return };
    let l = state.settings.language;
    let shown = |kelvin: f64| state.settings.temperature(celsius(kelvin));
    let (core, pan) = (shown(piece.core()), shown(state.session.kitchen.pan_temperature()));
    ui.label(RichText::new(l.fill("hob.core_and_pan", &[("core", &core), ("pan", &pan)])).size(18.0).strong());
    if let Some(scale) = state.scale() {
        let class = l.called("class", core_class(piece, &scale));
        let class = l.fill("hob.class_so_far", &[("class", &class), ("scale", &l.called("scale", &scale.name))]);
        ui.label(RichText::new(class).size(13.0).color(theme::of(ui).quiet));
    }
}

fn hob(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("hob.hob")).color(theme::of(ui).quiet));
    let settings = state.session.kitchen.hob().coil.settings_w.clone();
    let now = state.session.kitchen.hob_w();
    let holds = state.session.kitchen.hob_holds().is_some();
    for w in settings {
        let text = if w == 0.0 { l.text("hob.off").to_owned() } else { format!("{w:.0} W") };
        let on = (w - now).abs() < 0.5 && !holds;
        if press(ui, &text, on, true, l.text("hob.power")) {
            acts.push(Act::HobSet(w));
        }
    }
    let custom = !state.session.kitchen.hob().coil.settings_w.iter().any(|w| (w - now).abs() < 0.5);
    if custom && !holds {
        ui.label(RichText::new(format!("{now:.0} W")).color(theme::of(ui).accent));
    }
    hold(state, ui, acts);
}

/// The temperatures at which the hob can hold the pan, in a list.
fn hold(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let (l, kitchen) = (state.settings.language, &state.session.kitchen);
    let held = kitchen.hob_holds().map(celsius);
    let words = |c: f64| l.fill("hob.hold_at", &[("temperature", &state.settings.temperature(c))]);
    let text = held.map_or_else(|| l.text("hob.hold").to_owned(), words);
    let colour = if held.is_some() { theme::of(ui).accent } else { theme::of(ui).text };
    let list = egui::ComboBox::from_id_salt("hold").selected_text(RichText::new(text).color(colour));
    let shown = list.show_ui(ui, |ui| {
        for c in &kitchen.hob().hold.settings_c {
            let on = held.is_some_and(|held| (held - c).abs() < 0.5);
            if ui.selectable_label(on, state.settings.temperature(*c)).clicked() {
                acts.push(Act::HobHold(*c));
            }
        }
    });
    shown.response.on_hover_text(l.text("hob.hold_hint"));
}

fn hands(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let place = state.session.steak().map(|p| p.place);
    let in_pan = matches!(place, Some(Place::Pan(_)));
    let outside = |id: &String| state.session.kitchen.piece(id).is_some_and(|p| !p.in_pan());
    let some_outside = state.session.its_group().iter().any(outside);
    let next_is_put = matches!(place, Some(Place::Waiting));
    let food_in = l.fill("hob.food_in", &[("food", &capitalised(l.called("noun", &state.session.noun())))]);
    button(state, ui, acts, &food_in, next_is_put, some_outside, Act::Put);
    button(state, ui, acts, l.text("hob.flip"), false, in_pan, Act::Flip);
    if matches!(place, Some(Place::Rest(_))) {
        // What lies on the board cannot be taken out, but cut.
        let whole = state.session.steak().is_some_and(|p| p.halved().is_none());
        button(state, ui, acts, l.text("hob.halve"), false, whole, Act::Halve);
    } else {
        button(state, ui, acts, l.text("hob.take_out"), false, in_pan, Act::Out);
    }
    let on_cloth = state.session.kitchen.cloth().is_some();
    button(state, ui, acts, l.text("hob.cloth"), on_cloth, true, Act::Cloth);
    button(state, ui, acts, l.text("hob.restart"), false, true, Act::Restart);
    if let Some(text) = no_power(&state.session.kitchen) {
        ui.label(RichText::new(l.text(text)).size(13.0).color(theme::of(ui).accent).strong());
    }
    if let Some(runner) = &state.session.runner {
        let text = l.fill(
            "hob.next_step",
            &[
                ("title", &l.called("recipe", &runner.recipe().title)),
                ("step", &crate::words::next_step::words(runner, state.settings)),
            ],
        );
        ui.add(egui::Label::new(RichText::new(text).size(13.0).color(theme::of(ui).quiet)).truncate());
    }
}

/// Key of why the hob gives no power although it is on.
fn no_power(kitchen: &Kitchen) -> Option<&'static str> {
    Some(match NoPower::of(kitchen)? {
        NoPower::Cloth => "hob.no_power_cloth",
        NoPower::Limit => "hob.no_power_limit",
        NoPower::Lifted => "hob.no_power_lifted",
        NoPower::OffRing => "hob.no_power_off_ring",
    })
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn time(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let pause = pause_word(state);
    ui.label(RichText::new(clock(state.session.kitchen.time_s())).size(20.0).strong());
    button(state, ui, acts, pause, state.session.paused, true, Act::Pause);
    button(state, ui, acts, state.settings.language.text("hob.step"), false, true, Act::Step);
    SPEEDS.into_iter().for_each(|speed| speed_button(state, ui, acts, speed));
}

fn time_right_to_left(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    SPEEDS.into_iter().rev().for_each(|speed| speed_button(state, ui, acts, speed));
    button(state, ui, acts, state.settings.language.text("hob.step"), false, true, Act::Step);
    let pause = pause_word(state);
    button(state, ui, acts, pause, state.session.paused, true, Act::Pause);
    ui.label(RichText::new(clock(state.session.kitchen.time_s())).size(20.0).strong());
}

fn pause_word(state: &WindowState) -> &'static str {
    state.settings.language.text(if state.session.paused { "hob.go_on" } else { "hob.pause" })
}

fn speed_button(state: &WindowState, ui: &mut Ui, acts: &mut Acts, speed: f64) {
    if press(ui, &format!("{speed:.0}×"), state.session.speed == speed, true, state.settings.language.text("hob.speed"))
    {
        acts.push(Act::SpeedSet(speed));
    }
}

pub(crate) fn button(state: &WindowState, ui: &mut Ui, acts: &mut Acts, text: &str, on: bool, enabled: bool, act: Act) {
    if press(ui, text, on, enabled, &hint(&act, state.settings.language)) {
        acts.push(act);
    }
}

fn press(ui: &mut Ui, text: &str, on: bool, enabled: bool, hint: &str) -> bool {
    let response = ui.add_enabled(enabled, theme::of(ui).button(text, on));
    response.on_hover_text(hint).clicked()
}
