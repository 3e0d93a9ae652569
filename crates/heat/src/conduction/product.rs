//! Conduction with constant properties on a product mesh: one weight per axis and node, no storage per edge.

use crate::conduction::axis::End;
use crate::conduction::boundary::Boundary;
use crate::conduction::column::Between;
use crate::conduction::super_step::{Rates, Stage, StepStart};
use crate::conduction::tensor::TensorBody;

/// The constant thermal properties of a layer: conductivity [W/(m·K)] and capacity [J/(m³·K)].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Thermal conductivity [W/(m·K)].
    pub conductivity: f64,
    /// Volumetric heat capacity [J/(m³·K)].
    pub capacity: f64,
}

/// The boundary condition of one face: axis, end of the axis, condition.
pub type FaceBoundary = (usize, End, Boundary);

/// The conduction operator f(T) = dT/dt of a [`TensorBody`] with constant layers [K/s].
///
/// It gives the same rates as the edges of [`TensorBody::layered_graph`] under [`crate::Rule::ShapeFunctions`], to
/// rounding. A plane is the set of nodes with one index along the vertical axis; its properties are means over its layers.
/// Up to two axes are across the vertical one.
///
/// The centre of a sphere after a step of its surface temperature:
///
/// ```
/// use saute_heat::Boundary;
/// use saute_heat::conduction::axis::{Axis, End, Metric};
/// use saute_heat::conduction::product::{Constants, ProductOperator};
/// use saute_heat::conduction::super_step::SuperStep;
/// use saute_heat::conduction::tensor::TensorBody;
///
/// // A meatball of radius 15 mm at 283 K in boiling water.
/// let radius = Axis { metric: Metric::Spherical, nodes: (0..=60).map(|i| 0.25e-3 * f64::from(i)).collect() };
/// let ball = TensorBody::new(vec![radius]);
/// let meat = Constants { conductivity: 0.48, capacity: 3.7e6 };
/// let operator = ProductOperator::new(&ball, &[meat], &[(0, End::High, Boundary::Fixed(373.0))]);
/// let mut temperature_k = vec![283.0; ball.node_count()];
/// temperature_k[60] = 373.0;
/// let mut step = SuperStep::new(ball.node_count());
/// let stages = SuperStep::stages_for(1.0, operator.stable_step());
/// (0..300).for_each(|_| step.advance(&mut temperature_k, 1.0, stages, &operator));
///
/// // Carslaw & Jaeger (1959), section 9.3.
/// let fourier = 0.48 / 3.7e6 * 300.0 / (0.015 * 0.015);
/// let term = |n: i32| (-1f64).powi(n + 1) * (-(f64::from(n) * std::f64::consts::PI).powi(2) * fourier).exp();
/// let exact_k = 373.0 - 90.0 * 2.0 * (1..20).map(term).sum::<f64>();
/// assert!((temperature_k[0] - exact_k).abs() < 0.05, "{} K, exact {exact_k} K", temperature_k[0]);
/// ```
#[derive(Clone, Debug)]
pub struct ProductOperator {
    counts: [usize; 3],
    /// Weights of the previous and the next neighbour: axes across [1/m²], vertical axis [1/s].
    before: [Vec<f64>; 3],
    after: [Vec<f64>; 3],
    /// Thermal diffusivity of each plane along the axes across [m²/s].
    diffusivity: Vec<f64>,
    /// Height of each plane ÷ its areal heat capacity: the response to a flux through a side wall [m³·K/J].
    wall: Vec<f64>,
    /// Robin boundary at both ends of each axis as h and source: axes across per length, vertical axis [1/s] and [K/s].
    exchange: [[Option<[f64; 2]>; 2]; 3],
    fixed: [[bool; 2]; 3],
}

impl ProductOperator {
    /// Returns the operator of a body with the properties of its layers and the conditions of its faces.
    ///
    /// A face without a condition is adiabatic. Axes across the vertical one come first in the body, the vertical one last.
    pub fn new(body: &TensorBody, layers: &[Constants], boundaries: &[FaceBoundary]) -> Self {
        let planes = body.vertical.map_or(1, |v| body.axes[v].nodes.len());
        let across: Vec<usize> = (0..body.axes.len()).filter(|a| Some(*a) != body.vertical).collect();
        let count = |slot: usize| across.get(slot).map_or(1, |&a| body.axes[a].nodes.len());
        let mut operator = Self {
            counts: [count(0), count(1), planes],
            before: [vec![0.0; count(0)], vec![0.0; count(1)], vec![0.0; planes]],
            after: [vec![0.0; count(0)], vec![0.0; count(1)], vec![0.0; planes]],
            diffusivity: vec![0.0; planes],
            wall: vec![0.0; planes],
            exchange: [[None; 2]; 3],
            fixed: [[false; 2]; 3],
        };
        across.iter().enumerate().for_each(|(slot, &a)| operator.set_across(slot, body, a));
        let capacity = operator.set_planes(body, layers);
        operator.set_column(body, layers, &capacity);
        for &(axis, end, boundary) in boundaries {
            let slot = across.iter().position(|&a| a == axis);
            operator.set_boundary(body, (slot.unwrap_or(2), axis), end, boundary, &capacity);
        }
        operator
    }

    fn set_across(&mut self, slot: usize, body: &TensorBody, axis: usize) {
        let (axis, cells) = (&body.axes[axis], body.axes[axis].cells());
        for i in 0..cells.len() - 1 {
            let link = axis.link(i);
            self.after[slot][i] = link / cells[i];
            self.before[slot][i + 1] = link / cells[i + 1];
        }
    }

    /// Sets the properties of each plane for the axes across; returns their areal heat capacities [J/(m²·K)].
    fn set_planes(&mut self, body: &TensorBody, layers: &[Constants]) -> Vec<f64> {
        let sum = |plane: usize, of: &dyn Fn(&Constants) -> f64| -> f64 {
            body.plane_parts(plane).map(|(layer, height)| of(&layers[layer]) * height).sum()
        };
        let plate = |plane: usize| if plane == 0 { body.column.plate } else { 0.0 };
        let capacity: Vec<f64> = (0..self.counts[2]).map(|s| sum(s, &|l| l.capacity) + plate(s)).collect();
        for (plane, capacity) in capacity.iter().enumerate() {
            self.diffusivity[plane] = sum(plane, &|l| l.conductivity) / capacity;
            self.wall[plane] = sum(plane, &|_| 1.0) / capacity;
        }
        capacity
    }

    fn set_column(&mut self, body: &TensorBody, layers: &[Constants], capacity: &[f64]) {
        let Some(axis) = body.vertical else { return };
        for (i, between) in body.column.between.iter().enumerate() {
            let conductance = match between {
                Between::Contact(h) => *h,
                Between::Layer(layer) => layers[*layer].conductivity * body.axes[axis].link(i),
            };
            self.after[2][i] = conductance / capacity[i];
            self.before[2][i + 1] = conductance / capacity[i + 1];
        }
    }

    fn set_boundary(
        &mut self,
        body: &TensorBody,
        (slot, axis): (usize, usize),
        end: End,
        boundary: Boundary,
        capacity: &[f64],
    ) {
        let (side, axis) = (usize::from(end == End::High), &body.axes[axis]);
        let node = axis.end_node(end);
        let scale = if slot == 2 { 1.0 / capacity[node] } else { axis.end_surface(end) / axis.cells()[node] };
        match boundary {
            Boundary::Exchange { h, source } => self.exchange[slot][side] = Some([h * scale, source * scale]),
            Boundary::Fixed(_) => self.fixed[slot][side] = true,
        }
    }

    /// Returns the longest explicit Euler step that satisfies the discrete maximum principle [s].
    ///
    /// Δt = 1 / max Σ weights over all nodes; with Robin boundaries on side walls the value is a lower bound.
    pub fn stable_step(&self) -> f64 {
        let [nx, ny, nz] = self.counts;
        let widest = |slot: usize, n: usize| {
            (0..n)
                .map(|i| self.before[slot][i] + self.after[slot][i] + self.end_exchange(slot, i)[0])
                .fold(0.0, f64::max)
        };
        let links =
            |slot: usize, n: usize| (0..n).map(|i| self.before[slot][i] + self.after[slot][i]).fold(0.0, f64::max);
        let (x, y) = (links(0, nx) + links(1, ny), widest(0, nx) + widest(1, ny));
        let plane = |k: usize| {
            // Robin terms scale with `wall` and links with the diffusivity; the sum of both maxima is an upper bound.
            let across = self.diffusivity[k] * x + self.wall[k] * (y - x);
            across + self.before[2][k] + self.after[2][k] + self.end_exchange(2, k)[0]
        };
        1.0 / (0..nz).map(plane).fold(0.0, f64::max)
    }

    fn end_exchange(&self, slot: usize, i: usize) -> [f64; 2] {
        let at = |side: usize, here: bool| self.exchange[slot][side].filter(|_| here).unwrap_or([0.0; 2]);
        let (low, high) = (at(0, i == 0), at(1, i + 1 == self.counts[slot]));
        [low[0] + high[0], low[1] + high[1]]
    }

    fn is_fixed(&self, slot: usize, i: usize) -> bool {
        self.fixed[slot][0] && i == 0 || self.fixed[slot][1] && i + 1 == self.counts[slot]
    }

    /// Writes the rates of the row of nodes (·, j, k) [K/s].
    #[inline]
    fn row(&self, t: &[f64], j: usize, k: usize, rate: &mut [f64]) {
        let [n, ny, nz] = self.counts;
        if self.is_fixed(1, j) || self.is_fixed(2, k) {
            return rate.fill(0.0);
        }
        let base = (k * ny + j) * n;
        let here = &t[base..base + n];
        // A missing neighbour has zero weight; the row itself is read in its place.
        let near = |there: bool, at: usize| if there { &t[at..at + n] } else { here };
        let stride = n * ny;
        let row = Row {
            here,
            y: [near(j > 0, base.wrapping_sub(n)), near(j + 1 < ny, base + n)],
            z: [near(k > 0, base.wrapping_sub(stride)), near(k + 1 < nz, base + stride)],
        };
        let a = self.diffusivity[k];
        let weights = [a * self.before[1][j], a * self.after[1][j], self.before[2][k], self.after[2][k]];
        let (side, end) = (self.end_exchange(1, j), self.end_exchange(2, k));
        let own = weights.iter().sum::<f64>() + self.wall[k] * side[0] + end[0];
        let source = self.wall[k] * side[1] + end[1];
        row.add_up(a, [&self.before[0], &self.after[0]], weights, [own, source], rate);
        self.finish_ends(here, self.wall[k], rate);
    }

    /// Adds the Robin terms at both ends of a row and zeroes the rates of Dirichlet nodes [K/s].
    fn finish_ends(&self, here: &[f64], wall: f64, rate: &mut [f64]) {
        for (side, i) in [(0, 0), (1, here.len() - 1)] {
            if let Some([h, source]) = self.exchange[0][side] {
                rate[i] += wall * (source - h * here[i]);
            }
            if self.fixed[0][side] {
                rate[i] = 0.0;
            }
        }
    }

    fn rows(&self) -> impl Iterator<Item = (usize, usize, usize)> + use<> {
        let [n, ny, nz] = self.counts;
        (0..nz).flat_map(move |k| (0..ny).map(move |j| (j, k, (k * ny + j) * n)))
    }
}

/// Temperatures of a row of nodes and of its four neighbour rows [K].
struct Row<'a> {
    here: &'a [f64],
    y: [&'a [f64]; 2],
    z: [&'a [f64]; 2],
}

impl Row<'_> {
    /// Writes rate = a (before · T₋ + after · T₊ − (before + after) T) + Σ weights · neighbours − own · T + source [K/s].
    #[inline]
    fn add_up(&self, a: f64, along: [&[f64]; 2], w: [f64; 4], [own, source]: [f64; 2], rate: &mut [f64]) {
        let n = self.here.len();
        let (here, rate, [before, after]) = (&self.here[..n], &mut rate[..n], along.map(|x| &x[..n]));
        let ([y0, y1], [z0, z1]) = (self.y.map(|r| &r[..n]), self.z.map(|r| &r[..n]));
        for i in 0..n {
            rate[i] = w[0] * y0[i] + w[1] * y1[i] + w[2] * z0[i] + w[3] * z1[i] - own * here[i] + source;
        }
        if n < 2 {
            return;
        }
        rate[0] += a * after[0] * (here[1] - here[0]);
        rate[n - 1] += a * before[n - 1] * (here[n - 2] - here[n - 1]);
        let m = n - 2;
        let (left, mid, right) = (&here[..m], &here[1..=m], &here[2..]);
        let (before, after, rate) = (&before[1..=m], &after[1..=m], &mut rate[1..=m]);
        for i in 0..m {
            rate[i] += a * (before[i] * (left[i] - mid[i]) + after[i] * (right[i] - mid[i]));
        }
    }
}

impl Rates for ProductOperator {
    fn rates(&self, t: &[f64], rate: &mut [f64]) {
        for (j, k, base) in self.rows() {
            self.row(t, j, k, &mut rate[base..base + self.counts[0]]);
        }
    }

    fn begin(&self, share: f64, t: &[f64], start: &mut [f64], rates: &mut [f64], y: &mut [f64]) {
        for (j, k, base) in self.rows() {
            let at = base..base + self.counts[0];
            let (t_row, rate) = (&t[at.clone()], &mut rates[at.clone()]);
            self.row(t, j, k, rate);
            start[at.clone()].copy_from_slice(t_row);
            y[at].iter_mut().zip(t_row.iter().zip(rate.iter())).for_each(|(y, (t, f))| *y = t + share * f);
        }
    }

    /// Works row by row, so that the rates stay in the first-level cache.
    fn stage(&self, weights: &Stage, t: &[f64], start: StepStart, y: &mut [f64], scratch: &mut [f64]) {
        let n = self.counts[0];
        let rate = &mut scratch[..n];
        for (j, k, base) in self.rows() {
            self.row(t, j, k, rate);
            let at = base..base + n;
            let start = StepStart { state: &start.state[at.clone()], rates: &start.rates[at.clone()] };
            weights.combine(&t[at.clone()], start, rate, &mut y[at]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conduction::axis::{Axis, Metric};
    use crate::conduction::column::Column;
    use crate::conduction::edge_conduction::Conduction;
    use crate::conduction::rule::Rule;

    const LAYERS: [Constants; 2] =
        [Constants { conductivity: 0.5, capacity: 3.6e6 }, Constants { conductivity: 52.0, capacity: 3.3e6 }];

    fn bodies() -> Vec<TensorBody> {
        let levels = vec![0.0, 1e-3, 3e-3, 4e-3, 4e-3, 7e-3, 9e-3];
        let (zero, one) = (Between::Layer(0), Between::Layer(1));
        let column = Column { between: vec![zero, zero, one, Between::Contact(900.0), zero, zero], plate: 9e3 };
        let across = || Axis::straight(vec![0.0, 2e-3, 3e-3, 6e-3]);
        let radius = |metric| Axis { metric, nodes: vec![0.0, 2e-3, 5e-3, 6e-3] };
        vec![
            TensorBody::stacked(vec![across(), across(), Axis::straight(levels.clone())], Some(2), column.clone()),
            TensorBody::stacked(
                vec![radius(Metric::Cylindrical), Axis::straight(levels.clone())],
                Some(1),
                column.clone(),
            ),
            TensorBody::stacked(vec![Axis::straight(levels)], Some(0), column),
            TensorBody::new(vec![radius(Metric::Spherical)]),
        ]
    }

    /// Returns the same rates, assembled over edges and nodes [K/s].
    fn by_edges(body: &TensorBody, boundaries: &[FaceBoundary], t: &[f64]) -> Vec<f64> {
        let edges = body.layered_graph(Rule::ShapeFunctions);
        let mut conduction = Conduction::default();
        conduction.refresh_layers(&edges, |layer, _| LAYERS[layer].conductivity);
        let mut power = vec![0.0; t.len()];
        conduction.add_power(&edges.graph, t, &mut power);
        for &(axis, end, boundary) in boundaries {
            let Boundary::Exchange { h, source } = boundary else { continue };
            body.face(axis, end).iter().for_each(|&(n, area)| power[n] += area * (source - h * t[n]));
        }
        (0..t.len())
            .map(|n| {
                let heat = |p: crate::conduction::tensor::Part| p.volume * LAYERS[p.layer].capacity;
                power[n] / (body.parts(n).map(heat).sum::<f64>() + body.plate_capacity(n))
            })
            .collect()
    }

    #[test]
    fn rates_equal_those_of_the_edge_graph() {
        for body in bodies() {
            let mut boundaries: Vec<FaceBoundary> = (0..body.axes.len())
                .map(|a| (a, End::High, Boundary::convective(30.0 * (a + 1) as f64, 400.0)))
                .collect();
            if let Some(v) = body.vertical {
                boundaries.push((v, End::Low, Boundary::Exchange { h: 5.0, source: 2e4 }));
            }
            let t: Vec<f64> = (0..body.node_count()).map(|n| 300.0 + 50.0 * libm::sin(7.0 * n as f64)).collect();
            let operator = ProductOperator::new(&body, &LAYERS, &boundaries);
            let mut rates = vec![0.0; t.len()];
            operator.rates(&t, &mut rates);
            let expected = by_edges(&body, &boundaries, &t);
            let scale = expected.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
            for (r, e) in rates.iter().zip(&expected) {
                assert!((r - e).abs() < 1e-10 * scale, "{r} {e}");
            }
            assert!(operator.stable_step() > 0.0 && operator.stable_step().is_finite());
        }
    }

    #[test]
    fn a_dirichlet_face_keeps_its_temperature_and_a_stage_is_the_weighted_sum_of_rates() {
        let body = &bodies()[0];
        let boundaries = [(2, End::Low, Boundary::Fixed(300.0)), (0, End::High, Boundary::Fixed(300.0))];
        let operator = ProductOperator::new(body, &LAYERS, &boundaries);
        let t: Vec<f64> = (0..body.node_count()).map(|n| n as f64).collect();
        let mut rates = vec![1.0; t.len()];
        operator.rates(&t, &mut rates);
        for (axis, end) in [(2, End::Low), (0, End::High)] {
            assert!(body.face(axis, end).iter().all(|&(n, _)| rates[n] == 0.0));
        }
        let weights = Stage { previous: 0.5, before: 2.0, start: 0.25, slope: 0.1, slope_at_start: 3.0 };
        let (start, mut y, mut scratch) = (StepStart { state: &t, rates: &t }, t.clone(), t.clone());
        operator.stage(&weights, &t, start, &mut y, &mut scratch);
        for (n, y) in y.iter().enumerate() {
            assert!((y - (5.75 * t[n] + 0.1 * rates[n])).abs() < 1e-9);
        }
    }
}
