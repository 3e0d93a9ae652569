//! Calibration: where the marks of the sheet are shown, found by looking, and the warp that follows.

use std::collections::BTreeMap;

use glam::DVec2;
use nalgebra::{DMatrix, DVector};

use crate::lens::Lens;
use crate::rig::{MARKS, Rig};
use crate::warp::Warp;

/// Where marks were moved to, in shares of the device's width and height; marks that were not are where the rig states.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize)]
pub struct Calibration {
    /// By the number of the mark.
    pub moved: BTreeMap<usize, [f64; 2]>,
}

/// The warp of a calibration, and how well it shows what was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// The warp.
    pub warp: Warp,
    /// Farthest that a moved mark is from where the warp shows it [pixels].
    pub residual: f64,
}

/// Corners among the marks.
const CORNERS: usize = 4;
/// Steps of the least-squares fit (chosen: it has converged after ten).
const FIT_STEPS: usize = 30;
/// Regularisation that keeps numbers which the marks do not determine near the rig's: pixels for a whole unit of k₁, k₂
/// and the centre's shift over the half diagonal (chosen: a hundredth of what a mark off by 0.1 pixel pulls where the
/// lens bends at all).
const PULL: [f64; 4] = [0.05, 0.05, 0.1, 0.1];

impl Calibration {
    /// Pixels at which the marks are shown now, on a device of a size [pixels].
    pub fn pixels(&self, rig: &Rig, size: DVec2) -> Option<[DVec2; MARKS]> {
        let places = rig.mark_places()?;
        let warp = self.fitted(rig, size)?.warp;
        let found = |mark: usize| self.moved.get(&mark).map(|share| DVec2::from_array(*share) * size);
        Some(std::array::from_fn(|mark| found(mark).unwrap_or_else(|| warp.pixel(places[mark]))))
    }

    /// Moves a mark to a pixel. A first corner makes all of them known: the others stay where they were shown.
    pub fn place(&mut self, mark: usize, pixel: DVec2, rig: &Rig, size: DVec2) {
        if let (true, Some(now)) = (mark < CORNERS, self.pixels(rig, size)) {
            for (corner, shown) in now.iter().enumerate().take(CORNERS) {
                self.moved.entry(corner).or_insert((*shown / size).to_array());
            }
        }
        self.moved.insert(mark, (pixel / size).to_array());
    }

    /// Puts a mark back to where it would be, a corner with all corners; or all marks.
    pub fn put_back(&mut self, mark: Option<usize>) {
        self.moved.retain(|moved, _| match mark {
            None => false,
            Some(corner) if corner < CORNERS => *moved >= CORNERS,
            Some(mark) => *moved != mark,
        });
    }

    /// Moves a mark by pixels.
    pub fn shift(&mut self, mark: usize, by: DVec2, rig: &Rig, size: DVec2) {
        if let Some(now) = self.pixels(rig, size) {
            self.place(mark, now[mark] + by, rig, size);
        }
    }

    /// Moves a mark by pixels in directions that the eye sees: x to its right, y downwards, however device and mirror
    /// turn the picture.
    pub fn nudge(&mut self, mark: usize, by: DVec2, rig: &Rig, size: DVec2) {
        const SHARE: f64 = 1e-4;
        let (Some(fitted), Some(places)) = (self.fitted(rig, size), rig.mark_places()) else { return };
        let from = fitted.warp.pixel(places[mark]);
        let along = |axis: DVec2| (fitted.warp.pixel(places[mark] + SHARE * axis) - from).normalize_or_zero();
        self.shift(mark, by.x * along(DVec2::X) + by.y * along(DVec2::Y), rig, size);
    }

    /// The warp that shows the corners where they were found, through the lens by which the other marks fit best: its
    /// first coefficient by one of them, both by three, the centre in addition by all five. None where three corners are on
    /// a line.
    pub fn fitted(&self, rig: &Rig, size: DVec2) -> Option<Fitted> {
        let places = rig.mark_places()?;
        let nominal = rig.nominal.scaled(rig.screen.pixels(), size);
        let shown = |mark: usize| {
            let found = self.moved.get(&mark).map(|share| DVec2::from_array(*share) * size);
            found.unwrap_or_else(|| nominal.pixel(places[mark]))
        };
        let corners = std::array::from_fn(shown);
        let seen = std::array::from_fn(|corner: usize| places[corner]);
        let middles: Vec<[DVec2; 2]> =
            (CORNERS..MARKS).filter(|m| self.moved.contains_key(m)).map(|m| [places[m], shown(m)]).collect();
        let warp_with = |lens: Lens| Warp::through(seen, corners, lens);
        if middles.is_empty() && !self.moved.keys().any(|mark| *mark < CORNERS) {
            return Some(Fitted { warp: nominal, residual: 0.0 });
        }
        let warp = warp_with(fit(nominal.lens, &middles, &warp_with))?;
        let off = middles.iter().map(|[place, pixel]| warp.pixel(*place).distance(*pixel));
        Some(Fitted { warp, residual: off.fold(0.0, f64::max) })
    }
}

/// The lens by which points are shown nearest to where they were found (Levenberg–Marquardt).
fn fit(start: Lens, points: &[[DVec2; 2]], warp_with: &dyn Fn(Lens) -> Option<Warp>) -> Lens {
    let free = match points.len() {
        0 => return start,
        1 | 2 => 1,
        3 | 4 => 2,
        _ => 4,
    };
    let lens_of = |x: [f64; 4]| Lens {
        k: [start.k[0] + x[0], start.k[1] + x[1]],
        centre: start.centre + start.unit * DVec2::new(x[2], x[3]),
        unit: start.unit,
    };
    let residuals = |x: [f64; 4]| -> Option<Vec<f64>> {
        let warp = warp_with(lens_of(x))?;
        let off = points.iter().flat_map(|[place, pixel]| (warp.pixel(*place) - *pixel).to_array());
        Some(off.chain((0..4).map(|i| PULL[i] * x[i])).collect())
    };
    let (mut x, mut damping) = ([0.0; 4], 1e-3);
    let Some(mut now) = residuals(x) else { return start };
    for _ in 0..FIT_STEPS {
        let Some(step) = step(x, &now, free, damping, &residuals) else { break };
        let tried: [f64; 4] = std::array::from_fn(|i| x[i] + step[i]);
        match residuals(tried) {
            Some(then) if squares(&then) < squares(&now) => {
                (x, now, damping) = (tried, then, damping * 0.2);
            }
            _ => damping *= 8.0,
        }
    }
    lens_of(x)
}

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

/// One Levenberg–Marquardt step for the first `free` parameters; the others are held. Solves the damped normal equations
/// (JᵀJ + λ diag JᵀJ) δ = −Jᵀr by a Cholesky factorisation.
fn step(
    x: [f64; 4],
    now: &[f64],
    free: usize,
    damping: f64,
    residuals: &dyn Fn([f64; 4]) -> Option<Vec<f64>>,
) -> Option<[f64; 4]> {
    let now = DVector::from_column_slice(now);
    let jacobian = jacobian(x, &now, free, residuals)?;
    let mut normal = jacobian.tr_mul(&jacobian);
    for i in 0..free {
        normal[(i, i)] *= 1.0 + damping;
    }
    let solved = normal.cholesky()?.solve(&-jacobian.tr_mul(&now));
    let finite = solved.iter().all(|delta| delta.is_finite());
    finite.then(|| std::array::from_fn(|i| solved.get(i).copied().unwrap_or(0.0)))
}

/// The derivatives of the residuals by the first `free` parameters (forward differences); one column each.
fn jacobian(
    x: [f64; 4],
    now: &DVector<f64>,
    free: usize,
    residuals: &dyn Fn([f64; 4]) -> Option<Vec<f64>>,
) -> Option<DMatrix<f64>> {
    const NUDGE: f64 = 1e-6;
    let column = |i: usize| {
        let mut moved = x;
        moved[i] += NUDGE;
        residuals(moved).map(|then| (DVector::from_vec(then) - now) / NUDGE)
    };
    let columns: Vec<_> = (0..free).map(column).collect::<Option<_>>()?;
    Some(DMatrix::from_columns(&columns))
}
