//! Files of the Visualization Toolkit: unstructured grids (VTU) and their times (PVD).
//!
//! Format: <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

pub mod collection;
pub mod grid;
pub mod vtu_file;

pub use collection::Collection;
pub use grid::{Array, CellKind, Cells, Grid, Numbers};
