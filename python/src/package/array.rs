//! NumPy arrays that show memory of the simulator without a copy.
//!
//! An array takes the address, the shape and the strides of a field by NumPy's array interface and keeps the [`Memory`] as its
//! base. This is the one place where an address leaves Rust's care: no word `unsafe` is here, because giving an address is
//! safe and NumPy does the reading, so it must be shown by hand that the address stays good. It does:
//!
//! - The address is that of a slice inside of a value behind an [`Arc`], and the memory has a clone of that [`Arc`]. While an
//!   array lives, so does its base, and the value is neither moved nor dropped.
//! - While a memory lives, the count of the [`Arc`] is above one for everybody else. A kitchen is changed only through
//!   `Arc::make_mut`, which then copies it first. So nobody writes to what an array shows, in no thread.
//! - Nothing shown has interior mutability: the slices are numbers in vectors of plain data.
//! - The interface states "read only", and the memory offers no buffer, so NumPy refuses to make the array writeable.
//! - Shape and strides come from the slice itself ([`Memory::rows`]), so that no element is outside of it.

use std::any::Any;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple};

/// What an array shows, and what keeps it alive.
#[pyclass(frozen, module = "saute._core")]
pub(crate) struct Memory {
    _owner: Arc<dyn Any + Send + Sync>,
    address: usize,
    shape: Vec<usize>,
    strides: Vec<usize>,
    kind: &'static str,
}

/// A number that arrays show: its name in NumPy's array interface.
pub(crate) trait Number: Copy + 'static {
    /// As "<f8".
    const KIND: &'static str;
}

impl Number for f32 {
    const KIND: &'static str = "<f4";
}

impl Number for f64 {
    const KIND: &'static str = "<f8";
}

impl Number for u32 {
    const KIND: &'static str = "<u4";
}

impl Number for u8 {
    const KIND: &'static str = "|u1";
}

// The names above state little endian, as every platform is that Python's wheels are built for.
#[cfg(target_endian = "big")]
compile_error!("arrays are shown in the order of bytes of little-endian machines");

impl Memory {
    /// The numbers of a field.
    fn flat<T: Number, O: Any + Send + Sync>(owner: &Arc<O>, field: impl FnOnce(&O) -> &[T]) -> Self {
        let slice = field(owner);
        let (address, count) = (slice.as_ptr() as usize, slice.len());
        Self::at(owner, address, vec![count], vec![size_of::<T>()], T::KIND)
    }

    /// `N` numbers in each row of a table; `numbers` picks them.
    fn rows<R: Copy + 'static, T: Number, const N: usize, O: Any + Send + Sync>(
        owner: &Arc<O>,
        table: impl FnOnce(&O) -> &[R],
        numbers: impl FnOnce(&R) -> &[T; N],
    ) -> Self {
        let slice = table(owner);
        // The picked numbers are inside of the first row, and so at the same place in every other one.
        let address = slice.first().map_or(0, |row| std::ptr::from_ref(numbers(row)) as usize);
        Self::at(owner, address, vec![slice.len(), N], vec![size_of::<R>(), size_of::<T>()], T::KIND)
    }

    fn at<O: Any + Send + Sync>(
        owner: &Arc<O>,
        address: usize,
        shape: Vec<usize>,
        strides: Vec<usize>,
        kind: &'static str,
    ) -> Self {
        Self { _owner: Arc::clone(owner) as _, address, shape, strides, kind }
    }

    fn array(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        static AS_ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        let as_array =
            AS_ARRAY.get_or_try_init(py, || Ok::<_, PyErr>(py.import("numpy")?.getattr("asarray")?.unbind()))?;
        as_array.bind(py).call1((self,))
    }
}

#[pymethods]
impl Memory {
    /// NumPy's array interface, version 3.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", self.kind)?;
        interface.set_item("shape", PyTuple::new(py, &self.shape)?)?;
        interface.set_item("strides", PyTuple::new(py, &self.strides)?)?;
        interface.set_item("data", (self.address, true))?;
        Ok(interface)
    }
}

/// Returns an array that shows the numbers of a field.
pub(crate) fn shown<'py, T: Number, O: Any + Send + Sync>(
    py: Python<'py>,
    owner: &Arc<O>,
    field: impl FnOnce(&O) -> &[T],
) -> PyResult<Bound<'py, PyAny>> {
    Memory::flat(owner, field).array(py)
}

/// Returns an array that shows `N` numbers of each row of a table.
pub(crate) fn shown_rows<'py, R: Copy + 'static, T: Number, const N: usize, O: Any + Send + Sync>(
    py: Python<'py>,
    owner: &Arc<O>,
    table: impl FnOnce(&O) -> &[R],
    numbers: impl FnOnce(&R) -> &[T; N],
) -> PyResult<Bound<'py, PyAny>> {
    Memory::rows(owner, table, numbers).array(py)
}

/// Returns an array of numbers that were made for it.
pub(crate) fn made<T: Number + Send + Sync>(py: Python<'_>, numbers: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    shown(py, &Arc::new(numbers), |numbers| numbers)
}
