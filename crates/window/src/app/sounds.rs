//! The sound of the cook: what is heard is told to who plays it, once a picture.

use saute_session::hearing::caption::nearer;
use saute_session::hearing::{Ear, plate};
use saute_session::permits::Permit;
use saute_sound::{Event, Snapshot, Told};

use super::SauteApp;
use crate::host::Host;
use crate::listener::Listener;

/// Time in which captions and level follow what is heard [s] (chosen: words that change faster cannot be read).
const READ_S: f64 = 0.7;

/// What is heard, and by whom.
#[derive(Default)]
pub(crate) struct Sounds {
    listener: Option<Box<dyn Listener>>,
    /// Who listens to the kitchen of a number.
    ear: Option<(u64, Ear)>,
    /// What is heard, as captions and level show it, and when that was [s].
    shown: Snapshot,
    shown_at: f64,
}

impl SauteApp {
    /// Lets somebody else play what is heard.
    pub fn let_listen(&mut self, listener: Box<dyn Listener>) {
        self.sounds.listener = Some(listener);
    }

    /// What is heard, for captions and level; none where a study leaves no sound.
    pub(crate) fn heard(&self) -> Option<Snapshot> {
        self.permits().allow(&[Permit::Sound]).then_some(self.sounds.shown)
    }

    /// Tells what is heard now.
    pub(crate) fn sound(&mut self, now: f64) {
        let may_sound = self.permits().allow(&[Permit::Sound]);
        let is_paused = !may_sound || !self.settings.sound || self.session.time_stands() || self.time_waits();
        let (snapshot, events) = self.listen_to_kitchen();
        let share = 1.0 - (-(now - self.sounds.shown_at).max(0.0) / READ_S).exp();
        self.sounds.shown = nearer(&self.sounds.shown, &snapshot, share as f32);
        self.sounds.shown_at = now;
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

    /// Listens to the kitchen that is shown; of another one what happened before is not heard.
    fn listen_to_kitchen(&mut self) -> (Snapshot, Vec<Event>) {
        let (number, kitchen) = (self.session.generation, &self.session.kitchen);
        let ear = self.sounds.ear.take().filter(|(of, _)| *of == number).map(|(_, ear)| ear);
        let mut ear = ear.unwrap_or_else(|| Ear::new(kitchen));
        let heard = ear.hear(kitchen);
        self.sounds.ear = Some((number, ear));
        heard
    }

    /// Says once that there is no sound, and why.
    pub(crate) fn say_no_sound(&self, error: &str) {
        self.desk.notice.say(self.settings.language.fill("notice.no_sound", &[("error", &error)]));
    }
}
