//! Promise: data that no sound device sends stops the motors within milliseconds, and only a hand starts them again.

use glam::DVec3;
use saute_haptics::control::control_loop::LoopState;
use saute_haptics::control::loop_step::LoopStep;
use saute_haptics::device::{HapticDevice, Health};
use saute_haptics::kitchen::contact_model::{ContactModel, Payload, Plane};
use saute_haptics::{Pose, Renderer, Spidar, library};

use crate::bench_device::{Bench, BenchLink, Lie};
use crate::random::device;

const DT: f64 = 1e-3;
const DEVICE: &str = "spidar-pan-crossed";
/// Fastest change of a tension within a step [N], with the rounding to millinewtons.
const MOST_N: f64 = 5.001;

/// A loop with a full pan, and what its strings did.
struct Cook {
    bench: Bench,
    control: LoopStep,
    number: u64,
    model: ContactModel,
    tension: [f64; 8],
    /// Largest change of a tension within a step so far [N].
    jump: f64,
    /// Lowest value of the energy account so far [J].
    lowest: f64,
}

impl Cook {
    /// Begins with a calibrated device that renders contents of 1.5 kg over a wall.
    fn begin() -> Self {
        let geometry = device(DEVICE);
        let bench = Bench::new(&geometry);
        let spidar = Spidar::new(bench.link(), geometry, 42);
        let renderer = Renderer::new(spidar.capabilities(), &library::feel().unwrap());
        let control = LoopStep::new(Box::new(spidar), renderer, 0);
        let mut model = ContactModel { payload: Payload::point(1.5, DVec3::X * 0.03), ..ContactModel::default() };
        model.planes[0] = Plane { normal: DVec3::Z, at_least: 0.05, edge_radius: 0.1, below: 0.0 };
        let mut cook = Self { bench, control, number: 0, model, tension: [0.3; 8], jump: 0.0, lowest: 0.0 };
        let state = cook.steps(5000);
        assert!(state.sample.health == Health::Running && state.command.wrench.force.z < -13.0, "{state:?}");
        assert!(cook.jump < MOST_N, "{} N in normal use", cook.jump);
        cook
    }

    fn step(&mut self) -> LoopState {
        self.number += 1;
        self.model.number = self.number / 16 + 1;
        let state = self.control.step(&self.model, DT);
        let now = self.bench.tensions();
        // A stop cuts the current of strings that have been released before.
        if !self.bench.is_stopped() && self.number > 10 {
            let change = (0..8).map(|i| (now[i] - self.tension[i]).abs());
            self.jump = change.fold(self.jump, f64::max);
        }
        (self.tension, self.lowest) = (now, state.passivity_j);
        state
    }

    fn steps(&mut self, count: u32) -> LoopState {
        (0..count).map(|_| self.step()).last().unwrap()
    }

    /// Steps until a safety rule fires; returns the number of steps and the fault. The first step sends the false values of the device.
    fn until_fault(&mut self, most: u32) -> (u32, Health) {
        for k in 1..=most {
            let health = self.step().sample.health;
            if health.is_safety_fault() {
                return (k, health);
            }
        }
        panic!("no rule fired within {most} steps");
    }

    /// After a fault: all strings are least within 2 ms, the device is sent a stop, and stays stopped.
    fn assert_released(&mut self) {
        self.steps(2);
        assert!(self.bench.is_stopped(), "told to stop within 2 ms: {:?}", self.tension);
        assert!(self.bench.least_before_stop(), "every string was commanded to its least tension before");
        assert!(self.jump < MOST_N, "{} N within a millisecond", self.jump);
        self.bench.lie(Lie::None);
        let after = self.steps(3000);
        assert!(after.sample.health.is_safety_fault(), "it does not start by itself: {:?}", after.sample.health);
        assert_eq!((self.bench.tensions(), self.bench.stops()), ([0.0; 8], 3), "three stops");
        assert!(!after.command.enabled);
    }
}

#[test]
fn impossible_data_stop_the_motors_within_milliseconds() {
    let lies = [
        (Lie::LargestCounts, 4, Health::ImpossibleLengths),
        (Lie::RandomCounts(0.05), 200, Health::ImpossibleLengths),
        (Lie::Noise(0.01), 10, Health::ImpossibleLengths),
        (Lie::Tensions(u16::MAX), 4, Health::ForceAboveLimit),
    ];
    for (lie, most, expected) in lies {
        let (mut slowest, mut jump, mut lowest) = (0, 0.0f64, f64::INFINITY);
        for seed in 0..20 {
            let mut cook = Cook::begin();
            cook.bench.seed(seed);
            cook.bench.lie(lie);
            let (steps, fault) = cook.until_fault(most);
            assert_eq!(fault, expected, "{lie:?}");
            cook.assert_released();
            (slowest, jump, lowest) = (slowest.max(steps), jump.max(cook.jump), lowest.min(cook.lowest));
        }
        println!(
            "{lie:?}: {expected:?} after {slowest} ms at most, changes of at most {jump:.3} N within a millisecond, \
             account at least {:.2} mJ",
            lowest * 1e3
        );
    }
}

#[test]
fn a_pose_that_runs_away_with_the_force_overdraws_the_energy_account() {
    let mut cook = Cook::begin();
    // All lengths fit a pose, but that jumps through the wall and back in every sample.
    let mut fault = None;
    for k in 0..400 {
        let z = if k % 2 == 0 { 0.1 } else { 0.02 };
        cook.bench.put(Pose::at(0.0, 0.0, z));
        let health = cook.step().sample.health;
        if health.is_safety_fault() {
            println!("{health:?} after {k} ms, at most {:.3} N within a millisecond", cook.jump);
            fault = Some(health);
            break;
        }
    }
    assert_eq!(fault, Some(Health::EnergyOverdrawn));
    cook.assert_released();
}

#[test]
fn only_a_hand_starts_a_device_again_after_a_fault() {
    let mut cook = Cook::begin();
    cook.bench.lie(Lie::LargestCounts);
    cook.until_fault(4);
    cook.assert_released();
    cook.control.resume();
    let state = cook.steps(2000);
    assert!(state.sample.health == Health::Running && state.command.wrench.force.z < -13.0, "{state:?}");
    assert!(state.account_j > 0.0);
}

#[test]
fn a_device_that_still_lies_after_a_hand_has_resumed_goes_back_to_its_jig() {
    let mut cook = Cook::begin();
    cook.bench.slip(0.03);
    cook.until_fault(4);
    cook.assert_released();
    cook.control.resume();
    assert_eq!(cook.steps(200).sample.health, Health::Uncalibrated, "a string has slipped for good");
}

#[test]
fn one_impossible_sample_changes_nothing() {
    let mut cook = Cook::begin();
    let before = cook.step().sample.pose;
    cook.bench.lie(Lie::LargestCounts);
    cook.step();
    cook.bench.lie(Lie::None);
    let lied = cook.step().sample;
    assert!(lied.length_misfit > 1e3 && (lied.pose.position - before.position).length() < 1e-4, "{lied:?}");
    let after = cook.steps(1000).sample;
    assert!(after.health == Health::Running && (after.pose.position - before.position).length() < 1e-4);
    assert!(cook.jump < MOST_N);
}

#[test]
fn a_stopped_device_is_told_three_times_two_milliseconds_apart() {
    let mut cook = Cook::begin();
    cook.control.stop();
    assert_eq!(cook.bench.stops(), 1, "at once");
    cook.step();
    assert_eq!(cook.bench.stops(), 1);
    cook.step();
    assert_eq!(cook.bench.stops(), 2);
    cook.steps(2);
    assert_eq!(cook.bench.stops(), 3);
    assert_eq!(cook.steps(100).sample.health, Health::Stopped);
    assert_eq!(cook.bench.stops(), 3);
}

#[test]
fn no_stop_follows_the_three_of_a_stop() {
    for fault in [false, true] {
        let mut cook = Cook::begin();
        if fault {
            cook.bench.lie(Lie::LargestCounts);
            cook.until_fault(4);
            cook.assert_released();
        } else {
            cook.control.stop();
            cook.steps(2);
            // A second press while the stops are sent.
            cook.control.stop();
            cook.steps(10);
        }
        assert_eq!(cook.bench.stops(), 3);
        cook.control.stop();
        cook.steps(10);
        let Cook { bench, control, .. } = cook;
        drop(control);
        assert_eq!(bench.stops(), 3, "neither a press nor the end of the program tells a stopped device again");
    }
}

/// Returns the health after some steps without a command.
fn steps(spidar: &mut Spidar<BenchLink>, count: u32) -> Health {
    (0..count).map(|_| spidar.exchange(&Default::default(), DT).health).last().unwrap()
}

#[test]
fn a_device_that_was_never_asked_for_is_sent_no_stop_and_a_lost_one_is() {
    let geometry = device(DEVICE);
    let bench = Bench::new(&geometry);
    let mut spidar = Spidar::new(bench.link(), geometry.clone(), 42);
    spidar.stop();
    assert_eq!(steps(&mut spidar, 10), Health::Stopped);
    assert_eq!(bench.stops(), 0);
    let mut spidar = Spidar::new(bench.link(), geometry, 42);
    steps(&mut spidar, 10);
    bench.mute(true);
    assert_eq!(steps(&mut spidar, 150), Health::Lost);
    spidar.stop();
    assert_eq!(bench.stops(), 1, "it may still hear");
}

#[test]
fn a_driver_that_is_dropped_in_a_panic_sends_all_three_stops() {
    let geometry = device(DEVICE);
    let bench = Bench::new(&geometry);
    let mut spidar = Spidar::new(bench.link(), geometry, 42);
    let broken = std::thread::spawn(move || {
        for _ in 0..50 {
            spidar.exchange(&Default::default(), DT);
        }
        panic!("on purpose");
    });
    assert!(broken.join().is_err());
    assert_eq!(bench.stops(), 3);
}
