//! Second-order super-time-stepping: one long step of a few stages in place of many short ones.

/// Coefficients of a Runge–Kutta–Legendre step of second order.
///
/// Stable up to (s² + s − 2)/4 explicit steps; source: Meyer, Balsara, Aslam 2014, J. Comput. Phys. 257:594, eqs. 16–18.
#[derive(Clone, Debug)]
pub struct SuperStep {
    stages: Vec<Stage>,
    first: f64,
    previous: Vec<f64>,
    before: Vec<f64>,
    start: Vec<f64>,
    slope_at_start: Vec<f64>,
    slope: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
struct Stage {
    mu: f64,
    nu: f64,
    mu_slope: f64,
    gamma_slope: f64,
}

impl SuperStep {
    /// A step of `stages` ≥ 2 stages for `nodes` unknowns.
    pub fn new(stages: usize, nodes: usize) -> Self {
        let s = stages.max(2);
        let b = |j: usize| {
            let j = j as f64;
            if j < 2.0 { 1.0 / 3.0 } else { (j * j + j - 2.0) / (2.0 * j * (j + 1.0)) }
        };
        let w = 4.0 / ((s * s + s - 2) as f64);
        let stage = |j: usize| {
            let x = j as f64;
            let mu = (2.0 * x - 1.0) / x * b(j) / b(j - 1);
            Stage {
                mu,
                nu: -(x - 1.0) / x * b(j) / b(j - 2),
                mu_slope: mu * w,
                gamma_slope: -(1.0 - b(j - 1)) * mu * w,
            }
        };
        let zeros = || vec![0.0; nodes];
        Self {
            stages: (2..=s).map(stage).collect(),
            first: b(1) * w,
            previous: zeros(),
            before: zeros(),
            start: zeros(),
            slope_at_start: zeros(),
            slope: zeros(),
        }
    }

    /// Fewest stages that carry a step of `dt` where an explicit step may be `explicit` long.
    pub fn stages_for(dt: f64, explicit: f64) -> usize {
        (2..).find(|s| ((s * s + s - 2) as f64) * 0.25 * explicit >= dt).unwrap_or(2)
    }

    /// Moves `t` by `dt` under dT/dt = `slope(T)`, which writes the rate of every unknown.
    pub fn advance(&mut self, t: &mut [f64], dt: f64, mut slope: impl FnMut(&[f64], &mut [f64])) {
        self.start.copy_from_slice(t);
        slope(t, &mut self.slope_at_start);
        self.before.copy_from_slice(t);
        for (y, (t, m)) in self.previous.iter_mut().zip(t.iter().zip(&self.slope_at_start)) {
            *y = t + self.first * dt * m;
        }
        for stage in &self.stages {
            slope(&self.previous, &mut self.slope);
            let rest = 1.0 - stage.mu - stage.nu;
            for (i, y) in t.iter_mut().enumerate() {
                *y = stage.mu * self.previous[i]
                    + stage.nu * self.before[i]
                    + rest * self.start[i]
                    + dt * (stage.mu_slope * self.slope[i] + stage.gamma_slope * self.slope_at_start[i]);
            }
            std::mem::swap(&mut self.before, &mut self.previous);
            self.previous.copy_from_slice(t);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decay at several rates: the error falls at second order.
    #[test]
    fn the_error_of_decay_falls_at_second_order() {
        let rates = [0.3, 1.0, 2.0];
        let error = |steps: usize| {
            let mut t = [1.0; 3];
            let mut step = SuperStep::new(5, 3);
            for _ in 0..steps {
                step.advance(&mut t, 1.0 / steps as f64, |t, m| (0..3).for_each(|i| m[i] = -rates[i] * t[i]));
            }
            (0..3).map(|i| (t[i] - libm::exp(-rates[i])).abs()).fold(0.0, f64::max)
        };
        let order = libm::log2(error(8) / error(16));
        assert!((1.8..2.3).contains(&order), "{order}");
    }

    #[test]
    fn stiff_decay_stays_bounded_at_the_stated_limit() {
        for s in [2, 5, 9] {
            let limit = ((s * s + s - 2) as f64) * 0.25;
            let mut t = [1.0, 1.0];
            let mut step = SuperStep::new(s, 2);
            for _ in 0..50 {
                // The fastest rate allows explicit steps of 1: 2 / rate.
                step.advance(&mut t, limit, |t, m| {
                    m[0] = -2.0 * t[0];
                    m[1] = -0.01 * t[1];
                });
                assert!(t[0].abs() <= 1.0 && t[1] <= 1.0, "{s} stages: {t:?}");
            }
        }
        assert_eq!(SuperStep::stages_for(1.0, 1.0), 2);
        assert_eq!(SuperStep::stages_for(6.9, 1.0), 5);
    }
}
