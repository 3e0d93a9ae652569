//! A connection whose reads and writes end at a deadline, however slowly the other side drips.

use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// A stream that may be read from and written to until a deadline.
///
/// Time-outs of the socket alone do not bound a caller that reads on until a record or a message is whole: each byte begins
/// them anew.
#[derive(Debug)]
pub struct Bounded {
    stream: TcpStream,
    until: Instant,
}

impl Bounded {
    /// Until a deadline.
    pub fn new(stream: TcpStream, until: Instant) -> Self {
        Self { stream, until }
    }

    /// From now on for so long.
    pub fn allow(&mut self, time: Duration) {
        self.until = Instant::now() + time;
    }

    fn in_time(&self) -> io::Result<()> {
        if Instant::now() > self.until { Err(ErrorKind::TimedOut.into()) } else { Ok(()) }
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
