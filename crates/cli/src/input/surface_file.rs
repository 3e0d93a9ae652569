//! Surface files: triangle meshes in STL, OBJ or glTF.

use std::path::{Component, Path, PathBuf};

use saute_kitchen::heat::Soup;

use crate::error::CliError;

/// Larger files are not read [bytes] (chosen: 100,000 triangles take 20 MB as text).
const LARGEST: u64 = 128 << 20;

/// Reads the triangles of a surface file.
pub fn read(path: &Path) -> Result<Soup, CliError> {
    let bytes = bytes(path).map_err(|e| {
        CliError::place(path.display(), format!("cannot be read: {e}"), "check the path of the surface")
    })?;
    if bytes.len() as u64 > LARGEST {
        return Err(CliError::place(
            path.display(),
            "is larger than 128 MiB",
            "reduce the number of triangles in your modelling program (decimate)",
        ));
    }
    let beside = |name: &str| self::bytes(&in_folder_of(path, name)?).ok();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    saute_surface::read(&name, &bytes, beside).map_err(|e| CliError::place(path.display(), e.message, e.remedy))
}

/// Returns the path of a file that a surface file names; `None` if it lies outside the folder of the surface file.
fn in_folder_of(path: &Path, name: &str) -> Option<PathBuf> {
    let is_plain = |part: Component| matches!(part, Component::Normal(_));
    if !Path::new(name).components().all(is_plain) || name.contains(['\\', ':']) {
        return None;
    }
    // Links are followed first: one in the folder may lead out of it.
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
    std::fs::File::open(path)?.take(LARGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
