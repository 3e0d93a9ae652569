//! Tables of a kinetics file: the response of one kind of flesh to heat.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::sourced_table;

sourced_table! {
    /// A first-order change given by its rate at an anchor temperature.
    Change {
        /// Name of the change, as colours, texture and shrinkage refer to it.
        name: String,
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate at the anchor temperature [1/min].
        anchor_rate_per_min: f64,
    }
}

sourced_table! {
    /// Water-holding capacity of the flesh and release of the rest.
    WaterHolding {
        /// Share of the raw water that is lost far above the transition [-].
        drop: f64,
        /// Spread of the transition [-]; see the equation of the held share in the crate's water module.
        spread: f64,
        /// Steepness of the transition [1/K].
        slope_per_k: f64,
        /// Temperature of the transition [°C].
        middle_c: f64,
        /// Least share of the raw water that is lost when a change is complete, by the name of the change [-].
        change: BTreeMap<String, f64>,
        /// Rate of release of the water that is no longer held, at `release_anchor_c` [1/s].
        release_per_s: f64,
        /// Temperature at which the release rate is given [°C].
        release_anchor_c: f64,
        /// Activation energy of the release [kJ/mol].
        release_activation_energy_kj_mol: f64,
        /// Speed of free juice along the fibres [µm/s].
        juice_speed_um_s: f64,
        /// Largest film of juice on a face; more runs off [kg/m²].
        film_kg_m2: f64,
    }
}

sourced_table! {
    /// Rate of browning: an Arrhenius rate times a factor of the water activity.
    BrowningRate {
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate at the anchor temperature with a factor of 1 [1/s].
        anchor_rate_per_s: f64,
        /// Water activities at which the factor is given, ascending [-].
        activity: Vec<f64>,
        /// Factor of the rate at those activities [-].
        factor: Vec<f64>,
    }
}

sourced_table! {
    /// Rate of charring of browned flesh.
    CharringRate {
        /// Activation energy [kJ/mol].
        activation_energy_kj_mol: f64,
        /// Temperature at which the rate is given [°C].
        anchor_c: f64,
        /// Rate at the anchor temperature [1/s].
        anchor_rate_per_s: f64,
    }
}

sourced_table! {
    /// Lethality: thermal death of pathogens.
    Lethality {
        /// Time of a tenfold reduction at 60 °C, D₆₀ [min].
        d60_min: f64,
        /// Temperature difference for a tenfold change of that time, z [K].
        z_k: f64,
    }
}

sourced_table! {
    /// Elastic modulus as a function of the changes.
    Texture {
        /// Modulus of the raw flesh [kPa].
        raw_kpa: f64,
        /// Contribution of a complete change, by the name of the change [kPa].
        change_kpa: BTreeMap<String, f64>,
        /// Share of a bending stress that remains after a minute [-].
        relaxed_share: f64,
    }
}

sourced_table! {
    /// Hardness on biting relative to the raw food, as a function of the changes.
    Hardness {
        /// Contribution of a complete change, by the name of the change [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Juiciness on biting: the remaining share of the raw water, times 1 plus the contributions of the changes.
    Juiciness {
        /// Contribution of a complete change to the factor, by the name of the change [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Contraction of free tissue.
    Shrinkage {
        /// Contraction of a length across the fibres by a complete change, by the name of the change [-].
        across: BTreeMap<String, f64>,
        /// Contraction along the fibres (a steak's thickness) by a complete change, by the name of the change [-].
        along: BTreeMap<String, f64>,
        /// Least volume relative to the raw volume; losses beyond it leave pores [-].
        least_volume: f64,
    }
}

sourced_table! {
    /// Curling of a body whose belly contracts more than its back.
    Curl {
        /// Difference of the contractions along the body by a complete change, by the name of the change [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Release of molten fat from the tissue.
    FatRelease {
        /// Share of the lean tissue's fat that can leave [-].
        fine_share: f64,
        /// Share of the fat in seams that can leave [-].
        seam_share: f64,
        /// Temperatures at which the release rate is given, ascending [°C].
        celsius: Vec<f64>,
        /// Release rate at those temperatures of fat at a face [1/s].
        rate_per_s: Vec<f64>,
        /// Depth below a face at which the rate is 1/e of that at the face [mm].
        depth_mm: f64,
    }
}

/// Kinetics of one kind of flesh, as its file states them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kinetics {
    /// First-order changes, at most [`MOST_CHANGES`]; the first determines the look of fat, the last the doneness.
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

/// Largest number of changes of one kind of flesh [-] (chosen: beef has four).
pub const MOST_CHANGES: usize = 4;

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
}
