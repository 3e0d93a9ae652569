//! Binary STL.

use crate::read_error::CUT_OFF;
use crate::text_lines::NOT_FINITE;
use crate::{ReadError, Soup, enough_room};

/// Size of the header, with the number of triangles in its last four bytes [B].
pub const HEAD: usize = 84;
/// Place of the number of triangles [B].
const COUNT: usize = HEAD - 4;
/// Size of a triangle: normal, three corners, attributes [B].
const TRIANGLE: usize = 50;
/// Place of the corners within a triangle, behind the normal [B].
const CORNERS: usize = 12;
/// Size of a coordinate [B].
const COORDINATE: usize = 4;

/// Returns true if a file has the length that follows from its number of triangles.
pub fn has_its_length(bytes: &[u8]) -> bool {
    stated(bytes).is_some_and(|count| bytes.len() as u64 == length(count))
}

/// The number of triangles that a header states.
fn stated(bytes: &[u8]) -> Option<u32> {
    bytes.get(COUNT..)?.first_chunk::<4>().map(|count| u32::from_le_bytes(*count))
}

/// Length of a file with so many triangles [B].
fn length(count: u32) -> u64 {
    HEAD as u64 + TRIANGLE as u64 * u64::from(count)
}

/// Returns the triangles of a file.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
    let count = stated(bytes).ok_or_else(|| ReadError::at_byte(bytes.len(), "ends within the header", CUT_OFF))?;
    if bytes.len() as u64 != length(count) {
        return Err(wrong_length(bytes.len(), count));
    }
    enough_room(count as usize, 3 * count as usize)?;
    let mut soup = Soup::default();
    for (at, triangle) in (HEAD..).step_by(TRIANGLE).zip(bytes[HEAD..].as_chunks::<TRIANGLE>().0) {
        let first = soup.vertices.len() as u32;
        let numbers = triangle[CORNERS..].as_chunks::<COORDINATE>().0.iter().map(|v| f32::from_le_bytes(*v));
        let numbers: Vec<f64> = numbers.map(f64::from).collect();
        if let Some(wrong) = numbers.iter().position(|v| !v.is_finite()) {
            let message = format!("coordinate {} is no finite number", numbers[wrong]);
            return Err(ReadError::at_byte(at + CORNERS + COORDINATE * wrong, message, NOT_FINITE));
        }
        soup.vertices.extend(numbers.as_chunks::<3>().0);
        soup.triangles.push([first, first + 1, first + 2]);
    }
    Ok(soup)
}

fn wrong_length(held: usize, count: u32) -> ReadError {
    let needed = length(count);
    let stated = format!("{needed} bytes of a binary STL with {count} triangles (bytes {COUNT} to {})", HEAD - 1);
    if (held as u64) < needed {
        return ReadError::at_byte(held, format!("ends before the {stated}"), CUT_OFF);
    }
    let remedy = "export the body alone, as one binary STL file, or as ASCII STL";
    ReadError::at_byte(needed as usize, format!("goes on after the {stated}"), remedy)
}
