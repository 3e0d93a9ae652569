//! The numbers of `saute bench heat` as text.

use std::fmt::Write;

use super::HeatBench;
use super::brick::BrickBench;

/// Returns the brick's numbers as a line.
pub fn brick_text(brick: &BrickBench) -> String {
    format!(
        "brick of {} nodes, {} steps: {:.4} s; error {:.4} K, with half the step {:.4} K\n",
        brick.nodes, brick.steps, brick.loop_s, brick.max_error_k, brick.half_step_error_k
    )
}

/// Returns the numbers as text.
pub fn text(bench: &HeatBench) -> String {
    let scaling = &bench.scaling;
    let mut text = brick_text(&bench.brick);
    let _ = write!(
        text,
        "kernel: {:.0} million node updates/s; {:.2} of the bandwidth of a STREAM triad at 10⁶ nodes\n\
         \n   nodes   one step of {} stages [s]\n",
        bench.updates_per_s * 1e-6,
        bench.bandwidth_fraction,
        scaling.steps.stages
    );
    for (nodes, seconds) in scaling.steps.nodes.iter().zip(&scaling.steps.seconds) {
        let _ = writeln!(text, "{nodes:8}   {seconds:.6}");
    }
    let _ = writeln!(text, "time grows as nodes to the power of {:.3}", scaling.steps.exponent);
    text.push_str("\n   nodes   whole brick [s]   error [K]\n");
    for run in &scaling.runs {
        let _ = writeln!(text, "{:8}   {:15.4}   {:9.4}", run.nodes, run.seconds, run.max_error_k);
    }
    if let Some(seconds) = scaling.seconds_to_0_1_k {
        let _ = writeln!(text, "to 0.1 K: {seconds:.4} s");
    }
    let steak = &bench.steak;
    let _ = writeln!(text, "\nsteak of {} nodes, full physics: {:.0} × real time", steak.nodes, steak.real_time_factor);
    text
}
