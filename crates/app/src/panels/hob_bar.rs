//! Hob, cloth, hands and time.

use egui::{RichText, Ui};
use saute_kitchen::{Kitchen, Place, celsius};

use crate::act::{Act, BINDINGS};
use crate::app::SauteApp;
use crate::panels::inside::clock;
use crate::panels::pour;
use crate::session::SPEEDS;
use crate::theme;

/// Shows the controls: in three rows, or wrapped where it is narrow.
pub fn show(app: &mut SauteApp, ui: &mut Ui, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| hands(app, ui));
        ui.horizontal_wrapped(|ui| pour::show(app, ui));
        ui.horizontal_wrapped(|ui| hob(app, ui));
        ui.horizontal_wrapped(|ui| time(app, ui));
        ui.separator();
        temperatures(app, ui);
        crate::panels::inside::show_advice(app, ui);
        return;
    }
    ui.horizontal(|ui| {
        hob(app, ui);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| time_right_to_left(app, ui));
    });
    ui.horizontal(|ui| hands(app, ui));
    ui.horizontal(|ui| pour::show(app, ui));
}

/// Core and pan at a glance, where the panel with all readings is not open.
fn temperatures(app: &SauteApp, ui: &mut Ui) {
    let Some(piece) = app.session.steak() else { return };
    let shown = |kelvin: f64| app.settings.temperature(celsius(kelvin));
    let (core, pan) = (shown(piece.core()), shown(app.session.kitchen.pan_temperature()));
    ui.label(RichText::new(format!("core {core}   ·   pan {pan}")).size(18.0).strong());
    if let Some(scale) = app.scale() {
        let class = format!("core so far: {} (scale: {})", scale.name_of(piece.core_peak.0), scale.name);
        ui.label(RichText::new(class).size(13.0).color(theme::QUIET));
    }
}

fn hob(app: &mut SauteApp, ui: &mut Ui) {
    ui.label(RichText::new("Hob").color(theme::QUIET));
    let settings = app.session.kitchen.hob().coil.settings_w.clone();
    let now = app.session.kitchen.hob_w();
    for w in settings {
        let text = if w == 0.0 { "off".to_owned() } else { format!("{w:.0} W") };
        let on = (w - now).abs() < 0.5;
        if press(ui, &text, on, true, "hob power (Q lower, E higher)") {
            app.act(Act::HobSet(w), &ui.ctx().clone());
        }
    }
    let custom = !app.session.kitchen.hob().coil.settings_w.iter().any(|w| (w - now).abs() < 0.5);
    if custom {
        ui.label(RichText::new(format!("{now:.0} W")).color(theme::ACCENT));
    }
}

fn hands(app: &mut SauteApp, ui: &mut Ui) {
    let place = app.session.steak().map(|p| p.place);
    let in_pan = matches!(place, Some(Place::Pan(_)));
    let outside = |id: &String| app.session.kitchen.piece(id).is_some_and(|p| !p.in_pan());
    let some_outside = app.its_group().iter().any(outside);
    let next_is_put = matches!(place, Some(Place::Waiting));
    button(app, ui, &capitalised(&format!("{} in", app.session.noun())), next_is_put, some_outside, Act::Put);
    button(app, ui, "Flip", false, in_pan, Act::Flip);
    button(app, ui, "Take out", false, in_pan, Act::Out);
    let on_cloth = app.session.kitchen.cloth().is_some();
    button(app, ui, "Wet cloth", on_cloth, true, Act::Cloth);
    button(app, ui, "Start over", false, true, Act::Restart);
    if let Some(text) = no_power(&app.session.kitchen) {
        ui.label(RichText::new(text).size(13.0).color(theme::ACCENT).strong());
    }
    if let Some(runner) = &app.session.runner {
        let text = format!("{} – next: {}", runner.recipe().title, runner.waiting_for());
        ui.add(egui::Label::new(RichText::new(text).size(13.0).color(theme::QUIET)).truncate());
    }
}

/// Why the hob gives no power although it is on.
fn no_power(kitchen: &Kitchen) -> Option<&'static str> {
    let (pan, on) = (kitchen.pan_state(), kitchen.hob_w() > 0.0);
    match () {
        () if !on || kitchen.drawn_w() > 0.0 => None,
        () if kitchen.cloth().is_some() => Some("No power: the pan is on the cloth"),
        () if pan.limited => Some("No power: the hob's limit holds"),
        () if pan.pose.lift > 0.0 => Some("No power: the pan is lifted"),
        () => Some("No power: the pan is off its ring"),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn time(app: &mut SauteApp, ui: &mut Ui) {
    let pause = if app.session.paused { "Go on" } else { "Pause" };
    ui.label(RichText::new(clock(app.session.kitchen.time_s())).size(20.0).strong());
    button(app, ui, pause, app.session.paused, true, Act::Pause);
    button(app, ui, "Step", false, true, Act::Step);
    SPEEDS.into_iter().for_each(|speed| speed_button(app, ui, speed));
}

fn time_right_to_left(app: &mut SauteApp, ui: &mut Ui) {
    SPEEDS.into_iter().rev().for_each(|speed| speed_button(app, ui, speed));
    button(app, ui, "Step", false, true, Act::Step);
    let pause = if app.session.paused { "Go on" } else { "Pause" };
    button(app, ui, pause, app.session.paused, true, Act::Pause);
    ui.label(RichText::new(clock(app.session.kitchen.time_s())).size(20.0).strong());
}

fn speed_button(app: &mut SauteApp, ui: &mut Ui, speed: f64) {
    if press(
        ui,
        &format!("{speed:.0}×"),
        app.session.speed == speed,
        true,
        "simulated seconds a second ([ slower, ] faster)",
    ) {
        app.set_speed(speed);
    }
}

pub(crate) fn button(app: &mut SauteApp, ui: &mut Ui, text: &str, on: bool, enabled: bool, act: Act) {
    if press(ui, text, on, enabled, &hint(act)) {
        app.act(act, &ui.ctx().clone());
    }
}

/// What a button does, and its key.
fn hint(act: Act) -> String {
    BINDINGS.iter().find(|b| b.act == act).map_or_else(String::new, |b| format!("{} ({})", b.words, b.written))
}

fn press(ui: &mut Ui, text: &str, on: bool, enabled: bool, hint: &str) -> bool {
    let response = ui.add_enabled(enabled, theme::button(text, on));
    response.on_hover_text(hint).clicked()
}
