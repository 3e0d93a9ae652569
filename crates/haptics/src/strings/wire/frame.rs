//! Eighty bytes: header, payload, checksum.

use super::checksum::crc32;
use super::message::{Message, PAYLOAD, PayloadError};

/// Bytes of a frame.
pub const FRAME: usize = 80;
/// Bytes before the payload.
const HEADER: usize = 12;
/// First byte after the payload.
const CHECK: usize = HEADER + PAYLOAD;
/// First two bytes.
pub const MAGIC: [u8; 2] = *b"SP";
/// Version of the protocol.
pub const VERSION: u8 = 1;

/// A message with its number and session.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Counts up with every frame of its sender.
    pub sequence: u32,
    /// Chosen by the host at its hello; the device repeats it.
    pub session: u32,
    /// What it says.
    pub message: Message,
}

/// Why bytes are no frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// Not 80 bytes.
    #[error("a frame has {FRAME} bytes, not {0}")]
    Length(usize),
    /// Does not begin with "SP".
    #[error("does not begin with \"SP\"")]
    Magic,
    /// Damaged.
    #[error("the checksum does not fit")]
    Checksum,
    /// Another version.
    #[error("version {0} of the protocol; this program speaks {VERSION}")]
    Version(u8),
    /// A payload that means nothing.
    #[error(transparent)]
    Payload(#[from] PayloadError),
}

impl Frame {
    /// As bytes.
    pub fn encode(&self) -> [u8; FRAME] {
        let mut bytes = [0; FRAME];
        bytes[..2].copy_from_slice(&MAGIC);
        bytes[2] = VERSION;
        let (kind, payload) = self.message.encode();
        bytes[3] = kind;
        bytes[4..8].copy_from_slice(&self.sequence.to_le_bytes());
        bytes[8..12].copy_from_slice(&self.session.to_le_bytes());
        bytes[HEADER..CHECK].copy_from_slice(&payload);
        let check = crc32(&bytes[..CHECK]);
        bytes[CHECK..].copy_from_slice(&check.to_le_bytes());
        bytes
    }

    /// From bytes.
    pub fn decode(bytes: &[u8]) -> Result<Self, FrameError> {
        let bytes: &[u8; FRAME] = bytes.try_into().map_err(|_| FrameError::Length(bytes.len()))?;
        if bytes[..2] != MAGIC {
            return Err(FrameError::Magic);
        }
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        if word(CHECK) != crc32(&bytes[..CHECK]) {
            return Err(FrameError::Checksum);
        }
        if bytes[2] != VERSION {
            return Err(FrameError::Version(bytes[2]));
        }
        let mut payload = [0; PAYLOAD];
        payload.copy_from_slice(&bytes[HEADER..CHECK]);
        Ok(Self { sequence: word(4), session: word(8), message: Message::decode(bytes[3], &payload)? })
    }
}
