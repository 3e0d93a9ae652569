//! The list of actions: for each its kind, its key in a recipe, its format and its description.

use core::fmt;

use schemars::{Schema, SchemaGenerator};
use serde::de::MapAccess;

use crate::file::action_file::{
    BasteTable, ButterTable, CoolTable, FlipTable, HalveTable, HobTable, LidTable, MovePanTable, MoveTable, OilTable,
    PressTable, PutTable, RestTable, ShakeTable, TiltTable, TossTable, TrueValue, WaterTable,
};
use crate::file::repeat_file::RepeatEntry;
use crate::file::shorthand::{ShortOrTable, Written};

/// Declares [`ActionKind`] and [`ActionEntry`] from one row for each action: kind, key, format, example, description. The
/// example is a value for a recipe with a food "steak".
macro_rules! actions {
    ($($kind:ident $name:literal $format:ty, $example:literal, $summary:literal;)*) => {
        /// Kinds of actions, in the order in which messages list them.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ActionKind {
            $(#[doc = concat!("`", $name, "`: ", $summary)] $kind,)*
        }

        /// An action as a recipe file states it, not yet checked.
        #[derive(Clone, Debug)]
        pub enum ActionEntry {
            $(#[doc = concat!("`", $name, "`: ", $summary)] $kind($format),)*
        }

        impl ActionKind {
            /// All kinds.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$kind),*];

            /// Returns the key of the action in a recipe: `flip`.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$kind => $name,)* }
            }

            /// Returns the description of the action: `turns foods over.`
            pub const fn summary(self) -> &'static str {
                match self { $(Self::$kind => $summary,)* }
            }

            /// Returns the action as a line of a recipe with a food "steak": `flip = "steak"`.
            pub const fn example(self) -> &'static str {
                match self { $(Self::$kind => concat!($name, " = ", $example),)* }
            }

            /// Reads the value of the action's key.
            pub(crate) fn read<'de, A: MapAccess<'de>>(self, map: &mut A) -> Result<ActionEntry, A::Error> {
                match self { $(Self::$kind => map.next_value().map(ActionEntry::$kind),)* }
            }

            /// Returns the schema of the action's value, or null.
            pub(crate) fn schema(self, generator: &mut SchemaGenerator) -> Schema {
                match self { $(Self::$kind => generator.subschema_for::<Option<$format>>(),)* }
            }
        }

        impl ActionEntry {
            /// Returns the kind of the action.
            pub fn kind(&self) -> ActionKind {
                match self { $(Self::$kind(_) => ActionKind::$kind,)* }
            }

            /// Returns true if the action is written as a bare value, not as a table.
            pub fn is_bare(&self) -> bool {
                match self { $(Self::$kind(written) => written.is_bare(),)* }
            }
        }
    };
}

actions! {
    Hob "hob_w" ShortOrTable<HobTable>, "2000",
        "sets the hob; a bare number is its electrical power, 0–3500 [W]; with hold_c it holds the pan at a temperature.";
    Put "put" ShortOrTable<PutTable>, "\"steak\"", "puts foods into the pan.";
    Flip "flip" ShortOrTable<FlipTable>, "\"steak\"", "turns foods over.";
    Rest "rest" ShortOrTable<RestTable>, "\"steak\"", "takes foods out of the pan to rest.";
    Halve "halve" ShortOrTable<HalveTable>, "\"steak\"", "cuts foods that lie on the board in halves.";
    MovePan "move_pan" ShortOrTable<MovePanTable>, "{ lift_mm = 50 }",
        "moves the pan over the hob, or lifts it, until it is moved again; true sets it back onto its ring.";
    Cool "cool" ShortOrTable<CoolTable>, "\"wet-cloth\"", "sets the pan on a wet cloth, off the hob.";
    Oil "oil_g" ShortOrTable<OilTable>, "10", "pours oil into the pan; a bare number is how much [g].";
    Butter "butter_g" ShortOrTable<ButterTable>, "15", "puts butter into the pan; a bare number is how much [g].";
    Water "water_g" ShortOrTable<WaterTable>, "30", "pours water into the pan; a bare number is how much [g].";
    Toss "toss" ShortOrTable<TossTable>, "true", "tosses what lies in the pan; true takes the defaults.";
    Shake "shake" ShortOrTable<ShakeTable>, "5", "shakes the pan to and fro; a bare number is how long [s].";
    Tilt "tilt" ShortOrTable<TiltTable>, "15",
        "tilts the pan until it is tilted otherwise; a bare number is the angle [°], 0 levels it.";
    Press "press" ShortOrTable<PressTable>, "\"steak\"", "presses foods onto the floor with the turner.";
    Baste "baste" ShortOrTable<BasteTable>, "\"steak\"", "spoons hot fat of the pan over foods in it.";
    Move "move" ShortOrTable<MoveTable>, "{ food = \"steak\", to_mm = [30, 0] }",
        "pushes or carries foods to a place in the pan.";
    Lid "lid" ShortOrTable<LidTable>, "true", "lays the lid on (true, \"on\") or takes it off (false, \"off\").";
    Wipe "wipe" TrueValue, "true", "wipes the pan with a paper towel, once nothing lies in it: only the film of a seasoned pan stays.";
    Repeat "repeat" RepeatEntry, "{ flip = \"steak\", every_s = 30, times = 4 }",
        "carries out one action again and again, first after every_s, until a condition holds or so many times.";
    End "end" TrueValue, "true", "ends the cook.";
}

impl ActionKind {
    /// Returns true if `repeat` may carry out the action.
    pub fn is_repeatable(self) -> bool {
        !matches!(self, Self::Repeat | Self::End)
    }

    /// Returns the kind with a key.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

impl fmt::Display for ActionKind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.name())
    }
}
