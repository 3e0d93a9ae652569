//! What the line reads.

use saute_kitchen::advice::Advice;

use crate::context::PanelContext;
use crate::reads_context;
use crate::tutorial::Tutorial;
use saute_session::Forecast;
use saute_session::guided::Guided;
use saute_session::plan::live::Live;
use saute_study::class::rest::is_out;

/// What the line reads.
pub struct NowState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// What to do next with the piece that the panels are about, the most urgent first.
    pub advice: &'a [Advice],
    /// How high the core of resting food still rises, and in how long.
    pub rise: Option<Forecast>,
    /// True if the goal is reached, the food is still in the pan and the coach is on.
    pub alarm: bool,
    /// The cook that follows a plan.
    pub live: Option<&'a Live>,
    /// True while a plan is kept to: its guide alone states what to do.
    pub guide_leads: bool,
    /// The tutorial while it runs.
    pub tutorial: Option<&'a Tutorial>,
    /// True while a card is over the scene.
    pub card_is_open: bool,
}

impl<'a> NowState<'a> {
    /// Returns true while a plan or the tutorial leads, or a lesson or a study waits to be ended.
    pub fn is_led(&self) -> bool {
        self.tutorial.is_some() || self.live.is_some_and(|live| !live.is_closed()) || self.waits_to_end().is_some()
    }

    /// The lesson or the study that waits to be ended: its food is out.
    pub fn waits_to_end(&self) -> Option<&'a Guided> {
        self.guided.filter(|_| is_out(&self.session.kitchen))
    }
}

reads_context!(NowState);
