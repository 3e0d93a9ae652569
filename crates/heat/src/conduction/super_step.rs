//! Runge–Kutta–Legendre super-time-stepping of second order (RKL2).

/// A Runge–Kutta–Legendre integrator of second order (RKL2) with its work arrays.
///
/// A step of s stages is stable up to (s² + s − 2)/4 explicit Euler steps. It suits symmetric diffusion operators with
/// real negative eigenvalues; it does not satisfy the maximum principle between stages. Source: Meyer, Balsara, Aslam
/// 2014 `[@meyer-2014]`, eqs. 16–18.
///
/// ```
/// use saute_heat::conduction::super_step::{Rates, SuperStep};
///
/// // Newton's law of cooling with time constants of 1 s and 100 s.
/// struct Cooling;
/// impl Rates for Cooling {
///     fn rates(&self, t: &[f64], rate: &mut [f64]) {
///         (rate[0], rate[1]) = (-t[0], -0.01 * t[1]);
///     }
/// }
/// // An explicit step of the fast mode that obeys the maximum principle is 1 s; a step of 6 s needs 5 stages.
/// let stages = SuperStep::stages_for(6.0, 1.0);
/// assert_eq!(stages, 5);
/// let mut excess_k = vec![80.0, 80.0];
/// let mut step = SuperStep::new(2);
/// (0..10).for_each(|_| step.advance(&mut excess_k, 6.0, stages, &Cooling));
/// assert!(excess_k[0].abs() < 1.1, "{} K", excess_k[0]);
/// assert!((excess_k[1] - 80.0 * (-0.6f64).exp()).abs() < 0.01, "{} K", excess_k[1]);
/// ```
#[derive(Clone, Debug)]
pub struct SuperStep {
    previous: Vec<f64>,
    start: Vec<f64>,
    slope_at_start: Vec<f64>,
    scratch: Vec<f64>,
}

/// The weights of one RKL2 stage, some dimensionless [-] and some times [s].
///
/// y ← `previous` · t + `before` · y + `start` · t₀ + `slope` · f(t) + `slope_at_start` · f(t₀), with the previous stage
/// in t and the one before it in y.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Weight of stage j − 1 [-].
    pub previous: f64,
    /// Weight of stage j − 2 [-].
    pub before: f64,
    /// Weight of the state at the start of the step [-].
    pub start: f64,
    /// Weight of the rates of stage j − 1 [s].
    pub slope: f64,
    /// Weight of the rates at the start of the step [s].
    pub slope_at_start: f64,
}

/// The state [K] and its rates [K/s] at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct StepStart<'a> {
    /// Unknowns [K].
    pub state: &'a [f64],
    /// Their rates [K/s].
    pub rates: &'a [f64],
}

/// A system of ordinary differential equations dT/dt = f(T) [K/s].
pub trait Rates {
    /// Writes the rate of every unknown to `rate` [K/s].
    fn rates(&self, t: &[f64], rate: &mut [f64]);

    /// Starts a step from the state `t` with the first stage y ← t + `share` · f(t), `share` in [s].
    ///
    /// Copies `t` to `start` and writes f(t) to `rates`.
    fn begin(&self, share: f64, t: &[f64], start: &mut [f64], rates: &mut [f64], y: &mut [f64]) {
        start.copy_from_slice(t);
        self.rates(t, rates);
        y.iter_mut().zip(t.iter().zip(rates.iter())).for_each(|(y, (t, f))| *y = t + share * f);
    }

    /// Computes one stage from stage j − 1 in `t` and stage j − 2 in `y`, and writes it to `y` [K].
    ///
    /// `scratch` has the length of `y`.
    fn stage(&self, weights: &Stage, t: &[f64], start: StepStart, y: &mut [f64], scratch: &mut [f64]) {
        self.rates(t, scratch);
        weights.combine(t, start, scratch, y);
    }
}

impl Stage {
    /// Returns the weights of stage `j` ≥ 2 of `s` in a step of `dt` [s].
    fn new(j: usize, s: usize, dt: f64) -> Self {
        let x = j as f64;
        let mu = (2.0 * x - 1.0) / x * b(j) / b(j - 1);
        let nu = -(x - 1.0) / x * b(j) / b(j - 2);
        let slope = mu * w(s) * dt;
        Self { previous: mu, before: nu, start: 1.0 - mu - nu, slope, slope_at_start: -(1.0 - b(j - 1)) * slope }
    }

    /// Writes the weighted sum of the stage to `y`, given f(t) in `rate`; all slices have one length [K].
    #[inline]
    pub fn combine(&self, t: &[f64], start: StepStart, rate: &[f64], y: &mut [f64]) {
        let n = y.len();
        let (t, t0, f0, f) = (&t[..n], &start.state[..n], &start.rates[..n], &rate[..n]);
        for i in 0..n {
            y[i] = self.previous * t[i]
                + self.before * y[i]
                + self.start * t0[i]
                + self.slope * f[i]
                + self.slope_at_start * f0[i];
        }
    }
}

/// Coefficient b_j of RKL2 [-].
fn b(j: usize) -> f64 {
    let x = j as f64;
    if j < 2 { 1.0 / 3.0 } else { (x * x + x - 2.0) / (2.0 * x * (x + 1.0)) }
}

/// Coefficient w₁ of RKL2 with s stages [-].
fn w(s: usize) -> f64 {
    4.0 / ((s * s + s - 2) as f64)
}

impl SuperStep {
    /// Returns an integrator for `nodes` unknowns.
    pub fn new(nodes: usize) -> Self {
        let zeros = || vec![0.0; nodes];
        Self { previous: zeros(), start: zeros(), slope_at_start: zeros(), scratch: zeros() }
    }

    /// Returns the stability limit of a step of `stages` in explicit Euler steps, (s² + s − 2)/4 [-].
    pub fn reach(stages: usize) -> f64 {
        1.0 / w(stages.max(2))
    }

    /// Returns the smallest odd number of stages, from 3, that is stable for a step of `dt` [-].
    ///
    /// `explicit` is the stable explicit Euler step; both are in [s]. Even numbers of stages do not damp the fastest mode
    /// at the limit (advice of Meyer et al. 2014 `[@meyer-2014]`). The result is capped at 999 stages.
    pub fn stages_for(dt: f64, explicit: f64) -> usize {
        (3..1000).step_by(2).find(|s| Self::reach(*s) * explicit >= dt * (1.0 - 1e-12)).unwrap_or(999)
    }

    /// Advances `t` by `dt` [s] with one RKL2 step of `stages` stages, at least 2.
    pub fn advance(&mut self, t: &mut Vec<f64>, dt: f64, stages: usize, system: &impl Rates) {
        let s = stages.max(2);
        system.begin(b(1) * w(s) * dt, t, &mut self.start, &mut self.slope_at_start, &mut self.previous);
        for j in 2..=s {
            let start = StepStart { state: &self.start, rates: &self.slope_at_start };
            system.stage(&Stage::new(j, s, dt), &self.previous, start, t, &mut self.scratch);
            std::mem::swap(t, &mut self.previous);
        }
        std::mem::swap(t, &mut self.previous);
    }

    /// Advances `t` by `dt` [s] with one explicit Euler step.
    pub fn euler(&mut self, t: &mut [f64], dt: f64, system: &impl Rates) {
        self.start.copy_from_slice(t);
        system.rates(t, &mut self.slope_at_start);
        t.iter_mut().zip(&self.slope_at_start).for_each(|(t, rate)| *t += dt * rate);
    }

    /// Returns the state before the last step [K].
    pub fn start(&self) -> &[f64] {
        &self.start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Decay(Vec<f64>);

    impl Rates for Decay {
        fn rates(&self, t: &[f64], rate: &mut [f64]) {
            rate.iter_mut().zip(t).zip(&self.0).for_each(|((r, t), k)| *r = -k * t);
        }
    }

    #[test]
    fn the_error_of_decay_falls_at_second_order() {
        let decay = Decay(vec![0.3, 1.0, 2.0]);
        let error = |steps: usize, stages: usize| {
            let mut t = vec![1.0; 3];
            let mut step = SuperStep::new(3);
            (0..steps).for_each(|_| step.advance(&mut t, 1.0 / steps as f64, stages, &decay));
            (0..3).map(|i| (t[i] - libm::exp(-decay.0[i])).abs()).fold(0.0, f64::max)
        };
        for stages in [2, 3, 5, 12] {
            let order = libm::log2(error(8, stages) / error(16, stages));
            assert!((1.8..2.3).contains(&order), "{stages} stages: {order}");
        }
    }

    #[test]
    fn stiff_decay_stays_bounded_at_the_stated_limit() {
        // The fastest rate, 2 per second, permits explicit steps of 2 / rate = 1 s.
        let decay = Decay(vec![2.0, 0.01]);
        for s in [2, 5, 9, 20] {
            let mut t = vec![1.0, 1.0];
            let mut step = SuperStep::new(2);
            for _ in 0..50 {
                step.advance(&mut t, SuperStep::reach(s), s, &decay);
                assert!(t[0].abs() <= 1.0 && t[1] <= 1.0, "{s} stages: {t:?}");
            }
        }
        assert_eq!(SuperStep::stages_for(1.0, 1.0), 3);
        assert_eq!(SuperStep::stages_for(6.9, 1.0), 5);
    }
}
