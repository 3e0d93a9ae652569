//! STL files.

use std::borrow::Cow;
use std::io::Cursor;

use crate::{DAMAGED, ReadError, Soup, enough_room};

/// Size of the header of a binary file, with the number of triangles in its last four bytes [B].
const HEAD: usize = 84;
/// Size of a triangle in a binary file [B].
const TRIANGLE: usize = 50;

/// Returns the triangles of a binary or ASCII file.
///
/// # Errors
/// [`ReadError`] if the file is not valid or its length does not match its number of triangles.
pub fn read(bytes: &[u8]) -> Result<Soup, ReadError> {
    let prepared = prepare(bytes)?;
    let error = |e: std::io::Error| ReadError::new(format!("is not a valid STL file: {e}"), DAMAGED);
    let mut cursor = Cursor::new(prepared.as_ref());
    let mut soup = Soup::default();
    for triangle in stl_io::create_stl_reader(&mut cursor).map_err(error)? {
        let first = soup.vertices.len() as u32;
        enough_room(soup.triangles.len() + 1, soup.vertices.len() + 3)?;
        soup.vertices.extend(triangle.map_err(error)?.vertices.map(|v| v.0.map(f64::from)));
        soup.triangles.push([first, first + 1, first + 2]);
    }
    Ok(soup)
}

/// Returns the file in the form that `stl_io` recognises as binary or ASCII.
///
/// The length decides, not the first word: many binary files also begin with "solid".
fn prepare(bytes: &[u8]) -> Result<Cow<'_, [u8]>, ReadError> {
    let count = bytes.get(HEAD - 4..HEAD).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
    let needed = count.map(|n| HEAD as u64 + TRIANGLE as u64 * u64::from(n));
    let is_text = bytes.starts_with(b"solid");
    match needed {
        Some(needed) if bytes.len() as u64 == needed => {
            let mut plain = bytes.to_vec();
            plain[..5].fill(0);
            Ok(Cow::Owned(plain))
        }
        Some(needed) if !is_text => {
            let message = format!("is truncated or too long: {} bytes instead of {needed}", bytes.len());
            Err(ReadError::new(message, DAMAGED))
        }
        None if !is_text => Err(ReadError::new("is not an STL file", DAMAGED)),
        // An ASCII body without a name is valid and frequent.
        _ if bytes.get(5) != Some(&b' ') => Ok(Cow::Owned([b"solid ", &bytes[5..]].concat())),
        _ => Ok(Cow::Borrowed(bytes)),
    }
}
