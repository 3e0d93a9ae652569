//! Wavefront OBJ files.

use std::io::Cursor;

use crate::{DAMAGED, ReadError, Soup};

/// Returns the triangles of all objects of a file; faces with more than three corners are triangulated.
///
/// # Errors
/// [`ReadError`] if the file is not valid.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
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
