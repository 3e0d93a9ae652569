//! The tables of the actions, with their limits and defaults.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::file::shorthand::{Shorthand, Written};
use saute_kitchen::hands::command::RestOn;
use saute_kitchen::hands::ranges::{
    COOL_S, FAT_G, FOR_S, HALVE_AT_MM, LIFT_MM, PAN_MM, PLACE_MM, PRESS_N, SHAKE_AMPLITUDE_MM, SHAKE_HZ, TILT_DEG,
    TOSS_HEIGHT_MM, TOWARDS_DEG, WATER_G,
};

/// Temperature at which the hob may hold the pan [°C]; the checked range is that of `hobs/induction.toml`.
pub const HOLD_C: [f64; 2] = [50.0, 230.0];

/// Sets the hob to a power, or lets it hold the pan at a temperature.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HobTable {
    /// Electrical power; with `hold_c` the largest that it uses [W].
    #[schemars(with = "f64", range(min = 0, max = 3500))]
    pub w: Spanned<f64>,
    /// Holds the pan at this temperature by the sensor under the glass, until the hob is set again [°C].
    #[schemars(with = "Option<f64>", range(min = HOLD_C[0], max = HOLD_C[1]))]
    pub hold_c: Option<Spanned<f64>>,
}

/// Puts a food into the pan.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PutTable {
    /// A food, a group, or "all"; of several those that are not in the pan. They are laid side by side.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Place of its centre relative to the pan's, or that about which a group lies [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>", inner(range(min = PLACE_MM.low, max = PLACE_MM.high)), extend("default" = [0, 0], "x-remedy" = "write at_mm = [x, y], for instance [20, 0]"))]
    pub at_mm: Option<Spanned<[f64; 2]>>,
    /// Drops it from above onto what is there, one piece after the other; false by default.
    #[schemars(extend("default" = false))]
    pub heap: Option<bool>,
}

/// Turns foods over.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlipTable {
    /// A food, a group, or "all"; of several those that are in the pan.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
}

/// Takes foods out of the pan to rest.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RestTable {
    /// A food, a group, or "all"; of several those that are in the pan.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Onto what; the board by default.
    #[schemars(extend("default" = "board"))]
    pub on: Option<RestOn>,
}

/// Cuts foods that lie on the board in halves across their long axis, once, and opens them; foil is
/// taken off.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalveTable {
    /// A food, a group, or "all"; of several those that lie on the board whole.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Place of the cut along the long axis, from the middle [mm]; 0 by default.
    #[schemars(with = "Option<f64>", range(min = HALVE_AT_MM.low, max = HALVE_AT_MM.high), extend("default" = HALVE_AT_MM.default))]
    pub at_mm: Option<Spanned<f64>>,
}

/// Moves the pan over the hob, or lifts it, until it is moved again: back onto its ring by default. More than 15 mm above the
/// glass or off the ring it gets no power.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovePanTable {
    /// Its centre relative to the ring's [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>", inner(range(min = PAN_MM.low, max = PAN_MM.high)), extend("default" = [0, 0], "x-remedy" = "write at_mm = [x, y], for instance [20, 0]"))]
    pub at_mm: Option<Spanned<[f64; 2]>>,
    /// Its height above the glass [mm]; 0 by default.
    #[schemars(with = "Option<f64>", range(min = LIFT_MM.low, max = LIFT_MM.high), extend("default" = LIFT_MM.default))]
    pub lift_mm: Option<Spanned<f64>>,
}

/// Sets the pan on something cool, off the hob.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoolTable {
    /// What cools it.
    pub by: CoolBy,
    /// How long [s]; 3 by default.
    #[schemars(with = "Option<f64>", range(min = COOL_S.low, max = COOL_S.high), extend("default" = COOL_S.default))]
    pub for_s: Option<Spanned<f64>>,
}

/// What cools the pan.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CoolBy {
    /// A folded wet cloth.
    WetCloth,
}

/// Pours oil into the pan.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OilTable {
    /// How much [g].
    #[schemars(with = "f64", range(min = FAT_G[0], max = FAT_G[1]))]
    pub g: Spanned<f64>,
    /// Which oil; the kitchen's own by default.
    #[schemars(with = "Option<String>")]
    pub kind: Option<Spanned<String>>,
}

/// Puts butter into the pan.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ButterTable {
    /// How much [g].
    #[schemars(with = "f64", range(min = FAT_G[0], max = FAT_G[1]))]
    pub g: Spanned<f64>,
}

/// Pours water into the pan.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaterTable {
    /// How much [g].
    #[schemars(with = "f64", range(min = WATER_G[0], max = WATER_G[1]))]
    pub g: Spanned<f64>,
}

/// Tosses what is in the pan.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TossTable {
    /// Height of the foods' flight [mm]; 250 by default, which turns most of them over.
    #[schemars(with = "Option<f64>", range(min = TOSS_HEIGHT_MM.low, max = TOSS_HEIGHT_MM.high), extend("default" = TOSS_HEIGHT_MM.default))]
    pub height_mm: Option<Spanned<f64>>,
}

/// Shakes the pan to and fro.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShakeTable {
    /// Farthest from the middle, to either side [mm]; 20 by default.
    #[schemars(with = "Option<f64>", range(min = SHAKE_AMPLITUDE_MM.low, max = SHAKE_AMPLITUDE_MM.high), extend("default" = SHAKE_AMPLITUDE_MM.default))]
    pub amplitude_mm: Option<Spanned<f64>>,
    /// How often a second [Hz]; 3 by default.
    #[schemars(with = "Option<f64>", range(min = SHAKE_HZ.low, max = SHAKE_HZ.high), extend("default" = SHAKE_HZ.default))]
    pub hz: Option<Spanned<f64>>,
    /// How long [s]; 5 by default.
    #[schemars(with = "Option<f64>", range(min = FOR_S.low, max = FOR_S.high), extend("default" = FOR_S.default))]
    pub for_s: Option<Spanned<f64>>,
}

/// Tilts the pan until it is tilted otherwise; 0 levels it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TiltTable {
    /// Angle between floor and horizontal [°].
    #[schemars(with = "f64", range(min = TILT_DEG[0], max = TILT_DEG[1]))]
    pub deg: Spanned<f64>,
    /// Where the floor goes down, from +x over +y as seen from above [°]; 0 by default.
    #[schemars(with = "Option<f64>", range(min = TOWARDS_DEG.low, max = TOWARDS_DEG.high), extend("default" = TOWARDS_DEG.default))]
    pub towards_deg: Option<Spanned<f64>>,
}

/// Presses foods onto the floor with the turner, one after the other.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressTable {
    /// A food, a group, or "all"; of several those that are in the pan.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Force [N]; 10 by default.
    #[schemars(with = "Option<f64>", range(min = PRESS_N.low, max = PRESS_N.high), extend("default" = PRESS_N.default))]
    pub n: Option<Spanned<f64>>,
    /// How long each [s]; 5 by default.
    #[schemars(with = "Option<f64>", range(min = FOR_S.low, max = FOR_S.high), extend("default" = FOR_S.default))]
    pub for_s: Option<Spanned<f64>>,
}

/// Spoons hot fat of the pan over foods in it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BasteTable {
    /// A food, a group, or "all"; of several those that are in the pan.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// How long [s]; 5 by default.
    #[schemars(with = "Option<f64>", range(min = FOR_S.low, max = FOR_S.high), extend("default" = FOR_S.default))]
    pub for_s: Option<Spanned<f64>>,
}

/// Pushes or carries foods to a place in the pan.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MoveTable {
    /// A food, a group, or "all"; of several those that are in the pan. They come to lie side by side.
    #[schemars(with = "String")]
    pub food: Spanned<String>,
    /// Place of its centre relative to the pan's, or that about which a group lies [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>", inner(range(min = PLACE_MM.low, max = PLACE_MM.high)), extend("default" = [0, 0], "x-remedy" = "write to_mm = [x, y], for instance [20, 0]"))]
    pub to_mm: Option<Spanned<[f64; 2]>>,
}

/// Lays the lid on, or takes it off.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LidTable {
    /// True or "on" if it lies on the pan.
    pub on: OnOff,
}

/// The value of an action that is only done: true.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(inline)]
pub struct TrueValue(#[schemars(with = "bool")] pub Spanned<bool>);

impl Written for TrueValue {
    fn is_bare(&self) -> bool {
        true
    }
}

/// Yes or no, also in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, JsonSchema)]
#[schemars(with = "OnOffWords")]
pub struct OnOff(pub bool);

/// How it is written.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected true, false, \"on\" or \"off\"")]
enum OnOffWords {
    /// As true or false.
    Truth(bool),
    /// In words.
    Word(OnOffWord),
}

#[derive(Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum OnOffWord {
    On,
    Off,
}

impl<'de> Deserialize<'de> for OnOff {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self(match OnOffWords::deserialize(deserializer)? {
            OnOffWords::Truth(truth) => truth,
            OnOffWords::Word(word) => matches!(word, OnOffWord::On),
        }))
    }
}

/// Implements [`Shorthand`] for tables whose other keys have defaults.
macro_rules! shorthand {
    ($($table:ident: $bare:ty [$sets:expr] = |$value:ident| $make:expr;)*) => {
        $(impl Shorthand for $table {
            type Bare = $bare;
            const SETS: Option<&'static str> = $sets;

            fn from_bare($value: Spanned<$bare>) -> Result<Self, &'static str> {
                $make
            }
        })*
    };
}

shorthand! {
    HobTable: f64 [Some("w")] = |w| Ok(Self { w, hold_c: None });
    PutTable: String [Some("food")] = |food| Ok(Self { food, at_mm: None, heap: None });
    FlipTable: String [Some("food")] = |food| Ok(Self { food });
    RestTable: String [Some("food")] = |food| Ok(Self { food, on: None });
    HalveTable: String [Some("food")] = |food| Ok(Self { food, at_mm: None });
    MovePanTable: bool [None] = |yes| yes.into_inner().then(Self::default).ok_or(NO_EFFECT);
    CoolTable: CoolBy [Some("by")] = |by| Ok(Self { by: by.into_inner(), for_s: None });
    OilTable: f64 [Some("g")] = |g| Ok(Self { g, kind: None });
    ButterTable: f64 [Some("g")] = |g| Ok(Self { g });
    WaterTable: f64 [Some("g")] = |g| Ok(Self { g });
    TossTable: bool [None] = |yes| yes.into_inner().then(Self::default).ok_or(NO_EFFECT);
    ShakeTable: f64 [Some("for_s")] = |for_s| Ok(Self { for_s: Some(for_s), ..Self::default() });
    TiltTable: f64 [Some("deg")] = |deg| Ok(Self { deg, towards_deg: None });
    PressTable: String [Some("food")] = |food| Ok(Self { food, n: None, for_s: None });
    BasteTable: String [Some("food")] = |food| Ok(Self { food, for_s: None });
    MoveTable: String [Some("food")] = |food| Ok(Self { food, to_mm: None });
    LidTable: OnOff [Some("on")] = |on| Ok(Self { on: on.into_inner() });
}

const NO_EFFECT: &str = "false does nothing: write true, or leave the step out";
