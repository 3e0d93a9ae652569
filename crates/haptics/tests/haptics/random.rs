//! Seeded random numbers for tests.

use glam::DVec3;
use saute_haptics::{Geometry, Pose, library};

pub struct Random(pub u64);

impl Random {
    /// Returns a number uniform between −1 and 1.
    pub fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }
}

pub fn device(name: &str) -> Geometry {
    library::devices().unwrap().remove(name).unwrap()
}

/// Returns a random pose within ±100 mm and ±20° of home.
pub fn somewhere(geometry: &Geometry, random: &mut Random) -> Pose {
    let home = geometry.home();
    let turn = random.vector() * 20f64.to_radians();
    let axis = turn.normalize();
    Pose { position: home.position + random.vector() * 0.1, ..home }.turned(axis, turn.length().min(20f64.to_radians()))
}

/// Returns distance [mm] and angle [°] between poses.
pub fn apart(a: &Pose, b: &Pose) -> (f64, f64) {
    let turn = saute_kitchen::dynamics::pose::rotation_between(a.rotation, b.rotation).length();
    ((a.position - b.position).length() * 1e3, turn.to_degrees())
}
