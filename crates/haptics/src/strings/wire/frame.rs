//! The frame: eighty bytes of header, payload and checksum.

use super::message::{Message, PAYLOAD, PayloadError};

/// Length of a frame [bytes].
pub const FRAME: usize = 80;
/// Offset of the payload [bytes].
const HEADER: usize = 12;
/// Offset of the checksum, directly after the payload [bytes].
const CHECK: usize = HEADER + PAYLOAD;
/// First two bytes of a frame.
pub const MAGIC: [u8; 2] = *b"SP";
/// Protocol version.
pub const VERSION: u8 = 2;

/// A message with its sequence number and session.
///
/// ```
/// use saute_haptics::strings::wire::{Frame, FrameError, Message};
///
/// let frame = Frame { sequence: 2, session: 7, message: Message::Arm };
/// let mut bytes = frame.encode();
/// assert_eq!(Frame::decode(&bytes), Ok(frame));
/// bytes[4] ^= 1;
/// assert_eq!(Frame::decode(&bytes), Err(FrameError::Checksum));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Sequence number, which increases with every frame of its sender.
    pub sequence: u32,
    /// Session, a random number that the host draws for its hello and the device repeats.
    pub session: u32,
    /// The message.
    pub message: Message,
}

/// Why bytes are not a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// The length is not 80 bytes.
    #[error("a frame has {FRAME} bytes, not {0}")]
    Length(usize),
    /// The magic bytes "SP" are missing.
    #[error("does not begin with \"SP\"")]
    Magic,
    /// The checksum does not match: the frame is damaged.
    #[error("the checksum does not match")]
    Checksum,
    /// The protocol version is not supported.
    #[error("protocol version {0}; this program supports {VERSION}")]
    Version(u8),
    /// The payload is invalid.
    #[error(transparent)]
    Payload(#[from] PayloadError),
}

/// Returns the CRC-32 of IEEE 802.3 [-].
fn checksum(bytes: &[u8]) -> u32 {
    crc32fast::hash(bytes)
}

impl Frame {
    /// Returns the frame's bytes.
    pub fn encode(&self) -> [u8; FRAME] {
        let mut bytes = [0; FRAME];
        bytes[..2].copy_from_slice(&MAGIC);
        bytes[2] = self.message.version();
        let (kind, payload) = self.message.encode();
        bytes[3] = kind;
        bytes[4..8].copy_from_slice(&self.sequence.to_le_bytes());
        bytes[8..12].copy_from_slice(&self.session.to_le_bytes());
        bytes[HEADER..CHECK].copy_from_slice(&payload);
        let check = checksum(&bytes[..CHECK]);
        bytes[CHECK..].copy_from_slice(&check.to_le_bytes());
        bytes
    }

    /// Parses a frame.
    pub fn decode(bytes: &[u8]) -> Result<Self, FrameError> {
        let bytes: &[u8; FRAME] = bytes.try_into().map_err(|_| FrameError::Length(bytes.len()))?;
        if bytes[..2] != MAGIC {
            return Err(FrameError::Magic);
        }
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        if word(CHECK) != checksum(&bytes[..CHECK]) {
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

#[cfg(test)]
mod tests {
    #[test]
    fn the_check_value_of_the_standard() {
        assert_eq!(super::checksum(b"123456789"), 0xcbf4_3926);
    }
}
