//! Tension distribution: the string tensions that render a wrench.

use crate::strings::linear::solve_symmetric;
use crate::strings::{Lines, STRINGS};
use crate::wrench::Wrench;

/// Parameters of the tension distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TensionRule {
    /// Minimum tension, which keeps strings taut [N].
    pub min: f64,
    /// Maximum tension [N].
    pub max: f64,
    /// Lever l that converts a torque error to a force error [m].
    pub lever: f64,
    /// Weight ρ of squared tension above the minimum over squared force error [-].
    pub regularisation: f64,
}

/// A tension distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tensions {
    /// Tension of each string [N].
    pub tension: [f64; STRINGS],
    /// Wrench of these tensions [N, N·m].
    pub achieved: Wrench,
    /// Number of linear systems solved.
    pub rounds: u32,
}

/// Bound at which a tension is held.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bound {
    Free,
    Low,
    High,
}

/// Maximum number of active-set iterations (chosen: several times what eight bounds need in the tests, and still within a step).
const ROUNDS: u32 = 64;
/// Gradient below which a bound stays active [N] (chosen: far below the required accuracy of 1e-6).
const TOLERANCE: f64 = 1e-12;

/// Solves the box-constrained quadratic programme of the tensions [N]:
/// min |Σ tᵢ dᵢ − F|² + |Σ tᵢ rᵢ − T|²/l² + ρ Σ (tᵢ − t_min)² with t_min ≤ tᵢ ≤ t_max.
///
/// A primal active-set method starts from the active bounds of the last solution. The problem is strictly convex for ρ > 0, so
/// its one solution is found exactly. It allocates nothing.
///
/// ```
/// use saute_haptics::{TensionSolver, Wrench, library};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let devices = library::devices()?;
/// let geometry = &devices["spidar-pan-crossed"];
/// let lines = geometry.rig().lines(&geometry.home());
/// let mut solver = TensionSolver::new(geometry.tension_rule());
/// let weight = Wrench { force: glam::DVec3::new(0.0, 0.0, -3.0), ..Wrench::ZERO };
/// let rest = solver.solve(&lines, &geometry.preload());
/// let loaded = solver.solve(&lines, &(geometry.preload() + weight));
/// let rendered = loaded.achieved - rest.achieved;
/// assert!((rendered.force - weight.force).length() < 0.1, "{} N", rendered.force);
/// assert!(loaded.tension.iter().all(|t| *t >= geometry.drive.min_tension_n));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TensionSolver {
    rule: TensionRule,
    bounds: [Bound; STRINGS],
    last: [f64; STRINGS],
}

/// H and c of ½ xᵀ H x + cᵀ x.
struct Quadratic {
    h: [[f64; STRINGS]; STRINGS],
    c: [f64; STRINGS],
}

impl Quadratic {
    fn new(lines: &Lines, wrench: &Wrench, rule: &TensionRule) -> Self {
        let per_lever = 1.0 / rule.lever;
        let scaled = |mut rows: [f64; 6]| {
            rows[3..].iter_mut().for_each(|r| *r *= per_lever);
            rows
        };
        let columns: [[f64; 6]; STRINGS] = std::array::from_fn(|i| scaled(lines.column(i)));
        let wanted = scaled(wrench.rows());
        let dot = |a: &[f64; 6], b: &[f64; 6]| (0..6).map(|k| a[k] * b[k]).sum::<f64>();
        let mut h: [[f64; STRINGS]; STRINGS] =
            std::array::from_fn(|i| std::array::from_fn(|j| dot(&columns[i], &columns[j])));
        (0..STRINGS).for_each(|i| h[i][i] += rule.regularisation);
        let c = std::array::from_fn(|i| -dot(&columns[i], &wanted) - rule.regularisation * rule.min);
        Self { h, c }
    }

    fn gradient(&self, x: &[f64; STRINGS], i: usize) -> f64 {
        self.c[i] + (0..STRINGS).map(|j| self.h[i][j] * x[j]).sum::<f64>()
    }

    /// Returns the minimum over the free tensions while the others stay at their bounds.
    fn best_free(&self, x: &[f64; STRINGS], bounds: &[Bound; STRINGS]) -> Option<[f64; STRINGS]> {
        let mut free = [0; STRINGS];
        let mut n = 0;
        for i in (0..STRINGS).filter(|&i| bounds[i] == Bound::Free) {
            free[n] = i;
            n += 1;
        }
        let (mut a, mut b) = ([[0.0; STRINGS]; STRINGS], [0.0; STRINGS]);
        for (r, &i) in free[..n].iter().enumerate() {
            let fixed = (0..STRINGS).filter(|&j| bounds[j] != Bound::Free).map(|j| self.h[i][j] * x[j]).sum::<f64>();
            b[r] = -self.c[i] - fixed;
            (0..n).for_each(|k| a[r][k] = self.h[i][free[k]]);
        }
        if !solve_symmetric(&mut a, &mut b, n) {
            return None;
        }
        let mut y = *x;
        (0..n).for_each(|r| y[free[r]] = b[r]);
        Some(y)
    }
}

impl TensionSolver {
    /// Creates a solver that starts from minimum tensions.
    pub fn new(rule: TensionRule) -> Self {
        Self { rule, bounds: [Bound::Low; STRINGS], last: [rule.min; STRINGS] }
    }

    /// Returns the solver's parameters.
    pub fn rule(&self) -> &TensionRule {
        &self.rule
    }

    /// Returns the optimal tensions for a wrench on the body [N].
    pub fn solve(&mut self, lines: &Lines, wrench: &Wrench) -> Tensions {
        let problem = Quadratic::new(lines, wrench, &self.rule);
        let mut rounds = 0;
        while rounds < ROUNDS {
            rounds += 1;
            let Some(y) = problem.best_free(&self.last, &self.bounds) else { break };
            if self.move_towards(&y) && !self.release(&problem) {
                break;
            }
        }
        Tensions { tension: self.last, achieved: lines.wrench(&self.last), rounds }
    }

    /// Moves to `y` or to the first blocking bound; returns true if `y` was reached.
    fn move_towards(&mut self, y: &[f64; STRINGS]) -> bool {
        let (mut share, mut blocking) = (1.0, None);
        for i in (0..STRINGS).filter(|&i| self.bounds[i] == Bound::Free) {
            let way = y[i] - self.last[i];
            let (limit, bound) = if way < 0.0 { (self.rule.min, Bound::Low) } else { (self.rule.max, Bound::High) };
            let beyond = if way < 0.0 { y[i] < limit } else { y[i] > limit };
            if beyond && (limit - self.last[i]) / way < share {
                (share, blocking) = (((limit - self.last[i]) / way).max(0.0), Some((i, limit, bound)));
            }
        }
        for i in (0..STRINGS).filter(|&i| self.bounds[i] == Bound::Free) {
            self.last[i] += share * (y[i] - self.last[i]);
        }
        if let Some((i, limit, bound)) = blocking {
            (self.last[i], self.bounds[i]) = (limit, bound);
        }
        blocking.is_none()
    }

    /// Frees the tension with the largest Lagrange multiplier; returns true if there is one above the tolerance.
    fn release(&mut self, problem: &Quadratic) -> bool {
        let multiplier = |i: usize| match self.bounds[i] {
            Bound::Free => 0.0,
            Bound::Low => -problem.gradient(&self.last, i),
            Bound::High => problem.gradient(&self.last, i),
        };
        let worst = (0..STRINGS).map(|i| (i, multiplier(i))).fold((0, TOLERANCE), |w, h| if h.1 > w.1 { h } else { w });
        if worst.1 > TOLERANCE {
            self.bounds[worst.0] = Bound::Free;
        }
        worst.1 > TOLERANCE
    }
}
