//! The path along which a cross-section is carried: straight up, straight up with uneven height, or along stations.

use crate::mesh::outline::Outline;
use crate::mesh::section::{MeshError, Section};

/// Station of a path: the cross-section at one place, in a plane of space.
#[derive(Clone, Debug)]
pub struct Station {
    /// Position of the section's origin [m].
    pub centre: [f64; 3],
    /// Unit vectors along which the section's two coordinates run; their cross product points along the path [-].
    pub across: [[f64; 3]; 2],
    /// The section at the station: the same nodes at other points, with a triangulation of its own, so that no in-plane
    /// conductance is negative.
    pub section: Section,
}

impl Station {
    /// The nodes of `section` at `points` [m].
    pub fn new(
        section: &Section,
        centre: [f64; 3],
        across: [[f64; 3]; 2],
        points: Vec<[f64; 2]>,
    ) -> Result<Self, MeshError> {
        let rim = Outline { points: section.rim().iter().map(|&i| points[i as usize]).collect() };
        // Areas follow the triangles of the section itself, so that they pass smoothly from station to station.
        let areas = section.areas_at(&points);
        let standing = Section::triangulate(points, |p| rim.contains(p))?;
        Ok(Self { centre, across, section: Section { areas, ..standing } })
    }

    /// The section scaled along its two coordinates.
    pub fn scaled(
        section: &Section,
        centre: [f64; 3],
        across: [[f64; 3]; 2],
        scale: [f64; 2],
    ) -> Result<Self, MeshError> {
        let points = section.points.iter().map(|p| [scale[0] * p[0], scale[1] * p[1]]).collect();
        Self::new(section, centre, across, points)
    }

    /// Returns the position in space of a point of the section's plane [m].
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [a, b] = &self.across;
        [0, 1, 2].map(|k| self.centre[k] + x * a[k] + y * b[k])
    }

    /// Returns the coordinates of a point of space in the section's plane, and its distance from that plane along the path
    /// [m].
    pub fn coordinates(&self, p: [f64; 3]) -> [f64; 3] {
        let from = [0, 1, 2].map(|k| p[k] - self.centre[k]);
        let [a, b] = &self.across;
        [a, b, &cross(*a, *b)].map(|e| dot(from, *e))
    }
}

/// Path along which a section is swept.
#[derive(Clone, Debug, Default)]
pub enum Path {
    /// Straight along z, with a constant section.
    #[default]
    Straight,
    /// Straight along z; the height of each column of nodes relative to the mean [-].
    Uneven(Vec<f64>),
    /// A station for each level.
    Stations(Vec<Station>),
}

impl Path {
    /// Builds a path with column heights 1 + `variation`, shifted so that their mean over the section is 1 [-].
    pub fn uneven(section: &Section, variation: impl Fn([f64; 2]) -> f64) -> Self {
        let raw: Vec<f64> = section.points.iter().map(|p| variation(*p)).collect();
        let mean = raw.iter().zip(&section.areas).map(|(v, a)| v * a).sum::<f64>() / section.area();
        Self::Uneven(raw.into_iter().map(|v| 1.0 + v - mean).collect())
    }

    /// Height of a column relative to the mean [-].
    pub fn column(&self, i: usize) -> f64 {
        match self {
            Self::Uneven(columns) => columns[i],
            _ => 1.0,
        }
    }
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d = [0, 1, 2].map(|k| a[k] - b[k]);
    libm::sqrt(dot(d, d))
}
