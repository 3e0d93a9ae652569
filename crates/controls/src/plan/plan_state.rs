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
