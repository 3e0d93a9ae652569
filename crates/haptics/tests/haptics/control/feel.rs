//! Promise: rendered forces are bounded and passive, start softly, and fade without fresh models.

use glam::DVec3;
use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Health};
use saute_haptics::kitchen::contact_model::{ContactModel, Impulse, Payload, Plane};
use saute_haptics::{Capabilities, Pose, Renderer, Twist, WeightOnSpring, library};

use crate::random::{Random, device};

const DT: f64 = 1e-3;

fn strings() -> Capabilities {
    device("spidar-pan-crossed").capabilities()
}

fn renderer(capabilities: &Capabilities) -> Renderer {
    Renderer::new(capabilities, &library::feel().unwrap())
}

fn held(position: DVec3, linear: DVec3) -> HapticSample {
    HapticSample {
        pose: Pose { position, ..Pose::default() },
        twist: Twist { linear, angular: DVec3::ZERO },
        health: Health::Running,
        fresh: true,
        ..HapticSample::default()
    }
}

fn weighing(number: u64, mass: f64) -> ContactModel {
    ContactModel { number, payload: Payload::point(mass, DVec3::ZERO), ..ContactModel::default() }
}

/// Steps with a model that is published every 16 ms.
fn steps(renderer: &mut Renderer, sample: &HapticSample, model: &ContactModel, steps: u64) -> Vec<HapticCommand> {
    let fresh = |k: u64| ContactModel { number: model.number + k / 16, ..*model };
    (0..steps).map(|k| renderer.step(sample, &fresh(k), DT)).collect()
}

#[test]
fn forces_grow_from_nothing_within_the_soft_start() {
    let mut renderer = renderer(&strings());
    let still = held(DVec3::Z * 0.1, DVec3::ZERO);
    let felt = steps(&mut renderer, &still, &weighing(1, 0.5), 700);
    let weight = 0.5 * 9.80665;
    let at = |k: usize| -felt[k].wrench.force.z / weight;
    assert!(at(0) < 0.01 && (at(249) - 0.5).abs() < 0.05 && (at(600) - 1.0).abs() < 0.01, "{} {}", at(249), at(600));
    let jump = felt.windows(2).map(|w| (w[1].wrench - w[0].wrench).force.length()).fold(0.0, f64::max);
    assert!(jump < 0.1, "{jump} N within a millisecond");
}

#[test]
fn without_a_fresh_model_for_50_ms_forces_fade_and_come_back_with_the_next() {
    let mut renderer = renderer(&strings());
    let still = held(DVec3::Z * 0.1, DVec3::ZERO);
    steps(&mut renderer, &still, &weighing(1, 0.5), 1000);
    let old = weighing(1000, 0.5);
    let felt: Vec<HapticCommand> = (0..400).map(|_| renderer.step(&still, &old, DT)).collect();
    let force = |k: usize| -felt[k].wrench.force.z;
    assert!(force(45) > 4.8, "full before 50 ms: {}", force(45));
    assert!(force(160) < 3.0 && force(160) > 1.0, "fading: {}", force(160));
    assert_eq!(felt[299], HapticCommand::default(), "zero, and the strings at minimum tension");
    let back = steps(&mut renderer, &still, &weighing(2000, 0.5), 700);
    assert!((-back[699].wrench.force.z - 4.9).abs() < 0.05);
}

#[test]
fn a_collision_is_rendered_once_with_its_whole_impulse() {
    let mut renderer = renderer(&strings());
    let still = held(DVec3::Z * 0.1, DVec3::ZERO);
    steps(&mut renderer, &still, &weighing(1, 0.0), 1000);
    let mut model = weighing(2000, 0.0);
    let impulse = DVec3::new(0.0, 0.0, -0.06);
    model.impulses[0] = Impulse { number: 1, impulse, at: DVec3::new(0.05, 0.0, 0.0), energy: 0.05 };
    let felt = steps(&mut renderer, &still, &model, 48);
    let sum: DVec3 = felt.iter().map(|c| c.wrench.force * DT).sum();
    let turn: DVec3 = felt.iter().map(|c| c.wrench.torque * DT).sum();
    assert!((sum - impulse).length() < 0.02 * impulse.length(), "{sum}");
    assert!((turn.y - 0.05 * 0.06).abs() < 1e-4, "{turn}");
    assert!(felt[20..].iter().all(|c| c.wrench.force.length() < 1e-9), "zero after its duration");
}

#[test]
fn inertia_is_felt_when_the_pan_is_accelerated() {
    let mut renderer = renderer(&strings());
    steps(&mut renderer, &held(DVec3::Z * 0.1, DVec3::ZERO), &weighing(1, 0.6), 1000);
    // Constant acceleration to the right: the contents resist with m a.
    let acceleration = 2.0;
    let mut last = HapticCommand::default();
    for k in 0..250u64 {
        let t = k as f64 * DT;
        let sample = held(DVec3::new(0.5 * acceleration * t * t, 0.0, 0.1), DVec3::X * (acceleration * t));
        last = renderer.step(&sample, &weighing(1000 + k, 0.6), DT);
    }
    assert!((last.wrench.force.x + 0.6 * acceleration).abs() < 0.1, "{:?}", last.wrench);
}

#[test]
fn no_contact_model_exceeds_the_limits() {
    let capabilities = strings();
    let mut renderer = renderer(&capabilities);
    let mut random = Random(2);
    let mut last = HapticCommand::default();
    for k in 1..20_000u64 {
        let wild = [1.0, 1e3, 1e12, f64::INFINITY, f64::NAN][(k / 16 % 5) as usize];
        let mut model = weighing(k, 0.3 * wild);
        model.loose.force = random.vector() * wild * 50.0;
        model.vapour = wild;
        model.impulses[0] = Impulse { number: k, impulse: random.vector() * wild, at: random.vector(), energy: wild };
        let sample = held(random.vector() * 0.3, random.vector() * 2.0);
        let command = renderer.step(&sample, &model, DT);
        let wrench = command.wrench;
        assert!(wrench.is_finite() && wrench.force.length() <= 25.0 + 1e-9 && wrench.torque.length() <= 1.5 + 1e-9);
        let change = wrench - last.wrench;
        assert!(change.force.length() <= 5.0 + 1e-9 || command.wrench.force == DVec3::ZERO, "slew: {change:?}");
        last = command;
    }
}

#[test]
fn an_active_world_is_limited_to_the_reserve() {
    // A force along every motion, as from a spring with a delayed measurement.
    let mut renderer = renderer(&strings());
    let mut arm = WeightOnSpring::default();
    let mut command = HapticCommand::default();
    let mut given = 0.0;
    for k in 1..20_000u64 {
        let sample = arm.exchange(&command, DT);
        given += command.wrench.power(&sample.twist) * DT;
        let mut model = weighing(k, 0.0);
        model.loose.force = sample.twist.linear * 30.0 + DVec3::X * if k == 600 { 5.0 } else { 0.0 };
        command = renderer.step(&HapticSample { health: Health::Running, ..sample }, &model, DT);
    }
    let lowest = renderer.passivity().lowest();
    assert!((0.0..0.005).contains(&lowest), "lowest {lowest} J");
    assert!(given < 0.006, "{given} J given to the hand from a reserve of 5 mJ");
}

#[test]
fn sizzle_grows_with_the_vapour_flow_and_persists_as_vibration() {
    let rms = |vapour: f64| {
        let mut renderer = renderer(&strings());
        let model = ContactModel { number: 1, vapour, ..ContactModel::default() };
        let felt = steps(&mut renderer, &held(DVec3::Z * 0.1, DVec3::ZERO), &model, 3000);
        let squares: f64 = felt[1000..].iter().map(|c| c.wrench.force.z.powi(2)).sum();
        (squares / 2000.0).sqrt()
    };
    let (none, some, more) = (rms(0.0), rms(0.1e-3), rms(0.5e-3));
    assert!(none == 0.0 && some > 0.005 && more > 1.8 * some && more < 0.5, "{none} {some} {more}");
}

#[test]
fn the_hobs_glass_pushes_back() {
    let mut renderer = renderer(&strings());
    let mut model = weighing(1, 0.0);
    model.planes[0] = Plane { normal: DVec3::Z, at_least: 0.0, edge_radius: 0.1, below: 0.003 };
    let free = steps(&mut renderer, &held(DVec3::Z * 0.01, DVec3::ZERO), &model, 800);
    assert_eq!(free[799].wrench.force, DVec3::ZERO);
    let model = ContactModel { number: 5000, ..model };
    let pressed = steps(&mut renderer, &held(DVec3::Z * 0.001, DVec3::ZERO), &model, 100);
    let force = pressed[99].wrench.force;
    assert!((force.z - 1500.0 * 0.002).abs() < 0.01, "{force}");
}

#[test]
fn a_device_without_a_real_pan_renders_the_pan_s_weight() {
    let model = ContactModel { own: Payload::point(1.2, DVec3::ZERO), ..weighing(1, 0.3) };
    let weigh = |name: &str| {
        let mut renderer = renderer(&device(name).capabilities());
        -steps(&mut renderer, &held(DVec3::Z * 0.1, DVec3::ZERO), &model, 1500)[1499].wrench.force.z / 9.80665
    };
    assert!((weigh("spidar-pan-crossed") - 0.3).abs() < 1e-3);
    assert!((weigh("spidar-frame") - 1.5).abs() < 1e-2);
}

/// Swings a rendered pan: returns the work that the hand does and gets back [J], and the lowest value of the observer's
/// account [J].
fn swung(capabilities: &Capabilities, mass: impl Fn(f64) -> f64, reach: f64, hz: f64) -> ([f64; 2], f64) {
    let mut renderer = renderer(capabilities);
    steps(&mut renderer, &held(DVec3::Z * 0.1, DVec3::ZERO), &weighing(1, mass(0.0)), 1500);
    let (mut work, mut command) = ([0.0; 2], HapticCommand::default());
    for k in 0..4000u64 {
        let t = k as f64 * DT;
        let (sin, cos) = (std::f64::consts::TAU * hz * t).sin_cos();
        // The motion fades in.
        let size = reach * (t / 0.5).min(1.0);
        let speed = DVec3::X * (size * std::f64::consts::TAU * hz * cos);
        let power = command.wrench.force.dot(speed);
        work[usize::from(power > 0.0)] += power.abs() * DT;
        let sample = held(DVec3::new(size * sin, 0.0, 0.1), speed);
        command = renderer.step(&sample, &weighing(2000 + k, mass(t)), DT);
    }
    (work, renderer.passivity().lowest())
}

#[test]
fn a_swung_pan_returns_the_energy_that_the_hand_put_into_it_and_no_more() {
    let frame = device("spidar-frame").capabilities();
    for (reach, hz) in [(0.05, 0.8), (0.07, 1.0), (0.08, 1.2)] {
        let ([put, back], lowest) = swung(&frame, |_| 1.6, reach, hz);
        assert!(lowest >= 0.0 && back <= put + 0.005, "{hz} Hz: {put} J in, {back} J out, lowest {lowest} J");
        assert!(back > 0.7 * put, "{hz} Hz: of {put} J only {back} J return");
    }
}

#[test]
fn food_that_leaves_a_swung_pan_takes_its_energy_with_it_and_the_account_stays_positive() {
    let frame = device("spidar-frame").capabilities();
    for leaves_at in [1.30, 1.37, 1.45, 1.53] {
        let (_, lowest) = swung(&frame, |t| if t < leaves_at { 1.6 } else { 1.3 }, 0.09, 1.2);
        assert!(lowest >= 0.0, "left at {leaves_at} s: lowest {lowest} J");
    }
}
