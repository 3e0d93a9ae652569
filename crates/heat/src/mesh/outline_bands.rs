//! The sides of an outline by their height, so that a point is compared with the few beside it.

use crate::mesh::outline::{Outline, distance_to_segment};

/// Number of bands [-] (chosen: some six sides each in a smooth outline).
const BANDS: usize = 512;
/// Margin on distances, in which a side is looked at although its band says that it is too far [-] (chosen: far above rounding).
const MARGIN: f64 = 1e-6;

/// Sides of an outline in bands of y. The answers are exactly those of the whole outline.
#[derive(Clone, Debug)]
pub struct OutlineBands {
    low: f64,
    per_metre: f64,
    bands: Vec<Vec<[[f64; 2]; 2]>>,
}

impl OutlineBands {
    /// Sorts the sides of an outline.
    pub fn new(outline: &Outline) -> Self {
        let heights = || outline.points.iter().map(|p| p[1]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(f64::NEG_INFINITY, f64::max);
        let mut sorted = Self { low, per_metre: BANDS as f64 / (high - low), bands: vec![Vec::new(); BANDS] };
        for (p, q) in outline.corners() {
            let [from, to] = [sorted.band(p[1].min(q[1])), sorted.band(p[1].max(q[1]))];
            sorted.bands[from..=to].iter_mut().for_each(|band| band.push([p, q]));
        }
        sorted
    }

    /// Band of a height; the first or the last beyond the outline. It never falls while the height rises.
    fn band(&self, y: f64) -> usize {
        (((y - self.low) * self.per_metre).max(0.0) as usize).min(BANDS - 1)
    }

    /// Returns true if a point [m] is inside, by the even–odd rule.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        let sides = self.bands[self.band(point[1])].iter();
        sides.filter(|side| is_crossed(point, **side)).count() % 2 == 1
    }

    /// Returns true if a point is farther from the curve than a distance [m].
    pub fn is_farther(&self, point: [f64; 2], least: f64) -> bool {
        let reach = least * (1.0 + MARGIN);
        let [x, y] = point;
        let [from, to] = [self.band(y - reach), self.band(y + reach)];
        self.bands[from..=to].iter().flatten().all(|&[p, q]| {
            let is_beside = p[0].max(q[0]) < x - reach || p[0].min(q[0]) > x + reach;
            is_beside || distance_to_segment(point, p, q) > least
        })
    }
}

/// Returns true if the ray from a point along x crosses a side.
pub(super) fn is_crossed([x, y]: [f64; 2], [p, q]: [[f64; 2]; 2]) -> bool {
    (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_those_of_the_whole_outline() {
        let outlines = [
            Outline::superellipse(0.12, 0.08, 2.6, &[(3, 0.08, 1.0), (2, 0.03, 0.4)]),
            Outline::circle(0.05),
            Outline::rectangle(0.12, 0.07),
        ];
        for outline in &outlines {
            let bands = OutlineBands::new(outline);
            for i in 0..1500 {
                let share = [0.618_034, 0.754_878].map(|step| f64::from(i) * step % 1.0 - 0.5);
                let mut p = [0.15 * share[0], 0.1 * share[1]];
                if i % 5 == 0 {
                    // As high as a corner, and on the curve.
                    p = outline.points[i as usize % outline.points.len()];
                }
                assert_eq!(bands.contains(p), outline.contains(p), "{p:?}");
                for least in [1e-4, 2e-3, 0.02] {
                    assert_eq!(bands.is_farther(p, least), outline.distance_to(p) > least, "{p:?} {least}");
                }
            }
        }
    }
}
