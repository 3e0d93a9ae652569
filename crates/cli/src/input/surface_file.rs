//! Surface files: triangle meshes in STL, OBJ or glTF.

use std::path::Path;

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
    let beside = |name: &str| self::bytes(&path.with_file_name(name)).ok();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    saute_surface::read(&name, &bytes, beside).map_err(|e| CliError::place(path.display(), e.message, e.remedy))
}

fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    use std::io::Read;
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take(LARGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
