//! Corners of polyhedra that neighbours share.

use std::collections::BTreeMap;

/// Distance below which two corners are one ÷ spacing of the nodes [-] (chosen: far above rounding, far below any edge that can
/// be seen).
const SAME: f64 = 1e-5;
/// Edge of the cubes in which corners are looked up ÷ spacing [-] (chosen: a few corners in each).
const CUBE: f64 = 0.2;

/// Corners, each once [m].
pub(super) struct Corners {
    pub(super) points: Vec<[f64; 3]>,
    cubes: BTreeMap<[i64; 3], Vec<u32>>,
    same: f64,
    cube: f64,
}

impl Corners {
    /// Returns no corners, of cells whose nodes are `spacing` apart [m].
    pub(super) fn new(spacing: f64) -> Self {
        Self { points: Vec::new(), cubes: BTreeMap::new(), same: SAME * spacing, cube: CUBE * spacing }
    }

    /// Returns the corners of a polygon; none if fewer than three are left.
    pub(super) fn polygon(&mut self, points: &[[f64; 3]]) -> Option<Vec<u32>> {
        let mut corners: Vec<u32> = points.iter().map(|p| self.corner(*p)).collect();
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        (corners.len() > 2).then_some(corners)
    }

    fn corner(&mut self, p: [f64; 3]) -> u32 {
        if let Some(known) = self.near(p) {
            return known;
        }
        let next = self.points.len() as u32;
        self.points.push(p);
        self.cubes.entry(self.place(p, 0.0)).or_default().push(next);
        next
    }

    fn near(&self, p: [f64; 3]) -> Option<u32> {
        let (low, high) = (self.place(p, -self.same), self.place(p, self.same));
        let mut cubes = (low[0]..=high[0])
            .flat_map(|x| (low[1]..=high[1]).flat_map(move |y| (low[2]..=high[2]).map(move |z| [x, y, z])));
        cubes.find_map(|cube| {
            let here = self.cubes.get(&cube)?;
            here.iter().copied().find(|corner| {
                let q = self.points[*corner as usize];
                (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>() < self.same * self.same
            })
        })
    }

    fn place(&self, p: [f64; 3], shift: f64) -> [i64; 3] {
        p.map(|v| ((v + shift) / self.cube).floor() as i64)
    }
}
