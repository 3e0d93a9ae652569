//! Carries out what is done about a plan.

use crate::app::SauteApp;
use crate::app::on_host::OnHost;
use saute_controls::act::Card;
use saute_controls::plan::PlanFile;
use saute_controls::plan::{PlanAct, kitchen_card};
use saute_kitchen::Command;
use saute_plan::schedule::Plan;
use saute_plan::schedule::voice::Keeping;
use saute_session::SPEEDS;
use saute_session::plan::live::Live;
use saute_session::work::WorkKind;
use saute_session::work::in_frames::InFrames;
use std::sync::Arc;

impl SauteApp {
    /// Carries out what is done about a plan.
    pub(crate) fn act_on_plan(&mut self, act: PlanAct, ctx: &egui::Context) {
        match act {
            PlanAct::Choose(choice) => self.settings.plan = choice,
            PlanAct::Find => self.find_plan(),
            PlanAct::Stop => self.leads.planning.stop(&self.session.library),
            PlanAct::CookLive => self.cook_live(),
            PlanAct::CookItself => self.let_plan_cook(),
            PlanAct::Save(file) => self.save_plan(file, ctx),
            PlanAct::DoStep => self.do_step(),
            PlanAct::Hurry => self.hurry(),
            PlanAct::Leave => drop(self.leads.live.take_if(|live| !live.close())),
        }
    }

    fn find_plan(&mut self) {
        let asked = self.settings.wanted_plan(&self.session.library);
        let helper = (!self.leads.planning.has_helper()).then(|| self.hire_or_frames(WorkKind::Plan));
        let home = self.session.home();
        let there = asked.hob.as_ref().and_then(|hob| home.on_hob(hob).ok());
        let home = there.as_deref().unwrap_or(home).home().map(str::to_owned);
        self.leads.planning.ask(asked, home, helper);
    }

    /// A helper for a kind of work; where no agency finds one, it works in frames.
    pub(crate) fn hire_or_frames(&self, kind: WorkKind) -> Box<dyn saute_session::work::Helper> {
        let in_frames = || Box::new(InFrames::new(kind, &self.session.library)) as Box<dyn saute_session::work::Helper>;
        self.hire(kind).unwrap_or_else(in_frames)
    }

    /// Takes what the search has found since the last frame.
    pub(crate) fn follow_plan(&mut self, ctx: &egui::Context) {
        let was_searching = self.leads.planning.is_searching();
        self.leads.planning.take_answers(&self.session.library);
        if was_searching && !self.leads.planning.is_searching() && self.desk.card != Some(Card::Plan) {
            self.say("plan.ready");
        }
        if self.leads.planning.is_searching() {
            let soon = std::time::Duration::from_millis(if self.leads.planning.needs_frames() { 0 } else { 200 });
            ctx.request_repaint_after(soon);
        }
        let live = self.leads.live.as_mut().filter(|live| live.is_of(&self.session));
        if live.is_some_and(|live| live.look_after(&mut self.session)) {
            self.open_result_of_plan();
        }
    }

    fn hurry(&mut self) {
        if let Some(live) = &mut self.leads.live {
            live.hurries(&self.session);
        }
        self.session.set_speed(SPEEDS[SPEEDS.len() - 1]);
    }

    /// The plan that the shown cook follows, until it is over: its rest is as long as planned.
    fn followed(&self) -> Option<&Live> {
        self.leads.live.as_ref().filter(|live| live.is_of(&self.session) && live.gave().is_none())
    }

    /// Returns true while a plan is followed.
    pub(crate) fn follows_plan(&self) -> bool {
        self.followed().is_some()
    }

    /// How the person keeps to the plan that is followed.
    pub(crate) fn keeping(&self) -> Option<Keeping> {
        self.followed().map(|live| live.keeping(&self.session))
    }

    fn cook_live(&mut self) {
        let Some(plan) = self.leads.planning.plan().cloned() else { return };
        if self.begin_plan(&plan, false) {
            self.aim_at(&plan.order.goal);
            self.leads.live = Some(Live::new(plan, &self.session));
            self.session.set_paused(true);
        }
    }

    fn let_plan_cook(&mut self) {
        let Some(plan) = self.leads.planning.plan().cloned() else { return };
        if self.begin_plan(&plan, true) {
            self.aim_at(&plan.order.goal);
            self.leads.live = Some(Live::new(plan, &self.session));
        }
    }

    /// Begins the cook of a plan: it plays, or its food and its pan are set out. Returns false if that cannot be done.
    fn begin_plan(&mut self, plan: &Plan, plays: bool) -> bool {
        let library = Arc::clone(self.session.home());
        let begun = match plan.schedule.recipe(&plan.order, &library) {
            Ok(recipe) if plays => self.session.play(recipe).map_err(|error| error.to_string()),
            Ok(recipe) => self.session.set_out_recipe(recipe).map_err(|error| error.to_string()),
            Err(error) => Err(error.to_string()),
        };
        if let Err(error) = &begun {
            self.say_trouble(error);
            return false;
        }
        // One leads at a time.
        self.set_tutorial(false);
        self.leads.learn.begin_cook();
        self.sights.motions.clear();
        self.desk.card = None;
        self.say_new_beginning();
        true
    }

    /// Does the steps that come next, in the cook that follows a plan; time goes on.
    fn do_step(&mut self) {
        let Some(live) = self.leads.live.as_ref().filter(|live| live.is_of(&self.session)) else { return };
        for command in live.commands(&self.session) {
            let is_given = self.give(&command);
            // The eye follows what comes out, as when it is taken out by its own button.
            if let Command::Rest { food, .. } = command
                && is_given
            {
                self.sights.taken_out = Some(food);
            }
        }
        self.session.set_paused(false);
    }

    /// The bytes of a file that is made of the plan that was found.
    pub(crate) fn plan_file(&self, file: PlanFile) -> Option<Vec<u8>> {
        let plan = self.leads.planning.plan().or_else(|| self.leads.live.as_ref().map(Live::plan))?;
        let text = match file {
            PlanFile::Recipe => saute_controls::plan::recipe_file(plan, &self.session.library, &self.settings),
            PlanFile::Card => kitchen_card::page(plan, &self.session.library, self.settings.speech()),
        };
        Some(text.into_bytes())
    }
}
