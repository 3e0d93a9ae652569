//! The sound of the cook: what is heard is sent to the listener that plays it, once a picture.

use saute_session::hearing::plate;
use saute_session::hearing::shown::Hearing;
use saute_session::permits::Permit;
use saute_sound::{Snapshot, Told};

use super::SauteApp;
use crate::host::Host;
use crate::listener::Listener;

/// What is heard, and by whom.
#[derive(Default)]
pub(crate) struct Sounds {
    listener: Option<Box<dyn Listener>>,
    /// What is heard of the kitchen.
    hearing: Hearing,
}

impl SauteApp {
    /// Lets another listener play what is heard.
    pub fn let_listen(&mut self, listener: Box<dyn Listener>) {
        self.sounds.listener = Some(listener);
    }

    /// What is heard, for captions and level; none where a study leaves no sound.
    pub(crate) fn heard(&self) -> Option<Snapshot> {
        self.permits().allow(&[Permit::Sound]).then_some(self.sounds.hearing.shown())
    }

    /// Sends what is heard now to the listener.
    pub(crate) fn sound(&mut self, now: f64) {
        let may_sound = self.permits().allow(&[Permit::Sound]);
        let is_paused = !may_sound || !self.settings.sound || self.session.time_stands() || self.time_waits();
        let (snapshot, events) = self.sounds.hearing.hear(&self.session.kitchen, self.session.generation, now);
        if !is_paused && let Some(speaker) = self.host.speaker() {
            match speaker {
                Ok(listener) => self.let_listen(listener),
                Err(trouble) => self.say_no_sound(&trouble),
            }
        }
        let pan = plate(&self.session.kitchen);
        let told = Told { snapshot, pan, is_paused, volume: self.settings.volume as f32 };
        let Some(listener) = self.sounds.listener.as_mut() else { return };
        listener.hear(&told, &events);
        if let Some(trouble) = listener.trouble() {
            self.say_no_sound(&trouble);
        }
    }

    /// Reports once that there is no sound, and why.
    pub(crate) fn say_no_sound(&self, error: &str) {
        self.desk.notice.say(self.settings.language.fill("notice.no_sound", &[("error", &error)]));
    }
}
