//! A knife's cut across the long axis of a piece: its halves part there, and each has a fresh face.
//!
//! The piece stays one mesh and one state. Edges that cross the plane lose their conductance, juice no longer passes, and
//! the nodes beside the plane get a patch each, which meets the air and from which juice runs off. What a node's patch
//! covers is the part of the plane that its lost edges stood for: shape × distance across the plane, which is what a
//! field that rises evenly across the plane would have sent through it; all of them add up to the plane's own area.

use saute_heat::{Cut as SectionCut, Path};

use crate::body::patch::{Face, Patch};
use crate::body::surface::{PatchPose, unit};
use crate::model::FoodModel;

/// Least distance of a cut from either end of the long axis [m] (chosen: a knife cuts no thinner slice off a hot piece).
const LEAST_SLICE: f64 = 3.0e-3;

/// Where a piece is cut through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Unit vector along the long axis in the body frame [-]; a curved body's is that of its path where it is cut, at rest.
    pub axis: [f64; 3],
    /// Distance of the cut from the middle along the long axis of the rest shape [m]; along the path of a curved body.
    pub at: f64,
}

/// Why a piece cannot be cut.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CutError {
    /// It is in halves.
    #[error("it is cut in halves already")]
    Halved,
    /// The plane misses it.
    #[error("the cut may lie up to {most} m from the middle")]
    Beside {
        /// Farthest from the middle [m].
        most: f64,
    },
}

/// What a cut changed.
#[derive(Clone, Debug)]
pub(crate) struct Halving {
    cut: Cut,
    /// The fresh faces' patches are the last ones, from here on.
    first_patch: usize,
    /// Which nodes lie beyond the cut.
    beyond: Vec<bool>,
    /// Nodes whose edge was cut, the one beyond second.
    parted: Vec<[u32; 2]>,
    /// The level before the cut, where levels follow each other along the long axis.
    level: Option<usize>,
}

impl FoodModel {
    /// Where the piece was cut in halves.
    pub fn halved_at(&self) -> Option<Cut> {
        self.halving.as_ref().map(|h| h.cut)
    }

    /// Whether a node of a halved piece lies in the half towards the positive end of the long axis.
    pub fn is_beyond_cut(&self, node: usize) -> bool {
        self.halving.as_ref().is_some_and(|h| h.beyond[node])
    }

    /// The patches of the fresh faces: the last ones; none of a whole piece.
    pub fn fresh_faces(&self) -> core::ops::Range<usize> {
        self.halving.as_ref().map_or(self.patches.len(), |h| h.first_patch)..self.patches.len()
    }

    /// The piece cut in halves at a distance from the middle of its long axis [m]; its state goes on as it is.
    pub fn halved(&self, at: f64) -> Result<Self, CutError> {
        if self.halving.is_some() {
            return Err(CutError::Halved);
        }
        let most = 0.5 * self.size[self.long_axis()] - LEAST_SLICE;
        if !(-most..=most).contains(&at) {
            return Err(CutError::Beside { most });
        }
        let beyond: Vec<bool> = (0..self.mesh.node_count()).map(|node| self.along(node) > at).collect();
        let edges: Vec<(usize, [u32; 2])> = self
            .mesh
            .graph
            .ends
            .iter()
            .enumerate()
            .filter(|(_, [a, b])| beyond[*a as usize] != beyond[*b as usize])
            .map(|(edge, &[a, b])| (edge, if beyond[b as usize] { [a, b] } else { [b, a] }))
            .collect();
        if edges.is_empty() {
            return Err(CutError::Beside { most });
        }
        let mut halves = self.clone();
        halves.part(at, beyond, &edges);
        Ok(halves)
    }

    fn part(&mut self, at: f64, beyond: Vec<bool>, edges: &[(usize, [u32; 2])]) {
        let areas = self.fresh_areas(at, edges);
        let level = matches!(self.mesh.path, Path::Stations(_)).then(|| self.level_before(at));
        let first_patch = self.patches.len();
        let face = if self.is_slice() { Face::Side } else { Face::Top };
        for (&node, &area) in &areas {
            self.patches.push(Patch { node, face, air: Face::Side as usize, area });
            match self.outlets.iter_mut().find(|outlet| outlet.0 == node) {
                Some(outlet) => outlet.1 += area,
                None => self.outlets.push((node, area)),
            }
        }
        edges.iter().for_each(|(edge, _)| self.mesh.graph.shape[*edge] = 0.0);
        let across = |step: &(u32, u32, f64)| beyond[step.0 as usize] != beyond[step.1 as usize];
        self.cell_readings.outwards.retain(|step| !across(step));
        let parted = edges.iter().map(|(_, pair)| *pair).collect();
        let mut axis = [0.0; 3];
        axis[self.long_axis()] = 1.0;
        self.halving = Some(Halving { cut: Cut { axis, at }, first_patch, beyond, parted, level });
        let poses = self.rest_poses();
        if let (Some(halving), Some(near)) = (&mut self.halving, poses.get(first_patch..)) {
            let towards = near.iter().zip(&self.patches[first_patch..]).find(|(_, p)| !halving.beyond[p.node as usize]);
            halving.cut.axis = towards.map_or(axis, |(pose, _)| pose.normal);
        }
        self.rest_normals = poses.into_iter().map(|p| p.normal).collect();
    }

    /// 0 where the piece is longest along x, 1 along y; a body on stations is as long as its path.
    fn long_axis(&self) -> usize {
        let on_path = matches!(self.mesh.path, Path::Stations(_));
        if on_path || self.size[0] >= self.size[1] { 0 } else { 1 }
    }

    /// Distance of a node of the rest shape from the middle along the long axis [m].
    fn along(&self, node: usize) -> f64 {
        if let Path::Stations(_) = self.mesh.path {
            return self.mesh.levels[node / self.mesh.nodes_per_level()] - 0.5 * self.mesh.thickness();
        }
        self.mesh.position(node)[self.long_axis()]
    }

    /// The last level of stations before a cut.
    fn level_before(&self, at: f64) -> usize {
        let z = at + 0.5 * self.mesh.thickness();
        self.mesh.levels.partition_point(|level| *level <= z).saturating_sub(1)
    }

    /// Area of the fresh face that belongs to each node beside the cut [m²].
    fn fresh_areas(&self, at: f64, edges: &[(usize, [u32; 2])]) -> std::collections::BTreeMap<u32, f64> {
        let mut areas = std::collections::BTreeMap::new();
        let mut sum = 0.0;
        for &(edge, [near, far]) in edges {
            // Borders of sheaths lower a conductance, not the area.
            let whole = self.mesh.graph.shape[edge] / self.sheath_share(edge);
            let area = whole * (self.along(far as usize) - self.along(near as usize));
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
        match &self.mesh.path {
            Path::Stations(stations) => {
                let (level, share) = self.mesh.bracket(at + 0.5 * self.mesh.thickness());
                let [a, b] = [level, level + 1].map(|l| stations[l].section.areas.iter().sum::<f64>());
                Some(a + share * (b - a))
            }
            Path::Cells(cells) => Some(cells.slice(self.long_axis(), at).ok()?.areas.iter().sum()),
            _ => {
                let cut: SectionCut = self.cut_across(at);
                let columns: Vec<f64> = (0..self.mesh.nodes_per_level())
                    .map(|i| self.mesh.thickness() * self.mesh.path.column(i))
                    .collect();
                Some(cut.lengths().iter().enumerate().map(|(i, length)| length * cut.sample(i, &columns)).sum())
            }
        }
    }

    /// Whether a cut keeps juice from passing between two neighbouring levels.
    pub(crate) fn parts_levels(&self, a: usize, b: usize) -> bool {
        self.halving.as_ref().is_some_and(|h| h.level == Some(a.min(b)))
    }

    /// Turns the poses of the fresh faces, one towards the other half's side of the plane each.
    pub(crate) fn pose_fresh_faces(&self, positions: &[[f64; 3]], poses: &mut [PatchPose]) {
        let Some(halving) = &self.halving else { return };
        let mut axis = halving.cut.axis;
        if let Path::Stations(_) = self.mesh.path {
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
