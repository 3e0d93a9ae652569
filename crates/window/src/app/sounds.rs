//! The sound of the cook: what is heard is sent to the listener that plays it, once a picture.

use egui::Context;
use saute_session::hearing::example::Example;
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
    /// What a cue means, while it is played, and since when [s].
    example: Option<(Example, f64)>,
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

    /// Plays what a cue means, in place of the cook.
    pub(crate) fn play_example(&mut self, example: Example, ctx: &Context) {
        self.sounds.example = Some((example, ctx.input(|i| i.time)));
        ctx.request_repaint();
    }

    /// What is played of an example now, if there is one.
    fn example_now(&mut self, ctx: &Context) -> Option<Snapshot> {
        let (example, begun) = self.sounds.example?;
        let snapshot = example.at(ctx.input(|i| i.time) - begun);
        match snapshot {
            Some(_) => ctx.request_repaint(),
            None => self.sounds.example = None,
        }
        snapshot
    }

    /// Sends what is heard now to the listener.
    pub(crate) fn sound(&mut self, ctx: &Context) {
        let may_sound = self.permits().allow(&[Permit::Sound]);
        let example = self.example_now(ctx);
        let is_still = example.is_none() && (self.session.time_stands() || self.time_waits());
        let is_paused = !may_sound || !self.settings.sound || is_still;
        let now = ctx.input(|i| i.time);
        let (heard, events) = self.sounds.hearing.hear(&self.session.kitchen, self.session.generation, now);
        // Of the cook nothing is heard meanwhile.
        let (snapshot, events) = example.map_or((heard, events), |example| (example, Vec::new()));
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
