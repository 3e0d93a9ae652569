//! Hob, cloth, hands and time.

use egui::{RichText, Ui};
use saute_kitchen::{Kitchen, Place, celsius};

use crate::act::{Act, hint};
use crate::app::SauteApp;
use crate::panels::inside::clock;
use crate::panels::pour;
use crate::session::SPEEDS;
use crate::ui::theme;

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
    let l = app.settings.language;
    let shown = |kelvin: f64| app.settings.temperature(celsius(kelvin));
    let (core, pan) = (shown(piece.core()), shown(app.session.kitchen.pan_temperature()));
    ui.label(RichText::new(l.fill("hob.core_and_pan", &[("core", &core), ("pan", &pan)])).size(18.0).strong());
    if let Some(scale) = app.scale() {
        let class = l.called("class", scale.name_of(piece.core_peak.0));
        let class = l.fill("hob.class_so_far", &[("class", &class), ("scale", &l.called("scale", &scale.name))]);
        ui.label(RichText::new(class).size(13.0).color(theme::of(ui).quiet));
    }
}

fn hob(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    ui.label(RichText::new(l.text("hob.hob")).color(theme::of(ui).quiet));
    let settings = app.session.kitchen.hob().coil.settings_w.clone();
    let now = app.session.kitchen.hob_w();
    for w in settings {
        let text = if w == 0.0 { l.text("hob.off").to_owned() } else { format!("{w:.0} W") };
        let on = (w - now).abs() < 0.5;
        if press(ui, &text, on, true, l.text("hob.power")) {
            app.act(Act::HobSet(w), &ui.ctx().clone());
        }
    }
    let custom = !app.session.kitchen.hob().coil.settings_w.iter().any(|w| (w - now).abs() < 0.5);
    if custom {
        ui.label(RichText::new(format!("{now:.0} W")).color(theme::of(ui).accent));
    }
}

fn hands(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    let place = app.session.steak().map(|p| p.place);
    let in_pan = matches!(place, Some(Place::Pan(_)));
    let outside = |id: &String| app.session.kitchen.piece(id).is_some_and(|p| !p.in_pan());
    let some_outside = app.its_group().iter().any(outside);
    let next_is_put = matches!(place, Some(Place::Waiting));
    let food_in = l.fill("hob.food_in", &[("food", &capitalised(l.called("noun", &app.session.noun())))]);
    button(app, ui, &food_in, next_is_put, some_outside, Act::Put);
    button(app, ui, l.text("hob.flip"), false, in_pan, Act::Flip);
    if matches!(place, Some(Place::Rest(_))) {
        // What lies on the board cannot be taken out, but cut.
        let whole = app.session.steak().is_some_and(|p| p.halved().is_none());
        button(app, ui, l.text("hob.halve"), false, whole, Act::Halve);
    } else {
        button(app, ui, l.text("hob.take_out"), false, in_pan, Act::Out);
    }
    let on_cloth = app.session.kitchen.cloth().is_some();
    button(app, ui, l.text("hob.cloth"), on_cloth, true, Act::Cloth);
    button(app, ui, l.text("hob.restart"), false, true, Act::Restart);
    if let Some(text) = no_power(&app.session.kitchen) {
        ui.label(RichText::new(l.text(text)).size(13.0).color(theme::of(ui).accent).strong());
    }
    if let Some(runner) = &app.session.runner {
        let text = l.fill(
            "hob.next_step",
            &[
                ("title", &l.called("recipe", &runner.recipe().title)),
                ("step", &crate::words::next_step::words(runner, &app.settings)),
            ],
        );
        ui.add(egui::Label::new(RichText::new(text).size(13.0).color(theme::of(ui).quiet)).truncate());
    }
}

/// Key of why the hob gives no power although it is on.
fn no_power(kitchen: &Kitchen) -> Option<&'static str> {
    let (pan, on) = (kitchen.pan_state(), kitchen.hob_w() > 0.0);
    match () {
        () if !on || kitchen.drawn_w() > 0.0 => None,
        () if kitchen.cloth().is_some() => Some("hob.no_power_cloth"),
        () if pan.limited => Some("hob.no_power_limit"),
        () if pan.pose.lift > 0.0 => Some("hob.no_power_lifted"),
        () => Some("hob.no_power_off_ring"),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn time(app: &mut SauteApp, ui: &mut Ui) {
    let pause = pause_word(app);
    ui.label(RichText::new(clock(app.session.kitchen.time_s())).size(20.0).strong());
    button(app, ui, pause, app.session.paused, true, Act::Pause);
    button(app, ui, app.settings.language.text("hob.step"), false, true, Act::Step);
    SPEEDS.into_iter().for_each(|speed| speed_button(app, ui, speed));
}

fn time_right_to_left(app: &mut SauteApp, ui: &mut Ui) {
    SPEEDS.into_iter().rev().for_each(|speed| speed_button(app, ui, speed));
    button(app, ui, app.settings.language.text("hob.step"), false, true, Act::Step);
    let pause = pause_word(app);
    button(app, ui, pause, app.session.paused, true, Act::Pause);
    ui.label(RichText::new(clock(app.session.kitchen.time_s())).size(20.0).strong());
}

fn pause_word(app: &SauteApp) -> &'static str {
    app.settings.language.text(if app.session.paused { "hob.go_on" } else { "hob.pause" })
}

fn speed_button(app: &mut SauteApp, ui: &mut Ui, speed: f64) {
    if press(ui, &format!("{speed:.0}×"), app.session.speed == speed, true, app.settings.language.text("hob.speed")) {
        app.set_speed(speed);
    }
}

pub(crate) fn button(app: &mut SauteApp, ui: &mut Ui, text: &str, on: bool, enabled: bool, act: Act) {
    if press(ui, text, on, enabled, &hint(act, app.settings.language)) {
        app.act(act, &ui.ctx().clone());
    }
}

fn press(ui: &mut Ui, text: &str, on: bool, enabled: bool, hint: &str) -> bool {
    let response = ui.add_enabled(enabled, theme::of(ui).button(text, on));
    response.on_hover_text(hint).clicked()
}
