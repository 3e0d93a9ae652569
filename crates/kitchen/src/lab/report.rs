//! What a lab run tells.

use std::collections::BTreeMap;

use serde::Serialize;

/// The numbers of a lab run, as `saute lab --json` prints them.
#[derive(Clone, Debug, Serialize)]
pub struct LabReport {
    /// Name of the case.
    pub name: String,
    /// Nodes of the mesh.
    pub nodes: usize,
    /// Steps that were made.
    pub steps: usize,
    /// Wall time of the time loop [s].
    pub wall_s: f64,
    /// When the stop condition was met [s].
    pub stopped_at_s: Option<f64>,
    /// Series of each probe: time [s] and temperature [°C], the start included.
    pub probes: BTreeMap<String, Vec<[f64; 2]>>,
    /// Share of the volume that has ever been above a temperature, by that temperature in °C [%].
    pub volume_pct_above: BTreeMap<String, f64>,
    /// Heat taken up [J]; for a slab per m².
    pub absorbed_j: f64,
    /// Highest temperature of any node at any time [°C].
    pub max_c: f64,
    /// Lowest temperature of any node at any time [°C].
    pub min_c: f64,
}
