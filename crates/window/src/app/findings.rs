//! What a frame finds out once, before panels show it.

use std::sync::Arc;

use saute_kitchen::advice::Advice;
use saute_kitchen::advice::coaching::Coaching;
use saute_plan::schedule::voice::Keeping;
use saute_scene::quality::Quality;
use saute_session::Forecast;
use saute_sound::Snapshot;
use saute_words::judgement_words::ResultWords;

use super::SauteApp;
use saute_controls::act::Card;

/// What a frame finds out once, before panels show it.
pub(crate) struct Findings {
    /// What is advised for the piece that the panels are about.
    pub(crate) advised: Vec<Advice>,
    /// What of it panels state, the most urgent first.
    pub(crate) advice: Vec<Advice>,
    /// How the person keeps to the plan that is followed.
    pub(crate) keeping: Option<Keeping>,
    /// What a coach states of the piece; none where the coach is off.
    pub(crate) coaching: Option<Coaching>,
    /// True if the goal is reached, the food is still in the pan and the coach is on.
    pub(crate) alarm: bool,
    /// How high the core of resting food still rises, and in how long.
    pub(crate) rise: Option<Forecast>,
    /// The result in words, while its card is open, and from when the cook is tried again [s].
    pub(crate) result: Option<(ResultWords, Option<f64>)>,
    /// How far a cook came with which the window offers to go on [s].
    pub(crate) unfinished_s: Option<f64>,
    /// What is heard; none where a study leaves no sound.
    pub(crate) heard: Option<Snapshot>,
    /// The quality at which the scene is drawn.
    pub(crate) quality: Quality,
    /// True while ways are shown side by side.
    pub(crate) side_by_side: bool,
}

impl SauteApp {
    /// Finds out what panels show in this frame.
    pub(crate) fn find_out(&mut self) -> Findings {
        let goal = self.scale().map(|scale| (Arc::clone(&scale), self.settings.goal(&scale)));
        let (advised, rise) = (self.session.advice(goal), self.session.rise());
        let result = self.shown_result();
        self.read_shown_rig();
        let keeping = self.keeping();
        // While a plan is kept to, its guide gives the orders.
        let advice = keeping.map_or_else(|| advised.clone(), |keeping| keeping.leaves(&advised));
        let coach = self.settings.coach && !self.settings.skill_mode && self.reads_out();
        let piece = self.session.shown_piece().filter(|_| coach);
        Findings {
            coaching: piece.and_then(|piece| Coaching::of(&self.session.kitchen, piece, &advised)),
            alarm: coach && advice.iter().any(|one| one.is_goal()),
            unfinished_s: self.offered_s(),
            heard: self.heard(),
            quality: self.quality(),
            side_by_side: self.shows_ways(),
            advised,
            advice,
            keeping,
            rise,
            result,
        }
    }

    /// The result while its card is open; its mark is kept.
    fn shown_result(&mut self) -> Option<(ResultWords, Option<f64>)> {
        self.keep_mark();
        let result = if self.desk.card == Some(Card::Result) { self.result() } else { None };
        self.serve(result.as_ref().map(|(words, _)| words));
        result
    }

    /// Reads the rig of the half mirror while its card is open, which shows the error of one that cannot be read.
    fn read_shown_rig(&mut self) {
        if self.desk.card == Some(Card::Mirror) {
            let _ = self.sights.mirror.rig(&self.settings.mirror.rig);
        }
    }
}
