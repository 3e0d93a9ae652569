//! The tables of a lab case for probes and expected values.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::case::ranges::{AT_MM, EXPECTED, TIME_S, TOLERANCE, TOLERANCE_PCT};

/// A probe.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProbeEntry {
    /// Name.
    pub name: String,
    /// Position in the body's coordinates [mm].
    #[schemars(with = "Vec<f64>", inner(range(min = AT_MM[0], max = AT_MM[1])))]
    pub at_mm: Spanned<Vec<f64>>,
    /// If true, the upward heat flux is reported as well; at an interface of two bodies it is that of the upper one.
    #[serde(default)]
    pub flux: bool,
}

/// An expected value, with exactly one of `tolerance` and `tolerance_pct`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExpectEntry {
    /// Quantity.
    pub quantity: Quantity,
    /// Name of the probe, for `quantity = "probe"` and `"flux"`.
    pub probe: Option<String>,
    /// Time of the reading, for a probe [s].
    #[schemars(with = "Option<f64>", range(min = TIME_S[0], max = TIME_S[1]))]
    pub at_s: Option<Spanned<f64>>,
    /// Expected value, in the quantity's unit.
    #[schemars(with = "f64", range(min = EXPECTED[0], max = EXPECTED[1]))]
    pub value: Spanned<f64>,
    /// Largest absolute error, in the quantity's unit.
    #[schemars(with = "Option<f64>", range(min = TOLERANCE[0], max = TOLERANCE[1]))]
    pub tolerance: Option<Spanned<f64>>,
    /// Largest relative error [%].
    #[schemars(with = "Option<f64>", range(min = TOLERANCE_PCT[0], max = TOLERANCE_PCT[1]))]
    pub tolerance_pct: Option<Spanned<f64>>,
}

/// Quantities that can be expected.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Temperature of a probe [°C].
    Probe,
    /// Time at which the stop condition was met [s].
    StoppedAt,
    /// Heat absorbed [J]; of a slab [J/m²].
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
    /// Dried depth of a slab [mm].
    CrustMm,
    /// Highest temperature of the probe named in `report.peak_of` [°C].
    CorePeak,
    /// Time of that highest temperature [s].
    CorePeakAt,
    /// Time at which the first phase ended [s].
    FirstPhaseEnded,
    /// Stop time of the compared run over the stop time of this run [-].
    StopRatio,
    /// Juice lost by dripping [g].
    DrippedG,
    /// Mass lost [%].
    LostPct,
    /// Contraction of the section across the fibres, by area [%].
    SectionShrunkPct,
    /// Contraction along the fibres, of the thickness [%].
    ThicknessShrunkPct,
    /// Highest conductance of the contact with a pan [W/(m²·K)].
    ContactHighest,
    /// Time of the highest conductance [s].
    ContactHighestAt,
    /// Last conductance of the contact with a pan [W/(m²·K)].
    ContactLast,
    /// Lowest conductance of the contact with a pan [W/(m²·K)].
    ContactLowest,
}

impl Quantity {
    /// Returns true for the temperature of a probe.
    pub fn is_temperature(self) -> bool {
        self == Self::Probe
    }
}
