//! The format of a lab case as it is written, before anything is checked.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

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
    /// The body.
    #[schemars(with = "BodyEntry")]
    pub body: Spanned<BodyEntry>,
    /// What it is made of.
    #[schemars(with = "MaterialEntry")]
    pub material: Spanned<MaterialEntry>,
    /// Boundaries; a face without one is insulated, a later entry overrides an earlier one.
    #[serde(default)]
    #[schemars(with = "Vec<BoundaryEntry>")]
    pub boundary: Vec<Spanned<BoundaryEntry>>,
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
    pub report: Option<ReportEntry>,
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
}

/// An expected value, with exactly one of `tolerance` and `tolerance_pct`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExpectEntry {
    /// Which quantity.
    pub quantity: Quantity,
    /// Which probe, for `quantity = "probe"`.
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
    /// Largest node spacing [mm]; the mesh is finer towards the faces.
    #[schemars(with = "Option<f64>")]
    pub resolution_mm: Option<Spanned<f64>>,
    /// Start temperature [°C].
    #[schemars(with = "f64")]
    pub initial_c: Spanned<f64>,
}

/// The material: three constants, or a food.
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
    #[schemars(with = "f64")]
    pub ambient_c: Spanned<f64>,
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
}

/// When to stop.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StopEntry {
    /// Once every point has reached this at any time [°C].
    pub when_every_point_has_reached_c: f64,
}

/// What else is told.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReportEntry {
    /// Share of the volume that has ever been above these [°C].
    pub volume_above_c: Vec<f64>,
}
