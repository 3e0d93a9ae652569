//! How deep a point lies below a surface.

use std::collections::BTreeMap;

use super::Surface;
use super::triangle_tree::TriangleTree;
use crate::vector::{Vec3, add, along, cross, dot, length, scale, sub, unit};

/// The surface nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depth {
    /// Distance below the surface, negative outside [m].
    pub depth: f64,
    /// The nearest point of the surface [m].
    pub nearest: Vec3,
    /// The triangle that holds it.
    pub triangle: u32,
}

/// Finds depths below a surface; sides are told by the angle-weighted normals of Bærentzen & Aanæs (2005), which are
/// right also where the nearest point is an edge or a corner.
#[derive(Clone, Debug)]
pub struct DepthFinder<'a> {
    surface: &'a Surface,
    tree: TriangleTree,
    faces: Vec<Vec3>,
    edges: BTreeMap<[u32; 2], Vec3>,
    corners: Vec<Vec3>,
}

impl<'a> DepthFinder<'a> {
    /// Prepares a surface.
    pub fn new(surface: &'a Surface) -> Self {
        let faces: Vec<Vec3> = (0..surface.triangles.len()).map(|t| surface.normal(t)).collect();
        let mut edges = BTreeMap::<[u32; 2], Vec3>::new();
        let mut corners = vec![[0.0; 3]; surface.vertices.len()];
        for (t, ids) in surface.triangles.iter().enumerate() {
            let p = surface.corners(t);
            for k in 0..3 {
                let (a, b) = (ids[k], ids[(k + 1) % 3]);
                let edge = edges.entry([a.min(b), a.max(b)]).or_default();
                *edge = add(*edge, faces[t]);
                let (u, v) = (unit(sub(p[(k + 1) % 3], p[k])), unit(sub(p[(k + 2) % 3], p[k])));
                let angle = libm::acos(dot(u, v).clamp(-1.0, 1.0));
                corners[a as usize] = along(corners[a as usize], faces[t], angle);
            }
        }
        Self { surface, tree: TriangleTree::new(surface), faces, edges, corners }
    }

    /// The surface.
    pub fn surface(&self) -> &Surface {
        self.surface
    }

    /// Outward normal of a triangle.
    pub fn normal(&self, triangle: u32) -> Vec3 {
        self.faces[triangle as usize]
    }

    /// How deep a point lies.
    pub fn depth(&self, p: Vec3) -> Depth {
        let (mut best, mut found, mut weights, mut nearest) = (f64::INFINITY, 0, [0.0; 3], p);
        self.tree.nearest(p, |t| {
            let corners = self.surface.corners(t as usize);
            let w = closest(corners, p);
            let at = mix(corners, w);
            let away = sub(p, at);
            if dot(away, away) < best {
                (best, found, weights, nearest) = (dot(away, away), t, w, at);
            }
            best
        });
        let normal = self.pseudonormal(found, weights);
        let outside = dot(sub(p, nearest), normal) > 0.0;
        let distance = libm::sqrt(best);
        Depth { depth: if outside { -distance } else { distance }, nearest, triangle: found }
    }

    fn pseudonormal(&self, triangle: u32, weights: Vec3) -> Vec3 {
        let ids = self.surface.triangles[triangle as usize];
        let on: Vec<u32> = (0..3).filter(|&k| weights[k] > 0.0).map(|k| ids[k]).collect();
        match on[..] {
            [a] => self.corners[a as usize],
            [a, b] => self.edges[&[a.min(b), a.max(b)]],
            _ => self.faces[triangle as usize],
        }
    }
}

fn mix([a, b, c]: [Vec3; 3], w: Vec3) -> Vec3 {
    add(add(scale(a, w[0]), scale(b, w[1])), scale(c, w[2]))
}

/// Weights of a triangle's corners at its point nearest to `p`; exactly 0 off the feature that holds it (Ericson, Real-Time
/// Collision Detection, 2005, 5.1.5).
fn closest([a, b, c]: [Vec3; 3], p: Vec3) -> Vec3 {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(p, a));
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let bp = sub(p, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return [1.0 - v, v, 0.0];
    }
    let cp = sub(p, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
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
    let area = length(cross(ab, ac));
    if area == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let (v, w) = (vb / (va + vb + vc), vc / (va + vb + vc));
    [1.0 - v - w, v, w]
}
