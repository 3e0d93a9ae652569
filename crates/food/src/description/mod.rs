//! Foods as they are described in files.

mod kinetics;
mod lab_colour;
mod properties;
mod shape;
mod tissue;

use std::sync::Arc;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::body::form::Form;

pub use kinetics::{
    BrowningRate, Change, CharringRate, Curl, FatRelease, Hardness, Juiciness, Kinetics, Lethality, MOST_CHANGES,
    NoSuchChange, PerChange, Shrinkage, Texture, WaterHolding,
};
pub use lab_colour::{LabColour, LabShift};
pub use properties::{Anisotropy, Colours, Crust, FatMelting, Sorption, SurfaceProperties};
pub use shape::{OutlineShape, SizeRange, Spine, SurfaceFile};
pub use tissue::{Composition, Core, Marbling, Sheaths};

/// How well a number is known.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
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
///
/// The table derives [`schemars::JsonSchema`]: the field's doc comment is its meaning, `#[schemars(range(…))]` the range
/// in which a file may set it, `#[schemars(example = …)]` what a message proposes to write. The calling crate depends on
/// `schemars` and `serde`.
#[macro_export]
macro_rules! sourced_table {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident : $kind:ty),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)*
            /// Where the numbers come from, or "chosen" and why.
            #[schemars(example = &"chosen: …")]
            pub source: String,
            /// How well they are known.
            #[schemars(example = &"low")]
            pub confidence: $crate::description::Confidence,
        }
    };
}

/// A food as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute food")]
pub struct FoodDescription {
    /// Name for people.
    #[schemars(example = &"My food")]
    pub name: String,
    /// Id of the kinetics file: what heat does to this kind of flesh.
    #[schemars(example = &"beef")]
    pub kinetics: String,
    /// Shape that is built.
    #[schemars(example = &"steak")]
    pub form: Form,
    /// Allowed sizes; of the form "mesh" those of its surface file unless given.
    #[serde(default = "SizeRange::unset")]
    #[schemars(with = "Option<SizeRange>")]
    pub size: SizeRange,
    /// Outline: of slices as seen from above, of sticks and shrimps across them; bodies of cells have none.
    #[serde(default = "OutlineShape::unset")]
    #[schemars(with = "Option<OutlineShape>")]
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
    /// What the flesh consists of: mass fractions that add up to 1.
    pub lean: Composition,
    /// What fat tissue consists of: mass fractions that add up to 1; absent where there is none.
    pub adipose: Option<Composition>,
    /// Seams of fat tissue; absent where there are none.
    pub marbling: Option<Marbling>,
    /// Melting of the fat.
    pub fat_melting: FatMelting,
    /// GAB sorption isotherm: how tightly the last water is held.
    pub sorption: Sorption,
    /// The dry crust.
    pub crust: Crust,
    /// Conduction across; as along unless given.
    pub anisotropy: Option<Anisotropy>,
    /// Properties of the surface.
    pub surface: SurfaceProperties,
    /// Colours and their changes, L*, a*, b* under D65.
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
