//! The wrench of what is in the pan on the hand that holds it.

use glam::DVec3;
use saute_food::GRAVITY;

use crate::dynamics::Against;
use crate::kitchen::Kitchen;
use crate::piece::piece_state::Piece;

/// Velocities of the foods at an instant.
#[derive(Clone, Debug, Default)]
pub struct FoodVelocities(Vec<(u32, DVec3)>);

/// A force and a torque, in the kitchen's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PanWrench {
    /// Force [N].
    pub force: DVec3,
    /// Torque about the centre of the pan's floor [N·m].
    pub torque: DVec3,
}

impl FoodVelocities {
    /// Returns the velocities of the foods that have a body.
    pub fn of(kitchen: &Kitchen) -> Self {
        let mut velocities = Self::default();
        velocities.note(kitchen);
        velocities
    }

    /// Replaces them by those of the present instant.
    pub fn note(&mut self, kitchen: &Kitchen) {
        self.0.clear();
        let bodies = kitchen.pieces.iter().filter_map(|p| Some((p.key, kitchen.world.velocity(p.key)?.0)));
        self.0.extend(bodies);
    }

    fn get(&self, key: u32) -> Option<DVec3> {
        self.0.iter().find(|(known, _)| *known == key).map(|(_, velocity)| *velocity)
    }
}

impl PanWrench {
    fn add(&mut self, force: DVec3, arm: DVec3) {
        self.force += force;
        self.torque += arm.cross(force);
    }
}

impl Kitchen {
    /// Mean wrench of foods and liquids on the pan since an instant `dt` ago [s]: their weight, and what their change of speed
    /// takes (Newton's second law). Food that a tool holds, or that flies, does not count; nor does the pan itself.
    pub fn pan_wrench(&self, before: &FoodVelocities, dt: f64) -> PanWrench {
        let pan = self.world.motion.pose;
        let mut wrench = PanWrench::default();
        for piece in self.pieces.iter().filter(|piece| self.loads_pan(piece)) {
            let Some((now, _)) = self.world.velocity(piece.key) else { continue };
            let change = before.get(piece.key).map_or(DVec3::ZERO, |before| before - now);
            let force = (change / dt - DVec3::Z * GRAVITY) * piece.mass();
            wrench.add(force, piece.pose.position - pan.position);
        }
        let (places, liquids) = (&self.fixed.pan.liquids.bed.places, &self.pan.liquids);
        for (i, place) in places.iter().enumerate() {
            let mass = liquids.oil.mass[i] + liquids.water.mass[i];
            wrench.add(DVec3::Z * (-mass * GRAVITY), pan.rotation * DVec3::from_array(*place));
        }
        wrench
    }

    /// Returns true if a piece in the pan touches something else than the blade, and no tool holds it.
    fn loads_pan(&self, piece: &Piece) -> bool {
        let touches = || self.world.contacts(piece.key).iter().any(|c| c.force > 0.0 && c.against != Against::Blade);
        piece.in_pan() && self.second_hand.hand.gripped() != Some(piece.key) && touches()
    }
}
