//! Node placement: layers below the surface and a lattice inside.

use glam::DVec3;

use crate::mesh::bounds::bounds;
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::Sample;
use crate::mesh::surface::DepthFinder;

/// Ratio of the thicknesses of successive layers [-] (chosen; convergence is tested).
const GROWTH: f64 = 1.4;
/// Distance of neighbours on the lattice ÷ spacing on the surface [-] (chosen: lattice cells then have about the volume of
/// cells in the last layer).
const LATTICE: f64 = 0.55;
/// Least depth below any part of the surface ÷ depth below its own sample, for a node of a layer [-] (chosen: a smaller
/// value means that another part of the surface is nearer).
const OWN_DEPTH: f64 = 0.85;
/// Least distance of nodes of one layer ÷ spacing [-] (chosen).
const CROWDED: f64 = 0.5;
/// Cosine of the angle between normals below which two samples belong to one face and their columns may be thinned [-]
/// (chosen: 45°; columns on both sides of a sharp edge stay symmetric, so that cells end exactly at the edge).
const ONE_FACE: f64 = 0.707;
/// Least distance of nodes of different layers ÷ layer thickness [-] (chosen).
const LAYERS_APART: f64 = 0.6;
/// Least distance of a lattice node from other nodes ÷ lattice distance [-] (chosen).
const LATTICE_APART: f64 = 0.75;

/// A node of the mesh, with its position [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Position [m].
    pub position: DVec3,
    /// Depth below the surface [m].
    pub depth: f64,
    /// Index of the surface sample above it.
    pub sample: u32,
}

/// Returns the depths of the layers below the surface [m].
pub fn depths(first: f64, spacing: f64) -> Vec<f64> {
    let (mut gap, mut depth, mut depths) = (first, 0.0, Vec::new());
    while gap < LATTICE * spacing {
        depth += gap;
        depths.push(depth);
        gap *= GROWTH;
    }
    depths
}

/// Returns all nodes: the surface samples in their order, then the layers, then the lattice [m].
pub fn nodes(finder: &DepthFinder, samples: &[Sample], first: f64, spacing: f64) -> Vec<Node> {
    let bounds = bounds(finder.surface().points());
    let grid = PointGrid::over(bounds, 0.5 * spacing);
    let mut placed = Placed { samples, grid, nodes: Vec::new(), layers: Vec::new() };
    for (i, sample) in samples.iter().enumerate() {
        placed.push(Node { position: sample.position, depth: 0.0, sample: i as u32 }, 0);
    }
    let deepest = copies(finder, samples, first, spacing, &mut placed);
    lattice(finder, samples, &deepest, spacing, bounds, &mut placed);
    placed.nodes
}

/// The nodes placed so far, each with its layer.
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

    /// Returns true if a new node of a layer is too close to an existing one.
    fn crowded(&self, copy: &Node, layer: u32, gap: f64, spacing: f64) -> bool {
        let normal = |sample: u32| self.samples[sample as usize].normal;
        let same_layer = |i: u32| {
            let other = &self.nodes[i as usize];
            self.layers[i as usize] == layer && normal(other.sample).dot(normal(copy.sample)) > ONE_FACE
        };
        self.grid.any_within(copy.position, CROWDED * spacing, same_layer)
            || self.grid.any_within(copy.position, LAYERS_APART * gap, |_| true)
    }
}

/// Offsets the samples inwards, layer by layer; returns the deepest node of each column [m].
fn copies(finder: &DepthFinder, samples: &[Sample], first: f64, spacing: f64, placed: &mut Placed) -> Vec<f64> {
    let mut deepest = vec![0.0; samples.len()];
    let mut open = vec![true; samples.len()];
    let mut before = 0.0;
    for (layer, depth) in (1u32..).zip(depths(first, spacing)) {
        for (i, sample) in samples.iter().enumerate() {
            let position = sample.position + -depth * sample.normal;
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

/// Fills the remaining interior with a body-centred cubic lattice about the origin.
fn lattice(
    finder: &DepthFinder,
    samples: &[Sample],
    deepest: &[f64],
    spacing: f64,
    [low, high]: [DVec3; 2],
    placed: &mut Placed,
) {
    let positions: Vec<DVec3> = samples.iter().map(|s| s.position).collect();
    let surface = PointGrid::of(&positions, spacing);
    let apart = LATTICE * spacing;
    let edge = apart * 2.0 / libm::sqrt(3.0);
    let from = low.to_array().map(|v| libm::floor(v / edge) as i64);
    let to = high.to_array().map(|v| libm::ceil(v / edge) as i64);
    for (z, y, x) in triples(from, to) {
        for half in [0.0, 0.5] {
            let position = DVec3::from([x, y, z].map(|v| (v as f64 + half) * edge));
            let found = finder.depth(position);
            if found.depth < 0.5 * apart {
                continue;
            }
            let normal = finder.normal(found.triangle);
            let facing = |i: u32| samples[i as usize].normal.dot(normal) > 0.0;
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
