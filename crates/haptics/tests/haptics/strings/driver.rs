//! Promise: the driver finds its device, calibrates it, respects its limits, and reconnects automatically.

use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Health};
use saute_haptics::strings::wire::Units;
use saute_haptics::{Pose, Spidar, Wrench};

use crate::bench_device::{Bench, BenchLink};
use crate::random::{apart, device};

const DT: f64 = 1e-3;

fn after(spidar: &mut Spidar<BenchLink>, command: &HapticCommand, steps: u32) -> HapticSample {
    (0..steps).map(|_| spidar.exchange(command, DT)).last().unwrap()
}

/// A calibrated device.
fn running(bench: &Bench) -> Spidar<BenchLink> {
    let mut spidar = Spidar::new(bench.link(), device("spidar-pan-crossed"), 42);
    let sample = after(&mut spidar, &HapticCommand::default(), 4000);
    assert_eq!(sample.health, Health::Running);
    spidar
}

fn pull(force: glam::DVec3) -> HapticCommand {
    HapticCommand { wrench: Wrench { force, ..Wrench::ZERO }, enabled: true, ..HapticCommand::default() }
}

#[test]
fn a_hello_and_the_jig_lead_to_a_true_pose() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = Spidar::new(bench.link(), device("spidar-pan-crossed"), 42);
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 5).health, Health::Uncalibrated);
    assert!(bench.tensions().iter().all(|t| (t - 0.3).abs() < 1e-9), "minimum tension before the calibration");
    after(&mut spidar, &HapticCommand::default(), 4000);
    let there = Pose::at(0.05, -0.04, 0.13).turned(glam::DVec3::X, 0.2);
    bench.put(there);
    let sample = after(&mut spidar, &pull(glam::DVec3::NEG_Z * 3.0), 1000);
    let (mm, deg) = apart(&sample.pose, &there);
    assert!(sample.health == Health::Running && mm < 0.1 && deg < 0.1, "{mm} mm, {deg}°");
}

#[test]
fn the_achieved_wrench_is_what_the_strings_do_beyond_the_empty_device() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    let command = pull(glam::DVec3::new(0.5, 0.0, -5.0));
    let sample = after(&mut spidar, &command, 1500);
    let empty = Wrench { force: glam::DVec3::NEG_Z * 4.0, ..Wrench::ZERO };
    let off = bench.wrench() - empty - sample.achieved;
    assert!(off.force.length() < 0.01 && off.torque.length() < 1e-3, "{off:?}");
    assert!((sample.achieved.force - command.wrench.force).length() < 0.01, "{:?}", sample.achieved);
}

#[test]
fn the_empty_device_reports_no_wrench_while_its_preload_builds_up() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    for step in 0..600 {
        let made = after(&mut spidar, &pull(glam::DVec3::ZERO), 1).achieved;
        assert!(made.force.length() < 0.02 && made.torque.length() < 2e-3, "step {step}: {made:?}");
    }
}

#[test]
fn no_command_pulls_harder_than_the_limit() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    for force in [1e3, 1e9, f64::INFINITY, f64::NAN] {
        for direction in [glam::DVec3::NEG_Z, glam::DVec3::X, glam::DVec3::new(1.0, 1.0, -1.0)] {
            let sample = after(&mut spidar, &pull(direction * force), 300);
            let pulled = bench.wrench().force.length();
            assert!(pulled <= 25.01 && sample.total_force_n <= 25.01, "{pulled} N for {force}");
            assert!(bench.tensions().iter().all(|t| (0.299..=12.0).contains(t)));
        }
    }
}

#[test]
fn an_unplugged_device_is_lost_and_runs_again_without_the_jig_when_plugged_in() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    bench.plug(false);
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 300).health, Health::Lost);
    bench.plug(true);
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 200).health, Health::Running);
}

#[test]
fn a_device_that_lost_its_count_must_go_to_the_jig_again() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    bench.plug(false);
    after(&mut spidar, &HapticCommand::default(), 300);
    bench.power_cycle();
    bench.plug(true);
    assert_eq!(after(&mut spidar, &pull(glam::DVec3::NEG_Z), 200).health, Health::Uncalibrated);
    assert!(bench.tensions().iter().all(|t| (t - 0.3).abs() < 1e-9), "no force without a pose");
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 4000).health, Health::Running);
}

#[test]
fn wrong_units_and_wrong_codes_are_refused_until_they_are_right() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    bench.speak(Units { tension: 2, ..Units::SPOKEN });
    let mut spidar = Spidar::new(bench.link(), device("spidar-pan-crossed"), 42);
    assert_eq!(after(&mut spidar, &pull(glam::DVec3::NEG_Z), 500).health, Health::WrongUnits);
    assert_eq!(bench.tensions(), [0.0; 8]);
    bench.speak(Units::SPOKEN);
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 1200).health, Health::Uncalibrated);
    let mut stranger = Spidar::new(bench.link(), device("spidar-pan-crossed"), 1);
    assert_eq!(after(&mut stranger, &HapticCommand::default(), 50).health, Health::WrongCode);
}

#[test]
fn a_stopped_device_releases_all_forces_for_good() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    after(&mut spidar, &pull(glam::DVec3::NEG_Z * 5.0), 1000);
    spidar.stop();
    let sample = after(&mut spidar, &pull(glam::DVec3::NEG_Z * 5.0), 1000);
    assert!(bench.is_stopped() && sample.health == Health::Stopped);
    assert_eq!(bench.tensions(), [0.0; 8]);
}

#[test]
fn a_device_that_is_not_as_drawn_is_distinguished_from_an_uncalibrated_one() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = Spidar::new(bench.link(), device("spidar-pan"), 42);
    assert_eq!(after(&mut spidar, &HapticCommand::default(), 100).health, Health::Uncalibrated);
    assert_eq!(after(&mut spidar, &pull(glam::DVec3::NEG_Z), 4000).health, Health::Misfit);
    assert!(bench.tensions().iter().all(|t| (t - 0.3).abs() < 1e-9), "no force without a pose");
}

#[test]
fn no_command_changes_a_tension_faster_than_the_slew_rate_and_achieved_is_what_was_sent() {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    let mut spidar = running(&bench);
    let mut random = crate::random::Random(5);
    after(&mut spidar, &pull(glam::DVec3::ZERO), 1000);
    let (mut before, mut jump, mut off) = (bench.tensions(), 0.0f64, 0.0f64);
    for _ in 0..3000 {
        let wrench = Wrench { force: random.vector() * 60.0, torque: random.vector() * 3.0 };
        let sample = spidar.exchange(&HapticCommand { wrench, enabled: true, ..HapticCommand::default() }, DT);
        let now = bench.tensions();
        jump = (0..8).fold(jump, |jump, i| jump.max((now[i] - before[i]).abs()));
        before = now;
        off = off.max((sample.achieved.force - bench.wrench().force - glam::DVec3::Z * 4.0).length());
    }
    assert!(jump <= 5.0 + 1e-9 && jump > 4.9, "{jump} N within a millisecond");
    assert!(off < 0.05, "{off} N");
}
