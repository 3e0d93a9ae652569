//! Promise: conduction in bodies of cells agrees with the closed-form solutions of cube, ball and cylinder (Carslaw &
//! Jaeger 1959), converges, conserves energy and never leaves the range of the data.

use saute_heat::{CellMesh, Conduction, Soup};

use super::bodies::{ball, brick, cylinder};
use super::filling::meshed;
use crate::bath::Bath;

const K: f64 = 0.48;
const RHO_C: f64 = 0.48 / 1.3e-7;
const H: f64 = 200.0;
const START: f64 = 10.0;
const AMBIENT: f64 = 150.0;

/// A body that exchanges heat with its surroundings through every patch.
struct Body {
    mesh: CellMesh,
    capacity: Vec<f64>,
    exchange: Vec<f64>,
    conduction: Conduction,
    t: Vec<f64>,
}

impl Body {
    fn new(soup: &Soup, coarseness: f64, h: f64) -> Self {
        let mesh = meshed(soup, coarseness);
        let capacity: Vec<f64> = mesh.graph.volume.iter().map(|v| v * RHO_C).collect();
        let mut exchange = vec![0.0; capacity.len()];
        mesh.patches.iter().for_each(|p| exchange[p.node as usize] += h * p.area);
        let mut conduction = Conduction::default();
        conduction.refresh(&mesh.graph, &vec![K; capacity.len()]);
        let t = vec![START; capacity.len()];
        Self { mesh, capacity, exchange, conduction, t }
    }

    /// Advances by a time [s] and returns the absorbed heat [J].
    fn run(&mut self, duration: f64) -> f64 {
        let Self { mesh, capacity, exchange, conduction, t } = self;
        Bath { graph: &mesh.graph, conduction, capacity, exchange }.soak(t, AMBIENT, duration)
    }

    fn mean(&self) -> f64 {
        let sum: f64 = self.t.iter().zip(&self.mesh.graph.volume).map(|(t, v)| t * v).sum();
        sum / self.mesh.graph.volume.iter().sum::<f64>()
    }

    /// Returns the temperature at the centre and the mean temperature [°C].
    fn after(&mut self, duration: f64) -> [f64; 2] {
        self.run(duration);
        [self.mesh.at(&self.t, [0.0; 3]), self.mean()]
    }
}

/// Returns the root of an increasing function in an interval, by bisection.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let mid = 0.5 * (low + high);
        if f(mid) < 0.0 { low = mid } else { high = mid }
    }
    0.5 * (low + high)
}

/// Returns the excess ratios at the centre and on average of a slab of half-thickness l after a time [-].
fn slab(l: f64, time: f64) -> [f64; 2] {
    let (bi, fo) = (H * l / K, 1.3e-7 * time / (l * l));
    let mut sums = [0.0; 2];
    for n in 0..60 {
        let start = f64::from(n) * std::f64::consts::PI;
        let z = root(start, start + 0.5 * std::f64::consts::PI - 1e-12, |z| z * z.tan() - bi);
        let c = 4.0 * z.sin() / (2.0 * z + (2.0 * z).sin()) * (-z * z * fo).exp();
        sums[0] += c;
        sums[1] += c * z.sin() / z;
    }
    sums
}

/// Returns the same ratios of a ball of radius r [-].
fn sphere(r: f64, time: f64) -> [f64; 2] {
    let (bi, fo) = (H * r / K, 1.3e-7 * time / (r * r));
    let mut sums = [0.0; 2];
    for n in 0..60 {
        let start = f64::from(n) * std::f64::consts::PI;
        // 1 − z cot z = Bi.
        let z = root(start + 1e-9, start + std::f64::consts::PI - 1e-9, |z| 1.0 - z / z.tan() - bi);
        let c = 4.0 * (z.sin() - z * z.cos()) / (2.0 * z - (2.0 * z).sin()) * (-z * z * fo).exp();
        sums[0] += c;
        sums[1] += c * 3.0 * (z.sin() - z * z.cos()) / (z * z * z);
    }
    sums
}

/// Returns the Bessel function of the first kind of integer order, by its integral.
fn bessel(order: f64, x: f64) -> f64 {
    let n = 400;
    let step = std::f64::consts::PI / f64::from(n);
    let value = |i: i32| (order * f64::from(i) * step - x * (f64::from(i) * step).sin()).cos();
    let inner: f64 = (1..n).map(value).sum();
    (inner + 0.5 * (value(0) + value(n))) / f64::from(n)
}

/// Returns the same ratios of a long cylinder of radius r [-].
fn long_cylinder(r: f64, time: f64) -> [f64; 2] {
    let (bi, fo) = (H * r / K, 1.3e-7 * time / (r * r));
    let mut sums = [0.0; 2];
    // z J1(z) = Bi J0(z) changes sign once between neighbouring zeros of J1.
    let f = |z: f64| z * bessel(1.0, z) - bi * bessel(0.0, z);
    let mut from = 1e-6;
    for _ in 0..30 {
        let mut to = from + 0.05;
        while (f(from) < 0.0) == (f(to) < 0.0) {
            to += 0.05;
        }
        let (mut low, mut high) = (to - 0.05, to);
        for _ in 0..100 {
            let mid = 0.5 * (low + high);
            if (f(mid) < 0.0) == (f(low) < 0.0) { low = mid } else { high = mid }
        }
        let z = 0.5 * (low + high);
        let (j0, j1) = (bessel(0.0, z), bessel(1.0, z));
        let c = 2.0 / z * j1 / (j0 * j0 + j1 * j1) * (-z * z * fo).exp();
        sums[0] += c;
        sums[1] += c * 2.0 * j1 / z;
        from = to;
    }
    sums
}

fn warmed(excess: [f64; 2]) -> [f64; 2] {
    excess.map(|e| AMBIENT + (START - AMBIENT) * e)
}

fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0], a[1] * b[1]]
}

/// Returns the largest errors of the central and of the mean temperature over several times [K].
fn error(soup: &Soup, coarseness: f64, times: &[f64], exact: impl Fn(f64) -> [f64; 2]) -> [f64; 2] {
    let mut body = Body::new(soup, coarseness, H);
    let (mut worst, mut before) = ([0.0f64; 2], 0.0);
    for &time in times {
        let (found, expected) = (body.after(time - before), warmed(exact(time)));
        before = time;
        worst = [0, 1].map(|k| worst[k].max((found[k] - expected[k]).abs()));
    }
    worst
}

fn cube_error(coarseness: f64) -> [f64; 2] {
    let exact = |t| {
        let s = slab(0.015, t);
        product(s, product(s, s))
    };
    error(&brick([0.0; 3], [30.0; 3]), coarseness, &[60.0, 180.0, 360.0, 720.0], exact)
}

fn ball_error(coarseness: f64) -> [f64; 2] {
    error(&ball(15.0, 5), coarseness, &[60.0, 180.0, 360.0, 720.0], |t| sphere(0.015, t))
}

fn cylinder_error(coarseness: f64) -> [f64; 2] {
    let exact = |t| product(long_cylinder(0.015, t), slab(0.01, t));
    error(&cylinder(15.0, 20.0, 128), coarseness, &[60.0, 180.0, 360.0, 720.0], exact)
}

/// The centre and the mean are exact to about one percent of a step of 140 K.
#[test]
fn cube_ball_and_cylinder_follow_the_series() {
    for (name, [middle, mean]) in
        [("cube", cube_error(1.0)), ("ball", ball_error(1.0)), ("cylinder", cylinder_error(1.0))]
    {
        println!("{name}: middle {middle:.2} K, mean {mean:.2} K");
        assert!(middle < 1.5 && mean < 1.0, "{name}: middle {middle} K, mean {mean} K");
    }
}

#[test]
fn finer_meshes_have_smaller_errors() {
    for (name, error) in [("cube", cube_error as fn(f64) -> [f64; 2]), ("ball", ball_error)] {
        let [coarse, fine] = [error(2.0), error(0.75)];
        println!("{name}: {coarse:?} -> {fine:?}");
        assert!(fine[0] < 0.5 * coarse[0] && fine[1] < 0.5 * coarse[1], "{name}: {coarse:?} -> {fine:?}");
    }
}

#[test]
fn absorbed_energy_equals_stored_energy() {
    let mut body = Body::new(&ball(12.0, 4), 1.0, H);
    let taken = body.run(200.0);
    let stored: f64 = body.t.iter().zip(&body.capacity).map(|(t, c)| (t - START) * c).sum();
    assert!((taken / stored - 1.0).abs() < 1e-10);
}

#[test]
fn no_node_leaves_the_range_of_the_data() {
    let mut body = Body::new(&cylinder(12.0, 6.0, 96), 1.0, 2000.0);
    for _ in 0..30 {
        body.run(2.0);
        let low = body.t.iter().copied().fold(f64::INFINITY, f64::min);
        let high = body.t.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(low >= START - 1e-9 && high <= AMBIENT + 1e-9, "{low} .. {high}");
    }
}
