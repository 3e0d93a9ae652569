//! The service thread: exchanges forces and states with the Inverse service, and reconnects after a loss.

use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use glam::{DQuat, DVec3};
use tungstenite::protocol::WebSocketConfig;
use tungstenite::{Error, Message, WebSocket};

use super::message::{Held, State, force};
use super::{Incoming, Link, Outgoing};
use crate::remote::bounded::Bounded;
use crate::remote::timeout::is_timeout;

/// The connection; each answer has a deadline.
type Socket = WebSocket<Bounded>;

/// Interval between two messages (chosen: 1 kHz; the service keeps pace with its client).
const PERIOD: Duration = Duration::from_millis(1);
/// Timeout of a whole answer, however it drips (chosen: the zero force that follows is sent within 50 ms of the last force).
const ANSWER_TIMEOUT: Duration = Duration::from_millis(30);
/// Timeout of one read within it (chosen: a small part of it).
const READ_TIMEOUT: Duration = Duration::from_millis(2);
/// Interval between two connection attempts (chosen: short for a person, and cheap without a service).
const RECONNECT: Duration = Duration::from_millis(300);
/// Polling interval for the end of the thread meanwhile (chosen: imperceptible).
const POLL: Duration = Duration::from_millis(10);
/// Timeout of connecting (chosen: the service is on this machine or near).
const CONNECT_TIMEOUT: Duration = Duration::from_millis(500);
/// Watchdog: age of a command after which its force is zero (chosen: the watchdog time of a contact model).
const STALE: Duration = Duration::from_millis(50);
/// Longest answer [bytes] (chosen: the full state of ten devices).
const LONGEST: usize = 64 << 10;
/// Button of the grip that sets the level.
const LEVEL_BUTTON: u32 = 0b10;

/// The connection to the service.
pub struct Service {
    address: SocketAddr,
    input: triple_buffer::Input<Incoming>,
    outgoing: triple_buffer::Output<Outgoing>,
    end: Arc<AtomicBool>,
    incoming: Incoming,
    level: Option<DQuat>,
    /// Number and time of the last command.
    commanded: (u64, Instant),
}

/// Reads a message; it must be whole at the deadline of the stream.
fn answer(socket: &mut Socket) -> Result<Message, Error> {
    loop {
        match socket.read() {
            Err(Error::Io(e)) if is_timeout(&e) && !socket.get_ref().is_late() => {}
            result => return result,
        }
    }
}

/// The connection is lost or silent.
struct Disconnected;

impl From<Error> for Disconnected {
    fn from(_: Error) -> Self {
        Self
    }
}

impl From<std::io::Error> for Disconnected {
    fn from(_: std::io::Error) -> Self {
        Self
    }
}

impl Service {
    /// Creates a thread's state without a connection.
    pub fn new(
        address: SocketAddr,
        input: triple_buffer::Input<Incoming>,
        outgoing: triple_buffer::Output<Outgoing>,
        end: Arc<AtomicBool>,
    ) -> Self {
        let commanded = (0, Instant::now());
        Self { address, input, outgoing, end, incoming: Incoming::default(), level: None, commanded }
    }

    /// Exchanges messages and reconnects, until the device is closed.
    pub fn run(mut self) {
        while !self.is_over() {
            // The remedy for every error is a new connection.
            let _ = self.session();
            self.publish(|incoming| (incoming.link, incoming.buttons) = (Link::Away, 0));
            let again = Instant::now() + RECONNECT;
            while !self.is_over() && Instant::now() < again {
                std::thread::sleep(POLL);
            }
        }
    }

    fn is_over(&self) -> bool {
        self.end.load(Ordering::Acquire)
    }

    fn publish(&mut self, change: impl FnOnce(&mut Incoming)) {
        change(&mut self.incoming);
        self.input.write(self.incoming);
    }

    fn session(&mut self) -> Result<(), Disconnected> {
        let mut socket = self.connect()?;
        let id = self.first_device(&mut socket)?;
        let ended = self.exchange(&mut socket, &id);
        // The last force must not persist, however the session ended; the answer confirms the zero force.
        socket.get_mut().allow(ANSWER_TIMEOUT);
        let _ = socket.send(Message::text(force(&id, DVec3::ZERO, false)));
        let _ = answer(&mut socket);
        let _ = socket.close(None);
        ended
    }

    fn connect(&self) -> Result<Socket, Disconnected> {
        let stream = TcpStream::connect_timeout(&self.address, CONNECT_TIMEOUT)?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(CONNECT_TIMEOUT))?;
        stream.set_write_timeout(Some(ANSWER_TIMEOUT))?;
        let reader = stream.try_clone()?;
        let config = WebSocketConfig::default().max_message_size(Some(LONGEST)).max_frame_size(Some(LONGEST));
        let url = format!("ws://{}/", self.address);
        let stream = Bounded::new(stream, Instant::now() + CONNECT_TIMEOUT);
        let greeted = tungstenite::client::client_with_config(url, stream, Some(config));
        let (mut socket, _) = greeted.map_err(|_| Disconnected)?;
        // From now on short reads, until an answer is whole or late.
        reader.set_read_timeout(Some(READ_TIMEOUT))?;
        socket.get_mut().allow(CONNECT_TIMEOUT);
        Ok(socket)
    }

    /// Sends forces and receives answers until the device is closed.
    fn exchange(&mut self, socket: &mut Socket, id: &str) -> Result<(), Disconnected> {
        self.level = None;
        let mut is_first = true;
        let mut due = Instant::now();
        while !self.is_over() {
            let command = self.command();
            socket.get_mut().allow(ANSWER_TIMEOUT);
            socket.send(Message::text(force(id, command, is_first)))?;
            is_first = false;
            self.receive(socket, id)?;
            due = (due + PERIOD).max(Instant::now());
            std::thread::sleep(due.saturating_duration_since(Instant::now()).min(PERIOD));
        }
        Ok(())
    }

    /// Returns the first device of the inventory that the service sends at first.
    fn first_device(&mut self, socket: &mut Socket) -> Result<String, Disconnected> {
        let state = self.read(socket)?.ok_or(Disconnected)?;
        state.inverse3.into_iter().next().map(|d| d.device_id).ok_or(Disconnected)
    }

    /// Reads the next answer; an invalid one is counted and gives `None`.
    fn read(&mut self, socket: &mut Socket) -> Result<Option<State>, Disconnected> {
        let message = match answer(socket) {
            Ok(Message::Text(text)) => State::parse(&text).ok(),
            Ok(Message::Close(_)) => return Err(Disconnected),
            Ok(_) => None,
            Err(e) => {
                if matches!(e, Error::Capacity(_) | Error::Protocol(_) | Error::Utf8(_)) {
                    self.publish(|incoming| incoming.rejected = incoming.rejected.wrapping_add(1));
                }
                return Err(Disconnected);
            }
        };
        if message.is_none() {
            self.publish(|incoming| incoming.rejected = incoming.rejected.wrapping_add(1));
        }
        Ok(message)
    }

    /// Reads one answer and publishes the state of the device.
    fn receive(&mut self, socket: &mut Socket, id: &str) -> Result<(), Disconnected> {
        let Some(state) = self.read(socket)? else { return Ok(()) };
        let device = state.inverse3.iter().find(|d| d.device_id == id).ok_or(Disconnected)?;
        let Some(cursor) = device.state else { return Ok(()) };
        let grip = state.grip();
        let rotation = self.rotation(grip);
        let ready = device.status.calibrated.unwrap_or(true);
        self.publish(|incoming| {
            incoming.number += 1;
            incoming.place = cursor.cursor_position.vector();
            incoming.velocity = cursor.cursor_velocity.vector();
            incoming.force = cursor.current_cursor_force.vector();
            incoming.rotation = rotation;
            incoming.buttons = grip.map_or(0, |g| g.buttons.bits());
            incoming.link = if ready { Link::Up } else { Link::Uncalibrated };
        });
        Ok(())
    }

    /// Returns the grip's rotation from level; level is its first orientation, or that at the last press of its button.
    fn rotation(&mut self, grip: Option<Held>) -> DQuat {
        let Some((grip, turn)) = grip.and_then(|g| Some((g, g.orientation.turn()?))) else { return DQuat::IDENTITY };
        if grip.buttons.bits() & LEVEL_BUTTON != 0 {
            self.level = None;
        }
        let level = *self.level.get_or_insert(turn);
        (turn * level.conjugate()).normalize()
    }

    /// Returns the commanded force [N]; zero if the command is stale.
    fn command(&mut self) -> DVec3 {
        let outgoing = *self.outgoing.read();
        if outgoing.number != self.commanded.0 {
            self.commanded = (outgoing.number, Instant::now());
        }
        if self.commanded.1.elapsed() < STALE && outgoing.force.is_finite() { outgoing.force } else { DVec3::ZERO }
    }
}
