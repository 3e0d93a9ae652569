//! A session in the window: the kitchen, its clock, and a recipe that may be playing.

mod choice;
mod clock;
mod foresight;
mod mark;
mod resumed;
mod selection;
mod stock;

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Command, Kitchen, Library, Refused};
use saute_picture::probe::Probes;
use saute_recipe::{Recipe, Recorder, Runner};

use self::choice::set_out;
use self::mark::label;

pub use self::choice::{STEAK, SteakChoice, group_of, noun};
pub use self::clock::SPEEDS;
pub use self::foresight::Forecast;
pub use self::mark::Mark;

/// The state behind the window.
pub struct Session {
    /// Library of foods, pans, rooms, scales and recipes.
    pub library: Arc<Library>,
    /// The kitchen.
    pub kitchen: Kitchen,
    /// The recipe that plays, until the user gives a command.
    pub runner: Option<Runner>,
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
    /// Haptic devices and the tools they hold.
    #[cfg(not(target_arch = "wasm32"))]
    pub hands: crate::hand::Hands,
    choice: SteakChoice,
    recipe: Option<Recipe>,
    /// Food that was added to the first choice.
    added: Vec<(SteakChoice, usize)>,
    owed_s: f64,
    selected: Option<String>,
    start_mass_g: BTreeMap<String, f64>,
    forecast: Option<(String, u64, Forecast)>,
}

impl Session {
    /// Starts a session with the chosen food and pan.
    pub fn new(library: Arc<Library>, choice: &SteakChoice) -> Result<Self, SetupError> {
        let kitchen = set_out(&library, choice)?;
        let mut session = Self {
            library,
            kitchen,
            runner: None,
            recorder: Recorder::default(),
            probes: Probes::default(),
            marks: Vec::new(),
            speed: 1.0,
            paused: false,
            generation: 0,
            #[cfg(not(target_arch = "wasm32"))]
            hands: crate::hand::Hands::default(),
            choice: choice.clone(),
            recipe: None,
            added: Vec::new(),
            owed_s: 0.0,
            selected: None,
            start_mass_g: BTreeMap::new(),
            forecast: None,
        };
        session.begin();
        Ok(session)
    }

    fn begin(&mut self) {
        self.recorder = Recorder::default();
        self.recorder.observe(&self.kitchen);
        self.probes = Probes::default();
        self.marks.clear();
        self.added.clear();
        self.owed_s = 0.0;
        self.forecast = None;
        self.generation += 1;
        self.selected = None;
        self.start_mass_g.clear();
        #[cfg(not(target_arch = "wasm32"))]
        self.hands.begin();
        self.weigh_new();
    }

    /// Restarts with another choice of food and pan.
    pub fn set_out(&mut self, choice: &SteakChoice) -> Result<(), SetupError> {
        self.kitchen = set_out(&self.library, choice)?;
        (self.choice, self.recipe, self.runner) = (choice.clone(), None, None);
        self.begin();
        Ok(())
    }

    /// Plays a recipe from its start.
    pub fn play(&mut self, recipe: Recipe) -> Result<(), SetupError> {
        self.kitchen = recipe.kitchen(&self.library)?;
        self.runner = Some(Runner::new(Arc::new(recipe.clone())));
        self.recipe = Some(recipe);
        self.paused = false;
        self.speed = 1.0;
        self.begin();
        Ok(())
    }

    /// Restarts the same recipe or choice.
    pub fn restart(&mut self) -> Result<(), SetupError> {
        match self.recipe.clone() {
            Some(recipe) => self.play(recipe),
            None => {
                let added = std::mem::take(&mut self.added);
                self.set_out(&self.choice.clone())?;
                added.iter().try_for_each(|(choice, count)| self.add(choice, *count).map(drop))
            }
        }
    }

    /// Carries out a command of the user, which stops the recipe.
    pub fn command(&mut self, command: &Command) -> Result<(), Refused> {
        self.kitchen.apply(command)?;
        self.runner = None;
        if matches!(command, Command::Put { .. }) {
            self.recorder.on_put(&self.kitchen);
        }
        if let Some(label) = label(command) {
            self.mark(label);
        }
        Ok(())
    }

    fn mark(&mut self, label: String) {
        self.recorder.write_row(&self.kitchen);
        self.marks.push(Mark { time_s: self.kitchen.time_s(), label });
    }

    /// Returns the title of the recipe, if one was loaded.
    pub fn recipe_title(&self) -> Option<&str> {
        self.recipe.as_ref().map(|r| r.title.as_str())
    }

    /// Returns the last choice of food and pan.
    pub fn choice(&self) -> &SteakChoice {
        &self.choice
    }
}

#[cfg(test)]
mod tests {
    use web_time::Duration;

    use super::*;

    fn session() -> Session {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        Session::new(library, &SteakChoice::default()).expect("sets out")
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
    }
}
