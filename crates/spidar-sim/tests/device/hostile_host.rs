//! Promise: a hostile second host cannot pull a string, take over, break the link, or find the pairing code.

use saute_haptics::strings::wire::{Command, Frame, Hello, Message, Refusal, Refused};

use crate::memory_link::{Bench, CODE};

const HOST: &str = "10.0.0.1:9000";
const STRANGER: &str = "10.0.0.66:9000";
const SESSION: u32 = 0x51a7_e001;

fn frame(sequence: u32, session: u32, message: Message) -> Frame {
    Frame { sequence, session, message }
}

fn hello(pairing: u32) -> Message {
    Message::Hello(Hello { pairing, rate_hz: 1000 })
}

fn command(mn: u16) -> Message {
    Message::Command(Command { time_us: 0, tension_mn: [mn; 8] })
}

/// A device that a host drives with 2 N on every string; the last sequence number is 12.
fn driven() -> Bench {
    let bench = Bench::new(1.0);
    bench.deliver(&frame(1, SESSION, hello(CODE)), HOST);
    bench.deliver(&frame(2, SESSION, Message::Arm), HOST);
    for sequence in 3..=12 {
        bench.deliver(&frame(sequence, SESSION, command(2000)), HOST);
        bench.pass(1);
    }
    assert_eq!(bench.answers(HOST).len(), 12, "caps and a sample for each other frame");
    bench.pass(8);
    assert_pulls(&bench, 2.0);
    bench
}

fn assert_pulls(bench: &Bench, newtons: f64) {
    let tensions = bench.tensions();
    assert!(tensions.iter().all(|t| (t - newtons).abs() < 0.05), "{tensions:?} instead of {newtons} N");
}

fn refusal(messages: &[Message]) -> Refused {
    match messages {
        [Message::Refused(refused)] => *refused,
        other => panic!("not one refusal: {other:?}"),
    }
}

#[test]
fn commands_are_bound_to_the_address_and_the_session_of_the_greeting_host() {
    let bench = driven();
    for (session, from) in [(SESSION, STRANGER), (SESSION, "10.0.0.1:9001"), (SESSION ^ 1, HOST), (0, STRANGER)] {
        for message in [command(12_000), Message::Arm, Message::Stop] {
            bench.deliver(&frame(1000, session, message), from);
        }
        bench.pass(2);
        assert_pulls(&bench, 2.0);
        assert_eq!(bench.answers(from).len(), 0, "strangers get no answer");
    }
}

#[test]
fn repeated_and_overtaken_commands_are_discarded() {
    let bench = driven();
    bench.deliver(&frame(20, SESSION, command(3000)), HOST);
    for sequence in [3, 12, 19, 20, 20u32.wrapping_sub(1 << 31)] {
        bench.deliver(&frame(sequence, SESSION, command(12_000)), HOST);
    }
    bench.deliver(&frame(19, SESSION, Message::Arm), HOST);
    bench.pass(8);
    assert_pulls(&bench, 3.0);
    assert_eq!(bench.answers(HOST).len(), 1, "one sample for the one that is new");
    // Sequence numbers wrap.
    for sequence in [(1 << 31) + 19, (1 << 31) + (1 << 30), u32::MAX, 4] {
        bench.deliver(&frame(sequence, SESSION, command(4000)), HOST);
    }
    assert_eq!(bench.answers(HOST).len(), 4);
}

#[test]
fn a_delayed_hello_does_not_begin_its_session_again() {
    let bench = driven();
    bench.deliver(&frame(1, SESSION, hello(CODE)), HOST);
    bench.deliver(&frame(30, SESSION, hello(CODE)), HOST);
    bench.pass(1);
    assert_pulls(&bench, 2.0);
    bench.deliver(&frame(31, SESSION + 1, hello(CODE)), HOST);
    assert!(bench.is_idle(), "the host has restarted");
    bench.answers(HOST);
    bench.deliver(&frame(1, SESSION, hello(CODE)), HOST);
    assert_eq!(bench.answers(HOST).len(), 0);
    bench.deliver(&frame(32, SESSION + 1, Message::Arm), HOST);
    assert_eq!(bench.answers(HOST).len(), 1, "the new session goes on");
}

#[test]
fn a_device_is_busy_until_one_second_after_the_last_frame_of_its_host() {
    let bench = driven();
    for (code, number) in [(CODE, 8), (1, 9)] {
        bench.deliver(&frame(1, number, hello(code)), STRANGER);
        let refused = refusal(&bench.answers(STRANGER));
        assert_eq!((refused.reason, refused.version), (Refusal::Busy, 2), "the code is not looked at");
        assert!((985..=1000).contains(&refused.wait_ms), "{} ms", refused.wait_ms);
    }
    bench.pass(105);
    assert_pulls(&bench, 0.3);
    bench.pass(840);
    bench.deliver(&frame(2, 10, hello(CODE)), STRANGER);
    assert_eq!(refusal(&bench.answers(STRANGER)).reason, Refusal::Busy);
    bench.pass(100);
    assert!(bench.is_idle());
    bench.deliver(&frame(3, 11, hello(CODE)), STRANGER);
    assert!(matches!(bench.answers(STRANGER)[..], [Message::Caps(_)]));
    bench.deliver(&frame(100, SESSION, command(12_000)), HOST);
    assert!(bench.is_idle() && bench.answers(HOST).is_empty(), "the old session is over");
}

#[test]
fn at_most_one_wrong_code_per_second_is_looked_at() {
    let bench = Bench::new(1.0);
    let (mut looked_at, mut tries) = (0, 0);
    for second in 0..60u32 {
        for k in 0..1000u32 {
            let code = 100_000 + second * 1000 + k;
            bench.deliver(&frame(k, code, hello(code)), &format!("10.0.{}.{}:77", second % 8, k % 200));
            tries += 1;
            bench.pass(1);
        }
        for host in 0..8 {
            for last in 0..200 {
                let answers = bench.answers(&format!("10.0.{host}.{last}:77"));
                looked_at += answers
                    .iter()
                    .filter(|m| matches!(m, Message::Refused(r) if r.reason == Refusal::WrongCode))
                    .count();
            }
        }
    }
    println!(
        "{looked_at} of {tries} codes were looked at in 60 s: all 900 000 would take {:.1} days",
        900e3 / 86_400.0
    );
    assert!((59..=61).contains(&looked_at), "{looked_at} of {tries} codes in 60 s");
    bench.pass(1000);
    bench.deliver(&frame(9, 5, hello(CODE)), HOST);
    assert!(matches!(bench.answers(HOST)[..], [Message::Caps(_)]), "the right code still pairs");
}

#[test]
fn a_wrong_code_in_the_host_s_name_does_not_end_its_session() {
    let bench = driven();
    bench.deliver(&frame(900, 77, hello(1)), HOST);
    assert_eq!(refusal(&bench.answers(HOST)).reason, Refusal::WrongCode);
    bench.deliver(&frame(13, SESSION, command(2500)), HOST);
    bench.pass(8);
    assert_pulls(&bench, 2.5);
}

#[test]
fn a_hello_of_another_version_is_answered_and_does_not_break_a_running_link() {
    let bench = driven();
    for k in 0..1000 {
        let older = Message::HelloOfVersion1(Hello { pairing: CODE, rate_hz: 1000 });
        bench.deliver(&frame(k, 50, older), if k % 2 == 0 { STRANGER } else { HOST });
        bench.deliver(&frame(13 + k, SESSION, command(2000)), HOST);
        bench.pass(1);
    }
    assert_pulls(&bench, 2.0);
    let refused =
        |m: &&Message| matches!(m, Message::Refused(r) if r.reason == Refusal::OtherVersion && r.version == 2);
    let answers = [bench.answers(STRANGER), bench.answers(HOST)].concat();
    let told = answers.iter().filter(refused).count();
    assert!((1..=11).contains(&told), "{told} answers in a second");
    assert_eq!(answers.len() - told, 1000, "every command was answered");
}

#[test]
fn a_stop_ends_the_session_and_a_lost_one_is_made_up_by_watchdog_and_silence() {
    let bench = driven();
    // Overtaken by a command, a stop still stops.
    bench.deliver(&frame(11, SESSION, Message::Stop), HOST);
    assert!(bench.is_idle());
    bench.deliver(&frame(13, SESSION, command(5000)), HOST);
    bench.deliver(&frame(14, SESSION, Message::Arm), HOST);
    bench.pass(20);
    assert!(bench.is_idle(), "the session is over");
    assert_pulls(&bench, 0.0);
    assert_eq!(bench.answers(HOST).len(), 0);

    let bench = driven();
    bench.pass(110);
    assert_pulls(&bench, 0.3);
    bench.pass(900);
    assert!(bench.is_idle());
    bench.pass(20);
    assert_pulls(&bench, 0.0);
}

#[test]
fn an_old_stop_does_not_stop_a_new_session() {
    let bench = driven();
    bench.deliver(&frame(13, SESSION, Message::Stop), HOST);
    bench.deliver(&frame(16, SESSION + 9, hello(CODE)), HOST);
    bench.deliver(&frame(17, SESSION + 9, Message::Arm), HOST);
    bench.deliver(&frame(14, SESSION, Message::Stop), HOST);
    bench.deliver(&frame(15, SESSION, Message::Stop), HOST);
    assert!(!bench.is_idle());
}

#[test]
fn a_tension_outside_the_range_becomes_the_nearest_within_it() {
    let bench = driven();
    bench.deliver(&frame(13, SESSION, command(0)), HOST);
    bench.pass(10);
    assert_pulls(&bench, 0.3);
    bench.deliver(&frame(14, SESSION, command(u16::MAX)), HOST);
    bench.pass(12);
    assert_pulls(&bench, 12.0);
}
