//! What the card of plans reads.

use crate::context::PanelContext;
use crate::reads_context;
use saute_session::plan::planning::Planning;

/// What the card of plans reads.
pub struct PlanState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// The search for a plan.
    pub planning: &'a Planning,
}

reads_context!(PlanState);

impl PlanState<'_> {
    /// Returns true if the plan of the food, the pan and the target that are chosen now was found.
    pub fn has_plan(&self) -> bool {
        let now = || self.settings.wanted_plan(&self.session.library);
        self.planning.plan().is_some() && self.planning.asked().is_some_and(|asked| *asked == now())
    }
}
