//! Actions on foods.

use serde_json::{Value, json};

use crate::action::{ActionKind, mm};
use saute_kitchen::hands::command::{Command, RestOn};
use saute_kitchen::piece::piece_state::Piece;

/// An action on a food.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoodAction {
    /// Puts it into the pan.
    Put {
        /// Place of its centre relative to the pan's; several foods are laid around it [m].
        at: [f64; 2],
        /// True if it is dropped from above onto the foods in the pan.
        heap: bool,
    },
    /// Turns it over.
    Flip,
    /// Takes it out of the pan.
    Rest(RestOn),
    /// Cuts it in halves on the board.
    Halve {
        /// Distance of the cut from the middle along the long axis [m].
        at: f64,
    },
    /// Presses it onto the floor of the pan.
    Press {
        /// Force [N].
        newtons: f64,
        /// Duration [s].
        for_s: f64,
    },
    /// Spoons hot fat over it.
    Baste {
        /// Duration [s].
        for_s: f64,
    },
    /// Moves it to a place in the pan; several foods are laid around that place [m].
    Move([f64; 2]),
}

/// Where a food must be for an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// Outside the pan.
    OutsidePan,
    /// In the pan.
    InPan,
    /// On the board, not yet cut.
    WholeOnBoard,
}

/// The place to which an action brings a food.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Destination {
    /// Place relative to the pan's centre [m].
    pub at: [f64; 2],
    /// True if the foods of a group lie side by side around the place, false if all of them go to it.
    pub side_by_side: bool,
}

impl FoodAction {
    /// Returns the kind of the action.
    pub fn kind(self) -> ActionKind {
        match self {
            Self::Put { .. } => ActionKind::Put,
            Self::Flip => ActionKind::Flip,
            Self::Rest(_) => ActionKind::Rest,
            Self::Halve { .. } => ActionKind::Halve,
            Self::Press { .. } => ActionKind::Press,
            Self::Baste { .. } => ActionKind::Baste,
            Self::Move(_) => ActionKind::Move,
        }
    }

    /// Returns the command for one food. `at` is the place of this food [m]; an action without a destination ignores
    /// it.
    pub fn command(self, food: String, at: [f64; 2]) -> Command {
        match self {
            Self::Put { heap, .. } => Command::Put { food, at, heap },
            Self::Flip => Command::Flip { food },
            Self::Rest(on) => Command::Rest { food, on },
            Self::Halve { at } => Command::Halve { food, at },
            Self::Press { newtons, for_s } => Command::Press { food, newtons, for_s },
            Self::Baste { for_s } => Command::Baste { food, for_s },
            Self::Move(_) => Command::Move { food, to: at },
        }
    }

    /// Returns the action that gives a command, and its food; none for a command on the pan and for motions of a hand.
    pub fn of_command(command: &Command) -> Option<(String, Self)> {
        let (food, action) = match command {
            Command::Put { food, at, heap } => (food, Self::Put { at: *at, heap: *heap }),
            Command::Flip { food } => (food, Self::Flip),
            Command::Rest { food, on } => (food, Self::Rest(*on)),
            Command::Halve { food, at } => (food, Self::Halve { at: *at }),
            Command::Press { food, newtons, for_s } => (food, Self::Press { newtons: *newtons, for_s: *for_s }),
            Command::Baste { food, for_s } => (food, Self::Baste { for_s: *for_s }),
            Command::Move { food, to } => (food, Self::Move(*to)),
            _ => return None,
        };
        Some((food.clone(), action))
    }

    /// Returns where a food must be for the action.
    pub fn requirement(self) -> Requirement {
        match self {
            Self::Put { .. } => Requirement::OutsidePan,
            Self::Halve { .. } => Requirement::WholeOnBoard,
            Self::Flip | Self::Rest(_) | Self::Press { .. } | Self::Baste { .. } | Self::Move(_) => Requirement::InPan,
        }
    }

    /// Returns the place to which the action brings a food; none if the food stays or leaves the pan.
    pub fn destination(self) -> Option<Destination> {
        match self {
            Self::Put { at, heap } => Some(Destination { at, side_by_side: !heap }),
            Self::Move(at) => Some(Destination { at, side_by_side: true }),
            Self::Flip | Self::Rest(_) | Self::Halve { .. } | Self::Press { .. } | Self::Baste { .. } => None,
        }
    }

    /// Returns the action's value in the units of the recipe, as JSON.
    pub fn value(self) -> Value {
        match self {
            Self::Put { at, heap: false } => json!(at.map(mm)),
            Self::Put { at, heap: true } => json!({ "at_mm": at.map(mm), "heap": true }),
            Self::Flip => Value::Null,
            Self::Rest(on) => json!(on),
            Self::Halve { at } => json!({ "at_mm": mm(at) }),
            Self::Press { newtons, for_s } => json!({ "n": newtons, "for_s": for_s }),
            Self::Baste { for_s } => json!({ "for_s": for_s }),
            Self::Move(to) => json!(to.map(mm)),
        }
    }

    /// Returns the action on a food or group in English: `flip steak`.
    pub fn words(self, food: &str) -> String {
        match self {
            Self::Put { .. } => format!("put {food}"),
            Self::Flip => format!("flip {food}"),
            Self::Rest(RestOn::Board) => format!("rest {food} on the board"),
            Self::Rest(RestOn::Rack) => format!("rest {food} on the rack"),
            Self::Rest(RestOn::Foil) => format!("rest {food} on the board under foil"),
            Self::Halve { .. } => format!("halve {food}"),
            Self::Press { newtons, for_s } => format!("press {food} with {newtons} N for {for_s} s"),
            Self::Baste { for_s } => format!("baste {food} for {for_s} s"),
            Self::Move(_) => format!("move {food} to {} mm", self.value()),
        }
    }

    /// Returns the time for which the next step waits at least [s].
    pub fn duration_s(self) -> f64 {
        match self {
            Self::Press { for_s, .. } | Self::Baste { for_s } => for_s,
            Self::Put { .. } | Self::Flip | Self::Rest(_) | Self::Halve { .. } | Self::Move(_) => 0.0,
        }
    }
}

impl Requirement {
    /// Returns true if a piece meets the requirement now.
    pub fn met_by(self, piece: &Piece) -> bool {
        match self {
            Self::OutsidePan => !piece.in_pan(),
            Self::InPan => piece.in_pan(),
            Self::WholeOnBoard => piece.lies_on_board() && piece.halved().is_none(),
        }
    }
}
