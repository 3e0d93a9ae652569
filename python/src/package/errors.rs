//! Errors as the exceptions of the package, which are classes of Python (`saute/_errors.py`).

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use saute_kitchen::Refused;
use saute_kitchen::bytes::BytesError;
use saute_kitchen::kitchen::SetupError;
use saute_schema::InputError;
use saute_sweep_folder::FolderError;

use crate::package::recipe::Source;

/// Returns an exception of a class of the package.
fn raised<A>(class: &str, arguments: A) -> PyErr
where
    A: for<'py> IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
{
    Python::attach(|py| {
        let made =
            py.import("saute._errors").and_then(|module| module.getattr(class)?.call1(arguments.into_pyobject(py)?));
        made.map_or_else(|error| error, PyErr::from_value)
    })
}

/// What is wrong with a recipe.
pub(crate) fn input(error: InputError, source: &Source) -> PyErr {
    let key = source.key_at(error.line);
    let line = source.has_lines.then_some(error.line);
    raised("InputError", (error.message, error.file, key, error.remedy, line))
}

/// What is wrong with an argument in the place of a recipe.
pub(crate) fn argument(message: String, remedy: String) -> PyErr {
    raised("InputError", (message, Option::<String>::None, Option::<String>::None, remedy, Option::<usize>::None))
}

/// A file of a user's data that cannot be used.
pub(crate) fn data(message: &str, file: String, line: usize) -> PyErr {
    let remedy = "correct the file, or take it out of the folder";
    raised("InputError", (message.to_owned(), file, Option::<String>::None, remedy, line))
}

/// What is wrong with a file that is no recipe; without its line where nobody has seen lines.
pub(crate) fn at_line(error: InputError, has_lines: bool) -> PyErr {
    let line = has_lines.then_some(error.line);
    raised("InputError", (error.message, error.file, Option::<String>::None, error.remedy, line))
}

/// A folder of results that cannot be used.
pub(crate) fn folder(error: &FolderError) -> PyErr {
    let FolderError { place, message, remedy } = error.clone();
    raised("InputError", (message, place, Option::<String>::None, remedy, Option::<usize>::None))
}

/// A kitchen that cannot be built.
pub(crate) fn setup(error: &SetupError, file: &str) -> PyErr {
    let remedy = "name a food, a pan and sizes that can be built";
    raised("InputError", (error.to_string(), file.to_owned(), Option::<String>::None, remedy, Option::<usize>::None))
}

/// A command that the kitchen does not take; it is unchanged.
pub(crate) fn refused(reason: &Refused) -> PyErr {
    raised("RefusedError", (reason.to_string(),))
}

/// A command that some kitchens of a batch do not take; these are unchanged.
pub(crate) fn refused_at(reason: &Refused, kitchens: &[usize]) -> PyErr {
    let places: Vec<String> = kitchens.iter().map(usize::to_string).collect();
    raised("RefusedError", (format!("in kitchen {}: {reason}", places.join(", ")),))
}

/// A kitchen on the reduced mesh was used for more than readings.
pub(crate) fn on_reduced_mesh() -> PyErr {
    let reason = "this kitchen is on the reduced mesh of a batch and can only be read: step and command the batch";
    raised("RefusedError", (reason,))
}

/// Bytes that are no kitchen.
pub(crate) fn bytes(error: &BytesError) -> PyErr {
    raised("SnapshotError", (error.to_string(),))
}

/// No picture can be drawn.
pub(crate) fn graphics(error: &impl ToString) -> PyErr {
    raised("GraphicsError", (error.to_string(),))
}

/// A fault of the package itself.
pub(crate) fn fault(error: &impl ToString) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}
