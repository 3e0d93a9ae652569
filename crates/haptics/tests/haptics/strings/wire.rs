//! Promise: frames match docs/spidar-protocol.md, and no received bytes can break the host.

use std::io::{self, Read, Write};

use proptest::prelude::*;
use saute_haptics::strings::wire::{
    Caps, Command, Deframer, DeviceState, FRAME, FaultCode, Frame, FrameError, Hello, Link, Message, Refusal, Refused,
    STUFFED, Sample, SerialLink, stuff,
};

use crate::bench_caps::CAPS;

const DOCUMENT: &str = include_str!("../../../../../docs/spidar-protocol.md");

fn vector(name: &str) -> Vec<u8> {
    let after = DOCUMENT.split(&format!("vector {name}\n")).nth(1).expect("the vector is in the document");
    let hex: String = after.split("```").next().unwrap().split_whitespace().collect();
    (0..hex.len() / 2).map(|i| u8::from_str_radix(&hex[2 * i..2 * i + 2], 16).unwrap()).collect()
}

fn refused(reason: Refusal, wait_ms: u16) -> Message {
    Message::Refused(Refused { reason, version: 2, wait_ms })
}

fn documented() -> Vec<(&'static str, Frame)> {
    let tension_mn = [300, 400, 500, 600, 700, 800, 900, 12_000];
    let count = [0, 1, -1, 1000, -1000, 20_000, -20_000, i32::MAX];
    let sample = Sample {
        state: DeviceState::Running,
        fault: FaultCode::None,
        time_us: 1_000_000,
        obeyed: 3,
        count,
        tension_mn,
        ..Sample::default()
    };
    let armed =
        Sample { state: DeviceState::Armed, jig: 3, buttons: 0b1000_0001, obeyed: 0, tension_mn: [300; 8], ..sample };
    let fault = Sample { state: DeviceState::Fault, fault: FaultCode::Slack, tension_mn: [0; 8], ..sample };
    let frame = |sequence, message| Frame { sequence, session: 7, message };
    vec![
        ("hello", frame(1, Message::Hello(Hello { pairing: 123_456, rate_hz: 1000 }))),
        ("caps", frame(1, Message::Caps(Caps { boot: 0xb007, ..CAPS }))),
        ("arm", frame(2, Message::Arm)),
        ("command", frame(3, Message::Command(Command { time_us: 2000, tension_mn }))),
        ("sample", frame(2, Message::Sample(sample))),
        ("sample-armed", frame(2, Message::Sample(armed))),
        ("sample-fault", frame(3, Message::Sample(fault))),
        ("stop", frame(4, Message::Stop)),
        ("refused", frame(1, refused(Refusal::WrongCode, 1000))),
        ("refused-busy", frame(1, refused(Refusal::Busy, 250))),
        ("refused-order", frame(2, refused(Refusal::OutOfOrder, 0))),
        ("refused-version", frame(1, refused(Refusal::OtherVersion, 0))),
    ]
}

#[test]
fn every_test_vector_of_the_document_is_written_and_read() {
    for (name, frame) in documented() {
        assert_eq!(frame.encode().to_vec(), vector(name), "{name}");
        assert_eq!(Frame::decode(&vector(name)).unwrap(), frame, "{name}");
    }
    let sample: [u8; FRAME] = vector("sample").try_into().unwrap();
    assert_eq!(stuff(&sample).to_vec(), vector("sample-stuffed"));
}

#[test]
fn a_hello_of_version_1_is_written_for_older_devices_and_never_read() {
    let hello = Message::HelloOfVersion1(Hello { pairing: 123_456, rate_hz: 1000 });
    let frame = Frame { sequence: 5, session: 7, message: hello };
    assert_eq!(frame.encode().to_vec(), vector("hello-of-version-1"));
    assert_eq!(Frame::decode(&frame.encode()), Err(FrameError::Version(1)));
}

#[test]
fn every_single_bit_error_is_noticed() {
    let sound = vector("sample");
    for bit in 0..8 * FRAME {
        let mut damaged = sound.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(Frame::decode(&damaged).is_err(), "bit {bit}");
    }
}

#[test]
fn another_version_needs_an_intact_checksum() {
    let mut frame = vector("caps");
    frame[2] = 3;
    assert_eq!(Frame::decode(&frame), Err(FrameError::Checksum));
    assert_eq!(Frame::decode(&frame[..70]), Err(FrameError::Length(70)));
}

/// A stream that delivers bytes in pieces and stores what is written.
struct Wire {
    coming: Vec<u8>,
    piece: usize,
    written: Vec<u8>,
}

impl Read for Wire {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let count = self.piece.min(self.coming.len()).min(into.len());
        if count == 0 {
            return Err(io::ErrorKind::WouldBlock.into());
        }
        into[..count].copy_from_slice(&self.coming[..count]);
        self.coming.drain(..count);
        Ok(count)
    }
}

impl Write for Wire {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.written.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn frames_pass_a_serial_line_both_ways() {
    let frame = documented()[4].1;
    let coming = vector("sample-stuffed").repeat(3);
    let mut link = SerialLink::over(Wire { coming, piece: 7, written: Vec::new() });
    for _ in 0..3 {
        assert_eq!(link.receive().unwrap().unwrap(), frame);
    }
    assert!(link.receive().is_none());
    link.send(&frame).unwrap();
}

proptest! {
    #[test]
    fn no_bytes_make_a_frame_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = Frame::decode(&bytes);
    }

    #[test]
    fn no_payload_makes_a_message_panic(kind in any::<u8>(), bytes in proptest::collection::vec(any::<u8>(), 64)) {
        let payload: [u8; 64] = bytes.try_into().unwrap();
        if let Ok(message) = Message::decode(kind, &payload) {
            // A decoded message encodes to the same meaning; unused bytes may differ.
            let (again, said) = message.encode();
            prop_assert_eq!(kind, again);
            prop_assert_eq!(Message::decode(again, &said).unwrap(), message);
        }
    }

    #[test]
    fn any_frame_survives_stuffing(bytes in proptest::collection::vec(any::<u8>(), FRAME)) {
        let frame: [u8; FRAME] = bytes.try_into().unwrap();
        let stuffed = stuff(&frame);
        prop_assert_eq!(stuffed.iter().position(|b| *b == 0), Some(STUFFED - 1));
        let mut deframer = Deframer::default();
        let found: Vec<[u8; FRAME]> = stuffed.iter().filter_map(|b| deframer.push(*b)).collect();
        prop_assert_eq!(found, vec![frame]);
    }

    #[test]
    fn a_stream_resynchronises_after_any_garbage(
        garbage in proptest::collection::vec(any::<u8>(), 0..400), lost in 0usize..STUFFED, piece in 1usize..300,
    ) {
        // Garbage, a truncated frame, then two whole ones: both are found.
        let whole = vector("sample-stuffed");
        let mut coming = garbage;
        coming.extend(&whole[lost..]);
        coming.extend(&whole);
        coming.extend(&whole);
        let mut link = SerialLink::over(Wire { coming, piece, written: Vec::new() });
        let mut found = 0;
        while let Some(frame) = link.receive() {
            found += usize::from(frame == Ok(documented()[4].1));
        }
        prop_assert!(found >= 2, "{}", found);
    }
}
