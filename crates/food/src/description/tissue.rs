//! Tissue tables of a food file: composition, core, sheaths and marbling.

use crate::sourced_table;

sourced_table! {
    /// Mass fractions of a tissue [-].
    Composition {
        /// Water [-].
        water: f64,
        /// Protein [-].
        protein: f64,
        /// Fat [-].
        fat: f64,
        /// Carbohydrate without fibre [-].
        carbohydrate: f64,
        /// Fibre [-].
        fibre: f64,
        /// Ash [-].
        ash: f64,
    }
}

sourced_table! {
    /// Core of a root: a second tissue around its axis, through the thickness of slices and along sticks.
    Core {
        /// Mean radius relative to that of the piece [-].
        radius: f64,
        /// Waviness of the edge relative to the radius of the core [-].
        wave: f64,
        /// Largest distance from the middle, relative to the half width [-].
        offset: f64,
        /// Width of the transition between the tissues [mm].
        edge_mm: f64,
        /// Raw colour, L*, a*, b* under D65.
        colour: [f64; 3],
        /// Composition of the core; that of the lean tissue unless stated.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// Concentric sheaths of a shaft with resistive borders; the second tissue is their green.
    Sheaths {
        /// Mean thickness of a sheath [mm].
        thickness_mm: f64,
        /// Variation of the thickness relative to its mean [-].
        variation: f64,
        /// Conductance of the border between two sheaths [W/(m²·K)].
        conductance_w_m2k: f64,
        /// Largest share of the green tissue [-].
        greenest: f64,
        /// Raw colour of the green tissue, L*, a*, b* under D65.
        colour: [f64; 3],
        /// Composition of the green tissue; that of the lean tissue unless stated.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// Fat seams in the flesh.
    Marbling {
        /// Mean mass share of adipose tissue [-].
        adipose_share: f64,
        /// Typical distance between seams [mm].
        seam_mm: f64,
        /// Length of the seams relative to their thickness [-].
        flattening: f64,
    }
}

impl Composition {
    /// Mass fraction of the solids other than fat [-].
    pub fn lean_solids(&self) -> f64 {
        self.protein + self.carbohydrate + self.fibre + self.ash
    }

    /// Sum of all fractions [-]; 1 for a complete composition.
    pub fn total(&self) -> f64 {
        self.water + self.fat + self.lean_solids()
    }
}
