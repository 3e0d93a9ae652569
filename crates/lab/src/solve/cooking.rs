//! Runs the full food model on a plain body with given boundary conditions.

use std::collections::BTreeMap;

use saute_food::{Exchange, FoodModel, FoodSolver, FoodState, FreeAir, Lab, NodeField, Surroundings, Touch};
use saute_heat::conduction::axis::End;
use saute_heat::conduction::boundary::Boundary;
use saute_heat::conduction::tensor::TensorBody;

use crate::case::{Case, CookingCase, Medium, Phase, Radiation, Until};
use crate::case::{Contact, Shape};
use crate::result::recording::LINEAR;
use crate::result::report::LabReport;
use crate::solve::body::vertical;
use crate::solve::cooking_body::FoodBody;
use crate::solve::solver::opposite;
use crate::solve::watch::Watch;
use saute_kitchen::piece::contact::{FaceContact, PatchGap, wetness};
use saute_kitchen::{TICK_S, celsius};

/// Largest heat transfer coefficient of air; above it the medium is a solid or a liquid [W/(m²·K)] (chosen: forced
/// convection of air reaches 100).
const MOST_OF_AIR: f64 = 100.0;
/// Conductance of an insulated face [W/(m²·K)] (chosen: negligible; [`Touch::Closed`] would be exact, but would change
/// the last digits of recorded results).
const INSULATED: f64 = 1e-12;

/// Runs a case with the full food model. `clock` returns wall time [s], for the report only.
pub fn cook(case: &Case, cooking: &CookingCase, clock: &impl Fn() -> f64, watch: &mut Watch) -> LabReport {
    // The library checks composition and names of changes, the case everything else, so this cannot fail.
    let Ok(body) = FoodBody::new(case, cooking) else { return LabReport::empty(case) };
    let mut run = Cooking::new(case, cooking, body);
    let start = clock();
    run.read();
    watch.look(run.time(), || run.fields());
    for &output in &case.outputs {
        while run.stopped_at.is_none() && run.time() < output - 0.5 * run.dt {
            run.step();
            watch.look(run.time(), || run.fields());
        }
        run.read();
        if run.stopped_at.is_some() {
            break;
        }
    }
    watch.end(run.time(), || run.fields());
    run.report(clock() - start)
}

/// A cooking run and its state.
struct Cooking<'a> {
    case: &'a Case,
    cooking: &'a CookingCase,
    body: FoodBody,
    state: FoodState,
    solver: FoodSolver,
    dt: f64,
    steps: usize,
    flips: usize,
    phase: usize,
    /// Time of the last change of the faces [s].
    laid_at: f64,
    touch: Vec<Touch>,
    /// Air at each end of each axis.
    air: Vec<FreeAir>,
    probes: Vec<Vec<(usize, f64)>>,
    series: Vec<Vec<[f64; 2]>>,
    absorbed: f64,
    /// Time [s] and mean contact conductance to a pan [W/(m²·K)], every second.
    contact: Vec<[f64; 2]>,
    range: [f64; 2],
    core_peak: [f64; 2],
    phases_ended: Vec<f64>,
    stopped_at: Option<f64>,
}

impl<'a> Cooking<'a> {
    fn new(case: &'a Case, cooking: &'a CookingCase, body: FoodBody) -> Self {
        let initial = case.bodies[0].initial;
        let mut run = Self {
            state: FoodState::raw(&body.model, initial),
            solver: FoodSolver::default(),
            dt: (TICK_S * case.step_factor).min(case.duration),
            steps: 0,
            flips: 0,
            phase: 0,
            laid_at: 0.0,
            touch: vec![Touch::default(); body.model.patches().len()],
            air: vec![cooking.room.still_air(); body.ends.len()],
            probes: case.probes.iter().map(|p| body.tensor.locate(&p.place, LINEAR)).collect(),
            series: vec![Vec::new(); case.probes.len()],
            absorbed: 0.0,
            contact: Vec::new(),
            range: [initial; 2],
            core_peak: [initial, 0.0],
            phases_ended: Vec::new(),
            stopped_at: None,
            case,
            cooking,
            body,
        };
        run.meet();
        run
    }

    /// Returns the body with the fields of its nodes.
    fn fields(&self) -> (&TensorBody, Vec<NodeField<'_>>) {
        (&self.body.tensor, self.body.model.node_fields(&self.state))
    }

    fn time(&self) -> f64 {
        self.steps as f64 * self.dt
    }

    /// Returns the current phase; after the last one its boundaries remain.
    fn phase(&self) -> &'a Phase {
        &self.case.phases[self.phase.min(self.case.phases.len() - 1)]
    }

    /// Returns the end of the current phase.
    fn until(&self) -> Until {
        self.case.phases.get(self.phase).map_or(Until::Forever, |p| p.until)
    }

    fn probe(&self, probe: usize) -> f64 {
        self.probes[probe].iter().map(|(node, weight)| weight * self.state.temperature[*node]).sum()
    }

    /// Returns the temperature whose highest value is reported: that of a named probe, or of the centre [K].
    fn core(&self) -> f64 {
        match self.case.peak_of {
            Some(probe) => self.probe(probe),
            None => self.body.model.at_core(&self.state.temperature),
        }
    }

    fn step(&mut self) {
        self.events();
        self.meet();
        let around = Surroundings { touch: &self.touch, air: &self.air, pressed: 0.0 };
        let before = self.to_target();
        let exchange = self.solver.advance(&self.body.model, &mut self.state, &around, self.dt);
        self.steps += 1;
        self.observe(&exchange);
        if before.zip(self.to_target()).is_some_and(|(before, now)| before * now <= 0.0) {
            self.end_phase();
        }
    }

    /// Returns the temperature of the probe that ends the phase, less its target [K].
    fn to_target(&self) -> Option<f64> {
        match self.until() {
            Until::Probe(probe, target) => Some(self.probe(probe) - target),
            _ => None,
        }
    }

    /// Carries out the flips and the ends of phases that are due.
    fn events(&mut self) {
        let now = self.time() + 0.5 * self.dt;
        while self.case.flips.get(self.flips).is_some_and(|at| *at < now) {
            self.flips += 1;
            self.laid_at = self.time();
        }
        while matches!(self.until(), Until::Time(end) if end < now) {
            self.end_phase();
        }
    }

    fn end_phase(&mut self) {
        self.phases_ended.push(self.time());
        self.phase += 1;
        self.laid_at = self.time();
    }

    /// Updates the boundary condition of every patch.
    fn meet(&mut self) {
        let phase = self.phase();
        self.touch.fill(Touch::Contact { conductance: INSULATED, temperature: self.case.bodies[0].initial });
        let upside_down = self.flips % 2 == 1;
        for at in 0..self.body.ends.len() {
            let (axis, end, _) = self.body.ends[at];
            let swapped = upside_down && vertical(self.case.shape) == Some(axis);
            let outer = if swapped { opposite(end) } else { end };
            let here = |f: &(usize, End)| *f == (axis, outer);
            let Some((.., boundary)) = phase.boundaries.iter().find(|b| here(&(b.0, b.1))) else { continue };
            let medium = phase.media.iter().find(|m| here(&(m.0, m.1))).map(|m| m.2);
            self.meet_end(at, boundary, medium.unwrap_or_default());
        }
    }

    fn meet_end(&mut self, at: usize, boundary: &Boundary, medium: Medium) {
        let range = self.body.ends[at].2.clone();
        let touch = match *boundary {
            Boundary::Fixed(temperature) => Touch::Fixed { temperature },
            Boundary::Exchange { h, source } => {
                let temperature = if h > 0.0 { source / h } else { self.air[0].temperature };
                Touch::Contact { conductance: h, temperature }
            }
        };
        let (h, outside) = (touch.conductance(), touch.temperature());
        match medium.contact {
            Some(Contact::Pan) => self.meet_pan(range, outside),
            Some(Contact::Air) => self.meet_air(at, h, outside, medium),
            None if h <= MOST_OF_AIR => self.meet_air(at, h, outside, medium),
            _ => self.touch[range].fill(touch),
        }
    }

    fn meet_air(&mut self, at: usize, h: f64, outside: f64, medium: Medium) {
        let moving = self.cooking.room.air_moving(h);
        let own = self.cooking.food.surface.emissivity;
        // The food model multiplies the share by the food's own emissivity.
        let share = |r: Radiation| if own > 0.0 { r.emissivity / own } else { 0.0 };
        self.air[at] = FreeAir {
            temperature: outside,
            walls: medium.radiation.map_or(outside, |r| r.surroundings),
            radiation: medium.radiation.map_or(0.0, share),
            vapour_density: medium.vapour_density.unwrap_or(moving.vapour_density),
            ..moving
        };
        self.touch[self.body.ends[at].2.clone()].fill(Touch::default());
    }

    fn meet_pan(&mut self, range: std::ops::Range<usize>, pan: f64) {
        let gap = &self.cooking.room.contact;
        let model = &self.body.model;
        let area: f64 = model.patches()[range.clone()].iter().map(|p| p.area).sum();
        let face = FaceContact {
            since: self.time() - self.laid_at,
            pressure: saute_food::GRAVITY * self.state.mass_left(model) / area,
            escape: 1e-3 * gap.vent_spacing_mm,
            film: self.cooking.room.default_film(),
            coating: None,
        };
        let (thickness, share) = (face.mean_gap(gap), model.description().surface.contact_share);
        let mut mean = 0.0;
        for patch in range {
            let node = model.patches()[patch].node as usize;
            let wetness = wetness(self.state.water[node] / model.initial_water()[node]);
            let conductance = face.conductance(gap, &PatchGap { thickness, pan, wetness }) * share;
            self.touch[patch] = Touch::Contact { conductance, temperature: pan };
            mean += conductance * model.patches()[patch].area / area;
        }
        if self.contact.last().is_none_or(|[last, _]| self.time() > last + 0.999) {
            self.contact.push([self.time(), mean]);
        }
    }

    fn observe(&mut self, exchange: &Exchange) {
        self.absorbed += self.solver.contact_heat.iter().sum::<f64>() - exchange.air;
        let (low, high) = self.state.range();
        self.range = [self.range[0].min(low), self.range[1].max(high)];
        let core = self.core();
        if core > self.core_peak[0] {
            self.core_peak = [core, self.time()];
        }
        // The food model updates its peaks every half second; a stop has to be exact to one step.
        self.state.peak.iter_mut().zip(&self.state.temperature).for_each(|(p, t)| *p = p.max(*t));
        if self.case.stop_at.is_some_and(|target| self.state.peak.iter().all(|p| *p >= target)) {
            self.stopped_at = Some(self.time());
        }
    }

    fn read(&mut self) {
        for probe in 0..self.probes.len() {
            let value = [self.time(), celsius(self.probe(probe))];
            self.series[probe].push(value);
        }
    }

    fn report(self, wall_s: f64) -> LabReport {
        let model = &self.body.model;
        let volume = model.mesh().volumes();
        let whole: f64 = volume.iter().sum();
        let above = |c: f64| {
            let hot = self.state.peak.iter().zip(volume).filter(|(p, _)| celsius(**p) > c).map(|(_, v)| v);
            100.0 * hot.sum::<f64>() / whole
        };
        let slab = self.case.shape == Shape::Slab;
        let (lateral, thickness) =
            (self.state.stretch.lateral, model.mesh().swept().map_or(0.0, |mesh| mesh.thickness()));
        let unsound = "a value became non-finite and the food stopped changing; use another resolution_mm or size_mm";
        let names = self.case.probes.iter().map(|p| p.name.clone());
        LabReport {
            nodes: model.mesh().node_count(),
            steps: self.steps,
            wall_s,
            warnings: if self.state.healthy { Vec::new() } else { vec![unsound.to_owned()] },
            stopped_at_s: self.stopped_at,
            volume_pct_above: self.case.volume_above_c.iter().map(|&c| (format!("{c}"), above(c))).collect(),
            absorbed_j: self.absorbed,
            max_c: celsius(self.range[1]),
            min_c: celsius(self.range[0]),
            evaporated_kg_m2: slab.then_some(self.state.evaporated),
            evaporated_g: Some(1e3 * self.state.evaporated),
            dripped_g: Some(1e3 * self.state.dripped),
            rendered_g: Some(1e3 * self.state.rendered),
            section_shrunk_pct: model.contracts().then_some(100.0 * (1.0 - lateral * lateral)),
            thickness_shrunk_pct: model.contracts().then(|| 100.0 * (1.0 - model.thickness(&self.state) / thickness)),
            contact_w_m2k: self.contact.clone(),
            lost_pct: Some(100.0 * (1.0 - self.state.mass(model) / model.raw_mass())),
            surface_lab: surface_lab(model, &self.state),
            core_peak_c: Some(celsius(self.core_peak[0])),
            core_peak_at_s: Some(self.core_peak[1]),
            probes: names.zip(self.series.iter().cloned()).collect(),
            phases_ended_s: self.phases_ended.clone(),
            ..LabReport::empty(self.case)
        }
    }
}

fn surface_lab(model: &FoodModel, state: &FoodState) -> BTreeMap<String, [f64; 3]> {
    let sides = [("bottom", [0.0, 0.0, 1.0]), ("top", [0.0, 0.0, -1.0])];
    let there = sides.into_iter().filter(|(name, _)| *name == "top" || !model.closed_below());
    there
        .map(|(name, up)| {
            let Lab(lab) = model.face_reading(state, up).lab;
            (name.to_owned(), lab)
        })
        .collect()
}
