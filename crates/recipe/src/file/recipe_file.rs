//! The format of a recipe file.

use saute_food::OutlineKind;
use saute_kitchen::PieceOrder;
use saute_kitchen::hands::ranges::{MAX_S, MINUTES, PAN_INITIAL_C, PAN_OIL_G};
use saute_kitchen::piece::memory::MOST_PIECES;
use schemars::transform::transform_subschemas;
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use toml::Spanned;

use crate::file::shorthand::{ShortOrTable, Shorthand};
use crate::file::step_file::StepEntry;

/// A cook: a pan, foods and steps.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute recipe")]
pub struct RecipeFile {
    /// Title for people.
    pub title: Option<String>,
    /// How long it takes from the cold pan to the plate, for lists of recipes [min].
    #[schemars(with = "Option<f64>", range(min = MINUTES.low, max = MINUTES.high))]
    pub minutes: Option<Spanned<f64>>,
    /// Rules for comparison; everything that this program knows unless given.
    #[schemars(with = "Option<Preset>")]
    pub preset: Option<Preset>,
    /// The cook stops here if the steps have not ended it [s]; 3600 by default.
    #[schemars(with = "Option<f64>", range(min = MAX_S.low, max = MAX_S.high))]
    pub max_s: Option<Spanned<f64>>,
    /// The hob; that of the kitchen at home by default.
    #[schemars(with = "Option<HobEntry>")]
    pub hob: Option<HobEntry>,
    /// The pan; a carbon steel pan at 20 °C by default.
    #[schemars(with = "Option<PanEntry>")]
    pub pan: Option<Spanned<PanEntry>>,
    /// Foods that the steps use.
    #[serde(default)]
    #[schemars(with = "Vec<FoodEntry>")]
    pub food: Vec<Spanned<FoodEntry>>,
    /// What happens, strictly in order.
    #[serde(default)]
    #[schemars(with = "Vec<StepEntry>")]
    pub step: Vec<Spanned<StepEntry>>,
}

/// Rules for comparison.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum Preset {
    /// Those of the 2013 Interactive Cooking Simulator: heat along line segments, contact by distance, all heat above
    /// boiling into vapour, browning above 150 °C by weight loss in four stages, a cloth that cools at once.
    #[serde(rename = "2013")]
    Paper2013,
}

/// The hob.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HobEntry {
    /// Id of a hob (`saute list hobs`).
    #[schemars(with = "String")]
    pub kind: Spanned<String>,
}

/// The pan.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PanEntry {
    /// Id of a pan (`saute list pans`).
    #[schemars(with = "Option<String>")]
    pub kind: Option<Spanned<String>>,
    /// Start temperature [°C]; 20 by default.
    #[schemars(with = "Option<f64>", range(min = PAN_INITIAL_C.low, max = PAN_INITIAL_C.high))]
    pub initial_c: Option<Spanned<f64>>,
    /// Canola oil in it at the start [g]; 0 is dry, apart from the film of a seasoned pan. By default 5, or none if a step pours oil or
    /// butter before the first food goes in.
    #[schemars(with = "Option<f64>", range(min = PAN_OIL_G[0], max = PAN_OIL_G[1]))]
    pub oil_g: Option<Spanned<f64>>,
}

/// One food.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FoodEntry {
    /// Name that the steps use: letters, digits, - and _; not "all".
    #[schemars(with = "String")]
    pub id: Spanned<String>,
    /// Id of a food (`saute list foods`).
    #[schemars(with = "String")]
    pub kind: Spanned<String>,
    /// Length, width, thickness of a steak; diameter, thickness of a disc [mm]; the food's own by default.
    #[schemars(with = "Option<Vec<f64>>")]
    pub size_mm: Option<Spanned<Vec<f64>>>,
    /// Temperature at which it goes into the pan [°C]; 5 by default.
    #[schemars(with = "Option<f64>", range(min = PieceOrder::INITIAL_C[0], max = PieceOrder::INITIAL_C[1]))]
    pub initial_c: Option<Spanned<f64>>,
    /// Spacing of its mesh relative to the default [-]; 1 by default. A result that has settled hardly changes at 0.5.
    #[schemars(with = "Option<f64>", range(min = *PieceOrder::COARSENESS.start(), max = *PieceOrder::COARSENESS.end()))]
    pub coarseness: Option<Spanned<f64>>,
    /// Seed of its natural variation; 1 by default. The pieces of a group have seeds that follow each other.
    #[schemars(range(max = u32::MAX))]
    pub seed: Option<u32>,
    /// Makes a group of so many pieces, which are called id.1, id.2 and so on; one piece with the plain id where it is not
    /// given.
    #[schemars(with = "Option<u32>", range(min = 1, max = MOST_PIECES))]
    pub count: Option<Spanned<u32>>,
    /// Fineness of its mesh; "default" by default.
    pub mesh: Option<MeshName>,
    /// "natural" (default): each seed gives a piece of its own form; "plain": the same plain outline for all; "individual": as
    /// natural, and each seed also differs in composition, fibres, unevenness and juice, as its food states the spread.
    pub outline: Option<OutlineKind>,
}

/// Fineness of a mesh.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum MeshName {
    /// As fine as the physics asks for.
    #[default]
    #[serde(rename = "default")]
    Default,
    /// As many vertices as the 2013 Interactive Cooking Simulator had.
    #[serde(rename = "2013")]
    Paper2013,
}

/// A condition: `pan_c`, or `food` with one of its quantities. It is true at once if it holds already. A bare number means
/// above for a temperature and below for a mass.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WhenEntry {
    /// Area mean of the pan's flat floor [°C].
    #[schemars(transform = of_temperatures)]
    pub pan_c: Option<ShortOrTable<SideTable>>,
    /// Which food; of a group (or "all") the last piece must have met the condition while the step is waited for.
    #[schemars(with = "Option<String>")]
    pub food: Option<Spanned<String>>,
    /// Its core temperature [°C].
    #[schemars(transform = of_temperatures)]
    pub core_c: Option<ShortOrTable<SideTable>>,
    /// Mean temperature of its upper face [°C].
    #[schemars(transform = of_temperatures)]
    pub top_c: Option<ShortOrTable<SideTable>>,
    /// Mean temperature of its lower face [°C].
    #[schemars(transform = of_temperatures)]
    pub bottom_c: Option<ShortOrTable<SideTable>>,
    /// Its mass [g].
    pub mass_g: Option<ShortOrTable<SideTable>>,
}

/// Largest mass of a condition [g] (chosen: beyond any food).
const LARGEST_G: f64 = 5e5;
/// Largest temperature of a condition [°C] (chosen: beyond any pan).
const LARGEST_C: f64 = 500.0;

/// Narrows the range of masses to that of temperatures, wherever it is stated in a schema.
fn of_temperatures(schema: &mut Schema) {
    if let Some(largest) = schema.get_mut("maximum") {
        *largest = LARGEST_C.into();
    }
    transform_subschemas(&mut of_temperatures, schema);
}

/// The side of a value on which a quantity must be: one of the two keys.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub struct SideTable {
    /// The quantity is at this value or above it, in the unit of its key.
    #[schemars(range(min = 0, max = LARGEST_G))]
    pub above: Option<f64>,
    /// The quantity is at this value or below it, in the unit of its key.
    #[schemars(range(min = 0, max = LARGEST_G))]
    pub below: Option<f64>,
}

/// The side of a bare number depends on the quantity; the check chooses it.
impl Shorthand for SideTable {
    type Bare = f64;
    const SETS: Option<&'static str> = Some("above");

    fn from_bare(value: Spanned<f64>) -> Result<Self, &'static str> {
        Ok(Self { above: Some(value.into_inner()), below: None })
    }
}
