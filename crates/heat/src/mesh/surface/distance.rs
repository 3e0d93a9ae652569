//! Signed distance of a point from a closed surface.

use std::collections::BTreeMap;

use glam::DVec3;

use super::Surface;
use super::triangle_tree::TriangleTree;

/// The signed distance of a point from a surface [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depth {
    /// Distance below the surface, negative outside [m].
    pub depth: f64,
    /// Nearest point of the surface [m].
    pub nearest: DVec3,
    /// Triangle with the nearest point.
    pub triangle: u32,
}

/// Query structure for signed distances from a closed surface [m].
///
/// The sign follows from angle-weighted pseudonormals, which are correct also if the nearest point is on an edge or a
/// vertex. Source: Bærentzen & Aanæs 2005 `[@baerentzen-aanaes-2005]`, IEEE Trans. Vis. Comput. Graph. 11:243.
#[derive(Clone, Debug)]
pub struct DepthFinder<'a> {
    surface: &'a Surface,
    tree: TriangleTree,
    faces: Vec<DVec3>,
    edges: BTreeMap<[u32; 2], DVec3>,
    corners: Vec<DVec3>,
}

impl<'a> DepthFinder<'a> {
    /// Returns the query structure of a surface.
    pub fn new(surface: &'a Surface) -> Self {
        let faces: Vec<DVec3> = (0..surface.triangles.len()).map(|t| surface.normal(t)).collect();
        let mut edges = BTreeMap::<[u32; 2], DVec3>::new();
        let mut corners = vec![DVec3::ZERO; surface.vertices.len()];
        for (t, ids) in surface.triangles.iter().enumerate() {
            let p = surface.corners(t);
            for k in 0..3 {
                let (a, b) = (ids[k], ids[(k + 1) % 3]);
                *edges.entry([a.min(b), a.max(b)]).or_default() += faces[t];
                let [u, v] = [p[(k + 1) % 3], p[(k + 2) % 3]].map(|q| (q - p[k]).normalize_or_zero());
                let angle = libm::acos(u.dot(v).clamp(-1.0, 1.0));
                corners[a as usize] += angle * faces[t];
            }
        }
        Self { surface, tree: TriangleTree::new(surface), faces, edges, corners }
    }

    /// Returns the surface.
    pub fn surface(&self) -> &Surface {
        self.surface
    }

    /// Returns the outward unit normal of a triangle [-].
    pub fn normal(&self, triangle: u32) -> DVec3 {
        self.faces[triangle as usize]
    }

    /// Returns the signed distance of a point [m].
    pub fn depth(&self, p: DVec3) -> Depth {
        let (mut best, mut found, mut weights, mut nearest) = (f64::INFINITY, 0, [0.0; 3], p);
        self.tree.nearest(p, |t| {
            let corners = self.surface.corners(t as usize);
            let w = closest(corners, p);
            let at = mix(corners, w);
            let squared = p.distance_squared(at);
            if squared < best {
                (best, found, weights, nearest) = (squared, t, w, at);
            }
            best
        });
        let normal = self.pseudonormal(found, weights);
        let outside = (p - nearest).dot(normal) > 0.0;
        let distance = libm::sqrt(best);
        Depth { depth: if outside { -distance } else { distance }, nearest, triangle: found }
    }

    /// Returns the pseudonormal at a point of a triangle: that of the vertex, edge or face with non-zero weights.
    fn pseudonormal(&self, triangle: u32, weights: [f64; 3]) -> DVec3 {
        let ids = self.surface.triangles[triangle as usize];
        let on: Vec<u32> = (0..3).filter(|&k| weights[k] > 0.0).map(|k| ids[k]).collect();
        match on[..] {
            [a] => self.corners[a as usize],
            [a, b] => self.edges[&[a.min(b), a.max(b)]],
            _ => self.faces[triangle as usize],
        }
    }
}

fn mix([a, b, c]: [DVec3; 3], w: [f64; 3]) -> DVec3 {
    a * w[0] + b * w[1] + c * w[2]
}

/// Returns the barycentric coordinates of the point of a triangle nearest to `p` [-].
///
/// Coordinates are exactly 0 for the corners off the vertex or edge with that point, by which [`DepthFinder`] selects the
/// pseudonormal; the nearest-point functions of geometry crates return rounded ones. Source: Ericson, Real-Time
/// Collision Detection (2005) `[@ericson-2005]`, section 5.1.5.
fn closest([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return [1.0 - v, v, 0.0];
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return [1.0 - w, 0.0, w];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - w, w];
    }
    if ab.cross(ac).length() == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let (v, w) = (vb / (va + vb + vc), vc / (va + vb + vc));
    [1.0 - v - w, v, w]
}
