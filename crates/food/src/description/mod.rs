//! Descriptions of foods and kinetics, as their TOML files state them.

mod kinetics;
mod properties;
mod shape;
mod tissue;

use std::sync::Arc;

use serde::Deserialize;

use crate::body::form::Form;

pub use kinetics::{
    BrowningRate, Change, CharringRate, Curl, FatRelease, Hardness, Juiciness, Kinetics, Lethality, MOST_CHANGES,
    NoSuchChange, PerChange, Shrinkage, Texture, WaterHolding,
};
pub use properties::{Anisotropy, Colours, Crust, FatMelting, Sorption, SurfaceProperties};
pub use shape::{OutlineShape, SizeRange, Spine, SurfaceFile};
pub use tissue::{Composition, Core, Marbling, Sheaths};

/// Confidence in the numbers of a table.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Confidence {
    /// Measured values or a standard.
    High,
    /// Derived, or measured on a similar material.
    Medium,
    /// An engineering estimate.
    #[default]
    Low,
}

/// Declares a table of a data file: its fields, their source and the confidence in them.
#[macro_export]
macro_rules! sourced_table {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident : $kind:ty),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)*
            /// Source of the numbers, or "chosen" and the reason.
            pub source: String,
            /// Confidence in the numbers.
            pub confidence: $crate::description::Confidence,
        }
    };
}

/// A food, as its file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FoodDescription {
    /// Display name.
    pub name: String,
    /// Id of the kinetics file.
    pub kinetics: String,
    /// Form of the pieces.
    pub form: Form,
    /// Allowed sizes; of a closed surface those of its own file, unless stated.
    #[serde(default = "SizeRange::unset")]
    pub size: SizeRange,
    /// Outline: of slices seen from above, of sticks and shrimps in cross-section; bodies of cells have none.
    #[serde(default = "OutlineShape::unset")]
    pub outline: OutlineShape,
    /// File of a closed surface that is filled with cells; absent in swept forms.
    pub mesh: Option<SurfaceFile>,
    /// The closed surface itself; the reader of the files sets it.
    #[serde(skip)]
    pub body: Option<Arc<saute_heat::Surface>>,
    /// Curve of a shrimp; absent in other forms.
    pub spine: Option<Spine>,
    /// Core of a root; absent in other foods.
    pub core: Option<Core>,
    /// Sheaths of a shaft; absent in other foods.
    pub sheaths: Option<Sheaths>,
    /// Lean tissue.
    pub lean: Composition,
    /// Fat tissue; absent in foods without it.
    pub adipose: Option<Composition>,
    /// Seams of fat tissue; absent in foods without them.
    pub marbling: Option<Marbling>,
    /// Melting of fat.
    pub fat_melting: FatMelting,
    /// Sorption isotherm.
    pub sorption: Sorption,
    /// Dry crust.
    pub crust: Crust,
    /// Anisotropy of conduction; isotropic if absent.
    pub anisotropy: Option<Anisotropy>,
    /// Surface properties.
    pub surface: SurfaceProperties,
    /// Colours.
    pub colour: Colours,
}

impl FoodDescription {
    /// Raw colour of the second tissue, L*, a*, b*; none in foods without it.
    pub fn second_colour(&self) -> Option<[f64; 3]> {
        let sheaths = || self.sheaths.as_ref().map(|s| s.colour);
        self.core.as_ref().map(|c| c.colour).or_else(sheaths)
    }

    /// Composition of the second tissue; the lean tissue unless stated.
    pub fn second_tissue(&self) -> &Composition {
        let core = self.core.as_ref().and_then(|c| c.tissue.as_ref());
        let sheaths = || self.sheaths.as_ref().and_then(|s| s.tissue.as_ref());
        core.or_else(sheaths).unwrap_or(&self.lean)
    }
}
