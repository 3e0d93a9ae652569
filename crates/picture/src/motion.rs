//! Animates jumps: food that is put into the pan, the pan on its way to the cloth. All
//! else moves as the kitchen's bodies move.

use std::collections::BTreeMap;

use crate::stage::{Places, Pose, pan_pose, poses};
use glam::Vec3;
use saute_kitchen::Kitchen;

/// Time of a move in the picture [s] (chosen).
const MOVE_S: f32 = 0.45;
/// How high a piece is lifted on its way [m] (chosen: over the rim).
const LIFT: f32 = 0.075;

/// How far a body may come between two pictures [m] (chosen: more than any hand moves it, less than from board to pan).
const JUMP: f32 = 0.1;

#[derive(Clone, Copy, Debug)]
struct Motion {
    from: Pose,
    to: Pose,
    progress: f32,
}

/// Pieces and pan on their way.
#[derive(Clone, Debug, Default)]
pub struct Motions {
    moving: BTreeMap<String, Motion>,
    pan: Option<Motion>,
    /// The point to which the eye has followed the pan, and true while it moves.
    followed: Option<(Vec3, bool)>,
    generation: u64,
    /// True if everything is at once where it goes.
    pub jumps: bool,
}

/// How far the pan moves before the eye follows, and how near the eye then comes [m] (chosen: a shake leaves it at
/// rest).
const EYE_SLACK: [f32; 2] = [0.06, 0.004];
/// Time constant with which the eye follows [s] (chosen: gently).
const EYE_S: f32 = 0.35;

impl Motions {
    /// Forgets everything.
    pub fn clear(&mut self) {
        self.moving.clear();
        (self.pan, self.followed) = (None, None);
    }

    /// Follows the kitchen through `wall` seconds; a new `generation` starts at rest.
    pub fn advance(&mut self, kitchen: &Kitchen, generation: u64, wall: f32) {
        // The end of every way.
        let wall = if self.jumps { f32::INFINITY } else { wall };
        if generation != self.generation {
            self.clear();
            self.generation = generation;
        }
        self.moving.retain(|id, _| kitchen.piece(id).is_some());
        for (piece, target) in kitchen.pieces().iter().zip(poses(kitchen)) {
            self.moving.entry(piece.id.clone()).or_insert(Motion::resting(target)).advance(target, wall);
        }
        let target = pan_pose(kitchen);
        self.pan.get_or_insert(Motion::resting(target)).advance(target, wall);
        self.follow(target.position, wall);
    }

    /// Lets the camera follow the pan once it has moved far.
    fn follow(&mut self, pan: Vec3, wall: f32) {
        let (at, chasing) = self.followed.unwrap_or((pan, false));
        let away = at.distance(pan);
        if away > EYE_SLACK[usize::from(chasing)] {
            self.followed = Some((at.lerp(pan, 1.0 - (-wall / EYE_S).exp()), true));
        } else {
            self.followed = Some((at, false));
        }
    }

    /// Starts a piece's next move from where a hand let it go.
    pub fn release(&mut self, id: &str, from: Pose) {
        if let Some(motion) = self.moving.get_mut(id) {
            *motion = Motion::resting(from);
        }
    }

    /// Returns true if an animation runs.
    pub fn moving(&self) -> bool {
        let eye = self.followed.is_some_and(|(_, chasing)| chasing);
        eye || self.moving.values().chain(&self.pan).any(|m| m.progress < 1.0)
    }

    /// Poses of the things that an animation moves.
    pub fn places(&self) -> Places {
        let moving = |m: &&Motion| m.progress < 1.0;
        Places {
            pieces: self.moving.iter().filter(|(_, m)| moving(m)).map(|(id, m)| (id.clone(), at(m))).collect(),
            pan: self.pan.as_ref().filter(moving).map(at),
            followed: self.followed.map(|(point, _)| point),
        }
    }
}

impl Motion {
    fn resting(at: Pose) -> Self {
        Self { from: at, to: at, progress: 1.0 }
    }

    fn advance(&mut self, target: Pose, wall: f32) {
        if self.to.position.distance(target.position) < JUMP {
            self.to = target;
        } else {
            *self = Self { from: at(self), to: target, progress: 0.0 };
        }
        self.progress = (self.progress + wall / MOVE_S).min(1.0);
    }
}

fn at(motion: &Motion) -> Pose {
    let t = motion.progress;
    let s = t * t * (3.0 - 2.0 * t);
    let lift = if t < 1.0 { LIFT * 4.0 * t * (1.0 - t) } else { 0.0 };
    Pose {
        position: motion.from.position.lerp(motion.to.position, s) + Vec3::Z * lift,
        rotation: motion.from.rotation.slerp(motion.to.rotation, s),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_that_moves_is_followed_and_one_that_jumps_is_eased_there() {
        let pose = |x: f32, z: f32| Pose { position: Vec3::new(x, 0.0, z), rotation: glam::Quat::IDENTITY };
        let mut motion = Motion::resting(pose(0.0, 0.010));
        for k in 0..50u8 {
            motion.advance(pose(0.0, 0.010 + 1e-4 * f32::from(k)), 0.05);
            assert!(motion.progress >= 1.0, "it hops");
        }
        motion.advance(pose(0.2, 0.015), 0.05);
        assert!(motion.progress < 1.0);
        (0..10).for_each(|_| motion.advance(pose(0.2, 0.0151), 0.05));
        assert!(motion.progress >= 1.0 && at(&motion).position.distance(Vec3::new(0.2, 0.0, 0.0151)) < 1e-6);
    }
}
