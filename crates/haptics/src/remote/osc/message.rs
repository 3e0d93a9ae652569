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
/// Range of the length of a quaternion, which is made one [-] (chosen: anything else is no orientation).
const QUATERNION: [f64; 2] = [0.5, 2.0];
/// Largest number of a button [-].
const LAST_BUTTON: i32 = 31;

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

/// Why a datagram or message is invalid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BadOsc {
    /// The datagram is not OSC.
    #[error("is not OSC")]
    Format,
    /// The datagram is too long or has too many messages.
    #[error("has too many messages")]
    Many,
    /// The address is unknown, or the arguments do not match it.
    #[error("has an unknown address or wrong arguments")]
    Meaning,
    /// A number is out of range, or none.
    #[error("{key} may be {low} to {high}")]
    Range {
        /// What the number is.
        key: &'static str,
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
    },
}

/// Returns all messages of a datagram with bundles opened, each one parsed or an error.
pub fn read(datagram: &[u8]) -> Result<Vec<Result<Event, BadOsc>>, BadOsc> {
    if datagram.len() > LONGEST {
        return Err(BadOsc::Many);
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
    match message.addr.as_str() {
        "/saute/pair" => code(&message.args).map(Event::Pair),
        "/saute/pan/pose" => pose(&message.args).map(Event::Pan),
        "/saute/turner/pose" => pose(&message.args).map(Event::Turner),
        "/saute/pan/tilt" => tilt(&message.args).map(Event::Tilt),
        "/saute/button" => button(&message.args),
        _ => Err(BadOsc::Meaning),
    }
}

/// Parses a code as text, or as a number without its leading zeros.
fn code(args: &[OscType]) -> Result<String, BadOsc> {
    match args {
        [OscType::String(code)] => Ok(code.clone()),
        [OscType::Int(number)] if (0..1_000_000).contains(number) => Ok(format!("{number:06}")),
        _ => Err(BadOsc::Meaning),
    }
}

fn numbers<const N: usize>(args: &[OscType]) -> Result<[f64; N], BadOsc> {
    if args.len() != N {
        return Err(BadOsc::Meaning);
    }
    let mut numbers = [0.0; N];
    for (number, arg) in numbers.iter_mut().zip(args) {
        *number = match arg {
            OscType::Float(v) => f64::from(*v),
            OscType::Double(v) => *v,
            OscType::Int(v) => f64::from(*v),
            _ => return Err(BadOsc::Meaning),
        };
    }
    Ok(numbers)
}

/// Parses x, y, z [m] and a quaternion x, y, z, w [-].
fn pose(args: &[OscType]) -> Result<Pose, BadOsc> {
    let [x, y, z, qx, qy, qz, qw] = numbers(args)?;
    let (position, rotation) = (DVec3::new(x, y, z), DQuat::from_xyzw(qx, qy, qz, qw));
    ranged("the distance from the ring's centre [m]", position.length(), [0.0, FARTHEST_M])?;
    ranged("the length of the quaternion [-]", rotation.length(), QUATERNION)?;
    Ok(Pose { position, rotation: rotation.normalize() })
}

/// Parses rotation angles about the axis to the right and about the axis away from the cook [°].
fn tilt(args: &[OscType]) -> Result<DQuat, BadOsc> {
    let [right, away] = numbers(args)?;
    for angle in [right, away] {
        ranged("the tilt [°]", angle, [-STEEPEST_DEG, STEEPEST_DEG])?;
    }
    Ok(about(DVec3::new(right.to_radians(), away.to_radians(), 0.0)))
}

fn button(args: &[OscType]) -> Result<Event, BadOsc> {
    let (number, down) = match args {
        [OscType::Int(number), OscType::Bool(down)] => (*number, *down),
        [OscType::Int(number), value] => {
            let [value] = numbers(std::slice::from_ref(value))?;
            if !value.is_finite() {
                return Err(BadOsc::Meaning);
            }
            (*number, value > 0.5)
        }
        _ => return Err(BadOsc::Meaning),
    };
    ranged("the number of the button", number.into(), [0.0, LAST_BUTTON.into()])?;
    Ok(Event::Button(number as u32, down))
}

/// Refuses a number beyond its range, and one that is none.
fn ranged(key: &'static str, value: f64, [low, high]: [f64; 2]) -> Result<(), BadOsc> {
    if (low..=high).contains(&value) { Ok(()) } else { Err(BadOsc::Range { key, low, high }) }
}
