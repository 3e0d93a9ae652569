//! The tables of a lab case for boundary conditions, phases and flips.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::case::ranges::{
    AMBIENT_C, DURATION_S, EMISSIVITY, H_W_M2K, HUMIDITY_PCT, LEAST_INTERVAL, Q_W_M2, REACHED_C, TIME_S,
};

/// A boundary condition: Robin (`h_w_m2k`), fixed temperature (Dirichlet) or fixed flux (Neumann), with thermal radiation
/// (`radiant_c`) where the temperature is not fixed.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoundaryEntry {
    /// Faces.
    #[schemars(with = "Face")]
    pub face: Spanned<Face>,
    /// Heat transfer coefficient, of air that of convection alone [W/(m²·K)]. With `physics = "cooking"` it also drives
    /// the evaporation into air, by the Lewis analogy.
    #[schemars(with = "Option<f64>", range(min = H_W_M2K[0], max = H_W_M2K[1]))]
    pub h_w_m2k: Option<Spanned<f64>>,
    /// If true, the surface temperature is fixed at `ambient_c` (Dirichlet boundary).
    #[serde(default)]
    pub fixed: bool,
    /// Ambient temperature, or surface temperature where `fixed` [°C].
    #[schemars(with = "Option<f64>", range(min = AMBIENT_C[0], max = AMBIENT_C[1]))]
    pub ambient_c: Option<Spanned<f64>>,
    /// With `physics = "cooking"`: the medium at the face. By default `h_w_m2k` up to 100 means air, which takes up
    /// vapour, and more means a solid or a liquid. A pan of `ambient_c` needs no `h_w_m2k`: the contact model of the
    /// kitchen computes it.
    pub contact: Option<Contact>,
    /// Heat flux into the body [W/m²], alone or in addition to `h_w_m2k`.
    #[schemars(with = "Option<f64>", range(min = Q_W_M2[0], max = Q_W_M2[1]))]
    pub q_w_m2: Option<Spanned<f64>>,
    /// Temperature of the surroundings that exchange thermal radiation with the face [°C], as the walls of an oven; alone
    /// or in addition to `h_w_m2k`. No radiation by default. With `physics = "cooking"` the medium at the face is air.
    #[schemars(with = "Option<f64>", range(min = AMBIENT_C[0], max = AMBIENT_C[1]))]
    pub radiant_c: Option<Spanned<f64>>,
    /// Effective emissivity of the face and its surroundings [-]; that of the food's surface by default. Needs `radiant_c`.
    #[schemars(with = "Option<f64>", range(min = EMISSIVITY[0], max = EMISSIVITY[1]))]
    pub emissivity: Option<Spanned<f64>>,
    /// With `physics = "cooking"`: relative humidity of the air at `ambient_c` [%]; its vapour density is that of the
    /// room's air by default. The vapour pressure is at most one atmosphere.
    #[schemars(with = "Option<f64>", range(min = HUMIDITY_PCT[0], max = HUMIDITY_PCT[1]))]
    pub humidity_pct: Option<Spanned<f64>>,
}

/// Face, or faces, of a body.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Face {
    /// The lower end of z.
    Bottom,
    /// The upper end of z.
    Top,
    /// All faces except bottom and top.
    Side,
    /// Both faces normal to x.
    X,
    /// Both faces normal to y.
    Y,
    /// Both faces normal to z.
    Z,
    /// Every face.
    All,
}

/// Medium at a face.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Contact {
    /// Air, which takes up vapour.
    Air,
    /// A solid or a liquid, which takes up no vapour.
    Solid,
    /// A pan with a film of oil: contact conductance from gap, pressure, wetness and steam.
    Pan,
}

/// A phase with its own boundaries. The last phase lasts until the end of the run.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PhaseEntry {
    /// End of the phase; optional in the last.
    #[schemars(with = "Option<UntilEntry>")]
    pub until: Option<Spanned<UntilEntry>>,
    /// Boundaries that override those of `[[boundary]]`.
    #[serde(default)]
    #[schemars(with = "Vec<BoundaryEntry>")]
    pub boundary: Vec<Spanned<BoundaryEntry>>,
}

/// The end of a phase: a time, or a temperature that a probe crosses upwards or downwards.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UntilEntry {
    /// Time at which the phase ends [s].
    #[schemars(with = "Option<f64>", range(min = TIME_S[0], max = TIME_S[1]))]
    pub at_s: Option<Spanned<f64>>,
    /// Name of the probe.
    pub probe: Option<String>,
    /// Temperature that the probe crosses [°C].
    #[schemars(with = "Option<f64>", range(min = REACHED_C[0], max = REACHED_C[1]))]
    pub reaches_c: Option<Spanned<f64>>,
}

/// Flips: exactly one of `at_s` and `every_s`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlipsEntry {
    /// Times of the flips, ascending [s].
    #[schemars(inner(range(min = TIME_S[0], max = TIME_S[1])))]
    pub at_s: Option<Vec<f64>>,
    /// Interval between flips [s].
    #[schemars(with = "Option<f64>", range(min = DURATION_S[0] * LEAST_INTERVAL))]
    pub every_s: Option<Spanned<f64>>,
}
