//! Bodies of cells inside a closed surface: their meshes.

use saute_heat::mesh::cells::Weights;
use saute_heat::vector::{Vec3, cross, sub};
use saute_heat::{BodyMesh, CellMesh, Fineness, Outline, Surface};

use crate::body::Body;
use crate::body::patch::{Face, Patch};
use crate::build_error::BuildError;
use crate::description::FoodDescription;
use crate::piece_spec::PieceSpec;

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
        Ok(Self {
            size,
            mesh: BodyMesh::from(cells),
            outline,
            patches,
            contracts: true,
            natural: false,
            pool: None,
            waves: None,
        })
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
pub(crate) fn nodes(description: &FoodDescription, piece: &PieceSpec) -> Result<f64, BuildError> {
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

/// Weights at the core of a body of cells: at its centroid, or at its deepest node if the centroid is outside [-].
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
