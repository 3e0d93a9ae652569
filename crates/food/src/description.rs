//! Foods as they are described in files.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Deserialize;

use crate::form::Form;

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
    /// Sizes that a piece may have, in the order of the form's dimensions.
    SizeRange {
        /// Unless told otherwise [mm].
        default_mm: Vec<f64>,
        /// Smallest [mm].
        min_mm: Vec<f64>,
        /// Largest [mm].
        max_mm: Vec<f64>,
    }
}

sourced_table! {
    /// Outline of the cross-section.
    OutlineShape {
        /// Superellipse exponent [-]; 2 is an ellipse.
        exponent: f64,
        /// Amplitude of the natural waviness over the radius [-].
        ripple: f64,
        /// How much the thickness may differ from one end to the other, over its mean [-].
        #[serde(default)]
        wedge: f64,
        /// Amplitude of the gentle bumps of a cut over the mean thickness [-].
        #[serde(default)]
        bumps: f64,
    }
}

sourced_table! {
    /// A file that holds a closed surface.
    SurfaceFile {
        /// Path beside the food's own file.
        file: String,
        /// Millimetres in one unit of that file [mm].
        scale_mm: Option<f64>,
        /// Direction of the fibres, along which juice moves; it takes the shortest way to the skin unless told [-].
        fibres: Option<[f64; 3]>,
    }
}

impl SizeRange {
    /// No sizes: the file does not give them.
    fn unset() -> Self {
        let source = String::new();
        Self { default_mm: Vec::new(), min_mm: Vec::new(), max_mm: Vec::new(), source, confidence: Confidence::Low }
    }

    /// Whether the file gives sizes.
    pub fn is_set(&self) -> bool {
        !self.default_mm.is_empty()
    }
}

impl OutlineShape {
    /// No outline: the file does not give one.
    fn unset() -> Self {
        Self { exponent: 2.0, ripple: 0.0, wedge: 0.0, bumps: 0.0, source: String::new(), confidence: Confidence::Low }
    }

    /// Whether the file gives an outline.
    pub fn is_set(&self) -> bool {
        !self.source.is_empty()
    }
}

sourced_table! {
    /// The curve of a shrimp.
    Spine {
        /// Angle through which it turns from end to end [°].
        turn_deg: f64,
        /// How much that differs between pieces [°].
        turn_varies_deg: f64,
        /// Breadth over depth of the body [-].
        flattening: f64,
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
    /// Conduction that differs with direction.
    Anisotropy {
        /// Conductivity across the fibres or sheaths over that of the composition [-].
        across: f64,
    }
}

sourced_table! {
    /// Surface properties.
    SurfaceProperties {
        /// Thermal emissivity [-].
        emissivity: f64,
        /// Share of the lower face that comes near to the pan: 1 for flat cuts, less for rounded pieces [-].
        contact_share: f64,
    }
}

sourced_table! {
    /// Colours and their changes, L*, a*, b* under D65.
    Colours {
        /// Raw flesh.
        raw: [f64; 3],
        /// Added when a change is complete, by its name.
        change: BTreeMap<String, [f64; 3]>,
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
    /// A first-order change given by its rate at an anchor temperature.
    Change {
        /// Name by which colours, texture and shrinkage refer to it.
        name: String,
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
        /// Share of the raw water that is lost at least when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
        /// First-order release of what is no longer held, at `release_anchor_c` [1/s].
        release_per_s: f64,
        /// Temperature of that [°C].
        release_anchor_c: f64,
        /// How the release quickens with temperature [kJ/mol].
        release_activation_energy_kj_mol: f64,
        /// Speed of free juice along the fibres [µm/s].
        juice_speed_um_s: f64,
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
    /// Elastic modulus from the changes.
    Texture {
        /// Raw [kPa].
        raw_kpa: f64,
        /// Added when a change is complete, by its name [kPa].
        change_kpa: BTreeMap<String, f64>,
        /// Share of the stress of a bend that is left after a minute [-].
        relaxed_share: f64,
    }
}

sourced_table! {
    /// Hardness on biting over that of the raw food, from the changes.
    Hardness {
        /// Added when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Juiciness on biting: the raw food's water that is left, times one plus the changes' contributions.
    Juiciness {
        /// Added to 1 when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// How far free tissue contracts.
    Shrinkage {
        /// Contraction of a length across the fibres when a change is complete, by its name [-].
        across: BTreeMap<String, f64>,
        /// Contraction along the fibres (a steak's thickness) when a change is complete, by its name [-].
        along: BTreeMap<String, f64>,
        /// Volume over the raw volume below which what is lost leaves pores [-].
        least_volume: f64,
    }
}

sourced_table! {
    /// How a body curls because its belly contracts more than its back.
    Curl {
        /// Difference of the contractions along the body when a change is complete, by its name [-].
        change: BTreeMap<String, f64>,
    }
}

sourced_table! {
    /// Molten fat that leaves the tissue.
    FatRelease {
        /// Share of the lean tissue's fat that can leave [-].
        fine_share: f64,
        /// Share of the fat in seams that can leave [-].
        seam_share: f64,
        /// Temperatures at which the rate is given, ascending [°C].
        celsius: Vec<f64>,
        /// Rate at those temperatures, of fat that lies at a face [1/s].
        rate_per_s: Vec<f64>,
        /// Depth below a face at which the rate has fallen to 1/e [mm].
        depth_mm: f64,
    }
}

/// What heat does to one kind of flesh.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kinetics {
    /// First-order changes, at most [`MOST_CHANGES`]; the first makes fat look cooked, the last tells a cook that it is done.
    pub change: Vec<Change>,
    /// Water holding.
    pub water_holding: WaterHolding,
    /// Fat that leaves.
    pub fat_release: FatRelease,
    /// Contraction.
    pub shrinkage: Shrinkage,
    /// Curling; absent where there is none.
    pub curl: Option<Curl>,
    /// Browning.
    pub browning: BrowningRate,
    /// Charring.
    pub charring: CharringRate,
    /// Death of pathogens.
    pub lethality: Lethality,
    /// Elastic modulus.
    pub texture: Texture,
    /// Hardness.
    pub hardness: Hardness,
    /// Juiciness.
    pub juiciness: Juiciness,
}

/// Most changes that one kind of flesh may have (chosen: beef has four).
pub const MOST_CHANGES: usize = 4;

/// A value for each change, in the order of the kinetics file.
pub type PerChange = [f64; MOST_CHANGES];

/// A name that is no change of the kinetics.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("\"{name}\" in [{table}] is no change of the kinetics; there are: {known}")]
pub struct NoSuchChange {
    /// The table that names it.
    pub table: &'static str,
    /// The name.
    pub name: String,
    /// What there is.
    pub known: String,
}

impl Kinetics {
    /// Names of the changes, in order.
    pub fn names(&self) -> Vec<&str> {
        self.change.iter().map(|c| c.name.as_str()).collect()
    }

    /// The values of a table in the order of the changes; what the table does not name is zero.
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
