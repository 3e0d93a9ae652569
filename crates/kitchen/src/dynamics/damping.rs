//! What takes speed from a body besides friction: soft, wet food creeps to a stop, and what rolls on the table comes to
//! rest.

/// Speed below which a body creeps [solver units/s] (chosen: 5 cm/s), and the linear and angular damping of a creeping
/// body [1/s] (chosen: soft, wet food stops within hundredths of a second).
const CREEPING: f32 = 5.0;
const CREEP_DAMPING: [f32; 2] = [30.0, 60.0];
/// Deceleration of the rim of what rolls on the table, by damping alone [solver units/s²] (chosen: the centre of a disc
/// loses a third of it, 0.5 m/s², the rolling resistance of soft food. The table has no edge: without it a ring that
/// fell out of the pan would roll for ever).
const ROLLING: f32 = 150.0;

/// Linear and angular damping of a body of a speed [1/s].
pub(super) fn damping(speed: f32, on_table: bool) -> [f32; 2] {
    if speed < CREEPING {
        return CREEP_DAMPING;
    }
    [0.0, if on_table { ROLLING / speed } else { 0.0 }]
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};
    use saute_food::Solid;

    use crate::dynamics::{PanShape, PanTarget, Pose, RIGID_HZ, World};

    #[test]
    fn a_ring_that_rolls_on_the_table_comes_to_rest_near_by() {
        let mut world = World::new(PanShape { floor: 0.1, rim: 0.13, height: 0.04, thickness: 0.002 });
        let on_edge = DQuat::from_rotation_x(core::f64::consts::FRAC_PI_2);
        let pose = Pose { position: DVec3::new(0.0, -0.5, 0.014), rotation: on_edge };
        world.add(1, Solid::Cylinder { radius: 0.014, half_height: 0.010 }, 0.012, &pose);
        let target = PanTarget { pose: world.motion.pose, ..PanTarget::default() };
        for _ in 0..RIGID_HZ / 8 {
            world.push(1, DVec3::X * 0.06, DVec3::ZERO);
            world.step(&target);
        }
        let speed = world.velocity(1).map_or(0.0, |(speed, _)| speed.length());
        assert!(speed > 0.1, "it rolls: {speed} m/s");
        (0..3 * RIGID_HZ).for_each(|_| world.step(&target));
        let rolled = world.pose(1).map_or(0.0, |pose| pose.position.x);
        assert!(world.is_settled() && (0.02..0.5).contains(&rolled), "{rolled} m");
    }
}
