//! Panel of the connected haptic devices: state, lateness, force; and the emergency stop.

use egui::{Align2, Area, Color32, Id, RichText, Ui, vec2};
use saute_haptics::{Health, Rendering};

use super::choice::role_word;
use crate::bindings::{hint, key_of};
use crate::ui::layout::{GAP, Layout};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, HostAct, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::hands::Connected;
use saute_controls::hands::{Hands, Role};
use saute_words::language::Language;

/// Width of the panel, and height of the stop [points] (chosen: hit without looking).
const WIDTH: f32 = 248.0;
const STOP: f32 = 56.0;
/// Height of the way to go on after a stop [points] (chosen: as large as other buttons that are pressed on purpose).
const GO_ON: f32 = 40.0;
/// Ground of the stop: red of a mushroom button, white on which has a contrast of 6.5 [-] (chosen).
const RED: Color32 = Color32::from_rgb(178, 24, 24);
/// Ground of a stop that was pressed: dark red, white on which has a contrast of 14 [-] (chosen).
const PRESSED: Color32 = Color32::from_rgb(84, 16, 16);
/// Width of its edge [points] (chosen: as wide as a button's rim looks when it is down).
const RIM: f32 = 3.0;

/// Shows the panel while a device is connected.
pub(crate) fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if !state.session.hands.any() {
        return;
    }
    // Beside what is at the left; the scene has made room for it.
    let at =
        if layout.narrow { layout.free.left_top() } else { layout.free.left_top() - vec2(WIDTH + 24.0 + GAP, -24.0) };
    let at = at + vec2(if layout.narrow { GAP } else { 0.0 }, GAP);
    Area::new(Id::unique("hands")).fixed_pos(at).pivot(Align2::LEFT_TOP).show(ui.ctx(), |ui| {
        theme::of(ui).panel().show(ui, |ui| {
            ui.set_width(WIDTH);
            ui.spacing_mut().item_spacing.y = 3.0;
            for role in [Role::Pan, Role::Turner] {
                if let Some(device) = state.session.hands.device(role) {
                    lines(device, role, ui, state.settings.language);
                }
            }
            if state.session.speed != 1.0 {
                quiet(ui, state.settings.language.text("hand.faded"));
            }
            buttons(state, ui, acts);
        });
    });
}

/// State of one device.
fn lines(device: &Connected, role: Role, ui: &mut Ui, l: Language) {
    let state = device.state();
    let health = health_word(state.sample.health, l);
    ui.add(egui::Label::new(RichText::new(format!("{}: {health}", role_word(role, l))).strong().size(14.5)).wrap());
    let simulated = if device.is_simulated() { l.text("hand.simulated") } else { "" };
    quiet(ui, &format!("{} {simulated}", device.name));
    if let Some(why) = device.reported() {
        quiet(ui, why);
    }
    let late = state.lateness;
    let whole = |v: f64| format!("{v:.0}");
    let open: [(&str, &dyn std::fmt::Display); 3] =
        [("hz", &whole(state.rate_hz)), ("p50", &whole(late.p50)), ("p99", &whole(late.p99))];
    let measured = l.fill("hand.rate", &open);
    quiet(ui, if state.rate_hz > 0.0 { &measured } else { l.text("hand.measuring") });
    if role == Role::Turner {
        return;
    }
    quiet(ui, rendering_word(device.capabilities.rendering(), l));
    let (force, limit) = (state.sample.total_force_n, device.capabilities.limits.force_n);
    let words = l.fill("hand.force", &[("now", &format!("{force:.1}")), ("limit", &whole(limit))]);
    let share = if limit > 0.0 { (force / limit) as f32 } else { 0.0 };
    ui.add(egui::ProgressBar::new(share).desired_height(18.0).corner_radius(4).text(RichText::new(words).size(13.0)));
    let mj = |j: f64| format!("{:.1}", 1e3 * j);
    quiet(ui, &l.fill("hand.energy", &[("now", &mj(state.account_j)), ("least", &mj(state.passivity_j))]));
}

fn quiet(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).size(13.0).color(theme::of(ui).quiet));
}

fn buttons(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.add_space(4.0);
    stop_button(state.session.hands.is_stopped(), ui, acts, l);
    ui.add_space(3.0);
    let (strung, shown) = (state.session.hands.strung().is_some(), state.session.hands.strings_are_shown());
    ui.horizontal(|ui| {
        let strings = theme::of(ui).button(l.text("hand.strings"), shown);
        if ui.add_enabled(strung, strings).on_hover_text(hint(&Act::View(ViewAct::Strings), l)).clicked() {
            acts.push(Act::View(ViewAct::Strings));
        }
        if ui.add(theme::of(ui).button(l.text("hand.disconnect"), false)).clicked() {
            acts.extend([Role::Pan, Role::Turner].map(|role| Act::App(AppAct::Host(HostAct::Disconnect(role)))));
        }
    });
    if shown {
        super::strings_view::legend(l, ui);
    }
}

/// The stop; once pressed it looks so, and the way to go on appears below it.
fn stop_button(stopped: bool, ui: &mut Ui, acts: &mut Acts, l: Language) {
    let word = l.text(if stopped { "hand.halted" } else { "hand.stop" });
    let text = RichText::new(format!("{word} ({})", key_of(&Act::App(AppAct::StopHands))))
        .size(20.0)
        .strong()
        .color(Color32::WHITE);
    let mut stop = egui::Button::new(text).fill(if stopped { PRESSED } else { RED }).selected(stopped);
    if stopped {
        stop = stop.stroke(egui::Stroke::new(RIM, RED));
    }
    // A second press does no harm: what is stopped stays stopped.
    if ui.add_sized([WIDTH, STOP], stop).on_hover_text(hint(&Act::App(AppAct::StopHands), l)).clicked() {
        acts.push(Act::App(AppAct::StopHands));
    }
    if stopped {
        let go_on = egui::Button::new(RichText::new(l.text("hand.go_on")).size(18.0).strong());
        if ui.add_sized([WIDTH, GO_ON], go_on).on_hover_text(l.text("hand.go_on_hint")).clicked() {
            acts.push(Act::App(AppAct::Host(HostAct::ResumeHands)));
        }
    }
}

/// Shifts the scene's free part to the side of the panel, where there is room.
pub(crate) fn make_room(mut layout: Layout, hands: &Hands) -> Layout {
    if hands.any() && !layout.narrow {
        layout.free.min.x += WIDTH + 24.0 + 2.0 * GAP;
    }
    layout
}

fn health_word(health: Health, l: Language) -> &'static str {
    l.text(match health {
        Health::Connecting => "hand.connecting",
        Health::Uncalibrated => "hand.uncalibrated",
        Health::Misfit => "hand.misfit",
        Health::Running => "hand.running",
        Health::Lost => "hand.lost",
        Health::WrongCode => "hand.wrong_code",
        Health::WrongUnits => "hand.wrong_units",
        Health::Fault => "hand.fault",
        Health::Busy => "hand.busy",
        Health::DeviceOutdated => "hand.device_outdated",
        Health::ProgramOutdated => "hand.program_outdated",
        Health::WatchdogUnlawful => "hand.watchdog_unlawful",
        Health::LeastTensionTooHigh => "hand.least_too_high",
        Health::LargestTensionTooLow => "hand.largest_too_low",
        Health::RateTooLow => "hand.rate_too_low",
        Health::Stopped => "hand.stopped",
        Health::ImpossibleLengths => "hand.impossible_lengths",
        Health::ForceAboveLimit => "hand.force_above_limit",
        Health::EnergyOverdrawn => "hand.energy_overdrawn",
    })
}

fn rendering_word(rendering: Rendering, l: Language) -> &'static str {
    l.text(match rendering {
        Rendering::Wrench => "hand.wrench",
        Rendering::Force => "hand.force_alone",
        Rendering::Rumble => "hand.rumble",
        Rendering::SoundAndPicture => "hand.sound_and_picture",
    })
}
