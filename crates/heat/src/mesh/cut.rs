//! Straight cuts through a cross-section; swept along the path, a cut is the plane that shows the inside of a body.

use crate::mesh::section::Section;

/// The crossing of a cut line and an edge of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutPoint {
    /// Distance along the cut from its reference point [m].
    pub along: f64,
    /// Nodes at the ends of the crossed edge.
    pub nodes: [u32; 2],
    /// Linear weight of the second node [-].
    pub share: f64,
}

/// A cut, as its crossings with edges in order along the line [m].
///
/// ```
/// use saute_heat::{Cut, Outline, Section};
///
/// let section = Section::mesh(&Outline::rectangle(0.04, 0.03), 2e-3, 1e-3)?;
/// let cut = Cut::new(&section, [0.01, 0.0], [0.0, 1.0]);
/// let length_m: f64 = cut.lengths().iter().sum();
/// assert!((length_m - 0.03).abs() < 1e-9, "{length_m} m");
/// # Ok::<(), saute_heat::MeshError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cut {
    /// Crossings, ascending along the line; empty where the line misses the section.
    pub points: Vec<CutPoint>,
}

impl Cut {
    /// Returns the cut along the line through `point` [m] with unit `direction` [-].
    pub fn new(section: &Section, point: [f64; 2], direction: [f64; 2]) -> Self {
        let offset = |i: u32| {
            let p = section.points[i as usize];
            (p[0] - point[0]) * -direction[1] + (p[1] - point[1]) * direction[0]
        };
        let along = |i: u32| {
            let p = section.points[i as usize];
            (p[0] - point[0]) * direction[0] + (p[1] - point[1]) * direction[1]
        };
        let mut points = Vec::new();
        for [a, b] in section.sides() {
            // A node exactly on the line counts as positive, so that every crossing is proper.
            let (da, db) = (offset(a), offset(b));
            if (da >= 0.0) != (db >= 0.0) {
                let share = da / (da - db);
                points.push(CutPoint { along: along(a) * (1.0 - share) + along(b) * share, nodes: [a, b], share });
            }
        }
        points.sort_by(|p, q| p.along.total_cmp(&q.along));
        Self { points }
    }

    /// Returns the length of line that belongs to each crossing: half of each neighbouring interval [m].
    pub fn lengths(&self) -> Vec<f64> {
        let n = self.points.len();
        (0..n)
            .map(|i| {
                let before = if i > 0 { self.points[i].along - self.points[i - 1].along } else { 0.0 };
                let after = if i + 1 < n { self.points[i + 1].along - self.points[i].along } else { 0.0 };
                0.5 * (before + after)
            })
            .collect()
    }

    /// Returns the value at crossing `i` of a field on the nodes of one level, in the unit of the field.
    pub fn sample(&self, i: usize, level: &[f64]) -> f64 {
        let p = &self.points[i];
        level[p.nodes[0] as usize] * (1.0 - p.share) + level[p.nodes[1] as usize] * p.share
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::outline::Outline;

    #[test]
    fn a_cut_through_a_disc_spans_its_diameter_and_samples_linearly() {
        let section = Section::mesh(&Outline::circle(0.05), 5e-3, 2e-3).expect("meshes");
        let cut = Cut::new(&section, [0.01, 0.0], [0.0, 1.0]);
        let length: f64 = cut.lengths().iter().sum();
        assert!((length / (2.0 * libm::sqrt(0.05f64 * 0.05 - 0.01 * 0.01)) - 1.0).abs() < 0.01);
        let field: Vec<f64> = section.points.iter().map(|p| 5.0 * p[1]).collect();
        for (i, p) in cut.points.iter().enumerate() {
            assert!((cut.sample(i, &field) - 5.0 * p.along).abs() < 1e-12);
        }
        assert!(Cut::new(&section, [0.2, 0.0], [0.0, 1.0]).points.is_empty());
    }
}
