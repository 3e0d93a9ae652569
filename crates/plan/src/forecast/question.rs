//! Actions that one may take now, whose results are forecast.

use std::sync::Arc;

use saute_kitchen::food::Scale;
use saute_kitchen::{Command, Kitchen, RestOn, kelvin};
use serde::{Deserialize, Serialize};

/// Power that lower heat leaves, relative to the present one [-] (chosen: a clear step on every hob).
const LOWER_SHARE: f64 = 0.5;
/// By how much lower heat lowers the temperature that the hob keeps [K] (chosen: the same, where a pan is held).
const LOWER_K: f64 = 30.0;

/// What is done with a piece now.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Question {
    /// Nothing.
    AsItIs,
    /// It is turned over.
    Flip,
    /// It is taken out and rests on the board.
    TakeOut,
    /// The hob gets half its power, or keeps 30 K less.
    LowerHeat,
}

/// A question about a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Ask {
    /// Name of the piece.
    pub food: String,
    /// What is done with it.
    pub question: Question,
    /// Scale in whose classes the section is shared out; none leaves the shares out.
    pub scale: Option<Arc<Scale>>,
}

impl Question {
    /// All questions, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::AsItIs, Self::Flip, Self::TakeOut, Self::LowerHeat];

    /// Returns what the hand does; none where it is not possible now.
    pub fn commands(self, kitchen: &Kitchen, food: &str) -> Option<Vec<Command>> {
        let piece = kitchen.piece(food).filter(|piece| piece.is_out())?;
        let food = food.to_owned();
        match self {
            Self::AsItIs => Some(Vec::new()),
            _ if !piece.in_pan() => None,
            Self::Flip => Some(vec![Command::Flip { food }]),
            Self::TakeOut => Some(vec![Command::Rest { food, on: RestOn::Board }]),
            Self::LowerHeat => lower_heat(kitchen).map(|command| vec![command]),
        }
    }
}

/// The command that lowers the heat; none on a cold hob.
fn lower_heat(kitchen: &Kitchen) -> Option<Command> {
    let power = kitchen.hob_w();
    if power <= 0.0 {
        return None;
    }
    Some(match kitchen.hob_holds() {
        Some(held) => {
            let lowest = kelvin(kitchen.hob().hold()?.lowest_c);
            Command::HobHold { temperature: (held - LOWER_K).max(lowest), power }
        }
        None => Command::Hob(LOWER_SHARE * power),
    })
}
