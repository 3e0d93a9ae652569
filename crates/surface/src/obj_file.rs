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

/// Counts the triangles and the corners of a file before it is parsed, which takes many times the memory of its text, and
/// checks that faces refer to what is there: the parser computes with their indices before it does.
fn bounded(bytes: &[u8]) -> Result<(), ReadError> {
    let (mut triangles, mut counts, mut highest) = (0, [0; 3], [0; 3]);
    for line in bytes.split(|b| *b == b'\n') {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let kind = words.next();
        match kind.map(|word| (word, KINDS.iter().position(|kind| *kind == word))) {
            Some((_, Some(kind))) => counts[kind] += 1,
            // A polygon with n corners becomes n − 2 triangles.
            Some((b"f" | b"l" | b"p", _)) => {
                let mut corners = 0;
                for corner in words {
                    refer(corner, &counts, &mut highest)?;
                    corners += 1;
                }
                triangles += usize::max(corners, 3) - 2;
            }
            _ => {}
        }
    }
    if let Some(kind) = (0..3).find(|kind| highest[*kind] > counts[*kind] as i64) {
        return Err(absent(highest[kind], kind, counts[kind]));
    }
    // Normals and texture coordinates may be as many each.
    enough_room(triangles, counts[0].max((counts[1] + counts[2]) / 2))
}

/// Words before a vertex, a texture coordinate and a normal, in the order in which a corner names them.
const KINDS: [&[u8]; 3] = [b"v", b"vt", b"vn"];

/// Notes the largest indices of a corner such as `5/1/-2`; a negative one counts back from what was read so far.
fn refer(corner: &[u8], counts: &[usize; 3], highest: &mut [i64; 3]) -> Result<(), ReadError> {
    for (kind, number) in corner.split(|b| *b == b'/').take(3).enumerate() {
        // What is no number is refused by the parser.
        let Some(index) = std::str::from_utf8(number).ok().and_then(|text| text.parse::<i64>().ok()) else { continue };
        if index == 0 || (index < 0 && index.unsigned_abs() > counts[kind] as u64) {
            return Err(absent(index, kind, counts[kind]));
        }
        highest[kind] = highest[kind].max(index);
    }
    Ok(())
}

fn absent(index: i64, kind: usize, count: usize) -> ReadError {
    let what = ["vertex", "texture coordinate", "normal"][kind];
    ReadError::new(format!("refers to {what} {index}, but contains {count}"), DAMAGED)
}
