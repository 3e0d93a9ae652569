//! Promise: an Inverse3 at its maker's service moves the pan with limited forces and reconnects; no answer breaks the driver.

use std::time::{Duration, Instant};

use glam::DVec3;
use proptest::prelude::*;
use saute_haptics::device::{HapticCommand, HapticSample};
use saute_haptics::remote::haply::message::State;
use saute_haptics::{Health, Opened, Rendering, Wrench, open};

use super::inverse_service::InverseService;

/// Longest wait for what must come (chosen: a machine that is busy with much else).
const PATIENCE: Duration = Duration::from_secs(60);

fn until(
    opened: &mut Opened,
    command: &HapticCommand,
    mut seen: impl FnMut(&HapticSample) -> bool,
) -> Option<HapticSample> {
    exchange_for(PATIENCE, opened, command, &mut seen)
}

/// Exchanges commands until a condition is true; none if it does not for so long.
fn exchange_for(
    longest: Duration,
    opened: &mut Opened,
    command: &HapticCommand,
    seen: &mut dyn FnMut(&HapticSample) -> bool,
) -> Option<HapticSample> {
    let begun = Instant::now();
    while begun.elapsed() < longest {
        let sample = opened.device.exchange(command, 1e-3);
        if seen(&sample) {
            return Some(sample);
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    None
}

fn push(force: DVec3) -> HapticCommand {
    HapticCommand { wrench: Wrench { force, torque: DVec3::X * 9.0 }, enabled: true, ..HapticCommand::default() }
}

fn running(service: &InverseService) -> Opened {
    let mut opened = open(&format!("haply@{}", service.address), 0).unwrap();
    until(&mut opened, &push(DVec3::ZERO), |s| s.health == Health::Running).expect("running");
    opened
}

#[test]
fn the_pan_follows_the_cursor_in_the_kitchen_s_directions() {
    let service = InverseService::start();
    let mut opened = running(&service);
    assert_eq!(opened.device.capabilities().rendering(), Rendering::Force);
    let first = service.first_message().unwrap();
    assert_eq!(first["session"]["configure"]["profile"]["name"], "saute");
    assert_eq!(first["inverse3"][0]["configure"]["preset"]["preset"], "arm_front_centered");
    service.put(DVec3::new(0.03, -0.05, 0.02));
    let there = DVec3::new(0.03, -0.05, 0.12);
    let sample =
        until(&mut opened, &push(DVec3::ZERO), |s| (s.pose.position - there).length() < 1e-9).expect("follows");
    assert_eq!(sample.twist.linear, DVec3::X * 0.1);
    let before = service.felt().2;
    until(&mut opened, &push(DVec3::ZERO), |_| service.felt().2 > before + 200).expect("messages continue");
}

#[test]
fn forces_arrive_without_torques_and_never_above_the_limit() {
    let service = InverseService::start();
    let mut opened = running(&service);
    let wanted = DVec3::new(1.0, -2.0, 0.5);
    until(&mut opened, &push(wanted), |_| (service.felt().0 - wanted).length() < 1e-9).expect("the force arrives");
    for force in [1e3, f64::INFINITY, f64::NAN] {
        let before = service.felt().2;
        until(&mut opened, &push(DVec3::Z * force), |_| service.felt().2 > before + 50).expect("commands arrive");
        assert!(service.felt().1 <= 6.0 + 1e-9, "{} N for {force}", service.felt().1);
    }
    until(&mut opened, &HapticCommand { enabled: false, ..push(wanted) }, |_| service.felt().0 == DVec3::ZERO)
        .expect("let go");
}

#[test]
fn a_stopped_loop_makes_no_force() {
    let service = InverseService::start();
    let mut opened = running(&service);
    until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0.z > 2.9).expect("pushed");
    await_zero(&service);
    until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0.z > 2.9).expect("pushed again");
    opened.device.stop();
    let stopped = until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0 == DVec3::ZERO).expect("let go");
    assert_eq!(stopped.health, Health::Stopped);
}

#[test]
fn dropping_a_device_releases_its_force_before_the_program_continues() {
    let service = InverseService::start();
    let mut opened = running(&service);
    until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0.z > 2.9).expect("pushed");
    drop(opened);
    assert_eq!(service.felt().0, DVec3::ZERO);
}

#[test]
fn an_interrupted_session_ends_with_zero_force() {
    let service = InverseService::start();
    let mut opened = running(&service);
    until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0.z > 2.9).expect("pushed");
    service.babble(&[&"x".repeat(100_000)]);
    // Without exchanges there is no reconnection, and no command that could become stale after the session's end.
    await_zero(&service);
}

/// Waits until the service makes no force; no command is exchanged meanwhile.
fn await_zero(service: &InverseService) {
    let begun = Instant::now();
    while service.felt().0 != DVec3::ZERO {
        assert!(begun.elapsed() < PATIENCE, "still {} N", service.felt().0.z);
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn a_service_that_drips_bytes_gets_a_zero_force_as_the_next_and_last_word() {
    let service = InverseService::start();
    let mut opened = running(&service);
    until(&mut opened, &push(DVec3::Z * 3.0), |_| service.felt().0.z > 2.9).expect("pushed");
    service.drip();
    // The loop goes on pushing, but the session is over; the dripping lasts for two seconds.
    until(&mut opened, &push(DVec3::Z * 3.0), |s| s.health == Health::Lost).expect("lost");
    let heard = service.heard();
    let last_push = heard.iter().rposition(|(_, force)| *force != DVec3::ZERO).unwrap();
    let zero = heard.get(last_push + 1).expect("a zero force follows");
    let took = zero.0 - heard[last_push].0;
    println!("zero force {took:?} after the last one");
    // On a quiet machine; scripts/campaign.sh requires it.
    assert!(std::env::var_os("SAUTE_CAMPAIGN").is_none() || took < Duration::from_millis(50), "{took:?}");
    assert_eq!(heard.len(), last_push + 2, "it is the last word");
}

#[test]
fn a_lost_service_is_reconnected() {
    let service = InverseService::start();
    let mut opened = running(&service);
    service.hang_up(true);
    let lost = until(&mut opened, &push(DVec3::Z), |s| s.health == Health::Lost).expect("lost");
    assert_eq!(lost.achieved, Wrench::ZERO);
    service.hang_up(false);
    until(&mut opened, &push(DVec3::Z), |s| s.health == Health::Running).expect("back by itself");
}

#[test]
fn a_missing_service_is_awaited_and_an_uncalibrated_device_is_reported() {
    let free = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    let mut opened = open(&format!("haply@{free}"), 0).unwrap();
    // Longer than an attempt takes.
    let awaits = Duration::from_secs(2);
    assert!(exchange_for(awaits, &mut opened, &push(DVec3::Z), &mut |s| s.health != Health::Connecting).is_none());
    let service = InverseService::at(free);
    service.calibrate(false);
    until(&mut opened, &push(DVec3::Z), |s| s.health == Health::Uncalibrated).expect("reported");
    assert_eq!(service.felt().1, 0.0, "no force before the calibration");
    service.calibrate(true);
    until(&mut opened, &push(DVec3::Z), |s| s.health == Health::Running).expect("running");
}

#[test]
fn a_grip_rotates_the_pan_relative_to_its_level() {
    let service = InverseService::start();
    service.hold([0.5f64.sqrt(), 0.5f64.sqrt(), 0.0, 0.0], [false; 3]);
    let mut opened = running(&service);
    let tilted = |s: &HapticSample| (s.pose.rotation * DVec3::Z).angle_between(DVec3::Z).to_degrees();
    until(&mut opened, &push(DVec3::ZERO), |s| tilted(s) < 1e-6).expect("the first orientation is level");
    let half = 65f64.to_radians();
    service.hold([half.cos(), half.sin(), 0.0, 0.0], [true, false, true]);
    let sample = until(&mut opened, &push(DVec3::ZERO), |s| (tilted(s) - 40.0).abs() < 1e-6).expect("turns");
    assert_eq!(sample.buttons, 0b101);
    service.hold([half.cos(), half.sin(), 0.0, 0.0], [false, true, false]);
    until(&mut opened, &push(DVec3::ZERO), |s| tilted(s) < 1e-6).expect("button b sets the level");
}

#[test]
fn garbage_is_counted_and_survived() {
    let service = InverseService::start();
    let mut opened = running(&service);
    let far = r#"{"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":1e9,"y":0,"z":0}}}]}"#;
    let turned = r#"{"verse_grip":[{"state":{"orientation":{"w":0,"x":0,"y":0,"z":0}}}]}"#;
    service.babble(&["", "{", "[1,2]", "null", far, turned, r#"{"inverse3":[{"device_id":5}]}"#]);
    let seen = until(&mut opened, &push(DVec3::ZERO), |s| s.rejected >= 7).expect("seven are counted");
    assert!(seen.pose.position.length() < 1.0, "{seen:?}");
    until(&mut opened, &push(DVec3::ZERO), |s| s.health == Health::Running && s.fresh).expect("and it goes on");
    service.babble(&[&"x".repeat(100_000)]);
    until(&mut opened, &push(DVec3::ZERO), |s| s.rejected >= 8).expect("too long");
    until(&mut opened, &push(DVec3::ZERO), |s| s.health == Health::Running && s.fresh).expect("found again");
}

proptest! {
    #[test]
    fn every_accepted_position_is_finite_and_in_range(text in "\\PC{0,300}", x in proptest::num::f64::ANY) {
        let _ = State::parse(&text);
        let text = format!(r#"{{"inverse3":[{{"device_id":"a","state":{{"cursor_position":{{"x":{x:?}}}}}}}]}}"#);
        if let Ok(state) = State::parse(&text) {
            prop_assert!(state.inverse3[0].state.unwrap().cursor_position.vector().length() <= 1.0);
        }
    }
}
