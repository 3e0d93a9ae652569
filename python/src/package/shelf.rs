//! What the package carries: foods, pans, oils and recipes.

use std::sync::{Arc, LazyLock};

use pyo3::prelude::*;
use saute_kitchen::Library;
use saute_schema::LibraryError;

use crate::package::errors;

static LIBRARY: LazyLock<Result<Arc<Library>, LibraryError>> = LazyLock::new(|| Library::embedded().map(Arc::new));

/// Returns the library, which is read once.
pub(crate) fn library() -> PyResult<&'static Arc<Library>> {
    LIBRARY.as_ref().map_err(errors::fault)
}

/// Names of the foods.
#[pyfunction]
pub(crate) fn foods() -> PyResult<Vec<String>> {
    Ok(library()?.foods.keys().cloned().collect())
}

/// Names of the pans.
#[pyfunction]
pub(crate) fn pans() -> PyResult<Vec<String>> {
    Ok(library()?.pans.keys().cloned().collect())
}

/// Names of the hobs.
#[pyfunction]
pub(crate) fn hobs() -> PyResult<Vec<String>> {
    Ok(library()?.hobs.keys().cloned().collect())
}

/// Names of the oils and fats.
#[pyfunction]
pub(crate) fn oils() -> PyResult<Vec<String>> {
    Ok(library()?.oils.keys().cloned().collect())
}

/// Names of the shipped recipes.
#[pyfunction]
pub(crate) fn recipes() -> PyResult<Vec<String>> {
    Ok(library()?.recipes.keys().cloned().collect())
}
