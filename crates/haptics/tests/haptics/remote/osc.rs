//! Promise: paired OSC senders move pan and turner, all others are ignored and counted, and no message breaks the listener.

use std::net::UdpSocket;
use std::time::{Duration, Instant};

use glam::DVec3;
use proptest::prelude::*;
use rosc::{OscBundle, OscMessage, OscPacket, OscTime, OscType};
use saute_haptics::device::{HapticCommand, HapticSample};
use saute_haptics::open::Reach;
use saute_haptics::remote::osc::message::{Event, read};
use saute_haptics::{Health, Opened, Rendering, open};

const DT: f64 = 4e-3;

struct Bench {
    opened: Opened,
    code: String,
}

/// A program that sends OSC.
struct Sender(UdpSocket);

fn bench() -> Bench {
    let opened = open("osc@127.0.0.1:0", 0).unwrap();
    let code = opened.access.code.clone().unwrap();
    Bench { opened, code }
}

fn packet(address: &str, args: Vec<OscType>) -> OscPacket {
    OscPacket::Message(OscMessage { addr: address.into(), args })
}

fn floats(numbers: &[f32]) -> Vec<OscType> {
    numbers.iter().map(|v| OscType::Float(*v)).collect()
}

impl Bench {
    fn sender(&self) -> Sender {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.connect(&self.opened.access.place).unwrap();
        Sender(socket)
    }

    fn until(&mut self, mut seen: impl FnMut(&HapticSample) -> bool) -> Option<HapticSample> {
        let begun = Instant::now();
        while begun.elapsed() < Duration::from_secs(60) {
            let sample = self.opened.device.exchange(&HapticCommand::default(), DT);
            if seen(&sample) {
                return Some(sample);
            }
            std::thread::sleep(Duration::from_secs_f64(DT));
        }
        None
    }

    fn paired(&self) -> Sender {
        let sender = self.sender();
        sender.send(packet("/saute/pair", vec![OscType::String(self.code.clone())]));
        sender
    }
}

impl Sender {
    fn send(&self, packet: OscPacket) {
        self.0.send(&rosc::encoder::encode(&packet).unwrap()).unwrap();
    }

    fn pose(&self, address: &str, numbers: [f32; 7]) {
        self.send(packet(address, floats(&numbers)));
    }
}

fn up(sample: &HapticSample) -> DVec3 {
    sample.pose.rotation * DVec3::Z
}

#[test]
fn a_paired_sender_moves_pan_and_turner_and_presses_buttons() {
    let mut bench = bench();
    assert_eq!(bench.opened.access.reach, Reach::ThisMachine);
    assert_eq!(bench.opened.device.capabilities().rendering(), Rendering::SoundAndPicture);
    let sender = bench.paired();
    let (sin, cos) = 15f32.to_radians().sin_cos();
    let seen = bench.until(|s| {
        sender.pose("/saute/pan/pose", [0.05, -0.02, 0.1, sin, 0.0, 0.0, cos]);
        (s.pose.position - DVec3::new(0.05, -0.02, 0.1)).length() < 1e-4
    });
    let sample = seen.expect("the pan is there");
    assert!(
        sample.health == Health::Running && (up(&sample).y + 0.5).abs() < 1e-3 && sample.turner.is_none(),
        "{sample:?}"
    );
    sender.send(packet("/saute/button", vec![OscType::Int(3), OscType::Float(1.0)]));
    let sample = bench.until(|s| {
        sender.pose("/saute/turner/pose", [0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0]);
        s.turner.is_some()
    });
    let sample = sample.expect("the turner is there");
    assert!((sample.turner.unwrap().position - DVec3::new(0.1, 0.2, 0.3)).length() < 1e-6 && sample.buttons == 8);
    let tilted = bench.until(|s| {
        sender.send(packet("/saute/pan/tilt", floats(&[0.0, 30.0])));
        (up(s).x - 0.5).abs() < 1e-3 && s.pose.position.length() < 1e-3
    });
    assert!(tilted.is_some(), "tilt alone turns the pan at home");
}

#[test]
fn a_sender_that_has_not_paired_is_ignored_and_counted() {
    let mut bench = bench();
    let (friend, stranger) = (bench.paired(), bench.sender());
    friend.send(packet("/saute/pan/tilt", floats(&[0.0, 0.0])));
    bench.until(|s| s.health == Health::Running).expect("the paired sender works");
    for _ in 0..10 {
        stranger.send(packet("/saute/pan/tilt", floats(&[40.0, 0.0])));
    }
    let wrong = format!("{:06}", (bench.code.parse::<u32>().unwrap() + 1) % 1_000_000);
    stranger.send(packet("/saute/pair", vec![OscType::String(wrong)]));
    stranger.send(packet("/saute/pair", vec![OscType::String(bench.code.clone())]));
    let seen = bench.until(|s| s.rejected >= 12).expect("counted, with the right code too soon after a wrong one");
    assert!((up(&seen) - DVec3::Z).length() < 1e-6, "{seen:?}");
}

#[test]
fn the_code_may_come_as_a_number_and_bundles_are_opened() {
    let mut bench = bench();
    let sender = bench.sender();
    let code = OscType::Int(bench.code.parse().unwrap());
    let time = OscTime { seconds: 0, fractional: 1 };
    let inner = OscBundle { timetag: time, content: vec![packet("/saute/pan/tilt", floats(&[20.0, 0.0]))] };
    let content = vec![packet("/saute/pair", vec![code]), OscPacket::Bundle(inner)];
    sender.send(OscPacket::Bundle(OscBundle { timetag: time, content }));
    assert!(bench.until(|s| (up(s).y + 20f64.to_radians().sin()).abs() < 1e-2).is_some());
}

#[test]
fn a_program_that_sends_floats_alone_pairs_and_presses_buttons() {
    for slash in ["", "/"] {
        let mut bench = bench();
        let sender = bench.sender();
        sender.send(packet(&format!("/saute/pair{slash}"), floats(&[bench.code.parse().unwrap()])));
        sender.send(packet(&format!("/saute/button{slash}"), floats(&[1.0, 1.0])));
        sender.send(packet(&format!("/saute/pan/tilt{slash}"), floats(&[10.0, 0.0])));
        let seen = bench.until(|s| s.health == Health::Running).expect("paired");
        assert_eq!((seen.buttons, seen.rejected), (2, 0));
    }
}

#[test]
fn the_code_may_have_any_type_of_number_and_leading_zeros_may_be_missing() {
    let parsed = |arg: OscType| {
        let bytes = rosc::encoder::encode(&packet("/saute/pair", vec![arg])).unwrap();
        read(&bytes).unwrap().remove(0)
    };
    for arg in [OscType::Int(42), OscType::Long(42), OscType::Float(42.0), OscType::Double(42.0)] {
        assert_eq!(parsed(arg), Ok(Event::Pair("000042".into())));
    }
    assert_eq!(parsed(OscType::Float(999_999.0)), Ok(Event::Pair("999999".into())));
    for arg in [OscType::Float(42.5), OscType::Float(-1.0), OscType::Int(1_000_000), OscType::Float(f32::NAN)] {
        assert!(parsed(arg.clone()).is_err(), "{arg:?}");
    }
}

/// Returns the reason that is sent to the sender next, within a minute.
fn answer(sender: &Sender) -> String {
    sender.0.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    let mut bytes = [0; 1024];
    let length = sender.0.recv(&mut bytes).expect("an answer");
    match rosc::decoder::decode_udp(&bytes[..length]).unwrap().1 {
        OscPacket::Message(OscMessage { addr, args }) if addr == "/saute/rejected" => match &args[..] {
            [OscType::String(why)] => why.clone(),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_rejected_message_says_why_on_the_screen_and_to_its_sender() {
    let mut bench = bench();
    let sender = bench.sender();
    let code: f32 = bench.code.parse().unwrap();
    let bad = [
        ("/saute/pan/tilt", floats(&[0.0, 0.0]), "not paired"),
        ("/saute/pair", floats(&[code]), ""),
        ("/saute/pan/tillt", floats(&[0.0, 0.0]), "/saute/pan/tillt is no address of saute"),
        ("/saute/pan/tilt", floats(&[0.0]), "two angles in degrees"),
        ("/saute/pan/tilt", floats(&[f32::NAN, 0.0]), "/saute/pan/tilt has a number that is not finite"),
        ("/saute/pan/pose", floats(&[f32::INFINITY; 7]), "/saute/pan/pose has a number that is not finite"),
        ("/saute/turner/pose", floats(&[9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]), "as 0 to 2 m"),
        ("/saute/button", floats(&[0.5, 1.0]), "from 0 to 31"),
        ("/saute/pair", vec![OscType::String("no code".into())], "the code is wrong"),
    ];
    for (address, args, why) in &bad {
        sender.send(packet(address, args.clone()));
        if !why.is_empty() {
            let told = answer(&sender);
            assert!(told.contains(why), "{address}: {told}");
        }
    }
    let seen = bench.until(|s| s.rejected >= 8).expect("all are counted");
    assert_eq!((seen.rejected, seen.pose.is_finite()), (8, true));
    let shown: Vec<String> = bench.opened.notices.as_ref().unwrap().try_iter().collect();
    let own = sender.0.local_addr().unwrap().to_string();
    assert_eq!(shown.len(), 8, "{shown:?}");
    assert!(shown.iter().all(|line| line.starts_with("rejected a message from ") && line.contains(&own)), "{shown:?}");
}

#[test]
fn the_answer_of_another_listener_is_not_answered() {
    let bench = bench();
    let sender = bench.sender();
    sender.send(packet("/saute/rejected", vec![OscType::String("why".into())]));
    sender.send(packet("/saute/button", vec![]));
    assert!(answer(&sender).contains("the number of a button"), "the second message's answer comes first");
}

#[test]
fn a_silent_sender_is_lost_and_the_pan_returns_home() {
    let mut bench = bench();
    let sender = bench.paired();
    sender.pose("/saute/pan/pose", [0.2, 0.0, 0.2, 0.3, 0.0, 0.0, 1.0]);
    bench.until(|s| s.pose.position.x > 0.19).expect("there");
    bench.until(|s| s.health == Health::Lost).expect("lost");
    bench.until(|s| s.pose.position.length() < 5e-3 && up(s).z > 0.9999).expect("home");
    sender.pose("/saute/pan/pose", [0.2, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0]);
    bench.until(|s| s.health == Health::Running).expect("and back");
}

#[test]
fn the_button_of_a_lost_sender_stays_released_when_it_returns() {
    let mut bench = bench();
    let sender = bench.paired();
    sender.send(packet("/saute/button", vec![OscType::Int(5), OscType::Bool(true)]));
    let tilt = || sender.send(packet("/saute/pan/tilt", floats(&[0.0, 0.0])));
    tilt();
    bench.until(|s| s.health == Health::Running && s.buttons == 32).expect("pressed");
    bench.until(|s| s.health == Health::Lost && s.buttons == 0).expect("lost");
    tilt();
    let back = bench.until(|s| s.health == Health::Running).expect("back");
    assert_eq!(back.buttons, 0);
}

#[test]
fn a_sender_of_the_turner_alone_does_not_move_the_pan_and_its_turner_stays_in_the_workspace() {
    let mut bench = bench();
    let sender = bench.paired();
    let far = |s: &HapticSample| {
        sender.pose("/saute/turner/pose", [1.5, 0.1, -1.0, 1.0, 0.0, 0.0, 0.0]);
        s.turner.is_some()
    };
    let sample = bench.until(far).expect("the turner is there");
    assert!(sample.health == Health::Running && !sample.leads_pan, "{sample:?}");
    let turner = sample.turner.unwrap();
    assert!((turner.position - DVec3::new(0.5, 0.1, -0.5)).length() < 1e-6, "{turner:?}");
    assert!((turner.rotation * DVec3::Z).z < -0.999, "a turner may be turned over");
    sender.send(packet("/saute/pan/tilt", floats(&[0.0, 0.0])));
    bench.until(|s| s.leads_pan && s.turner.is_some()).expect("both");
}

#[test]
fn the_port_is_free_as_soon_as_the_device_is_dropped() {
    let bench = bench();
    let text = format!("osc@{}", bench.opened.access.place);
    assert!(open(&text, 0).is_err(), "it is in use");
    drop(bench);
    assert!(open(&text, 0).is_ok());
}

#[test]
fn garbage_is_counted_and_survived_and_poses_stay_in_the_workspace() {
    let mut bench = bench();
    let sender = bench.paired();
    for bytes in [&b""[..], b"/", b"#bundle\0", &[0xff; 100], &[0; 1024], &[b'/'; 1400]] {
        sender.0.send(bytes).unwrap();
    }
    for numbers in [[f32::NAN; 7], [1e9; 7], [0.0; 7], [f32::INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]] {
        sender.pose("/saute/pan/pose", numbers);
    }
    sender.send(packet("/saute/pan/pose", floats(&[1.0])));
    sender.send(packet("/saute/fire", vec![]));
    sender.send(packet("/saute/button", vec![OscType::Int(99), OscType::Bool(true)]));
    let seen = bench.until(|s| s.rejected >= 12).expect("counted");
    assert_eq!((seen.health, seen.buttons), (Health::Connecting, 0));
    sender.pose("/saute/pan/pose", [1.5, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let far = bench.until(|s| s.pose.position.x > 0.49).expect("at the bound");
    assert!(far.pose.position.x <= 0.5 && far.pose.position.z <= 0.5, "{far:?}");
    assert!(up(&far).angle_between(DVec3::Z) < 2.1, "no pan upside down");
    // The flood goes on while the device counts: on a busy machine the kernel drops packets that nobody reads.
    let flooded = bench.until(|s| {
        (0..200).for_each(|_| sender.pose("/saute/pan/pose", [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]));
        s.rejected > 500
    });
    assert!(flooded.is_some(), "a flood is rejected");
}

proptest! {
    #[test]
    fn no_datagram_makes_the_parser_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = read(&bytes);
    }

    #[test]
    fn every_accepted_pose_is_valid(numbers in prop::array::uniform7(proptest::num::f32::ANY)) {
        let bytes = rosc::encoder::encode(&packet("/saute/pan/pose", floats(&numbers))).unwrap();
        if let Ok(Event::Pan(pose)) = &read(&bytes).unwrap()[0] {
            prop_assert!(pose.position.length() <= 2.0 && (pose.rotation.length() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn damaged_messages_do_not_make_the_parser_panic(at in 0usize..60, byte in any::<u8>(), cut in 0usize..60) {
        let mut bytes = rosc::encoder::encode(&packet("/saute/pan/pose", floats(&[0.1; 7]))).unwrap();
        let last = bytes.len() - 1;
        bytes[at.min(last)] = byte;
        bytes.truncate(last + 1 - cut.min(last));
        let _ = read(&bytes);
    }
}
