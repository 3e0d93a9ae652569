//! Messages between host and device, and their payloads.

use super::frame::VERSION;
use crate::strings::STRINGS;

/// Length of a payload [bytes].
pub const PAYLOAD: usize = 64;

/// A message of the protocol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Message {
    /// Host: requests a device.
    Hello(Hello),
    /// Host: the same in version 1, which only an older device answers.
    HelloOfVersion1(Hello),
    /// Device: states its capabilities.
    Caps(Caps),
    /// Host: requests the minimum tension.
    Arm,
    /// Host: commands tensions.
    Command(Command),
    /// Device: reports encoders, tensions and state.
    Sample(Sample),
    /// Host: releases all tensions.
    Stop,
    /// Device: refuses a request.
    Refused(Refused),
}

/// Payload of a hello.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hello {
    /// Pairing code that the device shows; 0 if it needs none.
    pub pairing: u32,
    /// Rate of the host's commands [Hz].
    pub rate_hz: u16,
}

/// Codes of a device's units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Units {
    /// Unit of counts: 1 is nanometres per count.
    pub length: u8,
    /// Unit of tensions: 1 is millinewtons.
    pub tension: u8,
    /// Unit of times: 1 is microseconds.
    pub time: u8,
}

impl Units {
    /// Units of this protocol version.
    pub const SPOKEN: Self = Self { length: 1, tension: 1, time: 1 };
}

/// Capabilities of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caps {
    /// Number of strings.
    pub strings: u8,
    /// Units.
    pub units: Units,
    /// String length per encoder count [nm].
    pub pitch_nm: u32,
    /// Minimum tension [mN].
    pub min_mn: u16,
    /// Maximum tension [mN].
    pub max_mn: u16,
    /// Maximum command rate [Hz].
    pub rate_hz: u16,
    /// Watchdog: time without a command after which the device falls back to the minimum tension [ms].
    pub watchdog_ms: u16,
    /// Boot number, which changes whenever the encoders have lost their count.
    pub boot: u32,
    /// ASCII name, padded with zeros.
    pub name: [u8; 16],
}

/// Payload of a command: tensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command {
    /// Host clock, wrapping [µs].
    pub time_us: u32,
    /// Tension of each string [mN].
    pub tension_mn: [u16; STRINGS],
}

/// State of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DeviceState {
    /// Waits for a hello, without motor current.
    #[default]
    Idle,
    /// Has answered a hello, without motor current.
    Greeted,
    /// Keeps the minimum tension.
    Armed,
    /// Follows commands.
    Running,
    /// Reports a fault, without motor current.
    Fault,
}

/// Fault of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FaultCode {
    /// No fault.
    #[default]
    None,
    /// A motor is overheated.
    MotorHot,
    /// An encoder jumps.
    Encoder,
    /// A string is slack or broken.
    Slack,
    /// The supply voltage is too low.
    Supply,
}

/// Payload of a sample: measured state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sample {
    /// State.
    pub state: DeviceState,
    /// Fault.
    pub fault: FaultCode,
    /// Jig place whose contact is closed, counted from 1; 0 for none.
    pub jig: u8,
    /// Buttons, one bit each.
    pub buttons: u8,
    /// Device clock, wrapping [µs].
    pub time_us: u32,
    /// Sequence number of the last executed command.
    pub obeyed: u32,
    /// Encoder counts.
    pub count: [i32; STRINGS],
    /// Tensions derived from the motor currents [mN].
    pub tension_mn: [u16; STRINGS],
}

/// Why a device refuses a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The pairing code is wrong.
    WrongCode,
    /// Another host is connected.
    Busy,
    /// The request is not allowed in the present state.
    OutOfOrder,
    /// The code was not looked at, so soon after a wrong one.
    TooManyTries,
    /// The hello was one of another protocol version.
    OtherVersion,
}

/// Payload of a refusal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused {
    /// Reason.
    pub reason: Refusal,
    /// Protocol version of the device.
    pub version: u8,
    /// Time after which another hello may succeed [ms].
    pub wait_ms: u16,
}

/// Why a payload is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PayloadError {
    /// The kind of message is unknown.
    #[error("there is no message of kind {0}")]
    Kind(u8),
    /// A field contains an unknown code.
    #[error("{field} has no code {code}")]
    Code {
        /// Name of the field.
        field: &'static str,
        /// The code.
        code: u8,
    },
}

/// Writes numbers sequentially.
struct Writer {
    bytes: [u8; PAYLOAD],
    at: usize,
}

impl Writer {
    fn put(&mut self, bytes: &[u8]) -> &mut Self {
        self.bytes[self.at..self.at + bytes.len()].copy_from_slice(bytes);
        self.at += bytes.len();
        self
    }
}

/// Reads numbers sequentially.
struct Reader<'a> {
    bytes: &'a [u8; PAYLOAD],
    at: usize,
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let mut taken = [0; N];
        taken.copy_from_slice(&self.bytes[self.at..self.at + N]);
        self.at += N;
        taken
    }

    fn u8(&mut self) -> u8 {
        self.take::<1>()[0]
    }

    fn u16(&mut self) -> u16 {
        u16::from_le_bytes(self.take())
    }

    fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.take())
    }

    fn tensions(&mut self) -> [u16; STRINGS] {
        std::array::from_fn(|_| self.u16())
    }
}

/// Returns the entry of a list at the index `code`.
fn coded<T: Copy>(field: &'static str, code: u8, list: &[T]) -> Result<T, PayloadError> {
    list.get(code as usize).copied().ok_or(PayloadError::Code { field, code })
}

const STATES: [DeviceState; 5] =
    [DeviceState::Idle, DeviceState::Greeted, DeviceState::Armed, DeviceState::Running, DeviceState::Fault];
const FAULTS: [FaultCode; 5] =
    [FaultCode::None, FaultCode::MotorHot, FaultCode::Encoder, FaultCode::Slack, FaultCode::Supply];
const REFUSALS: [Refusal; 5] =
    [Refusal::WrongCode, Refusal::Busy, Refusal::OutOfOrder, Refusal::TooManyTries, Refusal::OtherVersion];

impl Message {
    /// Returns the protocol version of the message [-].
    pub fn version(&self) -> u8 {
        if matches!(self, Self::HelloOfVersion1(_)) { 1 } else { VERSION }
    }

    /// Returns kind and payload.
    pub fn encode(&self) -> (u8, [u8; PAYLOAD]) {
        let mut w = Writer { bytes: [0; PAYLOAD], at: 0 };
        let kind = match self {
            Self::Hello(hello) | Self::HelloOfVersion1(hello) => {
                w.put(&hello.pairing.to_le_bytes()).put(&hello.rate_hz.to_le_bytes());
                1
            }
            Self::Caps(caps) => {
                caps.write(&mut w);
                2
            }
            Self::Arm => 3,
            Self::Command(command) => {
                w.put(&command.time_us.to_le_bytes());
                for tension in command.tension_mn {
                    w.put(&tension.to_le_bytes());
                }
                4
            }
            Self::Sample(sample) => {
                sample.write(&mut w);
                5
            }
            Self::Stop => 6,
            Self::Refused(refused) => {
                w.put(&[refused.reason as u8, refused.version]).put(&refused.wait_ms.to_le_bytes());
                7
            }
        };
        (kind, w.bytes)
    }

    /// Parses kind and payload.
    pub fn decode(kind: u8, payload: &[u8; PAYLOAD]) -> Result<Self, PayloadError> {
        let mut r = Reader { bytes: payload, at: 0 };
        Ok(match kind {
            1 => Self::Hello(Hello { pairing: r.u32(), rate_hz: r.u16() }),
            2 => Self::Caps(Caps::read(&mut r)),
            3 => Self::Arm,
            4 => Self::Command(Command { time_us: r.u32(), tension_mn: r.tensions() }),
            5 => Self::Sample(Sample::read(&mut r)?),
            6 => Self::Stop,
            7 => Self::Refused(Refused {
                reason: coded("reason", r.u8(), &REFUSALS)?,
                version: r.u8(),
                wait_ms: r.u16(),
            }),
            _ => return Err(PayloadError::Kind(kind)),
        })
    }
}

impl Caps {
    fn write(&self, w: &mut Writer) {
        w.put(&[self.strings, self.units.length, self.units.tension, self.units.time]);
        w.put(&self.pitch_nm.to_le_bytes());
        for value in [self.min_mn, self.max_mn, self.rate_hz, self.watchdog_ms] {
            w.put(&value.to_le_bytes());
        }
        w.put(&self.boot.to_le_bytes()).put(&self.name);
    }

    fn read(r: &mut Reader) -> Self {
        Self {
            strings: r.u8(),
            units: Units { length: r.u8(), tension: r.u8(), time: r.u8() },
            pitch_nm: r.u32(),
            min_mn: r.u16(),
            max_mn: r.u16(),
            rate_hz: r.u16(),
            watchdog_ms: r.u16(),
            boot: r.u32(),
            name: r.take(),
        }
    }
}

impl Sample {
    fn write(&self, w: &mut Writer) {
        w.put(&[self.state as u8, self.fault as u8, self.jig, self.buttons]);
        w.put(&self.time_us.to_le_bytes()).put(&self.obeyed.to_le_bytes());
        for count in self.count {
            w.put(&count.to_le_bytes());
        }
        for tension in self.tension_mn {
            w.put(&tension.to_le_bytes());
        }
    }

    fn read(r: &mut Reader) -> Result<Self, PayloadError> {
        Ok(Self {
            state: coded("state", r.u8(), &STATES)?,
            fault: coded("fault", r.u8(), &FAULTS)?,
            jig: r.u8(),
            buttons: r.u8(),
            time_us: r.u32(),
            obeyed: r.u32(),
            count: std::array::from_fn(|_| i32::from_le_bytes(r.take())),
            tension_mn: r.tensions(),
        })
    }
}
