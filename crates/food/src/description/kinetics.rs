//! Tables of a kinetics file: the response of one kind of flesh to heat.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::sourced_table;

sourced_table! {
    /// A change given by its rate at an anchor temperature: dX/dt = k (1 − X), or with `autocatalysis` s dX/dt = k (1 − X)(X + s).
    Change {
        /// Name of the change, as colours, texture and shrinkage refer to it.
        #[schemars(example = &"myosin")]
        name: String,
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 1.0, max = 1000.0), example = 241.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = 0.0, max = 200.0), example = 57.0)]
        anchor_c: f64,
        /// Rate at the anchor temperature [1/min].
        #[schemars(range(min = 1e-6, max = 1e4), example = 2.66)]
        anchor_rate_per_min: f64,
        /// Share s by which a change that speeds itself up begins [-]; a first-order change has none.
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.1)]
        autocatalysis: Option<f64>,
    }
}

sourced_table! {
    /// Water-holding capacity of the flesh and release of the rest.
    WaterHolding {
        /// Share of the raw water that is lost far above the transition [-].
        #[schemars(range(min = 0.0, max = 0.9), example = 0.46)]
        drop: f64,
        /// Spread of the transition [-]; see the equation of the held share in the crate's water module.
        #[schemars(range(min = 1e-3, max = 1e6), example = 30.0)]
        spread: f64,
        /// Steepness of the transition [1/K].
        #[schemars(range(min = 0.0, max = 5.0), example = 0.25)]
        slope_per_k: f64,
        /// Temperature of the transition [°C].
        #[schemars(range(min = -100.0, max = 300.0), example = 52.0)]
        middle_c: f64,
        /// Least share of the raw water that is lost when a change is complete, by the name of the change [-].
        #[schemars(extend("examples" = [{ "myosin": 0.13 }], "additionalProperties" = each(0.0, 1.0)))]
        change: BTreeMap<String, f64>,
        /// Rate of release of the water that is no longer held, at `release_anchor_c` [1/s].
        #[schemars(range(min = 0.0, max = 1.0), example = 1.5e-3)]
        release_per_s: f64,
        /// Temperature at which the release rate is given [°C].
        #[schemars(range(min = 0.0, max = 150.0), example = 65.0)]
        release_anchor_c: f64,
        /// Activation energy of the release [kJ/mol].
        #[schemars(range(min = 0.0, max = 500.0), example = 60.0)]
        release_activation_energy_kj_mol: f64,
        /// Speed of free juice along the fibres [µm/s].
        #[schemars(range(min = 0.0, max = 1e4), example = 10.0)]
        juice_speed_um_s: f64,
        /// Share of the juice freed on the only hot side of the coldest level that flows through that level to the other
        /// face [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.3)]
        through_share: f64,
        /// Share of the juice that enters boiling flesh and passes all of it to the face as liquid [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.7)]
        passes_boiling: f64,
        /// Largest film of juice on a face; more runs off [kg/m²].
        #[schemars(range(min = 0.0, max = 2.0), example = 0.1)]
        film_kg_m2: f64,
    }
}

sourced_table! {
    /// Rate of browning: an Arrhenius rate times a factor of the water activity.
    BrowningRate {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 0.0, max = 1000.0), example = 100.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = -50.0, max = 500.0), example = 140.0)]
        anchor_c: f64,
        /// Rate at the anchor temperature with a factor of 1 [1/s].
        #[schemars(range(min = 0.0, max = 100.0), example = 5.0e-3)]
        anchor_rate_per_s: f64,
        /// Water activities at which the factor is given, ascending [-].
        #[schemars(inner(range(min = -1.0, max = 2.0)), extend("examples" = [[0.0, 0.65, 1.0]]))]
        activity: Vec<f64>,
        /// Factor of the rate at those activities [-].
        #[schemars(inner(range(min = 0.0, max = 1e6)), extend("examples" = [[0.4, 1.0, 0.02]]))]
        factor: Vec<f64>,
    }
}

sourced_table! {
    /// Rate of charring of browned flesh.
    CharringRate {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 0.0, max = 1000.0), example = 140.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = -50.0, max = 500.0), example = 250.0)]
        anchor_c: f64,
        /// Rate at the anchor temperature [1/s].
        #[schemars(range(min = 0.0, max = 100.0), example = 5.0e-3)]
        anchor_rate_per_s: f64,
    }
}

sourced_table! {
    /// Lethality: thermal death of pathogens. Where sources differ the slower of their kills counts, at each temperature.
    Lethality {
        /// The germ that the numbers were measured on; pathogens unless stated.
        #[serde(default = "pathogens")]
        #[schemars(length(min = 1), example = &"E. coli O157:H7")]
        germ: String,
        /// Time of a tenfold reduction at 60 °C, D₆₀ [min].
        #[schemars(range(min = 1e-3, max = 1e4), example = 2.6)]
        d60_min: f64,
        /// Temperature difference for a tenfold change of that time, z [K].
        #[schemars(range(min = 1.0, max = 30.0), example = 6.0)]
        z_k: f64,
        /// Numbers of further sources.
        #[serde(default)]
        also: Vec<Kill>,
        /// Log₁₀ reduction from which the food is called pasteurised [-]; without it it is called neither that nor otherwise.
        #[schemars(range(min = 1.0, max = 12.0), example = 6.5)]
        pasteurised_log: Option<f64>,
    }
}

/// Kill of a germ as one source states it.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Kill {
    /// Time of a tenfold reduction at 60 °C, D₆₀ [min].
    #[schemars(range(min = 1e-3, max = 1e4), example = 2.6)]
    pub d60_min: f64,
    /// Temperature difference for a tenfold change of that time, z [K].
    #[schemars(range(min = 1.0, max = 30.0), example = 6.0)]
    pub z_k: f64,
}

impl Lethality {
    /// Returns the log₁₀ reduction a minute at a temperature [°C]: 10^((T − 60)/z) / D₆₀, by the slowest of the sources.
    pub fn rate_per_min(&self, celsius: f64) -> f64 {
        let of = |kill: &Kill| libm::pow(10.0, (celsius - 60.0) / kill.z_k) / kill.d60_min;
        let first = Kill { d60_min: self.d60_min, z_k: self.z_k };
        self.also.iter().map(of).fold(of(&first), |least, rate| if rate < least { rate } else { least })
    }
}

sourced_table! {
    /// Elastic modulus as a function of the changes.
    Texture {
        /// Modulus of the raw flesh [kPa].
        #[schemars(range(min = 0.1, max = 1e5), example = 6.0)]
        raw_kpa: f64,
        /// Contribution of a complete change, by the name of the change [kPa].
        #[schemars(extend("examples" = [{ "myosin": 8.0 }], "additionalProperties" = each(-1e6, 1e6)))]
        change_kpa: BTreeMap<String, f64>,
        /// Share of a bending stress that remains after a minute [-].
        #[schemars(range(min = 0.01, max = 1.0), example = 0.4)]
        relaxed_share: f64,
        /// Share of the strain under a press that stays when it ends [-]; 0.1 by default.
        #[serde(default = "springs_back")]
        #[schemars(range(min = 0.0, max = 1.0), example = 0.1)]
        set_share: f64,
    }
}

sourced_table! {
    /// Hardness on biting relative to the raw food, as a function of the changes.
    Hardness {
        /// Contribution of a complete change, by the name of the change [-].
        #[schemars(extend("examples" = [{ "myosin": 0.7 }], "additionalProperties" = each(-100.0, 100.0)))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Juiciness on biting: the remaining share of the raw water, times 1 plus the contributions of the changes.
    Juiciness {
        /// Contribution of a complete change to the factor, by the name of the change [-].
        #[schemars(extend("examples" = [{ "actin": -0.5 }], "additionalProperties" = each(-10.0, 10.0)))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Contraction of free tissue.
    Shrinkage {
        /// Contraction of a length across the fibres by a complete change, by the name of the change [-].
        #[schemars(extend("examples" = [{ "myosin": 0.05 }], "additionalProperties" = each(-0.5, 0.5)))]
        across: BTreeMap<String, f64>,
        /// Contraction along the fibres (a steak's thickness) by a complete change, by the name of the change [-].
        #[schemars(extend("examples" = [{ "actin": 0.25 }], "additionalProperties" = each(-0.5, 0.5)))]
        along: BTreeMap<String, f64>,
        /// Least volume relative to the raw volume; losses beyond it leave pores [-].
        #[schemars(range(min = 0.05, max = 1.0), example = 0.585)]
        least_volume: f64,
    }
}

sourced_table! {
    /// Curling of a body whose belly contracts more than its back.
    Curl {
        /// Difference of the contractions along the body by a complete change, by the name of the change [-].
        #[schemars(extend("examples" = [{ "myosin": 0.1 }], "additionalProperties" = each(-0.5, 0.5)))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Release of molten fat from the tissue.
    FatRelease {
        /// Share of the lean tissue's fat that can leave [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.15)]
        fine_share: f64,
        /// Share of the fat in seams that can leave [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.6)]
        seam_share: f64,
        /// Temperatures at which the release rate is given, ascending [°C].
        #[schemars(inner(range(min = -100.0, max = 600.0)), extend("examples" = [[45.0, 100.0]]))]
        celsius: Vec<f64>,
        /// Release rate at those temperatures of fat at a face [1/s].
        #[schemars(inner(range(min = 0.0, max = 100.0)), extend("examples" = [[0.0, 1.0e-3]]))]
        rate_per_s: Vec<f64>,
        /// Depth below a face at which the rate is 1/e of that at the face [mm].
        #[schemars(range(min = 0.1, max = 1000.0), example = 3.0)]
        depth_mm: f64,
    }
}

/// Kinetics of one kind of flesh, as its file states them.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute kinetics")]
pub struct Kinetics {
    /// Changes, at most [`MOST_CHANGES`]; the first determines the look of fat.
    #[schemars(length(min = 1, max = MOST_CHANGES))]
    pub change: Vec<Change>,
    /// Water holding.
    pub water_holding: WaterHolding,
    /// Release of fat.
    pub fat_release: FatRelease,
    /// Shrinkage.
    pub shrinkage: Shrinkage,
    /// Curling; absent in a body that does not curl.
    pub curl: Option<Curl>,
    /// Browning.
    pub browning: BrowningRate,
    /// Charring.
    pub charring: CharringRate,
    /// Lethality of pathogens.
    pub lethality: Lethality,
    /// Elastic modulus.
    pub texture: Texture,
    /// Hardness.
    pub hardness: Hardness,
    /// Juiciness.
    pub juiciness: Juiciness,
}

/// Share of the strain under a press that stays [-] (chosen: whole flesh springs back).
fn springs_back() -> f64 {
    0.1
}

/// What is killed if the file does not name it.
fn pathogens() -> String {
    "Pathogens".to_owned()
}

/// Returns the schema of a number for each name of a table, with its range.
fn each(least: f64, most: f64) -> serde_json::Value {
    serde_json::json!({ "type": "number", "format": "double", "minimum": least, "maximum": most })
}

/// Largest number of changes of one kind of flesh [-] (chosen: beef has seven).
pub const MOST_CHANGES: usize = 7;

/// A value for each change, in the order of the kinetics file.
pub type PerChange = [f64; MOST_CHANGES];

/// Error: a table names a change that the kinetics do not contain.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("\"{name}\" in [{table}] is not a change of the kinetics; its changes: {known}")]
pub struct NoSuchChange {
    /// The table with the name.
    pub table: &'static str,
    /// The unknown name.
    pub name: String,
    /// Names of the changes in the kinetics.
    pub known: String,
}

impl Kinetics {
    /// Names of the changes, in the order of the file.
    pub fn names(&self) -> Vec<&str> {
        self.change.iter().map(|c| c.name.as_str()).collect()
    }

    /// Returns the values of a table in the order of the changes; changes that the table does not name get zero.
    ///
    /// # Errors
    /// If the table names a change that the kinetics do not contain.
    pub fn in_order<T: Copy + Default>(
        &self,
        table: &'static str,
        values: &BTreeMap<String, T>,
    ) -> Result<[T; MOST_CHANGES], NoSuchChange> {
        let mut ordered = [T::default(); MOST_CHANGES];
        for (name, value) in values {
            let Some(at) = self.change.iter().position(|c| &c.name == name) else {
                return Err(NoSuchChange { table, name: name.clone(), known: self.names().join(", ") });
            };
            ordered[at] = *value;
        }
        Ok(ordered)
    }

    /// Returns the values of a table for the changes that it names, by their place.
    ///
    /// # Errors
    /// As [`Self::in_order`].
    pub(crate) fn effects(&self, table: &'static str, values: &BTreeMap<String, f64>) -> Result<Effects, NoSuchChange> {
        let ordered = self.in_order(table, values)?;
        Ok(Effects(ordered.into_iter().enumerate().filter(|(_, value)| *value != 0.0).collect()))
    }
}

/// What complete changes contribute to a property: the place of each change that does, and its contribution.
#[derive(Clone, Debug, Default)]
pub(crate) struct Effects(Vec<(usize, f64)>);

impl Effects {
    /// The node fields of the changes that contribute, each with its contribution.
    pub(crate) fn of<'a>(&'a self, changed: &'a [Vec<f64>]) -> impl Iterator<Item = (&'a [f64], f64)> {
        self.0.iter().map(|(place, value)| (changed[*place].as_slice(), *value))
    }

    /// Returns true if no change contributes.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
