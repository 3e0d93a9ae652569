//! Surface files (STL, OBJ, glTF) as loose triangles; knows no file system: bytes come in.

mod gltf_file;
mod obj_file;
mod stl_file;

use std::path::Path;

pub use saute_heat::Soup;

/// A format of surface files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Stereolithography, binary or ASCII.
    Stl,
    /// Wavefront.
    Obj,
    /// glTF 2.0, as JSON or binary.
    Gltf,
}

/// Endings of the names of surface files.
pub const ENDINGS: [&str; 4] = ["stl", "obj", "gltf", "glb"];

impl Format {
    /// The format that a file's name tells.
    pub fn of(name: &str) -> Option<Self> {
        match Path::new(name).extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "stl" => Some(Self::Stl),
            "obj" => Some(Self::Obj),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }

    /// Millimetres in one unit of a file, unless told otherwise [mm]: glTF is in metres, the others mostly in millimetres.
    fn unit_mm(self) -> f64 {
        if self == Self::Gltf { 1000.0 } else { 1.0 }
    }
}

/// Why a surface file could not be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ReadError {
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub remedy: String,
}

impl ReadError {
    fn new(message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { message: message.into(), remedy: remedy.into() }
    }
}

/// Reads a surface file; `beside` gives the bytes of a file that lies beside it (the `.bin` of a glTF).
///
/// z points up in what is returned: glTF files, in which y does, are turned.
pub fn read(name: &str, bytes: &[u8], beside: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Soup, ReadError> {
    let Some(format) = Format::of(name) else {
        return Err(ReadError::new("is no surface file that can be read", "export it as .stl, .obj, .gltf or .glb"));
    };
    let mut soup = match format {
        Format::Stl => stl_file::read(bytes),
        Format::Obj => obj_file::read(bytes),
        Format::Gltf => gltf_file::read(bytes, beside),
    }?;
    soup.unit_mm = format.unit_mm();
    if soup.triangles.is_empty() {
        return Err(ReadError::new(
            "holds no triangle",
            "export the body as a triangle mesh (points, lines and curved patches are not read)",
        ));
    }
    Ok(soup)
}

const DAMAGED: &str = "export it again; the file is damaged or of another format than its name tells";
