//! Promise: normal use with three times the simulator's noise fires no safety rule.

use glam::DVec3;
use saute_haptics::control::loop_step::LoopStep;
use saute_haptics::kitchen::contact_model::{ContactModel, Impulse, Payload, Plane};
use saute_haptics::{Geometry, HapticDevice, Health, Renderer, Spidar, library};

use crate::memory_link::{Bench, CODE};

/// Number of samples in the hand.
const SAMPLES: u64 = 1_000_000;

fn geometry() -> Geometry {
    library::devices().unwrap().remove("spidar-pan-crossed").unwrap()
}

/// What a cook does to the hand at a step of the loop: a steak that slides and is turned, sizzle, a wall, and blows.
fn cooking(step: u64) -> ContactModel {
    let seconds = step as f64 * 1e-3;
    // The steak is taken out for two of every twenty seconds.
    let mass = if seconds % 20.0 < 18.0 { 0.3 } else { 0.0 };
    let centre = DVec3::new((0.7 * seconds).sin(), (0.9 * seconds).cos(), 0.3) * 0.05;
    let mut model = ContactModel { number: step / 16 + 1, vapour: 5e-4, ..ContactModel::default() };
    model.payload = Payload::point(mass, centre);
    model.planes[0] = Plane { normal: DVec3::Z, at_least: 0.06, edge_radius: 0.1, below: 0.003 };
    let blow = DVec3::NEG_Z * 0.08;
    model.impulses[0] = Impulse { number: step / 700, impulse: blow, at: DVec3::X * 0.06, energy: 0.05 };
    model
}

#[test]
fn a_million_samples_of_normal_use_with_three_times_the_noise_cause_no_fault() {
    let bench = Bench::new(3.0);
    let spidar = Spidar::new(bench.link("10.0.0.1:9000"), geometry(), CODE);
    let renderer = Renderer::new(spidar.capabilities(), &library::feel().unwrap());
    let mut control = LoopStep::new(Box::new(spidar), renderer, 0);
    let (mut running, mut misfit, mut force, mut jump) = (0, 0.0f64, 0.0f64, 0.0f64);
    let (mut step, mut last) = (0, [0.3; 8]);
    while running < SAMPLES {
        step += 1;
        bench.pass(1);
        let state = control.step(&cooking(step), 1e-3);
        let sample = state.sample;
        assert!(!sample.health.is_stopped(), "{:?} after {running} samples", sample.health);
        assert!(step < SAMPLES + 20_000, "it was not always running: {:?}", sample.health);
        if sample.health == Health::Running {
            running += 1;
            misfit = misfit.max(sample.length_misfit);
            force = force.max(sample.total_force_n);
            let told = sample.tension_n.unwrap();
            jump = (0..8).fold(jump, |jump, i| jump.max((told[i] - last[i]).abs()));
            last = told;
        }
        if step % 100_000 == 0 || running == SAMPLES {
            println!(
                "{running} samples: lengths at most {misfit:.3} of what is possible, force at most {force:.1} N, \
                 tensions changed by at most {jump:.2} N/ms, account at least {:.2} mJ",
                state.passivity_j * 1e3
            );
        }
    }
    assert!(force > 8.0, "something was felt: {force} N");
}
