//! Tables of a kinetics file: what heat does to one kind of flesh.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::sourced_table;

sourced_table! {
    /// A first-order change given by its rate at an anchor temperature.
    Change {
        /// Name by which colours, texture and shrinkage refer to it.
        name: String,
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate there [1/min].
        anchor_rate_per_min: f64,
    }
}

sourced_table! {
    /// Water that the flesh can hold and how quickly the rest leaves.
    WaterHolding {
        /// Share lost far above the transition [-].
        drop: f64,
        /// Spread of the transition [-].
        spread: f64,
        /// Steepness [1/K].
        slope_per_k: f64,
        /// Temperature of the transition [°C].
        middle_c: f64,
        /// Share of the raw water that is lost at least when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
        /// First-order release of what is no longer held, at `release_anchor_c` [1/s].
        release_per_s: f64,
        /// Temperature of that [°C].
        release_anchor_c: f64,
        /// How the release quickens with temperature [kJ/mol].
        release_activation_energy_kj_mol: f64,
        /// Speed of free juice along the fibres [µm/s].
        juice_speed_um_s: f64,
        /// Juice that stays on a face before it runs off [kg/m²].
        film_kg_m2: f64,
    }
}

sourced_table! {
    /// Browning: rate at an anchor temperature times a factor of water activity.
    BrowningRate {
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate there at the best water activity [1/s].
        anchor_rate_per_s: f64,
        /// Water activities of the factor's corners, ascending [-].
        activity: Vec<f64>,
        /// Factor at those activities [-].
        factor: Vec<f64>,
    }
}

sourced_table! {
    /// Charring of what is browned.
    CharringRate {
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate there [1/s].
        anchor_rate_per_s: f64,
    }
}

sourced_table! {
    /// Death of pathogens by heat.
    Lethality {
        /// Minutes for a tenfold reduction at 60 °C [min].
        d60_min: f64,
        /// Kelvins for a tenfold change of that [K].
        z_k: f64,
    }
}

sourced_table! {
    /// Elastic modulus from the changes.
    Texture {
        /// Raw [kPa].
        raw_kpa: f64,
        /// Added when a change is complete, by its name [kPa].
        change_kpa: BTreeMap<String, f64>,
        /// Share of the stress of a bend that is left after a minute [-].
        relaxed_share: f64,
    }
}

sourced_table! {
    /// Hardness on biting over that of the raw food, from the changes.
    Hardness {
        /// Added when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Juiciness on biting: the raw food's water that is left, times one plus the changes' contributions.
    Juiciness {
        /// Added to 1 when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// How far free tissue contracts.
    Shrinkage {
        /// Contraction of a length across the fibres when a change is complete, by its name [-].
        across: BTreeMap<String, f64>,
        /// Contraction along the fibres (a steak's thickness) when a change is complete, by its name [-].
        along: BTreeMap<String, f64>,
        /// Volume over the raw volume below which what is lost leaves pores [-].
        least_volume: f64,
    }
}

sourced_table! {
    /// How a body curls because its belly contracts more than its back.
    Curl {
        /// Difference of the contractions along the body when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Molten fat that leaves the tissue.
    FatRelease {
        /// Share of the lean tissue's fat that can leave [-].
        fine_share: f64,
        /// Share of the fat in seams that can leave [-].
        seam_share: f64,
        /// Temperatures at which the rate is given, ascending [°C].
        celsius: Vec<f64>,
        /// Rate at those temperatures, of fat that lies at a face [1/s].
        rate_per_s: Vec<f64>,
        /// Depth below a face at which the rate has fallen to 1/e [mm].
        depth_mm: f64,
    }
}

/// What heat does to one kind of flesh.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kinetics {
    /// First-order changes, at most [`MOST_CHANGES`]; the first makes fat look cooked, the last tells a cook that it is done.
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
