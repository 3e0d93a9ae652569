//! Surface files: triangle meshes in STL, OBJ or glTF.

use std::path::{Path, PathBuf};

use saute_kitchen::heat::Soup;
use saute_surface::{Place, ReadError};

use crate::error::CliError;

/// Larger files are not read [MiB] (chosen: the largest surface takes 100 MB as text).
const LARGEST_MIB: u64 = 128;

/// Reads the triangles of a surface file.
pub fn read(path: &Path) -> Result<Soup, ReadError> {
    let bytes = bytes(path).map_err(|e| {
        whole(format!("cannot be read: {e}"), "name a file with a surface, and check its path and its permissions")
    })?;
    if bytes.len() as u64 > LARGEST_MIB << 20 {
        let remedy = "reduce the number of triangles in your modelling program (decimate), or export it as .glb";
        return Err(whole(format!("is larger than {LARGEST_MIB} MiB"), remedy));
    }
    let beside = |name: &str| self::bytes(&in_folder_of(path, name)?).ok();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    saute_surface::read(&name, &bytes, beside)
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

fn whole(message: String, remedy: &str) -> ReadError {
    ReadError { place: Place::File, message, remedy: remedy.to_owned() }
}

/// Returns the path of a file that a surface file names; `None` if a link leads out of the folder of the surface file.
fn in_folder_of(path: &Path, name: &str) -> Option<PathBuf> {
    let file = path.with_file_name(name).canonicalize().ok()?;
    let folder = path.canonicalize().ok()?.parent()?.to_owned();
    file.starts_with(folder).then_some(file)
}

/// Reads a regular file: a pipe or a device could block, or have no end.
fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    use std::io::Read;
    if !path.metadata()?.is_file() {
        return Err(std::io::Error::other("it is no regular file"));
    }
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take((LARGEST_MIB << 20) + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
