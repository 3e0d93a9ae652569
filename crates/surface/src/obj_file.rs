//! Wavefront OBJ files.

use std::io::Cursor;

use crate::{DAMAGED, ReadError, Soup, enough_room};

/// Returns the triangles of all objects of a file; faces with more than three corners are triangulated.
///
/// # Errors
/// [`ReadError`] if the file is not valid.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
    bounded(bytes)?;
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    // Materials do not affect the shape.
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(bytes), &options, no_materials)
        .map_err(|e| ReadError::new(format!("is not a valid OBJ file: {e}"), DAMAGED))?;
    let mut soup = Soup::default();
    for mesh in models.iter().map(|m| &m.mesh) {
        let first = soup.vertices.len() as u32;
        soup.vertices.extend(mesh.positions.as_chunks::<3>().0);
        soup.triangles.extend(mesh.indices.as_chunks::<3>().0.iter().map(|t| t.map(|i| first + i)));
    }
    Ok(soup)
}

/// Counts the triangles and the corners of a file before it is parsed: parsing takes many times the memory of its text.
fn bounded(bytes: &[u8]) -> Result<(), ReadError> {
    let [mut triangles, mut corners, mut others] = [0, 0, 0];
    for line in bytes.split(|b| *b == b'\n') {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match words.next() {
            // A polygon with n corners becomes n − 2 triangles.
            Some(b"f") => triangles += words.count().max(3) - 2,
            Some(b"v") => corners += 1,
            Some(b"vn" | b"vt") => others += 1,
            _ => {}
        }
    }
    // Normals and texture coordinates may be as many each.
    enough_room(triangles, corners.max(others / 2))
}
