//! The recipe format as it is written, before anything is checked.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::command::RestOn;

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
    /// Name that the steps use.
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
    /// Seed of its natural variation; 1 by default.
    pub seed: Option<u32>,
}

/// One step: at most one trigger (`at_s`, `after_s`, `when`) and exactly one action.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepEntry {
    /// Trigger: time from the start [s].
    #[schemars(with = "Option<f64>")]
    pub at_s: Option<Spanned<f64>>,
    /// Trigger: time from the end of the step before [s]; 0 where no trigger is given.
    #[schemars(with = "Option<f64>")]
    pub after_s: Option<Spanned<f64>>,
    /// Trigger: a temperature crosses a value, in either direction.
    #[schemars(with = "Option<WhenEntry>")]
    pub when: Option<Spanned<WhenEntry>>,
    /// Action: electrical power of the hob, 0–3500 [W].
    #[schemars(with = "Option<f64>", range(min = 0, max = 3500))]
    pub hob_w: Option<Spanned<f64>>,
    /// Action: puts a food into the pan.
    #[schemars(with = "Option<String>")]
    pub put: Option<Spanned<String>>,
    /// With `put`: place of its centre relative to the pan's [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>")]
    pub at_mm: Option<Spanned<Vec<f64>>>,
    /// Action: turns a food over.
    #[schemars(with = "Option<String>")]
    pub flip: Option<Spanned<String>>,
    /// Action: takes a food out of the pan to rest.
    #[schemars(with = "Option<String>")]
    pub rest: Option<Spanned<String>>,
    /// With `rest`: onto what; the board by default.
    #[schemars(with = "Option<RestOn>")]
    pub on: Option<Spanned<RestOn>>,
    /// Action: moves the pan over the hob, or lifts it, until it is moved again.
    #[schemars(with = "Option<MovePanEntry>")]
    pub move_pan: Option<Spanned<MovePanEntry>>,
    /// Action: sets the pan on a wet cloth, off the hob.
    #[schemars(with = "Option<CoolBy>")]
    pub cool: Option<Spanned<CoolBy>>,
    /// With `cool`: how long [s]; 3 by default.
    #[schemars(with = "Option<f64>", range(min = 0.1, max = 600))]
    pub for_s: Option<Spanned<f64>>,
    /// Action: ends the cook.
    #[schemars(with = "Option<bool>")]
    pub end: Option<Spanned<bool>>,
}

/// Where the pan goes: back onto its ring by default. More than 15 mm above the glass or off the ring it gets no power.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovePanEntry {
    /// Its centre relative to the ring's [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>")]
    pub at_mm: Option<Spanned<Vec<f64>>>,
    /// Its height above the glass [mm]; 0 by default.
    #[schemars(with = "Option<f64>", range(min = 0, max = 500))]
    pub lift_mm: Option<Spanned<f64>>,
}

/// What cools the pan.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CoolBy {
    /// A folded wet cloth.
    WetCloth,
}

/// A condition: `pan_c`, or `food` with one of its quantities.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WhenEntry {
    /// Area mean of the pan's flat floor [°C].
    pub pan_c: Option<f64>,
    /// Which food.
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
