//! Points sorted into cubes, to find those near a place.

use crate::vector::{Vec3, bounds, distance, sub};

/// Most cubes along an edge (chosen: bounds memory where points lie far apart).
const MOST_CUBES: usize = 128;

/// Points in cubes.
#[derive(Clone, Debug, Default)]
pub struct PointGrid {
    low: Vec3,
    cube: f64,
    counts: [usize; 3],
    buckets: Vec<Vec<u32>>,
    /// The points in the order in which they came.
    pub points: Vec<Vec3>,
}

impl PointGrid {
    /// An empty grid over a box, with cubes of about the given edge [m].
    pub fn over([low, high]: [Vec3; 2], cube: f64) -> Self {
        let edges = sub(high, low);
        let largest = edges.into_iter().fold(0.0, f64::max);
        let cube = cube.max(largest / MOST_CUBES as f64).max(f64::MIN_POSITIVE);
        let counts = edges.map(|e| (e / cube) as usize + 1);
        Self { low, cube, counts, buckets: vec![Vec::new(); counts[0] * counts[1] * counts[2]], points: Vec::new() }
    }

    /// A grid of given points.
    pub fn of(points: &[Vec3], cube: f64) -> Self {
        let mut grid = Self::over(bounds(points.iter().copied()), cube);
        points.iter().for_each(|p| grid.push(*p));
        grid
    }

    /// Adds a point.
    pub fn push(&mut self, p: Vec3) {
        let at = self.place(p);
        let bucket = self.bucket(at);
        self.buckets[bucket].push(self.points.len() as u32);
        self.points.push(p);
    }

    fn place(&self, p: Vec3) -> [usize; 3] {
        [0, 1, 2].map(|k| (((p[k] - self.low[k]) / self.cube).max(0.0) as usize).min(self.counts[k] - 1))
    }

    fn bucket(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Visits the points within a distance, with their distance [m].
    pub fn within(&self, p: Vec3, reach: f64, mut visit: impl FnMut(u32, f64)) {
        let (from, to) = (self.place(p.map(|v| v - reach)), self.place(p.map(|v| v + reach)));
        for z in from[2]..=to[2] {
            for y in from[1]..=to[1] {
                for x in from[0]..=to[0] {
                    for &i in &self.buckets[self.bucket([x, y, z])] {
                        let d = distance(self.points[i as usize], p);
                        if d <= reach {
                            visit(i, d);
                        }
                    }
                }
            }
        }
    }

    /// Whether a point lies nearer than a distance that `accept`s being counted.
    pub fn any_within(&self, p: Vec3, reach: f64, accept: impl Fn(u32) -> bool) -> bool {
        let mut any = false;
        self.within(p, reach, |i, d| any |= d < reach && accept(i));
        any
    }

    /// The nearest of the points that `accept` takes, looked for in growing distances from `reach` on [m].
    pub fn nearest(&self, p: Vec3, mut reach: f64, accept: impl Fn(u32) -> bool) -> Option<u32> {
        let [low, high] = [self.low, [0, 1, 2].map(|k| self.low[k] + self.cube * self.counts[k] as f64)];
        let farthest = distance(low, high) + distance(p, low).min(distance(p, high));
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
