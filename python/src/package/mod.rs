//! Classes and functions of `saute._core`.
//!
//! A kitchen (`kitchen`) shares its state with every array that was taken from it (`array`), and steps without Python's global
//! lock.

mod array;
mod batch;
mod batch_commands;
mod commands;
mod cook;
mod errors;
mod expected;
mod kitchen;
mod own_data;
mod pan;
mod piece;
mod readings;
mod recipe;
mod render;
mod score;
mod seat;
mod shelf;
mod sound;
mod sweep;

use pyo3::prelude::*;

/// Compiled part of the package saute.
#[pymodule]
mod _core {
    #[pymodule_export]
    use crate::package::array::Memory;
    #[pymodule_export]
    use crate::package::batch::PyBatch;
    #[pymodule_export]
    use crate::package::cook::{PyCooked, cook};
    #[pymodule_export]
    use crate::package::kitchen::PyKitchen;
    #[pymodule_export]
    use crate::package::piece::PyPiece;
    #[pymodule_export]
    use crate::package::shelf::{foods, hobs, oils, pans, recipes};
    #[pymodule_export]
    use crate::package::sweep::{PySweep, PySweepFolder};

    use super::{Bound, PyModule, PyModuleMethods, PyResult};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("TICK_S", saute_kitchen::TICK_S)
    }
}
