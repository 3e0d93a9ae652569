//! The exact temperatures of a brick that is flipped once, as eigenfunction series.
//!
//! Sides and top face the same air. T − T_air is therefore a sum over pairs of symmetric cosines across the brick, each
//! times a profile c(z, t) with ∂c/∂t = α (c″ − κ² c), driven by the hot face. Each profile is its steady state plus a sum
//! over the eigenfunctions of the thickness. At the flip the profile is mirrored and expanded again. Source: Carslaw & Jaeger,
//! Conduction of Heat in Solids (1959) `[@carslaw-jaeger-1959]`, ch. 2, 3 and 5.

use std::f64::consts::PI;

/// A brick in air with its bottom on a hot plate (Robin boundaries).
#[derive(Clone, Copy, Debug)]
pub struct Brick {
    /// Sizes [m].
    pub size: [f64; 3],
    /// Thermal conductivity [W/(m·K)].
    pub conductivity: f64,
    /// Thermal diffusivity [m²/s].
    pub diffusivity: f64,
    /// Heat transfer coefficients of the air and of the plate [W/(m²·K)].
    pub h: [f64; 2],
    /// Temperatures: initial, air, plate [°C].
    pub celsius: [f64; 3],
    /// Time of the flip [s].
    pub flip: f64,
}

/// Terms of the series across and along the thickness (chosen: ten times as many change less than 1 mK from 60 s on).
const ACROSS: usize = 40;
const ALONG: usize = 60;
/// Panels of the quadrature over the thickness, with the points of [`GAUSS`] in each (chosen: five panels per oscillation).
const PANELS: usize = 300;
/// Gauss–Legendre points and weights on [−1, 1], exact up to degree 5.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// A symmetric cosine across the brick: wave number [1/m] and its coefficient in the expansion of 1 [-].
#[derive(Clone, Copy, Debug)]
struct Cosine {
    wave: f64,
    share: f64,
    half: f64,
}

impl Cosine {
    fn at(&self, x: f64) -> f64 {
        (self.wave * (x - self.half)).cos()
    }
}

/// An eigenfunction of the thickness, hot face at 0: cos νz + (H/ν) sin νz.
#[derive(Clone, Debug)]
struct Along {
    wave: f64,
    steepness: f64,
    /// Values times weights at the quadrature points, over the integral of the square.
    projector: Vec<f64>,
    /// Values at the quadrature points.
    values: Vec<f64>,
}

impl Along {
    fn at(&self, z: f64) -> f64 {
        (self.wave * z).cos() + self.steepness / self.wave * (self.wave * z).sin()
    }
}

/// The steady profile per kelvin of the plate above the air: A e^(−κz) + B e^(−κ(L−z)).
#[derive(Clone, Copy, Debug)]
struct Steady {
    kappa: f64,
    length: f64,
    a: f64,
    b: f64,
}

impl Steady {
    fn new(kappa: f64, length: f64, [air, hot]: [f64; 2]) -> Self {
        let e = (-kappa * length).exp();
        let determinant = (kappa + hot) * (kappa + air) - (hot - kappa) * (air - kappa) * e * e;
        Self { kappa, length, a: hot * (kappa + air) / determinant, b: -hot * (air - kappa) * e / determinant }
    }

    fn at(&self, z: f64) -> f64 {
        self.a * (-self.kappa * z).exp() + self.b * (-self.kappa * (self.length - z)).exp()
    }
}

/// Returns the root of a function between two points of different sign, by bisection.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let negative = f(low) < 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == negative { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

impl Brick {
    /// Returns the temperatures [°C] at the given places [m], one row for each time [s].
    pub fn temperatures(&self, places: &[[f64; 3]], times: &[f64]) -> Vec<Vec<f64>> {
        let (x, y) = (self.cosines(self.size[0]), self.cosines(self.size[1]));
        let nodes = quadrature(self.size[2]);
        let along = self.along(&nodes);
        let mut found = vec![vec![self.celsius[1]; places.len()]; times.len()];
        for (p, q) in x.iter().flat_map(|p| y.iter().map(move |q| (p, q))) {
            let profile = Profile::new(self, (p.wave * p.wave + q.wave * q.wave).sqrt(), &along, &nodes);
            for (row, &time) in found.iter_mut().zip(times) {
                for (value, place) in row.iter_mut().zip(places) {
                    *value += p.share * q.share * p.at(place[0]) * q.at(place[1]) * profile.at(place[2], time);
                }
            }
        }
        found
    }

    fn steepness(&self) -> [f64; 2] {
        self.h.map(|h| h / self.conductivity)
    }

    fn cosines(&self, length: f64) -> Vec<Cosine> {
        let half = 0.5 * length;
        let bi = self.steepness()[0] * half;
        let cosine = |n: usize| {
            let zeta = root(n as f64 * PI, (n as f64 + 0.5) * PI, |z| z * z.sin() - bi * z.cos());
            Cosine { wave: zeta / half, share: 4.0 * zeta.sin() / (2.0 * zeta + (2.0 * zeta).sin()), half }
        };
        (0..ACROSS).map(cosine).collect()
    }

    fn along(&self, nodes: &[(f64, f64)]) -> Vec<Along> {
        let (length, [air, hot]) = (self.size[2], self.steepness());
        let eigen = |n: usize| {
            let condition = |v: f64| (v * v - air * hot) * (v * length).sin() - v * (air + hot) * (v * length).cos();
            let wave = root((n as f64 + 1e-9) * PI / length, (n as f64 + 1.0) * PI / length, condition);
            let mut found = Along { wave, steepness: hot, projector: Vec::new(), values: Vec::new() };
            found.values = nodes.iter().map(|(z, _)| found.at(*z)).collect();
            let square: f64 = found.values.iter().zip(nodes).map(|(v, (_, w))| v * v * w).sum();
            found.projector = found.values.iter().zip(nodes).map(|(v, (_, w))| v * w / square).collect();
            found
        };
        (0..ALONG).map(eigen).collect()
    }
}

/// One profile through the thickness: coefficients before and after the flip.
struct Profile<'a> {
    brick: &'a Brick,
    along: &'a [Along],
    steady: Steady,
    before: Vec<f64>,
    after: Vec<f64>,
}

impl<'a> Profile<'a> {
    fn new(brick: &'a Brick, kappa: f64, along: &'a [Along], nodes: &[(f64, f64)]) -> Self {
        let steady = Steady::new(kappa, brick.size[2], brick.steepness());
        let mut profile = Self { brick, along, steady, before: Vec::new(), after: Vec::new() };
        let start = brick.celsius[0] - brick.celsius[1];
        let rest: Vec<f64> = nodes.iter().map(|(z, _)| start - profile.steady_at(*z)).collect();
        profile.before = project(along, &rest);
        let decayed: Vec<f64> =
            along.iter().zip(&profile.before).map(|(a, b)| b * profile.decay(a.wave, brick.flip)).collect();
        let steady: Vec<f64> = nodes.iter().map(|(z, _)| profile.steady_at(*z)).collect();
        let whole = |i: usize| steady[i] + along.iter().zip(&decayed).map(|(a, b)| a.values[i] * b).sum::<f64>();
        let whole: Vec<f64> = (0..nodes.len()).map(whole).collect();
        // The quadrature is symmetric, so the reversed list is the mirror image.
        let rest: Vec<f64> = whole.iter().rev().zip(&steady).map(|(w, s)| w - s).collect();
        profile.after = project(along, &rest);
        profile
    }

    fn steady_at(&self, z: f64) -> f64 {
        (self.brick.celsius[2] - self.brick.celsius[1]) * self.steady.at(z)
    }

    fn decay(&self, wave: f64, time: f64) -> f64 {
        (-self.brick.diffusivity * (wave * wave + self.steady.kappa * self.steady.kappa) * time).exp()
    }

    /// Returns the contribution to T − T_air at a height of the body [K].
    fn at(&self, z: f64, time: f64) -> f64 {
        let flipped = time > self.brick.flip;
        let (shares, z, since) = if flipped {
            (&self.after, self.brick.size[2] - z, time - self.brick.flip)
        } else {
            (&self.before, z, time)
        };
        let series = self.along.iter().zip(shares);
        self.steady_at(z) + series.map(|(a, b)| b * a.at(z) * self.decay(a.wave, since)).sum::<f64>()
    }
}

/// Returns the coefficients of the eigenfunctions in a profile.
fn project(along: &[Along], profile: &[f64]) -> Vec<f64> {
    along.iter().map(|a| a.projector.iter().zip(profile).map(|(p, v)| p * v).sum()).collect()
}

/// Returns points and weights of the composite quadrature over a length [m].
fn quadrature(length: f64) -> Vec<(f64, f64)> {
    let panel = length / PANELS as f64;
    let places = |i: usize| GAUSS.map(|(x, w)| ((i as f64 + 0.5 + 0.5 * x) * panel, 0.5 * panel * w));
    (0..PANELS).flat_map(places).collect()
}
