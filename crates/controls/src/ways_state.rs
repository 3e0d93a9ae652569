//! What is read of ways side by side.

use crate::context::PanelContext;
use crate::reads_context;
use saute_session::timeline::WayBeside;
use std::collections::BTreeMap;

/// What is read of ways side by side.
pub struct WaysState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// The ways; none while the scene alone is shown.
    pub ways: Vec<WayBeside<'a>>,
    /// What they are called, by their numbers.
    pub names: BTreeMap<u64, String>,
    /// Place of the cut (−1…1).
    pub cut_at: f64,
}

impl WaysState<'_> {
    /// What a way is called.
    pub fn way_name(&self, way: &WayBeside) -> &str {
        self.names.get(&way.way.id).map_or("", String::as_str)
    }
}

reads_context!(WaysState);
