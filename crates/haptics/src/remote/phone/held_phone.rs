//! A phone that shows the kitchen and holds its pan: readings in, poses out, no network between them.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::turn;

use super::held_pan::HeldPan;
use super::message::{BadMessage, LARGEST_DEG, Measured};
use super::orientation::{Level, acceleration, from_angles};
use crate::remote::remote_pose::{SILENCE_S, limited_step};

/// Largest tilt of the phone that is taken as level [rad] (chosen: 75°, steeper than a screen is read in a hand).
const READ: f64 = 1.31;

/// The phone, from its first reading on.
#[derive(Clone, Debug, Default)]
pub struct HeldPhone {
    level: Level,
    /// Rotation of the pan that is requested; none before the phone was held flat enough to be taken as level.
    rotation: Option<DQuat>,
    /// Acceleration since the last step, in the kitchen's axes [m/s²].
    push: Option<DVec3>,
    /// Age of the last reading [s].
    silent: f64,
    pan: HeldPan,
}

impl HeldPhone {
    /// Takes a reading; `screen_deg` is the angle by which the picture is turned on the phone [°]. The first reading is taken as level:
    /// the pan is still while the phone is held as one reads it.
    ///
    /// # Errors
    ///
    /// If a number is outside a sensor's range; the reading is then left out.
    pub fn receive(&mut self, measured: &Measured, screen_deg: f64) -> Result<(), BadMessage> {
        measured.check()?;
        if !(0.0..LARGEST_DEG).contains(&screen_deg) {
            return Err(BadMessage::Range { key: "screen", low: 0.0, high: LARGEST_DEG });
        }
        let phone = from_angles(measured.turn);
        let screen = phone * turn(DVec3::Z, -screen_deg.to_radians());
        if self.rotation.is_none() && !self.level.set_within(READ, screen) {
            return Ok(());
        }
        self.rotation = Some(self.level.pan(screen));
        self.push = acceleration(measured, phone).map(|push| self.level.direction(phone, push));
        self.silent = 0.0;
        Ok(())
    }

    /// Returns the pose of the pan after `dt` [s]; none before the first reading, and while the phone is silent.
    pub fn step(&mut self, dt: f64) -> Option<Pose> {
        let dt = limited_step(dt);
        self.silent += dt;
        let rotation = self.rotation.filter(|_| self.silent <= SILENCE_S);
        self.pan.step(rotation.map(|rotation| (rotation, self.push.take())), dt);
        rotation.map(|_| self.pan.pose())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reading(turn: [f64; 3]) -> Measured {
        Measured { turn, push: Some([0.0; 3]), felt: None }
    }

    /// The pan's axis after a phone was held at some angles for a second.
    fn axis(phone: &mut HeldPhone, turn: [f64; 3], screen_deg: f64) -> DVec3 {
        let pose = (0..60).filter_map(|_| {
            phone.receive(&reading(turn), screen_deg).expect("in range");
            phone.step(1.0 / 60.0)
        });
        pose.last().expect("it holds the pan").rotation * DVec3::Z
    }

    #[test]
    fn the_pan_stands_as_the_phone_is_first_held_and_tilts_with_it() {
        // Upright and flat; both at 40° towards the eyes.
        for (held, leans, screen_deg) in
            [([20.0, 40.0, 0.0], [20.0, 25.0, 0.0], 0.0), ([20.0, 0.0, -40.0], [20.0, 0.0, -25.0], 90.0)]
        {
            let mut phone = HeldPhone::default();
            assert_eq!(phone.step(0.01), None, "before the first reading");
            assert!((axis(&mut phone, held, screen_deg) - DVec3::Z).length() < 1e-6);
            let up = axis(&mut phone, leans, screen_deg);
            // Its upper edge went down by 15°: the pan's far rim, too.
            let (sin, cos) = 15.0_f64.to_radians().sin_cos();
            assert!((up - DVec3::new(0.0, sin, cos)).length() < 1e-3, "{up}");
        }
    }

    #[test]
    fn a_steep_phone_takes_no_hold_and_a_silent_one_lets_go() {
        let mut phone = HeldPhone::default();
        phone.receive(&reading([0.0, 85.0, 0.0]), 0.0).expect("in range");
        assert_eq!(phone.step(0.01), None);
        phone.receive(&reading([0.0, 30.0, 0.0]), 0.0).expect("in range");
        assert!(phone.step(0.01).is_some());
        let silent = (0..60).map(|_| phone.step(0.02)).filter(Option::is_none).count();
        assert!(silent > 30, "{silent}");
        assert!(phone.receive(&reading([0.0, f64::NAN, 0.0]), 0.0).is_err());
    }
}
