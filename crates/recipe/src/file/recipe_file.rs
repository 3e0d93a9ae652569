//! The recipe format as it is written, before anything is checked.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::file::action_file::{
    ButterTable, CoolTable, FlipTable, HalveTable, HobTable, LidTable, MovePanTable, MoveTable, OilTable, PressTable,
    PutTable, RestTable, ShakeTable, TiltTable, TossTable, WaterTable,
};
use crate::file::shorthand::Entry;
use saute_kitchen::hands::command::RestOn;

/// A cook: a pan, foods and steps.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute recipe")]
pub struct RecipeFile {
    /// Title for people.
    pub title: Option<String>,
    /// Rules for comparison; everything that this program knows unless given.
    #[schemars(with = "Option<Preset>")]
    pub preset: Option<Preset>,
    /// The cook stops here if the steps have not ended it [s]; 3600 by default.
    #[schemars(with = "Option<f64>", range(min = 1, max = 86400))]
    pub max_s: Option<Spanned<f64>>,
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

/// The pan.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PanEntry {
    /// Id of a pan (`saute list pans`).
    #[schemars(with = "Option<String>")]
    pub kind: Option<Spanned<String>>,
    /// Start temperature [°C]; 20 by default.
    #[schemars(with = "Option<f64>", range(min = 0, max = 300))]
    pub initial_c: Option<Spanned<f64>>,
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
    #[schemars(with = "Option<f64>", range(min = 0, max = 60))]
    pub initial_c: Option<Spanned<f64>>,
    /// Seed of its natural variation; 1 by default. The pieces of a group have seeds that follow each other.
    pub seed: Option<u32>,
    /// Makes a group of so many pieces, which are called id.1, id.2 and so on; one piece with the plain id where it is not
    /// given.
    #[schemars(with = "Option<u32>", range(min = 1, max = MOST_PIECES))]
    pub count: Option<Spanned<i64>>,
    /// Fineness of its mesh; "default" by default.
    pub mesh: Option<MeshName>,
}

/// Pieces that a group may have (chosen: a 26 cm pan takes some 40 shrimps; more is a mistyped number).
pub(crate) const MOST_PIECES: i64 = 200;

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

/// One step: at most one trigger (`at_s`, `after_s`, `when`) and exactly one action. An action takes a table, or a bare value
/// that leaves the table's other keys at their defaults.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepEntry {
    /// Trigger: time from the start [s].
    #[schemars(with = "Option<f64>")]
    pub at_s: Option<Spanned<f64>>,
    /// Trigger: time from the step before [s], or from its end where it says how long it takes, at the earliest when the
    /// hands are done with it; 0 where no trigger is given.
    #[schemars(with = "Option<f64>")]
    pub after_s: Option<Spanned<f64>>,
    /// Trigger: a temperature crosses a value, in either direction.
    #[schemars(with = "Option<WhenEntry>")]
    pub when: Option<Spanned<WhenEntry>>,
    /// Action: sets the hob; a bare number is its electrical power, 0–3500 [W].
    pub hob_w: Option<Entry<HobTable>>,
    /// Action: puts foods into the pan.
    pub put: Option<Entry<PutTable>>,
    /// With a bare `put`: place of its centre relative to the pan's [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>")]
    pub at_mm: Option<Spanned<Vec<f64>>>,
    /// Action: turns foods over.
    pub flip: Option<Entry<FlipTable>>,
    /// Action: takes foods out of the pan to rest.
    pub rest: Option<Entry<RestTable>>,
    /// With a bare `rest`: onto what; the board by default.
    #[schemars(with = "Option<RestOn>")]
    pub on: Option<Spanned<RestOn>>,
    /// Action: cuts foods that lie on the board in halves.
    pub halve: Option<Entry<HalveTable>>,
    /// Action: moves the pan over the hob, or lifts it, until it is moved again; true sets it back onto its ring.
    pub move_pan: Option<Entry<MovePanTable>>,
    /// Action: sets the pan on a wet cloth, off the hob.
    pub cool: Option<Entry<CoolTable>>,
    /// With a bare `cool`: how long [s]; 3 by default.
    #[schemars(with = "Option<f64>", range(min = 0.1, max = 600))]
    pub for_s: Option<Spanned<f64>>,
    /// Action: pours oil into the pan; a bare number is how much [g].
    pub oil_g: Option<Entry<OilTable>>,
    /// Action: puts butter into the pan; a bare number is how much [g].
    pub butter_g: Option<Entry<ButterTable>>,
    /// Action: pours water into the pan; a bare number is how much [g].
    pub water_g: Option<Entry<WaterTable>>,
    /// Action: tosses what lies in the pan; true takes the defaults.
    pub toss: Option<Entry<TossTable>>,
    /// Action: shakes the pan to and fro; a bare number is how long [s].
    pub shake: Option<Entry<ShakeTable>>,
    /// Action: tilts the pan until it is tilted otherwise; a bare number is the angle [°], 0 levels it.
    pub tilt: Option<Entry<TiltTable>>,
    /// Action: presses foods onto the floor with the turner.
    pub press: Option<Entry<PressTable>>,
    /// Action: pushes or carries foods to a place in the pan.
    #[serde(rename = "move")]
    pub move_to: Option<Entry<MoveTable>>,
    /// Action: lays the lid on (true, "on") or takes it off (false, "off").
    pub lid: Option<Entry<LidTable>>,
    /// Action: ends the cook.
    #[schemars(with = "Option<bool>")]
    pub end: Option<Spanned<bool>>,
}

/// A condition: `pan_c`, or `food` with one of its quantities.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WhenEntry {
    /// Area mean of the pan's flat floor [°C].
    pub pan_c: Option<f64>,
    /// Which food; of a group (or "all") the last piece must have crossed the value while the step is waited for.
    #[schemars(with = "Option<String>")]
    pub food: Option<Spanned<String>>,
    /// Its core temperature [°C].
    pub core_c: Option<f64>,
    /// Mean temperature of its upper face [°C].
    pub top_c: Option<f64>,
    /// Mean temperature of its lower face [°C].
    pub bottom_c: Option<f64>,
    /// Its mass [g].
    pub mass_g: Option<f64>,
}
