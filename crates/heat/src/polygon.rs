//! Polygons with few corners that follow an outline.

use crate::outline::Outline;

/// Share of the corners that are spread by length alone, the rest goes where the outline bends [-] (chosen).
const BY_LENGTH: f64 = 0.15;

impl Outline {
    /// A polygon that strays by at most `stray` [m] from the outline, as far inside with its sides as outside with its
    /// corners, with as few corners of `fewest` to `most` as keep that; with `most` where none does.
    pub fn polygon(&self, stray: f64, [fewest, most]: [usize; 2]) -> Vec<[f64; 2]> {
        let mut count = fewest;
        loop {
            let at = self.spread(count);
            let sags: Vec<f64> = (0..count).map(|k| self.sag(at[k], at[(k + 1) % count])).collect();
            if count >= most || sags.iter().all(|sag| 0.5 * sag <= stray) {
                let out = |k: usize| 0.5 * sags[k].max(sags[(k + count - 1) % count]);
                return (0..count).map(|k| self.pushed_out(at[k], out(k))).collect();
            }
            count += 2;
        }
    }

    /// Places of corners along the outline, closer where it bends: a chord's sagitta is κ s²/8, so √κ is spread evenly.
    fn spread(&self, count: usize) -> Vec<usize> {
        let n = self.points.len();
        let side = |i: usize| {
            let (p, q) = (self.points[i % n], self.points[(i + 1) % n]);
            [q[0] - p[0], q[1] - p[1]]
        };
        let perimeter = self.perimeter();
        let mut sum = vec![0.0];
        for i in 0..n {
            let ([a, b], [c, d]) = (side(i), side(i + 1));
            let (length, turn) = (libm::hypot(a, b), libm::fabs(libm::atan2(a * d - b * c, a * c + b * d)));
            let bends = libm::sqrt(turn * length) / libm::sqrt(core::f64::consts::TAU * perimeter);
            sum.push(sum[i] + (1.0 - BY_LENGTH) * bends + BY_LENGTH * length / perimeter);
        }
        (0..count).map(|k| sum.partition_point(|s| *s < sum[n] * k as f64 / count as f64) % n).collect()
    }

    /// Largest distance of the outline from its chord between two places [m].
    fn sag(&self, from: usize, to: usize) -> f64 {
        let n = self.points.len();
        let (p, q) = (self.points[from], self.points[to]);
        let chord = [q[0] - p[0], q[1] - p[1]];
        let length = libm::hypot(chord[0], chord[1]).max(1e-12);
        let off = |i: usize| {
            let r = self.points[(from + i) % n];
            libm::fabs((r[0] - p[0]) * chord[1] - (r[1] - p[1]) * chord[0]) / length
        };
        (0..(to + n - from) % n).map(off).fold(0.0, f64::max)
    }

    fn pushed_out(&self, at: usize, by: f64) -> [f64; 2] {
        let n = self.points.len();
        let (p, before, after) = (self.points[at], self.points[(at + n - 1) % n], self.points[(at + 1) % n]);
        let along = [after[0] - before[0], after[1] - before[1]];
        let length = libm::hypot(along[0], along[1]).max(1e-12);
        [p[0] + by * along[1] / length, p[1] - by * along[0] / length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_strays_from_its_outline_no_further_than_it_may() {
        for outline in [Outline::superellipse(0.12, 0.08, 2.5, &[(3, 0.02, 1.0)]), Outline::circle(0.015)] {
            let polygon = Outline { points: outline.polygon(0.25e-3, [16, 32]) };
            assert!((16..=32).contains(&polygon.points.len()));
            let inside = outline.points.iter().map(|p| polygon.distance_to(*p)).fold(0.0, f64::max);
            let outside = polygon.points.iter().map(|p| outline.distance_to(*p)).fold(0.0, f64::max);
            assert!(inside < 0.3e-3 && outside < 0.3e-3, "{inside} {outside} with {}", polygon.points.len());
        }
    }
}
