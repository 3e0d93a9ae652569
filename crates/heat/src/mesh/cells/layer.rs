//! Nodes in layers below the surface and on a lattice inside.

use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::Sample;
use crate::mesh::surface::DepthFinder;
use crate::vector::{Vec3, along, bounds, dot};

/// Layers become thicker by this factor inwards [-] (chosen; convergence is tested).
const GROWTH: f64 = 1.4;
/// Distance of neighbours on the lattice over the spacing of the surface's samples [-] (chosen: a lattice cell then holds
/// about as much as a cell of the last layer).
const LATTICE: f64 = 0.55;
/// A copy must lie at least this share of its depth below every part of the surface [-] (chosen: less belongs to another
/// part).
const OWN_DEPTH: f64 = 0.85;
/// Copies of one layer that come nearer than this share of the spacing are thinned [-] (chosen).
const CROWDED: f64 = 0.5;
/// Cosine beyond which two samples are of one face, whose copies may be thinned [-] (chosen: 45°; thinning either column
/// beside a sharp edge would spoil their symmetry, by which cells end where faces do).
const ONE_FACE: f64 = 0.707;
/// Nodes of different layers stay apart by this share of the layers' distance [-] (chosen).
const LAYERS_APART: f64 = 0.6;
/// Lattice points stay away from other nodes by this share of the lattice's distance [-] (chosen).
const LATTICE_APART: f64 = 0.75;

/// A node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Place [m].
    pub position: Vec3,
    /// Depth below the surface [m].
    pub depth: f64,
    /// The sample of the surface that it lies below.
    pub sample: u32,
}

/// Depths of the layers below the first, which is the surface itself [m].
pub fn depths(first: f64, spacing: f64) -> Vec<f64> {
    let (mut gap, mut depth, mut depths) = (first, 0.0, Vec::new());
    while gap < LATTICE * spacing {
        depth += gap;
        depths.push(depth);
        gap *= GROWTH;
    }
    depths
}

/// Places nodes: the samples themselves first, in their order, then their copies inwards, then the lattice.
pub fn nodes(finder: &DepthFinder, samples: &[Sample], first: f64, spacing: f64) -> Vec<Node> {
    let bounds = bounds(finder.surface().vertices.iter().copied());
    let grid = PointGrid::over(bounds, 0.5 * spacing);
    let mut placed = Placed { samples, grid, nodes: Vec::new(), layers: Vec::new() };
    for (i, sample) in samples.iter().enumerate() {
        placed.push(Node { position: sample.position, depth: 0.0, sample: i as u32 }, 0);
    }
    let deepest = copies(finder, samples, first, spacing, &mut placed);
    lattice(finder, samples, &deepest, spacing, bounds, &mut placed);
    placed.nodes
}

/// What has been placed so far.
struct Placed<'a> {
    samples: &'a [Sample],
    grid: PointGrid,
    nodes: Vec<Node>,
    layers: Vec<u32>,
}

impl Placed<'_> {
    fn push(&mut self, node: Node, layer: u32) {
        self.grid.push(node.position);
        self.nodes.push(node);
        self.layers.push(layer);
    }

    /// Whether a copy of a sample would stand too near to what there is.
    fn crowded(&self, copy: &Node, layer: u32, gap: f64, spacing: f64) -> bool {
        let normal = |sample: u32| self.samples[sample as usize].normal;
        let same_layer = |i: u32| {
            let other = &self.nodes[i as usize];
            self.layers[i as usize] == layer && dot(normal(other.sample), normal(copy.sample)) > ONE_FACE
        };
        self.grid.any_within(copy.position, CROWDED * spacing, same_layer)
            || self.grid.any_within(copy.position, LAYERS_APART * gap, |_| true)
    }
}

/// Copies the samples inwards layer by layer; returns the depth that each reached [m].
fn copies(finder: &DepthFinder, samples: &[Sample], first: f64, spacing: f64, placed: &mut Placed) -> Vec<f64> {
    let mut deepest = vec![0.0; samples.len()];
    let mut open = vec![true; samples.len()];
    let mut before = 0.0;
    for (layer, depth) in (1u32..).zip(depths(first, spacing)) {
        for (i, sample) in samples.iter().enumerate() {
            let position = along(sample.position, sample.normal, -depth);
            let copy = Node { position, depth, sample: i as u32 };
            open[i] &= finder.depth(position).depth >= OWN_DEPTH * depth
                && !placed.crowded(&copy, layer, depth - before, spacing);
            if open[i] {
                placed.push(copy, layer);
                deepest[i] = depth;
            }
        }
        before = depth;
    }
    deepest
}

/// Fills what is left with a body-centred cubic lattice about the origin.
fn lattice(
    finder: &DepthFinder,
    samples: &[Sample],
    deepest: &[f64],
    spacing: f64,
    [low, high]: [Vec3; 2],
    placed: &mut Placed,
) {
    let positions: Vec<Vec3> = samples.iter().map(|s| s.position).collect();
    let surface = PointGrid::of(&positions, spacing);
    let apart = LATTICE * spacing;
    let edge = apart * 2.0 / libm::sqrt(3.0);
    let from = low.map(|v| libm::floor(v / edge) as i64);
    let to = high.map(|v| libm::ceil(v / edge) as i64);
    for (z, y, x) in triples(from, to) {
        for half in [0.0, 0.5] {
            let position = [x, y, z].map(|v| (v as f64 + half) * edge);
            let found = finder.depth(position);
            if found.depth < 0.5 * apart {
                continue;
            }
            let normal = finder.normal(found.triangle);
            let facing = |i: u32| dot(samples[i as usize].normal, normal) > 0.0;
            let sample = surface.nearest(found.nearest, spacing, facing).unwrap_or(0);
            let clear = found.depth > deepest[sample as usize] + 0.5 * apart
                && !placed.grid.any_within(position, LATTICE_APART * apart, |_| true);
            if clear {
                placed.push(Node { position, depth: found.depth, sample }, u32::MAX);
            }
        }
    }
}

fn triples(from: [i64; 3], to: [i64; 3]) -> impl Iterator<Item = (i64, i64, i64)> {
    (from[2]..=to[2]).flat_map(move |z| (from[1]..=to[1]).flat_map(move |y| (from[0]..=to[0]).map(move |x| (z, y, x))))
}
