//! STL files.

mod binary;
mod text;

use crate::read_error::DAMAGED;
use crate::text_lines::{lines, unmarked};
use crate::{ReadError, Soup};

/// Returns the triangles of all solids of a binary or ASCII file.
///
/// The length decides first, not the first word: many binary files also begin with "solid".
///
/// # Errors
/// [`ReadError`] if the file is not valid or its length does not match its number of triangles.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
    if binary::has_its_length(bytes) {
        return binary::read(bytes);
    }
    let text = unmarked(bytes)?;
    if is_text(text) {
        return text::read(text);
    }
    if bytes.len() < binary::HEAD {
        let message = "is not an STL file: it begins without \"solid\", and is shorter than a binary header";
        return Err(ReadError::new(message, DAMAGED));
    }
    binary::read(bytes)
}

/// Returns true for a text that begins with "solid"; a name may contain any bytes.
fn is_text(text: &[u8]) -> bool {
    let starts =
        |line: &[u8], word: &[u8]| line.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word));
    let mut filled = lines(text).filter(|line| !line.text.is_empty());
    let is_solid = filled.next().is_some_and(|first| starts(first.text, b"solid"));
    // Binary files have zeros in their header or in the number of triangles after it.
    let has_zeros = text.iter().take(binary::HEAD).any(|byte| *byte == 0);
    is_solid
        && (!has_zeros
            || filled.next().is_some_and(|line| starts(line.text, b"facet") || starts(line.text, b"endsolid")))
}
