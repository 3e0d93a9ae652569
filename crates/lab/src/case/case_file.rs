//! The format of a lab case as it is written, before anything is checked.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::case::one_or_more::OneOrMore;

/// A plain body, its material, its boundaries, and what is to be told.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute lab case")]
pub struct CaseFile {
    /// Name for people.
    pub name: Option<String>,
    /// How long [s].
    #[schemars(with = "f64")]
    pub duration_s: Spanned<f64>,
    /// Probes are read this often, and at the end [s]; only at the start and the end by default.
    #[schemars(with = "Option<f64>")]
    pub output_every_s: Option<Spanned<f64>>,
    /// The body, or several stacked upwards: `[[body]]`, lowest first. May be left out where there is a `[pan]`.
    pub body: Option<OneOrMore<BodyEntry>>,
    /// What it is made of: one `[material]` for all bodies, or one `[[material]]` for each, in the same order.
    #[schemars(with = "Option<OneOrMore<MaterialEntry>>")]
    pub material: Option<Spanned<OneOrMore<MaterialEntry>>>,
    /// A pan below the lowest body, or alone.
    #[schemars(with = "Option<PanEntry>")]
    pub pan: Option<Spanned<PanEntry>>,
    /// How it is computed.
    #[serde(default)]
    pub solver: SolverEntry,
    /// Boundaries; a face without one is insulated, a later entry overrides an earlier one.
    #[serde(default)]
    #[schemars(with = "Vec<BoundaryEntry>")]
    pub boundary: Vec<Spanned<BoundaryEntry>>,
    /// Boundaries that follow one another; each overrides those that always hold.
    #[serde(default)]
    #[schemars(with = "Vec<PhaseEntry>")]
    pub phase: Vec<Spanned<PhaseEntry>>,
    /// When bottom and top change places.
    #[schemars(with = "Option<FlipsEntry>")]
    pub flips: Option<Spanned<FlipsEntry>>,
    /// Points whose temperature is told.
    #[serde(default)]
    #[schemars(with = "Vec<ProbeEntry>")]
    pub probe: Vec<Spanned<ProbeEntry>>,
    /// When to stop before the duration is over.
    pub stop: Option<StopEntry>,
    /// What else is told.
    #[serde(default)]
    pub report: ReportEntry,
    /// Runs the case a second time with other flips, for `quantity = "stop_ratio"`.
    pub compare: Option<CompareEntry>,
    /// Where the expected values come from.
    pub source: Option<String>,
    /// What should come out.
    #[serde(default)]
    #[schemars(with = "Vec<ExpectEntry>")]
    pub expect: Vec<Spanned<ExpectEntry>>,
}

/// Quantities that can be expected.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Temperature of a probe [°C].
    Probe,
    /// When the stop condition was met [s].
    StoppedAt,
    /// Heat taken up [J], for a slab per m².
    Absorbed,
    /// Highest temperature of any node at any time [°C].
    Max,
    /// Lowest temperature of any node at any time [°C].
    Min,
    /// Heat flux upwards at a probe that has `flux = true` [W/m²].
    Flux,
    /// Water evaporated, of a slab [kg/m²].
    EvaporatedKgM2,
    /// Water evaporated, of a body with a volume [g].
    EvaporatedG,
    /// Depth that has dried, of a slab [mm].
    CrustMm,
    /// Highest temperature of the probe named in `report.peak_of` [°C].
    CorePeak,
    /// When that was [s].
    CorePeakAt,
    /// When the first phase ended [s].
    FirstPhaseEnded,
    /// When the compared run stopped over when this one did [-].
    StopRatio,
    /// Juice that ran off [g].
    DrippedG,
    /// Mass lost [%].
    LostPct,
    /// Contraction of the section across the fibres, by area [%].
    SectionShrunkPct,
    /// Contraction along the fibres, of the thickness [%].
    ThicknessShrunkPct,
    /// Highest conductance of the contact with a pan [W/(m²·K)].
    ContactHighest,
    /// When it was highest [s].
    ContactHighestAt,
    /// Last conductance of the contact with a pan [W/(m²·K)].
    ContactLast,
    /// Lowest conductance of the contact with a pan [W/(m²·K)].
    ContactLowest,
}

impl Quantity {
    /// Whether it is the temperature of a probe.
    pub fn is_temperature(self) -> bool {
        self == Self::Probe
    }
}

/// An expected value, with exactly one of `tolerance` and `tolerance_pct`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExpectEntry {
    /// Which quantity.
    pub quantity: Quantity,
    /// Which probe, for `quantity = "probe"` and `"flux"`.
    pub probe: Option<String>,
    /// When, for a probe [s].
    pub at_s: Option<f64>,
    /// Expected value, in the quantity's unit.
    pub value: f64,
    /// Largest departure, in the quantity's unit.
    pub tolerance: Option<f64>,
    /// Largest departure over the value [%].
    pub tolerance_pct: Option<f64>,
}

/// Shapes of bodies.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Shape {
    /// `size_mm` = [x, y, z]; the origin is a corner.
    Box,
    /// `size_mm` = [diameter, height]; the origin is the centre of the bottom.
    Cylinder,
    /// `size_mm` = [diameter]; the origin is the centre.
    Sphere,
    /// `size_mm` = [thickness]; infinite across; the origin is on the bottom.
    Slab,
}

/// The body.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Shape.
    pub shape: Shape,
    /// Sizes [mm].
    #[schemars(with = "Vec<f64>")]
    pub size_mm: Spanned<Vec<f64>>,
    /// Largest node spacing [mm], or one for each axis in the order of `size_mm`. A single number holds along the longest
    /// axis, and a shorter one gets finer by the square root of the sizes' ratio, at most twice as fine. The mesh is finer towards the faces.
    #[schemars(with = "Option<OneOrMore<f64>>")]
    pub resolution_mm: Option<Spanned<OneOrMore<f64>>>,
    /// How much finer the mesh is towards the faces [-]: 0 even, 1 (the default) 0.42 of the largest spacing, 2 a
    /// fourteenth.
    #[schemars(with = "Option<f64>")]
    pub grading: Option<Spanned<f64>>,
    /// Start temperature [°C].
    #[schemars(with = "f64")]
    pub initial_c: Spanned<f64>,
    /// Conductance of the contact with the body or pan below [W/(m²·K)]; perfect by default.
    #[schemars(with = "Option<f64>")]
    pub contact_h_w_m2k: Option<Spanned<f64>>,
}

/// A plate of even temperature under the lowest body, heated evenly from below; it has the body's footprint.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PanEntry {
    /// Id of a pan, for the thickness of its floor and its metal.
    #[schemars(with = "Option<String>")]
    pub kind: Option<Spanned<String>>,
    /// Thickness [mm].
    #[schemars(with = "Option<f64>")]
    pub thickness_mm: Option<Spanned<f64>>,
    /// Thermal conductivity [W/(m·K)]; an evenly heated plate does without.
    #[schemars(with = "Option<f64>")]
    pub conductivity_w_mk: Option<Spanned<f64>>,
    /// Density [kg/m³].
    #[schemars(with = "Option<f64>")]
    pub density_kg_m3: Option<Spanned<f64>>,
    /// Specific heat [J/(kg·K)].
    #[schemars(with = "Option<f64>")]
    pub specific_heat_j_kgk: Option<Spanned<f64>>,
    /// Heat that it is given [W/m²]; none by default.
    #[schemars(with = "Option<f64>")]
    pub q_w_m2: Option<Spanned<f64>>,
    /// Heat transfer coefficient of its losses [W/(m²·K)]; none by default.
    #[schemars(with = "Option<f64>")]
    pub h_w_m2k: Option<Spanned<f64>>,
    /// Temperature that it loses heat to [°C]; its own at the start by default.
    #[schemars(with = "Option<f64>")]
    pub ambient_c: Option<Spanned<f64>>,
    /// Start temperature [°C].
    #[schemars(with = "f64")]
    pub initial_c: Spanned<f64>,
}

/// How a case is computed.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolverEntry {
    /// What happens in the body.
    #[serde(default)]
    #[schemars(with = "Physics")]
    pub physics: Option<Spanned<Physics>>,
    /// What makes conductances of the mesh.
    #[serde(default)]
    pub rule: RuleEntry,
    /// Every time step is this many times as long as it would be [-]: to see what a step costs and brings.
    #[schemars(with = "Option<f64>")]
    pub step_factor: Option<Spanned<f64>>,
}

/// What happens in the body.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Physics {
    /// Heat is conducted; water boils away where the material says so.
    #[default]
    Conduction,
    /// All that a kitchen knows of a food; needs `food` in the material.
    Cooking,
}

/// What makes conductances of the mesh.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum RuleEntry {
    /// Linear shape functions.
    #[default]
    ShapeFunctions,
    /// Along every edge k · V^(2/3) / length, V the mean of both nodes' volumes; heat enters at the nodes on the face. For
    /// comparison.
    Segments,
}

/// A time with boundaries of its own. The last one lasts until the end.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PhaseEntry {
    /// When it ends; left out in the last.
    #[schemars(with = "Option<UntilEntry>")]
    pub until: Option<Spanned<UntilEntry>>,
    /// Boundaries in place of those that always hold.
    #[serde(default)]
    #[schemars(with = "Vec<BoundaryEntry>")]
    pub boundary: Vec<Spanned<BoundaryEntry>>,
}

/// The end of a phase: a time, or a probe's temperature on its way up or down.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UntilEntry {
    /// At this time [s].
    pub at_s: Option<f64>,
    /// Which probe.
    pub probe: Option<String>,
    /// Temperature that it reaches [°C].
    pub reaches_c: Option<f64>,
}

/// What the compared run does otherwise.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareEntry {
    /// Its flips.
    #[schemars(with = "FlipsEntry")]
    pub flips: Spanned<FlipsEntry>,
}

/// The material: three constants, or a food. Constants may be joined by water that boils.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialEntry {
    /// Thermal conductivity [W/(m·K)].
    #[schemars(with = "Option<f64>")]
    pub conductivity_w_mk: Option<Spanned<f64>>,
    /// Density [kg/m³].
    #[schemars(with = "Option<f64>")]
    pub density_kg_m3: Option<Spanned<f64>>,
    /// Specific heat [J/(kg·K)].
    #[schemars(with = "Option<f64>")]
    pub specific_heat_j_kgk: Option<Spanned<f64>>,
    /// Id of a food, for its raw lean tissue's own properties at the node's temperature.
    #[schemars(with = "Option<String>")]
    pub food: Option<Spanned<String>>,
    /// Water that can evaporate [kg/m³]. A node keeps to `boiling_c` until its water has gone.
    #[schemars(with = "Option<f64>")]
    pub water_kg_m3: Option<Spanned<f64>>,
    /// Where it boils [°C]; 100 by default.
    #[schemars(with = "Option<f64>")]
    pub boiling_c: Option<Spanned<f64>>,
    /// Latent heat [J/kg]; 2.257e6 by default.
    #[schemars(with = "Option<f64>")]
    pub latent_j_kg: Option<Spanned<f64>>,
    /// Thermal conductivity where the water has gone [W/(m·K)]; as before by default. The heat capacity stays.
    #[schemars(with = "Option<f64>")]
    pub crust_conductivity_w_mk: Option<Spanned<f64>>,
    /// Whether water is made up for.
    pub juice: Option<Juice>,
}

/// Whether water is made up for.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Juice {
    /// What evaporates is gone.
    Limited,
    /// A node never dries.
    Unlimited,
}

/// Faces of a body.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Face {
    /// The lower end of z.
    Bottom,
    /// The upper end of z.
    Top,
    /// Everything but bottom and top.
    Side,
    /// Both faces across x.
    X,
    /// Both faces across y.
    Y,
    /// Both faces across z.
    Z,
    /// Every face.
    All,
}

/// A boundary.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoundaryEntry {
    /// Which faces.
    #[schemars(with = "Face")]
    pub face: Spanned<Face>,
    /// Heat transfer coefficient [W/(m²·K)].
    #[schemars(with = "Option<f64>")]
    pub h_w_m2k: Option<Spanned<f64>>,
    /// Holds the surface at `ambient_c`.
    #[serde(default)]
    pub fixed: bool,
    /// Temperature outside, or of the surface where `fixed` [°C].
    #[schemars(with = "Option<f64>")]
    pub ambient_c: Option<Spanned<f64>>,
    /// With `physics = "cooking"`: what the face meets. Air takes up vapour; by default `h_w_m2k` up to 100 means air, more
    /// a solid or a liquid. A pan of `ambient_c` needs no `h_w_m2k`: the kitchen's contact model gives it.
    pub contact: Option<Contact>,
    /// A flux into the body [W/m²], alone or on top of `h_w_m2k`.
    #[schemars(with = "Option<f64>")]
    pub q_w_m2: Option<Spanned<f64>>,
}

/// What a face meets.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Contact {
    /// Air, which takes up vapour.
    Air,
    /// A solid or a liquid, which takes up none.
    Solid,
    /// A pan with its film of oil: conductance from gap, pressure, wetness and steam.
    Pan,
}

/// Flips.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlipsEntry {
    /// At these times [s].
    pub at_s: Option<Vec<f64>>,
    /// Every so often [s].
    pub every_s: Option<f64>,
}

/// A probe.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProbeEntry {
    /// Name.
    pub name: String,
    /// Where, in the body's coordinates [mm].
    #[schemars(with = "Vec<f64>")]
    pub at_mm: Spanned<Vec<f64>>,
    /// Tells the heat flux upwards too; at a border of two bodies the upper one's.
    #[serde(default)]
    pub flux: bool,
}

/// When to stop.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StopEntry {
    /// Once every point has reached this at any time [°C].
    #[schemars(with = "f64")]
    pub when_every_point_has_reached_c: Spanned<f64>,
}

/// What else is told.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReportEntry {
    /// Share of the volume that has ever been above these [°C].
    #[serde(default)]
    #[schemars(with = "Vec<f64>")]
    pub volume_above_c: Vec<Spanned<f64>>,
    /// Probe whose highest temperature is told, at any step.
    #[schemars(with = "Option<String>")]
    pub peak_of: Option<Spanned<String>>,
}
