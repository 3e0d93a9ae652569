//! Time integration of conduction: Runge–Kutta–Legendre super-steps on the product mesh (method of lines).

use saute_food::NodeField;
use saute_heat::Rule;
use saute_heat::conduction::axis::End;
use saute_heat::conduction::boundary::Boundary;
use saute_heat::conduction::product::{Constants, FaceBoundary, ProductOperator};
use saute_heat::conduction::super_step::SuperStep;
use saute_heat::conduction::tensor::{Part, TensorBody};

use crate::case::{Case, Radiation};
use crate::solve::body::mesh;
use crate::solve::edge_system::EdgeSystem;
use crate::solve::material::Material;

/// Largest number of stages of a super-step with constant properties at a step factor of 1 (chosen: the error in time
/// stays well below that in space).
const MOST_STAGES: usize = 9;
/// The same with variable properties, which are updated at every step (chosen: the length of seven explicit steps).
const MOST_STAGES_VARYING: usize = 5;
/// Used share of the stability limit [-] (chosen).
const SAFETY: f64 = 0.95;
/// Step over the time since the last change of a boundary [-] (chosen: profiles grow as the square root of time, so equal
/// relative steps have equal relative errors).
const GROWTH: f64 = 0.01;
/// The same with variable properties, which are constant during a step and first order in time [-] (chosen: the error is
/// less than 0.05 K).
const GROWTH_VARYING: f64 = 0.04;
/// First step of a pan alone over its time constant [-] (chosen: the relative error of a step is 1e-4).
const LUMPED_STEP: f64 = 0.01;

/// Spatial operator.
enum System {
    /// Constant properties with shape functions and linear boundaries: a product of one-dimensional operators.
    Product(Box<ProductOperator>),
    /// All other cases: edge by edge.
    Edges(Box<EdgeSystem>),
}

impl System {
    fn new(case: &Case, body: &TensorBody) -> Self {
        let layers: Option<Vec<Constants>> = case.materials.iter().map(Material::constants).collect();
        match layers {
            Some(layers) if case.rule == Rule::ShapeFunctions && !radiates(case) => {
                Self::Product(Box::new(ProductOperator::new(body, &layers, &[])))
            }
            _ => Self::Edges(Box::new(EdgeSystem::new(case, body))),
        }
    }
}

/// A body and its state.
pub(crate) struct Solver {
    /// Mesh.
    pub body: TensorBody,
    /// Temperature of each node [K].
    pub temperature: Vec<f64>,
    /// Time [s].
    pub time: f64,
    /// Number of steps so far.
    pub steps: usize,
    system: System,
    step: SuperStep,
    explicit: f64,
    boundaries: Vec<FaceBoundary>,
    radiation: Vec<(usize, End, Radiation)>,
    upside_down: bool,
    changed_at: f64,
    last_dt: f64,
    /// Heat absorbed by variable capacities, by boiling and by fixed-temperature faces [J].
    absorbed: f64,
    /// Heat stored at the start, for constant capacities [J].
    stored_at_start: f64,
    capacity: Vec<f64>,
}

impl Solver {
    pub(crate) fn new(case: &Case) -> Self {
        let body = mesh(case);
        let n = body.node_count();
        let initial = |layer: usize| case.bodies[layer].initial;
        let capacity: Vec<f64> = (0..n).map(|node| capacity(case, &body, node, &initial)).collect();
        let temperature = start(case, &body);
        let mut solver = Self {
            system: System::new(case, &body),
            stored_at_start: stored(&temperature, &capacity),
            temperature,
            time: 0.0,
            steps: 0,
            step: SuperStep::new(n),
            explicit: 0.0,
            boundaries: case.phases[0].boundaries.clone(),
            radiation: case.phases[0].radiation().collect(),
            upside_down: false,
            changed_at: 0.0,
            last_dt: 0.0,
            absorbed: 0.0,
            capacity,
            body,
        };
        solver.put_on(case);
        solver
    }

    /// Sets the boundaries of a phase.
    pub(crate) fn enter(&mut self, phase: usize, case: &Case) {
        self.boundaries.clone_from(&case.phases[phase].boundaries);
        self.radiation = case.phases[phase].radiation().collect();
        self.put_on(case);
    }

    /// Exchanges the boundaries of bottom and top.
    pub(crate) fn flip(&mut self, case: &Case) {
        self.upside_down = !self.upside_down;
        self.put_on(case);
    }

    /// Applies the boundaries; an odd number of flips exchanges those of bottom and top.
    fn put_on(&mut self, case: &Case) {
        let swapped = |axis: usize| self.upside_down && self.body.vertical == Some(axis);
        let there = |axis: usize, end: End| if swapped(axis) { opposite(end) } else { end };
        let boundaries: Vec<FaceBoundary> = self.boundaries.iter().map(|&(a, end, b)| (a, there(a, end), b)).collect();
        let radiation: Vec<_> = self.radiation.iter().map(|&(a, end, r)| (a, there(a, end), r)).collect();
        self.hold_fixed_faces(&boundaries, case);
        match &mut self.system {
            System::Product(operator) => {
                let layers: Vec<Constants> = case.materials.iter().filter_map(Material::constants).collect();
                **operator = ProductOperator::new(&self.body, &layers, &boundaries);
                self.explicit = operator.stable_step();
            }
            System::Edges(edges) => {
                edges.put_on(&self.body, &boundaries, &radiation);
                self.explicit = edges.refresh(&self.body, case, &self.temperature);
            }
        }
        self.changed_at = self.time;
    }

    /// Sets the nodes of fixed-temperature faces.
    fn hold_fixed_faces(&mut self, boundaries: &[FaceBoundary], case: &Case) {
        for &(axis, end, boundary) in boundaries {
            let Boundary::Fixed(at) = boundary else { continue };
            for (node, _) in self.body.face(axis, end) {
                let before = self.temperature[node];
                self.absorbed += capacity(case, &self.body, node, &|_| before) * (at - before);
                self.temperature[node] = at;
            }
        }
    }

    /// Returns the longest step over the explicit one, and the growth of steps after a change of a boundary [-].
    fn reach(&self) -> (f64, f64) {
        match &self.system {
            System::Edges(edges) if edges.boils() => (1.0, GROWTH),
            System::Edges(edges) if edges.varies() => (SuperStep::reach(MOST_STAGES_VARYING), GROWTH_VARYING),
            System::Product(_) | System::Edges(_) => (SuperStep::reach(MOST_STAGES), GROWTH),
        }
    }

    /// Returns the longest step and the longest explicit step with the present boundaries [s].
    pub(crate) fn longest_step(&self, case: &Case) -> [f64; 2] {
        [case.step_factor * SAFETY * self.reach().0 * self.explicit, self.explicit]
    }

    /// Returns the length of the next step towards `until` [s].
    pub(crate) fn next_step(&self, until: f64, case: &Case) -> f64 {
        let (reach, growth) = self.reach();
        let most = SAFETY * reach * self.explicit;
        let since = self.time - self.changed_at;
        let first = if self.temperature.len() == 1 { LUMPED_STEP } else { SAFETY } * self.explicit;
        let wanted = case.step_factor * most.min((growth * since).max(first));
        let left = until - self.time;
        left / libm::ceil(left / wanted - 1e-9).max(1.0)
    }

    /// Advances by `dt` [s].
    pub(crate) fn advance(&mut self, dt: f64, case: &Case) {
        self.last_dt = dt;
        self.time += dt;
        self.steps += 1;
        self.super_step(dt, case);
    }

    /// Sets the time to `until` [s] if the difference is rounding.
    pub(crate) fn settle_at(&mut self, until: f64) {
        if (self.time - until).abs() <= 1e-9 * until.max(1.0) {
            self.time = until;
        }
    }

    fn super_step(&mut self, dt: f64, case: &Case) {
        let stages = SuperStep::stages_for(dt, self.explicit);
        match &mut self.system {
            System::Product(operator) => self.step.advance(&mut self.temperature, dt, stages, &**operator),
            System::Edges(edges) => {
                if edges.varies() || edges.radiates() {
                    self.explicit = edges.refresh(&self.body, case, &self.temperature);
                }
                self.absorbed += edges.advance(&mut self.temperature, dt, &mut self.step, self.explicit);
            }
        }
    }

    /// Repeats the last step with only the given share of its length; does nothing where water boils.
    pub(crate) fn rewind(&mut self, share: f64, case: &Case) {
        let boils = matches!(&self.system, System::Edges(edges) if edges.boils());
        if boils || share >= 1.0 {
            return;
        }
        if let System::Edges(edges) = &self.system {
            self.absorbed -= edges.stored_since(&self.temperature, self.step.start());
        }
        self.temperature.copy_from_slice(self.step.start());
        let dt = self.last_dt * share;
        self.time -= self.last_dt - dt;
        self.last_dt = dt;
        if dt > 0.0 {
            self.super_step(dt, case);
        }
    }

    /// Returns the temperatures before the last step [K].
    pub(crate) fn before(&self) -> &[f64] {
        self.step.start()
    }

    /// Returns the length of the last step [s].
    pub(crate) fn last_dt(&self) -> f64 {
        self.last_dt
    }

    /// Returns the heat absorbed since the start [J]; of a slab [J/m²].
    pub(crate) fn absorbed(&self) -> f64 {
        match &self.system {
            System::Product(_) => stored(&self.temperature, &self.capacity) - self.stored_at_start,
            System::Edges(_) => self.absorbed,
        }
    }

    /// Returns the evaporated water [kg] and the dried volume [m³], of a slab per m²; `None` where no water boils.
    pub(crate) fn dried(&self) -> Option<[f64; 2]> {
        match &self.system {
            System::Edges(edges) if edges.boils() => Some(edges.dried()),
            _ => None,
        }
    }

    /// Returns the body with the fields of its nodes.
    pub(crate) fn fields(&self) -> (&TensorBody, Vec<NodeField<'_>>) {
        let mut fields = vec![
            NodeField::celsius("temperature_c", &self.temperature),
            NodeField::point("temperature_k", "K", &self.temperature),
            NodeField::amount("volume_m3", "m³", &self.body.volume),
        ];
        if let System::Edges(edges) = &self.system
            && edges.boils()
        {
            let dried = (0..self.temperature.len()).map(|node| edges.dried_share(node)).collect();
            fields.push(NodeField::computed("dried", "", dried));
        }
        (&self.body, fields)
    }

    /// Returns the thermal conductivity of a layer at a node [W/(m·K)].
    pub(crate) fn conductivity(&self, case: &Case, layer: usize, node: usize) -> f64 {
        let dried = match &self.system {
            System::Edges(edges) => edges.dried_share(node),
            System::Product(_) => 0.0,
        };
        case.materials[layer].conductivity(self.temperature[node], dried)
    }
}

/// Returns true if any face exchanges thermal radiation.
fn radiates(case: &Case) -> bool {
    case.phases.iter().any(|phase| phase.radiation().next().is_some())
}

fn stored(temperature: &[f64], capacity: &[f64]) -> f64 {
    temperature.iter().zip(capacity).map(|(t, c)| t * c).sum()
}

/// Returns the other end of an axis.
pub(crate) fn opposite(end: End) -> End {
    if end == End::Low { End::High } else { End::Low }
}

/// Returns the heat capacity of a node [J/K], of a slab [J/(m²·K)], with the temperature of each layer [K].
pub(crate) fn capacity(case: &Case, body: &TensorBody, node: usize, temperature: &dyn Fn(usize) -> f64) -> f64 {
    let heat = |p: Part| p.volume * case.materials[p.layer].capacity(temperature(p.layer));
    body.parts(node).map(heat).sum::<f64>() + body.plate_capacity(node)
}

/// Returns the initial temperatures [K]. A node shared by two bodies has the mean, weighted by heat capacity.
fn start(case: &Case, body: &TensorBody) -> Vec<f64> {
    let of = |n: usize| {
        let parts = body.parts(n).map(|p| {
            let initial = case.bodies[p.layer].initial;
            (p.volume * case.materials[p.layer].capacity(initial), initial)
        });
        let plate = case.pan.map_or((0.0, 0.0), |pan| (body.plate_capacity(n), pan.initial));
        let (heat, capacity) = parts.chain([plate]).fold((0.0, 0.0), |(q, c), (part, t)| (q + part * t, c + part));
        heat / capacity
    };
    (0..body.node_count()).map(of).collect()
}
