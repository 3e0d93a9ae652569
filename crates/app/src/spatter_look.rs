//! Oil that spatters as the renderer wants it: drops in the air, and spots where they have landed.

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};
use saute_kitchen::Kitchen;
use saute_kitchen::drop_flight::{DropFlight, Landing};
use saute_kitchen::spatter::Spot;

use crate::scene::input::{DropLook, PanLook, SpatterLook, SpotLook};
use crate::scene::pan_mesh::on_wall;

/// Radius of a spot over that of its drop [-] (chosen: hot oil wets glass and steel and spreads to a low cap).
const SPREAD: f32 = 2.2;
/// A spot is drawn this much above what it lies on [m] (chosen: over the bumps of the drawn wall).
const ABOVE: f32 = 4e-4;

/// What is seen of spatter now; `before` are the spots of the last look, kept while they are the same.
pub(crate) fn spatter_look(kitchen: &Kitchen, pan: &PanLook, before: &Arc<Vec<SpotLook>>) -> SpatterLook {
    let spatter = &kitchen.pan_state().liquids.spatter;
    let now = kitchen.time_s();
    let world_from_floor = pan.world_from_pan() * Mat4::from_translation(Vec3::Z * pan.thickness);
    let in_air = |flight: &&DropFlight| (0.0..flight.lasts_s).contains(&(now - flight.thrown_s));
    let drop = |flight: &DropFlight| {
        let age = now - flight.thrown_s;
        let [place, velocity] = [flight.place(age), flight.velocity(age)].map(single);
        DropLook {
            position: world_from_floor.transform_point3(place),
            velocity: world_from_floor.transform_vector3(velocity),
            radius: flight.radius as f32,
        }
    };
    let spots: Vec<SpotLook> =
        spatter.spots.iter().filter_map(|spot| spot_look(spot, pan, &world_from_floor)).collect();
    SpatterLook {
        drops: spatter.flights.iter().filter(in_air).map(drop).collect(),
        spots: if spots == **before { Arc::clone(before) } else { Arc::new(spots) },
    }
}

fn spot_look(spot: &Spot, pan: &PanLook, world_from_floor: &Mat4) -> Option<SpotLook> {
    let at = single(spot.at);
    let radius = SPREAD * spot.radius as f32;
    match spot.landing {
        Landing::Floor => None,
        Landing::Outside => Some(SpotLook { position: at.with_z(ABOVE), normal: Vec3::Z, radius }),
        Landing::Wall => {
            let out = at.truncate().normalize_or(Vec2::X);
            let (curve, inwards) = on_wall(pan, at.z);
            let place = (out * curve.x).extend(curve.y - pan.thickness);
            let normal = (out * inwards.x).extend(inwards.y);
            Some(SpotLook {
                position: world_from_floor.transform_point3(place + normal * ABOVE),
                normal: world_from_floor.transform_vector3(normal),
                radius,
            })
        }
    }
}

fn single(v: [f64; 3]) -> Vec3 {
    Vec3::from_array(v.map(|x| x as f32))
}
