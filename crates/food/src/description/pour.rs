//! Tables of a food that is poured: its yolk, and how it runs and stands.

use crate::description::{Composition, LabColour};
use crate::sourced_table;

sourced_table! {
    /// Yolk of a poured food: a second tissue that its skin holds together.
    Yolk {
        /// Share of the volume of the piece [-].
        #[schemars(range(min = 0.05, max = 0.6), example = 0.34)]
        share: f64,
        /// Height at which it stands in its white [mm].
        #[schemars(range(min = 5.0, max = 30.0), example = 17.0)]
        height_mm: f64,
        /// Raw colour, L*, a*, b* under D65.
        #[schemars(with = "LabColour", extend("examples" = [[62.0, 14.0, 56.0]]))]
        colour: [f64; 3],
        /// Composition of the yolk; that of the lean tissue unless stated.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// How a poured food runs and stands.
    Pour {
        /// Share of the thick white in the white [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.57)]
        thick_share: f64,
        /// Height at which thick white stands [mm].
        #[schemars(range(min = 1.0, max = 15.0), example = 6.0)]
        thick_height_mm: f64,
        /// Height at which the edge of thin white stands [mm].
        #[schemars(range(min = 0.3, max = 5.0), example = 1.8)]
        edge_mm: f64,
        /// Viscosity of what runs, at 20 °C [mPa·s].
        #[schemars(range(min = 1.0, max = 1e5), example = 60.0)]
        viscosity_mpa_s: f64,
        /// Activation energy of the viscosity: warm white runs faster [kJ/mol].
        #[schemars(range(min = 0.0, max = 100.0), example = 20.0)]
        activation_energy_kj_mol: f64,
        /// Name of the change that sets it: where it has gone half way, nothing runs any more.
        #[schemars(example = &"setting")]
        sets_by: String,
    }
}
