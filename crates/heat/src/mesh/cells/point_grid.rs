//! A uniform grid of points for neighbour search.
//!
//! Points are visited in a fixed order, bucket by bucket; sums over neighbours depend on it to the last bit.

use glam::DVec3;

use crate::mesh::bounds::bounds;

/// Most buckets along an edge of the box [-] (chosen: limits the memory where points are far apart).
const MOST_CUBES: usize = 128;

/// Points in cubic buckets [m].
#[derive(Clone, Debug, Default)]
pub struct PointGrid {
    low: DVec3,
    cube: f64,
    counts: [usize; 3],
    buckets: Vec<Vec<u32>>,
    /// The points in order of insertion [m].
    pub points: Vec<DVec3>,
}

impl PointGrid {
    /// Returns an empty grid over a box, with buckets of about the given edge [m].
    pub fn over([low, high]: [DVec3; 2], cube: f64) -> Self {
        let edges = (high - low).to_array();
        let largest = edges.into_iter().fold(0.0, f64::max);
        let cube = cube.max(largest / MOST_CUBES as f64).max(f64::MIN_POSITIVE);
        let counts = edges.map(|e| (e / cube) as usize + 1);
        Self { low, cube, counts, buckets: vec![Vec::new(); counts[0] * counts[1] * counts[2]], points: Vec::new() }
    }

    /// Returns a grid of given points, with buckets of about the given edge [m].
    pub fn of(points: &[DVec3], cube: f64) -> Self {
        let mut grid = Self::over(bounds(points.iter().copied()), cube);
        points.iter().for_each(|p| grid.push(*p));
        grid
    }

    /// Adds a point [m].
    pub fn push(&mut self, p: DVec3) {
        let at = self.place(p);
        let bucket = self.bucket(at);
        self.buckets[bucket].push(self.points.len() as u32);
        self.points.push(p);
    }

    fn place(&self, p: DVec3) -> [usize; 3] {
        [0, 1, 2].map(|k| (((p[k] - self.low[k]) / self.cube).max(0.0) as usize).min(self.counts[k] - 1))
    }

    fn bucket(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Visits the points within a distance of `p`, with their distances [m].
    pub fn within(&self, p: DVec3, reach: f64, mut visit: impl FnMut(u32, f64)) {
        let (from, to) = (self.place(p - DVec3::splat(reach)), self.place(p + DVec3::splat(reach)));
        for z in from[2]..=to[2] {
            for y in from[1]..=to[1] {
                for x in from[0]..=to[0] {
                    for &i in &self.buckets[self.bucket([x, y, z])] {
                        let d = self.points[i as usize].distance(p);
                        if d <= reach {
                            visit(i, d);
                        }
                    }
                }
            }
        }
    }

    /// Returns true if a point that `accept` admits is closer to `p` than a distance [m].
    pub fn any_within(&self, p: DVec3, reach: f64, accept: impl Fn(u32) -> bool) -> bool {
        let mut any = false;
        self.within(p, reach, |i, d| any |= d < reach && accept(i));
        any
    }

    /// Returns the nearest point that `accept` admits, searched in doubling distances from `reach` on [m].
    pub fn nearest(&self, p: DVec3, mut reach: f64, accept: impl Fn(u32) -> bool) -> Option<u32> {
        let low = self.low;
        let high = low + self.cube * DVec3::from(self.counts.map(|n| n as f64));
        let farthest = low.distance(high) + p.distance(low).min(p.distance(high));
        loop {
            let mut best: Option<(f64, u32)> = None;
            self.within(p, reach, |i, d| {
                if best.is_none_or(|b| (d, i) < b) && accept(i) {
                    best = Some((d, i));
                }
            });
            if best.is_some() || reach > farthest {
                return best.map(|b| b.1);
            }
            reach *= 2.0;
        }
    }
}
