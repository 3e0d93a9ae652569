//! Frames on a serial port, or any other stream of bytes.

use std::io::{self, Read, Write};
use std::time::Duration;

use super::frame::{Frame, FrameError};
use super::link::Link;
use super::stuffing::{Deframer, stuff};

/// Bytes that are read at once (chosen: three frames).
const CHUNK: usize = 256;

/// How long a frame may take to be written (chosen: a fifth of a tick; more is a lost frame).
const WRITE_TIME: Duration = Duration::from_micros(200);

/// Frames on a stream whose reads do not wait: they fail with `WouldBlock` or `TimedOut`, or give nothing.
#[derive(Debug)]
pub struct SerialLink<S> {
    stream: S,
    deframer: Deframer,
    held: [u8; CHUNK],
    next: usize,
    end: usize,
}

/// A serial port that is read only when something has come: waiting for nothing would make an error, and errors allocate.
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
    /// Opens a serial port such as `/dev/ttyACM0`; 1 Mbaud carries a thousand frames each way, 2 Mbaud with ease.
    pub fn open(port: &str, baud: u32) -> io::Result<Self> {
        let stream = serialport::new(port, baud).timeout(WRITE_TIME).open()?;
        Ok(Self::over(Port(stream)))
    }
}

impl<S: Read + Write> SerialLink<S> {
    /// Frames over a stream.
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
