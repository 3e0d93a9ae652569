//! Speed of the conduction operator and of the memory.

use std::hint::black_box;
use std::time::Instant;

use saute_kitchen::heat::Boundary;
use saute_kitchen::heat::conduction::axis::{Axis, End};
use saute_kitchen::heat::conduction::product::{Constants, ProductOperator};
use saute_kitchen::heat::conduction::super_step::SuperStep;
use saute_kitchen::heat::conduction::tensor::TensorBody;
use serde::Serialize;

/// Nodes along each edge of the cubes: 10⁴ to 10⁶ nodes.
const EDGES: [usize; 5] = [22, 32, 47, 68, 100];
/// Stages of a step.
const STAGES: usize = 9;
/// Operator applications in a step: one per stage; the one at the start replaces the one of the first stage.
const SWEEPS: f64 = STAGES as f64;
/// Arrays that a stage reads or writes: the two previous stages, the start, the rates.
const ARRAYS: f64 = 4.0;
/// Elements of the arrays of the triad (chosen: each array exceeds the caches).
const TRIAD: usize = 1 << 23;
/// Shortest duration of a measurement [s] (chosen: well above the resolution of the clock).
const LONG_ENOUGH: f64 = 0.15;
/// Number of measurements; the shortest is reported (chosen).
const TRIES: usize = 5;

/// Time of a step against mesh size.
#[derive(Debug, Serialize)]
pub struct StepTimes {
    /// Numbers of nodes.
    pub nodes: Vec<usize>,
    /// Time of one step [s].
    pub seconds: Vec<f64>,
    /// Stages of a step.
    pub stages: usize,
    /// Slope of log time against log nodes, by least squares [-].
    pub exponent: f64,
}

/// Measures steps on cubes.
pub fn step_times() -> StepTimes {
    let nodes: Vec<usize> = EDGES.iter().map(|n| n * n * n).collect();
    let seconds: Vec<f64> = EDGES.iter().map(|&n| step_time(n)).collect();
    let exponent = slope(&nodes, &seconds);
    StepTimes { nodes, seconds, stages: STAGES, exponent }
}

fn step_time(edge: usize) -> f64 {
    let axis = || Axis::straight((0..edge).map(|i| 1e-3 * i as f64).collect());
    let body = TensorBody::new(vec![axis(), axis(), axis()]);
    let layers = [Constants { conductivity: 0.48, capacity: 3.7e6 }];
    let boundaries = [0, 1, 2].map(|a| (a, End::High, Boundary::convective(500.0, 453.0)));
    let operator = ProductOperator::new(&body, &layers, &boundaries);
    let dt = 0.9 * SuperStep::reach(STAGES) * operator.stable_step();
    let mut t = vec![278.0; body.node_count()];
    let mut step = SuperStep::new(t.len());
    best_time(|| step.advance(&mut t, dt, STAGES, &operator))
}

/// Returns the shortest mean time of one call [s].
fn best_time(mut call: impl FnMut()) -> f64 {
    call();
    let start = Instant::now();
    call();
    let calls = (LONG_ENOUGH / start.elapsed().as_secs_f64().max(1e-9)).ceil() as usize;
    let mut measure = || {
        let start = Instant::now();
        (0..calls).for_each(|_| call());
        start.elapsed().as_secs_f64() / calls as f64
    };
    (0..TRIES).map(|_| measure()).fold(f64::INFINITY, f64::min)
}

fn slope(nodes: &[usize], seconds: &[f64]) -> f64 {
    let points: Vec<[f64; 2]> = nodes.iter().zip(seconds).map(|(n, s)| [(*n as f64).ln(), s.ln()]).collect();
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let above: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    above / points.iter().map(|p| (p[0] - x) * (p[0] - x)).sum::<f64>()
}

/// Returns the node updates per second on the smallest mesh [1/s].
pub fn updates_per_s(times: &StepTimes) -> f64 {
    SWEEPS * times.nodes[0] as f64 / times.seconds[0]
}

/// Returns the memory traffic on the largest mesh [B/s].
pub fn bandwidth(times: &StepTimes) -> f64 {
    let last = times.nodes.len() - 1;
    SWEEPS * ARRAYS * 8.0 * times.nodes[last] as f64 / times.seconds[last]
}

/// Returns the memory bandwidth of a = b + s c, each array counted once [B/s]. Source: McCalpin's STREAM benchmark
/// `[@mccalpin-stream]`.
pub fn triad_bandwidth() -> f64 {
    let (mut a, b, c) = (vec![0.0_f64; TRIAD], vec![1.0_f64; TRIAD], vec![2.0_f64; TRIAD]);
    let seconds = best_time(|| {
        let s = black_box(3.0);
        a.iter_mut().zip(&b).zip(&c).for_each(|((a, b), c)| *a = b + s * c);
        black_box(&mut a);
    });
    3.0 * 8.0 * TRIAD as f64 / seconds
}
