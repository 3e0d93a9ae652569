//! The result of a cook: when it is shown by itself, and its picture that is shared.

use crate::act::Card;
use crate::app::SauteApp;
use crate::learn::goal_choice::goal_of;
use crate::learn::on_its_own;
use saute_kitchen::advice::Advice;
use saute_words::judgement_words::ResultWords;

/// Longest interval between the marks of one taking out [s] (chosen: pieces of a group follow each other within it).
const SAME_OUT_S: f64 = 0.05;

impl SauteApp {
    /// Opens the result once the food has rested: once for each time that it came out, unless it is switched off.
    pub(crate) fn watch_result(&mut self, advice: &[Advice]) {
        let has_rested = advice.iter().any(|one| matches!(one, Advice::Rested { .. }));
        let is_free = self.desk.card.is_none() && !self.card_is_open() && !self.shows_ways() && !self.session.paused;
        let is_led = self.leads.learn.tutorial.is_some() || self.leads.guided.is_some() || self.follows_plan();
        let is_alone = self.session.runner.is_none() && !is_led;
        if !(self.settings.result_opens && has_rested && is_free && is_alone && self.session.is_out()) {
            return;
        }
        let moved = self.session.last_moved_s();
        let same = |a: f64, b: f64| (a - b).abs() < SAME_OUT_S;
        let is_new = self.leads.learn.shown_for.is_none_or(|before| !same(moved, before));
        if is_new {
            self.leads.learn.shown_for = Some(moved);
            self.desk.card = Some(Card::Result);
        }
    }

    /// Keeps the mark of a cook whose result is seen, once it has rested and nobody else cooked it: once for each time that it came out.
    pub(crate) fn keep_mark(&mut self) {
        let is_own = self.leads.guided.is_none() && !self.session.recording().beginning().plays;
        let came_out_s = self.session.came_out_s().filter(|_| is_own && self.session.is_out());
        let is_new = came_out_s.is_some() && self.leads.learn.marked_for != came_out_s;
        if self.desk.card != Some(Card::Result) || !is_new || self.session.rise().is_some() {
            return;
        }
        self.leads.learn.marked_for = came_out_s;
        let Some(goal) = goal_of(&self.session, &self.settings) else { return };
        if let Some(judgement) = self.session.judgement(&goal) {
            self.settings.keep_mark(&goal.name, judgement.mark.points());
        }
    }

    /// From when the cook is tried again: shortly before what decided [s].
    pub(crate) fn try_from_s(&self) -> Option<f64> {
        let goal = goal_of(&self.session, &self.settings)?;
        self.session.deciding_s(&self.session.judgement(&goal)?.better?)
    }

    /// The result in words; none without food that a scale knows.
    pub(crate) fn result_words(&mut self) -> Option<ResultWords> {
        let rise = self.session.rise();
        let live = self.leads.live.as_ref().filter(|live| live.judges(&self.session));
        // A plan is judged by what it was made for.
        let goal = live.map(|live| live.goal().clone()).or_else(|| goal_of(&self.session, &self.settings))?;
        let judgement = self.session.judgement(&goal)?;
        let words = ResultWords::of(&judgement, &goal, &self.session.noun(), self.settings.speech());
        let marks = self.settings.marks.get(&goal.name).map_or(&[][..], Vec::as_slice);
        let words = words.with_marks(marks, self.settings.language);
        // A plan says itself when it is served.
        Some(match (live, rise) {
            (Some(live), _) => {
                words.of_plan(live.plan(), &live.kept(&self.session, &judgement), self.settings.speech())
            }
            (None, Some(rise)) => words.while_it_rests(rise.peak_c, self.settings.speech()),
            (None, None) => words,
        })
    }

    /// Opens the result of a plan once its rest is over, unless it is switched off: time stands still then.
    pub(crate) fn open_result_of_plan(&mut self) {
        let is_free = self.desk.card.is_none() && !self.card_is_open() && !self.shows_ways();
        if self.settings.result_opens && is_free && self.leads.guided.is_none() && self.session.is_out() {
            self.leads.learn.shown_for = Some(self.session.last_moved_s());
            self.desk.card = Some(Card::Result);
        }
    }

    /// Saves the result as a picture: into the folder of pictures, or as a download of the browser.
    pub(crate) fn share_result(&mut self) {
        let l = self.settings.language;
        let Some((words, piece)) = self.result_words().zip(self.session.steak()) else { return };
        let drawn = on_its_own::picture(&words, piece, l);
        let bytes = saute_picture::still::png_file::png_bytes(&drawn).map_err(|error| error.to_string());
        match bytes.and_then(|bytes| self.keeper()(&bytes)) {
            Ok(path) => self.desk.notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
            Err(error) => self.desk.notice.say(l.fill("notice.not_saved", &[("error", &error)])),
        }
    }
}
