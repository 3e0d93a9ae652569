//! Delaunay triangulations of cross-sections, with linear shape functions.

use spade::{DelaunayTriangulation, Point2, Triangulation};

use crate::mesh::outline::Outline;
use crate::mesh::outline_bands::OutlineBands;

/// The reason why a cross-section cannot be triangulated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The points are too few, collinear, or not finite.
    #[error("the cross-section has no area: {0}")]
    NoArea(String),
}

/// A triangulated plane region with its lumped areas [m²] and cotangent weights [-].
///
/// Linear shape functions with lumped mass. Source: Pinkall & Polthier 1993, Experimental Mathematics 2:15 (cotangent
/// weights).
#[derive(Clone, Debug)]
pub struct Section {
    /// Node positions [m].
    pub points: Vec<[f64; 2]>,
    /// Triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Lumped area of each node: a third of the area of its triangles [m²].
    pub areas: Vec<f64>,
    /// Edges `(a, b, weight)` with the cotangent weight ½ (cot α + cot β) ≥ 0; α and β are the opposite angles [-].
    pub edges: Vec<(u32, u32, f64)>,
    /// Boundary edges as pairs of nodes, counter-clockwise.
    pub boundary: Vec<[u32; 2]>,
    /// Number of edges with a negative cotangent weight, which is set to zero [-]; 0 for the outlines of this crate.
    pub clamped_edges: usize,
}

impl Section {
    /// Returns a mesh of an outline with nodes `spacing` apart inside and a ring at depth `rim` [m].
    ///
    /// The nodes of the ring are on the inward normals of the boundary nodes. No obtuse angle then faces the boundary, and
    /// all cotangent weights are non-negative.
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the nodes span no triangle.
    pub fn mesh(outline: &Outline, spacing: f64, rim: f64) -> Result<Self, MeshError> {
        let (boundary, bands) = (outline.sampled(0.75 * spacing), OutlineBands::new(outline));
        let mut points: Vec<[f64; 2]> = boundary.iter().map(|&(p, _)| p).collect();
        let inset = boundary.iter().map(|&(p, n)| [p[0] + rim * n[0], p[1] + rim * n[1]]);
        let apart = 0.45 * spacing;
        for p in inset {
            if bands.is_farther(p, 0.95 * rim) {
                push_apart(&mut points, p, 0.6 * rim.min(apart));
            }
        }
        let lattice = hexagonal_lattice(outline.reach(), spacing);
        points.extend(lattice.filter(|&p| bands.contains(p) && bands.is_farther(p, rim + 0.7 * spacing)));
        Self::triangulate(points, |p| bands.contains(p))
    }

    /// Estimated number of nodes of [`Self::mesh`], without meshing [-].
    pub fn estimated_nodes(outline: &Outline, spacing: f64, rim: f64) -> f64 {
        let perimeter = outline.perimeter();
        let inside = (outline.area() - perimeter * (rim + 0.7 * spacing)).max(0.0);
        let lattice = inside / (0.5 * libm::sqrt(3.0) * spacing * spacing);
        2.0 * perimeter / (0.75 * spacing) + lattice
    }

    /// Returns a disc of concentric rings at the given `radii`, with nodes about `arc` apart on each ring [m].
    ///
    /// `radii` ascend; a radius of 0 is one central node.
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the nodes span no triangle.
    pub fn rings(radii: &[f64], arc: f64) -> Result<Self, MeshError> {
        let mut points = Vec::new();
        for (ring, &radius) in radii.iter().enumerate() {
            let count =
                (libm::round(core::f64::consts::TAU * radius / arc) as usize).max(if radius > 0.0 { 6 } else { 1 });
            for i in 0..count {
                let angle = core::f64::consts::TAU * (i as f64 + 0.5 * (ring % 2) as f64) / count as f64;
                points.push([radius * libm::cos(angle), radius * libm::sin(angle)]);
            }
        }
        Self::triangulate(points, |_| true)
    }

    /// Returns a mesh of rings similar to an outline, each given as `(node count, scale factor [-])`.
    ///
    /// The first ring is the outline itself, with scale factor 1.
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the nodes span no triangle.
    pub fn concentric(outline: &Outline, rings: &[(usize, f64)]) -> Result<Self, MeshError> {
        let ring = |&(count, share): &(usize, f64)| {
            outline.evenly(count).into_iter().map(move |(p, _)| [share * p[0], share * p[1]])
        };
        let mut points: Vec<[f64; 2]> = rings.iter().take(1).flat_map(ring).collect();
        // Where the outline is slightly concave, slivers between it and its convex hull do not belong to the section.
        let rim = OutlineBands::new(&Outline { points: points.clone() });
        // In the hollows of an outline inner rings reach beyond it.
        points.extend(rings.iter().skip(1).flat_map(ring).filter(|p| rim.contains(*p)));
        Self::triangulate(points, |p| rim.contains(p))
    }

    /// Returns the Delaunay triangulation of given nodes [m], with the triangles whose centroid `inside` accepts.
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if a node is not finite or no triangle is left.
    pub fn triangulate(points: Vec<[f64; 2]>, inside: impl Fn([f64; 2]) -> bool) -> Result<Self, MeshError> {
        let vertices = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
        let mesh: DelaunayTriangulation<Point2<f64>> =
            DelaunayTriangulation::bulk_load_stable(vertices).map_err(|e| MeshError::NoArea(e.to_string()))?;
        let mut triangles = Vec::new();
        for face in mesh.inner_faces() {
            let t = face.vertices().map(|v| v.fix().index() as u32);
            let [a, b, c] = t.map(|i| points[i as usize]);
            let centroid = [(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0];
            let sliver = twice_area(a, b, c) < 1e-6 * longest_side_squared(a, b, c);
            if !sliver && inside(centroid) {
                triangles.push(t);
            }
        }
        if triangles.is_empty() {
            return Err(MeshError::NoArea(format!("{} points span no triangle", points.len())));
        }
        triangles.sort_unstable();
        Ok(Self::with_triangles(points, triangles))
    }

    fn with_triangles(points: Vec<[f64; 2]>, triangles: Vec<[u32; 3]>) -> Self {
        let mut areas = vec![0.0; points.len()];
        let mut weights = std::collections::BTreeMap::<(u32, u32), (f64, Vec<[u32; 2]>)>::new();
        for &t in &triangles {
            let corner = t.map(|i| points[i as usize]);
            let doubled = twice_area(corner[0], corner[1], corner[2]);
            for k in 0..3 {
                let (a, b) = (t[(k + 1) % 3], t[(k + 2) % 3]);
                let entry = weights.entry((a.min(b), a.max(b))).or_default();
                entry.0 += 0.5 * dot(corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3]) / doubled;
                entry.1.push([a, b]);
                areas[t[k] as usize] += doubled / 6.0;
            }
        }
        let boundary = weights.values().filter(|w| w.1.len() == 1).map(|w| w.1[0]).collect();
        let clamped_edges = weights.values().filter(|w| w.0 < -1e-9).count();
        let edges = weights.iter().filter(|(_, w)| w.0 > 1e-12).map(|(&(a, b), w)| (a, b, w.0)).collect();
        Self { points, triangles, areas, edges, boundary, clamped_edges }
    }

    /// Returns each side of the triangulation once, with ascending nodes, including sides without weight.
    pub fn sides(&self) -> Vec<[u32; 2]> {
        let ends = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
        let sides = self.triangles.iter().flat_map(ends).map(|[a, b]| [a.min(b), a.max(b)]);
        sides.collect::<std::collections::BTreeSet<_>>().into_iter().collect()
    }

    /// Returns the nodes of the boundary in order, counter-clockwise.
    ///
    /// For a region with holes this is the loop through the first boundary edge.
    pub fn rim(&self) -> Vec<u32> {
        let next: std::collections::BTreeMap<u32, u32> = self.boundary.iter().map(|[a, b]| (*a, *b)).collect();
        let Some(&[first, _]) = self.boundary.first() else { return Vec::new() };
        let mut rim = vec![first];
        while let Some(&node) = rim.last().and_then(|last| next.get(last)) {
            if node == first || rim.len() > next.len() {
                break;
            }
            rim.push(node);
        }
        rim
    }

    /// Returns the lumped areas for nodes moved to other points, with the same triangles [m²].
    pub(crate) fn areas_at(&self, points: &[[f64; 2]]) -> Vec<f64> {
        let mut areas = vec![0.0; points.len()];
        for t in &self.triangles {
            let [a, b, c] = t.map(|i| points[i as usize]);
            t.iter().for_each(|&i| areas[i as usize] += twice_area(a, b, c) / 6.0);
        }
        areas
    }

    /// Returns the total area [m²].
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Returns the boundary length of each node, half of each adjacent boundary edge, 0 inside [m].
    pub fn boundary_lengths(&self) -> Vec<f64> {
        let mut lengths = vec![0.0; self.points.len()];
        for [a, b] in &self.boundary {
            let (p, q) = (self.points[*a as usize], self.points[*b as usize]);
            let half = 0.5 * libm::hypot(p[0] - q[0], p[1] - q[1]);
            lengths[*a as usize] += half;
            lengths[*b as usize] += half;
        }
        lengths
    }
}

/// Adds a point unless another is within a distance [m].
fn push_apart(points: &mut Vec<[f64; 2]>, p: [f64; 2], apart: f64) {
    if points.iter().all(|q| libm::hypot(p[0] - q[0], p[1] - q[1]) > apart) {
        points.push(p);
    }
}

/// Returns the points of a hexagonal lattice about the origin that reaches as far along both axes [m].
fn hexagonal_lattice(reach: f64, spacing: f64) -> impl Iterator<Item = [f64; 2]> {
    let row_height = spacing * libm::sqrt(3.0) / 2.0;
    let rows = libm::ceil(reach / row_height) as i32 + 1;
    let columns = libm::ceil(reach / spacing) as i32 + 1;
    (-rows..=rows).flat_map(move |row| {
        let offset = 0.5 * f64::from(row.rem_euclid(2));
        (-columns..=columns).map(move |column| [(f64::from(column) + offset) * spacing, f64::from(row) * row_height])
    })
}

/// Returns twice the signed area of a triangle [m²].
fn twice_area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

fn longest_side_squared(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    [(a, b), (b, c), (c, a)].iter().map(|(p, q)| dot(*p, *q, *q)).fold(0.0, f64::max)
}

/// Returns the scalar product of the two edges from `apex` [m²].
fn dot(apex: [f64; 2], p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - apex[0]) * (q[0] - apex[0]) + (p[1] - apex[1]) * (q[1] - apex[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mesh_covers_the_outline_and_every_cotangent_weight_is_positive() {
        for (outline, spacing) in [
            (Outline::superellipse(0.12, 0.08, 2.6, &[(3, 0.02, 1.0)]), 4.5e-3),
            (Outline::superellipse(0.03, 0.02, 2.2, &[]), 3e-3),
            (Outline::circle(0.1), 8e-3),
            (Outline::rectangle(0.04, 0.03), 2e-3),
        ] {
            let section = Section::mesh(&outline, spacing, 0.35 * spacing).expect("meshes");
            assert!((section.area() / outline.area() - 1.0).abs() < 0.01, "{} {}", section.area(), outline.area());
            assert_eq!(section.clamped_edges, 0);
            assert!(section.edges.iter().all(|e| e.2 > 0.0));
        }
    }

    #[test]
    fn linear_fields_carry_no_net_flux_inside() {
        let section = Section::mesh(&Outline::circle(0.05), 5e-3, 2e-3).expect("meshes");
        let mut net = vec![0.0; section.points.len()];
        for &(a, b, w) in &section.edges {
            let difference = section.points[a as usize][0] - section.points[b as usize][0];
            net[a as usize] += w * difference;
            net[b as usize] -= w * difference;
        }
        let rim: std::collections::BTreeSet<u32> = section.boundary.iter().flatten().copied().collect();
        for (i, value) in net.iter().enumerate().filter(|(i, _)| !rim.contains(&(*i as u32))) {
            assert!(value.abs() < 1e-12, "node {i}: {value}");
        }
    }

    #[test]
    fn a_line_of_points_is_refused() {
        let line = (0..5).map(|i| [f64::from(i), 0.0]).collect();
        assert!(matches!(Section::triangulate(line, |_| true), Err(MeshError::NoArea(_))));
    }
}
