//! A session in the window: the kitchen, its clock, and a recipe that may be playing.

pub mod at_home;
mod choice;
mod clock;
mod deciding;
pub mod easing;
pub mod export;
pub mod forecasts;
mod foreseen_peak;
mod foresight;
pub mod guided;
pub mod hands;
pub mod hearing;
mod judging;
pub mod kept;
mod kept_order;
pub mod lag;
mod mark;
mod noting;
pub mod permits;
pub mod plan;
pub mod playback;
mod resumed;
mod selection;
mod speeds;
mod stock;
pub mod timeline;
mod whole_time;
pub mod work;

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::{Command, Kitchen, Library, PieceOrder};
use saute_recipe::probe::Probes;
use saute_recipe::session::ReplayError;
use saute_recipe::{Recipe, Recorder, Recording, Runner};
use saute_study::class::Lesson;

use self::choice::as_recipe;
use self::hands::{Hands, NoHands};
use self::kept_order::KeptOrder;
use self::permits::{NotDone, Permits};
use self::timeline::Timeline;

pub use self::choice::{FoodChoice, noun};
pub use self::foreseen_peak::Forecast;
pub use self::mark::Mark;
pub use self::speeds::{MOST_OWED_S, SPEEDS};

/// The state behind the window.
pub struct Session<H = NoHands> {
    /// Library of foods, pans, rooms, scales and recipes, with the kitchen at home in which the present cook is.
    pub library: Arc<Library>,
    /// The library of the kitchen in which later cooks begin.
    home: Arc<Library>,
    /// The kitchen.
    pub kitchen: Kitchen,
    /// The recipe that plays, until the user gives a command.
    pub runner: Option<Runner>,
    /// The recipe that was left when the user gave a command.
    left: Option<Runner>,
    /// Series for the plot.
    pub recorder: Recorder,
    /// Points in the food whose temperature is recorded.
    pub probes: Probes,
    /// Events.
    pub marks: Vec<Mark>,
    /// Simulated time over wall time [-].
    pub speed: f64,
    /// True if time is paused.
    pub paused: bool,
    /// Number of restarts [-].
    pub generation: u64,
    /// Devices that hands hold, and the tools in them.
    pub hands: H,
    /// The lesson that watches the cook.
    pub lesson: Option<Lesson>,
    /// What a person may do.
    pub permits: Permits,
    choice: FoodChoice,
    /// What the cook began with: a recipe that plays, or one that only sets out the chosen food and pan.
    recipe: Arc<Recipe>,
    plays: bool,
    /// What happened, from the beginning to the instant that is shown.
    recording: Recording,
    timeline: Timeline,
    /// What is played elsewhere.
    playback: playback::Playback,
    forecasts: forecasts::Forecasts,
    owed_s: f64,
    selected: Option<String>,
    start_mass_g: BTreeMap<String, f64>,
    forecast: Option<(String, u64, Forecast)>,
    /// The valid order about the hob.
    order: KeptOrder,
    /// Foods that are being built.
    building: Option<stock::Building>,
}

impl<H: Hands> Session<H> {
    /// Starts a session with the chosen food and pan.
    ///
    /// # Errors
    ///
    /// If the library has not what was chosen.
    pub fn new(library: Arc<Library>, choice: &FoodChoice) -> Result<Self, ReplayError> {
        let recipe = Arc::new(as_recipe(&library, choice, 1)?);
        let kitchen = recipe.kitchen(&library)?;
        let recording = Recording::begin(&recipe, false, &library);
        let mut session = Self {
            home: Arc::clone(&library),
            library,
            kitchen,
            runner: None,
            left: None,
            recorder: Recorder::default(),
            probes: Probes::default(),
            marks: Vec::new(),
            speed: 1.0,
            paused: false,
            generation: 0,
            hands: H::default(),
            lesson: None,
            permits: Permits::default(),
            choice: choice.clone(),
            recipe,
            plays: false,
            recording,
            timeline: Timeline::default(),
            playback: Default::default(),
            forecasts: Default::default(),
            owed_s: 0.0,
            selected: None,
            start_mass_g: BTreeMap::new(),
            forecast: None,
            order: KeptOrder::default(),
            building: None,
        };
        session.begin();
        Ok(session)
    }

    /// Begins with a kitchen that is set out and its recording.
    fn begin(&mut self) {
        self.recorder = Recorder::default();
        self.recorder.observe(&self.kitchen);
        self.probes = Probes::default();
        self.marks.clear();
        self.left = None;
        self.selected = None;
        self.start_mass_g.clear();
        self.timeline.begin();
        self.playback.forget();
        self.listen();
        self.recording.observe(&self.kitchen);
        self.weigh_new();
        self.keep_keyframe();
        self.start_afresh();
    }

    /// The kitchen that is shown is another one: what was thought of the last one is forgotten.
    fn start_afresh(&mut self) {
        self.owed_s = 0.0;
        self.forecast = None;
        self.generation += 1;
        self.hands.begin();
    }

    /// Devices give the kitchen commands themselves.
    fn listen(&mut self) {
        self.kitchen.listen();
    }

    /// Begins a cook in place of the present one, which can be brought back.
    fn begin_with(&mut self, recipe: Arc<Recipe>, plays: bool) -> Result<(), ReplayError> {
        self.begin_in(Arc::clone(&self.home), recipe, plays)
    }

    /// As [`Self::begin_with`], in the kitchen of a library.
    fn begin_in(&mut self, library: Arc<Library>, recipe: Arc<Recipe>, plays: bool) -> Result<(), ReplayError> {
        let mut models = self.take_built(&recipe.foods);
        let kitchen = recipe.kitchen_with(&library, &mut models)?;
        self.put_by();
        self.library = library;
        self.recording = Recording::begin(&recipe, plays, &self.library);
        self.kitchen = kitchen;
        self.runner = plays.then(|| Runner::new(Arc::clone(&recipe)));
        (self.recipe, self.plays) = (recipe, plays);
        self.begin();
        self.timeline.models().adopt(models);
        Ok(())
    }

    /// The library of the kitchen in which later cooks begin.
    pub fn home(&self) -> &Arc<Library> {
        &self.home
    }

    /// Later cooks begin in the kitchen of a library.
    pub fn move_to(&mut self, home: Arc<Library>) {
        self.home = home;
    }

    /// Restarts with another choice of food and pan.
    ///
    /// # Errors
    ///
    /// If the library has not what was chosen.
    pub fn set_out(&mut self, choice: &FoodChoice, count: usize) -> Result<(), ReplayError> {
        let recipe = as_recipe(&self.library, choice, count)?;
        self.begin_with(Arc::new(recipe), false)?;
        self.choice = choice.clone();
        Ok(())
    }

    /// Sets out the pan and the foods of a recipe, whose steps are left to the cook.
    ///
    /// # Errors
    ///
    /// If the library has not what the recipe needs.
    pub fn set_out_recipe(&mut self, recipe: Recipe) -> Result<(), ReplayError> {
        self.begin_with(Arc::new(recipe), false)?;
        self.speed = 1.0;
        Ok(())
    }

    /// Plays a recipe from its start.
    ///
    /// # Errors
    ///
    /// If the library has not what the recipe needs.
    pub fn play(&mut self, recipe: Recipe) -> Result<(), ReplayError> {
        self.begin_with(Arc::new(recipe), true)?;
        self.paused = false;
        self.speed = 1.0;
        Ok(())
    }

    /// Sets out pan and food of a recipe, without its steps, for a cook that a study or a lesson leads: there is no way back to the cook
    /// before.
    ///
    /// # Errors
    ///
    /// If the library has not what the recipe needs.
    pub fn set_out_led(&mut self, recipe: Arc<Recipe>) -> Result<(), ReplayError> {
        self.lesson = None;
        self.begin_with(recipe, false)?;
        self.forget_put_by();
        self.set_paused(false);
        Ok(())
    }

    /// Returns true while the lesson waits for an answer.
    pub fn asks(&self) -> bool {
        self.lesson.as_ref().is_some_and(|lesson| lesson.waiting().is_some())
    }

    /// Restarts the same recipe or choice, with the food that was added.
    ///
    /// # Errors
    ///
    /// If a food cannot be built.
    pub fn restart(&mut self) -> Result<(), ReplayError> {
        if self.plays {
            return self.play(Recipe::clone(&self.recipe));
        }
        let orders: Vec<PieceOrder> = stock::added_to(&self.recording).cloned().collect();
        let known = self.timeline.models().needed_by(&orders, &self.library);
        self.begin_with(Arc::clone(&self.recipe), false)?;
        self.timeline.models().adopt(known);
        orders.into_iter().try_for_each(|order| self.add_one(order))?;
        self.end_of_beginning();
        Ok(())
    }

    /// Carries out a command of the user, which stops the recipe.
    ///
    /// # Errors
    ///
    /// If a study or a lesson locks it, or the kitchen refuses it.
    pub fn command(&mut self, command: &Command) -> Result<(), NotDone> {
        if !self.permits.allow(permits::needs(command)) {
            return Err(NotDone::Locked);
        }
        self.finish_travel();
        self.kitchen.apply(command)?;
        drop(self.kitchen.take_carried_out());
        self.depart(self.recording.entries().len());
        self.leave_recipe();
        self.recording.push(&self.kitchen, command.clone());
        self.note_last();
        Ok(())
    }

    /// Stops the recipe; it can be resumed.
    fn leave_recipe(&mut self) {
        self.left = self.runner.take().or_else(|| self.left.take());
    }

    /// Lets the recipe go on from the step that it waited for; returns false if none was left.
    pub fn resume_recipe(&mut self) -> bool {
        self.finish_travel();
        if self.left.is_none() {
            return self.runner.is_some();
        }
        self.depart(self.recording.entries().len());
        self.recording.resume(&self.kitchen);
        self.runner = self.left.take();
        true
    }

    /// Returns the title of the recipe that was left, if there is one.
    pub fn left_recipe(&self) -> Option<&str> {
        self.left.as_ref().map(|runner| runner.recipe().title.as_str())
    }

    /// Returns the title of the recipe, if one was loaded.
    pub fn recipe_title(&self) -> Option<&str> {
        self.plays.then_some(self.recipe.title.as_str())
    }

    /// Returns the last choice of food and pan.
    pub fn choice(&self) -> &FoodChoice {
        &self.choice
    }

    /// Lets a helper play recorded cooks, long ways through time and ways next to the one that is shown.
    pub fn employ(&mut self, helper: Box<dyn crate::work::Helper>) {
        self.playback.employ(helper);
    }

    /// What happened, from the beginning to the instant that is shown.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }
}

#[cfg(test)]
mod tests {
    use web_time::Duration;

    use super::*;

    fn session() -> Session {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        Session::new(library, &FoodChoice::default()).expect("sets out")
    }

    /// Ten wall seconds in a thousand small frames or in a few long ones: the same world.
    #[test]
    fn the_world_does_not_depend_on_the_frame_rate() {
        let run = |frames: u32| {
            let mut s = session();
            s.command(&Command::Hob(1100.0)).expect("hob");
            for _ in 0..frames {
                s.advance(Duration::from_secs_f64(10.0 / f64::from(frames)), Duration::from_secs(60)).expect("runs");
            }
            s
        };
        let (fine, coarse) = (run(1000), run(4));
        assert_eq!(fine.kitchen.tick().max(coarse.kitchen.tick()) - fine.kitchen.tick().min(coarse.kitchen.tick()), 0);
        assert_eq!(fine.kitchen.pan_temperature().to_bits(), coarse.kitchen.pan_temperature().to_bits());
    }

    #[test]
    fn time_that_the_machine_cannot_hold_stays_owed_and_is_said() {
        let mut s = session();
        s.set_speed(20.0);
        s.advance(Duration::from_secs(1), Duration::ZERO).expect("runs");
        assert!(s.behind_s().is_some_and(|b| b > 19.0));
        s.advance(Duration::ZERO, Duration::from_secs(60)).expect("runs");
        assert!((s.kitchen.time_s() - 20.0).abs() < 0.2 && s.behind_s().is_none());
    }

    #[test]
    fn a_person_can_take_over_from_a_recipe() {
        let mut s = session();
        let text = "[[step]]\nhob_w = 1100\n[[step]]\nafter_s = 60\nend = true\n";
        let recipe = Recipe::parse(text, "own.toml", &s.library).expect("parses");
        s.play(recipe).expect("plays");
        s.advance(Duration::from_secs(2), Duration::from_secs(60)).expect("runs");
        assert_eq!(s.kitchen.hob_w(), 1100.0);
        s.command(&Command::Hob(0.0)).expect("hob");
        assert!(s.runner.is_none());
        assert_eq!(s.kitchen.hob_w(), 0.0);
        assert!(s.left_recipe().is_some() && s.resume_recipe());
        s.advance(Duration::from_secs(60), Duration::from_secs(60)).expect("runs");
        assert!(s.paused, "the recipe has ended by its own last step");
        assert!(!s.resume_recipe());
    }
}
