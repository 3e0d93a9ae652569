//! A bounding volume hierarchy over the triangles of a surface.
//!
//! Visits happen in a fixed order, and the first of several triangles at the same distance wins. Nodes and normals of a
//! mesh depend on that choice to the last bit, so the tree of a geometry crate (parry3d-f64) cannot replace this one.

use glam::DVec3;

use super::Surface;
use crate::mesh::bounds::bounds;

/// Most triangles in a leaf [-] (chosen: smaller leaves cost more box tests than they save triangle tests).
const LEAF: usize = 4;

/// An axis-aligned box with its content.
#[derive(Clone, Debug)]
struct Node {
    low: DVec3,
    high: DVec3,
    /// For a leaf, the index of its first triangle in `order`; for a branch, the second child. The first child of a branch
    /// is the next node.
    first: u32,
    /// Number of triangles of a leaf; 0 for a branch.
    count: u32,
}

/// The bounding volume hierarchy, nodes in depth-first order [m].
#[derive(Clone, Debug)]
pub struct TriangleTree {
    nodes: Vec<Node>,
    order: Vec<u32>,
}

impl TriangleTree {
    /// Returns the hierarchy of a surface, split at the median along the longest axis.
    pub fn new(surface: &Surface) -> Self {
        let boxes: Vec<[DVec3; 2]> = (0..surface.triangles.len()).map(|t| bounds(surface.corners(t))).collect();
        let mut tree = Self { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        tree.split(&boxes, 0, boxes.len());
        tree
    }

    /// Adds the node of the triangles `from..to` of the order, with all its children.
    fn split(&mut self, boxes: &[[DVec3; 2]], from: usize, to: usize) {
        let inside = self.order[from..to].iter().flat_map(|&t| boxes[t as usize]);
        let [low, high] = bounds(inside);
        let here = self.nodes.len();
        self.nodes.push(Node { low, high, first: from as u32, count: (to - from) as u32 });
        if to - from <= LEAF {
            return;
        }
        let axis = (0..3).max_by(|&a, &b| (high[a] - low[a]).total_cmp(&(high[b] - low[b]))).unwrap_or(0);
        let middle = (from + to) / 2;
        let centre = |t: &u32| boxes[*t as usize][0][axis] + boxes[*t as usize][1][axis];
        self.order[from..to]
            .select_nth_unstable_by(middle - from, |a, b| centre(a).total_cmp(&centre(b)).then(a.cmp(b)));
        self.split(boxes, from, middle);
        self.nodes[here].first = self.nodes.len() as u32;
        self.nodes[here].count = 0;
        self.split(boxes, middle, to);
    }

    /// Visits the triangles of all leaves that overlap a box [m].
    pub fn overlapping(&self, low: DVec3, high: DVec3, mut visit: impl FnMut(u32)) {
        let mut stack = vec![0usize];
        while let Some(at) = stack.pop() {
            let node = &self.nodes[at];
            if (0..3).any(|k| node.low[k] > high[k] || node.high[k] < low[k]) {
                continue;
            }
            if node.count == 0 {
                stack.extend([at + 1, node.first as usize]);
            } else {
                self.order[node.first as usize..(node.first + node.count) as usize].iter().for_each(|&t| visit(t));
            }
        }
    }

    /// Visits triangles near a point, nearer boxes first.
    ///
    /// `visit` returns the squared distance beyond which no more boxes are visited [m²].
    pub fn nearest(&self, p: DVec3, mut visit: impl FnMut(u32) -> f64) {
        let mut stack = vec![(0usize, self.gap(0, p))];
        let mut within = f64::INFINITY;
        while let Some((at, gap)) = stack.pop() {
            if gap > within {
                continue;
            }
            let node = &self.nodes[at];
            if node.count == 0 {
                let (a, b) = (at + 1, node.first as usize);
                let (ga, gb) = (self.gap(a, p), self.gap(b, p));
                stack.extend(if ga < gb { [(b, gb), (a, ga)] } else { [(a, ga), (b, gb)] });
            } else {
                for &t in &self.order[node.first as usize..(node.first + node.count) as usize] {
                    within = visit(t);
                }
            }
        }
    }

    /// Returns the squared distance of a point from a box [m²].
    fn gap(&self, node: usize, p: DVec3) -> f64 {
        let Node { low, high, .. } = &self.nodes[node];
        (0..3).map(|k| (low[k] - p[k]).max(p[k] - high[k]).max(0.0)).map(|d| d * d).sum()
    }
}
