//! Closed surfaces: read as loose triangles, checked, and asked for distances.

mod crossing;
mod defect;
mod distance;
mod feature;
mod triangle_tree;
mod weld;

pub use defect::{Defect, Trouble};
pub use distance::{Depth, DepthFinder};
pub use feature::{Feature, features};

use crate::vector::{Vec3, add, bounds, cross, dot, length, scale, sub, unit};

/// Triangles as a file holds them: corners that belong together need not be shared.
#[derive(Clone, Debug, PartialEq)]
pub struct Soup {
    /// Corners, in the file's unit.
    pub vertices: Vec<Vec3>,
    /// Triangles by their corners, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Millimetres in one of those units, unless the user says otherwise [mm].
    pub unit_mm: f64,
}

impl Default for Soup {
    fn default() -> Self {
        Self { vertices: Vec::new(), triangles: Vec::new(), unit_mm: 1.0 }
    }
}

/// A closed surface of one body that does not cross itself; normals point outwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Corners [m].
    pub vertices: Vec<Vec3>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// Smallest thickness and largest length of a body [m] (chosen: below, the surface layers do not fit; above, nothing fits a pan).
pub const EXTENT: [f64; 2] = [3e-3, 0.3];

/// Most triangles of a surface (chosen: a scan at full detail has more, and shows no more once it is meshed inside).
pub const MOST_TRIANGLES: usize = 100_000;

impl Surface {
    /// Joins loose triangles, given how many metres the file's unit has, and checks that they close one sound body.
    ///
    /// A body that is inside out is turned; all else that is wrong is told with its number and place.
    pub fn close(soup: &Soup, metres: f64) -> Result<Self, Defect> {
        let mut surface = weld::weld(soup, metres)?;
        defect::closed(&surface)?;
        if surface.volume() < 0.0 {
            surface.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        defect::sized(&surface)?;
        match crossing::crossings(&surface) {
            found if found.count > 0 => Err(Defect::Crossing(found)),
            _ => Ok(surface),
        }
    }

    /// Corners of a triangle [m].
    #[inline]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|i| self.vertices[i as usize])
    }

    /// Vector along the normal of a triangle, twice its area long [m²].
    #[inline]
    pub fn doubled_area(&self, triangle: usize) -> Vec3 {
        let [a, b, c] = self.corners(triangle);
        cross(sub(b, a), sub(c, a))
    }

    /// Outward unit normal of a triangle.
    pub fn normal(&self, triangle: usize) -> Vec3 {
        unit(self.doubled_area(triangle))
    }

    /// Area [m²].
    pub fn area(&self) -> f64 {
        (0..self.triangles.len()).map(|t| 0.5 * length(self.doubled_area(t))).sum()
    }

    /// Enclosed volume [m³]; negative while the surface is inside out.
    pub fn volume(&self) -> f64 {
        let reference = self.vertices.first().copied().unwrap_or_default();
        let corners = |t: usize| self.corners(t).map(|p| sub(p, reference));
        (0..self.triangles.len()).map(corners).map(|[a, b, c]| dot(a, cross(b, c)) / 6.0).sum()
    }

    /// Centre of the enclosed volume [m].
    pub fn centroid(&self) -> Vec3 {
        let reference = self.vertices.first().copied().unwrap_or_default();
        let mut sum = [0.0; 3];
        for t in 0..self.triangles.len() {
            let [a, b, c] = self.corners(t).map(|p| sub(p, reference));
            sum = add(sum, scale(add(add(a, b), c), dot(a, cross(b, c)) / 24.0));
        }
        add(reference, scale(sum, 1.0 / self.volume()))
    }

    /// Edges of the box around it [m].
    pub fn extent(&self) -> Vec3 {
        let [low, high] = bounds(self.vertices.iter().copied());
        sub(high, low)
    }

    /// Moved so that its volume's centre is the origin, and scaled about it by a factor [-].
    pub fn centred(mut self, factor: f64) -> Self {
        let centre = self.centroid();
        self.vertices.iter_mut().for_each(|p| *p = scale(sub(*p, centre), factor));
        self
    }
}
