//! Hob, food and recipes by acts.

use saute_kitchen::{Command, RestOn, kelvin};
use saute_plan::forecast::Question;

use crate::app::SauteApp;
use crate::app::keeps::later::Later;
use saute_kitchen::piece::memory::MOST_PIECES;
use saute_session::FoodChoice;

/// Height of a toss by key [m] (chosen: over the rim, within reach).
const TOSS_M: f64 = 0.12;

impl SauteApp {
    /// Puts the wet cloth under the pan for its default time.
    pub(super) fn cool_with_cloth(&mut self) {
        let for_s = self.session.kitchen.room().cloth.default_s;
        self.command(&Command::Cool { for_s });
    }

    /// Lets the hob hold the pan at a temperature [°C].
    pub(super) fn hold_pan_at(&mut self, celsius: f64) {
        let power = self.session.kitchen.hob().hold().map_or(0.0, |hold| hold.panel_w);
        self.command(&Command::HobHold { temperature: kelvin(celsius), power });
    }

    pub(super) fn change_hob(&mut self, by: i8) {
        let settings = self.session.kitchen.hob().settings_w().to_vec();
        let now = self.session.kitchen.hob_w();
        let next = if by > 0 {
            settings.iter().copied().find(|&w| w > now + 0.5)
        } else {
            settings.iter().rev().copied().find(|&w| w < now - 0.5)
        };
        if let Some(w) = next {
            self.command(&Command::Hob(w));
        }
    }

    /// Tosses what is in the pan.
    pub(super) fn toss(&mut self) {
        if self.give(&Command::Toss { height: TOSS_M }) {
            self.ease_for_toss();
        }
    }

    /// Takes the food out onto the board; the eye follows it there.
    pub(super) fn take_out(&mut self) {
        let food = self.handled_id();
        if self.give(&Command::Rest { food: food.clone(), on: RestOn::Board }) {
            self.sights.taken_out = Some(food);
        }
    }

    /// Does what a forecast is about with the piece that the panels show; the eye follows what is taken out.
    pub(super) fn do_asked(&mut self, question: Question) {
        let food = self.session.shown_id();
        let commands = question.commands(&self.session.kitchen, &food).unwrap_or_default();
        let is_done = !commands.is_empty() && commands.iter().all(|command| self.give(command));
        if is_done && question == Question::TakeOut {
            self.sights.taken_out = Some(food);
        }
    }

    /// Halves the food on the board; the eye turns to the cut faces.
    pub(super) fn halve(&mut self) {
        let food = self.handled_id();
        if self.give(&Command::Halve { food: food.clone(), at: 0.0 }) {
            self.session.select(Some(food));
            self.look_at_cut();
        }
    }

    /// Lets the recipe go on from which a command took over.
    pub(super) fn resume_recipe(&mut self) {
        if self.session.resume_recipe() {
            self.say("notice.resumed");
        }
    }

    pub(super) fn select_next(&mut self) {
        let pieces = self.session.kitchen.pieces();
        let next = if self.session.selected().is_some() { self.session.shown_index() + 1 } else { 0 };
        let id = pieces.get(next).or(pieces.first()).map(|p| p.id.clone());
        self.session.select(id);
    }

    /// Sets out so many of the chosen food as soon as they are built.
    pub(super) fn set_out_by_hand(&mut self, count: usize) {
        let choice = self.settings.choice.clone();
        let is_to_build = self.session.builds_choice_first(&choice, count);
        if !self.waits_for_food(is_to_build, || Later::SetOut(choice.clone(), count)) {
            self.set_out_chosen(choice, count);
        }
    }

    /// Restarts with so many of the chosen food, and the chosen pan.
    pub(crate) fn set_out(&mut self, count: usize) {
        self.set_out_chosen(self.settings.choice.clone(), count);
    }

    /// Restarts with so many of a choice.
    pub(crate) fn set_out_chosen(&mut self, choice: FoodChoice, count: usize) {
        self.leads.learn.begin_cook();
        match self.session.set_out(&choice, count) {
            Ok(()) => {
                self.sights.motions.clear();
                self.say_new_beginning();
            }
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Shows a notice that another cook begins, and how the one before comes back, if there is one.
    pub(crate) fn say_new_beginning(&self) {
        if self.session.can_undo() && self.leads.guided.is_none() {
            self.say("notice.begun_anew");
        }
    }

    /// Adds food to the kitchen, outside of the pan, as soon as it is built.
    pub(super) fn add(&mut self, count: usize) {
        let (here, l) = (self.session.kitchen.pieces().len(), self.settings.language);
        if here + count > MOST_PIECES {
            let room = MOST_PIECES.saturating_sub(here);
            self.desk.notice.say(l.fill("pantry.full", &[("most", &MOST_PIECES), ("room", &room)]));
            return;
        }
        let choice = self.settings.choice.clone();
        let is_to_build = self.session.builds_added_first(&choice, count);
        if !self.waits_for_food(is_to_build, || Later::Add(choice.clone(), count)) {
            self.add_chosen(&choice, count);
        }
    }

    /// Adds so many of a choice.
    pub(crate) fn add_chosen(&mut self, choice: &FoodChoice, count: usize) {
        let l = self.settings.language;
        match self.session.add(choice, count) {
            Ok(group) => {
                let first = self.session.members(&group).into_iter().next();
                self.session.select(first);
                let food = self.session.name_of(&group, l);
                self.desk.notice.say(l.fill("pantry.added", &[("count", &count), ("food", &food)]));
            }
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Plays a recipe of the library.
    pub(super) fn play(&mut self, id: &str) {
        let library = std::sync::Arc::clone(&self.session.library);
        if let Some(text) = library.recipes.get(id) {
            self.open_recipe(text, &format!("{id}.toml"));
        }
    }

    pub(crate) fn restart(&mut self) {
        if self.leads.guided.is_some() {
            return self.lesson_again();
        }
        let is_to_build = self.session.builds_again_first();
        if self.waits_for_food(is_to_build, || Later::Restart) {
            return;
        }
        self.leads.learn.begin_cook();
        match self.session.restart() {
            Ok(()) => self.say_new_beginning(),
            Err(error) => self.say_trouble(&error),
        }
        self.sights.motions.clear();
    }
}
