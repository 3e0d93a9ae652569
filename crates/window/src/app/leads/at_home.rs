//! Carries out what is done about the kitchen at home.

use crate::app::SauteApp;
use saute_controls::act::Card;
use saute_controls::at_home::AtHomeAct;
use saute_controls::at_home::SCALE;
use saute_session::at_home::kept::KeptKitchen;
use saute_session::at_home::why_not::WhyNoFit;
use saute_session::export::Export;
use saute_session::plan::live::Live;
use saute_session::work::WorkKind;
use std::sync::Arc;

impl SauteApp {
    /// Carries out what is done about the kitchen at home.
    pub(crate) fn act_on_home(&mut self, act: AtHomeAct) {
        let entered = &mut self.leads.at_home.entered;
        match act {
            AtHomeAct::Rows(rows) => entered.rows = rows,
            AtHomeAct::Columns(columns) => {
                if let Some(log) = &mut entered.log {
                    log.choose(columns);
                }
            }
            AtHomeAct::Cooked(cooked) => entered.cooked = cooked,
            AtHomeAct::NoLog => entered.log = None,
            AtHomeAct::Fit => self.fit_kitchen(),
            AtHomeAct::Cancel => self.leads.at_home.cancel(),
            AtHomeAct::Keep => self.keep_kitchen(),
            AtHomeAct::Use(is_used) => self.use_kitchen(is_used),
            AtHomeAct::Forget => {
                self.settings.kitchen = None;
                self.enter_kitchen();
            }
        }
    }

    /// Takes a log, and opens the card.
    pub(crate) fn open_log(&mut self, name: &str, bytes: &[u8]) {
        self.desk.card = Some(Card::AtHome);
        if let Err(error) = self.leads.at_home.entered.take_log(name, bytes) {
            self.desk.notice.say(WhyNoFit::from(error).words(self.settings.language));
        }
    }

    /// Takes a recipe's text as what was cooked at home; one that cannot be read is reported as wrong.
    pub(crate) fn take_cooked(&mut self, name: &str, text: &str) {
        if saute_recipe::Recipe::parse(text, name, &self.keeps.library).is_err() {
            return self.open_recipe(text, name);
        }
        self.leads.at_home.entered.recipe = Some((name.to_owned(), text.to_owned()));
        self.leads.at_home.entered.cooked = saute_session::at_home::entered::Cooked::File;
    }

    fn fit_kitchen(&mut self) {
        let library = Arc::clone(&self.session.library);
        let shown = self.session.exported(Export::Recipe).ok().and_then(|(bytes, _)| String::from_utf8(bytes).ok());
        let plan = self
            .leads
            .planning
            .plan()
            .or(self.leads.live.as_ref().map(Live::plan))
            .map(saute_plan::schedule::Plan::recipe_text);
        let (entered, fahrenheit) = (&mut self.leads.at_home.entered, self.settings.fahrenheit);
        let made = entered
            .recipe(&library, shown, plan)
            .and_then(|recipe| Ok((entered.observed(&recipe, &library, SCALE, fahrenheit)?, recipe)));
        let (observed, recipe) = match made {
            Ok(made) => made,
            Err(error) => {
                self.leads.at_home.refuse(error.into());
                return;
            }
        };
        let helper = (!self.leads.at_home.has_helper()).then(|| self.hire_or_frames(WorkKind::Fit));
        // The factors count from the typical kitchen, whatever is cooked in now.
        self.leads.at_home.ask(recipe.text, self.typical_home(), observed, helper);
    }

    /// The kitchen at home with which the program was started, if any; the fit begins there.
    fn typical_home(&self) -> Option<String> {
        self.keeps.library.home().map(str::to_owned)
    }

    fn keep_kitchen(&mut self) {
        let Some(fitted) = self.leads.at_home.fitted() else { return };
        let log = self.leads.at_home.entered.log.as_ref().map_or("what was entered by hand", |log| log.name.as_str());
        let name = std::path::Path::new(log).file_name().map_or(log.into(), |name| name.to_string_lossy());
        self.settings.kitchen = Some(KeptKitchen::of(fitted, &self.keeps.library, &name));
        self.enter_kitchen();
    }

    fn use_kitchen(&mut self, is_used: bool) {
        if let Some(kept) = &mut self.settings.kitchen {
            kept.is_used = is_used;
        }
        self.enter_kitchen();
    }

    /// Later cooks begin in the kitchen that is kept, or in the typical one; one in which nothing was done begins there at once.
    fn enter_kitchen(&mut self) {
        let there = KeptKitchen::library(self.settings.kitchen.as_ref(), Arc::clone(&self.keeps.library));
        let is_own = there.home() != self.keeps.library.home();
        self.session.move_to(there);
        self.leads.planning.forget();
        if self.session.recording().entries().is_empty() && self.session.recipe_title().is_none() {
            let begun = self.session.restart();
            self.sights.motions.clear();
            if let Err(error) = begun {
                self.say_trouble(&error);
            }
        }
        self.say(if is_own { "athome.entered" } else { "athome.left" });
    }

    /// Takes what the fit has found since the last frame.
    pub(crate) fn follow_fit(&mut self, ctx: &egui::Context) {
        let was_fitting = self.leads.at_home.is_fitting();
        self.leads.at_home.take_answers();
        if was_fitting && !self.leads.at_home.is_fitting() && self.desk.card != Some(Card::AtHome) {
            self.say("athome.ready");
        }
        if self.leads.at_home.is_fitting() {
            let soon = if self.leads.at_home.needs_frames() { 0 } else { 200 };
            ctx.request_repaint_after(std::time::Duration::from_millis(soon));
        }
    }
}
