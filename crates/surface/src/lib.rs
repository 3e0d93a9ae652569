//! Surface files (STL, OBJ, glTF) as loose triangles, from bytes: this crate does not access the file system.
//!
//! A tetrahedron with legs of 10 mm in an OBJ file, closed and measured:
//!
//! ```
//! let obj = b"v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
//! let soup = saute_surface::read("piece.obj", obj, |_| None)?;
//! let surface = saute_heat::Surface::close(&soup, 1e-3 * soup.unit_mm)?;
//! let volume_mm3 = 1e9 * surface.volume();
//! assert!((volume_mm3 - 1000.0 / 6.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod gltf_file;
mod obj_file;
mod read_error;
mod stl_file;
mod text_lines;

use std::path::Path;

pub use read_error::{Place, ReadError};
pub use saute_heat::Soup;
use saute_heat::mesh::surface::MOST_TRIANGLES;

use crate::read_error::TOO_LARGE;

/// A format of surface files, with its default unit of length [mm].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// STL (stereolithography), binary or ASCII; in millimetres unless the user gives another unit.
    Stl,
    /// Wavefront OBJ; in millimetres unless the user gives another unit.
    Obj,
    /// glTF 2.0, JSON or binary; in metres.
    Gltf,
}

/// File name extensions of the supported formats, in lower case.
pub const ENDINGS: [&str; 4] = ["stl", "obj", "gltf", "glb"];

impl Format {
    /// Returns the format by the extension of a file name, in any case; `None` for other extensions.
    ///
    /// ```
    /// use saute_surface::Format;
    /// assert_eq!(Format::of("piece.GLB"), Some(Format::Gltf));
    /// assert_eq!(Format::of("piece.ply"), None);
    /// ```
    pub fn of(name: &str) -> Option<Self> {
        match Path::new(name).extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "stl" => Some(Self::Stl),
            "obj" => Some(Self::Obj),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }

    /// Returns the default length of a file's unit [mm].
    ///
    /// glTF specifies metres; STL and OBJ have no unit, and most programs write millimetres.
    fn unit_mm(self) -> f64 {
        if self == Self::Gltf { 1000.0 } else { 1.0 }
    }
}

/// A body of a surface file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Body {
    /// Its name, where the file gives it one.
    pub name: Option<String>,
    /// Its triangles, in the unit of the file.
    pub soup: Soup,
}

/// Returns the loose triangles of all bodies of a surface file together, in the unit of the file, with z up.
///
/// # Errors
/// As [`bodies`].
pub fn read(name: &str, bytes: &[u8], sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Soup, ReadError> {
    Ok(joined(&bodies(name, bytes, sibling)?))
}

/// Returns the triangles of bodies of one file together, in the unit of the file.
pub fn joined(bodies: &[Body]) -> Soup {
    let mut all = Soup { unit_mm: bodies.first().map_or(1.0, |body| body.soup.unit_mm), ..Soup::default() };
    for Body { soup, .. } in bodies {
        let first = all.vertices.len() as u32;
        all.vertices.extend(&soup.vertices);
        all.triangles.extend(soup.triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
    }
    all
}

/// Returns the bodies of a surface file, with z up: those of a glTF file by its nodes; an STL or OBJ file is one.
///
/// `sibling` returns the bytes of another file by its path relative to the same folder (the `.bin` of a glTF); the path is
/// decoded, and leads out of the folder only by a link. glTF files have y up and are rotated. The triangles are not checked; [`saute_heat::Surface::close`] does that.
///
/// # Errors
/// [`ReadError`] if the format is unknown, the file is not valid or too large, or it contains no triangle.
pub fn bodies(name: &str, bytes: &[u8], sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Vec<Body>, ReadError> {
    let Some(format) = Format::of(name) else {
        return Err(ReadError::new("is not in a supported format", "export it as .stl, .obj, .gltf or .glb"));
    };
    let one = |soup| vec![Body { name: None, soup }];
    let mut bodies = match format {
        Format::Stl => stl_file::read(bytes).map(one),
        Format::Obj => obj_file::read(bytes).map(one),
        Format::Gltf => gltf_file::read(bytes, sibling),
    }?;
    bodies.retain(|body| !body.soup.triangles.is_empty());
    bodies.iter_mut().for_each(|body| body.soup.unit_mm = format.unit_mm());
    if bodies.is_empty() {
        return Err(ReadError::new(
            "contains no triangle",
            "export the body as a triangle mesh (points, lines and curved patches are not read)",
        ));
    }
    Ok(bodies)
}

/// Corners that are read from a file [-] (chosen: three for each triangle of the largest surface, and as many unused ones).
const MOST_CORNERS: usize = 6 * MOST_TRIANGLES;

/// Returns an error if a file has more triangles or corners than a surface may have; checked before they are stored.
fn enough_room(triangles: usize, corners: usize) -> Result<(), ReadError> {
    if triangles > MOST_TRIANGLES || corners > MOST_CORNERS {
        return Err(ReadError::new(format!("has more than {MOST_TRIANGLES} triangles"), TOO_LARGE));
    }
    Ok(())
}
