//! Timing of pose estimation and tension distribution: `cargo bench -p saute-haptics`.

use std::hint::black_box;
use std::io::Write;
use std::time::Instant;

use glam::DVec3;
use saute_haptics::{Pose, PoseEstimator, TensionSolver, Wrench, library};

/// Number of poses along a motion.
const ROUNDS: u32 = 20_000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut out = std::io::stdout().lock();
    for (name, geometry) in library::devices()? {
        let rig = geometry.rig();
        let home = geometry.home();
        let at = |k: u32| {
            let s = f64::from(k) * 1e-3;
            let off = DVec3::new(s.sin(), (1.3 * s).sin(), (0.7 * s).cos()) * 0.08;
            Pose { position: home.position + off, ..home }.turned(DVec3::X, 0.3 * (2.1 * s).sin())
        };
        let mut estimator = PoseEstimator::new(rig, home);
        let begun = Instant::now();
        for k in 0..ROUNDS {
            black_box(estimator.update(&rig.lengths(&at(k)), 1e-3));
        }
        let pose_us = begun.elapsed().as_secs_f64() * 1e6 / f64::from(ROUNDS);
        let mut solver = TensionSolver::new(geometry.tension_rule());
        let (begun, mut rounds, mut worst) = (Instant::now(), 0, 0.0f64);
        for k in 0..ROUNDS {
            let s = f64::from(k) * 0.01;
            let torque = DVec3::new(s.sin(), s.cos(), (2.0 * s).sin()) * 0.2;
            let wanted = geometry.preload() + Wrench { force: DVec3::new(s.sin(), 0.0, -3.0), torque };
            let one = Instant::now();
            rounds += black_box(solver.solve(&rig.lines(&at(k)), &wanted)).rounds;
            worst = worst.max(one.elapsed().as_secs_f64() * 1e6);
        }
        let tension_us = begun.elapsed().as_secs_f64() * 1e6 / f64::from(ROUNDS);
        let mean = f64::from(rounds) / f64::from(ROUNDS);
        writeln!(
            out,
            "{name}: pose {pose_us:.2} µs, tensions {tension_us:.2} µs ({mean:.1} rounds; slowest {worst:.0} µs)"
        )?;
    }
    Ok(())
}
