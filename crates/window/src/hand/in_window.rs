//! Hands at devices in the window: connecting, the emergency stop, and what there is to say about it.

use egui::{Context, Key, Modifiers};

use super::hands::{HandsStart, Role};
use crate::app::SauteApp;

/// How often the panel is drawn anew while time stands still [s] (chosen: numbers that can be read).
const ANEW_S: f64 = 0.1;

impl SauteApp {
    /// Connects the devices with which the window starts.
    pub(crate) fn begin_hands(&mut self, start: HandsStart) {
        self.session.hands.file = start.calibration;
        for (role, text) in [(Role::Pan, start.pan), (Role::Turner, start.turner)] {
            if let Some(text) = text {
                self.connect_hand(role, &text, start.pairing);
            }
        }
    }

    /// Connects a device; time then runs as fast as the clock, for forces know no other pace.
    pub(crate) fn connect_hand(&mut self, role: Role, text: &str, pairing: u32) {
        match self.session.hands.connect(role, text, pairing) {
            Ok(()) => self.set_speed(1.0),
            Err(error) => self.say_trouble(&error),
        }
    }

    /// The emergency stop: all devices let go at once and stay so.
    pub(crate) fn stop_hands(&mut self) {
        if self.session.hands.any() {
            self.session.hands.stop();
            self.say("notice.hands_stopped");
        }
    }

    /// Enter in a window stops the devices.
    pub(crate) fn take_stop(&mut self, ctx: &Context) {
        if self.session.hands.any() && ctx.input_mut(enter) {
            self.stop_hands();
        }
    }

    /// Asks the devices how they are, before anything else is done in a frame. While one is connected, Enter stops it, whatever
    /// has the focus.
    pub(crate) fn take_devices(&mut self, ctx: &Context) {
        let shaken = ctx.input(|i| f64::from(i.stable_dt));
        if self.pad.is_plugged() {
            let rumble = self.session.hands.rumble(shaken);
            self.pad.shake(&rumble);
        }
        if !self.session.hands.any() {
            return;
        }
        self.take_stop(ctx);
        for kept in self.session.hands.update() {
            match kept {
                Ok(file) => {
                    self.notice.say(self.settings.language.fill("notice.calibrated", &[("file", &file.display())]))
                }
                Err(error) => self.say_trouble(&error),
            }
        }
        ctx.request_repaint_after(std::time::Duration::from_secs_f64(ANEW_S));
    }
}

/// Whether Enter was pressed, with whatever else; nothing else hears of it.
fn enter(input: &mut egui::InputState) -> bool {
    let held = input.modifiers;
    [Modifiers::NONE, held].into_iter().any(|with| input.consume_key(with, Key::Enter))
}
