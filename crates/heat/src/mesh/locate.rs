//! Point location in the triangulation of a cross-section.

use crate::mesh::section::Section;
use serde::{Deserialize, Serialize};

/// A point inside a triangle, as three nodes and their linear shape functions [-].
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Located {
    /// Nodes at the corners of the triangle.
    pub nodes: [u32; 3],
    /// Shape functions (barycentric coordinates) at the point; they sum to 1 [-].
    pub weights: [f64; 3],
}

impl Located {
    /// Returns the location of a point in a triangle, or `None` if the point is outside.
    pub fn within(nodes: [u32; 3], corners: [[f64; 2]; 3], point: [f64; 2]) -> Option<Self> {
        let weights = shape_functions(corners, point);
        weights.iter().all(|&w| w >= -1e-9).then_some(Self { nodes, weights })
    }
}

/// A uniform grid of buckets that finds the triangle around a point [m].
///
/// Temperature at a point between the nodes:
///
/// ```
/// use saute_heat::{Locator, Outline, Section};
///
/// let section = Section::mesh(&Outline::circle(0.05), 5e-3, 2e-3)?;
/// let field_k: Vec<f64> = section.points.iter().map(|p| 300.0 + 1000.0 * p[0]).collect();
/// let found = Locator::new(&section).locate_or_nearest(&section, [0.0123, 0.004]);
/// let at_k: f64 = found.nodes.iter().zip(found.weights).map(|(n, w)| w * field_k[*n as usize]).sum();
/// assert!((at_k - 312.3).abs() < 1e-9, "{at_k} K");
/// # Ok::<(), saute_heat::MeshError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Locator {
    origin: [f64; 2],
    cell: f64,
    columns: usize,
    rows: usize,
    buckets: Vec<Vec<u32>>,
}

impl Locator {
    /// Returns a locator for a section, with buckets about two triangles wide.
    pub fn new(section: &Section) -> Self {
        let (low, high) = bounds(section.points.iter().copied());
        // A section without triangles (a body of cells) gets buckets of an arbitrary width.
        let cell = match section.triangles.len() {
            0 => 1.0,
            count => libm::sqrt(section.area() / count as f64).max(1e-9) * 2.0,
        };
        let columns = ((high[0] - low[0]) / cell) as usize + 1;
        let rows = ((high[1] - low[1]) / cell) as usize + 1;
        let mut locator = Self { origin: low, cell, columns, rows, buckets: vec![Vec::new(); columns * rows] };
        for (index, triangle) in section.triangles.iter().enumerate() {
            let (low, high) = bounds(triangle.iter().map(|&i| section.points[i as usize]));
            let (from, to) = (locator.clamped(low), locator.clamped(high));
            for row in from[1]..=to[1] {
                for column in from[0]..=to[0] {
                    locator.buckets[row * columns + column].push(index as u32);
                }
            }
        }
        locator
    }

    fn clamped(&self, p: [f64; 2]) -> [usize; 2] {
        let along = |v: f64, origin: f64, n: usize| (((v - origin) / self.cell).max(0.0) as usize).min(n - 1);
        [along(p[0], self.origin[0], self.columns), along(p[1], self.origin[1], self.rows)]
    }

    /// Returns the triangle that contains a point [m], or `None` outside the section.
    pub fn locate(&self, section: &Section, point: [f64; 2]) -> Option<Located> {
        let [column, row] = self.clamped(point);
        let candidates = &self.buckets[row * self.columns + column];
        candidates.iter().find_map(|&t| {
            let nodes = section.triangles[t as usize];
            Located::within(nodes, nodes.map(|i| section.points[i as usize]), point)
        })
    }

    /// Returns the triangle that contains a point [m], or the nearest node if the point is outside.
    pub fn locate_or_nearest(&self, section: &Section, point: [f64; 2]) -> Located {
        self.locate(section, point).unwrap_or_else(|| {
            let distance = |p: &[f64; 2]| libm::hypot(p[0] - point[0], p[1] - point[1]);
            let nearest = (0..section.points.len())
                .min_by(|&a, &b| distance(&section.points[a]).total_cmp(&distance(&section.points[b])))
                .unwrap_or(0) as u32;
            Located { nodes: [nearest; 3], weights: [1.0, 0.0, 0.0] }
        })
    }
}

fn bounds(points: impl Iterator<Item = [f64; 2]>) -> ([f64; 2], [f64; 2]) {
    points.fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), p| {
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    })
}

fn shape_functions([a, b, c]: [[f64; 2]; 3], p: [f64; 2]) -> [f64; 3] {
    let cross = |o: [f64; 2], u: [f64; 2], v: [f64; 2]| (u[0] - o[0]) * (v[1] - o[1]) - (v[0] - o[0]) * (u[1] - o[1]);
    let whole = cross(a, b, c);
    [cross(p, b, c) / whole, cross(a, p, c) / whole, cross(a, b, p) / whole]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::outline::Outline;

    #[test]
    fn linear_fields_are_reproduced_everywhere() {
        let section = Section::mesh(&Outline::circle(0.05), 6e-3, 2e-3).expect("meshes");
        let locator = Locator::new(&section);
        let field = |p: [f64; 2]| 3.0 + 20.0 * p[0] - 7.0 * p[1];
        for i in 0..200 {
            let angle = f64::from(i) * 2.399;
            let radius = 0.048 * libm::sqrt(f64::from(i) / 200.0);
            let p = [radius * libm::cos(angle), radius * libm::sin(angle)];
            let found = locator.locate(&section, p).expect("inside");
            let value: f64 = (0..3).map(|k| found.weights[k] * field(section.points[found.nodes[k] as usize])).sum();
            assert!((value - field(p)).abs() < 1e-9);
        }
        assert!(locator.locate(&section, [0.06, 0.0]).is_none());
        assert_eq!(locator.locate_or_nearest(&section, [0.06, 0.0]).weights[0], 1.0);
    }
}
