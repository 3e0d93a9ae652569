//! A cook in the window: the kitchen, its clock, and a recipe that may be playing.

use std::sync::Arc;

use saute_kitchen::carry_over::foreseen_peak;
use saute_kitchen::food::Form;
use saute_kitchen::food::Rules;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Command, Kitchen, Library, PieceOrder, Recipe, Recorder, Runner, TICK_S, celsius, kelvin};
use web_time::{Duration, Instant};

/// What the person chooses before putting the food in.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(default)]
pub struct SteakChoice {
    /// Id of the food.
    pub kind: String,
    /// Its dimensions: those of its form [mm].
    pub size_mm: Vec<f64>,
    /// Start temperature [°C].
    pub initial_c: f64,
    /// Id of the pan.
    pub pan: String,
    /// Temperature to which the pan is preheated [°C]; room temperature starts cold.
    pub preheat_c: f64,
}

impl Default for SteakChoice {
    fn default() -> Self {
        Self {
            kind: "beef-lean".into(),
            size_mm: vec![120.0, 80.0, 25.0],
            initial_c: 5.0,
            pan: "carbon-steel-26".into(),
            preheat_c: 20.0,
        }
    }
}

/// Name of a steak that the window sets out; another food bears the name of its kind.
pub const STEAK: &str = "steak";

/// Something that happened, for the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub label: String,
}

/// What would happen if the food were taken out now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forecast {
    /// Expected core peak [°C].
    pub peak_c: f64,
    /// In how many seconds.
    pub in_s: f64,
}

/// How fast simulated time runs [-].
pub const SPEEDS: [f64; 3] = [1.0, 5.0, 20.0];
/// Simulated time owed beyond which the machine counts as too slow, as wall time at the chosen speed [s] (chosen).
const LATE_AFTER_S: f64 = 0.4;

/// The world behind the window.
pub struct Session {
    /// Everything that can be built.
    pub library: Arc<Library>,
    /// The world.
    pub kitchen: Kitchen,
    /// The recipe that plays, until a person takes over.
    pub runner: Option<Runner>,
    /// Series for the plot.
    pub recorder: Recorder,
    /// What happened.
    pub marks: Vec<Mark>,
    /// Simulated seconds a wall second.
    pub speed: f64,
    /// Whether time stands still.
    pub paused: bool,
    /// Counts worlds: changes with every restart.
    pub generation: u64,
    choice: SteakChoice,
    recipe: Option<Recipe>,
    owed_s: f64,
    start_mass_g: f64,
    forecast: Option<(u64, Forecast)>,
}

impl Session {
    /// Sets out what was chosen.
    pub fn new(library: Arc<Library>, choice: &SteakChoice) -> Result<Self, SetupError> {
        let kitchen = set_out(&library, choice)?;
        let mut session = Self {
            library,
            kitchen,
            runner: None,
            recorder: Recorder::default(),
            marks: Vec::new(),
            speed: 1.0,
            paused: false,
            generation: 0,
            choice: choice.clone(),
            recipe: None,
            owed_s: 0.0,
            start_mass_g: 0.0,
            forecast: None,
        };
        session.begin();
        Ok(session)
    }

    fn begin(&mut self) {
        self.recorder = Recorder::default();
        self.recorder.observe(&self.kitchen);
        self.marks.clear();
        self.owed_s = 0.0;
        self.forecast = None;
        self.generation += 1;
        self.start_mass_g = self.kitchen.pieces().first().map_or(0.0, |p| 1e3 * p.mass());
    }

    /// Starts over with a choice.
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

    /// Starts the same recipe or choice over.
    pub fn restart(&mut self) -> Result<(), SetupError> {
        match self.recipe.clone() {
            Some(recipe) => self.play(recipe),
            None => self.set_out(&self.choice.clone()),
        }
    }

    /// Title of the recipe that was loaded, if any.
    pub fn recipe_title(&self) -> Option<&str> {
        self.recipe.as_ref().map(|r| r.title.as_str())
    }

    /// What the person chose last.
    pub fn choice(&self) -> &SteakChoice {
        &self.choice
    }

    /// The first piece.
    pub fn steak(&self) -> Option<&saute_kitchen::Piece> {
        self.kitchen.pieces().first()
    }

    /// What the food is called in a sentence: "steak", "carrot coin".
    pub fn noun(&self) -> String {
        self.steak().map_or_else(|| STEAK.to_owned(), |p| noun(&self.library, &p.kind))
    }

    /// Its mass when it was set out [g].
    pub fn start_mass_g(&self) -> f64 {
        self.start_mass_g
    }

    /// Carries out a person's command: from then on the recipe no longer plays.
    pub fn command(&mut self, command: &Command) -> Result<(), String> {
        self.kitchen.apply(command).map_err(|refused| refused.to_string())?;
        self.runner = None;
        if matches!(command, Command::Put { .. }) {
            self.recorder.on_put(&self.kitchen);
        }
        self.mark(label(command));
        Ok(())
    }

    fn mark(&mut self, label: String) {
        self.recorder.write_row(&self.kitchen);
        self.marks.push(Mark { time_s: self.kitchen.time_s(), label });
    }

    /// Lets `wall` pass, stepping for no longer than `budget`; what was not reached stays owed.
    ///
    /// Returns a recipe's error if one came up; the recipe then stops playing.
    pub fn advance(&mut self, wall: Duration, budget: Duration) -> Result<(), String> {
        if self.paused {
            return Ok(());
        }
        self.owed_s += wall.as_secs_f64() * self.speed;
        let start = Instant::now();
        while self.owed_s >= TICK_S && start.elapsed() < budget {
            self.tick()?;
            self.owed_s -= TICK_S;
            if self.paused {
                break;
            }
        }
        Ok(())
    }

    /// One tick, with the recipe's steps that are due.
    pub fn tick(&mut self) -> Result<(), String> {
        if let Some(mut runner) = self.runner.take() {
            let fired = runner.poll(&mut self.kitchen).map_err(|e| e.to_string())?;
            self.recorder.on_steps(&self.kitchen, &fired);
            let time_s = self.kitchen.time_s();
            self.marks.extend(fired.iter().map(|step| Mark { time_s, label: step_label(step) }));
            if runner.stopped().is_some() {
                self.paused = true;
                self.owed_s = 0.0;
                return Ok(());
            }
            self.runner = Some(runner);
        }
        self.kitchen.step();
        self.recorder.observe(&self.kitchen);
        Ok(())
    }

    /// Chooses a speed; time owed at another speed is no longer asked for.
    pub fn set_speed(&mut self, speed: f64) {
        self.speed = speed;
        self.owed_s = 0.0;
    }

    /// Stops or goes on.
    pub fn set_paused(&mut self, paused: bool) {
        self.paused = paused;
        self.owed_s = 0.0;
    }

    /// How far the picture lags behind the chosen speed, if noticeably [simulated s].
    pub fn behind_s(&self) -> Option<f64> {
        (self.owed_s > LATE_AFTER_S * self.speed).then_some(self.owed_s)
    }

    /// What would happen if the food were taken out now; reckoned anew every simulated second.
    pub fn forecast(&mut self) -> Option<Forecast> {
        let piece = self.kitchen.pieces().first()?;
        if !piece.in_pan() {
            return None;
        }
        let second = self.kitchen.tick() / 10;
        if self.forecast.is_none_or(|(at, _)| at != second) {
            let (peak, in_s) = foreseen_peak(&piece.model, &piece.state, self.kitchen.room());
            self.forecast = Some((second, Forecast { peak_c: celsius(peak), in_s }));
        }
        self.forecast.map(|(_, f)| f)
    }
}

/// What a kind of food is called in a sentence.
pub fn noun(library: &Library, kind: &str) -> String {
    let name = library.foods.get(kind).map_or(kind, |f| f.name.as_str()).to_lowercase();
    if name.contains(STEAK) { STEAK.to_owned() } else { name }
}

fn set_out(library: &Library, choice: &SteakChoice) -> Result<Kitchen, SetupError> {
    let mut kitchen = Kitchen::new(library, &choice.pan, kelvin(choice.preheat_c))?;
    let food = library.foods.get(&choice.kind);
    let form = food.map_or(Form::Steak, |f| f.form);
    let default = || food.and_then(|f| form.extent(&f.size.default_mm)).unwrap_or_default();
    let size = form.extent(&choice.size_mm).unwrap_or_else(default);
    let is_steak = noun(library, &choice.kind) == STEAK;
    let order = PieceOrder {
        id: if is_steak { STEAK.into() } else { choice.kind.clone() },
        kind: choice.kind.clone(),
        size: size.map(|mm| mm * 1e-3),
        temperature: kelvin(choice.initial_c),
        seed: 1,
        coarseness: 1.0,
        rules: Rules::Full,
    };
    kitchen.add(library, &order)?;
    Ok(kitchen)
}

fn label(command: &Command) -> String {
    match command {
        Command::Hob(w) => format!("{w:.0} W"),
        Command::Put { .. } => "in".into(),
        Command::Flip { .. } => "flip".into(),
        Command::Rest { .. } => "out".into(),
        Command::MovePan { .. } => "pan".into(),
        Command::Cool { .. } => "cloth".into(),
    }
}

fn step_label(step: &saute_kitchen::Fired) -> String {
    match step.action {
        "hob_w" => format!("{:.0} W", step.value.as_f64().unwrap_or(0.0)),
        "put" => "in".into(),
        "rest" => "out".into(),
        "move_pan" => "pan".into(),
        "cool" => "cloth".into(),
        other => other.into(),
    }
}

#[cfg(test)]
mod tests {
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
