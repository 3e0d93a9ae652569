//! Tissue tables of a food file: composition, core, sheaths and marbling.

use crate::description::LabColour;
use crate::sourced_table;

sourced_table! {
    /// Mass fractions of a tissue [-].
    Composition {
        /// Water [-].
        #[schemars(range(min = 0.01, max = 0.99), example = 0.75)]
        water: f64,
        /// Protein [-].
        #[schemars(range(min = 0.001, max = 0.99), example = 0.20)]
        protein: f64,
        /// Fat [-].
        #[schemars(range(min = 0.0, max = 0.99), example = 0.03)]
        fat: f64,
        /// Carbohydrate without fibre [-].
        #[schemars(range(min = 0.0, max = 0.99), example = 0.0)]
        carbohydrate: f64,
        /// Fibre [-].
        #[schemars(range(min = 0.0, max = 0.99), example = 0.0)]
        fibre: f64,
        /// Ash [-].
        #[schemars(range(min = 0.0, max = 0.2), example = 0.01)]
        ash: f64,
    }
}

sourced_table! {
    /// Core of a root: a second tissue around its axis, through the thickness of slices and along sticks.
    Core {
        /// Mean radius relative to that of the piece [-].
        #[schemars(range(min = 0.05, max = 1.5), example = 0.5)]
        radius: f64,
        /// Waviness of the edge relative to the radius of the core [-].
        #[schemars(range(min = 0.0, max = 0.5), example = 0.1)]
        wave: f64,
        /// Largest distance from the middle, relative to the half width [-].
        #[schemars(range(min = 0.0, max = 1.5), example = 0.1)]
        offset: f64,
        /// Width of the transition between the tissues [mm].
        #[schemars(range(min = 0.05, max = 10.0), example = 0.5)]
        edge_mm: f64,
        /// Raw colour, L*, a*, b* under D65.
        #[schemars(with = "LabColour", extend("examples" = [[64.0, 22.0, 46.0]]))]
        colour: [f64; 3],
        /// Composition of the core; that of the lean tissue unless stated.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// Concentric sheaths of a shaft with resistive borders; the second tissue is their green.
    Sheaths {
        /// Mean thickness of a sheath [mm].
        #[schemars(range(min = 0.5, max = 20.0), example = 2.2)]
        thickness_mm: f64,
        /// Variation of the thickness relative to its mean [-].
        #[schemars(range(min = 0.0, max = 0.8), example = 0.3)]
        variation: f64,
        /// Conductance of the border between two sheaths [W/(m²·K)].
        #[schemars(range(min = 10.0, max = 1e6), example = 700.0)]
        conductance_w_m2k: f64,
        /// Largest share of the green tissue [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.9)]
        greenest: f64,
        /// Raw colour of the green tissue, L*, a*, b* under D65.
        #[schemars(with = "LabColour", extend("examples" = [[58.0, -20.0, 34.0]]))]
        colour: [f64; 3],
        /// Composition of the green tissue; that of the lean tissue unless stated.
        tissue: Option<Composition>,
    }
}

sourced_table! {
    /// Fat seams in the flesh.
    Marbling {
        /// Mean mass share of adipose tissue [-].
        #[schemars(range(min = 0.0, max = 0.6), example = 0.2)]
        adipose_share: f64,
        /// Typical distance between seams [mm].
        #[schemars(range(min = 1.0, max = 50.0), example = 9.0)]
        seam_mm: f64,
        /// Length of the seams relative to their thickness [-].
        #[schemars(range(min = 1.0, max = 20.0), example = 3.0)]
        flattening: f64,
        /// Lean of the seams off the fibres, across over along, at most; each piece leans by its seed [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 2.0), example = 0.6)]
        slant: f64,
    }
}

sourced_table! {
    /// Strip of fat tissue along one long side of a steak with its natural form.
    FatCap {
        /// Thickness of the thinnest and the thickest cap at their middle [mm].
        #[schemars(inner(range(min = 0.5, max = 30.0)), extend("examples" = [[4.0, 8.0]]))]
        thickness_mm: [f64; 2],
        /// Share of the outline along the shortest and the longest cap [-].
        #[schemars(inner(range(min = 0.05, max = 0.6)), extend("examples" = [[0.30, 0.42]]))]
        share: [f64; 2],
        /// Width of the transition to the flesh [mm].
        #[schemars(range(min = 0.1, max = 5.0), example = 1.0)]
        edge_mm: f64,
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
