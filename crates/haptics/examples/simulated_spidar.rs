//! A simulated SPIDAR string set: pose from string lengths, and string tensions for a weight.
//!
//! `cargo run --release -p saute-haptics --example simulated_spidar`

use std::io::Write;

use glam::DVec3;
use saute_haptics::{Pose, PoseEstimator, STRINGS, TensionSolver, Wrench, library};

/// Weight on the pan [N].
const WEIGHT_N: f64 = 3.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let geometry = library::devices()?.remove(library::DEFAULT_DEVICE).ok_or("the default device is missing")?;
    let rig = geometry.rig();
    let pitch = geometry.pitch();
    let mut estimator = PoseEstimator::new(rig, geometry.home());
    let mut solver = TensionSolver::new(geometry.tension_rule());
    let mut out = std::io::stdout().lock();
    writeln!(out, "{}, encoder pitch {:.0} µm", geometry.name, pitch * 1e6)?;
    for step in 0..=4 {
        // The true pose: a motion to the right with a growing tilt.
        let share = f64::from(step) / 4.0;
        let offset = DVec3::new(0.08, 0.02, 0.0) * share;
        let pose =
            Pose { position: geometry.home().position + offset, ..geometry.home() }.turned(DVec3::Y, 0.2 * share);

        // Encoders round the string lengths to their pitch.
        let lengths: [f64; STRINGS] = rig.lengths(&pose).map(|l| ((l / pitch).floor() + 0.5) * pitch);
        let found = estimator.update(&lengths, 1e-3);
        let error_mm = (found.position - pose.position).length() * 1e3;

        // Tensions that render the weight beyond the preload of the empty device.
        let wanted = geometry.preload() + Wrench { force: DVec3::NEG_Z * WEIGHT_N, torque: DVec3::ZERO };
        let solved = solver.solve(&rig.lines(&found), &wanted);
        let rendered = solved.achieved - geometry.preload();
        let tensions: Vec<String> = solved.tension.iter().map(|t| format!("{t:4.1}")).collect();
        writeln!(
            out,
            "x {:5.1} mm  pose error {error_mm:.3} mm  tensions {} N  rendered {:5.2} N",
            found.position.x * 1e3,
            tensions.join(" "),
            rendered.force.z
        )?;
    }
    Ok(())
}
