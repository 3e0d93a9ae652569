//! Links that transport frames.

use std::io;
use std::net::{SocketAddr, UdpSocket};

use super::frame::{FRAME, Frame, FrameError};

/// A link that sends and receives frames without blocking.
pub trait Link: Send {
    /// Sends a frame.
    fn send(&mut self, frame: &Frame) -> io::Result<()>;
    /// Returns a received frame, or an error for a damaged one; `None` if nothing was received.
    fn receive(&mut self) -> Option<Result<Frame, FrameError>>;
}

/// Frames as UDP datagrams.
#[derive(Debug)]
pub struct UdpLink {
    socket: UdpSocket,
}

impl UdpLink {
    /// Connects to a device's address; datagrams from elsewhere are ignored.
    pub fn connect(device: SocketAddr) -> io::Result<Self> {
        let any: SocketAddr = if device.is_ipv4() { ([0, 0, 0, 0], 0).into() } else { ([0u16; 8], 0).into() };
        let local = if device.ip().is_loopback() { SocketAddr::new(device.ip(), 0) } else { any };
        let socket = UdpSocket::bind(local)?;
        socket.connect(device)?;
        socket.set_nonblocking(true)?;
        Ok(Self { socket })
    }
}

impl Link for UdpLink {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        self.socket.send(&frame.encode()).map(|_| ())
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        // One byte more than a frame, so that longer datagrams are detected.
        let mut bytes = [0; FRAME + 1];
        let count = self.socket.recv(&mut bytes).ok()?;
        Some(Frame::decode(&bytes[..count]))
    }
}
