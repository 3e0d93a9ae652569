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
    /// Water evaporated from a slab [kg/m²].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evaporated_kg_m2: Option<f64>,
    /// Depth of a slab that has dried [mm].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crust_mm: Option<f64>,
    /// Water evaporated from a body with a volume [g].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evaporated_g: Option<f64>,
    /// Highest temperature of the probe in `report.peak_of` [°C].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub core_peak_c: Option<f64>,
    /// When that was [s].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub core_peak_at_s: Option<f64>,
    /// When each phase ended [s].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub phases_ended_s: Vec<f64>,
    /// Series of the heat flux upwards at probes that tell it: time [s] and flux [W/m²].
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub flux: BTreeMap<String, Vec<[f64; 2]>>,
    /// The run with other flips.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compared: Option<Box<Self>>,
}
