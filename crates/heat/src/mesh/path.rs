//! The path along which a cross-section is swept: straight up, straight up with uneven height, or along stations.

use glam::DVec3;

use crate::mesh::outline::Outline;
use crate::mesh::section::{MeshError, Section};

/// A station of a path: the local cross-section with its plane in space [m].
#[derive(Clone, Debug)]
pub struct Station {
    /// Position of the section's origin [m].
    pub centre: [f64; 3],
    /// Unit vectors of the section's two coordinates; their cross product points along the path [-].
    pub across: [[f64; 3]; 2],
    /// The local section: the same nodes at other points, with its own Delaunay triangulation, so that no cotangent
    /// weight is negative.
    pub section: Section,
}

impl Station {
    /// Returns a station with the nodes of `section` at `points`, in the plane through `centre` [m].
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the points span no triangle.
    pub fn new(
        section: &Section,
        centre: [f64; 3],
        across: [[f64; 3]; 2],
        points: Vec<[f64; 2]>,
    ) -> Result<Self, MeshError> {
        let rim = Outline { points: section.rim().iter().map(|&i| points[i as usize]).collect() };
        // Areas use the triangles of the original section, so that they vary smoothly from station to station.
        let areas = section.areas_at(&points);
        let standing = Section::triangulate(points, |p| rim.contains(p))?;
        Ok(Self { centre, across, section: Section { areas, ..standing } })
    }

    /// Returns a station with the section scaled along its two coordinates by the factors `scale` [-].
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the scaled points span no triangle.
    pub fn scaled(
        section: &Section,
        centre: [f64; 3],
        across: [[f64; 3]; 2],
        scale: [f64; 2],
    ) -> Result<Self, MeshError> {
        let points = section.points.iter().map(|p| [scale[0] * p[0], scale[1] * p[1]]).collect();
        Self::new(section, centre, across, points)
    }

    /// Returns the position in space of a point in the section's plane [m].
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [a, b] = self.across.map(DVec3::from);
        (DVec3::from(self.centre) + x * a + y * b).to_array()
    }

    /// Returns the coordinates of a point in the frame of the station: two in the plane and the one along the path [m].
    pub fn coordinates(&self, p: [f64; 3]) -> [f64; 3] {
        let from = DVec3::from(p) - DVec3::from(self.centre);
        let [a, b] = self.across.map(DVec3::from);
        [a, b, a.cross(b)].map(|e| from.dot(e))
    }

    /// Returns the direction of the path: the cross product of the section's unit vectors [-].
    pub(super) fn along(&self) -> DVec3 {
        let [a, b] = self.across.map(DVec3::from);
        a.cross(b)
    }
}

/// The path of a section through a body.
#[derive(Clone, Debug, Default)]
pub enum Path {
    /// Along z, with a constant section.
    #[default]
    Straight,
    /// Along z; each column of nodes has its own height ÷ mean height [-].
    Uneven(Vec<f64>),
    /// One station per level.
    Stations(Vec<Station>),
}

impl Path {
    /// Returns a path with column heights 1 + `variation` − its mean over the section [-].
    pub fn uneven(section: &Section, variation: impl Fn([f64; 2]) -> f64) -> Self {
        let raw: Vec<f64> = section.points.iter().map(|p| variation(*p)).collect();
        let mean = raw.iter().zip(&section.areas).map(|(v, a)| v * a).sum::<f64>() / section.area();
        Self::Uneven(raw.into_iter().map(|v| 1.0 + v - mean).collect())
    }

    /// Returns the height of a column ÷ mean height, 1 for an even path [-].
    pub fn column(&self, i: usize) -> f64 {
        match self {
            Self::Uneven(columns) => columns[i],
            Self::Straight | Self::Stations(_) => 1.0,
        }
    }
}
