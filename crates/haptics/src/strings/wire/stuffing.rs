//! Frames on a byte stream: consistent-overhead byte stuffing (Cheshire & Baker 1999), each frame ended by a zero.

use super::frame::FRAME;

/// Bytes of a frame on a stream: one code byte more, and the zero at its end.
pub const STUFFED: usize = FRAME + 2;

/// A frame's bytes without zeros but for the last.
pub fn stuff(frame: &[u8; FRAME]) -> [u8; STUFFED] {
    let mut out = [0; STUFFED];
    let (mut code_at, mut code) = (0, 1u8);
    for (i, byte) in frame.iter().enumerate() {
        if *byte == 0 {
            out[code_at] = code;
            (code_at, code) = (i + 1, 1);
        } else {
            out[i + 1] = *byte;
            code += 1;
        }
    }
    out[code_at] = code;
    out
}

/// Undoes [`stuff`] on the bytes before a zero.
fn unstuff(stuffed: &[u8; STUFFED - 1]) -> Option<[u8; FRAME]> {
    let mut frame = [0; FRAME];
    let mut next_code = stuffed[0] as usize;
    if next_code == 0 {
        return None;
    }
    for i in 1..STUFFED - 1 {
        let byte = stuffed[i];
        if i == next_code {
            next_code += byte as usize;
        } else {
            frame[i - 1] = byte;
        }
        if byte == 0 {
            return None;
        }
    }
    (next_code == STUFFED - 1).then_some(frame)
}

/// Finds frames in a stream of bytes; whatever came before, the first whole frame after a zero is found.
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
    /// Takes one byte; gives a frame's bytes when it ends one.
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
