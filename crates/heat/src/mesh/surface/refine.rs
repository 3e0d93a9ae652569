//! Refinement of triangles by halving their long edges.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::mesh::surface::Surface;

/// Vertices of triangles, to which those in the middle of edges can be added.
pub trait Vertices {
    /// Returns the position of a vertex [m].
    fn position(&self, vertex: u32) -> DVec3;

    /// Adds the vertex half-way between two others; returns its index.
    fn add_middle(&mut self, a: u32, b: u32) -> u32;
}

impl Vertices for Surface {
    fn position(&self, vertex: u32) -> DVec3 {
        self.vertex(vertex)
    }

    fn add_middle(&mut self, a: u32, b: u32) -> u32 {
        self.vertices.push(((self.vertex(a) + self.vertex(b)) * 0.5).to_array());
        self.vertices.len() as u32 - 1
    }
}

/// Bisects every edge longer than `longest` [m]; returns true if there was one. Neighbours stay conforming.
pub fn halve_long_edges(vertices: &mut impl Vertices, triangles: &mut Vec<[u32; 3]>, longest: f64) -> bool {
    let mut middles = BTreeMap::<[u32; 2], u32>::new();
    let mut finer = Vec::with_capacity(triangles.len());
    for t in std::mem::take(triangles) {
        let mids = [0, 1, 2].map(|k| {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            let [p, q] = [a, b].map(|v| vertices.position(v));
            (p.distance(q) > longest)
                .then(|| *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| vertices.add_middle(a, b)))
        });
        split(vertices, t, mids, &mut finer);
    }
    *triangles = finer;
    !middles.is_empty()
}

/// Divides a triangle at the midpoints of its bisected edges into two, three or four.
fn split(vertices: &impl Vertices, t: [u32; 3], mids: [Option<u32>; 3], triangles: &mut Vec<[u32; 3]>) {
    if let [Some(p), Some(q), Some(r)] = mids {
        triangles.extend([[t[0], p, r], [p, t[1], q], [r, q, t[2]], [p, q, r]]);
        return;
    }
    let first = (0..3).find_map(|k| mids[k].filter(|_| mids[(k + 2) % 3].is_none()).map(|p| (k, p)));
    let Some((k, p)) = first else {
        triangles.push(t);
        return;
    };
    let [a, b, c] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
    let Some(q) = mids[(k + 1) % 3] else {
        triangles.extend([[a, p, c], [p, b, c]]);
        return;
    };
    triangles.push([p, b, q]);
    let d = |u: u32, v: u32| vertices.position(u).distance(vertices.position(v));
    // The shorter diagonal gives the better aspect ratio.
    if d(a, q) < d(p, c) {
        triangles.extend([[a, p, q], [a, q, c]]);
    } else {
        triangles.extend([[a, p, c], [p, q, c]]);
    }
}
