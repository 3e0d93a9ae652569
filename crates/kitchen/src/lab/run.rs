//! Runs a lab case.

use saute_heat::Conduction;
use saute_heat::super_step::SuperStep;
use saute_heat::tensor::{End, TensorBody};

use crate::celsius;
use crate::lab::body::{axes, vertical};
use crate::lab::case::{Boundary, Case};
use crate::lab::report::LabReport;

/// Stages of a super-step (chosen: seven explicit steps' length for five stages, well damped).
const STAGES: usize = 5;
/// Share of the stability limit that is used [-].
const SAFETY: f64 = 0.9;

/// Runs a case; `clock` tells wall seconds, for the report alone.
pub fn run(case: &Case, clock: impl Fn() -> f64) -> LabReport {
    let mut solver = Solver::new(case);
    let mut recording = Recording::new(case, &solver);
    let start = clock();
    let mut flips = case.flips.iter().copied().peekable();
    for &output in &case.outputs {
        while recording.stopped_at.is_none() && solver.time < output * (1.0 - 1e-12) {
            let flip = flips.peek().copied().filter(|f| *f < output);
            solver.advance_to(flip.unwrap_or(output), case, &mut recording);
            if flip.is_some() && recording.stopped_at.is_none() {
                solver.flip(case);
                flips.next();
            }
        }
        if recording.stopped_at.is_some() {
            break;
        }
        recording.read(&solver);
    }
    if recording.stopped_at.is_some() {
        recording.read(&solver);
    }
    recording.report(case, &solver, clock() - start)
}

/// The body and its present state.
struct Solver {
    body: TensorBody,
    conduction: Conduction,
    temperature: Vec<f64>,
    capacity: Vec<f64>,
    conductivity: Vec<f64>,
    /// Exchange with the outside: conductance [W/K] and conductance × temperature [W].
    exchange: Vec<[f64; 2]>,
    fixed: Vec<bool>,
    step: SuperStep,
    explicit: f64,
    upside_down: bool,
    time: f64,
    steps: usize,
    absorbed: f64,
}

impl Solver {
    fn new(case: &Case) -> Self {
        let body = TensorBody::new(axes(case.shape, &case.size, case.resolution));
        let n = body.node_count();
        let mut solver = Self {
            conduction: Conduction::default(),
            temperature: vec![case.initial; n],
            capacity: vec![0.0; n],
            conductivity: vec![0.0; n],
            exchange: vec![[0.0; 2]; n],
            fixed: vec![false; n],
            step: SuperStep::new(STAGES, n),
            explicit: 0.0,
            upside_down: false,
            time: 0.0,
            steps: 0,
            absorbed: 0.0,
            body,
        };
        solver.set_boundaries(case);
        solver.refresh(case);
        solver
    }

    /// Puts the boundaries on; after a flip bottom and top have changed places.
    fn set_boundaries(&mut self, case: &Case) {
        self.exchange.fill([0.0; 2]);
        self.fixed.fill(false);
        for &(axis, end, boundary) in &case.boundaries {
            let swapped = self.upside_down && vertical(case.shape) == Some(axis);
            let end = if swapped { opposite(end) } else { end };
            for (node, area) in self.body.face(axis, end) {
                match boundary {
                    Boundary::Convective { h, outside } => {
                        self.exchange[node][0] += h * area;
                        self.exchange[node][1] += h * area * outside;
                    }
                    Boundary::Fixed(at) => {
                        let before = self.temperature[node];
                        self.absorbed += self.body.graph.volume[node] * case.material.capacity(before) * (at - before);
                        self.temperature[node] = at;
                        self.fixed[node] = true;
                    }
                }
            }
        }
    }

    fn flip(&mut self, case: &Case) {
        self.upside_down = !self.upside_down;
        self.set_boundaries(case);
        self.refresh(case);
    }

    /// Properties at the nodes' temperatures and the longest explicit step.
    fn refresh(&mut self, case: &Case) {
        for (i, &t) in self.temperature.iter().enumerate() {
            self.capacity[i] = self.body.graph.volume[i] * case.material.capacity(t);
            self.conductivity[i] = case.material.conductivity(t);
        }
        self.conduction.refresh(&self.body.graph, &self.conductivity);
        let exchange: Vec<f64> = self.exchange.iter().map(|e| e[0]).collect();
        // ΣG/C bounds half the largest eigenvalue, which explicit steps of that length resolve (Gershgorin).
        self.explicit = self.conduction.stable_step_with(&self.capacity, &exchange);
    }

    /// Moves to `until` in equal super-steps.
    fn advance_to(&mut self, until: f64, case: &Case, recording: &mut Recording) {
        let longest = SAFETY * self.explicit * ((STAGES * STAGES + STAGES - 2) as f64) * 0.25;
        let count = libm::ceil((until - self.time) / longest).max(1.0);
        let (from, dt) = (self.time, (until - self.time) / count);
        for i in 1..=count as usize {
            if case.material.varies() {
                self.refresh(case);
            }
            self.super_step(dt);
            self.time = from + dt * i as f64;
            self.steps += 1;
            recording.observe(self, dt, case);
            if recording.stopped_at.is_some() {
                return;
            }
        }
    }

    fn super_step(&mut self, dt: f64) {
        let before: f64 = self.temperature.iter().zip(&self.capacity).map(|(t, c)| t * c).sum();
        let Self { body, conduction, temperature, capacity, exchange, fixed, step, .. } = self;
        step.advance(temperature, dt, |t, rate| {
            for ((r, t), [g, s]) in rate.iter_mut().zip(t).zip(exchange.iter()) {
                *r = s - g * t;
            }
            conduction.add_power(&body.graph, t, rate);
            for ((r, c), fixed) in rate.iter_mut().zip(capacity.iter()).zip(fixed.iter()) {
                *r = if *fixed { 0.0 } else { *r / c };
            }
        });
        let after: f64 = self.temperature.iter().zip(&self.capacity).map(|(t, c)| t * c).sum();
        self.absorbed += after - before;
    }
}

fn opposite(end: End) -> End {
    if end == End::Low { End::High } else { End::Low }
}

/// A probe: nodes and weights that interpolate there, and what it has read: time [s] and temperature [°C].
struct Probe {
    name: String,
    weights: Vec<(usize, f64)>,
    series: Vec<[f64; 2]>,
}

/// What is remembered of a run.
struct Recording {
    probes: Vec<Probe>,
    peak: Vec<f64>,
    coldest_peak: f64,
    range: [f64; 2],
    stopped_at: Option<f64>,
}

impl Recording {
    fn new(case: &Case, solver: &Solver) -> Self {
        let probe = |(name, place): &(String, Vec<f64>)| Probe {
            name: name.clone(),
            weights: solver.body.locate(place),
            series: Vec::new(),
        };
        let mut recording = Self {
            probes: case.probes.iter().map(probe).collect(),
            peak: solver.temperature.clone(),
            coldest_peak: lowest(&solver.temperature),
            range: [lowest(&solver.temperature), highest(&solver.temperature)],
            stopped_at: None,
        };
        recording.read(solver);
        recording
    }

    fn read(&mut self, solver: &Solver) {
        for probe in &mut self.probes {
            let value: f64 = probe.weights.iter().map(|(n, w)| w * solver.temperature[*n]).sum();
            probe.series.push([solver.time, celsius(value)]);
        }
    }

    /// Takes peaks and range after a step of `dt`; the stop is placed within the step by the coldest peak's rise.
    fn observe(&mut self, solver: &Solver, dt: f64, case: &Case) {
        self.peak.iter_mut().zip(&solver.temperature).for_each(|(p, t)| *p = p.max(*t));
        self.range = [self.range[0].min(lowest(&solver.temperature)), self.range[1].max(highest(&solver.temperature))];
        let (before, now) = (self.coldest_peak, lowest(&self.peak));
        self.coldest_peak = now;
        if let Some(target) = case.stop_at.filter(|target| now >= *target) {
            let share = if now > before { ((target - before) / (now - before)).clamp(0.0, 1.0) } else { 0.0 };
            self.stopped_at = Some(solver.time - dt * (1.0 - share));
        }
    }

    fn report(self, case: &Case, solver: &Solver, wall_s: f64) -> LabReport {
        let volume = &solver.body.graph.volume;
        let whole: f64 = volume.iter().sum();
        let above = |c: f64| {
            let hot = self.peak.iter().zip(volume).filter(|(p, _)| celsius(**p) > c).map(|(_, v)| v);
            100.0 * hot.sum::<f64>() / whole
        };
        LabReport {
            name: case.name.clone(),
            nodes: solver.body.node_count(),
            steps: solver.steps,
            wall_s,
            stopped_at_s: self.stopped_at,
            volume_pct_above: case.volume_above_c.iter().map(|&c| (format!("{c}"), above(c))).collect(),
            absorbed_j: solver.absorbed,
            max_c: celsius(self.range[1]),
            min_c: celsius(self.range[0]),
            probes: self.probes.into_iter().map(|p| (p.name, p.series)).collect(),
        }
    }
}

fn lowest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn highest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}
