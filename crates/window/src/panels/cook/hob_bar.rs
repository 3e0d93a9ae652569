//! Hob, cloth, hands and time.

use egui::{RichText, Ui};
use saute_kitchen::doneness::core_class;
use saute_kitchen::{EventKind, Holding, Piece, Place, celsius};

use crate::panels::cook::act_button::{button, pressed, why_off};
use crate::panels::cook::cook_state::CookState;
use crate::panels::cook::{hob_slider, pour, status, time_strip};
use crate::panels::learn::coach;
use crate::ui::bell::{self, Bell};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, CookAct, TimeAct};
use saute_controls::context::PanelContext;
use saute_controls::settings::EASED;
use saute_session::SPEEDS;
use saute_words::clock::clock;
use saute_words::doneness_words;

/// Height of a control for a mouse, and space at the sides of its text [points].
const DESK: f32 = 36.0;
const DESK_PADDING: f32 = 8.0;

/// Size of the bell of a pan that is as hot as it is held [points], and how long it rings [simulated s] (chosen).
const BELL: f32 = 20.0;
const RINGS_S: f64 = 10.0;

/// Size of the strip of time [points].
const STRIP: egui::Vec2 = egui::vec2(470.0, 18.0);

/// Shows the controls: in two rows over a line of words, or wrapped where it is narrow.
pub fn show(state: &CookState, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    if narrow {
        ui.spacing_mut().interact_size.y = theme::TOUCH;
        (ui.spacing_mut().item_spacing, ui.spacing_mut().button_padding.x) = (egui::vec2(6.0, 6.0), 9.0);
        coach::show(state, state.coaching, ui, acts, true);
        ui.horizontal_wrapped(|ui| hands(state, ui, acts));
        ui.horizontal_wrapped(|ui| {
            hob_slider::show(state, ui, acts);
            hold(state, ui, acts);
        });
        ui.horizontal_wrapped(|ui| time(state, ui, acts));
        ui.horizontal_wrapped(|ui| {
            pour::show(state, ui, acts);
            cloth(state, ui, acts);
            step(state, ui, acts);
            restart(state, ui, acts);
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
        // So that the longest words have room too: other amounts, tongs or turner.
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (5.0, 6.0);
        hands(state, ui, acts);
        restart(state, ui, acts);
        pour::show(state, ui, acts);
        time_strip::undo_and_redo(state, ui, acts);
    });
    ui.spacing_mut().interact_size.y = STRIP.y;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 14.0;
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            time_strip::show(state, ui, acts, STRIP);
            time_strip::branches(state, state.side_by_side, ui, acts);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| status::show(state, ui, acts));
        });
    });
}

/// Core and pan at a glance, where the panel with all readings is not open.
fn temperatures(state: &PanelContext, ui: &mut Ui) {
    let Some(piece) = state.session.shown_piece().filter(|_| state.reads_out()) else { return };
    let l = state.settings.language;
    let shown = |kelvin: f64| state.settings.temperature(celsius(kelvin));
    let (core, pan) = (shown(piece.core()), shown(state.session.kitchen.pan_temperature()));
    ui.label(RichText::new(l.fill("hob.core_and_pan", &[("core", &core), ("pan", &pan)])).size(18.0).strong());
    if let Some(scale) = state.scale() {
        let class = doneness_words::class(&scale, core_class(piece, &scale), l);
        let class = l.fill("hob.class_so_far", &[("class", &class), ("scale", &doneness_words::label(&scale, l))]);
        ui.label(RichText::new(class).size(13.0).color(theme::of(ui).quiet));
    }
}

fn hob(state: &CookState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.label(RichText::new(l.text("hob.hob")).color(theme::of(ui).quiet));
    hob_slider::show(state, ui, acts);
    hold(state, ui, acts);
    cloth(state, ui, acts);
}

/// Sets the pan onto the wet cloth, and back.
fn cloth(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let on_cloth = state.session.kitchen.cloth().is_some();
    button(state, ui, acts, state.settings.language.text("hob.cloth"), on_cloth, true, Act::Cook(CookAct::Cloth));
}

/// The temperatures at which the hob can hold the pan, in a list.
fn hold(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let (l, kitchen) = (state.settings.language, &state.session.kitchen);
    let Some(sensor) = kitchen.hob().hold() else { return };
    let held = kitchen.hob_holds().map(celsius);
    let words = |c: f64| l.fill("hob.hold_at", &[("temperature", &state.settings.temperature(c))]);
    let text = held.map_or_else(|| l.text("hob.hold").to_owned(), words);
    let hint = l.text("hob.hold_hint");
    let list = egui::ComboBox::from_id_salt("hold").selected_text(RichText::new(text));
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
        let moves = !crate::ui::display::moves_less(state.settings) && !state.session.paused;
        bell::show(ui, &Bell { size: BELL, spoken: l.text("hob.hold_reached"), rings: since < RINGS_S, moves });
    }
}

fn hands(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let piece = state.session.shown_piece();
    let in_pan = piece.is_some_and(|piece| matches!(piece.place, Place::Pan(_)));
    let is_whole = |piece: &Piece| matches!(piece.place, Place::Rest(_)) && piece.halved().is_none();
    put_button(state, ui, acts);
    button(state, ui, acts, l.text("hob.flip"), false, in_pan, Act::Cook(CookAct::Flip));
    button(state, ui, acts, l.text("hob.take_out"), false, in_pan, Act::Cook(CookAct::Out));
    button(state, ui, acts, l.text("hob.halve"), false, piece.is_some_and(is_whole), Act::Cook(CookAct::Halve));
}

fn restart(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    button(state, ui, acts, state.settings.language.text("hob.restart"), false, true, Act::Cook(CookAct::Restart));
}

/// The button that puts the food in.
pub(crate) fn put_button(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    // What the turner holds in a flip is not out.
    let is_out = |p: &Piece| !p.in_pan() && p.place != Place::Held;
    let outside = |id: &String| state.session.kitchen.piece(id).is_some_and(is_out);
    let some_outside = state.session.its_group().iter().any(outside);
    let words = state.settings.language.text("hob.food_in");
    button(state, ui, acts, words, false, some_outside, Act::Cook(CookAct::Put));
}

/// The clock, pause and speeds, in a row that fingers use.
pub(crate) fn time(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    ui.label(RichText::new(clock(state.session.shown_s())).size(18.0).strong());
    pause(state, ui, acts);
    (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (4.0, 5.0);
    // As many as a phone has room for; all are reached by their keys.
    speeds(state, ui, acts, |speed| speed != 3.0);
}

/// The same from the right, with the single step, which a first cook does not have.
pub(crate) fn time_right_to_left(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let usual = (ui.spacing().item_spacing.x, ui.spacing().button_padding.x);
    (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (3.0, 6.0);
    speeds(state, ui, acts, |_| true);
    (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = usual;
    if !state.settings.few {
        step(state, ui, acts);
    }
    pause(state, ui, acts);
    ui.label(RichText::new(clock(state.session.shown_s())).size(20.0).strong());
}

fn pause(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    button(state, ui, acts, pause_word(state), state.session.paused, true, Act::Time(TimeAct::Pause));
}

fn step(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    button(state, ui, acts, state.settings.language.text("hob.step"), false, true, Act::Time(TimeAct::Step));
}

/// The speed that eases, and the fixed ones that have room, in the direction of the row; a first cook has none beyond the one that eases.
fn speeds(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, has_room: impl Fn(f64) -> bool) {
    let most = if state.settings.few { EASED } else { f64::INFINITY };
    let fixed = SPEEDS.into_iter().filter(|speed| has_room(*speed) && *speed <= most).map(Some);
    let mut all: Vec<Option<f64>> = [None].into_iter().chain(fixed).collect();
    if ui.layout().prefer_right_to_left() {
        all.reverse();
    }
    all.into_iter().for_each(|speed| speed_button(state, ui, acts, speed));
}

fn pause_word(state: &PanelContext) -> &'static str {
    state.settings.language.text(if state.session.paused { "hob.go_on" } else { "hob.pause" })
}

/// A button of a speed; none is the speed that eases.
fn speed_button(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, speed: Option<f64>) {
    let (l, settings, now) = (state.settings.language, state.settings, state.session.speed);
    let (words, is_on, hint, act) = match speed {
        None if settings.eases => {
            (l.fill("hob.eased_now", &[("speed", &format!("{now:.0}"))]), true, "hob.eased", TimeAct::SpeedEased)
        }
        None => (l.text("hob.eased_off").to_owned(), false, "hob.eased", TimeAct::SpeedEased),
        Some(speed) => {
            let is_on = !settings.eases && now == speed;
            (format!("{speed:.0}×"), is_on, "hob.speed", TimeAct::SpeedSet(speed))
        }
    };
    let act = Act::Time(act);
    if state.hides(&act) {
        return;
    }
    let response = pressed(ui, &words, is_on, !state.forbids(&act), l.text(hint));
    // What was chosen and cannot be sustained stays marked.
    if speed.is_some_and(|speed| !settings.eases && speed == settings.speed && speed != now) {
        let edge = egui::Stroke::new(1.5, theme::of(ui).quiet);
        ui.painter().rect_stroke(response.rect, theme::CONTROL_CORNER, edge, egui::StrokeKind::Inside);
    }
    if why_off(state, response, &act).clicked() {
        acts.push(act);
    }
}
