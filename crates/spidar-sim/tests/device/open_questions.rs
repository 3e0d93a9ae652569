//! Promise: the device obeys each rule of the protocol that leaves an implementer a choice, section by section.

use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Health};
use saute_haptics::strings::wire::{
    Caps, Command, DeviceState, FaultCode, Frame, Hello, Message, Refusal, Refused, Sample,
};
use saute_haptics::{Spidar, library};

use crate::memory_link::{Bench, CODE, MemoryLink};

const HOST: &str = "10.0.0.1:9000";
const OTHER_PORT: &str = "10.0.0.1:9001";
const SESSION: u32 = 0x51a7_e001;

/// A device with a host that numbers its frames.
struct Driven {
    bench: Bench,
    session: u32,
    sequence: u32,
}

impl Driven {
    fn new() -> Self {
        Self { bench: Bench::new(1.0), session: SESSION, sequence: 0 }
    }

    /// A device in state running, with 2 N on every string.
    fn running() -> Self {
        let mut driven = Self::new();
        driven.say(hello(CODE));
        driven.say(Message::Arm);
        assert_eq!(driven.sample(command(2000)).state, DeviceState::Running);
        driven
    }

    /// Sends the next frame and returns the answers.
    fn say(&mut self, message: Message) -> Vec<Message> {
        self.sequence += 1;
        self.deliver(self.sequence, message)
    }

    fn deliver(&self, sequence: u32, message: Message) -> Vec<Message> {
        self.bench.deliver(&Frame { sequence, session: self.session, message }, HOST);
        self.bench.answers(HOST)
    }

    /// Sends a frame that is answered with a sample.
    fn sample(&mut self, message: Message) -> Sample {
        match self.say(message)[..] {
            [Message::Sample(sample)] => sample,
            ref other => panic!("not one sample: {other:?}"),
        }
    }

    /// Begins another session; returns the capabilities.
    fn greet(&mut self) -> Caps {
        self.session += 1;
        match self.say(hello(CODE))[..] {
            [Message::Caps(caps)] => caps,
            ref other => panic!("not one answer with caps: {other:?}"),
        }
    }

    fn assert_pulls(&self, newtons: f64) {
        let tensions = self.bench.tensions();
        assert!(tensions.iter().all(|t| (t - newtons).abs() < 0.05), "{tensions:?} instead of {newtons} N");
    }
}

fn hello(pairing: u32) -> Message {
    Message::Hello(Hello { pairing, rate_hz: 1000 })
}

fn command(mn: u16) -> Message {
    Message::Command(Command { time_us: 0, tension_mn: [mn; 8] })
}

fn reason(answers: &[Message]) -> Option<Refusal> {
    match answers {
        [Message::Refused(Refused { reason, .. })] => Some(*reason),
        _ => None,
    }
}

fn driver(bench: &Bench) -> Spidar<MemoryLink> {
    let geometry = library::devices().unwrap().remove("spidar-pan-crossed").unwrap();
    Spidar::new(bench.link(HOST), geometry, CODE)
}

fn after(bench: &Bench, spidar: &mut Spidar<MemoryLink>, steps: u32) -> HapticSample {
    let step = |_| {
        bench.pass(1);
        spidar.exchange(&HapticCommand::default(), 1e-3)
    };
    (0..steps).map(step).last().unwrap()
}

#[test]
fn address_a_frame_from_another_port_of_the_same_machine_is_a_stranger_s() {
    let driven = Driven::running();
    for message in [command(9000), Message::Arm, Message::Stop] {
        driven.bench.deliver(&Frame { sequence: 50, session: SESSION, message }, OTHER_PORT);
    }
    driven.bench.deliver(&Frame { sequence: 51, session: SESSION + 5, message: hello(CODE) }, OTHER_PORT);
    assert_eq!(reason(&driven.bench.answers(OTHER_PORT)), Some(Refusal::Busy), "the hello alone is answered");
    driven.bench.pass(8);
    driven.assert_pulls(2.0);
}

#[test]
fn arm_when_armed_changes_nothing_and_arm_when_running_returns_to_the_least_tension() {
    let mut driven = Driven::new();
    driven.say(hello(CODE));
    for _ in 0..2 {
        assert_eq!(driven.sample(Message::Arm).state, DeviceState::Armed);
        driven.bench.pass(10);
        driven.assert_pulls(0.3);
    }
    driven.sample(command(2000));
    driven.bench.pass(10);
    driven.assert_pulls(2.0);
    assert_eq!(driven.sample(Message::Arm).state, DeviceState::Armed);
    driven.bench.pass(10);
    driven.assert_pulls(0.3);
}

#[test]
fn second_hello_is_answered_in_greeted_and_has_no_effect_later() {
    let mut driven = Driven::new();
    driven.say(hello(CODE));
    assert!(matches!(driven.say(hello(CODE))[..], [Message::Caps(_)]), "the first answer was lost");
    driven.say(Message::Arm);
    assert!(driven.say(hello(CODE)).is_empty(), "armed");
    driven.sample(command(2000));
    for _ in 0..9 {
        driven.bench.pass(100);
        assert!(driven.say(hello(CODE)).is_empty(), "running");
    }
    driven.bench.pass(99);
    assert!(!driven.bench.is_idle());
    driven.bench.pass(1);
    assert!(driven.bench.is_idle(), "a second after the command, however many hellos have come");
}

#[test]
fn fault_cuts_the_current_keeps_the_session_and_is_left_by_a_hello_after_repair() {
    let mut driven = Driven::running();
    driven.bench.order("fault 3");
    for message in [command(5000), Message::Arm] {
        let sample = driven.sample(message);
        assert_eq!((sample.state, sample.fault), (DeviceState::Fault, FaultCode::Slack));
        driven.bench.pass(20);
        driven.assert_pulls(0.0);
    }
    driven.greet();
    assert_eq!(driven.sample(Message::Arm).state, DeviceState::Fault, "the cause persists");
    assert!(driven.say(Message::Stop).is_empty());
    driven.bench.order("repair");
    driven.greet();
    let sample = driven.sample(Message::Arm);
    assert_eq!((sample.state, sample.fault), (DeviceState::Armed, FaultCode::None));
}

#[test]
fn fault_is_not_left_before_the_next_hello_nor_by_a_stop() {
    let mut driven = Driven::running();
    driven.bench.order("fault 1");
    driven.bench.order("repair");
    assert_eq!(driven.sample(command(5000)).fault, FaultCode::MotorHot);
    driven.say(Message::Stop);
    driven.bench.order("fault 2");
    driven.greet();
    assert_eq!(driven.sample(Message::Arm).fault, FaultCode::Encoder);
}

#[test]
fn fault_is_told_by_the_driver_which_goes_on_gently_after_repair() {
    let bench = Bench::new(1.0);
    let mut spidar = driver(&bench);
    assert_eq!(after(&bench, &mut spidar, 50).health, Health::Uncalibrated);
    bench.order("buttons 5");
    bench.order("fault 4");
    let sample = after(&bench, &mut spidar, 2500);
    assert_eq!((sample.health, sample.buttons), (Health::Fault, 0));
    assert!(bench.tensions().iter().all(|t| *t < 1e-9), "{:?}", bench.tensions());
    bench.order("repair");
    assert_eq!(after(&bench, &mut spidar, 1100).health, Health::Uncalibrated);
    assert!(bench.tensions().iter().all(|t| (t - 0.3).abs() < 0.05), "{:?}", bench.tensions());
}

#[test]
fn accepted_frames_alone_make_a_session_last_longer() {
    // A refused command is accepted: it was read.
    let mut driven = Driven::new();
    driven.say(hello(CODE));
    for _ in 0..5 {
        driven.bench.pass(900);
        assert_eq!(reason(&driven.say(command(2000))), Some(Refusal::OutOfOrder));
    }
    driven.say(Message::Arm);
    // Overtaken and repeated ones are not.
    driven.bench.pass(900);
    assert!(driven.deliver(driven.sequence, Message::Arm).is_empty());
    assert!(driven.deliver(1, command(2000)).is_empty());
    driven.bench.pass(100);
    assert!(driven.say(command(2000)).is_empty() && driven.bench.is_idle(), "the session has ended");
}

#[test]
fn accepted_arms_and_refused_commands_do_not_feed_the_watchdog() {
    let driven = Driven::running();
    for _ in 0..11 {
        driven.bench.pass(10);
        driven.deliver(1, command(2000));
    }
    driven.bench.pass(10);
    driven.assert_pulls(0.3);
}

#[test]
fn end_of_a_session_a_frame_after_exactly_one_second_is_too_late() {
    for (ms, alive) in [(999, true), (1000, false)] {
        let mut driven = Driven::running();
        driven.bench.pass(ms);
        assert_eq!(driven.say(command(2000)).len(), usize::from(alive), "{ms} ms");
    }
}

#[test]
fn end_of_a_session_a_restart_ends_it_and_nothing_of_it_remains() {
    let mut driven = Driven::running();
    let before = driven.greet();
    driven.say(Message::Arm);
    driven.bench.order("power-cycle");
    assert!(driven.say(command(2000)).is_empty() && driven.bench.is_idle());
    assert_ne!(driven.greet().boot, before.boot);
}

#[test]
fn clock_of_the_device_restarts_with_it_and_the_driver_s_time_goes_on() {
    let bench = Bench::new(1.0);
    let mut spidar = driver(&bench);
    let before = after(&bench, &mut spidar, 8000).time_s;
    assert!(before > 7.9, "{before} s");
    bench.order("power-cycle");
    let mut last = before;
    for _ in 0..1000 {
        let sample = after(&bench, &mut spidar, 1);
        assert!((0.0..0.3).contains(&(sample.time_s - last)), "{} s after {last} s", sample.time_s);
        last = sample.time_s;
    }
    assert!((last - before - 1.0).abs() < 0.05, "{last} s");
}

#[test]
fn obeyed_is_zero_until_a_command_of_the_session_was_executed() {
    let mut driven = Driven::new();
    driven.sequence = 100;
    for _ in 0..2 {
        driven.greet();
        assert_eq!(driven.sample(Message::Arm).obeyed, 0);
        assert_eq!(driven.sample(command(2000)).obeyed, driven.sequence);
        let executed = driven.sequence;
        assert_eq!(driven.sample(Message::Arm).obeyed, executed, "an arm is no command");
    }
}

#[test]
fn zero_is_no_session_and_an_ordinary_sequence() {
    let mut driven = Driven::new();
    driven.session = 0;
    assert!(driven.say(hello(CODE)).is_empty() && driven.say(Message::Arm).is_empty());
    let driven = Driven::new();
    assert!(matches!(driven.deliver(u32::MAX, hello(CODE))[..], [Message::Caps(_)]));
    assert!(matches!(driven.deliver(0, Message::Arm)[..], [Message::Sample(_)]));
}

#[test]
fn rate_no_hello_and_no_quick_command_is_refused_because_of_it() {
    for rate_hz in [0, 1, u16::MAX] {
        let mut driven = Driven::new();
        let answer = driven.say(Message::Hello(Hello { pairing: CODE, rate_hz }));
        assert!(matches!(answer[..], [Message::Caps(Caps { rate_hz: 1000, .. })]), "{answer:?}");
        driven.say(Message::Arm);
        for mn in 1..=100 {
            let answers = driven.say(command(20 * mn));
            assert!(!answers.iter().any(|a| matches!(a, Message::Refused(_))), "a hundred in the same moment");
        }
        assert_eq!(driven.sample(command(2000)).obeyed, driven.sequence);
        driven.bench.pass(10);
        driven.assert_pulls(2.0);
    }
}

#[test]
fn buttons_reach_the_hand_bit_by_bit() {
    let bench = Bench::new(1.0);
    let mut spidar = driver(&bench);
    after(&bench, &mut spidar, 50);
    for bits in [1, 2, 0b1000_0001, 255, 0] {
        bench.order(&format!("buttons {bits}"));
        assert_eq!(after(&bench, &mut spidar, 2).buttons, bits);
    }
    bench.order("buttons 1");
    after(&bench, &mut spidar, 2);
    bench.order("silence 3600");
    assert_eq!(after(&bench, &mut spidar, 200).buttons, 0, "a lost device presses nothing");
}

#[test]
fn contacts_of_the_jig_one_place_at_a_time_and_none_between_two() {
    let mut driven = Driven::running();
    let seen: Vec<u8> = (0..5000)
        .map(|_| {
            driven.bench.pass(1);
            driven.sample(command(300)).jig
        })
        .collect();
    let mut visited = seen.clone();
    visited.dedup();
    let places = library::devices().unwrap()["spidar-pan-crossed"].jig().len() as u8;
    let expected: Vec<u8> = (1..=places).flat_map(|place| [place, 0]).collect();
    assert_eq!(visited, expected);
}

#[test]
fn kept_calibration_no_two_starts_of_a_device_have_the_same_boot() {
    let boots: std::collections::BTreeSet<u32> = (0..50).map(|_| Driven::new().greet().boot).collect();
    assert!(boots.len() > 48, "{} boots of 50 starts", boots.len());
}

#[test]
fn wait_of_a_refusal_is_the_rest_of_the_session() {
    let mut driven = Driven::running();
    for ms in [0, 250, 500] {
        driven.sample(command(2000));
        driven.bench.pass(ms);
        driven.bench.deliver(&Frame { sequence: 1, session: 9, message: hello(CODE) }, OTHER_PORT);
        let answers = driven.bench.answers(OTHER_PORT);
        let [Message::Refused(Refused { reason: Refusal::Busy, wait_ms, .. })] = answers[..] else {
            panic!("{answers:?}")
        };
        assert_eq!(u64::from(wait_ms), 1000 - ms);
    }
    assert!(matches!(driven.say(command(1))[..], [Message::Sample(_)]));
}
