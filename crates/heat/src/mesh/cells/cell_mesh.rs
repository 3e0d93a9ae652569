//! Cells inside a closed surface.

use crate::conduction::graph::Graph;
use crate::mesh::cells::cell::{Cell, Wall};
use crate::mesh::cells::layer::{Node, nodes};
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::{Sample, convex, samples};
use crate::mesh::cells::skin::Skin;
use crate::mesh::surface::{DepthFinder, Surface};
use crate::vector::{Vec3, add, dot, length, scale, sub, unit};

/// How fine a mesh is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// Distance of the samples of the surface [m].
    pub spacing: f64,
    /// Distance of the first layer from the surface [m].
    pub first: f64,
}

/// Spacing of a large body [m] (chosen: the gradient length √(αt) is 9 mm after 10 minutes).
const SPACING: f64 = 4.0e-3;
/// First layer below the surface [m] (chosen: a crust is 0.5–1.5 mm thick).
const FIRST_LAYER: f64 = 0.35e-3;
/// Spacing over the diameter of a ball with the same volume per area [-] (chosen: 21 nodes around a cross-section).
const SPACING_SHARE: f64 = 0.15;
/// Nodes that a mesh has at most, about (chosen: a cook of an hour then takes less than a minute).
const MOST_NODES: f64 = 12_000.0;

impl Fineness {
    /// What suits a body, made coarser by a factor [-].
    pub fn of(surface: &Surface, coarseness: f64) -> Self {
        let (area, volume) = (surface.area(), surface.volume());
        let mut spacing = SPACING.min(SPACING_SHARE * 6.0 * volume / area) * coarseness;
        let first = FIRST_LAYER * coarseness;
        // About seven layers under an area of the spacing's square each, and a lattice cell of 0.13 spacings cubed.
        let count = |s: f64| 7.0 * area / (s * s) + volume / (0.13 * s * s * s);
        while count(spacing) > MOST_NODES {
            spacing *= 1.05;
        }
        Self { spacing, first }
    }
}

/// The part of the surface that belongs to one node and faces one way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellPatch {
    /// The node.
    pub node: u32,
    /// Area [m²].
    pub area: f64,
    /// Outward unit normal.
    pub normal: Vec3,
}

/// Why a body could not be meshed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CellMeshError {
    /// The cells do not fill the surface.
    #[error(
        "the cells inside the surface have {:.1} % of its volume and {:.1} % of its area; both must be 95 to 105 %",
        100.0 * .volume, 100.0 * .area
    )]
    Misfit {
        /// Their volume over the enclosed volume [-].
        volume: f64,
        /// Their outer area over the surface's [-].
        area: f64,
    },
}

/// A body of cells.
#[derive(Clone, Debug)]
pub struct CellMesh {
    /// The surface that was meshed.
    pub surface: Surface,
    /// Nodes; the first ones lie on the surface [m].
    pub positions: Vec<Vec3>,
    /// Depth of each node below the surface [m].
    pub depth: Vec<f64>,
    /// Volumes and edge shapes.
    pub graph: Graph,
    /// Faces to the outside.
    pub patches: Vec<CellPatch>,
    /// Triangles to be drawn.
    pub skin: Skin,
    /// How fine it is.
    pub fineness: Fineness,
    /// Volume and outer area of the cells before they were brought to the surface's, over these [-].
    pub fit: [f64; 2],
    pub(super) grid: PointGrid,
    pub(super) normals: Vec<Vec3>,
}

/// How much the cells may miss the surface's volume and area [-].
const MISFIT: f64 = 0.05;
/// Meshes that are tried, each finer than the one before.
const TRIALS: usize = 3;
/// Factor of the spacing from trial to trial [-] (chosen).
const FINER: f64 = 0.75;

impl CellMesh {
    /// Meshes the inside of a surface; goes finer where cells of the asked size do not fit it.
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

    /// Whether the edge between two nodes runs rather inwards (within 45°) than along the skin.
    #[inline]
    pub fn is_inward(&self, a: usize, b: usize) -> bool {
        let (rise, way) = (self.depth[a] - self.depth[b], sub(self.positions[a], self.positions[b]));
        2.0 * rise * rise > dot(way, way)
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.positions.len()
    }
}

/// Cells before they are brought to the surface's volume and area.
struct Cells {
    samples: Vec<Sample>,
    nodes: Vec<Node>,
    grid: PointGrid,
    volumes: Vec<f64>,
    /// Half of each face, from either side: its nodes and its area.
    halves: Vec<(u32, u32, f64)>,
    patches: Vec<CellPatch>,
}

impl Cells {
    fn fill(finder: &DepthFinder, fineness: Fineness) -> Self {
        let samples = samples(finder, fineness.spacing);
        let nodes = nodes(finder, &samples, fineness.first, fineness.spacing);
        let positions: Vec<Vec3> = nodes.iter().map(|n| n.position).collect();
        let grid = PointGrid::of(&positions, 0.5 * fineness.spacing);
        let mut cells = Self { samples, nodes, grid, volumes: Vec::new(), halves: Vec::new(), patches: Vec::new() };
        for node in 0..cells.nodes.len() as u32 {
            let cell = cells.cell(node, fineness.spacing);
            cells.add(node, &cell);
        }
        cells
    }

    /// What lies nearer to a node than to any other, and below the surface.
    fn cell(&self, node: u32, spacing: f64) -> Cell {
        let Node { position, sample, .. } = self.nodes[node as usize];
        let mut reach = 1.7 * spacing;
        let mut cell = loop {
            let mut cell = Cell::cube(2.0 * spacing);
            self.clip_skin(&mut cell, position, sample);
            self.grid.clip_bisectors(&mut cell, position, reach, Some(node));
            if 2.0 * cell.reach() <= reach || reach > 8.0 * spacing {
                break cell;
            }
            reach = 2.0 * cell.reach();
        };
        let beside: std::collections::BTreeSet<u32> = cell
            .facets
            .iter()
            .filter_map(|f| if let Wall::Node(n) = f.wall { Some(self.nodes[n as usize].sample) } else { None })
            .filter(|&s| s != sample && convex(&self.samples[sample as usize], &self.samples[s as usize]))
            .collect();
        beside.into_iter().for_each(|s| self.clip_skin(&mut cell, position, s));
        cell
    }

    /// Cuts off what lies outside the plane of a sample, unless the node itself does.
    fn clip_skin(&self, cell: &mut Cell, position: Vec3, sample: u32) {
        let plane = &self.samples[sample as usize];
        let offset = dot(sub(plane.position, position), plane.normal);
        if offset >= 0.0 {
            cell.clip(plane.normal, offset, Wall::Skin(sample));
        }
    }

    fn add(&mut self, node: u32, cell: &Cell) {
        self.volumes.push(cell.volume());
        let first = self.patches.len();
        for facet in &cell.facets {
            match facet.wall {
                Wall::Node(other) => self.halves.push((node.min(other), node.max(other), facet.area())),
                Wall::Skin(_) => {
                    // Heat enters where the surface's own nodes are.
                    let at = self.nodes[node as usize].sample;
                    add_patch(
                        &mut self.patches,
                        first,
                        CellPatch { node: at, area: facet.area(), normal: facet.normal },
                    );
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

    /// Brings volumes and areas to the surface's and joins the halves of the faces.
    fn finish(mut self, surface: &Surface, fineness: Fineness, fit: [f64; 2]) -> CellMesh {
        let mut graph = Graph { volume: self.volumes.iter().map(|v| v / fit[0]).collect(), ..Graph::default() };
        self.halves.sort_by_key(|h| (h.0, h.1));
        let least = 1e-6 * fineness.spacing * fineness.spacing;
        for face in self.halves.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (a, b, _) = face[0];
            let area = 0.5 * face.iter().map(|h| h.2).sum::<f64>();
            let distance = length(sub(self.nodes[a as usize].position, self.nodes[b as usize].position));
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
            positions: self.nodes.iter().map(|n| n.position).collect(),
            depth: self.nodes.iter().map(|n| n.depth).collect(),
            normals: self.nodes.iter().map(|n| self.samples[n.sample as usize].normal).collect(),
            graph,
            patches,
            fineness,
            fit,
            grid: self.grid,
        }
    }
}

/// Cosine beyond which patches of a node are one [-] (chosen: 40°, as at sharp edges).
const ONE_PATCH: f64 = 0.77;

/// Adds a patch to those from `first` on, to one that faces the same way if there is one.
fn add_patch(patches: &mut Vec<CellPatch>, first: usize, patch: CellPatch) {
    let first = first.min(patches.len());
    let same = patches[first..].iter_mut().find(|p| p.node == patch.node && dot(p.normal, patch.normal) > ONE_PATCH);
    match same {
        Some(p) => {
            p.normal = unit(add(scale(p.normal, p.area), scale(patch.normal, patch.area)));
            p.area += patch.area;
        }
        None => patches.push(patch),
    }
}

impl PointGrid {
    /// Cuts a cell around a place by the planes half-way to the points within a distance [m], nearest first.
    pub(super) fn clip_bisectors(&self, cell: &mut Cell, position: Vec3, reach: f64, but: Option<u32>) {
        let mut near = Vec::new();
        self.within(position, reach, |i, d| near.push((d, i)));
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut farthest = cell.reach();
        for (d, i) in near {
            if d > 2.0 * farthest {
                break;
            }
            if Some(i) != but && d > 0.0 {
                let normal = scale(sub(self.points[i as usize], position), 1.0 / d);
                cell.clip(normal, 0.5 * d, Wall::Node(i));
                farthest = cell.reach();
            }
        }
    }
}
