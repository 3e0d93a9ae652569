//! A connection whose reads and writes end at a deadline, even against a slow sender.

use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// A stream that can be read and written until a deadline.
///
/// Socket timeouts alone do not bound a caller that reads until a record or a message is complete, because each byte restarts
/// them.
#[derive(Debug)]
pub struct Bounded {
    stream: TcpStream,
    until: Instant,
}

impl Bounded {
    /// Creates a stream with a deadline.
    pub fn new(stream: TcpStream, until: Instant) -> Self {
        Self { stream, until }
    }

    /// Sets the deadline to `time` from now.
    pub fn allow(&mut self, time: Duration) {
        self.until = Instant::now() + time;
    }

    /// Returns true after the deadline.
    pub fn is_late(&self) -> bool {
        Instant::now() > self.until
    }

    fn in_time(&self) -> io::Result<()> {
        if self.is_late() { Err(ErrorKind::TimedOut.into()) } else { Ok(()) }
    }
}

impl Read for Bounded {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.in_time()?;
        self.stream.read(buffer)
    }
}

impl Write for Bounded {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.in_time()?;
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}
