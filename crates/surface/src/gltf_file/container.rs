//! The parts of a glTF file: JSON alone, or JSON and bytes in a binary container (GLB).

use crate::ReadError;
use crate::read_error::{CUT_OFF, DAMAGED, Place};
use crate::text_lines::unmarked;

/// Length of the header of a binary file: magic, version, length [bytes].
const HEADER: usize = 12;
/// Length of the header of a chunk: length, kind [bytes].
const CHUNK: usize = 8;
/// Version of the container, by the specification [-].
const VERSION: u32 = 2;

/// The parts of a file.
pub struct Container<'a> {
    pub json: &'a [u8],
    /// Place of the JSON in a binary file [bytes].
    json_at: Option<usize>,
    /// Bytes of the first buffer.
    pub binary: Option<&'a [u8]>,
}

/// Returns the parts of a file.
pub fn open(bytes: &[u8]) -> Result<Container<'_>, ReadError> {
    if !bytes.starts_with(b"glTF") {
        return Ok(Container { json: unmarked(bytes)?, json_at: None, binary: None });
    }
    let bytes = held(bytes)?;
    let json = chunk(bytes, HEADER, b"JSON")?;
    // Chunks begin at multiples of four bytes.
    let next = HEADER + CHUNK + json.len().next_multiple_of(4);
    let binary = if next + CHUNK <= bytes.len() { Some(chunk(bytes, next, b"BIN\0")?) } else { None };
    Ok(Container { json, json_at: Some(HEADER + CHUNK), binary })
}

/// Returns the bytes of a binary file up to the length that its header states.
fn held(bytes: &[u8]) -> Result<&[u8], ReadError> {
    let length = number(bytes, 8)? as usize;
    if length < HEADER {
        return Err(ReadError::at_byte(8, format!("states a length of {length} bytes, less than its header"), DAMAGED));
    }
    let version = number(bytes, 4)?;
    if version != VERSION {
        let message = format!("is glTF {version}.0, and only {VERSION}.0 is read");
        return Err(ReadError::at_byte(4, message, format!("export it as glTF {VERSION}.0")));
    }
    bytes.get(..length).ok_or_else(|| {
        ReadError::at_byte(bytes.len(), format!("ends before the {length} bytes that its header states"), CUT_OFF)
    })
}

/// Returns the content of the chunk that begins at a byte.
fn chunk<'a>(bytes: &'a [u8], at: usize, kind: &[u8; 4]) -> Result<&'a [u8], ReadError> {
    let length = number(bytes, at)? as usize;
    let begin = at + CHUNK;
    if bytes.get(at + 4..begin) != Some(kind) {
        let name = String::from_utf8_lossy(kind).replace('\0', "");
        return Err(ReadError::at_byte(at + 4, format!("is no chunk of the kind {name}"), DAMAGED));
    }
    let content = bytes.get(begin..).and_then(|rest| rest.get(..length));
    content.ok_or_else(|| ReadError::at_byte(at, format!("states a chunk of {length} bytes, beyond the file"), CUT_OFF))
}

/// Returns the number in four bytes.
fn number(bytes: &[u8], at: usize) -> Result<u32, ReadError> {
    let four = bytes.get(at..).and_then(|rest| rest.first_chunk::<4>());
    four.map(|four| u32::from_le_bytes(*four)).ok_or_else(|| ReadError::at_byte(bytes.len(), "ends there", CUT_OFF))
}

impl Container<'_> {
    /// Returns the place of an error in the JSON: its line in a text, its byte in a binary file.
    pub fn place(&self, error: &serde_json::Error) -> Place {
        let Some(json_at) = self.json_at else { return Place::Line(error.line()) };
        let before: usize = self.json.split_inclusive(|b| *b == b'\n').take(error.line() - 1).map(<[u8]>::len).sum();
        Place::Byte(json_at + before + error.column().saturating_sub(1))
    }
}
