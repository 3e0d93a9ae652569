//! Recording of a conduction run: probes, fluxes, peaks.

use saute_heat::conduction::axis::End;

use crate::case::Shape;
use crate::case::{Case, ProbeCase};
use crate::result::report::LabReport;
use crate::solve::solver::Solver;
use saute_kitchen::celsius;

/// Number of nodes along each axis for the interpolation of a probe: a cubic.
const CUBIC: usize = 4;
/// The same where an evaporation front moves through the body, at which a cubic overshoots.
pub(crate) const LINEAR: usize = 2;

/// Nodes and weights of the interpolation at a point, and the readings: time [s] and value.
struct Reading {
    name: String,
    weights: Vec<(usize, f64)>,
    series: Vec<[f64; 2]>,
}

/// A heat flux: weights of the gradient [1/m], and the layer of the conductivity.
struct Flux {
    reading: Reading,
    layer: usize,
}

/// The recording of a run.
pub(crate) struct Recording {
    probes: Vec<Reading>,
    fluxes: Vec<Flux>,
    /// Highest temperature of each node [K], if the case needs it.
    peak: Option<Vec<f64>>,
    coldest_peak: f64,
    range: [f64; 2],
    /// Highest temperature of the probe `peak_of` [K] and its time [s].
    core_peak: Option<[f64; 2]>,
    /// Times at which the phases ended [s].
    pub phases_ended: Vec<f64>,
    /// Time at which the stop condition was met [s].
    pub stopped_at: Option<f64>,
}

impl Reading {
    fn value(&self, field: &[f64]) -> f64 {
        self.weights.iter().map(|(n, w)| w * field[*n]).sum()
    }
}

impl Recording {
    pub(crate) fn new(case: &Case, solver: &Solver) -> Self {
        let points = if case.materials.iter().any(|m| m.boiling.is_some()) { LINEAR } else { CUBIC };
        let reading = |probe: &ProbeCase, weights| Reading { name: probe.name.clone(), weights, series: Vec::new() };
        let mut probes: Vec<Reading> =
            case.probes.iter().map(|p| reading(p, solver.body.locate(&p.place, points))).collect();
        probes.extend(case.pan.map(|_| pan(solver)));
        let flux = |probe: &ProbeCase| {
            let place = probe.place[solver.body.vertical?];
            let weights = solver.body.locate_slope(&probe.place, points);
            Some(Flux { reading: reading(probe, weights), layer: solver.body.layer_at(place)? })
        };
        let range = [lowest(&solver.temperature), highest(&solver.temperature)];
        let mut recording = Self {
            probes,
            fluxes: case.probes.iter().filter(|p| p.flux).filter_map(flux).collect(),
            peak: (case.stop_at.is_some() || !case.volume_above_c.is_empty()).then(|| solver.temperature.clone()),
            coldest_peak: range[0],
            range,
            core_peak: None,
            phases_ended: Vec::new(),
            stopped_at: None,
        };
        recording.observe_core(case, solver);
        recording.read(case, solver);
        recording
    }

    /// Reads every probe.
    pub(crate) fn read(&mut self, case: &Case, solver: &Solver) {
        for probe in &mut self.probes {
            let value = probe.value(&solver.temperature);
            probe.series.push([solver.time, celsius(value)]);
        }
        for flux in &mut self.fluxes {
            let node = flux.reading.weights.first().map_or(0, |w| w.0);
            let conductivity = solver.conductivity(case, flux.layer, node);
            let value = -conductivity * flux.reading.value(&solver.temperature);
            flux.reading.series.push([solver.time, value]);
        }
    }

    /// Returns the share of the last step at which a probe crossed a temperature [-]; `None` if it did not.
    pub(crate) fn crossing(&self, probe: usize, target: f64, solver: &Solver) -> Option<f64> {
        let [before, now] =
            [solver.before(), &solver.temperature].map(|field| self.probes[probe].value(field) - target);
        (before * now <= 0.0).then(|| if before == now { 0.0 } else { before / (before - now) })
    }

    /// Updates peaks and range after a step; interpolates the stop within the step by the coldest peak.
    pub(crate) fn observe(&mut self, case: &Case, solver: &Solver) {
        let [mut low, mut high] = self.range;
        for &t in &solver.temperature {
            low = if t < low { t } else { low };
            high = if t > high { t } else { high };
        }
        self.range = [low, high];
        self.observe_core(case, solver);
        if let Some(peak) = &mut self.peak {
            peak.iter_mut().zip(&solver.temperature).for_each(|(p, t)| *p = if *t > *p { *t } else { *p });
        }
        if let (Some(target), Some(peak)) = (case.stop_at, &self.peak) {
            let (before, now) = (self.coldest_peak, lowest(peak));
            self.coldest_peak = now;
            if now >= target {
                let share = if now > before { ((target - before) / (now - before)).clamp(0.0, 1.0) } else { 0.0 };
                self.stopped_at = Some(solver.time - solver.last_dt() * (1.0 - share));
            }
        }
    }

    fn observe_core(&mut self, case: &Case, solver: &Solver) {
        let Some(probe) = case.peak_of else { return };
        let now = self.probes[probe].value(&solver.temperature);
        if self.core_peak.is_none_or(|[peak, _]| now > peak) {
            self.core_peak = Some([now, solver.time]);
        }
    }

    pub(crate) fn report(self, case: &Case, solver: &Solver, wall_s: f64) -> LabReport {
        let volume = &solver.body.volume;
        let whole: f64 = volume.iter().sum();
        let above = |c: f64| {
            let hot = self.peak.iter().flatten().zip(volume).filter(|(p, _)| celsius(**p) > c).map(|(_, v)| v);
            if whole > 0.0 { 100.0 * hot.sum::<f64>() / whole } else { 0.0 }
        };
        let dried = solver.dried();
        let (per_area, whole_body) = if case.shape == Shape::Slab { (dried, None) } else { (None, dried) };
        LabReport {
            nodes: solver.body.node_count(),
            steps: solver.steps,
            wall_s,
            stopped_at_s: self.stopped_at,
            volume_pct_above: case.volume_above_c.iter().map(|&c| (format!("{c}"), above(c))).collect(),
            absorbed_j: solver.absorbed(),
            max_c: celsius(self.range[1]),
            min_c: celsius(self.range[0]),
            evaporated_kg_m2: per_area.map(|d| d[0]),
            crust_mm: per_area.map(|d| 1e3 * d[1]),
            evaporated_g: whole_body.map(|d| 1e3 * d[0]),
            core_peak_c: self.core_peak.map(|[peak, _]| celsius(peak)),
            core_peak_at_s: self.core_peak.map(|[_, at]| at),
            phases_ended_s: self.phases_ended,
            flux: self.fluxes.into_iter().map(|f| (f.reading.name, f.reading.series)).collect(),
            probes: self.probes.into_iter().map(|p| (p.name, p.series)).collect(),
            ..LabReport::empty(case)
        }
    }
}

/// Returns the reading of the mean temperature of the pan.
fn pan(solver: &Solver) -> Reading {
    let face = solver.body.vertical.map(|v| solver.body.face(v, End::Low)).unwrap_or_default();
    let area: f64 = face.iter().map(|(_, a)| a).sum();
    Reading { name: "pan".into(), weights: face.iter().map(|(n, a)| (*n, a / area)).collect(), series: Vec::new() }
}

fn lowest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, |a, b| if b < a { b } else { a })
}

fn highest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, |a, b| if b > a { b } else { a })
}
