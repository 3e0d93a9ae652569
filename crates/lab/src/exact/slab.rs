//! The exact temperatures of a slab with fixed temperatures or Robin boundaries.

use std::f64::consts::PI;

use crate::exact::root;

/// A slab of uniform initial temperature with fixed surface temperatures (Dirichlet boundaries).
///
/// ```
/// let slab = saute_lab::exact::FixedSlab {
///     thickness: 0.02,
///     diffusivity: 1.4e-7,
///     initial_c: 5.0,
///     bottom_c: 100.0,
///     top_c: 20.0,
/// };
/// // The steady state is linear.
/// assert!((slab.temperature(0.005, 1e6) - 80.0).abs() < 1e-9);
/// // The centre has not noticed the surfaces yet.
/// assert!((slab.temperature(0.01, 10.0) - 5.0).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedSlab {
    /// Thickness L [m].
    pub thickness: f64,
    /// Thermal diffusivity α [m²/s].
    pub diffusivity: f64,
    /// Initial temperature T₀ [°C].
    pub initial_c: f64,
    /// Temperature T₁ of the bottom [°C].
    pub bottom_c: f64,
    /// Temperature T₂ of the top [°C].
    pub top_c: f64,
}

/// Terms of the series (chosen: the remainder is below rounding from a Fourier number αt/L² of 1e-3 on).
const TERMS: u32 = 100;

impl FixedSlab {
    /// Returns the temperature at a height z above the bottom [m] and a time t > 0 [s] [°C].
    ///
    /// T = T₁ + (T₂ − T₁) z/L + Σ bₙ sin(nπz/L) exp(−n²π²αt/L²), with
    /// bₙ = 2/(nπ) · (T₀ − T₁ − (−1)ⁿ (T₀ − T₂)). Valid for αt/L² > 1e-3.
    /// Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), § 3.4.
    pub fn temperature(&self, z: f64, t: f64) -> f64 {
        let steady = self.bottom_c + (self.top_c - self.bottom_c) * z / self.thickness;
        let term = |n: u32| {
            let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
            let wave = f64::from(n) * PI / self.thickness;
            let share =
                (self.initial_c - self.bottom_c - sign * (self.initial_c - self.top_c)) * 2.0 / (f64::from(n) * PI);
            share * (wave * z).sin() * (-wave * wave * self.diffusivity * t).exp()
        };
        steady + (1..=TERMS).map(term).sum::<f64>()
    }
}

/// Returns the excess temperature ratio θ = (T − T∞)/(T₀ − T∞) at the centre of a slab with Robin boundaries [-].
///
/// θ = Σ 4 sin ζ / (2ζ + sin 2ζ) · exp(−ζ² Fo), with ζ tan ζ = Bi, the Biot number Bi = hL/k and the Fourier number
/// Fo = αt/L² for the half-thickness L. Valid for Fo > 1e-2. Source: Carslaw & Jaeger (1959), § 3.11.
pub fn robin_slab_centre(biot: f64, fourier: f64) -> f64 {
    let term = |n: u32| {
        let n = f64::from(n);
        let zeta = root(n * PI, (n + 0.5) * PI, |z| z * z.sin() - biot * z.cos());
        4.0 * zeta.sin() / (2.0 * zeta + (2.0 * zeta).sin()) * (-zeta * zeta * fourier).exp()
    };
    (0..TERMS).map(term).sum()
}
