//! OSC messages: poses of pan and turner, buttons, and the pairing code.

use glam::{DQuat, DVec3};
use rosc::{OscMessage, OscPacket, OscType};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;

/// Longest datagram [bytes] (chosen: a bundle of ten poses; it also bounds the nesting depth of bundles).
pub const LONGEST: usize = 1024;
/// Maximum number of messages per datagram (chosen: as many as fit).
const MOST: usize = 64;
/// Largest distance from the ring's centre [m] (chosen: no arm is longer).
pub const FARTHEST_M: f64 = 2.0;
/// Largest tilt angle [°].
pub const STEEPEST_DEG: f64 = 180.0;
/// Longest part of an unknown address that is repeated (chosen: enough to find a typing error).
const LONGEST_ECHO: usize = 40;

/// Addresses.
const PAIR: &str = "/saute/pair";
const PAN: &str = "/saute/pan/pose";
const TILT: &str = "/saute/pan/tilt";
const TURNER: &str = "/saute/turner/pose";
const BUTTON: &str = "/saute/button";
/// Address of the answer to a rejected message.
pub const REJECTED: &str = "/saute/rejected";

/// A parsed message.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// `/saute/pair`: the code on the screen.
    Pair(String),
    /// `/saute/pan/pose`: pose of the pan in the kitchen.
    Pan(Pose),
    /// `/saute/pan/tilt`: rotation of the pan; its position stays at home.
    Tilt(DQuat),
    /// `/saute/turner/pose`: pose of the turner's blade in the kitchen.
    Turner(Pose),
    /// `/saute/button`: number of the button, and true if it is pressed.
    Button(u32, bool),
}

/// Why a datagram or message is invalid, and what to send instead.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadOsc {
    /// The datagram is not OSC.
    #[error("is no OSC message or bundle: send OSC 1.0 over UDP")]
    Format,
    /// The datagram is too long.
    #[error("has more than {LONGEST} bytes: send smaller bundles")]
    Long,
    /// The datagram has too many messages.
    #[error("has more than {MOST} messages: send smaller bundles")]
    Many,
    /// The address is unknown.
    #[error("{0} is no address of saute: write /saute/pair, {PAN}, {TILT}, {TURNER} or {BUTTON}")]
    Address(String),
    /// The arguments do not match the address.
    #[error("{0} has other arguments than {1}")]
    Arguments(&'static str, &'static str),
    /// A number is NaN or infinite.
    #[error("{0} has a number that is not finite: send {send}, and nothing while there is no measurement", send = allowed(.0))]
    NotFinite(&'static str),
    /// A number is out of range.
    #[error("{0} has a number out of range: send {1}")]
    Range(&'static str, &'static str),
}

/// What the numbers of an address may be.
fn allowed(address: &str) -> &'static str {
    match address {
        PAN | TURNER => "the distance from the ring's centre as 0 to 2 m, and the length of the quaternion as 0.5 to 2",
        TILT => "the tilt as -180 to 180 degrees",
        _ => "a finite one",
    }
}

/// Returns all messages of a datagram with bundles opened, each one parsed or an error.
pub fn read(datagram: &[u8]) -> Result<Vec<Result<Event, BadOsc>>, BadOsc> {
    if datagram.len() > LONGEST {
        return Err(BadOsc::Long);
    }
    let (_, packet) = rosc::decoder::decode_udp(datagram).map_err(|_| BadOsc::Format)?;
    let mut waiting = vec![packet];
    let mut events = Vec::new();
    while let Some(packet) = waiting.pop() {
        match packet {
            OscPacket::Message(message) => events.push(event(&message)),
            // Time tags are ignored: a pose is valid on arrival.
            OscPacket::Bundle(bundle) => waiting.extend(bundle.content.into_iter().rev()),
        }
        if events.len() > MOST {
            return Err(BadOsc::Many);
        }
    }
    Ok(events)
}

fn event(message: &OscMessage) -> Result<Event, BadOsc> {
    let args = &message.args;
    // Some programs end every address with a slash.
    match message.addr.strip_suffix('/').unwrap_or(&message.addr) {
        PAIR => code(args).map(Event::Pair),
        PAN => pose(args, PAN).map(Event::Pan),
        TURNER => pose(args, TURNER).map(Event::Turner),
        TILT => tilt(args).map(Event::Tilt),
        BUTTON => button(args),
        address => Err(BadOsc::Address(echo(address))),
    }
}

/// Returns the beginning of an address, without what could disturb a terminal.
fn echo(address: &str) -> String {
    address.chars().map(|c| if c.is_control() { '?' } else { c }).take(LONGEST_ECHO).collect()
}

/// Returns a number of any type; none for other arguments.
fn number(arg: &OscType) -> Option<f64> {
    match arg {
        OscType::Float(v) => Some(f64::from(*v)),
        OscType::Double(v) => Some(*v),
        OscType::Int(v) => Some(f64::from(*v)),
        OscType::Long(v) => Some(*v as f64),
        _ => None,
    }
}

/// Returns a whole number below `end`, of any type: some programs send floats only.
fn whole(arg: &OscType, end: u32, address: &'static str, expected: &'static str) -> Result<u32, BadOsc> {
    let value = number(arg).ok_or(BadOsc::Arguments(address, expected))?;
    if !value.is_finite() {
        return Err(BadOsc::NotFinite(address));
    }
    let fits = value.fract() == 0.0 && (0.0..f64::from(end)).contains(&value);
    if fits { Ok(value as u32) } else { Err(BadOsc::Range(address, expected)) }
}

/// Parses a code as text, or as a number without its leading zeros.
fn code(args: &[OscType]) -> Result<String, BadOsc> {
    const EXPECTED: &str = "the six digits of the code, as text or as a whole number";
    match args {
        [OscType::String(code)] => Ok(code.clone()),
        [arg] => whole(arg, 1_000_000, PAIR, EXPECTED).map(|number| format!("{number:06}")),
        _ => Err(BadOsc::Arguments(PAIR, EXPECTED)),
    }
}

fn numbers<const N: usize>(
    args: &[OscType],
    address: &'static str,
    expected: &'static str,
) -> Result<[f64; N], BadOsc> {
    let wrong = BadOsc::Arguments(address, expected);
    if args.len() != N {
        return Err(wrong);
    }
    let mut numbers = [0.0; N];
    for (into, arg) in numbers.iter_mut().zip(args) {
        *into = number(arg).ok_or_else(|| wrong.clone())?;
    }
    if numbers.iter().all(|v| v.is_finite()) { Ok(numbers) } else { Err(BadOsc::NotFinite(address)) }
}

/// Parses x, y, z [m] and a quaternion x, y, z, w [-].
fn pose(args: &[OscType], address: &'static str) -> Result<Pose, BadOsc> {
    let [x, y, z, qx, qy, qz, qw] = numbers(args, address, "seven numbers: x, y, z and a quaternion x, y, z, w")?;
    let (position, rotation) = (DVec3::new(x, y, z), DQuat::from_xyzw(qx, qy, qz, qw));
    let fits = position.length() <= FARTHEST_M && (0.5..2.0).contains(&rotation.length());
    let pose = Pose { position, rotation: rotation.normalize() };
    if fits { Ok(pose) } else { Err(BadOsc::Range(address, allowed(address))) }
}

/// Parses rotation angles about the axis to the right and about the axis away from the cook [°].
fn tilt(args: &[OscType]) -> Result<DQuat, BadOsc> {
    let [right, away] = numbers(args, TILT, "two angles in degrees")?;
    if right.abs().max(away.abs()) > STEEPEST_DEG {
        return Err(BadOsc::Range(TILT, allowed(TILT)));
    }
    Ok(about(DVec3::new(right.to_radians(), away.to_radians(), 0.0)))
}

fn button(args: &[OscType]) -> Result<Event, BadOsc> {
    const EXPECTED: &str = "the number of a button from 0 to 31, and 1 or 0";
    let [which, down] = args else { return Err(BadOsc::Arguments(BUTTON, EXPECTED)) };
    let which = whole(which, 32, BUTTON, EXPECTED)?;
    let down = match down {
        OscType::Bool(down) => *down,
        value => numbers::<1>(std::slice::from_ref(value), BUTTON, EXPECTED)?[0] > 0.5,
    };
    Ok(Event::Button(which, down))
}
