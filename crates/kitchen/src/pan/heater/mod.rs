//! What makes the heat of a hob: a coil, a flame, an element behind glass or an iron plate.

pub mod coil;
pub mod disc;
pub mod element;
pub mod flame;
mod long_run;
pub mod plate;

pub use coil::{Coil, Control};
pub use element::Element;
pub use flame::{Flame, Grate};
pub use plate::Plate;

/// What makes the heat of a hob, by its file.
#[derive(Clone, Copy, Debug)]
pub enum Heater<'a> {
    /// The coil of an induction hob: heat is made in the pan.
    Coil(&'a Coil),
    /// A gas flame.
    Flame(&'a Flame),
    /// A radiant element behind glass-ceramic.
    Element(&'a Element),
    /// An iron plate with heaters in it.
    Plate(&'a Plate),
}

impl Heater<'_> {
    /// Its kind.
    pub fn kind(&self) -> HeaterKind {
        match self {
            Self::Coil(_) => HeaterKind::Coil,
            Self::Flame(_) => HeaterKind::Flame,
            Self::Element(_) => HeaterKind::Element,
            Self::Plate(_) => HeaterKind::Plate,
        }
    }
}

/// Kind of a heater.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HeaterKind {
    /// The coil of an induction hob.
    #[default]
    Coil,
    /// A gas flame.
    Flame,
    /// A radiant element behind glass-ceramic.
    Element,
    /// An iron plate.
    Plate,
}

/// What a heater without electronics gives in one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Given {
    /// Energy from mains or gas pipe [J].
    pub(crate) drawn: f64,
    /// Heat into the pan's metal [J].
    pub(crate) to_pan: f64,
}

/// What a heater meets in one step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meets<'a> {
    /// Temperature of the metal at each node, those of the floor first [K].
    pub(crate) metal: &'a [f64],
    /// Area of each node [m²].
    pub(crate) areas: &'a [f64],
    /// Share of the heater over which each floor node is [-].
    pub(crate) shares: &'a [f64],
    /// Height of the pan above its support [m].
    pub(crate) lift: f64,
    /// Power now [W].
    pub(crate) power: f64,
    /// Temperature of the room [K].
    pub(crate) room: f64,
    /// Length of the step [s].
    pub(crate) dt: f64,
}
