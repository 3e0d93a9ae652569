//! Frames on a byte stream: consistent-overhead byte stuffing (COBS, Cheshire & Baker 1999 `[@cheshire-baker-1999]`),
//! each frame terminated by a zero.

use super::frame::FRAME;

/// Length of a stuffed frame [bytes]: one code byte more than a frame, and the terminating zero.
pub const STUFFED: usize = FRAME + 2;

/// Returns a frame's bytes with no zero except the terminating one.
pub fn stuff(frame: &[u8; FRAME]) -> [u8; STUFFED] {
    let mut out = [0; STUFFED];
    // A frame is shorter than 254 bytes, so it has exactly one code byte of overhead.
    cobs::encode(frame, &mut out);
    out
}

/// Reverses [`stuff`] on the bytes before the zero; returns `None` if they do not encode exactly one frame.
fn unstuff(stuffed: &[u8; STUFFED - 1]) -> Option<[u8; FRAME]> {
    let mut frame = [0; FRAME];
    let length = cobs::decode(stuffed, &mut frame).ok()?;
    (length == FRAME).then_some(frame)
}

/// Finds frames in a stream of bytes; it finds the first whole frame after a zero, whatever came before.
#[derive(Clone, Copy, Debug)]
pub struct Deframer {
    held: [u8; STUFFED - 1],
    count: usize,
}

impl Default for Deframer {
    fn default() -> Self {
        Self { held: [0; STUFFED - 1], count: 0 }
    }
}

impl Deframer {
    /// Appends one byte; returns a frame's bytes when the byte completes one.
    pub fn push(&mut self, byte: u8) -> Option<[u8; FRAME]> {
        if byte != 0 {
            if self.count < self.held.len() {
                self.held[self.count] = byte;
            }
            self.count = (self.count + 1).min(self.held.len() + 1);
            return None;
        }
        let whole = self.count == self.held.len();
        self.count = 0;
        if whole { unstuff(&self.held) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Returns true if the code bytes of a stuffed frame lead exactly to its end; the definition of a valid frame of this length.
    fn is_valid(stuffed: &[u8; STUFFED - 1]) -> bool {
        let mut next_code = 0;
        while next_code < stuffed.len() {
            next_code += stuffed[next_code] as usize;
        }
        next_code == stuffed.len()
    }

    proptest! {
        #[test]
        fn exactly_the_frames_whose_code_bytes_lead_to_their_end_are_accepted(
            bytes in proptest::collection::vec(1u8..=255, STUFFED - 1),
            short in proptest::collection::vec(1u8..8, STUFFED - 1),
        ) {
            for bytes in [bytes, short] {
                let stuffed: [u8; STUFFED - 1] = bytes.try_into().expect("the length");
                let frame = unstuff(&stuffed);
                prop_assert_eq!(frame.is_some(), is_valid(&stuffed));
                if let Some(frame) = frame {
                    prop_assert_eq!(&stuff(&frame)[..STUFFED - 1], &stuffed[..]);
                }
            }
        }
    }
}
