//! A cook in the window: the kitchen, its clock, and a recipe that may be playing.

mod choice;
mod mark;

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::advice::{Advice, Goal, Situation};
use saute_kitchen::carry_over::foreseen_peak;
use saute_kitchen::food::Scale;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Command, FRAME_S, Kitchen, Library, Piece, Place, Refused, TICK_S, celsius};
use saute_picture::probe::Probes;
use saute_picture::stage::fitting_piece;
use saute_recipe::{Recipe, Recorder, Runner};
use web_time::{Duration, Instant};

use self::choice::{base_name, orders, set_out};
use self::mark::{label, step_label};

pub use self::choice::{STEAK, SteakChoice, group_of, noun};
pub use self::mark::Mark;

/// Forecast for food that is taken out now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forecast {
    /// Expected core peak [°C].
    pub peak_c: f64,
    /// In how many seconds.
    pub in_s: f64,
}

/// Speeds of simulated time over wall time [-].
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
    /// Points in the food whose temperature is remembered.
    pub probes: Probes,
    /// Events.
    pub marks: Vec<Mark>,
    /// Simulated seconds a wall second.
    pub speed: f64,
    /// True if time stands still.
    pub paused: bool,
    /// Counts worlds: changes with every restart.
    pub generation: u64,
    /// Hands at devices.
    #[cfg(not(target_arch = "wasm32"))]
    pub hands: crate::hand::Hands,
    choice: SteakChoice,
    recipe: Option<Recipe>,
    /// What was set out besides the first choice.
    added: Vec<(SteakChoice, usize)>,
    owed_s: f64,
    selected: Option<String>,
    start_mass_g: BTreeMap<String, f64>,
    forecast: Option<(String, u64, Forecast)>,
}

/// Time closer than this to a whole step counts as reached [s] (chosen: far above rounding, far below a frame).
const SAME_TIME: f64 = 1e-9;

impl Session {
    /// Sets out what was chosen.
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

    /// Remembers what new pieces weigh.
    fn weigh_new(&mut self) {
        for piece in self.kitchen.pieces() {
            self.start_mass_g.entry(piece.id.clone()).or_insert_with(|| 1e3 * piece.mass());
        }
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
            None => {
                let added = std::mem::take(&mut self.added);
                self.set_out(&self.choice.clone())?;
                added.iter().try_for_each(|(choice, count)| self.add(choice, *count).map(drop))
            }
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

    /// The piece that the panels are about: the selected one, else the first.
    pub fn steak(&self) -> Option<&Piece> {
        self.selected().or_else(|| self.kitchen.pieces().first())
    }

    /// The piece that was selected, while it is there.
    pub fn selected(&self) -> Option<&Piece> {
        self.kitchen.piece(self.selected.as_deref()?)
    }

    /// Selects a piece, or none.
    pub fn select(&mut self, id: Option<String>) {
        self.selected = id;
    }

    /// Where the piece of the panels stands among all pieces.
    pub fn steak_index(&self) -> usize {
        let id = self.steak().map(|p| &p.id);
        self.kitchen.pieces().iter().position(|p| Some(&p.id) == id).unwrap_or(0)
    }

    /// Noun for the food in a sentence: "steak", "carrot coin".
    pub fn noun(&self) -> String {
        self.steak().map_or_else(|| STEAK.to_owned(), |p| noun(&self.library, &p.kind))
    }

    /// Its mass when it was set out [g].
    pub fn start_mass_g(&self) -> f64 {
        self.steak().and_then(|p| self.start_mass_g.get(&p.id)).copied().unwrap_or(0.0)
    }

    /// Sets out more food: waiting pieces under one name.
    pub fn add(&mut self, choice: &SteakChoice, count: usize) -> Result<String, SetupError> {
        let group = self.free_name(&base_name(&self.library, &choice.kind));
        for order in orders(&self.library, choice, &group, count) {
            self.kitchen.add(&self.library, &order)?;
        }
        self.weigh_new();
        self.runner = None;
        self.added.push((choice.clone(), count));
        Ok(group)
    }

    /// A group's name that is not taken: the base, or the base with the first free number.
    fn free_name(&self, base: &str) -> String {
        let taken = |name: &str| self.kitchen.pieces().iter().any(|p| group_of(&p.id) == name);
        let numbered = (2..).map(|n| format!("{base}-{n}"));
        std::iter::once(base.to_owned()).chain(numbered).find(|name| !taken(name)).unwrap_or_else(|| base.to_owned())
    }

    /// Takes pieces away altogether.
    pub fn remove(&mut self, ids: &[String]) {
        for id in ids {
            self.kitchen.remove(id);
            self.start_mass_g.remove(id);
        }
        self.runner = None;
    }

    /// Pieces of a group, in their order.
    pub fn members(&self, group: &str) -> Vec<String> {
        let ids = self.kitchen.pieces().iter().map(|p| &p.id);
        ids.filter(|id| group_of(id) == group).cloned().collect()
    }

    /// Id of the piece that the panels are about; that of a steak where there is none.
    pub fn steak_id(&self) -> String {
        self.steak().map_or_else(|| STEAK.to_owned(), |p| p.id.clone())
    }

    /// The group of the piece that the panels are about.
    pub fn its_group(&self) -> Vec<String> {
        self.members(group_of(&self.steak_id()))
    }

    /// All pieces that wait to be put in.
    pub fn waiting(&self) -> Vec<String> {
        self.kitchen.pieces().iter().filter(|p| p.place == Place::Waiting).map(|p| p.id.clone()).collect()
    }

    /// The scale of doneness with an id; where the data has none, the first.
    pub fn chosen_scale(&self, id: &str) -> Option<&Arc<Scale>> {
        self.library.scale(id).or_else(|| self.library.scales.first())
    }

    /// The chosen scale, where it says anything about the piece that the panels are about.
    pub fn scale(&self, id: &str) -> Option<Arc<Scale>> {
        fitting_piece(self.steak(), self.chosen_scale(id)?)
    }

    /// What to do next with the piece that the panels are about, with a goal for its core [°C] where a scale of
    /// doneness says anything about it.
    pub fn advice(&mut self, goal_c: Option<f64>) -> Option<Advice> {
        let foreseen = goal_c.and_then(|_| self.forecast());
        let goal = goal_c.zip(foreseen).map(|(core_c, f)| Goal { core_c, foreseen_c: f.peak_c });
        Situation::of(&self.kitchen, self.steak()?).advice(goal)
    }

    /// Lays pieces that are not in the pan onto its floor, side by side, as many as fit; returns how many.
    pub fn lay(&mut self, ids: &[String]) -> Result<usize, Refused> {
        let places = self.kitchen.free_places(ids, [0.0, 0.0]);
        for (food, at) in ids.iter().zip(&places) {
            self.command(&Command::Put { food: food.clone(), at: *at, heap: false })?;
        }
        Ok(places.len())
    }

    /// Drops pieces into the pan in a loose heap.
    pub fn heap(&mut self, ids: &[String]) -> Result<(), Refused> {
        let floor = self.kitchen.world().pan_shape().floor;
        for (k, food) in ids.iter().enumerate() {
            let at = on_spiral(k, ids.len(), HEAP_SHARE * floor);
            self.command(&Command::Put { food: food.clone(), at, heap: true })?;
        }
        Ok(())
    }

    /// Carries out a person's command: from then on the recipe no longer plays.
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

    /// Lets `wall` pass, stepping for no longer than `budget`; what was not reached stays owed.
    ///
    /// Returns a recipe's error if one came up; the recipe then stops playing.
    pub fn advance(&mut self, wall: Duration, budget: Duration) -> Result<(), String> {
        if self.paused {
            return Ok(());
        }
        self.owed_s += wall.as_secs_f64() * self.speed;
        let start = Instant::now();
        // At the pace of a wall clock every frame is shown; faster, only ticks are.
        let step = if self.speed > 1.0 { TICK_S } else { FRAME_S };
        while self.owed_s >= step - SAME_TIME && start.elapsed() < budget {
            let before = self.kitchen.time_s();
            if self.speed > 1.0 {
                self.tick()?
            } else {
                self.frame().map(drop)?
            };
            self.owed_s -= self.kitchen.time_s() - before;
            if self.paused {
                break;
            }
        }
        Ok(())
    }

    /// To the end of the tick, with the recipe's steps that are due.
    pub fn tick(&mut self) -> Result<(), String> {
        while !self.frame()? {}
        Ok(())
    }

    /// One frame; at the start of a tick with the recipe's steps that are due. Returns true if a tick, or the recipe,
    /// has ended.
    fn frame(&mut self) -> Result<bool, String> {
        if self.kitchen.is_between_ticks() && !self.poll()? {
            return Ok(true);
        }
        #[cfg(not(target_arch = "wasm32"))]
        self.hands.lead(&mut self.kitchen);
        let ticked = self.kitchen.advance_frame();
        // Faster than the clock no force is true: then forces fade.
        #[cfg(not(target_arch = "wasm32"))]
        if self.speed == 1.0 {
            self.hands.send(&self.kitchen);
        }
        if ticked {
            self.recorder.observe(&self.kitchen);
            self.probes.observe(&self.kitchen);
        }
        Ok(ticked)
    }

    /// Lets the recipe do what is due; returns true if time goes on.
    fn poll(&mut self) -> Result<bool, String> {
        let Some(mut runner) = self.runner.take() else { return Ok(true) };
        let fired = runner.poll(&mut self.kitchen).map_err(|e| e.to_string())?;
        self.recorder.on_steps(&self.kitchen, &fired);
        let time_s = self.kitchen.time_s();
        self.marks.extend(fired.iter().map(|step| Mark { time_s, label: step_label(step) }));
        if runner.stopped().is_some() {
            self.paused = true;
            self.owed_s = 0.0;
            return Ok(false);
        }
        self.runner = Some(runner);
        Ok(true)
    }

    /// Sets the speed; time owed at another speed is dropped.
    pub fn set_speed(&mut self, speed: f64) {
        self.speed = speed;
        self.owed_s = 0.0;
    }

    /// Stops or goes on.
    pub fn set_paused(&mut self, paused: bool) {
        self.paused = paused;
        self.owed_s = 0.0;
    }

    /// Lag behind the chosen speed [simulated s]; none while it is not noticeable.
    pub fn behind_s(&self) -> Option<f64> {
        (self.owed_s > LATE_AFTER_S * self.speed).then_some(self.owed_s)
    }

    /// What would happen if the food were taken out now; computed once every simulated second.
    pub fn forecast(&mut self) -> Option<Forecast> {
        let piece = self.steak().filter(|p| p.in_pan())?;
        let second = self.kitchen.tick() / 10;
        if self.forecast.as_ref().is_none_or(|(id, at, _)| *at != second || *id != piece.id) {
            let (peak, in_s) = foreseen_peak(&piece.model, &piece.state, self.kitchen.room());
            self.forecast = Some((piece.id.clone(), second, Forecast { peak_c: celsius(peak), in_s }));
        }
        self.forecast.as_ref().map(|(.., f)| *f)
    }
}

/// Share of the floor's radius over which a heap is dropped [-] (chosen: clear of the wall).
const HEAP_SHARE: f64 = 0.62;

/// Places spread evenly over a disc, the first in its middle [m].
fn on_spiral(k: usize, count: usize, radius: f64) -> [f64; 2] {
    /// The golden angle [rad]: no two turns of the spiral meet.
    const TURN: f64 = 2.399_963_229_728_653;
    let (share, angle) = ((k as f64 / count.max(1) as f64).sqrt(), TURN * k as f64);
    [radius * share * angle.cos(), radius * share * angle.sin()]
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
