//! The result of a cook: when it is shown by itself, and its picture that is shared.

use std::sync::Arc;

use crate::app::SauteApp;
use crate::host::Host;
use crate::learn::on_its_own;
use crate::panels::cards::serving::Serving;
use saute_controls::act::Card;
use saute_controls::goal_choice::goal_of;
use saute_kitchen::advice::Advice;
use saute_picture::plated::plated;
use saute_picture::stage::StageOptions;
use saute_plan::goal::{Goal, Judgement};
use saute_scene::light::gathered::LightSample;
use saute_scene::quality::Quality;
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
        if let Some((goal, judgement)) = self.judged() {
            self.settings.keep_mark(&goal.name, judgement.mark.points());
        }
    }

    /// The cook so far, judged by its goal: a plan's cook by what the plan was made for. None without food that has a scale.
    fn judged(&self) -> Option<(Goal, Judgement)> {
        let live = self.leads.live.as_ref().filter(|live| live.judges(&self.session));
        let goal = live.map(|live| live.goal().clone()).or_else(|| goal_of(&self.session, &self.settings))?;
        let judgement = self.session.judgement(&goal)?;
        Some((goal, judgement))
    }

    /// The result in words, and from when the cook is tried again [s]: shortly before what decided, once it has rested.
    pub(crate) fn result(&mut self) -> Option<(ResultWords, Option<f64>)> {
        let rise = self.session.rise();
        let (goal, judgement) = self.judged()?;
        let speech = self.settings.speech();
        let marks = self.settings.marks.get(&goal.name).map_or(&[][..], Vec::as_slice);
        let words = ResultWords::of(&judgement, &goal, &self.session.noun(speech.language), speech)
            .with_marks(marks, speech.language);
        let live = self.leads.live.as_ref().filter(|live| live.judges(&self.session));
        // A plan itself states when it is served.
        let words = match (live, rise) {
            (Some(live), _) => words.of_plan(live.plan(), &live.kept(&self.session, &judgement), speech),
            (None, Some(rise)) => return Some((words.while_it_rests(rise.peak_c, speech), None)),
            (None, None) => words,
        };
        let try_from_s = judgement.better.and_then(|better| self.session.deciding_s(&better));
        Some((words, try_from_s))
    }

    /// Puts the food of a result on its plate, once for each result; without one the plate is cleared.
    pub(crate) fn serve(&mut self, words: Option<&ResultWords>) {
        let served = &self.desk.memory.result.plate;
        let Some(words) = words.filter(|_| self.drawable()) else {
            self.desk.memory.result.plate = None;
            return;
        };
        if served.as_ref().is_some_and(|plate| plate.words == *words) {
            return;
        }
        let (white_balance, light) = (self.settings.white_balance, self.settings.light);
        let options = StageOptions { white_balance, light, ..StageOptions::default() };
        let quality = self.quality();
        self.desk.memory.result.plate = Some(Serving {
            input: Arc::new(plated(&self.session.kitchen, &options)),
            quality,
            samples: if quality == Quality::Best { LightSample::KEPT } else { 1 },
            rest: self.sights.scene.rest.clone(),
            words: words.clone(),
        });
    }

    /// Opens the result of a plan once its rest is over, unless it is switched off: time is then stopped.
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
        let Some(((words, _), piece)) = self.result().zip(self.session.shown_piece()) else { return };
        let drawn = on_its_own::picture(&words, piece, l);
        let bytes = saute_picture::still::png_file::png_bytes(&drawn).map_err(|error| error.to_string());
        match bytes.and_then(|bytes| self.host.picture_keeper()(&bytes)) {
            Ok(path) => self.desk.notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
            Err(error) => self.desk.notice.say(l.fill("notice.not_saved", &[("error", &error)])),
        }
    }
}
