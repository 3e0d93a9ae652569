//! Descriptions of foods and kinetics, as their TOML files state them.

mod kinetics;
mod lab_colour;
mod pour;
mod properties;
mod relations;
mod shape;
mod tissue;
mod words;

use std::collections::BTreeMap;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::body::form::Form;
use crate::change::doneness::Scale;
use crate::paper_2013::Rules;

pub(crate) use kinetics::Effects;
pub use kinetics::{
    BrowningRate, Change, CharringRate, Curl, FatRelease, Hardness, Juiciness, Kinetics, Lethality, MOST_CHANGES,
    NoSuchChange, PerChange, Shrinkage, Texture, WaterHolding,
};
pub use lab_colour::{LabColour, LabShift};
pub use pour::{Pour, Yolk};
pub use properties::{Anisotropy, Colours, Crust, FatMelting, Freezing, Sorption, SurfaceProperties};
pub use shape::{NaturalForm, OutlineKind, OutlineShape, PieceSpread, SizeRange, Spine, SurfaceFile};
pub use tissue::{Composition, Core, FatCap, Marbling, Sheaths};
pub use words::{FILE_LANGUAGE, Feel, FoodWords};

/// Confidence in the numbers of a table.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
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
        #[derive(Clone, Debug, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)*
            /// Source of the numbers, or "chosen" and the reason.
            #[schemars(example = &"chosen: …")]
            pub source: String,
            /// Confidence in the numbers.
            #[schemars(example = &"low")]
            pub confidence: $crate::description::Confidence,
        }
    };
}

/// What flesh looks like near by.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Flesh {
    /// Muscle: bundles of fibres through the thickness.
    Muscle,
    /// Ground meat: strands pressed together.
    Ground,
    /// A root: core, cortex and rays between.
    Root,
    /// A shaft of sheaths, one in the other.
    Sheaths,
    /// The segments of a shrimp.
    Segments,
    /// Fish: flakes of muscle with pale sheets between them, across the length.
    Flakes,
    /// Even flesh: curd, tubers.
    Plain,
    /// A slice of a mushroom: skin round its cap, gills beside its stem.
    Mushroom,
    /// An egg: white and yolk.
    Egg,
    /// Layers of an onion, each with veins along it under a thin skin.
    Layers,
    /// The wall of a pod: a smooth skin outside, ribbed flesh inside.
    Pod,
}

/// Protein from which flesh without a second tissue is muscle (chosen: no plant that is fried raw has as much).
const MUSCLE_PROTEIN: f64 = 0.10;

sourced_table! {
    /// How a food is served unless the cook states otherwise.
    Served {
        /// Share of each face that is browned [%].
        #[schemars(range(min = 0.0, max = 100.0), example = 60.0)]
        crust_pct: f64,
        /// Times that a plan turns it at most [-]; as often as the cook allows without it.
        #[serde(default)]
        #[schemars(range(min = 0, max = 40), example = 1)]
        most_flips: Option<u32>,
        /// Time that a plan lets it rest at most [s]; until its core has peaked without it.
        #[serde(default)]
        #[schemars(range(min = 0, max = 600), example = 20)]
        most_rest_s: Option<u32>,
        /// Temperature of the pan about which plans put it in [°C]; 140 to 230 without it.
        #[serde(default)]
        #[schemars(range(min = 80, max = 250), example = 140)]
        pan_c: Option<u32>,
    }
}

/// A food, as its file describes it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute food")]
pub struct FoodDescription {
    /// Display name.
    #[schemars(example = &"My food")]
    pub name: String,
    /// Id of the kinetics file: what heat does to this kind of flesh.
    #[schemars(example = &"beef")]
    pub kinetics: String,
    /// What the food is called, by the code of the language.
    #[serde(default)]
    pub words: BTreeMap<String, FoodWords>,
    /// The food's own scale of doneness, in whose words no other food is spoken of; without it the scales for its kinetics.
    pub doneness: Option<Scale>,
    /// Form of the pieces.
    #[schemars(example = &"steak")]
    pub form: Form,
    /// What the flesh looks like near by; without it what its tissues and its protein suggest.
    #[schemars(example = &"muscle")]
    pub flesh: Option<Flesh>,
    /// How the food is served unless the cook states otherwise; without it as a food that is not fried for its crust.
    pub served: Option<Served>,
    /// Allowed sizes; of a closed surface those of its own file, unless stated.
    #[serde(default = "SizeRange::unset")]
    #[schemars(with = "Option<SizeRange>")]
    pub size: SizeRange,
    /// Outline: of slices seen from above, of sticks and shrimps in cross-section; bodies of cells have none.
    #[serde(default = "OutlineShape::unset")]
    #[schemars(with = "Option<OutlineShape>")]
    pub outline: OutlineShape,
    /// Natural form; a food without it has plain pieces.
    pub natural: Option<NaturalForm>,
    /// Spread of the pieces about the mean piece; absent in foods whose pieces are all alike.
    pub spread: Option<PieceSpread>,
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
    /// Yolk of a poured food; absent in other foods.
    pub yolk: Option<Yolk>,
    /// How a poured food runs and stands; absent in other foods.
    pub pour: Option<Pour>,
    /// What the flesh consists of: mass fractions that add up to 1.
    pub lean: Composition,
    /// Fat tissue; absent in foods without it.
    pub adipose: Option<Composition>,
    /// Seams of fat tissue; absent in foods without them.
    pub marbling: Option<Marbling>,
    /// Strip of fat tissue along one long side of a steak; absent in foods without it.
    pub fat_cap: Option<FatCap>,
    /// Melting of the fat.
    pub fat_melting: FatMelting,
    /// Freezing of the water; a food without it cannot be colder than 0 °C.
    pub freezing: Option<Freezing>,
    /// GAB sorption isotherm: how tightly the last water is held.
    pub sorption: Sorption,
    /// The dry crust.
    pub crust: Crust,
    /// Anisotropy of conduction; isotropic if absent.
    pub anisotropy: Option<Anisotropy>,
    /// Surface properties.
    pub surface: SurfaceProperties,
    /// Colours and their changes, L*, a*, b* under D65.
    pub colour: Colours,
}

impl FoodDescription {
    /// Returns true if a piece may begin as ice: its file states how it freezes, and its rules know ice.
    pub fn may_be_ice(&self, rules: Rules) -> bool {
        rules == Rules::Full && self.freezing.is_some()
    }

    /// What the flesh looks like near by.
    pub fn flesh(&self) -> Flesh {
        let suggested = || match () {
            () if self.core.is_some() => Flesh::Root,
            () if self.sheaths.is_some() => Flesh::Sheaths,
            () if self.lean.protein > MUSCLE_PROTEIN => Flesh::Muscle,
            () => Flesh::Plain,
        };
        self.flesh.unwrap_or_else(suggested)
    }

    /// Temperature of the pan about which plans put it in [°C]; none where plans choose.
    pub fn plan_pan_c(&self) -> Option<u32> {
        self.served.as_ref().and_then(|served| served.pan_c)
    }

    /// Times that a plan turns it at most, given those of other foods [-].
    pub fn most_flips(&self, usual: usize) -> usize {
        let stated = self.served.as_ref().and_then(|served| served.most_flips);
        stated.map_or(usual, |most| usual.min(most as usize))
    }

    /// Time that a plan lets it rest at most [s]; none where it rests until its core has peaked.
    pub fn most_rest_s(&self) -> Option<u32> {
        self.served.as_ref().and_then(|served| served.most_rest_s)
    }

    /// Share of each face that is browned unless the cook states another [%].
    pub fn crust_pct(&self) -> f64 {
        self.served.as_ref().map_or(0.0, |served| served.crust_pct)
    }

    /// Raw colour of the second tissue, L*, a*, b*; none in foods without it.
    pub fn second_colour(&self) -> Option<[f64; 3]> {
        let sheaths = || self.sheaths.as_ref().map(|s| s.colour);
        let yolk = || self.yolk.as_ref().map(|y| y.colour);
        self.core.as_ref().map(|c| c.colour).or_else(sheaths).or_else(yolk)
    }

    /// Composition of the second tissue; the lean tissue unless stated.
    pub fn second_tissue(&self) -> &Composition {
        let core = self.core.as_ref().and_then(|c| c.tissue.as_ref());
        let sheaths = || self.sheaths.as_ref().and_then(|s| s.tissue.as_ref());
        let yolk = || self.yolk.as_ref().and_then(|y| y.tissue.as_ref());
        core.or_else(sheaths).or_else(yolk).unwrap_or(&self.lean)
    }
}
