//! Promise: a calibration is stored, and valid at the next start as long as it still fits.

use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample};
use saute_haptics::strings::kept_calibration::{CalibrationMemory, KeptCalibration, file_in};
use saute_haptics::{Health, Pose, Spidar};

use crate::bench_device::{Bench, BenchLink};
use crate::random::{apart, device};

const DEVICE: &str = "spidar-pan-crossed";

fn after(spidar: &mut Spidar<BenchLink>, steps: u32) -> HapticSample {
    (0..steps).map(|_| spidar.exchange(&HapticCommand::default(), 1e-3)).last().unwrap()
}

/// The calibration of a device on its jig.
fn found(bench: &Bench) -> KeptCalibration {
    let mut spidar = Spidar::new(bench.link(), device(DEVICE), 42);
    let (memory, mut news) = CalibrationMemory::new(None);
    spidar.remember(memory);
    assert!(news.take().is_none());
    assert_eq!(after(&mut spidar, 4000).health, Health::Running);
    let found = news.take().unwrap();
    assert!(news.take().is_none(), "reported once");
    spidar.stop();
    found
}

/// The same device at the next start of the program.
fn started(bench: &Bench, kept: KeptCalibration) -> Spidar<BenchLink> {
    let mut spidar = Spidar::new(bench.link(), device(DEVICE), 42);
    spidar.remember(CalibrationMemory::new(Some(kept)).0);
    spidar
}

#[test]
fn a_stored_calibration_is_read_back_from_its_file_and_needs_no_jig() {
    let bench = Bench::new(&device(DEVICE));
    let kept = found(&bench);
    let text = kept.text().unwrap();
    assert!(text.contains("device = \"bench\"") && text.contains("[[string]]"), "{text}");
    let read = KeptCalibration::parse(&text, "bench.toml").unwrap();
    assert_eq!((read.device_name(), read.boot), ("bench".into(), kept.boot));
    let (a, b) = (&read.calibration, &kept.calibration);
    assert!(a.rig.is_near(&b.rig, 1e-12) && (0..8).all(|i| (a.offset[i] - b.offset[i]).abs() < 1e-12));
    let there = Pose::at(0.06, 0.03, 0.12).turned(glam::DVec3::Y, 0.2);
    bench.put(there);
    let mut spidar = started(&bench, read);
    let sample = after(&mut spidar, 50);
    let (mm, deg) = apart(&sample.pose, &there);
    assert!(sample.health == Health::Running && mm < 0.1 && deg < 0.1, "{:?} {mm} mm {deg}°", sample.health);
}

#[test]
fn encoders_that_have_lost_their_count_require_the_jig_again() {
    let bench = Bench::new(&device(DEVICE));
    let kept = found(&bench);
    bench.power_cycle();
    let mut spidar = started(&bench, kept);
    assert_eq!(after(&mut spidar, 50).health, Health::Uncalibrated);
    assert_eq!(after(&mut spidar, 4000).health, Health::Running, "calibrated on the jig");
}

#[test]
fn a_slipped_string_is_detected_at_the_start() {
    let bench = Bench::new(&device(DEVICE));
    let kept = found(&bench);
    bench.slip(0.02);
    assert_eq!(after(&mut started(&bench, kept), 50).health, Health::Uncalibrated);
    let other = KeptCalibration { device: *b"another\0\0\0\0\0\0\0\0\0", ..kept };
    bench.slip(-0.02);
    assert_eq!(after(&mut started(&bench, other), 50).health, Health::Uncalibrated, "another device's");
    assert_eq!(after(&mut started(&bench, kept), 50).health, Health::Running);
}

#[test]
fn another_device_at_the_same_place_with_the_same_boot_requires_the_jig() {
    let bench = Bench::new(&device(DEVICE));
    let kept = found(&bench);
    let mut spidar = started(&bench, kept);
    assert_eq!(after(&mut spidar, 50).health, Health::Running);
    bench.state_caps(|caps| caps.name[0] = b'B');
    bench.plug(false);
    after(&mut spidar, 200);
    bench.plug(true);
    assert_eq!(after(&mut spidar, 200).health, Health::Uncalibrated);
}

#[test]
fn an_invalid_file_is_refused_with_a_remedy() {
    let text = found(&Bench::new(&device(DEVICE))).text().unwrap();
    let refused = |text: &str, words: &str| {
        let said = KeptCalibration::parse(text, "pan.toml").unwrap_err().to_string();
        assert!(said.contains("pan.toml") && said.contains(words) && said.contains("jig"), "{said}");
    };
    refused(&text.replace("boot", "boots"), "boots");
    refused(&text.replacen("offset_mm = ", "offset_mm = 1e9 #", 1), "out of range");
    for residual in ["nan", "inf", "-1.0", "0.31", "1e9"] {
        refused(
            &text.replacen("residual_mm = ", &format!("residual_mm = {residual} #"), 1),
            "residual is out of range",
        );
    }
    refused(text.rsplit_once("[[string]]").unwrap().0, "eight strings");
    let folder = std::path::Path::new("calibrations");
    assert_eq!(file_in(folder, "spidar-pan@/dev/ttyACM0"), folder.join("spidar-pan__dev_ttyACM0.toml"));
}
