//! Pause, step and speed by acts.

use crate::app::SauteApp;
use saute_controls::settings::EASED;
use saute_session::SPEEDS;

impl SauteApp {
    pub(super) fn single_step(&mut self) {
        self.session.set_paused(true);
        if let Err(error) = self.session.tick() {
            self.say_trouble(&error);
        }
    }

    pub(super) fn change_speed(&mut self, by: i8) {
        let now = SPEEDS.iter().position(|&s| s == self.session.speed).unwrap_or(0) as i8;
        self.set_speed(SPEEDS[(now + by).clamp(0, SPEEDS.len() as i8 - 1) as usize]);
    }

    /// Lets time run fast, and at real time where a hand is needed.
    pub(crate) fn ease_speed(&mut self) {
        self.set_speed(EASED);
        self.settings.eases = true;
    }

    pub(crate) fn set_speed(&mut self, speed: f64) {
        self.session.set_speed(speed);
        (self.settings.speed, self.settings.held_speed, self.settings.eases) = (speed, None, false);
        self.pace.easing.forget();
        if let Some(live) = &mut self.leads.live {
            live.keeps_speed();
        }
    }
}
