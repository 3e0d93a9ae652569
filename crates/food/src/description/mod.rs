//! Foods as they are described in files.

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
    /// Allowed sizes; of a surface of the user's those of its file unless told.
    #[serde(default = "SizeRange::unset")]
    pub size: SizeRange,
    /// Outline: of slices as seen from above, of sticks and shrimps across them; bodies of cells have none.
    #[serde(default = "OutlineShape::unset")]
    pub outline: OutlineShape,
    /// Closed surface that is meshed inside; absent where the form is swept.
    pub mesh: Option<SurfaceFile>,
    /// What that file encloses; whoever reads the files puts it here.
    #[serde(skip)]
    pub body: Option<Arc<saute_heat::Surface>>,
    /// Curve of a shrimp; other forms have none.
    pub spine: Option<Spine>,
    /// Core of a root; absent where there is none.
    pub core: Option<Core>,
    /// Sheaths of a shaft; absent where there are none.
    pub sheaths: Option<Sheaths>,
    /// Lean tissue.
    pub lean: Composition,
    /// Fat tissue; absent where there is none.
    pub adipose: Option<Composition>,
    /// Seams of fat tissue; absent where there are none.
    pub marbling: Option<Marbling>,
    /// Melting of fat.
    pub fat_melting: FatMelting,
    /// Sorption isotherm.
    pub sorption: Sorption,
    /// Dry crust.
    pub crust: Crust,
    /// Conduction across; as along unless given.
    pub anisotropy: Option<Anisotropy>,
    /// Surface.
    pub surface: SurfaceProperties,
    /// Colours.
    pub colour: Colours,
}

impl FoodDescription {
    /// Raw colour of the second tissue, where there is one.
    pub fn second_colour(&self) -> Option<[f64; 3]> {
        let sheaths = || self.sheaths.as_ref().map(|s| s.colour);
        self.core.as_ref().map(|c| c.colour).or_else(sheaths)
    }

    /// What the second tissue consists of; the lean tissue where nothing else is said.
    pub fn second_tissue(&self) -> &Composition {
        let core = self.core.as_ref().and_then(|c| c.tissue.as_ref());
        let sheaths = || self.sheaths.as_ref().and_then(|s| s.tissue.as_ref());
        core.or_else(sheaths).unwrap_or(&self.lean)
    }
}
