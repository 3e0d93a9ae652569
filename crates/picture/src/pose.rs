//! Poses of the pieces and the pan in the picture, and the camera that follows the pan.

use std::collections::BTreeMap;

use glam::{Mat4, Quat, Vec3};
use saute_kitchen::{Kitchen, Piece, Place, RestOn};
use saute_scene::camera::Camera;
use saute_scene::input::RACK_HEIGHT;
use saute_scene::mesh::props::CLOTH_PLACE;

use crate::waiting::waiting_places;

/// Pose of a rigid body: position and rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Origin of its body [m].
    pub position: Vec3,
    /// Rotation.
    pub rotation: Quat,
}

impl Pose {
    /// Pose of a piece in the kitchen, with the lift of a rack.
    fn of(piece: &Piece) -> Self {
        // The rigid bodies have no rack: in the picture it lifts what lies on it.
        let lift = if piece.place == Place::Rest(RestOn::Rack) { RACK_HEIGHT } else { 0.0 };
        let bent = 0.5 * piece.state.stretch.dome.abs() as f32;
        let raised = piece.pose.position.as_vec3() + Vec3::Z * (lift + bent);
        Self { position: raised, rotation: piece.pose.rotation.as_quat() }
    }

    /// The pose of a rigid body of the kitchen.
    pub fn of_body(pose: &saute_kitchen::dynamics::Pose) -> Self {
        Self { position: pose.position.as_vec3(), rotation: pose.rotation.as_quat() }
    }

    /// Maps the rest frame to the world.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_rotation_translation(self.rotation, self.position)
    }

    /// This pose carried along with a frame that goes from one pose to another.
    fn carried(&self, from: &Self, to: &Self) -> Self {
        let turn = to.rotation * from.rotation.inverse();
        Self {
            position: to.position + turn * (self.position - from.position),
            rotation: (turn * self.rotation).normalize(),
        }
    }
}

/// Poses of all pieces, in their order: those of the kitchen's rigid bodies; what waits lies on the board, and what is
/// in a pan on the cloth is there.
pub fn poses(kitchen: &Kitchen) -> Vec<Pose> {
    let waiting = waiting_places(kitchen);
    let (bodies, drawn) = (body_of_pan(kitchen), pan_pose(kitchen));
    let pose = |(index, piece): (usize, &Piece)| match piece.place {
        Place::Waiting => waiting.get(&index).copied().unwrap_or_default(),
        Place::Pan(_) if bodies != drawn => Pose::of(piece).carried(&bodies, &drawn),
        _ => Pose::of(piece),
    };
    kitchen.pieces().iter().enumerate().map(pose).collect()
}

/// Poses of things in the picture while an animation moves them; otherwise the kitchen's poses hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    /// Pieces, by id.
    pub pieces: BTreeMap<String, Pose>,
    /// The pan: the centre of its underside.
    pub pan: Option<Pose>,
    /// The point of the hob's plane that the eye has followed the pan to [m]; where the pan is unless given.
    pub followed: Option<Vec3>,
}

impl Places {
    /// Pose of a piece.
    pub fn piece(&self, kitchen: &Kitchen, piece: &Piece) -> Pose {
        let index = kitchen.pieces().iter().position(|p| p.id == piece.id);
        index.and_then(|i| self.all(kitchen).get(i).copied()).unwrap_or_default()
    }

    /// Poses of all pieces, in their order; what is in the pan is carried along with it.
    pub fn all(&self, kitchen: &Kitchen) -> Vec<Pose> {
        let (stands, drawn) = (pan_pose(kitchen), self.pan(kitchen));
        let pose = |(piece, pose): (&Piece, Pose)| match self.pieces.get(&piece.id) {
            Some(moving) => *moving,
            None if piece.in_pan() && stands != drawn => pose.carried(&stands, &drawn),
            None => pose,
        };
        kitchen.pieces().iter().zip(poses(kitchen)).map(pose).collect()
    }

    /// Pose of the pan.
    pub fn pan(&self, kitchen: &Kitchen) -> Pose {
        self.pan.unwrap_or_else(|| pan_pose(kitchen))
    }

    /// Point that the camera follows [m].
    pub fn followed(&self, kitchen: &Kitchen) -> Vec3 {
        self.followed.unwrap_or_else(|| self.pan(kitchen).position)
    }
}

/// Share of the pan's motion that the eye follows [-] (chosen: hob and pan stay in view), and of its lift.
const EYE_FOLLOWS: f32 = 0.62;
const EYE_RISES: f32 = 0.35;

/// Returns the camera moved along with the pan, within the room.
pub fn following(camera: &Camera, pan: Vec3) -> Camera {
    let share = Vec3::new(EYE_FOLLOWS, EYE_FOLLOWS, EYE_RISES);
    Camera { target: camera.target + pan.with_z(pan.z.max(0.0)) * share, ..camera.clone() }.in_room()
}

/// Pose of the pan in the picture: the centre of its underside.
pub fn pan_pose(kitchen: &Kitchen) -> Pose {
    if kitchen.cloth().is_some() {
        return Pose { position: CLOTH_PLACE, rotation: Quat::IDENTITY };
    }
    body_of_pan(kitchen)
}

fn body_of_pan(kitchen: &Kitchen) -> Pose {
    let floor = Pose::of_body(&kitchen.world().motion.pose);
    let thickness = kitchen.world().pan_shape().thickness as f32;
    Pose { position: floor.position - floor.rotation * Vec3::Z * thickness, ..floor }
}
