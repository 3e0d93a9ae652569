//! The file format of a lab case, before any check.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::case::body_file::{BodyEntry, MaterialEntry, PanEntry};
use crate::case::boundary_file::{BoundaryEntry, FlipsEntry, PhaseEntry};
use crate::case::expect_file::{ExpectEntry, ProbeEntry};
use crate::case::one_or_more::OneOrMore;
use crate::case::ranges::{DURATION_S, LEAST_INTERVAL, REACHED_C, STEP_FACTOR};
use crate::result::evidence::Evidence;

/// A lab case: plain bodies, their materials and boundaries, the outputs and the expected values.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute lab case")]
pub struct CaseFile {
    /// Name for people.
    pub name: Option<String>,
    /// Duration of the run [s].
    #[schemars(with = "f64", range(min = DURATION_S[0], max = DURATION_S[1]))]
    pub duration_s: Spanned<f64>,
    /// Interval between probe readings [s]; probes are also read at the end. By default they are read at the start and the end only.
    #[schemars(with = "Option<f64>", range(min = DURATION_S[0] * LEAST_INTERVAL))]
    pub output_every_s: Option<Spanned<f64>>,
    /// One body, or a stack of several: `[[body]]`, lowest first. Optional where there is a `[pan]`.
    pub body: Option<OneOrMore<BodyEntry>>,
    /// Material: one `[material]` for all bodies, or one `[[material]]` for each, in the same order.
    #[schemars(with = "Option<OneOrMore<MaterialEntry>>")]
    pub material: Option<Spanned<OneOrMore<MaterialEntry>>>,
    /// A pan below the lowest body, or alone.
    #[schemars(with = "Option<PanEntry>")]
    pub pan: Option<Spanned<PanEntry>>,
    /// Physics and numerical method.
    #[serde(default)]
    pub solver: SolverEntry,
    /// Boundary conditions. A face without one is insulated; a later entry overrides an earlier one.
    #[serde(default)]
    #[schemars(with = "Vec<BoundaryEntry>")]
    pub boundary: Vec<Spanned<BoundaryEntry>>,
    /// Consecutive phases; the boundaries of a phase override those of `[[boundary]]`.
    #[serde(default)]
    #[schemars(with = "Vec<PhaseEntry>")]
    pub phase: Vec<Spanned<PhaseEntry>>,
    /// Times at which the bottom and top boundaries are exchanged.
    #[schemars(with = "Option<FlipsEntry>")]
    pub flips: Option<Spanned<FlipsEntry>>,
    /// Points whose temperature is reported.
    #[serde(default)]
    #[schemars(with = "Vec<ProbeEntry>")]
    pub probe: Vec<Spanned<ProbeEntry>>,
    /// Condition that stops the run before its duration is over.
    pub stop: Option<StopEntry>,
    /// Further outputs.
    #[serde(default)]
    pub report: ReportEntry,
    /// A second run of the case with other flips, for `quantity = "stop_ratio"`.
    pub compare: Option<CompareEntry>,
    /// Source of the expected values.
    pub source: Option<String>,
    /// Kind of evidence for the expected values; every case of `saute validate` states it.
    pub evidence: Option<Evidence>,
    /// Expected values.
    #[serde(default)]
    #[schemars(with = "Vec<ExpectEntry>")]
    pub expect: Vec<Spanned<ExpectEntry>>,
}

/// Physics and numerical method.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolverEntry {
    /// Physics of the body.
    #[serde(default)]
    #[schemars(with = "Physics")]
    pub physics: Option<Spanned<Physics>>,
    /// Rule for the conductances of the mesh.
    #[serde(default)]
    pub rule: RuleEntry,
    /// Factor on the length of every time step [-], for convergence studies.
    #[schemars(with = "Option<f64>", range(min = STEP_FACTOR[0], max = STEP_FACTOR[1]), extend("default" = 1.0))]
    pub step_factor: Option<Spanned<f64>>,
}

/// Physics of the body.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Physics {
    /// Heat conduction, with boiling where the material has water.
    #[default]
    Conduction,
    /// The full food model of the kitchen; needs `food` in the material.
    Cooking,
}

/// Rule for the conductances of the mesh.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum RuleEntry {
    /// Linear shape functions (finite elements).
    #[default]
    ShapeFunctions,
    /// Conductance k · V^(2/3) / length of every edge, with V the mean of both nodes' volumes; heat enters at the nodes on
    /// the face. For comparison.
    Segments,
}

/// Differences of the compared run.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareEntry {
    /// Flips of the compared run.
    #[schemars(with = "FlipsEntry")]
    pub flips: Spanned<FlipsEntry>,
}

/// Stop condition.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StopEntry {
    /// The run stops once every point has reached this temperature at some time [°C].
    #[schemars(with = "f64", range(min = REACHED_C[0], max = REACHED_C[1]))]
    pub when_every_point_has_reached_c: Spanned<f64>,
}

/// Further outputs.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReportEntry {
    /// Temperatures for the share of the volume that has ever exceeded them [°C].
    #[serde(default)]
    #[schemars(with = "Vec<f64>", inner(range(min = REACHED_C[0], max = REACHED_C[1])))]
    pub volume_above_c: Vec<Spanned<f64>>,
    /// Name of the probe whose highest temperature over all steps is reported.
    #[schemars(with = "Option<String>")]
    pub peak_of: Option<Spanned<String>>,
}
