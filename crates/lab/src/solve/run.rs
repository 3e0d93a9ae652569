//! Runs a lab case.

use crate::case::Physics;
use crate::case::{Case, Until};
use crate::result::recording::Recording;
use crate::result::report::LabReport;
use crate::solve::cooking::cook;
use crate::solve::solver::Solver;
use crate::solve::watch::Watch;

/// Runs a case. `clock` returns wall time [s], for the report only.
pub fn run(case: &Case, clock: impl Fn() -> f64) -> LabReport {
    run_watched(case, clock, &mut Watch::none())
}

/// As [`run`], with a watch that receives the fields on the way; the case that it is compared with is not watched.
pub fn run_watched(case: &Case, clock: impl Fn() -> f64, watch: &mut Watch) -> LabReport {
    let mut report = run_one(case, &clock, watch);
    report.compared = case.compare.as_ref().map(|other| Box::new(run_one(other, &clock, &mut Watch::none())));
    report
}

fn run_one(case: &Case, clock: &impl Fn() -> f64, watch: &mut Watch) -> LabReport {
    match (case.physics, &case.cooking) {
        (Physics::Cooking, Some(cooking)) => cook(case, cooking, clock, watch),
        _ => conduct(case, clock, watch),
    }
}

fn conduct(case: &Case, clock: &impl Fn() -> f64, watch: &mut Watch) -> LabReport {
    let solver = Solver::new(case);
    let recording = Recording::new(case, &solver);
    let start = clock();
    let mut run = Run { case, solver, recording, phase: 0, flips: 0 };
    watch.look(run.solver.time, || run.solver.fields());
    for &output in &case.outputs {
        while !run.is_over() && run.solver.time < output {
            run.advance_to(output.min(run.next_event()), watch);
            run.meet_events();
        }
        if run.is_over() {
            break;
        }
        run.recording.read(case, &run.solver);
    }
    if run.is_over() {
        run.recording.read(case, &run.solver);
    }
    watch.end(run.solver.time, || run.solver.fields());
    run.recording.report(case, &run.solver, clock() - start)
}

/// A conduction run with its position in the schedule.
struct Run<'a> {
    case: &'a Case,
    solver: Solver,
    recording: Recording,
    /// Index of the current phase.
    phase: usize,
    /// Number of flips so far.
    flips: usize,
}

impl Run<'_> {
    fn is_over(&self) -> bool {
        self.recording.stopped_at.is_some()
    }

    /// Returns the time of the next flip or the next end of a phase [s].
    fn next_event(&self) -> f64 {
        let flip = self.case.flips.get(self.flips).copied().unwrap_or(f64::INFINITY);
        match self.until() {
            Until::Time(end) => flip.min(end),
            _ => flip,
        }
    }

    fn meet_events(&mut self) {
        while self.case.flips.get(self.flips).is_some_and(|at| *at <= self.solver.time) {
            self.flips += 1;
            self.solver.flip(self.case);
        }
        while matches!(self.until(), Until::Time(end) if end <= self.solver.time) {
            self.end_phase();
        }
    }

    fn end_phase(&mut self) {
        self.recording.phases_ended.push(self.solver.time);
        self.phase += 1;
        if self.phase < self.case.phases.len() {
            self.solver.enter(self.phase, self.case);
        }
    }

    /// Returns the end of the current phase; after the last one its boundaries remain.
    fn until(&self) -> Until {
        self.case.phases.get(self.phase).map_or(Until::Forever, |p| p.until)
    }

    /// Advances to `until` [s], or to the end of the run if that comes first.
    fn advance_to(&mut self, until: f64, watch: &mut Watch) {
        while self.solver.time < until {
            let dt = self.solver.next_step(until, self.case);
            self.solver.advance(dt, self.case);
            self.solver.settle_at(until);
            let crossed = match self.until() {
                Until::Probe(probe, target) => self.recording.crossing(probe, target, &self.solver),
                _ => None,
            };
            if let Some(share) = crossed {
                self.solver.rewind(share, self.case);
            }
            self.recording.observe(self.case, &self.solver);
            watch.look(self.solver.time, || self.solver.fields());
            if crossed.is_some() {
                self.end_phase();
            }
            if self.is_over() {
                return;
            }
        }
    }
}
