//! Frames on a serial port or any other byte stream.

use std::io::{self, Read, Write};
use std::time::Duration;

use super::frame::{Frame, FrameError};
use super::link::Link;
use super::stuffing::{Deframer, stuff};

/// Size of the read buffer [bytes] (chosen: three frames).
const CHUNK: usize = 256;

/// Write timeout of a frame (chosen: a fifth of a step; a slower frame counts as lost).
const WRITE_TIMEOUT: Duration = Duration::from_micros(200);

/// Frames on a non-blocking stream: a read without data fails with `WouldBlock` or `TimedOut`, or returns 0.
#[derive(Debug)]
pub struct SerialLink<S> {
    stream: S,
    deframer: Deframer,
    held: [u8; CHUNK],
    next: usize,
    end: usize,
}

/// A serial port that is read only when data has arrived: a timeout would create an error, and errors allocate.
pub struct Port(Box<dyn serialport::SerialPort>);

impl Read for Port {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self.0.bytes_to_read() {
            Ok(0) => Err(io::ErrorKind::WouldBlock.into()),
            _ => self.0.read(into),
        }
    }
}

impl Write for Port {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl SerialLink<Port> {
    /// Opens a serial port such as `/dev/ttyACM0`; 1 Mbaud is the minimum for a thousand frames per second each way.
    pub fn open(port: &str, baud: u32) -> io::Result<Self> {
        let stream = serialport::new(port, baud).timeout(WRITE_TIMEOUT).open()?;
        Ok(Self::over(Port(stream)))
    }
}

impl<S: Read + Write> SerialLink<S> {
    /// Creates a link over a stream.
    pub fn over(stream: S) -> Self {
        Self { stream, deframer: Deframer::default(), held: [0; CHUNK], next: 0, end: 0 }
    }
}

impl<S: Read + Write + Send> Link for SerialLink<S> {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        self.stream.write_all(&stuff(&frame.encode()))
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        loop {
            while self.next < self.end {
                let byte = self.held[self.next];
                self.next += 1;
                if let Some(bytes) = self.deframer.push(byte) {
                    return Some(Frame::decode(&bytes));
                }
            }
            (self.next, self.end) = (0, self.stream.read(&mut self.held).ok().filter(|n| *n > 0)?);
        }
    }
}
