//! The mesh of Voronoi cells inside a closed surface.

use glam::DVec3;

use crate::conduction::graph::Graph;
use crate::mesh::cells::cell::{Cell, Wall};
use crate::mesh::cells::layer::{Node, nodes};
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::{Sample, samples};
use crate::mesh::cells::sites::Sites;
use crate::mesh::cells::skin::Skin;
use crate::mesh::surface::{DepthFinder, Surface};
/// The resolution of a cell mesh, as two lengths [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// Mean distance between neighbouring nodes on the surface [m].
    pub spacing: f64,
    /// Depth of the first layer of nodes below the surface [m].
    pub first: f64,
}

/// Node spacing on a large body [m] (chosen: the diffusion length √(αt) is 9 mm after 10 minutes).
const SPACING: f64 = 4.0e-3;
/// Depth of the first layer [m] (chosen: a crust is 0.5–1.5 mm thick).
const FIRST_LAYER: f64 = 0.35e-3;
/// Spacing ÷ diameter of the sphere with the same volume per area [-] (chosen: 21 nodes around a cross-section).
const SPACING_SHARE: f64 = 0.15;
/// Approximate maximum number of nodes [-] (chosen: a simulated hour then takes less than a minute).
const MOST_NODES: f64 = 12_000.0;

impl Fineness {
    /// Returns the resolution for a body, with both lengths multiplied by `coarseness` [-].
    ///
    /// The spacing is increased further until the estimated number of nodes is below 12 000.
    pub fn of(surface: &Surface, coarseness: f64) -> Self {
        let (area, volume) = (surface.area(), surface.volume());
        let mut spacing = SPACING.min(SPACING_SHARE * 6.0 * volume / area) * coarseness;
        let first = FIRST_LAYER * coarseness;
        while node_count(area, volume, spacing) > MOST_NODES {
            spacing *= 1.05;
        }
        Self { spacing, first }
    }

    /// Estimated number of nodes inside a surface [-].
    pub fn estimated_nodes(&self, surface: &Surface) -> f64 {
        node_count(surface.area(), surface.volume(), self.spacing)
    }
}

/// Estimated number of nodes of a spacing in a body with an area and a volume: about seven layers of nodes, each with an area of
/// spacing², and lattice cells of 0.13 spacing³ [-].
fn node_count(area: f64, volume: f64, s: f64) -> f64 {
    7.0 * area / (s * s) + volume / (0.13 * s * s * s)
}

/// The part of the surface that belongs to one node and has one orientation [m²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellPatch {
    /// The node.
    pub node: u32,
    /// Area [m²].
    pub area: f64,
    /// Outward unit normal [-].
    pub normal: [f64; 3],
}

/// The reason why a surface cannot be filled with cells.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CellMeshError {
    /// Volume or area of the cells differ by more than 5 % from those of the surface.
    #[error(
        "the cells inside the surface have {:.1} % of its volume and {:.1} % of its area; both must be 95 to 105 %",
        100.0 * .volume, 100.0 * .area
    )]
    Misfit {
        /// Volume of the cells ÷ enclosed volume [-].
        volume: f64,
        /// Outer area of the cells ÷ area of the surface [-].
        area: f64,
    },
}

/// A body of Voronoi cells inside a closed surface, with volumes [m³] and edge shapes [m] in its graph.
#[derive(Clone, Debug)]
pub struct CellMesh {
    /// The meshed surface.
    pub surface: Surface,
    /// Node positions; the nodes on the surface come first [m].
    pub positions: Vec<[f64; 3]>,
    /// Depth of each node below the surface, 0 for nodes on it [m].
    pub depth: Vec<f64>,
    /// Cell volumes, and face area ÷ distance of every pair of neighbours.
    pub graph: Graph,
    /// Outer faces.
    pub patches: Vec<CellPatch>,
    /// Triangles for drawing.
    pub skin: Skin,
    /// Resolution.
    pub fineness: Fineness,
    /// Volume and outer area of the cells ÷ those of the surface, before the correction that makes them equal [-].
    pub fit: [f64; 2],
    pub(super) grid: PointGrid,
    pub(super) normals: Vec<DVec3>,
    /// Index of the surface sample above each node, which is the node there.
    pub(super) samples: Vec<u32>,
}

/// Admissible relative error of the cells' volume and area before correction [-] (chosen).
const MISFIT: f64 = 0.05;
/// Number of resolutions that are tried [-] (chosen).
const TRIALS: usize = 3;
/// Factor of the spacing from trial to trial [-] (chosen).
const FINER: f64 = 0.75;

impl CellMesh {
    /// Returns the mesh of the body inside a surface with the given resolution [m].
    ///
    /// If the cells do not fit the surface to 5 %, the spacing is reduced to 75 % up to twice. Volumes and outer areas are
    /// then scaled so that their sums equal those of the surface.
    ///
    /// # Errors
    /// [`CellMeshError::Misfit`] if no resolution fits.
    pub fn new(surface: Surface, mut fineness: Fineness) -> Result<Self, CellMeshError> {
        let finder = DepthFinder::new(&surface);
        let mut left = TRIALS;
        loop {
            let cells = Cells::fill(&finder, fineness);
            let fit = [cells.volume() / surface.volume(), cells.area() / surface.area()];
            if fit.iter().all(|f| (f - 1.0).abs() <= MISFIT) {
                return Ok(cells.finish(&surface, fineness, fit));
            }
            left -= 1;
            if left == 0 {
                return Err(CellMeshError::Misfit { volume: fit[0], area: fit[1] });
            }
            fineness.spacing *= FINER;
        }
    }

    /// Returns true if the edge between two nodes runs within 45° of the direction of depth.
    #[inline]
    pub fn is_inward(&self, a: usize, b: usize) -> bool {
        let (rise, way) = (self.depth[a] - self.depth[b], self.node(a) - self.node(b));
        2.0 * rise * rise > way.dot(way)
    }

    /// Returns the position of a node [m].
    #[inline]
    pub(super) fn node(&self, node: usize) -> DVec3 {
        self.positions[node].into()
    }

    /// Returns the number of nodes.
    pub fn node_count(&self) -> usize {
        self.positions.len()
    }
}

/// The cells before their volumes and areas are corrected.
struct Cells {
    samples: Vec<Sample>,
    nodes: Vec<Node>,
    grid: PointGrid,
    volumes: Vec<f64>,
    /// Each face as seen from either cell: its nodes, ascending, and its area [m²].
    halves: Vec<(u32, u32, f64)>,
    patches: Vec<CellPatch>,
}

impl Cells {
    /// Returns the cells of all nodes inside a surface.
    fn fill(finder: &DepthFinder, fineness: Fineness) -> Self {
        let samples = samples(finder, fineness.spacing);
        let nodes = nodes(finder, &samples, fineness.first, fineness.spacing);
        let positions: Vec<DVec3> = nodes.iter().map(|n| n.position).collect();
        let grid = PointGrid::of(&positions, 0.5 * fineness.spacing);
        let mut cells = Self { samples, nodes, grid, volumes: Vec::new(), halves: Vec::new(), patches: Vec::new() };
        for node in 0..cells.nodes.len() as u32 {
            let cell = cells.cell(node, fineness.spacing);
            cells.add(node, &cell);
        }
        cells
    }

    /// Returns the Voronoi cell of a node, cut off at the planes of the surface samples near it.
    fn cell(&self, node: u32, spacing: f64) -> Cell {
        let site = |node: u32| {
            let Node { position, sample, .. } = self.nodes[node as usize];
            (position, sample)
        };
        Sites { grid: &self.grid, site, sample: |sample: u32| self.samples[sample as usize] }.cell(node, spacing)
    }

    /// Adds the volume, the faces and the patches of a cell.
    fn add(&mut self, node: u32, cell: &Cell) {
        self.volumes.push(cell.volume());
        let first = self.patches.len();
        for facet in &cell.facets {
            match facet.wall {
                Wall::Node(other) => self.halves.push((node.min(other), node.max(other), facet.area())),
                Wall::Skin(_) => {
                    // Heat enters at the nodes on the surface.
                    let at = self.nodes[node as usize].sample;
                    let patch = CellPatch { node: at, area: facet.area(), normal: facet.normal.to_array() };
                    add_patch(&mut self.patches, first, patch);
                }
                Wall::Box => {}
            }
        }
    }

    fn volume(&self) -> f64 {
        self.volumes.iter().sum()
    }

    fn area(&self) -> f64 {
        self.patches.iter().map(|p| p.area).sum()
    }

    /// Returns the mesh: volumes and areas scaled to those of the surface, faces averaged over both sides.
    fn finish(mut self, surface: &Surface, fineness: Fineness, fit: [f64; 2]) -> CellMesh {
        let mut graph = Graph { volume: self.volumes.iter().map(|v| v / fit[0]).collect(), ..Graph::default() };
        self.halves.sort_by_key(|h| (h.0, h.1));
        let least = 1e-6 * fineness.spacing * fineness.spacing;
        for face in self.halves.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (a, b, _) = face[0];
            let area = 0.5 * face.iter().map(|h| h.2).sum::<f64>();
            let distance = self.nodes[a as usize].position.distance(self.nodes[b as usize].position);
            if area > least {
                graph.push(a, b, area / distance);
            }
        }
        self.patches.sort_by_key(|p| p.node);
        let mut patches: Vec<CellPatch> = Vec::with_capacity(self.patches.len());
        let mut first = 0;
        for patch in self.patches {
            if patches.get(first).is_none_or(|p: &CellPatch| p.node != patch.node) {
                first = patches.len();
            }
            add_patch(&mut patches, first, CellPatch { area: patch.area / fit[1], ..patch });
        }
        CellMesh {
            skin: Skin::new(surface, &self.samples, fineness.spacing),
            surface: surface.clone(),
            positions: self.nodes.iter().map(|n| n.position.to_array()).collect(),
            depth: self.nodes.iter().map(|n| n.depth).collect(),
            normals: self.nodes.iter().map(|n| self.samples[n.sample as usize].normal).collect(),
            samples: self.nodes.iter().map(|n| n.sample).collect(),
            graph,
            patches,
            fineness,
            fit,
            grid: self.grid,
        }
    }
}

/// Cosine of the angle between normals below which two patches of a node are merged [-] (chosen: 40°, as at sharp edges).
const ONE_PATCH: f64 = 0.77;

/// Adds a patch to those from `first` on, or merges it with one of the same node and orientation.
fn add_patch(patches: &mut Vec<CellPatch>, first: usize, patch: CellPatch) {
    let first = first.min(patches.len());
    let normal = DVec3::from(patch.normal);
    let similar = |p: &&mut CellPatch| p.node == patch.node && DVec3::from(p.normal).dot(normal) > ONE_PATCH;
    match patches[first..].iter_mut().find(similar) {
        Some(p) => {
            let sum = DVec3::from(p.normal) * p.area + normal * patch.area;
            p.normal = sum.normalize_or_zero().to_array();
            p.area += patch.area;
        }
        None => patches.push(patch),
    }
}

impl PointGrid {
    /// Clips a cell around a position at the perpendicular bisectors to the points within a distance [m], nearest first.
    ///
    /// The point with index `but` is skipped.
    pub(super) fn clip_bisectors(&self, cell: &mut Cell, position: DVec3, reach: f64, but: Option<u32>) {
        let mut near = Vec::new();
        self.within(position, reach, |i, d| near.push((d, i)));
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut farthest = cell.reach();
        for (d, i) in near {
            if d > 2.0 * farthest {
                break;
            }
            if Some(i) != but && d > 0.0 {
                let normal = (self.points[i as usize] - position) * (1.0 / d);
                cell.clip(normal, 0.5 * d, Wall::Node(i));
                farthest = cell.reach();
            }
        }
    }
}
