//! The doors through which a kitchen is changed, and what each can change. [`CHANGES`] and [`STREAMED`] list it; `docs/doors.md` is
//! written from them, and a test hands bad numbers to each door.

mod changes;
mod page;
mod starts;
mod streamed;

use saute_haptics::HapticSample;
use saute_recipe::session::Deed;

pub use changes::CHANGES;
pub use page::page;
pub use starts::STARTS;
pub use streamed::STREAMED;

/// Which numbers are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// There is no number.
    Plain,
    /// Those between two ends, in the unit of the change.
    Within(f64, f64),
    /// Those for which the kitchen has room, power or reach.
    Fitting,
    /// All that are finite: the hand stays at its reach.
    Reach,
}

/// One notation of a change: how it is written, and the words by one of which a refusal names it.
#[derive(Clone, Copy, Debug)]
pub struct Way<W: 'static> {
    /// How it is written.
    pub write: W,
    /// Words one of which is in a refusal.
    pub named: &'static [&'static str],
    /// Which numbers are taken.
    pub range: Range,
}

/// A part of a recipe; `#` is replaced by the number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Keys at the top.
    Top(&'static str),
    /// Keys of the pan.
    Pan(&'static str),
    /// Keys of the hob.
    Hob(&'static str),
    /// Keys of the food.
    Food(&'static str),
    /// Keys of a step.
    Step(&'static str),
    /// Keys of the kitchen at home, which no recipe states.
    Home(&'static str),
}

/// Where the food is before a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Before {
    /// Not in the pan yet.
    Waiting,
    /// In the pan.
    InPan,
    /// On the board.
    OnBoard,
}

/// What an entry of a session does with a number.
pub type DeedOf = fn(f64) -> Deed;

/// One change, and how recipe, session and Python write it. A link and a stored cook of another version contain a session.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// Name, with the unit in brackets where it has one.
    pub name: &'static str,
    /// Where the food is.
    pub before: Before,
    /// In a recipe.
    pub recipe: Option<Way<Part>>,
    /// As an entry of a session, from the number in the unit of the change.
    pub entry: Option<Way<DeedOf>>,
    /// As a call of Python, with the number's range.
    pub python: Option<(&'static str, Range)>,
    /// By phone, OSC and device: true where a pose states it.
    pub posed: bool,
}

/// What a kitchen begins with. A session, a link and a page hold it as the text of a recipe.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Name, with the unit in brackets where it has one.
    pub name: &'static str,
    /// In a recipe.
    pub recipe: Way<Part>,
}

/// How a stream states a number.
#[derive(Clone, Copy, Debug)]
pub enum Streamed {
    /// A phone's message; `#` is replaced by the number.
    Phone(&'static str),
    /// An OSC message: its address, and its arguments from the number.
    Osc(&'static str, fn(f64) -> Vec<f64>),
    /// A device's sample, changed by the number.
    Device(fn(f64, &mut HapticSample)),
}

/// One number of a stream of poses.
#[derive(Clone, Copy, Debug)]
pub struct StreamedNumber {
    /// Name, with the unit in brackets.
    pub name: &'static str,
    /// How it is sent.
    pub message: Streamed,
    /// Word by which a refusal names it.
    pub named: &'static str,
    /// Which numbers are taken.
    pub range: Range,
}
