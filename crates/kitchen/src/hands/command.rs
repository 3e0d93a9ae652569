//! What hands, keys, devices and recipes may ask of a kitchen.

use serde::{Deserialize, Serialize};

use crate::dynamics::{Pose, Tool};

/// Where food rests.
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

/// A command; takes effect at the start of the next tick.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Sets the hob's electrical power [W].
    Hob(f64),
    /// Puts a piece into the pan at a place relative to the pan's centre [m].
    Put {
        /// Which piece.
        food: String,
        /// Where its centroid goes [m].
        at: [f64; 2],
        /// Dropped from above onto what lies there, instead of laid onto the floor.
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
        /// Onto what.
        on: RestOn,
    },
    /// Cuts a piece that lies on the board in halves, across its long axis, and opens it.
    Halve {
        /// Which piece.
        food: String,
        /// Distance of the cut from the middle along the long axis [m].
        at: f64,
    },
    /// Moves the pan over the hob; what lies in it moves along.
    MovePan {
        /// Centre of the pan relative to the ring's [m].
        at: [f64; 2],
        /// Height above the glass [m].
        lift: f64,
    },
    /// Sets the pan on the wet cloth for a while [s]; a fresh cloth unless one lies there already.
    Cool {
        /// How long [s].
        for_s: f64,
    },
    /// Tosses what lies in the pan.
    Toss {
        /// How high the foods shall fly [m].
        height: f64,
    },
    /// Shakes the pan to and fro.
    Shake {
        /// Farthest from the middle, to either side [m].
        amplitude: f64,
        /// How often [Hz].
        hz: f64,
        /// How long [s].
        for_s: f64,
    },
    /// Tilts the pan until it is tilted otherwise.
    Tilt {
        /// Angle between floor and horizontal [rad].
        angle: f64,
        /// Direction in which the floor goes down, from +x over +y [rad].
        towards: f64,
    },
    /// Presses a piece onto the floor.
    Press {
        /// Which piece.
        food: String,
        /// With what force [N].
        newtons: f64,
        /// How long [s].
        for_s: f64,
    },
    /// Pushes or carries a piece to a place in the pan [m].
    Move {
        /// Which piece.
        food: String,
        /// Where its centroid goes, relative to the pan's centre [m].
        to: [f64; 2],
    },
    /// Leads a tool freely to a pose; what it grips follows it by force.
    Lead {
        /// Which tool.
        tool: Tool,
        /// Where its tip shall be, in the kitchen.
        to: Pose,
        /// Which piece it takes hold of, once within reach.
        grip: Option<String>,
    },
    /// Lowers what a led tool grips until it lies, lets it go and puts the tool away.
    LetGo,
    /// Holds the pan at a pose of the middle of its floor, within reach and above the glass; ends a gesture.
    HoldPan {
        /// Where.
        pose: Pose,
    },
    /// Pours oil into the pan.
    Oil {
        /// Which oil; the kitchen's own unless given.
        kind: Option<String>,
        /// How much [kg].
        mass: f64,
    },
    /// Puts butter into the pan [kg].
    Butter(f64),
    /// Pours water into the pan [kg].
    Water(f64),
    /// Lays the lid on, or takes it off.
    Lid(bool),
}

impl Command {
    /// Whether it cannot be done while the lid is on.
    pub fn needs_open_pan(&self) -> bool {
        match self {
            Self::Put { .. } | Self::Flip { .. } | Self::Rest { .. } => true,
            Self::Press { .. } | Self::Move { .. } | Self::Toss { .. } => true,
            Self::Oil { .. } | Self::Butter(_) | Self::Water(_) => true,
            Self::Shake { .. } | Self::Tilt { .. } | Self::HoldPan { .. } | Self::LetGo => false,
            Self::Lead { .. } => true,
            Self::Halve { .. } => false,
            Self::Hob(_) | Self::MovePan { .. } | Self::Cool { .. } | Self::Lid(_) => false,
        }
    }
}

/// Why a command was not carried out; the kitchen is unchanged.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// No such piece.
    #[error("there is no food \"{0}\" here")]
    NoSuchFood(String),
    /// Not in the pan.
    #[error("\"{0}\" is not in the pan: put it in first")]
    NotInPan(String),
    /// Not on the board.
    #[error("\"{0}\" does not lie on the board, where the knife works: rest it on the board first")]
    NotOnBoard(String),
    /// In halves already.
    #[error("\"{0}\" is cut in halves already: it can be cut once")]
    AlreadyHalved(String),
    /// The knife would miss it.
    #[error("the knife would miss \"{food}\": cut within {most_mm} mm of its middle")]
    BesideFood {
        /// Which piece.
        food: String,
        /// Farthest from the middle [mm].
        most_mm: i64,
    },
    /// In the pan already.
    #[error("\"{0}\" is in the pan already")]
    AlreadyInPan(String),
    /// Does not fit.
    #[error(
        "\"{food}\" does not fit there: it reaches {reach_mm} mm from the pan's centre, the flat floor {floor_mm} mm; put it nearer to the centre or choose a smaller piece"
    )]
    DoesNotFit {
        /// Which piece.
        food: String,
        /// How far it would reach [mm].
        reach_mm: i64,
        /// Radius of the floor [mm].
        floor_mm: i64,
    },
    /// Another piece is in the way.
    #[error("\"{food}\" would lie on \"{other}\": take that out first")]
    Occupied {
        /// Which piece.
        food: String,
        /// What is in the way.
        other: String,
    },
    /// Waits outside of the world of bodies.
    #[error("\"{0}\" waits to be put in: no tool can lead it yet")]
    Waiting(String),
    /// Nothing to toss.
    #[error("there is nothing in the pan to toss: put a food in first")]
    EmptyPan,
    /// The pan would be out of reach.
    #[error("the pan can be moved and lifted by up to {farthest_mm} mm")]
    PanPlace {
        /// How far [mm].
        farthest_mm: i64,
    },
    /// Power out of range.
    #[error("the hob gives 0 to {largest_w} W")]
    Power {
        /// Largest power [W].
        largest_w: i64,
    },
    /// Unknown oil.
    #[error("there is no oil \"{kind}\"; there are: {known}")]
    NoSuchOil {
        /// What was asked for.
        kind: String,
        /// What there is.
        known: String,
    },
    /// No amount, or more than the pan holds.
    #[error("that is no amount of {what} that the pan holds: give more than 0 and at most {holds_g} g")]
    Amount {
        /// What.
        what: &'static str,
        /// Most [g].
        holds_g: i64,
    },
    /// The lid is in the way.
    #[error("the lid is on: take it off first")]
    LidIsOn,
}
