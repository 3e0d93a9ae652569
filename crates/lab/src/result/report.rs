//! The report of a lab run.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::case::Case;
use crate::case::Shape;

/// The numbers of a lab run, as `saute lab --json` prints them.
#[derive(Clone, Debug, Serialize)]
pub struct LabReport {
    /// Name of the case.
    pub name: String,
    /// Number of nodes of the mesh [-].
    pub nodes: usize,
    /// Number of time steps [-].
    pub steps: usize,
    /// Wall time of the time loop [s].
    pub wall_s: f64,
    /// True for a slab and a pan alone: joules and grams are per m².
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    pub per_m2: bool,
    /// Warnings; empty for a sound run.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
    /// Time at which the stop condition was met [s].
    pub stopped_at_s: Option<f64>,
    /// Series of each probe: time [s] and temperature [°C], including the start.
    pub probes: BTreeMap<String, Vec<[f64; 2]>>,
    /// Share of the volume that has ever exceeded a temperature, by that temperature in °C [%].
    pub volume_pct_above: BTreeMap<String, f64>,
    /// Heat absorbed [J]; of a slab [J/m²].
    pub absorbed_j: f64,
    /// Highest temperature of any node at any time [°C].
    pub max_c: f64,
    /// Lowest temperature of any node at any time [°C].
    pub min_c: f64,
    /// Water evaporated from a slab [kg/m²].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evaporated_kg_m2: Option<f64>,
    /// Dried depth of a slab [mm].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crust_mm: Option<f64>,
    /// Water evaporated from a body with a volume [g].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evaporated_g: Option<f64>,
    /// Juice lost by dripping from a cooked food [g]; of a slab [g/m²].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dripped_g: Option<f64>,
    /// Fat rendered out [g]; of a slab [g/m²].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rendered_g: Option<f64>,
    /// Mass lost [%].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost_pct: Option<f64>,
    /// Contraction of a cooked food's section across the fibres, by area [%].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub section_shrunk_pct: Option<f64>,
    /// Contraction along the fibres, of its mean thickness [%].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness_shrunk_pct: Option<f64>,
    /// Series of the contact with a pan: time [s] and mean conductance [W/(m²·K)].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub contact_w_m2k: Vec<[f64; 2]>,
    /// L*, a*, b* of bottom and top of the cooked food, area means [-]; a sphere has only a top.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub surface_lab: BTreeMap<String, [f64; 3]>,
    /// Highest temperature of the probe in `report.peak_of`, by default of the centre of a cooked food [°C].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub core_peak_c: Option<f64>,
    /// Time of that highest temperature [s].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub core_peak_at_s: Option<f64>,
    /// Times at which the phases ended [s].
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub phases_ended_s: Vec<f64>,
    /// Series of the upward heat flux at the probes with `flux = true`: time [s] and flux [W/m²].
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub flux: BTreeMap<String, Vec<[f64; 2]>>,
    /// Report of the compared run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compared: Option<Box<Self>>,
}

impl LabReport {
    /// Returns a report without results.
    pub(crate) fn empty(case: &Case) -> Self {
        Self {
            name: case.name.clone(),
            nodes: 0,
            steps: 0,
            wall_s: 0.0,
            per_m2: case.shape == Shape::Slab,
            warnings: Vec::new(),
            stopped_at_s: None,
            probes: BTreeMap::new(),
            volume_pct_above: BTreeMap::new(),
            absorbed_j: 0.0,
            max_c: 0.0,
            min_c: 0.0,
            evaporated_kg_m2: None,
            crust_mm: None,
            evaporated_g: None,
            dripped_g: None,
            rendered_g: None,
            lost_pct: None,
            section_shrunk_pct: None,
            thickness_shrunk_pct: None,
            contact_w_m2k: Vec::new(),
            surface_lab: BTreeMap::new(),
            core_peak_c: None,
            core_peak_at_s: None,
            phases_ended_s: Vec::new(),
            flux: BTreeMap::new(),
            compared: None,
        }
    }
}
