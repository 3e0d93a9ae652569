//! A speed that the machine cannot sustain gives way to one that it can.

use super::SauteApp;
use crate::app::apply::waiting::Waiting;
use crate::app::keeps::later::Later;
use saute_kitchen::advice::Advice;
use saute_picture::frame_meter::FrameMeter;
use saute_session::easing::Easing;
use saute_session::guided::Guided;
use saute_session::lag::{Lag, Retry};
use saute_session::{Forecast, SPEEDS};

/// For how long after a toss time goes at its real speed, so that food is seen to fly and felt to land [s] (chosen: it flies for
/// a third of a second and comes to rest within another).
const TOSS_S: f64 = 1.5;

/// How time goes in the window.
#[derive(Default)]
pub(crate) struct Pace {
    pub(crate) last_time: Option<f64>,
    /// The present lag of the clock.
    pub(crate) lag: Option<Lag>,
    /// When a speed that was given up is tried again.
    retry: Retry,
    /// True while a hand is needed, so that time goes at its real speed.
    hand_needed: bool,
    /// Simulated time of the last toss [s].
    tossed_s: Option<f64>,
    /// What waits until the instant is reached to which time is turned.
    pub(crate) waiting: Vec<Waiting>,
    /// What is done as soon as its foods are built, and in which beginning of a cook it was asked for.
    pub(crate) later: Option<(Later, u64)>,
    /// Real time where a hand is needed.
    pub(crate) easing: Easing,
    /// True if time was stopped because nobody sees the window.
    pub(crate) stopped_unseen: bool,
    pub(crate) meter: FrameMeter,
}

impl SauteApp {
    /// Returns true if an advice needs a hand, or all food has rested, whose core rises no more, and waits to be looked at.
    pub(super) fn needs_hand(&self, advised: &[Advice], rise: Option<Forecast>) -> bool {
        let rests = |one: &Advice| matches!(one, Advice::Resting { .. } | Advice::Rested { .. });
        let is_done = || rise.is_none() && self.session.is_out() && advised.iter().any(rests);
        advised.iter().any(|one| one.is_due()) || is_done() || self.food_is_tossed()
    }

    /// Time slows to the real one while food that is tossed flies.
    pub(super) fn ease_for_toss(&mut self) {
        self.pace.tossed_s = Some(self.session.kitchen.time_s());
        self.ease(true);
    }

    /// Returns true if food was tossed a moment ago.
    fn food_is_tossed(&self) -> bool {
        let since = |tossed_s: f64| self.session.kitchen.time_s() - tossed_s;
        self.pace.tossed_s.map(since).is_some_and(|since_s| (0.0..TOSS_S).contains(&since_s))
    }

    /// Slows to real time while a hand is needed, and returns to what the machine sustains of the chosen speed.
    pub(super) fn ease(&mut self, hand_needed: bool) {
        let somebody_leads = self.leads.guided.is_some() || self.leads.learn.tutorial.is_some();
        self.pace.hand_needed = false;
        if !self.settings.eases || self.settings.skill_mode || somebody_leads {
            return;
        }
        self.pace.hand_needed = hand_needed;
        if let Some(speed) = self.pace.easing.look(self.pace.hand_needed, self.session.speed) {
            self.session.set_speed(speed.min(self.settings.held_speed.unwrap_or(speed)));
        }
    }

    /// Watches the clock through `wall` seconds. The chosen speed stays in the settings, next to the one that the machine sustains, and is
    /// tried again, step by step; a speed that is locked stays, and what is missing is noted.
    pub(super) fn keep_up(&mut self, wall: f64) {
        let (now, time_s) = (self.session.speed, self.session.kitchen.time_s());
        let is_locked = self.leads.guided.as_ref().is_some_and(Guided::holds_speed);
        if is_locked || self.session.behind_s().is_none() || now <= SPEEDS[0] {
            self.pace.lag = None;
            if !is_locked && self.session.behind_s().is_none() {
                self.try_again(wall);
            }
            return;
        }
        let lag = self.pace.lag.get_or_insert(Lag::begun(time_s));
        let Some(holds) = lag.holdable(now, time_s, wall) else { return };
        self.pace.lag = None;
        self.session.set_speed(holds);
        self.settings.held_speed = Some(holds);
        self.pace.retry.gave_up();
        let words = |speed: f64| format!("{speed:.0}");
        let said: [(&str, &dyn std::fmt::Display); 2] = [("wanted", &words(now)), ("speed", &words(holds))];
        self.desk.notice.say(self.settings.language.fill("notice.slowed", &said));
    }

    /// Tries the next higher speed, up to the chosen one, once a lower one has been held for a while.
    fn try_again(&mut self, wall: f64) {
        let (now, wished) = (self.session.speed, self.settings.speed);
        if self.settings.held_speed != Some(now) || self.session.paused || self.pace.hand_needed {
            return;
        }
        if let Some(speed) = self.pace.retry.held(now, wished, wall) {
            self.session.set_speed(speed);
            self.settings.held_speed = (speed < wished).then_some(speed);
        }
    }
}
