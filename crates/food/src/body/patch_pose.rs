//! Positions and outward normals of the patches, at rest and in the present shape.

use saute_heat::{BodyMesh, Layout};
use serde::{Deserialize, Serialize};

use crate::body::Waves;
use crate::body::patch::{Face, Patch};
use crate::body::rest_shape::RestShape;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Vertical component of the outward normal below which a patch belongs to the lower face [-] (chosen: 45°).
const BELOW: f64 = -0.7;

/// Position and outward normal of a patch in the body frame.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct PatchPose {
    /// Position [m].
    pub position: [f64; 3],
    /// Outward unit normal [-].
    pub normal: [f64; 3],
}

/// Poses of all patches, in buffers that are reused between calls.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct PatchGeometry {
    /// Pose of each patch, in the order of the patches.
    pub poses: Vec<PatchPose>,
    #[serde(skip)]
    positions: Vec<[f64; 3]>,
}

impl RestShape {
    /// Rest position of a node in the body frame, whose origin is that of [`FoodModel::positions`] [m].
    pub(crate) fn rest_position(&self, node: usize) -> [f64; 3] {
        let [x, y, z] = self.mesh.position(node);
        match self.mesh.layout() {
            Layout::Upright(mesh) => [x, y, z - 0.5 * mesh.thickness()],
            Layout::Along(..) | Layout::Cells(_) => [x, y, z],
        }
    }

    /// Rest poses of the patches in the body frame.
    pub(crate) fn rest_poses(&self) -> Vec<PatchPose> {
        let positions: Vec<_> = (0..self.mesh.node_count()).map(|node| self.rest_position(node)).collect();
        let mut poses = Vec::new();
        self.pose_patches(&positions, &mut poses);
        poses
    }

    /// Sets what the rest poses of the patches determine.
    pub(crate) fn place_patches(&mut self, poses: &[PatchPose]) {
        self.rest_normals = poses.iter().map(|p| p.normal).collect();
        let waved = |waves: &Waves| poses.iter().map(|p| waves.at([p.position[0], p.position[1]])).collect();
        self.waved = self.waves.as_ref().map(waved).unwrap_or_default();
        self.outwards = poses.iter().map(|p| self.outwards_at(p.position)).collect();
    }

    fn pose_patches(&self, positions: &[[f64; 3]], poses: &mut Vec<PatchPose>) {
        poses.clear();
        let at = |p: &Patch| PatchPose { position: positions[p.node as usize], normal: [0.0; 3] };
        poses.extend(self.patches.iter().map(at));
        match &self.mesh {
            BodyMesh::Swept(_) => self.pose_triangles(positions, poses),
            // A body that contracts alike in all directions keeps its normals.
            BodyMesh::Cells(cells) => {
                poses.iter_mut().zip(&cells.patches).for_each(|(pose, patch)| pose.normal = patch.normal);
            }
        }
        self.pose_fresh_faces(positions, poses);
    }

    /// Mean normals of the triangles around each patch.
    fn pose_triangles(&self, positions: &[[f64; 3]], poses: &mut [PatchPose]) {
        for (nodes, patches) in self.surface.triangles.iter().zip(&self.surface.patches) {
            let normal = twice_area(nodes.map(|node| positions[node as usize]));
            for &patch in patches {
                (0..3).for_each(|k| poses[patch as usize].normal[k] += normal[k]);
            }
        }
        for (pose, patch) in poses.iter_mut().zip(&self.patches) {
            pose.normal = unit(pose.normal).unwrap_or_else(|| plain_normal(patch.face, pose.position));
        }
    }
}

impl FoodModel {
    /// Rest position of a node in the body frame, whose origin is that of [`FoodModel::positions`] [m].
    pub fn rest_position(&self, node: usize) -> [f64; 3] {
        self.shape.rest_position(node)
    }

    /// Returns the pose of every patch in the present shape, in the body frame, without the dome
    /// (see [`FoodModel::dome_gap`]).
    pub fn patch_geometry(&self, state: &FoodState) -> Vec<PatchPose> {
        let mut geometry = PatchGeometry::default();
        self.patch_geometry_into(state, &mut geometry);
        geometry.poses
    }

    /// As [`Self::patch_geometry`], into reused buffers.
    pub fn patch_geometry_into(&self, state: &FoodState, geometry: &mut PatchGeometry) {
        self.flat_positions_into(state, &mut geometry.positions);
        self.shape.pose_patches(&geometry.positions, &mut geometry.poses);
    }

    /// Returns the indices of the patches of the lower face, in ascending order.
    ///
    /// `up` is the world's upward direction in the body frame. The lower face has n·up < −0.7; if no patch does, it is the
    /// patches with the smallest n·up. Fresh faces of a cut never belong to it.
    pub fn patches_below(&self, up: [f64; 3]) -> impl Iterator<Item = usize> + '_ {
        let height = move |i: usize| {
            let n = self.shape.rest_normals[i];
            n[0] * up[0] + n[1] * up[1] + n[2] * up[2]
        };
        let there = move |i: &usize| self.shape.patches[*i].area > 0.0;
        let skin = self.fresh_faces().start;
        let lowest = (0..skin).filter(there).map(height).fold(f64::INFINITY, f64::min);
        let bound = if lowest < BELOW { BELOW } else { lowest + 1e-9 };
        (0..skin).filter(there).filter(move |i| height(*i) < bound)
    }
}

/// Normal of a patch of a body whose section has no triangles [-].
fn plain_normal(face: Face, [x, y, _]: [f64; 3]) -> [f64; 3] {
    match face {
        Face::Bottom => [0.0, 0.0, -1.0],
        Face::Top => [0.0, 0.0, 1.0],
        Face::Side => unit([x, y, 0.0]).unwrap_or([1.0, 0.0, 0.0]),
    }
}

/// Normal of a triangle; its length is twice the area [m²].
fn twice_area([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

pub(crate) fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let length = libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    (length > 0.0).then(|| v.map(|x| x / length))
}
