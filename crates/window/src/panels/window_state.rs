//! What panels read of the window.

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::Piece;
use saute_kitchen::advice::Advice;
use saute_kitchen::advice::coaching::Coaching;
use saute_kitchen::dynamics::Tool;
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_scene::quality::Quality;

use crate::act::{Act, Card};
use crate::host::Here;
use crate::input::pouring::Portion;
use crate::learn::tutorial::Tutorial;
use crate::mirror::view::MirrorView;
use crate::session::Session;
use crate::settings::Settings;
use crate::ui::notice::{Notice, Said};
use crate::ui::scene_view::SceneView;
use saute_session::Forecast;
use saute_session::at_home::fitting::AtHome;
use saute_session::guided::Guided;
use saute_session::permits::{Permit, Permits};
use saute_session::plan::live::Live;
use saute_session::plan::planning::Planning;
use saute_session::timeline::WayBeside;
use saute_sound::Snapshot;
use saute_words::judgement_words::ResultWords;

/// The window's state as panels read it; what they want changed they say with an [`crate::act::Act`].
pub struct WindowState<'a> {
    /// The world behind the window.
    pub session: &'a Session,
    /// The settings that are remembered.
    pub settings: &'a Settings,
    /// The scene's part of the window.
    pub scene: &'a SceneView,
    /// The half mirror's window.
    pub mirror: &'a MirrorView,
    /// What the window has of the desktop, or of its page.
    pub here: &'a Here,
    /// What was entered about the kitchen at home, and the fit to it.
    pub at_home: &'a AtHome,
    /// The search for a plan.
    pub planning: &'a Planning,
    /// The cook that follows a plan.
    pub live: Option<&'a Live>,
    /// The tool that mouse and right stick lead.
    pub tool: Tool,
    /// True while a turner is in the hand.
    pub turner_in_hand: bool,
    /// Portion that is poured at once.
    pub portion: Portion,
    /// Place of the cut (−1…1), or none.
    pub slice: Option<f64>,
    /// The card that is open.
    pub card: Option<Card>,
    /// The study or the lesson that leads the cook.
    pub guided: Option<&'a Guided>,
    /// What was said so far.
    pub said: &'a Notice,
    /// How far a cook came with which the window offers to go on [s].
    pub unfinished_s: Option<f64>,
    /// True if the system has a font with kana and kanji.
    pub japanese_font: bool,
    /// The quality at which the scene is drawn.
    pub quality: Quality,
    /// What to do next with the piece that the panels are about, the most urgent first.
    pub advice: Vec<Advice>,
    /// True while a plan is kept to: its guide alone states what to do.
    pub guide_leads: bool,
    /// What a coach states of that piece; none where the coach is off.
    pub coaching: Option<Coaching>,
    /// True if the goal is reached, the food is still in the pan and the coach is on.
    pub alarm: bool,
    /// What is heard; none where a study leaves no sound.
    pub heard: Option<Snapshot>,
    /// How high the core of resting food still rises, and in how long.
    pub rise: Option<Forecast>,
    /// The result in words, while its card is open.
    pub result: Option<ResultWords>,
    /// From when the cook is tried again, while its result is shown [s].
    pub try_from_s: Option<f64>,
    /// The tutorial while it runs.
    pub tutorial: Option<&'a Tutorial>,
    /// What was said last, while it is still shown.
    pub notice: Option<Said>,
    /// What waits until the instant is reached to which time is turned.
    pub waiting: Vec<String>,
    /// Ways side by side; none while the scene alone is shown.
    pub ways: Vec<WayBeside<'a>>,
    /// What they are called, by their numbers.
    pub way_names: BTreeMap<u64, String>,
}

impl WindowState<'_> {
    /// Returns true if panels may show readings: temperatures, doneness, curves, forecasts and advice. In skill mode, and where a
    /// study or a lesson hides them, they do not.
    pub fn reads_out(&self) -> bool {
        !self.settings.skill_mode && !self.is_blind()
    }

    /// Returns true while a plan or the tutorial leads.
    pub fn is_led(&self) -> bool {
        self.tutorial.is_some() || self.live.is_some_and(|live| !live.is_closed())
    }

    /// The scale of doneness in whose words the food that the panels show is spoken of.
    pub fn scale(&self) -> Option<Arc<Scale>> {
        self.session.scale(&self.settings.scale)
    }

    /// About how long the whole cook of the shown food takes to its goal [s]; none of food whose doneness is told by something else than
    /// the temperature of its core.
    pub fn whole_time_s(&self) -> Option<f64> {
        let scale = self.scale().filter(|scale| scale.measure() == Measure::Peak)?;
        self.session.whole_time_s(self.settings.goal(&scale))
    }

    /// Returns true if a study or a lesson hides what cannot be seen in a kitchen.
    pub fn is_blind(&self) -> bool {
        !self.permits().allow(&[Permit::ReadOuts])
    }

    /// Returns true if a control is not shown at all: what a study does not let anybody do, and what reads out where read-outs are
    /// hidden. What else a lesson locks is shown as locked: its card names it.
    pub fn hides(&self, act: &Act) -> bool {
        let is_study = matches!(self.guided, Some(Guided::Study(_)));
        self.forbids(act) && (is_study || (self.is_blind() && act.traits().reads))
    }

    /// What a study or a lesson lets a person do.
    pub fn permits(&self) -> Permits {
        self.guided.map(Guided::permits).unwrap_or_default()
    }

    /// Returns true if a study or a lesson does not let a person do something.
    pub fn forbids(&self, act: &Act) -> bool {
        !self.permits().allow(act.traits().needs)
    }

    /// What a way is called.
    pub fn way_name(&self, way: &WayBeside) -> &str {
        self.way_names.get(&way.way.id).map_or("", String::as_str)
    }

    /// The scale in whose words a piece is spoken of.
    pub fn scale_of(&self, piece: &Piece) -> Option<Arc<Scale>> {
        self.session.scales(&self.settings.scale).of(&piece.model).cloned()
    }
}
