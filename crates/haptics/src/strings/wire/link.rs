//! A way for frames to travel.

use std::io;
use std::net::{SocketAddr, UdpSocket};

use super::frame::{FRAME, Frame, FrameError};

/// Sends and receives frames without waiting.
pub trait Link: Send {
    /// Sends a frame.
    fn send(&mut self, frame: &Frame) -> io::Result<()>;
    /// A frame that has come, damaged ones as errors; none where nothing has.
    fn receive(&mut self) -> Option<Result<Frame, FrameError>>;
}

/// Frames as datagrams.
#[derive(Debug)]
pub struct UdpLink {
    socket: UdpSocket,
}

impl UdpLink {
    /// Speaks to a device at an address; only what comes from there is heard.
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
        // One byte more than a frame, so that longer datagrams are seen to be too long.
        let mut bytes = [0; FRAME + 1];
        let count = self.socket.recv(&mut bytes).ok()?;
        Some(Frame::decode(&bytes[..count]))
    }
}
