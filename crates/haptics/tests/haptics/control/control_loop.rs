//! Promise: the loop runs on its own thread at the device's rate, reports its jitter, and stops on request.

use std::time::{Duration, Instant};

use saute_haptics::control::control_loop::{ControlLoop, LoopState};
use saute_haptics::kitchen::contact_model::{ContactModel, Payload};
use saute_haptics::{Capabilities, HapticCommand, HapticDevice, HapticSample, Health, WeightOnSpring, library};

/// Publishes a weight of 0.4 kg until a condition is met, for at most a minute.
fn until(control: &mut ControlLoop, number: &mut u64, seen: impl Fn(&LoopState) -> bool) -> LoopState {
    let begun = Instant::now();
    loop {
        *number += 1;
        control.publish(ContactModel {
            number: *number,
            payload: Payload::point(0.4, glam::DVec3::ZERO),
            ..ContactModel::default()
        });
        let state = control.state();
        if seen(&state) {
            return state;
        }
        assert!(begun.elapsed() < Duration::from_secs(60), "{state:?}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn start() -> ControlLoop {
    ControlLoop::start(Box::new(WeightOnSpring::default()), &library::feel().unwrap(), 1000).unwrap()
}

#[test]
fn a_published_weight_is_rendered_and_the_run_is_reported() {
    let (mut control, mut number) = (start(), 0);
    let weight = 0.4 * 9.80665;
    until(&mut control, &mut number, |s| (s.command.wrench.force.z + weight).abs() < 0.05 && s.steps > 900);
    let report = control.end().unwrap();
    assert!(report.rate_hz > 500.0 && report.rate_hz < 1010.0, "{} Hz", report.rate_hz);
    assert!(report.scheduler.contains("SCHED") || report.scheduler.contains("real time"), "{}", report.scheduler);
    assert!(report.lateness.p99 >= report.lateness.p50 && report.lateness.max > 0.0);
    assert_eq!(report.log.len(), 1000.min(report.log.len()));
    assert!(report.log.windows(2).all(|w| w[1].host_s > w[0].host_s));
}

#[test]
fn the_emergency_stop_releases_all_forces_at_once_and_for_good() {
    let (mut control, mut number) = (start(), 0);
    until(&mut control, &mut number, |s| s.command.wrench.force.z < -1.0);
    control.emergency_stop();
    let state = until(&mut control, &mut number, |s| s.sample.health == Health::Stopped);
    assert_eq!(state.command.wrench.force, glam::DVec3::ZERO);
    std::thread::sleep(Duration::from_millis(700));
    let later = until(&mut control, &mut number, |s| s.steps > state.steps);
    assert!(!later.command.enabled && later.sample.achieved.force == glam::DVec3::ZERO, "{later:?}");
}

#[test]
fn a_hand_resumes_after_an_emergency_stop() {
    let (mut control, mut number) = (start(), 0);
    until(&mut control, &mut number, |s| s.command.wrench.force.z < -1.0);
    control.emergency_stop();
    until(&mut control, &mut number, |s| s.sample.health == Health::Stopped);
    control.resume();
    until(&mut control, &mut number, |s| s.sample.health == Health::Running && s.command.wrench.force.z < -3.0);
}

/// A driver that panics after some exchanges.
struct Breaking(WeightOnSpring, u32);

impl HapticDevice for Breaking {
    fn capabilities(&self) -> &Capabilities {
        self.0.capabilities()
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        assert!(self.1 > 0, "this driver panics on purpose");
        self.1 -= 1;
        self.0.exchange(command, dt)
    }

    fn stop(&mut self) {
        self.0.stop();
    }

    fn resume(&mut self) {
        self.0.resume();
    }
}

#[test]
fn a_loop_that_panicked_is_reported_as_lost() {
    let device = Box::new(Breaking(WeightOnSpring::default(), 1500));
    let (mut control, mut number) = (ControlLoop::start(device, &library::feel().unwrap(), 0).unwrap(), 0);
    until(&mut control, &mut number, |s| s.sample.health == Health::Running && s.rate_hz > 0.0);
    let state = until(&mut control, &mut number, |s| s.sample.health == Health::Lost);
    assert!(state.rate_hz == 0.0 && !state.command.enabled && !state.sample.fresh, "{state:?}");
    assert!(control.end().is_err());
}
