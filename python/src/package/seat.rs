//! A kitchen of a batch: whole, or with its pan and slices on the reduced mesh.

use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use saute_kitchen::hands::FoodVelocities;
use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen, Reductions};
use saute_kitchen::{Command, Kitchen, Piece, Refused, TICK_S};

use crate::package::errors;
use crate::package::kitchen::{PyKitchen, tick};

/// Ticks in a step of the reduced mesh [-].
const REDUCED_TICKS: u64 = (LAPSE_S / TICK_S + 0.5) as u64;

/// One kitchen of a batch.
pub(crate) enum Seat {
    Whole { state: Arc<Kitchen>, before: FoodVelocities },
    Reduced(Box<ReducedKitchen>),
}

/// Fineness of the kitchens of a batch.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Mesh {
    Whole,
    Reduced,
}

impl Mesh {
    /// Checks how many ticks are to be made: on the reduced mesh several make one step.
    pub(crate) fn check(self, ticks: u64) -> PyResult<()> {
        if self == Self::Whole || ticks.is_multiple_of(REDUCED_TICKS) {
            return Ok(());
        }
        Err(PyValueError::new_err(format!("n = {ticks}: on the reduced mesh give a multiple of {REDUCED_TICKS} ticks")))
    }
}

impl Seat {
    /// Takes a seat for a kitchen; on the reduced mesh it must be at rest, since nothing moves there.
    pub(crate) fn of(kitchen: &PyKitchen, mesh: Mesh) -> PyResult<Self> {
        kitchen.whole()?;
        let state = &kitchen.state;
        if mesh == Mesh::Whole {
            return Ok(Self::Whole { state: Arc::clone(state), before: kitchen.before.clone() });
        }
        if state.busy() || !state.pieces().iter().all(Piece::is_out) {
            let reason = "on the reduced mesh nothing moves: put all foods in and step until the kitchen is not busy";
            return Err(PyValueError::new_err(reason));
        }
        let reduced = state.reduced(&mut Reductions::default()).map_err(|error| errors::fault(&error))?;
        Ok(Self::Reduced(Box::new(reduced)))
    }

    /// The kitchen, to be read.
    pub(crate) fn kitchen(&self) -> &Kitchen {
        match self {
            Self::Whole { state, .. } => state,
            Self::Reduced(reduced) => reduced.kitchen(),
        }
    }

    /// The kitchen as one of its own; one on the reduced mesh can only be read.
    pub(crate) fn taken(&self) -> PyKitchen {
        match self {
            Self::Whole { state, before } => {
                PyKitchen { state: Arc::clone(state), before: before.clone(), is_reduced: false }
            }
            Self::Reduced(reduced) => PyKitchen { is_reduced: true, ..PyKitchen::of(reduced.kitchen().clone()) },
        }
    }

    pub(crate) fn apply(&mut self, command: &Command) -> Result<(), Refused> {
        match self {
            Self::Whole { state, .. } => Arc::make_mut(state).apply(command),
            Self::Reduced(reduced) => reduced.apply(command),
        }
    }

    pub(crate) fn ticks(&mut self, count: u64) {
        match self {
            Self::Whole { state, before } => {
                let kitchen = Arc::make_mut(state);
                (0..count).for_each(|_| tick(kitchen, before));
            }
            Self::Reduced(reduced) => (0..count / REDUCED_TICKS).for_each(|_| reduced.step()),
        }
    }

    /// Advances frames of 1/60 s; none on the reduced mesh, which has no motion.
    pub(crate) fn frames(&mut self, count: u64) {
        if let Self::Whole { state, before } = self {
            let kitchen = Arc::make_mut(state);
            for _ in 0..count {
                before.note(kitchen);
                kitchen.advance_frame();
            }
        }
    }
}
