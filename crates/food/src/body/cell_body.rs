//! Bodies of cells inside a closed surface: mesh, shrinkage and readings.

use saute_heat::mesh::cells::Weights;
use saute_heat::vector::{Vec3, cross, scale, sub};
use saute_heat::{BodyMesh, CellMesh, Fineness, Outline, Surface};

use crate::body::Body;
use crate::body::patch::{Face, Patch};
use crate::body::solid::Solid;
use crate::change::doneness::{MOST_CLASSES, Scale, Shares};
use crate::description::FoodDescription;
use crate::model::{BuildError, FoodModel, PieceSpec};
use crate::state::FoodState;
use crate::water::juice::Runoff;

/// Cosine between a patch's normal and the vertical beyond which it is a big face of the rest shape [-] (chosen: 45°).
const BIG_FACE: f64 = 0.7;

impl Body {
    /// Meshes the inside of a food's own surface, whose longest edge becomes the piece's length.
    pub(crate) fn inside_surface(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let surface = scaled(description, piece)?;
        let fineness = Fineness::of(&surface, piece.coarseness);
        let (size, outline) = (surface.extent(), silhouette(&surface.vertices));
        let cells = CellMesh::new(surface, fineness)?;
        let patches = cells.patches.iter().map(|p| {
            let air = match p.normal[2] {
                z if z > BIG_FACE => Face::Top,
                z if z < -BIG_FACE => Face::Bottom,
                _ => Face::Side,
            };
            // The skin contracts by the lateral stretch alone, as the big faces of a slice do.
            let face = if p.normal[2] > 0.0 { Face::Top } else { Face::Bottom };
            Patch { node: p.node, face, air: air as usize, area: p.area }
        });
        let patches = patches.collect();
        Ok(Self { size, mesh: BodyMesh::from(cells), outline, patches, contracts: true, natural: false })
    }
}

/// The food's own surface, whose longest edge is the piece's length [m].
fn scaled(description: &FoodDescription, piece: &PieceSpec) -> Result<Surface, BuildError> {
    let missing = BuildError::Missing { form: "mesh", table: "mesh" };
    let surface = description.body.as_deref().ok_or(missing)?.clone();
    let longest = surface.extent().into_iter().fold(0.0, f64::max);
    Ok(surface.centred(piece.size[0] / longest))
}

/// Estimated number of nodes of a body of cells, before it is meshed [-].
pub(super) fn nodes(description: &FoodDescription, piece: &PieceSpec) -> Result<f64, BuildError> {
    let surface = scaled(description, piece)?;
    Ok(Fineness::of(&surface, piece.coarseness).estimated_nodes(&surface))
}

/// Convex hull of points seen from above, counter-clockwise.
fn silhouette(points: &[Vec3]) -> Outline {
    let mut flat: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
    flat.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        cross(sub([b[0], b[1], 0.0], [a[0], a[1], 0.0]), sub([c[0], c[1], 0.0], [a[0], a[1], 0.0]))[2]
    };
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for p in points {
            while chain.len() > 1 && turn(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0.0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut flat.iter().copied());
    hull.extend(half(&mut flat.iter().rev().copied()));
    Outline { points: hull }
}

/// Weights at the core of a body of cells: at its centroid, or at its deepest node if the centroid lies outside [-].
pub(crate) fn cell_core(cells: &CellMesh) -> Weights {
    let deepest = (0..cells.node_count()).max_by(|a, b| cells.depth[*a].total_cmp(&cells.depth[*b]));
    let centre = [0.0; 3];
    if cells.contains(centre) { cells.weights(centre) } else { vec![(deepest.unwrap_or(0) as u32, 1.0)] }
}

/// Area of each node in the cut across the longest axis through the middle [m²].
pub(crate) fn middle_cut(cells: &CellMesh) -> Vec<(u32, f64)> {
    let extent = cells.surface.extent();
    let axis = if extent[0] >= extent[1] { 0 } else { 1 };
    let Ok(slice) = cells.slice(axis, 0.0) else { return Vec::new() };
    let mut areas = vec![0.0; cells.node_count()];
    for (weights, area) in slice.weights.iter().zip(&slice.areas) {
        weights.iter().for_each(|(node, w)| areas[*node as usize] += w * area);
    }
    (0u32..).zip(areas).filter(|(_, area)| *area > 0.0).collect()
}

impl FoodModel {
    /// Moves free juice outwards. Outer nodes come first, so that no juice moves by two nodes in one step.
    pub(crate) fn drain_cells(&self, state: &mut FoodState, reach: f64, runoff: &mut Runoff) {
        for &(from, to, distance) in &self.water.outwards {
            let share = 1.0 - 1.0 / (1.0 + reach / distance);
            let (nodes, mass) = ([from as usize, to as usize], share * state.juice[from as usize]);
            if mass > 0.0 {
                self.flow(state, nodes, mass, false, runoff);
            }
        }
    }

    /// Contracts the body isotropically to the sum of its nodes' volumes. Where a node has lost more or less than the mean,
    /// its breadth follows the flesh around it and its axial stretch takes up the difference.
    pub(crate) fn shrink_evenly(&self, state: &mut FoodState, relative_volume: impl Fn(&FoodState, usize) -> f64) {
        let volume = self.shape.mesh.volumes();
        let mut left = 0.0;
        for (node, rest) in volume.iter().enumerate() {
            state.stretch.axial[node] = relative_volume(state, node);
            left += rest * state.stretch.axial[node];
        }
        let lateral = libm::cbrt(left / volume.iter().sum::<f64>());
        state.stretch.lateral = lateral;
        state.stretch.axial.iter_mut().for_each(|a| *a /= lateral * lateral);
    }

    /// Present positions: rest positions scaled about the centre [m].
    pub(crate) fn cell_positions(&self, cells: &CellMesh, state: &FoodState, positions: &mut [[f64; 3]]) {
        positions.iter_mut().zip(&cells.positions).for_each(|(p, rest)| *p = scale(*rest, state.stretch.lateral));
    }

    /// Shares of doneness by volume [%], of a field that the scale measures.
    pub(crate) fn cell_volume_shares(&self, field: &[f64], scale: &Scale) -> Shares {
        let mut sums = [0.0; MOST_CLASSES];
        for (value, volume) in field.iter().zip(self.shape.mesh.volumes()) {
            scale.add_stretch(&mut sums, *value, *value, *volume);
        }
        Shares::from_weights(sums)
    }

    /// Shares of doneness of the middle cut by area [%], of a field that the scale measures.
    pub(crate) fn cell_cut_shares(&self, field: &[f64], scale: &Scale) -> Shares {
        let mut sums = [0.0; MOST_CLASSES];
        for &(node, area) in &self.shape.middle_cut {
            let value = field[node as usize];
            scale.add_stretch(&mut sums, value, value, area);
        }
        Shares::from_weights(sums)
    }

    /// The surface in its present shape.
    pub(crate) fn cell_solid(&self, cells: &CellMesh, state: &FoodState) -> Solid {
        let present = |p: &Vec3| scale(*p, state.stretch.lateral);
        Solid::Surface {
            points: cells.surface.vertices.iter().map(present).collect(),
            triangles: cells.surface.triangles.clone(),
        }
    }
}
