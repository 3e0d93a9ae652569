//! Hob, cloth, hands and time.

use egui::{RichText, Ui};
use saute_kitchen::advice::Advice;
use saute_kitchen::doneness::core_class;
use saute_kitchen::{EventKind, Holding, Place, celsius};

use crate::act::{Act, Acts, CookAct, TimeAct};
use crate::panels::cook::act_button::{button, pressed, why_off};
use crate::panels::cook::{hob_slider, pour, status, time_strip};
use crate::panels::learn::coach;
use crate::panels::window_state::WindowState;
use crate::ui::bell::{self, Bell};
use crate::ui::theme;
use saute_session::SPEEDS;
use saute_words::clock::clock;

/// Height of a control for a mouse, and space at the sides of its text [points].
const DESK: f32 = 36.0;
const DESK_PADDING: f32 = 8.0;

/// Size of the bell of a pan that is as hot as it is held [points], and how long it rings [simulated s] (chosen).
const BELL: f32 = 20.0;
const RINGS_S: f64 = 10.0;

/// Size of the strip of time [points].
const STRIP: egui::Vec2 = egui::vec2(470.0, 18.0);

/// Shows the controls: in two rows over a line of words, or wrapped where it is narrow.
pub fn show(state: &WindowState, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    if narrow {
        ui.spacing_mut().interact_size.y = theme::TOUCH;
        (ui.spacing_mut().item_spacing, ui.spacing_mut().button_padding.x) = (egui::vec2(6.0, 6.0), 9.0);
        coach::show(state, ui, true);
        ui.horizontal_wrapped(|ui| hands(state, ui, acts));
        ui.horizontal_wrapped(|ui| {
            hob_slider::show(state, ui, acts);
            hold(state, ui, acts);
        });
        ui.horizontal_wrapped(|ui| time(state, ui, acts));
        ui.horizontal_wrapped(|ui| {
            pour::show(state, ui, acts);
            cloth(state, ui, acts);
        });
        if state.turner_in_hand {
            ui.horizontal_wrapped(|ui| pour::turner(state, ui, acts));
        }
        ui.horizontal_wrapped(|ui| status::show(state, ui, acts));
        ui.separator();
        temperatures(state, ui);
        return;
    }
    ui.spacing_mut().interact_size.y = DESK;
    ui.spacing_mut().item_spacing = egui::vec2(5.0, 4.0);
    ui.spacing_mut().button_padding.x = DESK_PADDING;
    ui.horizontal(|ui| {
        hob(state, ui, acts);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| time_right_to_left(state, ui, acts));
    });
    ui.horizontal(|ui| {
        hands(state, ui, acts);
        pour::show(state, ui, acts);
        time_strip::undo_and_redo(state, ui, acts);
    });
    ui.spacing_mut().interact_size.y = STRIP.y;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 14.0;
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            time_strip::show(state, ui, acts, STRIP);
            time_strip::branches(state, ui, acts);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| status::show(state, ui, acts));
        });
    });
}

/// Core and pan at a glance, where the panel with all readings is not open.
fn temperatures(state: &WindowState, ui: &mut Ui) {
    let Some(piece) = state.session.steak().filter(|_| state.reads_out()) else { return };
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
    hob_slider::show(state, ui, acts);
    hold(state, ui, acts);
    cloth(state, ui, acts);
}

/// Sets the pan onto the wet cloth, and back.
fn cloth(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let on_cloth = state.session.kitchen.cloth().is_some();
    button(state, ui, acts, state.settings.language.text("hob.cloth"), on_cloth, true, Act::Cook(CookAct::Cloth));
}

/// The temperatures at which the hob can hold the pan, in a list.
fn hold(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let (l, kitchen) = (state.settings.language, &state.session.kitchen);
    let Some(sensor) = kitchen.hob().hold() else { return };
    let held = kitchen.hob_holds().map(celsius);
    let words = |c: f64| l.fill("hob.hold_at", &[("temperature", &state.settings.temperature(c))]);
    let text = held.map_or_else(|| l.text("hob.hold").to_owned(), words);
    let hint = l.text("hob.hold_hint");
    let colour = if held.is_some() { theme::of(ui).accent } else { theme::of(ui).text };
    let list = egui::ComboBox::from_id_salt("hold").selected_text(RichText::new(text).color(colour));
    let shown = list.show_ui(ui, |ui| {
        for c in &sensor.settings_c {
            let on = held.is_some_and(|held| (held - c).abs() < 0.5);
            if ui.selectable_label(on, state.settings.temperature(*c)).clicked() {
                acts.push(Act::Cook(CookAct::HobHold(*c)));
            }
        }
    });
    shown.response.on_hover_text(hint);
    if kitchen.holding() == Some(Holding::Reached) {
        let since = kitchen.time_s() - kitchen.events().tally(EventKind::DialReached).last_s;
        let moves = !state.settings.moves_less() && !state.session.paused;
        bell::show(ui, &Bell { size: BELL, spoken: l.text("hob.hold_reached"), rings: since < RINGS_S, moves });
    }
}

fn hands(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let place = state.session.steak().map(|p| p.place);
    let in_pan = matches!(place, Some(Place::Pan(_)));
    let outside = |id: &String| state.session.kitchen.piece(id).is_some_and(|p| !p.in_pan());
    let some_outside = state.session.its_group().iter().any(outside);
    // Not before the pan is hot: a button that is lit asks to be pressed.
    let next_is_put = state.advice.iter().any(|advice| matches!(advice, Advice::PutIn { .. }));
    button(state, ui, acts, &food_in(state), next_is_put, some_outside, Act::Cook(CookAct::Put));
    button(state, ui, acts, l.text("hob.flip"), false, in_pan, Act::Cook(CookAct::Flip));
    if matches!(place, Some(Place::Rest(_))) {
        // What lies on the board cannot be taken out, but cut.
        let whole = state.session.steak().is_some_and(|p| p.halved().is_none());
        button(state, ui, acts, l.text("hob.halve"), false, whole, Act::Cook(CookAct::Halve));
    } else {
        button(state, ui, acts, l.text("hob.take_out"), false, in_pan, Act::Cook(CookAct::Out));
    }
    button(state, ui, acts, l.text("hob.restart"), false, true, Act::Cook(CookAct::Restart));
}

/// What the button says that puts the food in.
pub(crate) fn food_in(state: &WindowState) -> String {
    let l = state.settings.language;
    l.fill("hob.food_in", &[("food", &capitalised(l.called("noun", &state.session.noun())))])
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn time(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let pause = pause_word(state);
    ui.label(RichText::new(clock(state.session.shown_s())).size(20.0).strong());
    button(state, ui, acts, pause, state.session.paused, true, Act::Time(TimeAct::Pause));
    button(state, ui, acts, state.settings.language.text("hob.step"), false, true, Act::Time(TimeAct::Step));
    SPEEDS.into_iter().for_each(|speed| speed_button(state, ui, acts, speed));
}

fn time_right_to_left(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    SPEEDS.into_iter().rev().for_each(|speed| speed_button(state, ui, acts, speed));
    button(state, ui, acts, state.settings.language.text("hob.step"), false, true, Act::Time(TimeAct::Step));
    let pause = pause_word(state);
    button(state, ui, acts, pause, state.session.paused, true, Act::Time(TimeAct::Pause));
    ui.label(RichText::new(clock(state.session.shown_s())).size(20.0).strong());
}

fn pause_word(state: &WindowState) -> &'static str {
    state.settings.language.text(if state.session.paused { "hob.go_on" } else { "hob.pause" })
}

fn speed_button(state: &WindowState, ui: &mut Ui, acts: &mut Acts, speed: f64) {
    let (hint, act) = (state.settings.language.text("hob.speed"), Act::Time(TimeAct::SpeedSet(speed)));
    let enabled = !state.forbids(&act);
    let response = pressed(ui, &format!("{speed:.0}×"), state.session.speed == speed, enabled, hint);
    if why_off(state, response, &act).clicked() {
        acts.push(act);
    }
}
