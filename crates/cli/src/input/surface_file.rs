//! Surface files: triangle meshes in STL, OBJ or glTF.

use std::path::Path;

use saute_files::regular_file::{self, Unread};
use saute_kitchen::heat::Soup;
use saute_surface::{Body, Place, ReadError, joined};

use crate::error::CliError;

/// Larger files are not read [MiB] (chosen: the largest surface takes 100 MB as text).
const LARGEST_MIB: u64 = 128;

/// Reads the triangles of all bodies of a surface file.
pub fn read(path: &Path) -> Result<Soup, ReadError> {
    Ok(joined(&bodies(path)?))
}

/// Reads the bodies of a surface file.
pub fn bodies(path: &Path) -> Result<Vec<Body>, ReadError> {
    let bytes = regular_file::read(path, LARGEST_MIB).map_err(|unread| {
        let remedy = match unread {
            Unread::Large(_) => {
                "reduce the number of triangles in your modelling program (decimate), or export it as .glb"
            }
            _ => "name a file with a surface, and check its path and its permissions",
        };
        ReadError { place: Place::File, message: unread.to_string(), remedy: remedy.to_owned() }
    })?;
    let beside = |name: &str| regular_file::read_beside(path, name, LARGEST_MIB);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    saute_surface::bodies(&name, &bytes, beside)
}

/// Returns the error of a surface file with its path, and its line or byte.
pub fn refused(path: &Path, error: ReadError) -> CliError {
    let path = path.display();
    match error.place {
        Place::File => CliError::place(path, error.message, error.remedy),
        Place::Line(line) => CliError::place(format!("{path}:{line}"), error.message, error.remedy),
        Place::Byte(byte) => CliError::place(format!("{path}, byte {byte}"), error.message, error.remedy),
    }
}
