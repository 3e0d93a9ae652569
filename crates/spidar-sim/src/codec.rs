//! The device's side of docs/spidar-protocol.md, version 2: an implementation independent of the driver's.

use std::time::Duration;

/// Length of a frame [bytes].
pub const FRAME: usize = 80;
const PAYLOAD: std::ops::Range<usize> = 12..76;
/// Protocol version.
const VERSION: u8 = 2;
/// Kind of a hello, in every version.
const HELLO: u8 = 1;

/// A request of a host.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request {
    Hello { pairing: u32 },
    Arm,
    Command { tension_mn: [u16; 8] },
    Stop,
}

/// What the bytes of a datagram are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parsed {
    /// A request with its sequence number and session.
    Request { sequence: u32, session: u32, request: Request },
    /// A hello of a host of another protocol version.
    HelloOfAnotherVersion { session: u32 },
}

/// Reason of a refusal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    WrongCode,
    Busy,
    OutOfOrder,
    TooManyTries,
    OtherVersion,
}

/// Returns the CRC-32 of IEEE 802.3, computed bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            let carry = crc & 1;
            crc >>= 1;
            if carry == 1 {
                crc ^= 0xedb8_8320;
            }
        }
    }
    !crc
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    (0..4).fold(0, |sum, i| sum | u32::from(bytes[at + i]) << (8 * i))
}

fn u16_at(bytes: &[u8], at: usize) -> u16 {
    u16::from(bytes[at]) | u16::from(bytes[at + 1]) << 8
}

/// Parses a request; returns `None` if the bytes are not a valid frame of a host.
pub fn parse(bytes: &[u8]) -> Option<Parsed> {
    let sound = bytes.len() == FRAME && bytes[0] == b'S' && bytes[1] == b'P';
    if !sound || u32_at(bytes, PAYLOAD.end) != crc(&bytes[..PAYLOAD.end]) {
        return None;
    }
    let (sequence, session) = (u32_at(bytes, 4), u32_at(bytes, 8));
    if bytes[2] != VERSION {
        return (bytes[3] == HELLO).then_some(Parsed::HelloOfAnotherVersion { session });
    }
    let payload = &bytes[PAYLOAD];
    let request = match bytes[3] {
        HELLO => Request::Hello { pairing: u32_at(payload, 0) },
        3 => Request::Arm,
        4 => Request::Command { tension_mn: std::array::from_fn(|i| u16_at(payload, 4 + 2 * i)) },
        6 => Request::Stop,
        _ => return None,
    };
    Some(Parsed::Request { sequence, session, request })
}

/// An answer under construction.
struct ReplyBytes {
    bytes: Vec<u8>,
}

impl ReplyBytes {
    fn new(kind: u8, sequence: u32, session: u32) -> Self {
        let mut bytes = vec![b'S', b'P', VERSION, kind];
        bytes.extend(sequence.to_le_bytes());
        bytes.extend(session.to_le_bytes());
        Self { bytes }
    }

    fn finish(mut self) -> Vec<u8> {
        self.bytes.resize(PAYLOAD.end, 0);
        let check = crc(&self.bytes);
        self.bytes.extend(check.to_le_bytes());
        self.bytes
    }
}

/// Properties that the device reports.
#[derive(Clone, Debug)]
pub struct Identity {
    pub tension_unit: u8,
    pub pitch_nm: u32,
    pub min_mn: u16,
    pub max_mn: u16,
    pub rate_hz: u16,
    pub watchdog_ms: u16,
    pub boot: u32,
    pub name: String,
}

/// Returns the frame of the capabilities.
pub fn caps(identity: &Identity, sequence: u32, session: u32) -> Vec<u8> {
    let mut answer = ReplyBytes::new(2, sequence, session);
    answer.bytes.extend([8, 1, identity.tension_unit, 1]);
    answer.bytes.extend(identity.pitch_nm.to_le_bytes());
    for value in [identity.min_mn, identity.max_mn, identity.rate_hz, identity.watchdog_ms] {
        answer.bytes.extend(value.to_le_bytes());
    }
    answer.bytes.extend(identity.boot.to_le_bytes());
    answer.bytes.extend(identity.name.bytes().filter(u8::is_ascii).take(16));
    answer.finish()
}

/// Measured state of the device.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    pub state: u8,
    pub fault: u8,
    pub jig: u8,
    pub buttons: u8,
    pub time_us: u32,
    pub obeyed: u32,
    pub count: [i32; 8],
    pub tension_mn: [u16; 8],
}

/// Returns the frame of a sample.
pub fn sample(reading: &Reading, sequence: u32, session: u32) -> Vec<u8> {
    let mut answer = ReplyBytes::new(5, sequence, session);
    answer.bytes.extend([reading.state, reading.fault, reading.jig, reading.buttons]);
    answer.bytes.extend(reading.time_us.to_le_bytes());
    answer.bytes.extend(reading.obeyed.to_le_bytes());
    reading.count.iter().for_each(|c| answer.bytes.extend(c.to_le_bytes()));
    reading.tension_mn.iter().for_each(|t| answer.bytes.extend(t.to_le_bytes()));
    answer.finish()
}

/// Returns the frame of a refusal, with the time after which another hello may succeed.
pub fn refused(why: Refusal, wait: Duration, sequence: u32, session: u32) -> Vec<u8> {
    let mut answer = ReplyBytes::new(7, sequence, session);
    let reason = match why {
        Refusal::WrongCode => 0,
        Refusal::Busy => 1,
        Refusal::OutOfOrder => 2,
        Refusal::TooManyTries => 3,
        Refusal::OtherVersion => 4,
    };
    answer.bytes.extend([reason, VERSION]);
    // Rounded up: a hello after a shorter time would come too early.
    let wait_ms = u16::try_from(wait.as_micros().div_ceil(1000)).unwrap_or(u16::MAX);
    answer.bytes.extend(wait_ms.to_le_bytes());
    answer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: &str = include_str!("../../../docs/spidar-protocol.md");

    /// Returns a test vector of the document.
    fn vector(name: &str) -> Vec<u8> {
        let after = DOCUMENT.split(&format!("vector {name}\n")).nth(1).expect("the vector is in the document");
        let hex: String = after.split("```").next().expect("text").split_whitespace().collect();
        (0..hex.len() / 2).map(|i| u8::from_str_radix(&hex[2 * i..2 * i + 2], 16).expect("hex")).collect()
    }

    fn request(sequence: u32, request: Request) -> Option<Parsed> {
        Some(Parsed::Request { sequence, session: 7, request })
    }

    #[test]
    fn requests_are_parsed_as_the_document_states() {
        assert_eq!(parse(&vector("hello")), request(1, Request::Hello { pairing: 123_456 }));
        assert_eq!(parse(&vector("arm")), request(2, Request::Arm));
        let tension_mn = [300, 400, 500, 600, 700, 800, 900, 12_000];
        assert_eq!(parse(&vector("command")), request(3, Request::Command { tension_mn }));
        assert_eq!(parse(&vector("stop")), request(4, Request::Stop));
        assert_eq!(parse(&vector("hello-of-version-1")), Some(Parsed::HelloOfAnotherVersion { session: 7 }));
    }

    #[test]
    fn answers_are_encoded_as_the_document_states() {
        let identity = Identity {
            tension_unit: 1,
            pitch_nm: 20_000,
            min_mn: 300,
            max_mn: 12_000,
            rate_hz: 1000,
            watchdog_ms: 100,
            boot: 0xb007,
            name: "bench".into(),
        };
        assert_eq!(caps(&identity, 1, 7), vector("caps"));
        let reading = Reading {
            state: 3,
            fault: 0,
            jig: 0,
            buttons: 0,
            time_us: 1_000_000,
            obeyed: 3,
            count: [0, 1, -1, 1000, -1000, 20_000, -20_000, i32::MAX],
            tension_mn: [300, 400, 500, 600, 700, 800, 900, 12_000],
        };
        assert_eq!(sample(&reading, 2, 7), vector("sample"));
        let armed = Reading { state: 2, jig: 3, buttons: 0b1000_0001, obeyed: 0, tension_mn: [300; 8], ..reading };
        assert_eq!(sample(&armed, 2, 7), vector("sample-armed"));
        let fault = Reading { state: 4, fault: 3, tension_mn: [0; 8], ..reading };
        assert_eq!(sample(&fault, 3, 7), vector("sample-fault"));
        assert_eq!(refused(Refusal::OutOfOrder, Duration::ZERO, 2, 7), vector("refused-order"));
        assert_eq!(refused(Refusal::Busy, Duration::from_micros(249_001), 1, 7), vector("refused-busy"));
        assert_eq!(refused(Refusal::WrongCode, Duration::from_secs(1), 1, 7), vector("refused"));
        assert_eq!(refused(Refusal::OtherVersion, Duration::ZERO, 1, 7), vector("refused-version"));
    }

    #[test]
    fn damaged_frames_are_not_requests() {
        let sound = vector("command");
        for bit in 0..8 * FRAME {
            let mut damaged = sound.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(parse(&damaged), None, "bit {bit}");
        }
        assert_eq!(parse(&sound[..79]), None);
    }
}
