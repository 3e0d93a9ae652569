//! Foods as they are described in files.

use serde::Deserialize;

/// How well a number is known.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Confidence {
    /// Measured or standard.
    High,
    /// Derived, or measured on something near.
    Medium,
    /// An engineering estimate.
    #[default]
    Low,
}

/// Declares a table of a data file: its fields, and where they come from (`source`, `confidence`).
#[macro_export]
macro_rules! sourced_table {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident : $kind:ty),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)*
            /// Where the numbers come from, or "chosen" and why.
            pub source: String,
            /// How well they are known.
            pub confidence: $crate::description::Confidence,
        }
    };
}

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
    /// Sizes that a piece may have.
    SizeRange {
        /// Length, width, thickness unless told otherwise [mm].
        default_mm: [f64; 3],
        /// Smallest [mm].
        min_mm: [f64; 3],
        /// Largest [mm].
        max_mm: [f64; 3],
    }
}

sourced_table! {
    /// Outline of the cross-section.
    OutlineShape {
        /// Superellipse exponent [-]; 2 is an ellipse.
        exponent: f64,
        /// Amplitude of the natural waviness over the radius [-].
        ripple: f64,
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

sourced_table! {
    /// Melting of the fat.
    FatMelting {
        /// Half of the fat is liquid here [°C].
        middle_c: f64,
        /// Width of the logistic transition [K].
        width_k: f64,
        /// Latent heat of fusion [J/kg].
        latent_j_kg: f64,
    }
}

sourced_table! {
    /// GAB sorption isotherm.
    Sorption {
        /// Monolayer moisture X_m [kg/kg dry].
        monolayer: f64,
        /// GAB constant C [-].
        c: f64,
        /// GAB constant K [-].
        k: f64,
        /// Water activity of the fresh food [-].
        fresh_activity: f64,
    }
}

sourced_table! {
    /// Dry crust.
    Crust {
        /// Thermal conductivity of the dry, porous crust [W/(m·K)].
        conductivity_w_mk: f64,
    }
}

sourced_table! {
    /// Surface properties.
    SurfaceProperties {
        /// Thermal emissivity [-].
        emissivity: f64,
    }
}

sourced_table! {
    /// Colours and their changes, L*, a*, b* under D65.
    Colours {
        /// Raw flesh.
        raw: [f64; 3],
        /// Added when all myosin is denatured.
        myosin: [f64; 3],
        /// Added when all myoglobin is denatured.
        myoglobin: [f64; 3],
        /// Golden stage of browning.
        golden: [f64; 3],
        /// Browning at which the golden stage is reached [-].
        golden_at: f64,
        /// Fully browned crust.
        crust: [f64; 3],
        /// Charred.
        char: [f64; 3],
        /// Raw fat.
        fat_raw: [f64; 3],
        /// Molten, cooked fat.
        fat_cooked: [f64; 3],
        /// Browned fat.
        fat_brown: [f64; 3],
    }
}

sourced_table! {
    /// A first-order reaction given by its rate at an anchor temperature.
    Denaturation {
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
        /// First-order release of what is no longer held [1/s].
        release_per_s: f64,
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
    /// Elastic modulus from protein states.
    Texture {
        /// Raw [kPa].
        raw_kpa: f64,
        /// Added when all myosin is denatured [kPa].
        myosin_kpa: f64,
        /// Added when all actin is denatured [kPa].
        actin_kpa: f64,
    }
}

/// What heat does to one kind of flesh.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kinetics {
    /// Myosin.
    pub myosin: Denaturation,
    /// Collagen with sarcoplasmic proteins.
    pub collagen: Denaturation,
    /// Actin.
    pub actin: Denaturation,
    /// Myoglobin.
    pub myoglobin: Denaturation,
    /// Water holding.
    pub water_holding: WaterHolding,
    /// Browning.
    pub browning: BrowningRate,
    /// Charring.
    pub charring: CharringRate,
    /// Death of pathogens.
    pub lethality: Lethality,
    /// Elastic modulus.
    pub texture: Texture,
}

/// The shapes that can be built.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// A superellipse outline times a thickness; fibres run through the thickness.
    Steak,
}

/// A food as its file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FoodDescription {
    /// Name for people.
    pub name: String,
    /// Id of the kinetics file.
    pub kinetics: String,
    /// Shape.
    pub form: Form,
    /// Allowed sizes.
    pub size: SizeRange,
    /// Outline.
    pub outline: OutlineShape,
    /// Lean tissue.
    pub lean: Composition,
    /// Fat tissue.
    pub adipose: Composition,
    /// Fat seams.
    pub marbling: Marbling,
    /// Melting of fat.
    pub fat_melting: FatMelting,
    /// Sorption isotherm.
    pub sorption: Sorption,
    /// Dry crust.
    pub crust: Crust,
    /// Surface.
    pub surface: SurfaceProperties,
    /// Colours.
    pub colour: Colours,
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
