//! Settings that are remembered from one start to the next.

pub mod interface_size;
pub mod plan_choice;
pub mod quality_choice;
mod remembered;
#[cfg(not(target_arch = "wasm32"))]
pub mod stored_zoom;
pub mod theme;
mod wanted_plan;

use std::collections::BTreeMap;

use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::food::Scale;
use saute_picture::colour::map::TemperatureMap;
use saute_picture::view::View;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;

use self::interface_size::InterfaceSize;
use self::plan_choice::PlanChoice;
use self::quality_choice::QualityChoice;
use self::theme::Theme;
use saute_mirror::settings::MirrorSettings;
use saute_session::FoodChoice;
use saute_session::at_home::kept::KeptKitchen;
use saute_words::language::Language;
use saute_words::speech::Speech;

/// Version of remembered settings: since 1 the goal is 62 °C at first, before it was 60 °C.
pub const VERSION: u32 = 1;
/// The speed that gives way to a hand [-] (chosen: a steak of twelve minutes takes four, and a pan still answers at once).
pub const EASED: f64 = 5.0;
/// Volume at first [-] (chosen: −12 dB, modest).
const VOLUME: f64 = 0.5;
/// Marks of one goal that are kept (chosen: a month of steaks).
const MOST_MARKS: usize = 30;
/// The first goal for the core, and that of version 0 [°C].
const GOAL_C: f64 = 62.0;
const GOAL_C_0: f64 = 60.0;

/// Remembered settings.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(default)]
pub struct Settings {
    /// Version of what is remembered ([`VERSION`]); 0 where none is stated.
    #[serde(default)]
    pub version: u32,
    /// Language of the window; that of the system where none was ever chosen.
    pub language: Language,
    /// Dark or light panels.
    pub theme: Theme,
    /// Size of the interface.
    pub size: InterfaceSize,
    /// True if what glides jumps; as the system states unless it was chosen.
    pub less_motion: Option<bool>,
    /// White balance of the look.
    pub white_balance: WhiteBalance,
    /// Light of the room.
    pub light: RoomLight,
    /// Rendering quality.
    pub quality: QualityChoice,
    /// True if the card of the first start was closed.
    pub introduced: bool,
    /// Show °F instead of °C.
    pub fahrenheit: bool,
    /// Colour map of temperatures.
    pub map: TemperatureMap,
    /// View that the colours show.
    pub view: View,
    /// True if the look is shown next to the view.
    pub split: bool,
    /// Id of the scale of doneness.
    pub scale: String,
    /// Simulated seconds a wall second that were chosen.
    pub speed: f64,
    /// Those to which the machine gave way, if it did.
    pub held_speed: Option<f64>,
    /// True if time slows to that of a kitchen where a hand is needed.
    pub eases: bool,
    /// The food and the pan.
    pub choice: FoodChoice,
    /// The request for a plan.
    pub plan: PlanChoice,
    /// The kitchen at home that was found.
    pub kitchen: Option<KeptKitchen>,
    /// Goal for the core's peak of food whose scale states no goal [°C]: at first medium.
    pub goal_c: f64,
    /// Goals for the core by the ids of the scales that state one, in the unit of the scale [°C or %].
    pub goals: BTreeMap<String, f64>,
    /// Id of the goal that a cook is judged by; none for the class that the goal of the core is in.
    pub goal_id: Option<String>,
    /// Marks of cooks by their goals, the last at the end [points].
    pub marks: BTreeMap<String, Vec<f64>>,
    /// True if the coach states what happens, what to perceive next, and when the goal is reached.
    pub coach: bool,
    /// True if the result opens by itself when the food has rested.
    pub result_opens: bool,
    /// True if all read-outs are hidden while one cooks.
    pub skill_mode: bool,
    /// True if the panel with the food's choices is open.
    pub pantry_open: bool,
    /// True if the list of the pieces is open.
    pub pieces_open: bool,
    /// True if the curves and all readings are shown.
    pub curves_open: bool,
    /// True if all panels are hidden.
    pub panels_hidden: bool,
    /// True while the kitchen is shown to a class before a projector: without panels, at the largest size.
    #[serde(skip)]
    pub projector: bool,
    /// True if only the few controls are shown that a first cook needs.
    pub few: bool,
    /// True if forecasts are made.
    pub forecasts: bool,
    /// Recipes that were opened from files, the last one first.
    pub recent: Vec<std::path::PathBuf>,
    /// The half mirror.
    pub mirror: MirrorSettings,
    /// True if the pan is heard.
    pub sound: bool,
    /// Volume, from 0 to 1 [-].
    pub volume: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: VERSION,
            language: Language::ENGLISH,
            theme: Theme::default(),
            size: InterfaceSize::default(),
            less_motion: None,
            white_balance: WhiteBalance::default(),
            light: RoomLight::default(),
            quality: QualityChoice::default(),
            introduced: false,
            fahrenheit: false,
            map: TemperatureMap::default(),
            view: View::default(),
            split: false,
            scale: DEFAULT_SCALE.to_owned(),
            speed: 1.0,
            held_speed: None,
            eases: false,
            choice: FoodChoice::default(),
            plan: PlanChoice::default(),
            kitchen: None,
            goal_c: GOAL_C,
            goals: BTreeMap::new(),
            goal_id: None,
            marks: BTreeMap::new(),
            coach: true,
            result_opens: true,
            skill_mode: false,
            pantry_open: false,
            pieces_open: false,
            curves_open: false,
            panels_hidden: false,
            projector: false,
            few: false,
            forecasts: true,
            recent: Vec::new(),
            mirror: MirrorSettings::default(),
            sound: true,
            volume: VOLUME,
        }
    }
}

impl Settings {
    /// Brings settings of an earlier version up to date: a goal that was never chosen is the present first one.
    pub fn up_to_date(mut self) -> Self {
        if self.version < 1 && self.goal_c == GOAL_C_0 {
            self.goal_c = GOAL_C;
        }
        self.version = VERSION;
        self
    }

    /// Settings of somebody's first visit: few controls, and time that is fast but waits for a hand.
    pub fn of_first_visit(self) -> Self {
        let plan = PlanChoice { plain: true, ..self.plan.clone() };
        Self { few: true, eases: true, speed: EASED, plan, ..self }
    }

    /// The speed to begin with: the chosen one, or what the machine sustained of it [-].
    pub fn first_speed(&self) -> f64 {
        self.speed.min(self.held_speed.unwrap_or(self.speed))
    }

    /// Returns true if no panel is shown.
    pub fn hides_panels(&self) -> bool {
        self.panels_hidden || self.projector
    }

    /// Hides all panels or shows them, also to a class.
    pub fn toggle_panels(&mut self) {
        (self.panels_hidden, self.projector) = (!self.hides_panels(), false);
    }

    /// Returns true if forecasts are enabled: in skill mode nothing is read out.
    pub fn foresees(&self) -> bool {
        self.forecasts && !self.skill_mode
    }

    /// Keeps a mark of a goal; as many are kept as show a trend.
    pub fn keep_mark(&mut self, goal: &str, mark: f64) {
        let marks = self.marks.entry(goal.to_owned()).or_default();
        marks.push(mark);
        // The best stays the best: the worst of the earlier ones goes.
        if marks.len() > MOST_MARKS {
            let worst = (0..marks.len() - 1).min_by(|a, b| marks[*a].total_cmp(&marks[*b]));
            worst.map(|place| marks.remove(place));
        }
    }

    /// Returns the goal for the core by a scale, in its unit [°C or %].
    pub fn goal(&self, scale: &Scale) -> f64 {
        scale.goal.map_or(self.goal_c, |own| self.goals.get(&scale.id).copied().unwrap_or(own))
    }

    /// Keeps a goal for the core by a scale, in its unit [°C or %].
    pub fn set_goal(&mut self, scale: &Scale, goal: f64) {
        match scale.goal {
            Some(_) => drop(self.goals.insert(scale.id.clone(), goal)),
            None => self.goal_c = goal,
        }
    }

    /// Returns true if the look and a view of a field are shown side by side.
    pub fn is_split(&self) -> bool {
        self.split && self.view != View::Look
    }

    /// Language and unit of the texts for the user.
    pub fn speech(&self) -> Speech {
        Speech { language: self.language, fahrenheit: self.fahrenheit }
    }

    /// A temperature in the chosen unit, with its unit, never broken over two lines.
    pub fn temperature(&self, celsius: f64) -> String {
        self.speech().temperature(celsius)
    }

    /// As [`Self::temperature`], to a tenth.
    pub fn fine_temperature(&self, celsius: f64) -> String {
        self.speech().fine_temperature(celsius)
    }

    /// A temperature in the chosen unit.
    pub fn degrees(&self, celsius: f64) -> f64 {
        self.speech().degrees(celsius)
    }

    /// °C from the chosen unit.
    pub fn celsius(&self, degrees: f64) -> f64 {
        self.speech().celsius(degrees)
    }

    /// The chosen unit.
    pub fn unit(&self) -> &'static str {
        self.speech().unit()
    }
}
