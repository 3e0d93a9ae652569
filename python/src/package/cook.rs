//! A recipe cooked to its end: the numbers of `saute cook --json`, the time series, and the kitchen at the end.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use saute_recipe::{Cook, StoppedBy};

use crate::package::array::made;
use crate::package::errors;
use crate::package::kitchen::PyKitchen;
use crate::package::own_data::Shelf;
use crate::package::recipe::Source;

/// Ticks between two looks for Ctrl-C [-] (chosen: some milliseconds to a second of a full pan).
const TICKS_PER_LOOK: usize = 50;

/// A cook that has ended.
#[pyclass(name = "Cooked", frozen, module = "saute._core")]
pub(crate) struct PyCooked {
    cook: Cook,
    shelf: Shelf,
}

/// Cooks a recipe to its end, without Python's global lock; data is a folder of the user's foods, pans and recipes.
#[pyfunction]
#[pyo3(signature = (recipe, data = None))]
pub(crate) fn cook(py: Python<'_>, recipe: &Bound<'_, PyAny>, data: Option<PathBuf>) -> PyResult<PyCooked> {
    let shelf = Shelf::of(data)?;
    let source = Source::among(recipe, &shelf)?;
    let mut cook = py.detach(|| begun(&source, &shelf))?;
    while cook.stopped().is_none() {
        py.detach(|| cooked_on(&mut cook, &source))?;
        py.check_signals()?;
    }
    Ok(PyCooked { cook, shelf })
}

fn begun(source: &Source, shelf: &Shelf) -> PyResult<Cook> {
    let recipe = source.recipe(&shelf.library)?;
    let file = recipe.file.clone();
    Cook::new(recipe, &shelf.library).map_err(|error| errors::setup(&error, &file))
}

fn cooked_on(cook: &mut Cook, source: &Source) -> PyResult<()> {
    for _ in 0..TICKS_PER_LOOK {
        if cook.stopped().is_some() {
            break;
        }
        cook.advance().map_err(|error| errors::input(error, source))?;
    }
    Ok(())
}

#[pymethods]
impl PyCooked {
    /// The numbers of the cook as JSON.
    fn json(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| serde_json::to_string(&self.cook.summary(0.0))).map_err(|error| errors::fault(&error))
    }

    /// The time series: an array for each column, as in series.csv.
    fn series<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let rows = &self.cook.recorder.rows;
        let series = PyDict::new(py);
        series.set_item("time_s", made(py, rows.iter().map(|row| row.time_s).collect())?)?;
        series.set_item("hob_drawn_w", made(py, rows.iter().map(|row| row.hob_drawn_w).collect())?)?;
        series.set_item("pan_c", made(py, rows.iter().map(|row| row.pan_c).collect())?)?;
        for (i, piece) in self.cook.kitchen.pieces().iter().enumerate() {
            for (k, column) in ["core_c", "top_c", "bottom_c", "mass_g"].into_iter().enumerate() {
                let values = rows.iter().map(|row| row.foods[i][k]).collect();
                series.set_item(format!("{}.{column}", piece.id), made(py, values)?)?;
            }
        }
        Ok(series)
    }

    /// The kitchen at the end.
    fn kitchen(&self) -> PyKitchen {
        PyKitchen::of(self.cook.kitchen.clone(), self.shelf.clone())
    }

    /// True if the recipe came to its end, false if a step was still waiting at max_s.
    #[getter]
    fn is_done(&self) -> bool {
        self.cook.stopped() != Some(StoppedBy::MaxS)
    }
}
