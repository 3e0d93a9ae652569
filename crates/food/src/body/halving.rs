//! A cut across the long axis of a piece into two halves, each with a fresh face.
//!
//! The piece remains one mesh and one state. Edges that cross the plane lose their conductance, and no juice passes. Each
//! node next to the plane gets a patch that meets the air and from which juice runs off. The area of that patch is the sum
//! of shape × distance across the plane over the node's cut edges, which is exact for a linear field; the areas are scaled
//! to add up to the area of the plane.

use std::collections::BTreeMap;

use saute_heat::{Layout, SweptMesh};

use crate::body::patch::{Face, Patch};
use crate::body::patch_pose::{PatchPose, unit};
use crate::body::rest_shape::RestShape;
use crate::model::FoodModel;

/// Least distance of a cut from either end of the long axis [m] (chosen: the thinnest slice that a knife cuts off a hot
/// piece).
const LEAST_SLICE: f64 = 3.0e-3;

/// Place and direction of a cut through a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Unit vector along the long axis in the body frame [-]; in a curved body along the path at the cut, at rest.
    pub axis: [f64; 3],
    /// Distance of the cut from the middle along the long axis of the rest shape, or along the path of a curved body [m].
    pub at: f64,
}

/// Error of cutting a piece in halves.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CutError {
    /// The piece is already cut in halves.
    #[error("the piece is already cut in halves")]
    Halved,
    /// The plane of the cut misses the piece or is too close to its end.
    #[error("a cut may lie at most {most} m from the middle")]
    Beside {
        /// Largest distance from the middle [m].
        most: f64,
    },
}

/// An edge across the plane of a cut and its two ends, the one beyond second.
type Crossing = (usize, [u32; 2]);

/// The changes that a cut made to the rest shape.
#[derive(Clone, Debug)]
pub(crate) struct Halving {
    cut: Cut,
    /// Index of the first patch of the fresh faces, which come last.
    first_patch: usize,
    /// True for nodes on the positive side of the cut.
    beyond: Vec<bool>,
    /// Both ends of each cut edge, the one beyond the cut second.
    parted: Vec<[u32; 2]>,
    /// The last level before the cut, in a body along stations.
    level: Option<usize>,
}

impl FoodModel {
    /// Returns the cut of a halved piece, or none.
    pub fn halved_at(&self) -> Option<Cut> {
        self.shape.halving.as_ref().map(|h| h.cut)
    }

    /// Returns true if a node of a halved piece is in the half at the positive end of the long axis.
    pub fn is_beyond_cut(&self, node: usize) -> bool {
        self.shape.halving.as_ref().is_some_and(|h| h.beyond[node])
    }

    /// Indices of the patches of the fresh faces; empty for a whole piece.
    pub fn fresh_faces(&self) -> core::ops::Range<usize> {
        let all = self.shape.patches.len();
        self.shape.halving.as_ref().map_or(all, |h| h.first_patch)..all
    }

    /// Returns the piece cut in halves at a distance from the middle of its long axis [m]; its [`FoodState`] stays valid.
    ///
    /// # Errors
    /// If the piece is cut already, or if the cut misses it.
    ///
    /// [`FoodState`]: crate::FoodState
    pub fn halved(&self, at: f64) -> Result<Self, CutError> {
        let shape = &self.shape;
        if shape.halving.is_some() {
            return Err(CutError::Halved);
        }
        let most = 0.5 * shape.size[shape.long_axis()] - LEAST_SLICE;
        if !(-most..=most).contains(&at) {
            return Err(CutError::Beside { most });
        }
        let beyond: Vec<bool> = (0..shape.mesh.node_count()).map(|node| shape.along(node) > at).collect();
        let edges = crossing_edges(&shape.mesh.graph().ends, &beyond);
        if edges.is_empty() {
            return Err(CutError::Beside { most });
        }
        let mut halves = self.clone();
        halves.part(at, beyond, &edges);
        Ok(halves)
    }

    fn part(&mut self, at: f64, beyond: Vec<bool>, edges: &[Crossing]) {
        let areas = self.fresh_areas(at, edges);
        let shape = &mut self.shape;
        let level = match shape.mesh.layout() {
            Layout::Along(mesh, _) => Some(level_before(mesh, at)),
            Layout::Upright(_) | Layout::Cells(_) => None,
        };
        let first_patch = shape.patches.len();
        let face = if shape.is_slice() { Face::Side } else { Face::Top };
        for (&node, &area) in &areas {
            shape.patches.push(Patch { node, face, air: Face::Side as usize, area });
            self.water.open_outlet(node, area);
        }
        let conductances = &mut shape.mesh.graph_mut().shape;
        edges.iter().for_each(|(edge, _)| conductances[*edge] = 0.0);
        self.water.part(&beyond);
        let parted = edges.iter().map(|(_, pair)| *pair).collect();
        let mut axis = [0.0; 3];
        axis[shape.long_axis()] = 1.0;
        shape.halving = Some(Halving { cut: Cut { axis, at }, first_patch, beyond, parted, level });
        shape.pose_cut(axis, first_patch);
    }

    /// Area of the fresh face of each node next to the cut [m²].
    fn fresh_areas(&self, at: f64, edges: &[Crossing]) -> BTreeMap<u32, f64> {
        let mut areas = BTreeMap::new();
        let mut sum = 0.0;
        for &(edge, [near, far]) in edges {
            // Borders of sheaths lower the conductance of an edge, not its area.
            let shape = &self.shape;
            let whole = shape.mesh.graph().shape[edge] / self.tissue.sheath_share(&shape.mesh, edge);
            let area = whole * (shape.along(far as usize) - shape.along(near as usize));
            sum += area;
            [near, far].iter().for_each(|node| *areas.entry(*node).or_insert(0.0) += area);
        }
        let fit = self.plane_area(at).filter(|area| *area > 0.0 && sum > 0.0).map_or(1.0, |area| area / sum);
        areas.values_mut().for_each(|area| *area *= fit);
        areas.retain(|_, area| *area > 0.0);
        areas
    }

    /// Area of the plane of a cut [m²].
    fn plane_area(&self, at: f64) -> Option<f64> {
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) => {
                let cut = self.cut_across(at);
                let columns: Vec<f64> =
                    (0..mesh.nodes_per_level()).map(|i| mesh.thickness() * mesh.path.column(i)).collect();
                Some(cut.lengths().iter().enumerate().map(|(i, length)| length * cut.sample(i, &columns)).sum())
            }
            Layout::Along(mesh, stations) => {
                let (level, share) = mesh.bracket(at + 0.5 * mesh.thickness());
                let [a, b] = [level, level + 1].map(|l| stations[l].section.areas.iter().sum::<f64>());
                Some(a + share * (b - a))
            }
            Layout::Cells(cells) => Some(cells.slice(self.shape.long_axis(), at).ok()?.areas.iter().sum()),
        }
    }
}

impl RestShape {
    /// Index of the long axis: 0 for x, 1 for y; a body along stations is long along its path (0).
    fn long_axis(&self) -> usize {
        let on_path = matches!(self.mesh.layout(), Layout::Along(..));
        if on_path || self.size[0] >= self.size[1] { 0 } else { 1 }
    }

    /// Distance of a node of the rest shape from the middle along the long axis [m].
    pub(crate) fn along(&self, node: usize) -> f64 {
        match self.mesh.layout() {
            Layout::Along(mesh, _) => mesh.levels[node / mesh.nodes_per_level()] - 0.5 * mesh.thickness(),
            Layout::Upright(_) | Layout::Cells(_) => self.mesh.position(node)[self.long_axis()],
        }
    }

    /// Sets the axis of the cut to its normal on the near side, and the rest normals with the fresh faces.
    fn pose_cut(&mut self, axis: [f64; 3], first_patch: usize) {
        let poses = self.rest_poses();
        if let (Some(halving), Some(near)) = (&mut self.halving, poses.get(first_patch..)) {
            let towards = near.iter().zip(&self.patches[first_patch..]).find(|(_, p)| !halving.beyond[p.node as usize]);
            halving.cut.axis = towards.map_or(axis, |(pose, _)| pose.normal);
        }
        self.place_patches(&poses);
    }

    /// Returns true if a cut keeps juice from passing between two neighbouring levels.
    pub(crate) fn parts_levels(&self, a: usize, b: usize) -> bool {
        self.halving.as_ref().is_some_and(|h| h.level == Some(a.min(b)))
    }

    /// Sets the normals of the fresh faces: each points to the other half.
    pub(crate) fn pose_fresh_faces(&self, positions: &[[f64; 3]], poses: &mut [PatchPose]) {
        let Some(halving) = &self.halving else { return };
        let mut axis = halving.cut.axis;
        if let Layout::Along(..) = self.mesh.layout() {
            let mut way = [0.0; 3];
            for [near, far] in &halving.parted {
                (0..3).for_each(|k| way[k] += positions[*far as usize][k] - positions[*near as usize][k]);
            }
            axis = unit(way).unwrap_or(axis);
        }
        for (pose, patch) in poses.iter_mut().zip(&self.patches).skip(halving.first_patch) {
            pose.normal = if halving.beyond[patch.node as usize] { axis.map(|v| -v) } else { axis };
        }
    }
}

/// Edges that cross the plane of a cut, with the end beyond it second.
fn crossing_edges(ends: &[[u32; 2]], beyond: &[bool]) -> Vec<Crossing> {
    ends.iter()
        .enumerate()
        .filter(|(_, [a, b])| beyond[*a as usize] != beyond[*b as usize])
        .map(|(edge, &[a, b])| (edge, if beyond[b as usize] { [a, b] } else { [b, a] }))
        .collect()
}

/// The last level of stations before a cut.
fn level_before(mesh: &SweptMesh, at: f64) -> usize {
    let z = at + 0.5 * mesh.thickness();
    mesh.levels.partition_point(|level| *level <= z).saturating_sub(1)
}
