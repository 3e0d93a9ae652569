//! A recorded cook that the helper plays up to its end: the window shows how far it has come.

use std::sync::Arc;

use saute_recipe::Recording;

use super::{Instant, Purpose, Stop, Traced};
use crate::Session;
use crate::hands::Hands;

impl<H: Hands> Session<H> {
    /// The instant that is shown, as bytes.
    pub(super) fn instant(&self) -> Instant {
        let (runner, plays) = self.runner_here();
        Instant { moment: self.recording.moment(), kitchen: self.kitchen.to_bytes(), runner: runner.state(), plays }
    }

    /// What the cook left behind up to the instant that is shown.
    pub(super) fn traced(&self) -> Traced {
        Traced {
            recording: self.recording.to_file(),
            recorder: self.recorder.clone(),
            marks: self.marks.clone(),
            start_mass_g: self.start_mass_g.clone(),
        }
    }

    /// Lets the helper play what is ahead up to its end; returns false if there is none.
    pub(crate) fn catch_up_elsewhere(&mut self) -> bool {
        let longest = self.longest();
        let (to, file) = (longest.moment(), || (longest.to_file(), None));
        let purpose = Purpose::Shown(to);
        // The order is made only where it is a new one.
        let order = (self.playback.has_helper() && !self.playback.is_open(purpose)).then(file);
        if let Some(order) = order {
            self.playback.ask(purpose, to, || order);
        }
        for stop in self.playback.stops(purpose) {
            self.show_stop(stop);
        }
        self.playback.has_helper()
    }

    fn show_stop(&mut self, stop: Stop) {
        let Some(Traced { recording, recorder, marks, start_mass_g }) = stop.traced else { return };
        let Ok(opened) = Recording::from_file(&recording) else { return };
        let (recipe, library) = (Arc::clone(&self.recipe), Arc::clone(&self.library));
        let Some(replay) = stop.at.replay(&recipe, &library, self.timeline.models()) else { return };
        self.recording = opened.recording;
        (self.recorder, self.marks, self.start_mass_g) = (recorder, marks, start_mass_g);
        self.timeline.catches_up = false;
        self.take_kitchen(replay);
        self.rejoin();
        self.set_paused(true);
        self.timeline.catches_up = self.lies_ahead();
    }
}
