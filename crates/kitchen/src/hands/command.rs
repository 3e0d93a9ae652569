//! Commands to a kitchen from hands, keys, devices and recipes, and the reasons for refusals.

use serde::{Deserialize, Serialize};

use crate::dynamics::{Pose, Tool};

/// Surface on which food rests.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RestOn {
    /// On the wooden board.
    #[default]
    Board,
    /// On a wire rack: air below.
    Rack,
    /// On the board under loose foil.
    Foil,
}

/// A command. It takes effect at the start of the next tick.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Command {
    /// Sets the hob's electrical power [W].
    Hob(f64),
    /// Lets the hob hold the pan at a temperature.
    HobHold {
        /// Temperature of the pan [K].
        temperature: f64,
        /// Largest electrical power that it uses [W].
        power: f64,
    },
    /// Puts a piece into the pan at a place relative to the pan's centre [m].
    Put {
        /// Which piece.
        food: String,
        /// Where its centroid goes [m].
        at: [f64; 2],
        /// True to drop it from above onto the pieces there, false to lay it onto the floor.
        heap: bool,
    },
    /// Turns a piece over about its long axis.
    Flip {
        /// Which piece.
        food: String,
    },
    /// Takes a piece out of the pan.
    Rest {
        /// Which piece.
        food: String,
        /// Surface.
        on: RestOn,
    },
    /// Cuts a piece on the board into halves, across its long axis, and opens it.
    Halve {
        /// Which piece.
        food: String,
        /// Distance of the cut from the centre along the long axis [m].
        at: f64,
    },
    /// Moves the pan over the hob with its contents.
    MovePan {
        /// Centre of the pan relative to the ring's [m].
        at: [f64; 2],
        /// Height above the glass [m].
        lift: f64,
    },
    /// Sets the pan on the wet cloth; the cloth is fresh unless the pan stands on one already.
    Cool {
        /// Duration [s].
        for_s: f64,
    },
    /// Tosses the contents of the pan.
    Toss {
        /// Height of the flight [m].
        height: f64,
    },
    /// Shakes the pan left and right.
    Shake {
        /// Amplitude to either side [m].
        amplitude: f64,
        /// Frequency [Hz].
        hz: f64,
        /// Duration [s].
        for_s: f64,
    },
    /// Tilts the pan; the tilt stays until the next command that turns the pan.
    Tilt {
        /// Angle between floor and horizontal [rad].
        angle: f64,
        /// Azimuth of the descent of the floor, from +x towards +y [rad].
        towards: f64,
    },
    /// Presses a piece onto the floor.
    Press {
        /// Which piece.
        food: String,
        /// Force [N].
        newtons: f64,
        /// Duration [s].
        for_s: f64,
    },
    /// Spoons hot fat of the pan over a piece.
    Baste {
        /// Which piece.
        food: String,
        /// Duration [s].
        for_s: f64,
    },
    /// Pushes or carries a piece to a place in the pan [m].
    Move {
        /// Which piece.
        food: String,
        /// Where its centroid goes, relative to the pan's centre [m].
        to: [f64; 2],
    },
    /// Moves a tool freely to a pose. A gripped piece follows by a spring–damper of bounded force.
    Lead {
        /// Which tool.
        tool: Tool,
        /// Target pose of its tip in the kitchen.
        to: Pose,
        /// Piece to grip once it is within reach.
        grip: Option<String>,
    },
    /// Lowers a gripped piece until it is supported, releases it and puts the tool away.
    LetGo,
    /// Holds the pan at a pose of the centre of its floor, limited to reach and to the space above the glass; ends a
    /// gesture.
    HoldPan {
        /// Pose of the centre of the floor.
        pose: Pose,
    },
    /// Pours oil into the pan.
    Oil {
        /// Kind of oil; the kitchen's default if `None`.
        kind: Option<String>,
        /// Mass [kg].
        mass: f64,
    },
    /// Puts butter into the pan [kg].
    Butter(f64),
    /// Pours water into the pan [kg].
    Water(f64),
    /// Puts the lid on (true) or takes it off.
    Lid(bool),
    /// Wipes the empty pan with a paper towel.
    Wipe,
}

impl Command {
    /// Returns true for a motion of a hand: a hand gives many of them, and no recipe states one.
    pub fn is_motion(&self) -> bool {
        matches!(self, Self::Lead { .. } | Self::LetGo | Self::HoldPan { .. })
    }

    /// Returns true if the lid prevents the command.
    pub fn needs_open_pan(&self) -> bool {
        match self {
            Self::Put { .. } | Self::Flip { .. } | Self::Rest { .. } => true,
            Self::Press { .. } | Self::Baste { .. } | Self::Move { .. } | Self::Toss { .. } => true,
            Self::Oil { .. } | Self::Butter(_) | Self::Water(_) => true,
            Self::Shake { .. } | Self::Tilt { .. } | Self::HoldPan { .. } | Self::LetGo => false,
            Self::Lead { .. } | Self::Wipe => true,
            Self::Halve { .. } => false,
            Self::Hob(_) | Self::HobHold { .. } | Self::MovePan { .. } | Self::Cool { .. } | Self::Lid(_) => false,
        }
    }
}

/// Reason why a command is refused. The kitchen is unchanged.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// No such piece.
    #[error("there is no food \"{0}\" here")]
    NoSuchFood(String),
    /// Not in the pan.
    #[error("\"{0}\" is not in the pan: put it in first")]
    NotInPan(String),
    /// Not on the board.
    #[error("\"{0}\" is not on the board, where it can be cut: take it out first")]
    NotOnBoard(String),
    /// Halved already.
    #[error("\"{0}\" is already halved: a piece can be cut once")]
    AlreadyHalved(String),
    /// The cut is beyond the end of the piece.
    #[error("the knife would miss \"{food}\": cut within {most_mm} mm of its middle")]
    BesideFood {
        /// Which piece.
        food: String,
        /// Largest distance from the centre [mm].
        most_mm: i64,
    },
    /// In the pan already.
    #[error("\"{0}\" is in the pan already")]
    AlreadyInPan(String),
    /// Does not fit onto the floor there.
    #[error(
        "\"{food}\" does not fit there: it reaches {reach_mm} mm from the pan's centre, the flat floor {floor_mm} mm; put it nearer to the centre or choose a smaller piece"
    )]
    DoesNotFit {
        /// Which piece.
        food: String,
        /// Reach of the piece from the pan's centre [mm].
        reach_mm: i64,
        /// Radius of the floor [mm].
        floor_mm: i64,
    },
    /// Another piece is in the way.
    #[error("\"{food}\" would lie on \"{other}\": take that out first")]
    Occupied {
        /// Which piece.
        food: String,
        /// Piece in the way.
        other: String,
    },
    /// Liquid still.
    #[error("\"{0}\" still runs: wait until it has set below")]
    StillRuns(String),
    /// Too little fat to spoon.
    #[error("there is too little fat in the pan to spoon over food: it needs {least_g} g")]
    TooLittleFat {
        /// Least fat in the pan [g].
        least_g: i64,
    },
    /// Waiting: the piece has no rigid body yet.
    #[error("\"{0}\" is not on the board or in the pan yet: put it in before you use a tool on it")]
    Waiting(String),
    /// The pan is empty: nothing to toss.
    #[error("there is nothing in the pan to toss: put a food in first")]
    EmptyPan,
    /// The pan's target is out of reach.
    #[error("the pan can be moved and lifted by up to {farthest_mm} mm")]
    PanPlace {
        /// Largest distance [mm].
        farthest_mm: i64,
    },
    /// Power out of range.
    #[error("the hob gives 0 to {largest_w} W")]
    Power {
        /// Largest power [W].
        largest_w: i64,
    },
    /// Temperature to hold out of range.
    #[error("the hob holds {lowest_c} to {highest_c} °C")]
    HoldTemperature {
        /// Lowest temperature [°C].
        lowest_c: i64,
        /// Highest temperature [°C].
        highest_c: i64,
    },
    /// A stove without a sensor cannot hold a temperature.
    #[error("this stove has no sensor and holds no temperature: set a power, or cook on the induction hob")]
    NoSensor,
    /// Unknown oil.
    #[error("there is no oil \"{kind}\"; there are: {known}")]
    NoSuchOil {
        /// Kind in the command.
        kind: String,
        /// Known kinds.
        known: String,
    },
    /// The amount is not positive or exceeds the free volume of the pan.
    #[error("the pan cannot take this amount of {what}: give more than 0 and at most {holds_g} g")]
    Amount {
        /// Substance.
        what: &'static str,
        /// Largest amount [g].
        holds_g: i64,
    },
    /// Food is in the way of the paper.
    #[error("take the {0} out before you wipe the pan")]
    FoodToWipe(String),
    /// A number is beyond its range, or none.
    #[error("{key} may be {low} to {high}")]
    Range {
        /// Key of a recipe whose value it is; it ends with the unit.
        key: &'static str,
        /// Smallest value, in the unit of the key.
        low: String,
        /// Largest value, in the unit of the key.
        high: String,
    },
    /// A pose that is none.
    #[error("this pose is none: give finite numbers and an orientation that is not zero; the hand stays where it is")]
    NoPose,
    /// The lid is in the way.
    #[error("the lid is on: take it off first")]
    LidIsOn,
}
