//! What comes by OSC: where pan and turner are, buttons, and the pairing code.

use glam::{DQuat, DVec3};
use rosc::{OscMessage, OscPacket, OscType};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;

/// Longest datagram [bytes] (chosen: a bundle of ten poses; also bounds how deep bundles can lie in each other).
pub const LONGEST: usize = 1024;
/// Most messages of one datagram (chosen: as many as fit).
const MOST: usize = 64;
/// Farthest place from the ring's centre [m] (chosen: nobody's arms are longer).
const FARTHEST_M: f64 = 2.0;
/// Steepest tilt that is told as angles [°].
const STEEPEST_DEG: f64 = 180.0;

/// One order.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// `/saute/pair`: the code that the screen shows.
    Pair(String),
    /// `/saute/pan/pose`: where the pan is in the kitchen.
    Pan(Pose),
    /// `/saute/pan/tilt`: how the pan is turned; its place stays at home.
    Tilt(DQuat),
    /// `/saute/turner/pose`: where the turner's blade is in the kitchen.
    Turner(Pose),
    /// `/saute/button`: which one, and whether it is down.
    Button(u32, bool),
}

/// A datagram or message that means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadOsc {
    /// No OSC.
    #[error("is no OSC")]
    Format,
    /// Too much at once.
    #[error("has too many messages")]
    Many,
    /// An unknown address, or arguments that do not belong to it.
    #[error("has an unknown address or wrong arguments")]
    Meaning,
    /// A number out of range.
    #[error("has a number out of range")]
    Range,
}

/// All messages of a datagram, bundles opened, each an order or counted as bad.
pub fn read(datagram: &[u8]) -> Result<Vec<Result<Order, BadOsc>>, BadOsc> {
    if datagram.len() > LONGEST {
        return Err(BadOsc::Many);
    }
    let (_, packet) = rosc::decoder::decode_udp(datagram).map_err(|_| BadOsc::Format)?;
    let mut waiting = vec![packet];
    let mut orders = Vec::new();
    while let Some(packet) = waiting.pop() {
        match packet {
            OscPacket::Message(message) => orders.push(order(&message)),
            // Time tags are not waited for: a pan is where it is now.
            OscPacket::Bundle(bundle) => waiting.extend(bundle.content.into_iter().rev()),
        }
        if orders.len() > MOST {
            return Err(BadOsc::Many);
        }
    }
    Ok(orders)
}

fn order(message: &OscMessage) -> Result<Order, BadOsc> {
    match message.addr.as_str() {
        "/saute/pair" => code(&message.args).map(Order::Pair),
        "/saute/pan/pose" => pose(&message.args).map(Order::Pan),
        "/saute/turner/pose" => pose(&message.args).map(Order::Turner),
        "/saute/pan/tilt" => tilt(&message.args).map(Order::Tilt),
        "/saute/button" => button(&message.args),
        _ => Err(BadOsc::Meaning),
    }
}

/// The code as text, or as a number, whose leading zeros are lost.
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
    if numbers.iter().all(|v| v.is_finite()) { Ok(numbers) } else { Err(BadOsc::Range) }
}

/// x, y, z [m] and a quaternion x, y, z, w.
fn pose(args: &[OscType]) -> Result<Pose, BadOsc> {
    let [x, y, z, qx, qy, qz, qw] = numbers(args)?;
    let (position, rotation) = (DVec3::new(x, y, z), DQuat::from_xyzw(qx, qy, qz, qw));
    let fits = position.length() <= FARTHEST_M && (0.5..2.0).contains(&rotation.length());
    if fits { Ok(Pose { position, rotation: rotation.normalize() }) } else { Err(BadOsc::Range) }
}

/// Turns about the axis to the right and about the axis away from the cook [°].
fn tilt(args: &[OscType]) -> Result<DQuat, BadOsc> {
    let [right, away] = numbers(args)?;
    if right.abs().max(away.abs()) > STEEPEST_DEG {
        return Err(BadOsc::Range);
    }
    Ok(about(DVec3::new(right.to_radians(), away.to_radians(), 0.0)))
}

fn button(args: &[OscType]) -> Result<Order, BadOsc> {
    let (number, down) = match args {
        [OscType::Int(number), OscType::Bool(down)] => (*number, *down),
        [OscType::Int(number), value] => (*number, numbers::<1>(std::slice::from_ref(value))?[0] > 0.5),
        _ => return Err(BadOsc::Meaning),
    };
    if (0..32).contains(&number) { Ok(Order::Button(number as u32, down)) } else { Err(BadOsc::Range) }
}
