//! Closed triangulated surfaces: welded from loose triangles, checked for defects, and queried for distances.

mod crossing;
mod defect;
mod distance;
mod feature;
pub mod refine;
mod triangle_tree;
mod unfold;
mod weld;

pub use defect::{Defect, Trouble};
pub(crate) use distance::DepthFinder;
pub(crate) use feature::features;

use glam::DVec3;

use crate::mesh::bounds::bounds;

/// Loose triangles as a file contains them, in the unit of the file; coincident corners need not be shared.
#[derive(Clone, Debug, PartialEq)]
pub struct Soup {
    /// Corners, in the unit of the file.
    pub vertices: Vec<[f64; 3]>,
    /// Triangles as indices of corners, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Length of the file's unit, unless the user gives another [mm].
    pub unit_mm: f64,
}

impl Default for Soup {
    fn default() -> Self {
        Self { vertices: Vec::new(), triangles: Vec::new(), unit_mm: 1.0 }
    }
}

/// A closed, oriented surface of one body without self-intersection, with vertices in [m].
///
/// [`Surface::close`] establishes these properties; normals point outwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Vertices [m].
    pub vertices: Vec<[f64; 3]>,
    /// Triangles as indices of vertices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// Smallest and largest edge of a body's bounding box [m].
///
/// Chosen: the surface layers do not fit into a thinner body; a longer one does not fit into a pan.
pub const EXTENT: [f64; 2] = [3e-3, 0.3];

/// Largest number of triangles of a surface [-] (chosen: a file of cooked foods has up to 430,000, two for each of the about
/// 200,000 vertices that it is made of; more detail is lost in the volume mesh).
pub const MOST_TRIANGLES: usize = 500_000;

impl Surface {
    /// Returns the closed surface of loose triangles whose unit has the given length [m].
    ///
    /// Vertices closer than 10⁻⁶ of the diagonal are merged. A body whose normals all point inwards is inverted. Small folds
    /// are smoothed, where that moves no vertex by more than 1 mm.
    ///
    /// # Errors
    /// A [`Defect`] with the number of occurrences and the first place, if the triangles do not form one closed, oriented
    /// two-manifold of admissible size without self-intersection.
    ///
    /// ```
    /// use saute_heat::{Soup, Surface};
    ///
    /// // A tetrahedron with legs of 10 mm.
    /// let vertices = vec![[0.0; 3], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0]];
    /// let triangles = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    /// let mut soup = Soup { vertices, triangles, unit_mm: 1.0 };
    /// let surface = Surface::close(&soup, 1e-3)?;
    /// assert!((surface.volume() - 1e-6 / 6.0).abs() < 1e-18, "{} m³", surface.volume());
    ///
    /// soup.triangles.pop();
    /// let defect = Surface::close(&soup, 1e-3).unwrap_err();
    /// assert!(defect.to_string().starts_with("not closed"));
    /// assert!(defect.remedy().contains("fill the holes"));
    /// # Ok::<(), saute_heat::Defect>(())
    /// ```
    pub fn close(soup: &Soup, metres: f64) -> Result<Self, Defect> {
        let mut surface = weld::weld(soup, metres)?;
        defect::closed(&surface)?;
        if surface.volume() < 0.0 {
            surface.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        defect::sized(&surface)?;
        unfold::unfold(&mut surface)?;
        Ok(surface)
    }

    /// Returns the position of a vertex [m].
    #[inline]
    pub(crate) fn vertex(&self, vertex: u32) -> DVec3 {
        self.vertices[vertex as usize].into()
    }

    /// Returns the positions of all vertices [m].
    pub(crate) fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.vertices.iter().map(|p| DVec3::from(*p))
    }

    /// Returns the corners of a triangle [m].
    #[inline]
    pub(crate) fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|i| self.vertex(i))
    }

    /// Returns the outward normal of a triangle with a length of twice its area [m²].
    #[inline]
    pub(crate) fn doubled_area(&self, triangle: usize) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(c - a)
    }

    /// Returns the outward unit normal of a triangle [-].
    pub(crate) fn normal(&self, triangle: usize) -> DVec3 {
        self.doubled_area(triangle).normalize_or_zero()
    }

    /// Returns the area [m²].
    pub fn area(&self) -> f64 {
        (0..self.triangles.len()).map(|t| 0.5 * self.doubled_area(t).length()).sum()
    }

    /// Returns the enclosed volume, negative if the normals point inwards [m³].
    ///
    /// V = Σ a · (b × c) / 6 over all triangles (divergence theorem).
    pub fn volume(&self) -> f64 {
        let reference = self.reference();
        let corners = |t: usize| self.corners(t).map(|p| p - reference);
        (0..self.triangles.len()).map(corners).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    /// Returns the centroid of the enclosed volume [m].
    pub fn centroid(&self) -> [f64; 3] {
        let reference = self.reference();
        let mut sum = DVec3::ZERO;
        for t in 0..self.triangles.len() {
            let [a, b, c] = self.corners(t).map(|p| p - reference);
            sum += (a + b + c) * (a.dot(b.cross(c)) / 24.0);
        }
        (reference + sum * (1.0 / self.volume())).to_array()
    }

    /// Returns a vertex near the body, from which volumes are summed with little cancellation [m].
    fn reference(&self) -> DVec3 {
        self.vertices.first().copied().unwrap_or_default().into()
    }

    /// Returns the edges of the axis-aligned bounding box [m].
    pub fn extent(&self) -> [f64; 3] {
        let [low, high] = bounds(self.points());
        (high - low).to_array()
    }

    /// Returns the surface with its centroid at the origin, scaled by a factor [-].
    pub fn centred(mut self, factor: f64) -> Self {
        let centre = DVec3::from(self.centroid());
        self.vertices.iter_mut().for_each(|p| *p = ((DVec3::from(*p) - centre) * factor).to_array());
        self
    }
}
