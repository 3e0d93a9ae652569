//! Promise: conduction agrees with closed-form solutions, converges at second order in space, conserves energy and
//! never leaves the range of the data. Solutions: Carslaw & Jaeger, Conduction of Heat in Solids (1959), ch. 3.

use crate::bath::Bath;
use saute_heat::{Conduction, Locator, Outline, Section, SweptMesh, graded_levels};

const K: f64 = 0.48;
const RHO_C: f64 = 0.48 / 1.3e-7;

/// A body with one thermal conductivity and a heat transfer coefficient (or a fixed temperature) on every face.
struct Body {
    mesh: SweptMesh,
    capacity: Vec<f64>,
    exchange: Vec<f64>,
    conduction: Conduction,
    t: Vec<f64>,
}

impl Body {
    fn new(mesh: SweptMesh, start: f64, h: f64) -> Self {
        let capacity = mesh.graph.volume.iter().map(|v| v * RHO_C).collect::<Vec<_>>();
        let mut exchange: Vec<f64> = mesh.side_areas().iter().map(|a| a * h).collect();
        let top = mesh.node(mesh.levels.len() - 1, 0);
        for (i, area) in mesh.section.areas.iter().enumerate() {
            exchange[i] += h * area;
            exchange[top + i] += h * area;
        }
        let mut conduction = Conduction::default();
        conduction.refresh(&mesh.graph, &vec![K; capacity.len()]);
        let t = vec![start; capacity.len()];
        Self { mesh, capacity, exchange, conduction, t }
    }

    /// Advances by a duration [s] and returns the absorbed heat [J].
    fn run(&mut self, until: f64, ambient: f64) -> f64 {
        let Self { mesh, capacity, exchange, conduction, t } = self;
        Bath { graph: &mesh.graph, conduction, capacity, exchange }.soak(t, ambient, until)
    }

    fn at(&self, p: [f64; 2], z: f64) -> f64 {
        let found = Locator::new(&self.mesh.section).locate_or_nearest(&self.mesh.section, p);
        let (level, share) = self.mesh.bracket(z);
        let on = |l: usize| {
            (0..3).map(|k| found.weights[k] * self.t[self.mesh.node(l, found.nodes[k] as usize)]).sum::<f64>()
        };
        on(level) * (1.0 - share) + on(level + 1) * share
    }
}

fn brick(size: [f64; 3], cells_across: f64) -> SweptMesh {
    let spacing = size[2] / cells_across;
    let section = Section::mesh(&Outline::rectangle(size[0], size[1]), spacing, 0.5 * spacing).expect("meshes");
    SweptMesh::new(section, graded_levels(size[2], spacing, 1.0, spacing))
}

/// Excess ratio θ at the centre of a slab of half-thickness L with Bi = hL/k: Σ C_n exp(−ζ_n² Fo).
fn slab_centre(bi: f64, fo: f64) -> f64 {
    (0..60)
        .map(|n| {
            let (mut low, mut high) =
                (f64::from(n) * std::f64::consts::PI, (f64::from(n) + 0.5) * std::f64::consts::PI - 1e-12);
            for _ in 0..200 {
                let mid = 0.5 * (low + high);
                if mid * mid.tan() < bi { low = mid } else { high = mid }
            }
            let z = 0.5 * (low + high);
            4.0 * z.sin() / (2.0 * z + (2.0 * z).sin()) * (-z * z * fo).exp()
        })
        .sum()
}

/// Brick 40 × 30 × 20 mm, h = 200 W/m²K on all faces, 10 → 150 °C: the product of three slabs.
fn exact_brick_centre(t: f64) -> f64 {
    let theta: f64 = [0.02, 0.015, 0.01].iter().map(|l| slab_centre(200.0 * l / K, 1.3e-7 * t / (l * l))).product();
    150.0 - 140.0 * theta
}

fn brick_error(cells: f64) -> f64 {
    let mut body = Body::new(brick([0.04, 0.03, 0.02], cells), 10.0, 200.0);
    body.run(300.0, 150.0);
    (body.at([0.0, 0.0], 0.01) - exact_brick_centre(300.0)).abs()
}

#[test]
fn brick_with_convection_agrees_with_the_product_solution() {
    let error = brick_error(20.0);
    assert!(error < 0.3, "{error} K");
}

#[test]
fn the_error_falls_at_second_order() {
    let (coarse, fine) = (brick_error(8.0), brick_error(16.0));
    let order = (coarse / fine).log2();
    assert!((1.8..=2.2).contains(&order), "order {order}: {coarse} -> {fine}");
}

#[test]
fn absorbed_energy_equals_stored_energy() {
    let mut body = Body::new(brick([0.04, 0.03, 0.02], 10.0), 10.0, 200.0);
    let taken = body.run(200.0, 150.0);
    let stored: f64 = body.t.iter().zip(&body.capacity).map(|(t, c)| (t - 10.0) * c).sum();
    assert!((taken / stored - 1.0).abs() < 1e-10);
}

#[test]
fn no_node_leaves_the_range_of_the_data() {
    let outline = Outline::superellipse(0.12, 0.08, 2.6, &[(3, 0.02, 1.0)]);
    let section = Section::mesh(&outline, 4.5e-3, 1.5e-3).expect("meshes");
    let mesh = SweptMesh::new(section, graded_levels(0.025, 0.3e-3, 1.4, 2.5e-3));
    let mut body = Body::new(mesh, 5.0, 2000.0);
    for _ in 0..30 {
        body.run(2.0, 200.0);
        let low = body.t.iter().copied().fold(f64::INFINITY, f64::min);
        let high = body.t.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(low >= 5.0 - 1e-9 && high <= 200.0 + 1e-9, "{low} .. {high}");
    }
}
