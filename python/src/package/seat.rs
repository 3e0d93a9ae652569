//! A kitchen of a batch: whole, or with its pan and slices on the reduced mesh.

use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen, Reductions};
use saute_kitchen::{Command, Kitchen, Library, Piece, Refused, TICK_S};

use crate::package::errors;
use crate::package::kitchen::PyKitchen;
use crate::package::own_data::Shelf;

/// Ticks in a step of the reduced mesh [-].
const REDUCED_TICKS: u64 = (LAPSE_S / TICK_S + 0.5) as u64;

/// One kitchen of a batch.
pub(crate) enum Seat {
    Whole(PyKitchen),
    Reduced(Box<ReducedKitchen>, Shelf),
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
            return Ok(Self::Whole(kitchen.clone()));
        }
        if state.busy() || !state.pieces().iter().all(Piece::is_out) {
            let reason = "on the reduced mesh nothing moves: put all foods in and step until the kitchen is not busy";
            return Err(PyValueError::new_err(reason));
        }
        let reduced = state.reduced(&mut Reductions::default()).map_err(|error| errors::fault(&error))?;
        Ok(Self::Reduced(Box::new(reduced), kitchen.shelf.clone()))
    }

    /// The kitchen, to be read.
    pub(crate) fn kitchen(&self) -> &Kitchen {
        match self {
            Self::Whole(kitchen) => &kitchen.state,
            Self::Reduced(reduced, _) => reduced.kitchen(),
        }
    }

    /// The library that it was built from.
    pub(crate) fn library(&self) -> &Library {
        match self {
            Self::Whole(kitchen) => &kitchen.shelf.library,
            Self::Reduced(_, shelf) => &shelf.library,
        }
    }

    /// The kitchen as a separate one; one on the reduced mesh can only be read.
    pub(crate) fn taken(&self) -> PyKitchen {
        match self {
            Self::Whole(kitchen) => kitchen.clone(),
            Self::Reduced(reduced, shelf) => {
                PyKitchen { is_reduced: true, ..PyKitchen::of(reduced.kitchen().clone(), shelf.clone()) }
            }
        }
    }

    pub(crate) fn apply(&mut self, command: &Command) -> Result<(), Refused> {
        match self {
            Self::Whole(kitchen) => Arc::make_mut(&mut kitchen.state).apply(command),
            Self::Reduced(reduced, _) => reduced.apply(command),
        }
    }

    pub(crate) fn ticks(&mut self, count: u64) {
        match self {
            Self::Whole(kitchen) => kitchen.ticks(count),
            Self::Reduced(reduced, _) => (0..count / REDUCED_TICKS).for_each(|_| reduced.step()),
        }
    }

    /// Advances frames of 1/60 s; none on the reduced mesh, which has no motion.
    pub(crate) fn frames(&mut self, count: u64) {
        if let Self::Whole(kitchen) = self {
            kitchen.frames(count);
        }
    }
}
