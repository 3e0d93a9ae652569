//! What the card of the kitchen at home reads.

use saute_controls::context::PanelContext;
use saute_controls::reads_context;
use saute_session::at_home::fitting::AtHome;

/// What the card of the kitchen at home reads.
pub struct AtHomeState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// What was entered about the kitchen at home, and the fit to it.
    pub at_home: &'a AtHome,
}

reads_context!(AtHomeState);
