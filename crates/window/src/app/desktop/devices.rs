//! Haptic devices in the window: connecting, going on after a stop, and notices about them.

use crate::app::SauteApp;
use egui::{Context, Key, Modifiers};
use saute_controls::hands::{HandsStart, Role};

/// Interval at which the panel is redrawn while time is stopped [s] (chosen: numbers that can be read).
const ANEW_S: f64 = 0.1;

impl SauteApp {
    /// Connects the devices with which the window starts.
    pub(super) fn begin_hands(&mut self, start: HandsStart) {
        self.session.hands.file = start.calibration;
        for (role, text) in [(Role::Pan, start.pan), (Role::Turner, start.turner)] {
            if let Some(text) = text {
                self.connect_hand(role, &text, start.pairing);
            }
        }
    }

    /// Connects a device; time then runs at the pace of the clock, the only pace at which forces are rendered.
    pub(super) fn connect_hand(&mut self, role: Role, text: &str, pairing: u32) {
        match self.session.hands.connect(role, text, pairing) {
            Ok(()) => self.set_speed(1.0),
            Err(error) => self.say_trouble(&error),
        }
    }

    /// After a stop or a safety fault: all devices may make forces again.
    pub(super) fn resume_hands(&mut self) {
        self.session.hands.resume();
        self.say("notice.hands_resumed");
    }

    /// Reads the state of the devices.
    pub(super) fn read_devices(&mut self, ctx: &Context) {
        for kept in self.session.hands.update() {
            match kept {
                Ok(file) => {
                    self.desk.notice.say(self.settings.language.fill("notice.calibrated", &[("file", &file.display())]))
                }
                Err(error) => self.say_trouble(&error),
            }
        }
        ctx.request_repaint_after(std::time::Duration::from_secs_f64(ANEW_S));
    }
}

/// Returns true if Enter was pressed, with any modifiers; the key is consumed.
pub(super) fn enter(input: &mut egui::InputState) -> bool {
    let held = input.modifiers;
    [Modifiers::NONE, held].into_iter().any(|with| input.consume_key(with, Key::Enter))
}
