//! Numbers of the streams by which phones, OSC senders and devices move the pan.

use glam::{DQuat, DVec3};
use saute_haptics::remote::osc::message::{FARTHEST_M, STEEPEST_DEG};
use saute_haptics::remote::phone::message::{LARGEST_DEG, LARGEST_M_S2};
use saute_haptics::{HapticSample, Pose};

use super::{Range, Streamed, StreamedNumber};

const fn either_side(most: f64) -> Range {
    Range::Within(-most, most)
}

const fn phone(name: &'static str, text: &'static str, named: &'static str, most: f64) -> StreamedNumber {
    StreamedNumber { name, message: Streamed::Phone(text), named, range: either_side(most) }
}

const fn device(name: &'static str, set: fn(f64, &mut HapticSample)) -> StreamedNumber {
    StreamedNumber { name, message: Streamed::Device(set), named: "", range: Range::Reach }
}

fn turned(v: f64) -> DQuat {
    DQuat::from_xyzw(v, 0.0, 0.0, 1.0)
}

/// All numbers that are streamed.
pub const STREAMED: &[StreamedNumber] = &[
    phone("phone: angles [°]", r#"{"kind":"motion","turn":[0,#,0]}"#, "turn", LARGEST_DEG),
    phone(
        "phone: acceleration without gravity [m/s²]",
        r#"{"kind":"motion","turn":[0,0,0],"push":[0,#,0]}"#,
        "push",
        LARGEST_M_S2,
    ),
    phone(
        "phone: acceleration with gravity [m/s²]",
        r#"{"kind":"motion","turn":[0,0,0],"felt":[0,0,#]}"#,
        "felt",
        LARGEST_M_S2,
    ),
    StreamedNumber {
        name: "OSC: place of the pan [m]",
        message: Streamed::Osc("/saute/pan/pose", |v| vec![v, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
        named: "the distance from the ring's centre",
        range: either_side(FARTHEST_M),
    },
    StreamedNumber {
        name: "OSC: place of the turner [m]",
        message: Streamed::Osc("/saute/turner/pose", |v| vec![0.0, v, 0.0, 0.0, 0.0, 0.0, 1.0]),
        named: "the distance from the ring's centre",
        range: either_side(FARTHEST_M),
    },
    StreamedNumber {
        name: "OSC: tilt [°]",
        message: Streamed::Osc("/saute/pan/tilt", |v| vec![v, 0.0]),
        named: "the tilt",
        range: either_side(STEEPEST_DEG),
    },
    device("device: place of the pan [m]", |v, sample| sample.pose.position.x = v),
    device("device: orientation of the pan [-]", |v, sample| sample.pose.rotation = turned(v)),
    device("device: place of the turner [m]", |v, sample| {
        sample.turner = Some(Pose { position: DVec3::splat(v), rotation: DQuat::IDENTITY });
    }),
    device("device: orientation of the turner [-]", |v, sample| {
        sample.turner = Some(Pose { position: DVec3::new(0.0, 0.0, 0.1), rotation: turned(v) });
    }),
    device("device: velocity [m/s]", |v, sample| sample.twist.linear = DVec3::splat(v)),
    device("device: force [N]", |v, sample| sample.total_force_n = v),
];
