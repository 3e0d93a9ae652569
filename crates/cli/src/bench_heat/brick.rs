//! A steak-sized brick that is flipped once, compared with its exact series.

use std::time::Instant;

use saute_kitchen::Library;
use saute_kitchen::heat::sorted::Sorted;
use saute_lab::exact::FlippedBrick;
use saute_lab::{Case, LabReport, run};
use saute_schema::InputError;
use serde::Serialize;

/// Probes: the centre, and 2.5 mm below both faces [mm].
const PLACES: [[f64; 3]; 3] = [[50.0, 35.0, 12.5], [50.0, 35.0, 2.5], [50.0, 35.0, 22.5]];
/// Times of the comparison [s].
const TIMES: [f64; 4] = [150.0, 300.0, 450.0, 600.0];
/// Largest spacing along x, y and z [mm] (chosen: weak air on the sides lets x and y be coarse).
const SPACING: [f64; 3] = [14.0, 12.0, 0.7];
/// Length of a step over the lab's default, which resolves orders of convergence [-] (chosen: the error in time stays
/// below half of the error in space; the error at half the step is reported too).
const STEP_FACTOR: f64 = 8.0;
/// Number of runs; their median is reported.
const RUNS: usize = 15;

/// Time and accuracy of the brick.
#[derive(Debug, Serialize)]
pub struct BrickBench {
    /// Time of the time loop, median of the runs [s].
    pub loop_s: f64,
    /// Largest error over all probes and times [K].
    pub max_error_k: f64,
    /// Largest error with steps of half the length [K].
    pub half_step_error_k: f64,
    /// Number of nodes.
    pub nodes: usize,
    /// Number of time steps.
    pub steps: usize,
}

/// One run on one mesh.
#[derive(Debug, Serialize)]
pub struct WholeRun {
    /// Number of nodes.
    pub nodes: usize,
    /// Time of the time loop [s].
    pub seconds: f64,
    /// Largest error [K].
    pub max_error_k: f64,
}

/// Returns the exact temperatures at all times and probes [°C].
pub fn exact() -> Vec<Vec<f64>> {
    let brick = FlippedBrick {
        size: [0.1, 0.07, 0.025],
        conductivity: 0.49,
        diffusivity: 0.49 / (1058.0 * 3590.0),
        h: [15.0, 500.0],
        celsius: [5.0, 25.0, 180.0],
        flip: 300.0,
    };
    brick.temperatures(&PLACES.map(|p| p.map(|mm| mm * 1e-3)), &TIMES)
}

fn case(scale: f64, step_factor: f64, library: &Library) -> Result<Case, InputError> {
    let [x, y, z] = SPACING.map(|s| s * scale);
    let probes: String = PLACES
        .iter()
        .enumerate()
        .map(|(i, [x, y, z])| format!("[[probe]]\nname = \"{i}\"\nat_mm = [{x}, {y}, {z}]\n"))
        .collect();
    let text = format!(
        "duration_s = 600\noutput_every_s = 150\n[body]\nshape = \"box\"\nsize_mm = [100, 70, 25]\n\
         resolution_mm = [{x}, {y}, {z}]\ninitial_c = 5\n\
         [material]\nconductivity_w_mk = 0.49\ndensity_kg_m3 = 1058\nspecific_heat_j_kgk = 3590\n\
         [solver]\nstep_factor = {step_factor}\n\
         [[boundary]]\nface = \"all\"\nh_w_m2k = 15\nambient_c = 25\n\
         [[boundary]]\nface = \"bottom\"\nh_w_m2k = 500\nambient_c = 180\n[flips]\nat_s = [300]\n{probes}"
    );
    Case::parse(&text, "brick", library)
}

fn timed(case: &Case) -> LabReport {
    let start = Instant::now();
    run(case, || start.elapsed().as_secs_f64())
}

fn max_error(report: &LabReport, exact: &[Vec<f64>]) -> f64 {
    let errors = exact.iter().enumerate().flat_map(|(i, row)| {
        // The first reading of a probe is the initial temperature.
        row.iter().enumerate().map(move |(place, exact)| (report.probes[&place.to_string()][i + 1][1] - exact).abs())
    });
    errors.fold(0.0, f64::max)
}

/// Measures the brick.
pub fn measure(exact: &[Vec<f64>], library: &Library) -> Result<BrickBench, InputError> {
    let whole = case(1.0, STEP_FACTOR, library)?;
    let report = timed(&whole);
    let seconds = Sorted::new((0..RUNS).map(|_| timed(&whole).wall_s).collect());
    Ok(BrickBench {
        loop_s: seconds.median().unwrap_or(0.0),
        max_error_k: max_error(&report, exact),
        half_step_error_k: max_error(&timed(&case(1.0, 0.5 * STEP_FACTOR, library)?), exact),
        nodes: report.nodes,
        steps: report.steps,
    })
}

/// Measures runs on meshes of different fineness: all spacings are scaled by the same factor.
pub fn whole_runs(exact: &[Vec<f64>], library: &Library) -> Result<Vec<WholeRun>, InputError> {
    let run = |scale: f64| {
        let case = case(scale, STEP_FACTOR, library)?;
        let report = timed(&case);
        let seconds = timed(&case).wall_s.min(report.wall_s);
        Ok(WholeRun { nodes: report.nodes, seconds, max_error_k: max_error(&report, exact) })
    };
    [2.0, 1.4, 1.0, 0.7, 0.5, 0.35].into_iter().map(run).collect()
}

/// Returns the time that reaches an error, by log-linear interpolation between runs [s]; none if no pair brackets it.
pub fn seconds_to(error: f64, runs: &[WholeRun]) -> Option<f64> {
    let pair = runs.windows(2).find(|w| w[0].max_error_k >= error && w[1].max_error_k <= error)?;
    let share = (pair[0].max_error_k / error).ln() / (pair[0].max_error_k / pair[1].max_error_k).ln();
    Some(pair[0].seconds * (pair[1].seconds / pair[0].seconds).powf(share))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// The series is checked by a mesh: errors fall fourfold when spacings and steps are halved.
    #[test]
    fn the_mesh_converges_to_the_series_at_second_order() {
        let (exact, library) = (exact(), Library::embedded().unwrap());
        let error = |scale: f64| max_error(&timed(&case(scale, 1.0, &library).unwrap()), &exact);
        let (coarse, fine) = (error(1.0), error(0.5));
        assert!(fine < 0.016 && (3.3..4.7).contains(&(coarse / fine)), "{coarse} {fine}");
    }

    #[test]
    fn the_series_starts_at_the_start_and_ends_in_the_air_where_there_is_no_plate() {
        let brick = FlippedBrick {
            size: [0.1, 0.07, 0.025],
            conductivity: 0.49,
            diffusivity: 1.3e-7,
            h: [15.0, 500.0],
            celsius: [5.0, 25.0, 180.0],
            flip: 1e6,
        };
        let early = brick.temperatures(&[[0.05, 0.035, 0.02]], &[5.0])[0][0];
        assert!((early - 5.0).abs() < 0.05, "{early}");
        let cold = FlippedBrick { celsius: [5.0, 25.0, 25.0], ..brick };
        let late = cold.temperatures(&[[0.02, 0.01, 0.003]], &[1e5])[0][0];
        assert!((late - 25.0).abs() < 1e-6, "{late}");
    }
}
