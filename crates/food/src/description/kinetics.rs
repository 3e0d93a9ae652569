//! Tables of a kinetics file: what heat does to one kind of flesh.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::sourced_table;

sourced_table! {
    /// A first-order change given by its rate at an anchor temperature.
    Change {
        /// Name by which colours, texture and shrinkage refer to it.
        #[schemars(example = &"myosin")]
        name: String,
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 1.0, max = 1000.0), example = 241.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = 0.0, max = 200.0), example = 57.0)]
        anchor_c: f64,
        /// Rate there [1/min].
        #[schemars(range(min = 1e-6, max = 1e4), example = 2.66)]
        anchor_rate_per_min: f64,
    }
}

sourced_table! {
    /// Water that the flesh can hold and how quickly the rest leaves.
    WaterHolding {
        /// Share lost far above the transition [-].
        #[schemars(range(min = 0.0, max = 0.9), example = 0.46)]
        drop: f64,
        /// Spread of the transition [-].
        #[schemars(range(min = 1e-3, max = 1e6), example = 30.0)]
        spread: f64,
        /// Steepness [1/K].
        #[schemars(range(min = 0.0, max = 5.0), example = 0.25)]
        slope_per_k: f64,
        /// Temperature of the transition [°C].
        #[schemars(range(min = -100.0, max = 300.0), example = 52.0)]
        middle_c: f64,
        /// Share of the raw water that is lost at least when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "myosin": 0.13 }]))]
        change: BTreeMap<String, f64>,
        /// First-order release of what is no longer held, at `release_anchor_c` [1/s].
        #[schemars(range(min = 0.0, max = 1.0), example = 1.5e-3)]
        release_per_s: f64,
        /// Temperature of that [°C].
        #[schemars(range(min = 0.0, max = 150.0), example = 65.0)]
        release_anchor_c: f64,
        /// How the release quickens with temperature [kJ/mol].
        #[schemars(range(min = 0.0, max = 500.0), example = 60.0)]
        release_activation_energy_kj_mol: f64,
        /// Speed of free juice along the fibres [µm/s].
        #[schemars(range(min = 0.0, max = 1e4), example = 10.0)]
        juice_speed_um_s: f64,
        /// Juice that stays on a face before it runs off [kg/m²].
        #[schemars(range(min = 0.0, max = 2.0), example = 0.1)]
        film_kg_m2: f64,
    }
}

sourced_table! {
    /// Browning: rate at an anchor temperature times a factor of water activity.
    BrowningRate {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 0.0, max = 1000.0), example = 100.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = -50.0, max = 500.0), example = 140.0)]
        anchor_c: f64,
        /// Rate there at the best water activity [1/s].
        #[schemars(range(min = 0.0, max = 100.0), example = 5.0e-3)]
        anchor_rate_per_s: f64,
        /// Water activities of the factor's corners, ascending [-].
        #[schemars(inner(range(min = -1.0, max = 2.0)), extend("examples" = [[0.0, 0.65, 1.0]]))]
        activity: Vec<f64>,
        /// Factor at those activities [-].
        #[schemars(inner(range(min = 0.0, max = 1e6)), extend("examples" = [[0.4, 1.0, 0.02]]))]
        factor: Vec<f64>,
    }
}

sourced_table! {
    /// Charring of what is browned.
    CharringRate {
        /// Activation energy [kJ/mol].
        #[schemars(range(min = 0.0, max = 1000.0), example = 140.0)]
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        #[schemars(range(min = -50.0, max = 500.0), example = 250.0)]
        anchor_c: f64,
        /// Rate there [1/s].
        #[schemars(range(min = 0.0, max = 100.0), example = 5.0e-3)]
        anchor_rate_per_s: f64,
    }
}

sourced_table! {
    /// Death of pathogens by heat.
    Lethality {
        /// Minutes for a tenfold reduction at 60 °C [min].
        #[schemars(range(min = 1e-3, max = 1e4), example = 2.6)]
        d60_min: f64,
        /// Kelvins for a tenfold change of that [K].
        #[schemars(range(min = 1.0, max = 30.0), example = 6.0)]
        z_k: f64,
    }
}

sourced_table! {
    /// Elastic modulus from the changes.
    Texture {
        /// Raw [kPa].
        #[schemars(range(min = 0.1, max = 1e5), example = 6.0)]
        raw_kpa: f64,
        /// Added when a change is complete, by its name [kPa].
        #[schemars(extend("examples" = [{ "myosin": 8.0 }]))]
        change_kpa: BTreeMap<String, f64>,
        /// Share of the stress of a bend that is left after a minute [-].
        #[schemars(range(min = 0.01, max = 1.0), example = 0.4)]
        relaxed_share: f64,
    }
}

sourced_table! {
    /// Hardness on biting over that of the raw food, from the changes.
    Hardness {
        /// Added when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "myosin": 0.7 }]))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Juiciness on biting: the raw food's water that is left, times one plus the changes' contributions.
    Juiciness {
        /// Added to 1 when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "actin": -0.5 }]))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// How far free tissue contracts.
    Shrinkage {
        /// Contraction of a length across the fibres when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "myosin": 0.05 }]))]
        across: BTreeMap<String, f64>,
        /// Contraction along the fibres (a steak's thickness) when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "actin": 0.25 }]))]
        along: BTreeMap<String, f64>,
        /// Volume over the raw volume below which what is lost leaves pores [-].
        #[schemars(range(min = 0.05, max = 1.0), example = 0.585)]
        least_volume: f64,
    }
}

sourced_table! {
    /// How a body curls because its belly contracts more than its back.
    Curl {
        /// Difference of the contractions along the body when a change is complete, by its name [-].
        #[schemars(extend("examples" = [{ "myosin": 0.1 }]))]
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Molten fat that leaves the tissue.
    FatRelease {
        /// Share of the lean tissue's fat that can leave [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.15)]
        fine_share: f64,
        /// Share of the fat in seams that can leave [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.6)]
        seam_share: f64,
        /// Temperatures at which the rate is given, ascending [°C].
        #[schemars(inner(range(min = -100.0, max = 600.0)), extend("examples" = [[45.0, 100.0]]))]
        celsius: Vec<f64>,
        /// Rate at those temperatures, of fat that lies at a face [1/s].
        #[schemars(inner(range(min = 0.0, max = 100.0)), extend("examples" = [[0.0, 1.0e-3]]))]
        rate_per_s: Vec<f64>,
        /// Depth below a face at which the rate has fallen to 1/e [mm].
        #[schemars(range(min = 0.1, max = 1000.0), example = 3.0)]
        depth_mm: f64,
    }
}

/// What heat does to one kind of flesh.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute kinetics")]
pub struct Kinetics {
    /// First-order changes, at most [`MOST_CHANGES`]; the first makes fat look cooked, the last tells a cook that it is done.
    #[schemars(length(min = 1, max = MOST_CHANGES))]
    pub change: Vec<Change>,
    /// Water holding.
    pub water_holding: WaterHolding,
    /// Fat that leaves.
    pub fat_release: FatRelease,
    /// Contraction.
    pub shrinkage: Shrinkage,
    /// Curling; absent where there is none.
    pub curl: Option<Curl>,
    /// Browning.
    pub browning: BrowningRate,
    /// Charring.
    pub charring: CharringRate,
    /// Death of pathogens.
    pub lethality: Lethality,
    /// Elastic modulus.
    pub texture: Texture,
    /// Hardness.
    pub hardness: Hardness,
    /// Juiciness.
    pub juiciness: Juiciness,
}

/// Most changes that one kind of flesh may have (chosen: beef has four).
pub const MOST_CHANGES: usize = 4;

/// A value for each change, in the order of the kinetics file.
pub type PerChange = [f64; MOST_CHANGES];

/// A name that is no change of the kinetics.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("\"{name}\" in [{table}] is no change of the kinetics; there are: {known}")]
pub struct NoSuchChange {
    /// The table that names it.
    pub table: &'static str,
    /// The name.
    pub name: String,
    /// What there is.
    pub known: String,
}

impl Kinetics {
    /// Names of the changes, in order.
    pub fn names(&self) -> Vec<&str> {
        self.change.iter().map(|c| c.name.as_str()).collect()
    }

    /// The values of a table in the order of the changes; what the table does not name is zero.
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
}
