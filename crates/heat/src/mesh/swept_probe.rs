//! Point location and interpolation inside a swept body.

use crate::mesh::locate::Located;
use crate::mesh::path::Station;
use crate::mesh::probe::Probe;
use crate::mesh::swept::SweptMesh;

impl SweptMesh {
    /// Returns the triangle of the section that contains a point [m], or `None` outside.
    pub fn locate(&self, p: [f64; 2]) -> Option<Located> {
        self.locator.locate(&self.section, p)
    }

    /// Returns the triangle of the section that contains a point [m], or the nearest node if the point is outside.
    pub fn locate_or_nearest(&self, p: [f64; 2]) -> Located {
        self.locator.locate_or_nearest(&self.section, p)
    }

    /// Returns the height of the column through a point of the section ÷ mean height [-].
    pub fn column_at(&self, found: &Located) -> f64 {
        (0..3).map(|k| found.weights[k] * self.path.column(found.nodes[k] as usize)).sum()
    }

    /// Returns the location of a point in the section and its distance along the path [m], or `None` outside.
    pub fn place_of(&self, p: [f64; 3]) -> Option<(Located, f64)> {
        if let Some(stations) = self.stations() {
            return self.place_among(stations, p);
        }
        let found = self.locate([p[0], p[1]])?;
        let height = p[2] / self.column_at(&found);
        (0.0..=self.thickness()).contains(&height).then_some((found, height))
    }

    /// Returns the location of a point between stations: its triangle of the section and its distance along the path [m].
    fn place_among(&self, stations: &[Station], p: [f64; 3]) -> Option<(Located, f64)> {
        for (level, pair) in stations.windows(2).enumerate() {
            let (low, high) = (pair[0].coordinates(p), pair[1].coordinates(p));
            if low[2] < -1e-12 || high[2] > 1e-12 {
                continue;
            }
            let share = if low[2] > high[2] { low[2] / (low[2] - high[2]) } else { 0.0 };
            let point = [0, 1].map(|k| low[k] + share * (high[k] - low[k]));
            let node = |i: u32| {
                let [a, b] = [0, 1].map(|k| pair[k].section.points[i as usize]);
                [0, 1].map(|k| a[k] + share * (b[k] - a[k]))
            };
            let corners = self.section.triangles.iter().map(|t| Located::within(*t, t.map(node), point));
            if let Some(found) = corners.flatten().next() {
                return Some((found, self.levels[level] + share * (self.levels[level + 1] - self.levels[level])));
            }
        }
        None
    }

    /// Returns the probe at a location in the section and a distance `z` along the path [m].
    pub fn probe_at(&self, found: &Located, z: f64) -> Probe {
        let (level, upper) = self.bracket(z);
        let nodes = [level, level + 1].map(|l| found.nodes.map(|i| self.node(l, i as usize) as u32));
        Probe::Levels { nodes, weights: found.weights, upper }
    }

    /// Returns the lower of the two levels that bracket a distance along the path [m], and the weight of the upper one [-].
    ///
    /// Distances beyond the ends are clamped.
    pub fn bracket(&self, z: f64) -> (usize, f64) {
        let upper = self.levels.partition_point(|&l| l <= z).clamp(1, self.levels.len() - 1);
        let (low, high) = (self.levels[upper - 1], self.levels[upper]);
        (upper - 1, ((z - low) / (high - low)).clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Outline, Section};

    #[test]
    fn distances_are_clamped_at_both_ends_of_the_path() {
        let section = Section::mesh(&Outline::circle(0.01), 2e-3, 1e-3).expect("meshes");
        let mesh = SweptMesh::new(section, vec![0.0, 1.0, 3.0]);
        assert_eq!(mesh.bracket(-1.0), (0, 0.0));
        assert_eq!(mesh.bracket(2.0), (1, 0.5));
        assert_eq!(mesh.bracket(9.0), (1, 1.0));
    }
}
