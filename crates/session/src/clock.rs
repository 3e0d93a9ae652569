//! The clock of a session: wall time to simulated time, frames, ticks and recipe steps.

use saute_kitchen::{FRAME_S, TICK_S};
use saute_recipe::Fired;
use saute_recipe::session::Done;
use web_time::{Duration, Instant};

use super::Session;
use super::mark::Mark;
use super::permits::Permit;
use super::speeds::MOST_OWED_S;
use crate::hands::Hands;

/// Simulated time owed beyond which the machine counts as too slow, as wall time at the chosen speed [s] (chosen).
const LATE_AFTER_S: f64 = 0.4;

/// Time closer than this to a whole step counts as reached [s] (chosen: far above rounding, far below a frame).
const SAME_TIME: f64 = 1e-9;

impl<H: Hands> Session<H> {
    /// Advances by the wall time `wall` at the chosen speed, and computes for no longer than `budget`. The remainder stays
    /// owed, up to a second of wall time: what is beyond it is not cooked, so that nothing burns unseen.
    ///
    /// # Errors
    ///
    /// Returns the error of a recipe's step; the recipe then stops playing.
    pub fn advance(&mut self, wall: Duration, budget: Duration) -> Result<(), String> {
        if self.is_travelling() {
            self.travel_on(budget);
            return Ok(());
        }
        if self.paused || self.timeline.is_held {
            self.pack_keyframes();
            return Ok(());
        }
        self.owed_s += wall.as_secs_f64() * self.speed;
        let start = Instant::now();
        // At real time every frame is shown; at higher speeds only ticks are.
        let step = if self.speed > 1.0 { TICK_S } else { FRAME_S };
        while self.owed_s >= step - SAME_TIME && start.elapsed() < budget {
            let before = self.kitchen.time_s();
            if self.speed > 1.0 {
                self.tick()?
            } else {
                self.frame().map(drop)?
            };
            self.owed_s -= self.kitchen.time_s() - before;
            if self.paused {
                break;
            }
        }
        self.owed_s = self.owed_s.min(MOST_OWED_S * self.speed);
        Ok(())
    }

    /// Advances to the end of the tick, with the recipe's steps that are due.
    pub fn tick(&mut self) -> Result<(), String> {
        while !self.frame()? {}
        Ok(())
    }

    /// Advances by one frame; at the start of a tick, the recipe's due steps run first. Returns true if a tick or the
    /// recipe has ended.
    pub(super) fn frame(&mut self) -> Result<bool, String> {
        let begun = Instant::now();
        self.finish_travel();
        self.let_go_of_undone();
        self.follow(false);
        if self.kitchen.is_between_ticks() && !self.poll()? {
            return Ok(true);
        }
        self.follow(true);
        self.let_devices_lead();
        let ticked = self.kitchen.advance_frame();
        self.recording.observe(&self.kitchen);
        // Forces are only valid at real time; otherwise they fade out.
        if self.speed == 1.0 {
            self.hands.send(&self.kitchen);
        }
        if ticked {
            self.recorder.observe(&self.kitchen);
            self.probes.observe(&self.kitchen);
            self.hand_over_present();
            self.ask_when_due();
        }
        self.rejoin();
        self.keep_keyframes(begun.elapsed());
        Ok(ticked)
    }

    /// Pauses where the lesson has a question.
    fn ask_when_due(&mut self) {
        if self.lesson.as_mut().is_some_and(|lesson| lesson.observe(&self.kitchen)) {
            self.set_paused(true);
        }
    }

    /// Lets devices give their commands, and records them.
    fn let_devices_lead(&mut self) {
        // Whatever a device gives is cooking.
        if self.permits.allow(&[Permit::Hands]) {
            self.hands.lead(&mut self.kitchen);
        }
        let before = self.recording.entries().len();
        self.recording.take(&mut self.kitchen);
        let after = self.recording.entries().len();
        if after > before {
            self.depart(before);
        }
        (before..after).for_each(|entry| self.note_until(entry + 1));
    }

    /// Runs the due steps of the recipe; returns true if the recipe has not stopped.
    fn poll(&mut self) -> Result<bool, String> {
        let Some(mut runner) = self.runner.take() else { return Ok(true) };
        let fired = runner.poll(&mut self.kitchen);
        self.recording.on_steps(&mut self.kitchen);
        let fired = fired.map_err(|e| e.to_string())?;
        self.recorder.on_steps(&self.kitchen, &fired);
        let (time_s, at) = (self.kitchen.time_s(), self.recording.moment());
        let mark = |step: &Fired| Mark { time_s, done: Done::from(&step.action), at, step: step.as_text() };
        self.marks.extend(fired.iter().map(mark));
        if runner.stopped().is_some() {
            self.paused = true;
            self.owed_s = 0.0;
            return Ok(false);
        }
        self.runner = Some(runner);
        Ok(true)
    }

    /// Sets the speed [-]; owed time is discarded.
    pub fn set_speed(&mut self, speed: f64) {
        self.speed = speed;
        self.owed_s = 0.0;
    }

    /// Pauses or resumes; owed time is discarded.
    pub fn set_paused(&mut self, paused: bool) {
        self.paused = paused;
        self.owed_s = 0.0;
    }

    /// Returns the lag behind the chosen speed [simulated s]; `None` while it is not noticeable.
    pub fn behind_s(&self) -> Option<f64> {
        (self.owed_s > LATE_AFTER_S * self.speed).then_some(self.owed_s)
    }
}
