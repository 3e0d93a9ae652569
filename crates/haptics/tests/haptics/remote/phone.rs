//! Promise: a phone moves the pan only after pairing, tosses it, and no message breaks the server; without a phone the pan returns home.

use std::net::SocketAddr;
use std::time::{Duration, Instant};

use glam::{DQuat, DVec3};
use proptest::prelude::*;
use saute_haptics::control::rumble::Rumble;
use saute_haptics::device::{HapticCommand, HapticSample};
use saute_haptics::open::Reach;
use saute_haptics::remote::phone::message::{FromPhone, Measured};
use saute_haptics::remote::phone::orientation::{Level, acceleration, from_angles};
use saute_haptics::remote::phone::toss::Toss;
use saute_haptics::remote::tilt::within_tilt;
use saute_haptics::{Health, Opened, open};

use super::phone_client::{PhoneClient, connect, get};

const DT: f64 = 4e-3;

struct Bench {
    opened: Opened,
    address: SocketAddr,
    code: String,
}

fn bench() -> Bench {
    let opened = open("phone@127.0.0.1:0", 0).unwrap();
    let address = opened.access.place.parse().unwrap();
    let code = opened.access.code.clone().unwrap();
    Bench { opened, address, code }
}

impl Bench {
    /// Exchanges in real time until a condition is met, for at most a minute.
    fn until(&mut self, command: &HapticCommand, mut seen: impl FnMut(&HapticSample) -> bool) -> Option<HapticSample> {
        let begun = Instant::now();
        while begun.elapsed() < Duration::from_secs(60) {
            let sample = self.opened.device.exchange(command, DT);
            if seen(&sample) {
                return Some(sample);
            }
            std::thread::sleep(Duration::from_secs_f64(DT));
        }
        None
    }

    fn wrong_code(&self) -> String {
        let number: u32 = self.code.parse().unwrap();
        format!("{:06}", (number + 1) % 1_000_000)
    }
}

fn motion(turn: [f64; 3]) -> String {
    format!(r#"{{"kind":"motion","turn":{turn:?}}}"#)
}

fn tilt(sample: &HapticSample) -> f64 {
    (sample.pose.rotation * DVec3::Z).angle_between(DVec3::Z).to_degrees()
}

#[test]
fn by_default_the_page_is_served_by_tls_to_this_machine_alone() {
    let bench = bench();
    assert_eq!(bench.opened.access.reach, Reach::ThisMachine);
    let said = bench.opened.access.lines().join("\n");
    assert!(
        said.contains("this machine alone") && said.contains(&bench.code) && said.contains("https://127.0.0.1:"),
        "{said}"
    );
    let page = get(bench.address, "/");
    assert!(page.starts_with("HTTP/1.1 200 OK") && page.ends_with("</html>\n"), "{}", &page[..200.min(page.len())]);
    assert!(page.contains("Content-Security-Policy: default-src 'none'") && page.contains("X-Frame-Options: DENY"));
    assert!(get(bench.address, "/other").starts_with("HTTP/1.1 404"));
}

#[test]
fn a_device_on_all_interfaces_is_stated_to_be_open_to_the_network() {
    let opened = open("phone@0.0.0.0:0", 0).unwrap();
    assert_eq!(opened.access.reach, Reach::Network);
    let said = opened.access.lines().join("\n");
    assert!(said.contains("open to the network") && !opened.access.url.unwrap().contains("0.0.0.0"), "{said}");
}

#[test]
fn after_the_code_the_pan_follows_the_phone_s_tilt() {
    let mut bench = bench();
    let mut phone = PhoneClient::connect(bench.address);
    phone.pair(&bench.code);
    phone.send(&motion([40.0, 0.0, 0.0]));
    phone.send(&motion([40.0, 20.0, 0.0]));
    let command = HapticCommand::default();
    let sample = bench.until(&command, |s| (tilt(s) - 20.0).abs() < 0.5).expect("the pan follows");
    assert_eq!(sample.health, Health::Running);
    let up = sample.pose.rotation * DVec3::Z;
    assert!(up.y < -0.3 && up.x.abs() < 0.01, "the phone's top was raised, so the pan leans towards the cook: {up}");
    phone.send(r#"{"kind":"flat"}"#);
    assert_eq!(phone.receive("flat").unwrap()["taken"], true);
    phone.send(&motion([40.0, 20.0, 0.0]));
    assert!(bench.until(&command, |s| tilt(s) < 0.5).is_some(), "20° are level now");
}

#[test]
fn a_wrong_code_is_refused_and_moves_nothing_and_the_next_attempt_must_wait() {
    let mut bench = bench();
    let mut phone = PhoneClient::connect(bench.address);
    phone.send(&motion([0.0, 30.0, 0.0]));
    phone.send(&format!(r#"{{"kind":"hello","code":"{}"}}"#, bench.wrong_code()));
    assert_eq!(phone.receive("refused").unwrap()["wait_s"], 1.0);
    phone.send(&motion([0.0, 30.0, 0.0]));
    phone.send(&format!(r#"{{"kind":"hello","code":"{}"}}"#, bench.code));
    assert!(phone.receive("refused").unwrap()["wait_s"].as_f64() > Some(0.5), "the right code too soon");
    let command = HapticCommand::default();
    let seen = bench.until(&command, |s| s.rejected >= 4).expect("refused messages are counted");
    assert!(seen.health == Health::Connecting && tilt(&seen) == 0.0 && seen.pose.position == DVec3::ZERO);
}

#[test]
fn another_site_s_page_cannot_open_the_socket() {
    let bench = bench();
    assert!(PhoneClient::from(bench.address, "https://evil.example").is_err());
    assert!(PhoneClient::from(bench.address, &format!("http://{}", bench.address)).is_err());
}

#[test]
fn a_disconnected_phone_is_lost_its_pan_returns_home_and_it_reconnects() {
    let mut bench = bench();
    let command = HapticCommand::default();
    let mut phone = PhoneClient::connect(bench.address);
    phone.pair(&bench.code);
    phone.send(&motion([0.0, 0.0, 0.0]));
    phone.send(&motion([0.0, 40.0, 0.0]));
    bench.until(&command, |s| tilt(s) > 39.0).expect("tilted");
    drop(phone);
    let mut steepest = 0.0f64;
    let lost = bench.until(&command, |s| s.health == Health::Lost).expect("lost");
    let mut before = tilt(&lost);
    bench.until(&command, |s| {
        steepest = steepest.max(before - tilt(s));
        before = tilt(s);
        before < 1.0
    });
    assert!(before < 1.0 && steepest < 1.0, "home at {before}°, no jump above {steepest}° a step");
    let mut again = PhoneClient::connect(bench.address);
    again.pair(&bench.code);
    again.send(&motion([0.0, 0.0, 0.0]));
    assert!(bench.until(&command, |s| s.health == Health::Running).is_some());
}

#[test]
fn the_button_of_a_lost_phone_stays_released_when_it_returns() {
    let mut bench = bench();
    let command = HapticCommand::default();
    let mut phone = PhoneClient::connect(bench.address);
    phone.pair(&bench.code);
    phone.send(r#"{"kind":"button","down":true}"#);
    phone.send(&motion([0.0; 3]));
    bench.until(&command, |s| s.buttons == 1).expect("pressed");
    let lost = bench.until(&command, |s| s.health == Health::Lost).expect("silent for half a second");
    assert_eq!(lost.buttons, 0);
    phone.send(&motion([0.0; 3]));
    let back = bench.until(&command, |s| s.health == Health::Running).expect("the same phone");
    assert_eq!(back.buttons, 0, "not pressed again");
    phone.send(r#"{"kind":"button","down":true}"#);
    phone.send(&motion([0.0; 3]));
    bench.until(&command, |s| s.buttons == 1).expect("pressed again");
    let mut second = PhoneClient::connect(bench.address);
    second.pair(&bench.code);
    second.send(&motion([0.0; 3]));
    bench.until(&command, |s| s.health == Health::Running && s.buttons == 0).expect("the other phone presses nothing");
}

#[test]
fn rumble_reaches_the_phone_and_the_phone_that_was_paired_last_moves_the_pan() {
    let mut bench = bench();
    let mut first = PhoneClient::connect(bench.address);
    first.pair(&bench.code);
    first.send(&motion([0.0, 0.0, 0.0]));
    let shake =
        HapticCommand { enabled: true, rumble: Rumble { strong: 0.75, weak: 0.25 }, ..HapticCommand::default() };
    bench.until(&shake, |s| s.health == Health::Running).expect("running");
    bench.opened.device.exchange(&shake, DT);
    let pan = std::iter::from_fn(|| first.receive("pan")).find(|m| m["strong"] == 0.75).unwrap();
    assert_eq!(pan["weak"], 0.25);
    let mut second = PhoneClient::connect(bench.address);
    second.pair(&bench.code);
    assert!(first.receive("replaced").is_some());
}

#[test]
fn garbage_of_every_kind_is_counted_and_survived() {
    let mut bench = bench();
    let mut raw = std::net::TcpStream::connect(bench.address).unwrap();
    std::io::Write::write_all(&mut raw, &[0x47; 4000]).unwrap();
    let mut half = connect(bench.address);
    let _ = std::io::Write::write_all(&mut half, b"GET / HT");
    let mut phone = PhoneClient::connect(bench.address);
    phone.pair(&bench.code);
    let deep = "[".repeat(900);
    let bad = [
        "",
        "{",
        "null",
        "{\"kind\":\"motion\"}",
        r#"{"kind":"motion","turn":[1e999,0,0]}"#,
        r#"{"kind":"fire"}"#,
        &deep,
    ];
    bad.iter().for_each(|text| phone.send(text));
    phone.send(&motion([400.0, 0.0, 0.0]));
    let _ = phone.0.send(tungstenite::Message::binary(vec![0xff; 100]));
    let command = HapticCommand::default();
    let seen = bench.until(&command, |s| s.rejected >= 9).expect("nine are counted");
    assert_eq!(seen.health, Health::Connecting, "none was motion");
    phone.send(&motion([0.0, 0.0, 0.0]));
    assert!(bench.until(&command, |s| s.health == Health::Running).is_some(), "and it still works");
    phone.send(&"x".repeat(5000));
    assert!(phone.receive("never").is_none(), "an oversized message ends the session");
    let mut again = PhoneClient::connect(bench.address);
    again.pair(&bench.code);
    for _ in 0..400 {
        again.send(&motion([0.0, 5.0, 0.0]));
    }
    let flooded = bench.until(&command, |s| s.rejected > 100).expect("messages above the rate limit are rejected");
    assert!(tilt(&flooded) < 6.0, "{flooded:?}");
}

#[test]
fn pings_count_against_the_rate_limit() {
    let mut bench = bench();
    let mut phone = PhoneClient::connect(bench.address);
    for _ in 0..300 {
        let _ = phone.0.send(tungstenite::Message::Ping(Default::default()));
    }
    bench.until(&HapticCommand::default(), |s| s.rejected >= 100).expect("a burst of sixty, then 180 per second");
}

#[test]
fn the_port_is_free_as_soon_as_the_device_is_dropped_and_a_used_port_is_named() {
    let first = bench();
    let mut phone = PhoneClient::connect(first.address);
    phone.pair(&first.code);
    let text = format!("phone@{}", first.address);
    let taken = open(&text, 0).err().unwrap().to_string();
    assert!(taken.contains(&first.address.to_string()) && taken.contains("remedy"), "{taken}");
    drop(first);
    assert!(open(&text, 0).is_ok(), "the port stays in use");
}

#[test]
fn a_toss_rises_and_leaks_home_and_a_sensor_s_offset_has_no_lasting_effect() {
    let half = DVec3::new(0.15, 0.15, 0.2);
    let run = |toss: &mut Toss, push: f64, seconds: f64| {
        (0..(seconds / 1e-3) as u32).for_each(|_| toss.step(Some(DVec3::Z * push), half, 1e-3));
        toss.place.z
    };
    let mut toss = Toss::default();
    run(&mut toss, 8.0, 0.12);
    let top = run(&mut toss, -8.0, 0.12);
    assert!((0.08..0.115).contains(&top), "three quarters of the double integral of 115 mm: {top}");
    assert!(run(&mut toss, 0.0, 4.0).abs() < 0.01, "home after four seconds");
    let mut skewed = Toss::default();
    run(&mut skewed, 0.2, 20.0);
    assert!(skewed.place.length() < 2e-3, "{:?}", skewed.place);
    assert!((run(&mut Toss::default(), 150.0, 3.0) - 0.2).abs() < 1e-9, "it stops at the bound");
}

#[test]
fn angles_are_converted_to_the_cook_s_directions_for_any_heading() {
    for alpha in [0.0, 90.0, 200.0, 350.0] {
        let mut level = Level::default();
        assert!((level.pan(from_angles([alpha, 0.0, 0.0])) * DVec3::Y - DVec3::Y).length() < 1e-9);
        let right = level.pan(from_angles([alpha, 0.0, 30.0])) * DVec3::Z;
        assert!((right.x - 0.5).abs() < 1e-9 && right.y.abs() < 1e-9, "right edge down leans right: {right}");
        assert!(!level.clone().set(from_angles([alpha, 80.0, 0.0])), "too steep for level");
    }
}

#[test]
fn accelerations_agree_on_systems_with_the_opposite_sign() {
    let phone = from_angles([10.0, 25.0, -15.0]);
    let up = phone.conjugate() * DVec3::Z;
    let push = DVec3::new(1.0, -2.0, 3.0);
    let felt = push + up * 9.80665;
    let measured = |push: Option<DVec3>, felt: Option<DVec3>| Measured {
        turn: [0.0; 3],
        push: push.map(|v| v.to_array()),
        felt: felt.map(|v| v.to_array()),
    };
    for m in [
        measured(Some(push), Some(felt)),
        measured(Some(-push), Some(-felt)),
        measured(None, Some(felt)),
        measured(None, Some(-felt)),
        measured(Some(push), None),
    ] {
        assert!((acceleration(&m, phone).unwrap() - push).length() < 1e-9, "{m:?}");
    }
    assert_eq!(acceleration(&measured(None, None), phone), None);
}

proptest! {
    #[test]
    fn no_text_makes_the_parser_panic(text in "\\PC{0,200}") {
        let _ = FromPhone::parse(&text);
    }

    #[test]
    fn every_accepted_motion_rotates_the_pan_within_its_bounds(turn in prop::array::uniform3(-1e3..1e3f64), push in prop::array::uniform3(-1e3..1e3f64)) {
        let text = format!(r#"{{"kind":"motion","turn":{turn:?},"push":{push:?}}}"#);
        if let Ok(FromPhone::Motion(measured)) = FromPhone::parse(&text) {
            let phone = from_angles(measured.turn);
            let pan = within_tilt(Level::default().pan(phone), 1.0);
            prop_assert!(pan.is_finite() && (pan * DVec3::Z).angle_between(DVec3::Z) < 1.0 + 1e-6);
            prop_assert!(acceleration(&measured, phone).unwrap().length() < 400.0);
        } else {
            prop_assert!(turn.iter().any(|v| v.abs() > 360.0) || push.iter().any(|v| v.abs() > 200.0));
        }
    }

    #[test]
    fn the_tilt_limit_keeps_smaller_tilts(angle in 0.0..3.1f64) {
        let rotation = DQuat::from_axis_angle(DVec3::new(0.6, 0.8, 0.0), angle);
        let bound = within_tilt(rotation, 1.0);
        prop_assert!(((bound * DVec3::Z).angle_between(DVec3::Z) - angle.min(1.0)).abs() < 1e-6);
    }
}
