//! Messages of devices.

use std::collections::VecDeque;
use std::io;
use std::net::SocketAddr;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use saute_haptics::remote::haply::message::{State, force};
use saute_haptics::remote::osc::message::{Event, read};
use saute_haptics::remote::phone::http;
use saute_haptics::remote::phone::message::{FromPhone, ToPhone};
use saute_haptics::remote::phone::orientation::{Level, acceleration, from_angles};
use saute_haptics::strings::wire::{Deframer, FRAME, Frame, FrameError, Link, Message, VERSION, stuff};
use saute_haptics::{Geometry, HapticCommand, HapticDevice, Rumble, Spidar, library};
use saute_spidar_sim::{Device, Making};

use crate::text;

/// Length of kind and payload of a message [bytes].
const SPOKEN: usize = 1 + 64;
/// Messages that a hostile device sends in one input [-].
const MOST_SPOKEN: usize = 8;
/// Rounds in which a driver has sent all its stops [-], and their length [s] (chosen: more and longer than the driver's own).
const STOPS: usize = 4;
const BETWEEN_STOPS_S: f64 = 5e-3;

static DEVICE: LazyLock<Geometry> = LazyLock::new(|| {
    let mut devices = library::devices().expect("the shipped devices are sound");
    devices.remove(library::DEFAULT_DEVICE).expect("is there")
});

/// A device that reports the samples in the input, in the session of the host.
struct Hostile {
    says: VecDeque<(u8, [u8; 64])>,
    session: u32,
    sequence: u32,
}

impl Link for Hostile {
    fn send(&mut self, frame: &Frame) -> io::Result<()> {
        assert_eq!(Frame::decode(&frame.encode()).map(|f| f.message.encode()), Ok(frame.message.encode()));
        self.session = frame.session;
        Ok(())
    }

    fn receive(&mut self) -> Option<Result<Frame, FrameError>> {
        let (kind, payload) = self.says.pop_front()?;
        self.sequence += 1;
        Some(Frame::decode(&framed(kind, self.sequence, self.session, &payload)))
    }
}

/// Returns a frame with a right checksum, which an input would hardly have.
fn framed(kind: u8, sequence: u32, session: u32, payload: &[u8; 64]) -> [u8; FRAME] {
    let mut bytes = [0; FRAME];
    bytes[..4].copy_from_slice(&[b'S', b'P', VERSION, kind]);
    bytes[4..8].copy_from_slice(&sequence.to_le_bytes());
    bytes[8..12].copy_from_slice(&session.to_le_bytes());
    bytes[12..76].copy_from_slice(payload);
    let check = crc32fast::hash(&bytes[..76]);
    bytes[76..].copy_from_slice(&check.to_le_bytes());
    bytes
}

/// Bytes of a SPIDAR's link: as a stream, as a datagram, and as what a device and a host send in valid frames.
pub fn wire(bytes: &[u8]) {
    let _ = Frame::decode(bytes);
    let mut deframer = Deframer::default();
    for frame in bytes.iter().filter_map(|byte| deframer.push(*byte)) {
        let _ = Frame::decode(&frame);
        assert_eq!(stuff(&frame).iter().filter(|byte| **byte == 0).count(), 1);
    }
    let said: Vec<(u8, [u8; 64])> = bytes
        .chunks_exact(SPOKEN)
        .take(MOST_SPOKEN)
        .filter_map(|chunk| Some((chunk[0], chunk[1..].try_into().ok()?)))
        .collect();
    hostile_host(bytes, &said);
    hostile_device(said);
}

/// The simulated device receives what a hostile host sends.
fn hostile_host(bytes: &[u8], said: &[(u8, [u8; 64])]) {
    let mut now = Instant::now();
    let making = Making { seed: 3, error_m: 0.5e-3, hand: 1.0, noise: 1.0 };
    let mut device = Device::named(library::DEFAULT_DEVICE, &making, 0, now).expect("a shipped device");
    let from = SocketAddr::from(([127, 0, 0, 1], 9));
    device.receive(bytes, from, now);
    for (sequence, (kind, payload)) in (1..).zip(said) {
        device.receive(&framed(*kind, sequence, 7, payload), from, now);
        now += Duration::from_millis(1);
        device.advance(now);
    }
    let tensions = device.tensions();
    assert!(tensions.iter().all(|t| t.is_finite()), "{tensions:?}");
}

/// The driver receives what a hostile device sends.
fn hostile_device(said: Vec<(u8, [u8; 64])>) {
    let known = said.iter().filter_map(|(kind, payload)| Message::decode(*kind, payload).ok());
    let most_rounds = known.count() + 2;
    let link = Hostile { says: said.into(), session: 0, sequence: 0 };
    let mut driver = Spidar::new(link, DEVICE.clone(), 0);
    for _ in 0..most_rounds {
        let sample = driver.exchange(&HapticCommand::default(), 1e-3);
        assert!(sample.pose.position.is_finite() && sample.total_force_n.is_finite(), "{sample:?}");
    }
    // What is still due is sent by the driver's clock: at its end it would wait for a real one.
    driver.stop();
    for _ in 0..STOPS {
        driver.exchange(&HapticCommand::default(), BETWEEN_STOPS_S);
    }
}

/// What a phone sends: the head of a request, or a message.
pub fn phone(bytes: &[u8]) {
    let mut stream = bytes;
    let deadline = Instant::now() + Duration::from_secs(1);
    let head = http::read_head(&mut stream, deadline);
    let answer = http::response(&http::parse(head.as_deref().unwrap_or(bytes)));
    assert!(answer.starts_with("HTTP/1.1 "), "{answer}");
    let Some(text) = text(bytes) else { return };
    let Ok(FromPhone::Motion(measured)) = FromPhone::parse(text) else { return };
    let phone = from_angles(measured.turn);
    let mut level = Level::default();
    level.set(phone);
    let rotation = level.pan(phone);
    assert!(rotation.is_finite() && acceleration(&measured, phone).is_none_or(|a| a.is_finite()));
    let pose = saute_haptics::Pose { position: glam::DVec3::ZERO, rotation };
    assert!(level.direction(phone, glam::DVec3::X).is_finite());
    assert!(!ToPhone::pan(&pose, &Rumble::default()).json().is_empty());
}

/// A datagram of OSC.
pub fn osc(bytes: &[u8]) {
    for event in read(bytes).into_iter().flatten().flatten() {
        if let Event::Pan(pose) | Event::Turner(pose) = event {
            assert!(pose.position.is_finite() && pose.rotation.is_finite(), "{pose:?}");
        }
    }
}

/// An answer of Haply's service.
pub fn haply(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Ok(state) = State::parse(text) else { return };
    if let Some(grip) = state.grip() {
        assert!(grip.orientation.turn().is_some_and(|turn| turn.is_finite()));
        assert!(grip.buttons.bits() < 8);
    }
    for device in &state.inverse3 {
        let place = device.state.map(|cursor| cursor.cursor_position.vector());
        assert!(place.is_none_or(|place| place.is_finite()));
        assert!(!force(&device.device_id, glam::DVec3::X, true).is_empty());
    }
}
