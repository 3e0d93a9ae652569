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
    /// The core of a root: a second tissue around its axis, through slices and along sticks.
    Core {
        /// Mean radius over that of the piece [-].
        radius: f64,
        /// Waviness of its edge over its radius [-].
        wave: f64,
        /// How far it may lie off the middle, over the half width [-].
        offset: f64,
        /// Width of the passage from one tissue to the other [mm].
        edge_mm: f64,
        /// Raw colour, L*, a*, b* under D65.
        colour: [f64; 3],
        /// What it consists of; as the rest unless given.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// Concentric sheaths of a shaft, with borders that conduct less; the second tissue is their green.
    Sheaths {
        /// Mean thickness of a sheath [mm].
        thickness_mm: f64,
        /// How much thicknesses differ over their mean [-].
        variation: f64,
        /// Conductance of the border between two sheaths [W/(m²·K)].
        conductance_w_m2k: f64,
        /// Largest share of the green tissue [-].
        greenest: f64,
        /// Raw colour of the green tissue, L*, a*, b* under D65.
        colour: [f64; 3],
        /// What the green tissue consists of; as the rest unless given.
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
        /// How much longer than thick the seams are [-].
        flattening: f64,
    }
}

impl Composition {
    /// Solids other than fat [-].
    pub fn lean_solids(&self) -> f64 {
        self.protein + self.carbohydrate + self.fibre + self.ash
    }

    /// Sum of all fractions [-]; 1 for a complete composition.
    pub fn total(&self) -> f64 {
        self.water + self.fat + self.lean_solids()
    }
}
