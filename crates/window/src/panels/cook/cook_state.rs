//! What the controls of the cook read.

use saute_kitchen::advice::coaching::Coaching;
use saute_kitchen::dynamics::Tool;

use crate::host::CurrentHost;
use saute_controls::context::PanelContext;
use saute_controls::input::pouring::Portion;
use saute_controls::reads_context;

/// What the controls of the cook read.
pub struct CookState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// What the window has of the desktop, or of its page.
    pub host: &'a CurrentHost,
    /// The tool that mouse and right stick lead.
    pub tool: Tool,
    /// True while a turner is in the hand.
    pub turner_in_hand: bool,
    /// Portion that is poured at once.
    pub portion: Portion,
    /// The power of the hob that is advised [W].
    pub advised_w: Option<f64>,
    /// What a coach states of the piece; none where the coach is off.
    pub coaching: Option<&'a Coaching>,
    /// True while ways are shown side by side.
    pub side_by_side: bool,
}

reads_context!(CookState);
