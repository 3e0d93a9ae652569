//! The thread that talks to the service, and looks for it again when it is gone.

use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use glam::{DQuat, DVec3};
use tungstenite::protocol::WebSocketConfig;
use tungstenite::{Error, Message, WebSocket};

use super::message::{Held, State, force};
use super::{Heard, Link, Told};

/// Time between two messages (chosen: a thousand a second; the service keeps pace with its client).
const PERIOD: Duration = Duration::from_millis(1);
/// How long the service may take to answer (chosen: fifty answers).
const PATIENCE: Duration = Duration::from_millis(50);
/// Time between two looks for the service (chosen: nobody waits long, and a machine without one is not kept busy).
const AGAIN: Duration = Duration::from_millis(300);
/// Time between two looks whether the device is gone, meanwhile (chosen: nobody notices).
const LOOK: Duration = Duration::from_millis(10);
/// How long connecting may take (chosen: it is on this machine, or near).
const CONNECT: Duration = Duration::from_millis(500);
/// Age of an order after which it makes no force any more (chosen: as old as a contact model may become).
const STALE: Duration = Duration::from_millis(50);
/// Longest answer [bytes] (chosen: ten devices with all they say).
const LONGEST: usize = 64 << 10;
/// Button of the grip that says: this is level.
const LEVEL_BUTTON: u32 = 0b10;

/// The talk with the service.
pub struct Service {
    address: SocketAddr,
    input: triple_buffer::Input<Heard>,
    told: triple_buffer::Output<Told>,
    end: Arc<AtomicBool>,
    heard: Heard,
    level: Option<DQuat>,
    ordered: (u64, Instant),
}

/// The service is gone, or says nothing.
struct Gone;

impl From<Error> for Gone {
    fn from(_: Error) -> Self {
        Self
    }
}

impl From<std::io::Error> for Gone {
    fn from(_: std::io::Error) -> Self {
        Self
    }
}

impl Service {
    /// Nothing is connected yet.
    pub fn new(
        address: SocketAddr,
        input: triple_buffer::Input<Heard>,
        told: triple_buffer::Output<Told>,
        end: Arc<AtomicBool>,
    ) -> Self {
        let ordered = (0, Instant::now());
        Self { address, input, told, end, heard: Heard::default(), level: None, ordered }
    }

    /// Talks, and looks for the service again, until the device is gone.
    pub fn run(mut self) {
        while !self.is_over() {
            // Whatever went wrong, the remedy is the same: try again.
            let _ = self.talk();
            self.publish(|heard| (heard.link, heard.buttons) = (Link::Away, 0));
            let again = Instant::now() + AGAIN;
            while !self.is_over() && Instant::now() < again {
                std::thread::sleep(LOOK);
            }
        }
    }

    fn is_over(&self) -> bool {
        self.end.load(Ordering::Acquire)
    }

    fn publish(&mut self, change: impl FnOnce(&mut Heard)) {
        change(&mut self.heard);
        self.input.write(self.heard);
    }

    fn talk(&mut self) -> Result<(), Gone> {
        let mut socket = self.connect()?;
        let id = self.first_device(&mut socket)?;
        socket.get_ref().set_read_timeout(Some(PATIENCE))?;
        let ended = self.lead(&mut socket, &id);
        // However it ended, the last force must not stay; the answer says that this has arrived. A service that is gone hears nothing.
        let _ = socket.send(Message::text(force(&id, DVec3::ZERO, false)));
        let _ = socket.read();
        let _ = socket.close(None);
        ended
    }

    fn connect(&self) -> Result<WebSocket<TcpStream>, Gone> {
        let stream = TcpStream::connect_timeout(&self.address, CONNECT)?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(CONNECT))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        let config = WebSocketConfig::default().max_message_size(Some(LONGEST)).max_frame_size(Some(LONGEST));
        let url = format!("ws://{}/", self.address);
        tungstenite::client::client_with_config(url, stream, Some(config)).map(|(socket, _)| socket).map_err(|_| Gone)
    }

    /// Orders forces and takes answers until the device is gone.
    fn lead(&mut self, socket: &mut WebSocket<TcpStream>, id: &str) -> Result<(), Gone> {
        self.level = None;
        let mut is_first = true;
        let mut due = Instant::now();
        while !self.is_over() {
            let order = self.order();
            socket.send(Message::text(force(id, order, is_first)))?;
            is_first = false;
            self.answer(socket, id)?;
            due = (due + PERIOD).max(Instant::now());
            std::thread::sleep(due.saturating_duration_since(Instant::now()).min(PERIOD));
        }
        Ok(())
    }

    /// The first device of the inventory with which the service begins.
    fn first_device(&mut self, socket: &mut WebSocket<TcpStream>) -> Result<String, Gone> {
        let state = self.read(socket)?.ok_or(Gone)?;
        state.inverse3.into_iter().next().map(|d| d.device_id).ok_or(Gone)
    }

    /// The next answer; none where it means nothing, which is counted.
    fn read(&mut self, socket: &mut WebSocket<TcpStream>) -> Result<Option<State>, Gone> {
        let message = match socket.read() {
            Ok(Message::Text(text)) => State::parse(&text).ok(),
            Ok(Message::Close(_)) => return Err(Gone),
            Ok(_) => None,
            Err(e) => {
                if matches!(e, Error::Capacity(_) | Error::Protocol(_) | Error::Utf8(_)) {
                    self.publish(|heard| heard.rejected = heard.rejected.wrapping_add(1));
                }
                return Err(Gone);
            }
        };
        if message.is_none() {
            self.publish(|heard| heard.rejected = heard.rejected.wrapping_add(1));
        }
        Ok(message)
    }

    /// Takes one answer and publishes what it says about the device.
    fn answer(&mut self, socket: &mut WebSocket<TcpStream>, id: &str) -> Result<(), Gone> {
        let Some(state) = self.read(socket)? else { return Ok(()) };
        let device = state.inverse3.iter().find(|d| d.device_id == id).ok_or(Gone)?;
        let Some(cursor) = device.state else { return Ok(()) };
        let grip = state.grip();
        let rotation = self.rotation(grip);
        let ready = device.status.calibrated.unwrap_or(true);
        self.publish(|heard| {
            heard.number += 1;
            heard.place = cursor.cursor_position.vector();
            heard.velocity = cursor.cursor_velocity.vector();
            heard.force = cursor.current_cursor_force.vector();
            heard.rotation = rotation;
            heard.buttons = grip.map_or(0, |g| g.buttons.bits());
            heard.link = if ready { Link::Up } else { Link::Uncalibrated };
        });
        Ok(())
    }

    /// How the grip is turned from level; level is how it was held first, or when its button was pressed.
    fn rotation(&mut self, grip: Option<Held>) -> DQuat {
        let Some((grip, turn)) = grip.and_then(|g| Some((g, g.orientation.turn()?))) else { return DQuat::IDENTITY };
        if grip.buttons.bits() & LEVEL_BUTTON != 0 {
            self.level = None;
        }
        let level = *self.level.get_or_insert(turn);
        (turn * level.conjugate()).normalize()
    }

    /// The force that is ordered; none where the order is old.
    fn order(&mut self) -> DVec3 {
        let told = *self.told.read();
        if told.number != self.ordered.0 {
            self.ordered = (told.number, Instant::now());
        }
        if self.ordered.1.elapsed() < STALE && told.force.is_finite() { told.force } else { DVec3::ZERO }
    }
}
