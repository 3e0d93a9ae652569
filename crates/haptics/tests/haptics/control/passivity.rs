//! Promise: the hand never receives more energy than it gave, in spite of delays, errors and NaN.

use std::collections::VecDeque;

use glam::{DMat3, DVec3};
use saute_haptics::control::coupled_payload::CoupledPayload;
use saute_haptics::control::passivity::Passivity;
use saute_haptics::control::safety_limits::SafetyLimits;
use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Health};
use saute_haptics::kitchen::contact_model::{ContactModel, Payload};
use saute_haptics::{Capabilities, Pose, Renderer, Twist, WeightOnSpring, Wrench, library};

use crate::random::device;

const DT: f64 = 1e-3;
const RESERVE: f64 = 5e-3;

fn strings() -> Capabilities {
    device("spidar-pan-crossed").capabilities()
}

fn along(x: f64) -> Wrench {
    Wrench { force: DVec3::X * x, ..Wrench::ZERO }
}

fn at(x: f64, speed: f64) -> HapticSample {
    HapticSample {
        pose: Pose::at(x, 0.0, 0.1),
        twist: Twist { linear: DVec3::X * speed, ..Twist::default() },
        health: Health::Running,
        fresh: true,
        ..HapticSample::default()
    }
}

#[test]
fn a_force_costs_its_displacement_and_a_torque_its_rotation() {
    let mut passivity = Passivity::new(RESERVE, 50.0);
    passivity.observe(&Pose::default(), &Wrench::ZERO, 0.0, DT);
    passivity.shown(&Wrench { force: DVec3::X * 2.0, torque: DVec3::Z * 0.5 }, &Wrench::ZERO);
    let spent = passivity.observe(&Pose::at(1e-3, 5e-3, 0.0).turned(DVec3::Z, 2e-3), &Wrench::ZERO, 0.0, DT);
    assert!((spent - 3e-3).abs() < 1e-12 && (passivity.account() - 2e-3).abs() < 1e-12, "{spent}");
}

#[test]
fn nan_empties_the_account_instead_of_filling_it() {
    let nan = DVec3::splat(f64::NAN);
    let filled = || {
        let mut passivity = Passivity::new(RESERVE, 50.0);
        passivity.observe(&Pose::default(), &Wrench::ZERO, 0.0, DT);
        passivity.shown(&along(1.0), &Wrench::ZERO);
        passivity
    };
    let mut place = filled();
    place.observe(&Pose { position: nan, ..Pose::default() }, &Wrench::ZERO, 0.0, DT);
    assert!((place.account() - 0.5 * RESERVE).abs() < 1e-12, "{}", place.account());
    let mut held = filled();
    held.observe(&Pose::at(-10.0, 0.0, 0.0), &Wrench::ZERO, f64::NAN, DT);
    assert!((held.account() - 20.0 * RESERVE).abs() < 1e-12, "{}", held.account());
    let mut made = filled();
    made.observe(&Pose::default(), &Wrench { force: nan, ..Wrench::ZERO }, 0.0, DT);
    assert!(made.account() <= RESERVE && made.account().is_finite(), "{}", made.account());
    let mut shown = filled();
    shown.shown(&Wrench { force: nan, ..Wrench::ZERO }, &Wrench::ZERO);
    shown.observe(&Pose::at(1.0, 0.0, 0.0), &Wrench::ZERO, 0.0, DT);
    assert_eq!(shown.account(), RESERVE, "nothing was rendered");
}

#[test]
fn contents_are_rendered_again_after_nan() {
    let feel = library::feel().unwrap();
    let good = Payload { mass: 0.5, centre: DVec3::ZERO, inertia: DMat3::IDENTITY * 1e-3 };
    let nan = DVec3::splat(f64::NAN);
    let (still, calm) = (Pose::default(), Twist::default());
    let broken = [
        (Payload { inertia: DMat3::IDENTITY * f64::NAN, ..good }, still, calm),
        (good, Pose { position: nan, ..still }, calm),
        (good, still, Twist { angular: nan, ..calm }),
    ];
    for (payload, pose, twist) in broken {
        let mut contents = CoupledPayload::new(&feel.payload, &strings());
        contents.step(&good, &still, &calm, DT);
        assert!(contents.step(&payload, &pose, &twist, DT).felt.is_finite());
        let felt = (0..500).map(|_| contents.step(&good, &still, &calm, DT).felt).last().unwrap();
        assert!((felt.force.z + 0.5 * 9.80665).abs() < 1e-3 && contents.held().is_finite(), "{felt:?}");
    }
}

#[test]
fn a_device_without_a_valid_pose_gets_no_force() {
    let mut renderer = Renderer::new(&strings(), &library::feel().unwrap());
    let mut step = |number: u64, sample: &HapticSample| {
        let payload = Payload::point(0.5, DVec3::ZERO);
        renderer.step(sample, &ContactModel { number, payload, ..ContactModel::default() }, DT)
    };
    (1..800).for_each(|k| assert!(step(k, &at(0.0, 0.0)).enabled));
    let lost = [at(f64::NAN, 0.0), at(0.0, f64::NAN)];
    assert!(lost.iter().all(|sample| step(801, sample) == HapticCommand::default()));
    let back = (802..1600).map(|k| step(k, &at(0.0, 0.0))).last().unwrap();
    assert!((back.wrench.force.z + 4.9).abs() < 0.05, "{back:?}");
}

/// A world that pushes to the right for the whole run.
fn pushing(number: u64, force: f64) -> ContactModel {
    ContactModel { number, loose: along(force), ..ContactModel::default() }
}

#[test]
fn a_velocity_that_lags_hides_no_energy_from_the_account() {
    // The pan moves to the right at 0.5 m/s; the device reports zero velocity all the time.
    let mut renderer = Renderer::new(&strings(), &library::feel().unwrap());
    let (mut given, mut force) = (0.0, 0.0);
    for k in 1..2000u64 {
        let way = 0.5 * DT;
        given += force * way;
        force = renderer.step(&at(way * k as f64, 0.0), &pushing(k, 5.0), DT).wrench.force.x;
    }
    assert!(given < 1.2 * RESERVE, "{given} J given to the hand");
}

#[test]
fn a_spring_with_a_delayed_measurement_gives_no_more_than_the_reserve() {
    // Reported pose and velocity are 3 ms old, and the velocity has a bandwidth of 40 Hz like that of strings.
    let mut renderer = Renderer::new(&strings(), &library::feel().unwrap());
    let (mut arm, mut command) = (WeightOnSpring::default(), HapticCommand::default());
    let (mut given, mut before, mut smooth) = (0.0, DVec3::Z * 0.1, DVec3::ZERO);
    let mut late: VecDeque<HapticSample> = VecDeque::new();
    for k in 1..20_000u64 {
        let now = arm.exchange(&command, DT);
        given += command.wrench.force.dot(now.pose.position - before);
        before = now.pose.position;
        smooth += (now.twist.linear - smooth) * (1.0 - (-DT * std::f64::consts::TAU * 40.0).exp());
        late.push_back(HapticSample { twist: Twist { linear: smooth, ..Twist::default() }, ..now });
        let sample = if late.len() > 3 { late.pop_front().unwrap() } else { late[0] };
        let kick = if k == 700 { 25.0 } else { 0.0 };
        let spring = sample.pose.position.x * -1500.0;
        command = renderer.step(&sample, &pushing(k, spring + kick), DT);
    }
    assert!(given < 2.0 * RESERVE && before.length() < 0.2, "{given} J given to the hand, which is at {before}");
    assert!(renderer.passivity().lowest() >= 0.0, "{} J", renderer.passivity().lowest());
}

#[test]
fn a_device_that_makes_more_than_the_command_is_charged_for_what_it_made() {
    let left = |made: Wrench| {
        let mut passivity = Passivity::new(RESERVE, 50.0);
        let weight = Wrench { force: DVec3::NEG_Z * 5.0, ..Wrench::ZERO };
        passivity.observe(&Pose::default(), &Wrench::ZERO, 0.0, DT);
        passivity.shown(&along(2.0), &weight);
        passivity.observe(&Pose::at(1e-3, 0.0, 1e-3), &made, 0.0, DT);
        passivity.account()
    };
    let made = |x: f64| Wrench { force: DVec3::new(x, 0.0, -5.0), ..Wrench::ZERO };
    assert!((left(made(3.0)) - 2e-3).abs() < 1e-12, "more than commanded");
    assert!((left(made(1.0)) - 3e-3).abs() < 1e-12, "a report below the command is not credited");
    assert!((left(Wrench::ZERO) - 3e-3).abs() < 1e-12, "a device that reports nothing");
}

#[test]
fn touching_a_wall_that_the_device_is_too_weak_for_costs_nothing() {
    // The command is a spring of 1000 N/m, of which the device makes at most 2 N; a force held at the middle of its step is conservative.
    let mut passivity = Passivity::new(RESERVE, 50.0);
    let place = |k: u32| 5e-3 * (f64::from(k) * 0.01).sin();
    let spring = |k: u32| -1000.0 * 0.5 * (place(k) + place(k + 1));
    passivity.observe(&Pose::default(), &Wrench::ZERO, 0.0, DT);
    for k in 0..10_000 {
        passivity.shown(&along(spring(k)), &Wrench::ZERO);
        passivity.observe(&Pose::at(place(k + 1), 0.0, 0.0), &along(spring(k).clamp(-2.0, 2.0)), 0.0, DT);
    }
    assert!(passivity.lowest() > 0.95 * RESERVE, "{} J", passivity.lowest());
}

#[test]
fn energy_is_limited_by_what_was_given_not_by_what_was_commanded() {
    let mut limits = SafetyLimits::new(strings().limits);
    let twist = Twist { linear: DVec3::X, ..Twist::default() };
    let wanted = along(20.0);
    for _ in 0..1000 {
        limits.charge(0.0, 0.0, DT);
        assert_eq!(limits.within_energy(&wanted, &twist, DT), wanted, "nothing was given");
    }
    for _ in 0..1000 {
        limits.charge(0.02, 0.02, DT);
        assert_eq!(limits.within_energy(&wanted, &twist, DT), wanted, "the hand's own energy returns");
    }
    (0..100).for_each(|_| limits.charge(0.02, 0.0, DT));
    assert_eq!(limits.within_energy(&wanted, &twist, DT), Wrench::ZERO, "2 J within 0.1 s");
    assert_eq!(limits.within_energy(&(wanted * -1.0), &twist, DT), wanted * -1.0, "dissipation is free");
    (0..3000).for_each(|_| limits.charge(0.0, 0.0, DT));
    assert_eq!(limits.within_energy(&wanted, &twist, DT), wanted, "later");
}

#[test]
fn contents_do_not_keep_moving_after_a_pause() {
    let mut renderer = Renderer::new(&strings(), &library::feel().unwrap());
    let mut step = |number: u64, sample: &HapticSample| {
        let payload = Payload::point(0.6, DVec3::ZERO);
        renderer.step(sample, &ContactModel { number, payload, ..ContactModel::default() }, DT)
    };
    assert!((1..1000).all(|k| step(k, &at(k as f64 * DT, 1.0)).enabled));
    let lost = HapticSample { health: Health::Lost, ..at(1.0, 0.0) };
    assert!((1000..1100).all(|k| step(k, &lost) == HapticCommand::default()));
    let sideways = (1100..1600).map(|k| step(k, &at(1.0, 0.0)).wrench.force.x.abs()).fold(0.0, f64::max);
    assert!(sideways < 1e-9, "{sideways} N in a hand at rest");
}
