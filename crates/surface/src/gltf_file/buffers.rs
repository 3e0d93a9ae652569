//! The bytes of the buffers of a glTF file.

use data_encoding::BASE64;

use crate::ReadError;
use crate::gltf_file::document::{Buffer, Document};
use crate::gltf_file::{extensions, reference};
use crate::read_error::{CUT_OFF, DAMAGED, TOO_LARGE};

/// Total length of all buffers [bytes] (chosen: buffers also hold what is not read, such as pictures).
const MOST_BUFFER_BYTES: usize = 128 << 20;

/// Returns the bytes of all buffers: the binary chunk, a data URI, or a file in the same folder.
pub fn read(
    document: &Document,
    binary: Option<&[u8]>,
    sibling: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Vec<u8>>, ReadError> {
    let declared = document.buffers.iter().fold(0, |sum: usize, buffer| sum.saturating_add(buffer.byte_length));
    enough_bytes(declared)?;
    let mut read = 0;
    let bytes = |(index, buffer): (usize, &Buffer)| {
        let bytes = match (&buffer.uri, binary) {
            (Some(uri), _) => named(uri, index, &sibling)?,
            (None, Some(binary)) if index == 0 => binary.to_vec(),
            (None, _) => return Err(extensions::without_data(&document.extensions_used, &format!("buffer {index}"))),
        };
        // A file that many buffers name is read for each.
        read += bytes.len();
        enough_bytes(read)?;
        whole(bytes, buffer, index)
    };
    document.buffers.iter().enumerate().map(bytes).collect()
}

/// Returns the bytes up to the length that a buffer declares: views are within it, and the sum of all bounds the memory.
fn whole(mut bytes: Vec<u8>, buffer: &Buffer, index: usize) -> Result<Vec<u8>, ReadError> {
    if bytes.len() < buffer.byte_length {
        let message = format!("its buffer {index} has {} of {} bytes", bytes.len(), buffer.byte_length);
        return Err(ReadError::new(message, CUT_OFF));
    }
    bytes.truncate(buffer.byte_length);
    bytes.shrink_to_fit();
    Ok(bytes)
}

fn enough_bytes(count: usize) -> Result<(), ReadError> {
    if count > MOST_BUFFER_BYTES {
        return Err(ReadError::new(format!("has buffers of {count} bytes"), TOO_LARGE));
    }
    Ok(())
}

/// Returns the bytes that a URI contains or names.
fn named(uri: &str, index: usize, sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Vec<u8>, ReadError> {
    if uri.get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:")) {
        let decoded = uri.split_once(";base64,").and_then(|(_, data)| from_base64(&reference::decoded(data)));
        return decoded.ok_or_else(|| ReadError::new(format!("its buffer {index} is no base64 text"), DAMAGED));
    }
    let path = reference::in_folder(uri)?;
    sibling(&path).ok_or_else(|| {
        let message = format!("refers to {path:?}, which is no file in the same folder that can be read");
        ReadError::new(message, "put that file into the same folder, or export a single .glb file")
    })
}

/// Returns the bytes of padded standard base64 text (RFC 4648, section 4), or `None` if the text is not canonical.
///
/// `BASE64` alone also decodes a concatenation of padded texts; RFC 4648 permits padding only at the end.
fn from_base64(text: &[u8]) -> Option<Vec<u8>> {
    let is_padded_inside = text.split(|byte| *byte == b'=').skip(1).any(|part| !part.is_empty());
    if is_padded_inside { None } else { BASE64.decode(text).ok() }
}
