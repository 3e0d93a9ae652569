//! The method of lines edge by edge, for variable properties, boiling water and the segment rule.

use saute_food::water::air_film::radiation_coefficient;
use saute_heat::Conduction;
use saute_heat::conduction::axis::End;
use saute_heat::conduction::boundary::Boundary;
use saute_heat::conduction::product::FaceBoundary;
use saute_heat::conduction::super_step::{Rates, SuperStep};
use saute_heat::conduction::tensor::{LayeredGraph, TensorBody};

use crate::case::{Case, Radiation};
use crate::solve::material::Boiling;
use crate::solve::solver::capacity;

/// Edges, conductances and water of a body: C dT/dt = Σ G (T_j − T) + s − g T + ε σ A (T_w⁴ − T⁴).
pub(super) struct EdgeSystem {
    edges: LayeredGraph,
    conduction: Conduction,
    capacity: Vec<f64>,
    /// Robin boundary of each node: conductance g [W/K] and source s [W].
    exchange: Vec<[f64; 2]>,
    radiating: Vec<Radiating>,
    fixed: Vec<bool>,
    varies: bool,
    water: Option<Water>,
}

/// A node that exchanges thermal radiation with its surroundings.
struct Radiating {
    node: usize,
    /// Emissivity × area [m²].
    black_area: f64,
    /// Temperature of the surroundings [K].
    surroundings: f64,
}

impl Radiating {
    /// Returns the heat flow into the node [W].
    fn power(&self, t: f64) -> f64 {
        radiation_coefficient(self.black_area, t, self.surroundings) * (self.surroundings - t)
    }

    /// Returns the largest slope of the heat flow between the node's temperature and that of the surroundings [W/K].
    fn slope(&self, t: f64) -> f64 {
        let hottest = t.max(self.surroundings);
        radiation_coefficient(self.black_area, hottest, hottest)
    }
}

/// Water of every node.
struct Water {
    /// Boiling data of the material of each node; `None` where it does not boil.
    boiling: Vec<Option<Boiling>>,
    /// Initial mass [kg]; infinite where evaporated water is replaced.
    initial: Vec<f64>,
    /// Remaining mass [kg].
    left: Vec<f64>,
    /// Volume of the boiling material [m³].
    volume: Vec<f64>,
    /// Evaporated mass [kg].
    evaporated: f64,
}

impl EdgeSystem {
    pub(super) fn new(case: &Case, body: &TensorBody) -> Self {
        let n = body.node_count();
        let boils = case.materials.iter().any(|m| m.boiling.is_some());
        Self {
            edges: body.layered_graph(case.rule),
            conduction: Conduction::default(),
            capacity: vec![0.0; n],
            exchange: vec![[0.0; 2]; n],
            radiating: Vec::new(),
            fixed: vec![false; n],
            varies: case.materials.iter().any(|m| m.constants().is_none()),
            water: boils.then(|| Water::new(case, body)),
        }
    }

    /// Sets the boundary conditions.
    pub(super) fn put_on(
        &mut self,
        body: &TensorBody,
        boundaries: &[FaceBoundary],
        radiation: &[(usize, End, Radiation)],
    ) {
        self.radiating = radiation.iter().flat_map(|r| radiating(body, r)).collect();
        self.exchange.fill([0.0; 2]);
        self.fixed.fill(false);
        for &(axis, end, boundary) in boundaries {
            for (node, area) in body.face(axis, end) {
                match boundary {
                    Boundary::Exchange { h, source } => {
                        self.exchange[node][0] += h * area;
                        self.exchange[node][1] += source * area;
                    }
                    Boundary::Fixed(_) => self.fixed[node] = true,
                }
            }
        }
    }

    /// Updates the properties at the node temperatures [K]; returns the longest stable explicit step [s].
    pub(super) fn refresh(&mut self, body: &TensorBody, case: &Case, temperature: &[f64]) -> f64 {
        for (node, c) in self.capacity.iter_mut().enumerate() {
            *c = capacity(case, body, node, &|_| temperature[node]);
        }
        let Self { conduction, edges, water, .. } = self;
        conduction.refresh_layers(edges, |layer, node| {
            let dried = water.as_ref().map_or(0.0, |w| w.dried_share(node));
            case.materials[layer].conductivity(temperature[node], dried)
        });
        // ΣG/C bounds half the largest eigenvalue, which explicit steps of that length resolve (Gershgorin).
        let mut totals: Vec<f64> = self.conduction.total.iter().zip(&self.exchange).map(|(g, e)| g + e[0]).collect();
        self.radiating.iter().for_each(|r| totals[r.node] += r.slope(temperature[r.node]));
        totals.iter().zip(&self.capacity).map(|(g, c)| c / g).fold(f64::INFINITY, f64::min)
    }

    /// Advances by `dt` [s]; returns the absorbed heat [J].
    pub(super) fn advance(&mut self, t: &mut Vec<f64>, dt: f64, step: &mut SuperStep, explicit: f64) -> f64 {
        let Some(mut water) = self.water.take() else {
            step.advance(t, dt, SuperStep::stages_for(dt, explicit), self);
            return self.stored_since(t, step.start());
        };
        step.euler(t, dt, self);
        let latent = water.boil(t, &self.capacity, &self.fixed);
        self.water = Some(water);
        self.stored_since(t, step.start()) + latent
    }

    /// Returns the heat stored between two states [J].
    pub(super) fn stored_since(&self, now: &[f64], before: &[f64]) -> f64 {
        now.iter().zip(before).zip(&self.capacity).map(|((n, b), c)| (n - b) * c).sum()
    }

    pub(super) fn varies(&self) -> bool {
        self.varies
    }

    pub(super) fn radiates(&self) -> bool {
        !self.radiating.is_empty()
    }

    pub(super) fn boils(&self) -> bool {
        self.water.is_some()
    }

    /// Returns the evaporated water [kg] and the dried volume [m³].
    pub(super) fn dried(&self) -> [f64; 2] {
        self.water
            .as_ref()
            .map_or([0.0; 2], |w| [w.evaporated, w.volume.iter().enumerate().map(|(n, v)| v * w.dried_share(n)).sum()])
    }

    pub(super) fn dried_share(&self, node: usize) -> f64 {
        self.water.as_ref().map_or(0.0, |w| w.dried_share(node))
    }
}

impl Rates for EdgeSystem {
    fn rates(&self, t: &[f64], rate: &mut [f64]) {
        for ((r, t), [g, s]) in rate.iter_mut().zip(t).zip(&self.exchange) {
            *r = s - g * t;
        }
        self.radiating.iter().for_each(|r| rate[r.node] += r.power(t[r.node]));
        self.conduction.add_power(&self.edges.graph, t, rate);
        for ((r, c), fixed) in rate.iter_mut().zip(&self.capacity).zip(&self.fixed) {
            *r = if *fixed { 0.0 } else { *r / c };
        }
    }
}

/// Returns the nodes of a radiating face.
fn radiating(body: &TensorBody, (axis, end, radiation): &(usize, End, Radiation)) -> Vec<Radiating> {
    let Radiation { surroundings, emissivity } = *radiation;
    let node = |(node, area)| Radiating { node, black_area: emissivity * area, surroundings };
    body.face(*axis, *end).into_iter().map(node).collect()
}

impl Water {
    fn new(case: &Case, body: &TensorBody) -> Self {
        let n = body.node_count();
        let mut water = Self {
            boiling: vec![None; n],
            initial: vec![0.0; n],
            left: Vec::new(),
            volume: vec![0.0; n],
            evaporated: 0.0,
        };
        for node in 0..n {
            for part in body.parts(node) {
                let Some(boiling) = case.materials[part.layer].boiling else { continue };
                water.boiling[node] = Some(boiling);
                water.volume[node] += part.volume;
                water.initial[node] += boiling.water.map_or(f64::INFINITY, |w| w * part.volume);
            }
        }
        water.left.clone_from(&water.initial);
        water
    }

    fn dried_share(&self, node: usize) -> f64 {
        let initial = self.initial[node];
        if initial > 0.0 && initial.is_finite() { 1.0 - self.left[node] / initial } else { 0.0 }
    }

    /// Converts heat above the boiling point into vapour while water remains; returns the latent heat of that vapour [J].
    ///
    /// Solves the Stefan problem by temperature recovery: a node stays at the boiling point until its water has
    /// evaporated. A fixed-temperature face above the boiling point dries at once.
    fn boil(&mut self, t: &mut [f64], capacity: &[f64], fixed: &[bool]) -> f64 {
        let mut latent = 0.0;
        for (node, t) in t.iter_mut().enumerate() {
            let Some(boiling) = self.boiling[node] else { continue };
            let excess = capacity[node] * (*t - boiling.at);
            if excess <= 0.0 || self.left[node] <= 0.0 {
                continue;
            }
            let vapour =
                if fixed[node] && self.left[node].is_finite() { self.left[node] } else { excess / boiling.latent };
            let vapour = vapour.min(self.left[node]);
            self.left[node] -= vapour;
            self.evaporated += vapour;
            latent += vapour * boiling.latent;
            if !fixed[node] {
                *t -= vapour * boiling.latent / capacity[node];
            }
        }
        latent
    }
}
