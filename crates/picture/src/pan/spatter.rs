//! Oil spatter as the renderer's input: drops in the air, and spots where they have landed.

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};
use saute_kitchen::Kitchen;
use saute_kitchen::liquids::drop_flight::{DropFlight, Landing};
use saute_kitchen::liquids::spatter::Spot;
use saute_scene::input::{DropLook, PanLook, SpatterLook, SpotLook};
use saute_scene::mesh::pan::on_wall;

use crate::pace::Pace;

/// Radius of a spot over that of its drop [-] (chosen: hot oil wets glass and steel and spreads to a low cap).
const SPREAD: f32 = 2.2;
/// A spot is drawn this much above what it lies on [m] (chosen: over the bumps of the drawn wall).
const ABOVE: f32 = 4e-4;

/// Ticks between two looks at the spots (chosen: a second, as the picture round the pan is brought up to date for
/// them).
const LOOK_TICKS: u64 = 10;

/// Keeps the spots between looks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spots {
    spots: Arc<Vec<SpotLook>>,
    /// The pan's look and pose for which they were made.
    seen: Option<(u64, Mat4)>,
}

impl Spots {
    /// Returns the visible spatter.
    pub(crate) fn look(&mut self, kitchen: &Kitchen, pan: &PanLook, pace: &Pace) -> SpatterLook {
        let spatter = &kitchen.pan_state().liquids.spatter;
        let world_from_floor = pan.world_from_pan() * Mat4::from_translation(Vec3::Z * pan.thickness);
        let look = (kitchen.tick() / LOOK_TICKS.max(pace.every()), world_from_floor);
        if self.seen != Some(look) {
            let spots: Vec<SpotLook> =
                spatter.spots.iter().filter_map(|spot| spot_look(spot, pan, &world_from_floor)).collect();
            if spots != *self.spots {
                self.spots = Arc::new(spots);
            }
            self.seen = Some(look);
        }
        let drops = drops(&spatter.flights, kitchen.time_s(), &world_from_floor);
        SpatterLook { drops, spots: Arc::clone(&self.spots) }
    }
}

/// The drops that are in the air at a moment [s].
fn drops(flights: &[DropFlight], now: f64, world_from_floor: &Mat4) -> Vec<DropLook> {
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
    flights.iter().filter(in_air).map(drop).collect()
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

#[cfg(test)]
mod tests {
    use saute_kitchen::food::Rules;
    use saute_kitchen::{Command, EventKind, Library, MeshSize, OutlineKind, PieceOrder, kelvin};

    use super::*;
    use crate::stage::{Stage, StageOptions};

    /// Every event is one drop: those in the air are drawn, those that fell on wall or glass are spots.
    #[test]
    fn as_many_drops_are_drawn_as_the_kitchen_throws() {
        let library = Library::embedded().expect("data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(190.0)).expect("pan");
        let order = PieceOrder {
            id: "steak".into(),
            kind: "beef-lean".into(),
            size: [0.10, 0.07, 0.02],
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 2.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &order).expect("food");
        for command in [
            Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false },
            Command::Oil { kind: Some("canola".into()), mass: 0.015 },
            Command::Hob(1200.0),
        ] {
            kitchen.apply(&command).expect("accepted");
        }
        let options = StageOptions::default();
        let mut stage = Stage::default();
        let (mut in_air, mut told) = (0, 0);
        for _ in 0..300 {
            kitchen.step();
            let scene = stage.scene(&kitchen, &options, &Default::default());
            let spatter = &kitchen.pan_state().liquids.spatter;
            assert_eq!(scene.spatter.drops.len(), spatter.flights.len());
            // Spots are looked at once a second.
            assert!(scene.spatter.spots.len() <= spatter.spots.len());
            if kitchen.tick().is_multiple_of(LOOK_TICKS) {
                assert_eq!(scene.spatter.spots.len(), spatter.spots.len());
            }
            in_air = in_air.max(scene.spatter.drops.len());
            told = [EventKind::Spatter, EventKind::Pop].map(|k| kitchen.events().tally(k).count).iter().sum();
        }
        assert!(in_air > 1 && told > 30, "{in_air} {told}");
    }
}
