//! The times of a series of grids, as a PVD file.

use std::fmt::Write;

use crate::vtk::vtu_file::escaped;

/// Grids that belong together, each with its time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Collection {
    entries: Vec<DataSet>,
}

#[derive(Clone, Debug, PartialEq)]
struct DataSet {
    time_s: f64,
    part: usize,
    name: String,
    file: String,
}

impl Collection {
    /// Adds a file at a time [s]: one of the parts that belong to that time, with its name.
    pub fn push(&mut self, time_s: f64, part: usize, name: &str, file: &str) {
        self.entries.push(DataSet { time_s, part, name: name.to_owned(), file: file.to_owned() });
    }

    /// Returns the series as a PVD file.
    pub fn pvd(&self) -> String {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
        );
        for DataSet { time_s, part, name, file } in &self.entries {
            let (name, file) = (escaped(name), escaped(file));
            // Writing to a text does not fail.
            let _ = writeln!(
                text,
                "<DataSet timestep=\"{time_s}\" group=\"\" part=\"{part}\" name=\"{name}\" file=\"{file}\"/>"
            );
        }
        text + "</Collection>\n</VTKFile>\n"
    }
}
