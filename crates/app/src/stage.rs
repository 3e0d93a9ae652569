//! Sets the scene: a kitchen becomes what the renderer draws.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Mat4, Quat, Vec3};
use saute_kitchen::food::Scale;
use saute_kitchen::{Kitchen, Piece, Place, RestOn, celsius};

use crate::colour_map::{ColourMap, TemperatureMap};
use crate::food_look::{Skin, slice};
use crate::scene::camera::Camera;
use crate::scene::input::{
    Colouring, FLOOR_FIELD_RINGS, FoodLook, HobLook, PanLook, RACK_HEIGHT, RestKind, RestLook, SceneInput, SteamSource,
};
use crate::scene::props::{BOARD_CENTRE, CLOTH_PLACE};
use crate::view::View;

/// How the picture is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct StageOptions {
    /// The eye.
    pub camera: Camera,
    /// What the colours mean.
    pub view: View,
    /// Which map shows temperatures.
    pub map: TemperatureMap,
    /// The scale of doneness; none where no scale says anything about the food.
    pub scale: Option<Arc<Scale>>,
    /// The cut: distance along the longest axis from the centroid over half the length (−1…1); none for no cut.
    pub slice: Option<f64>,
    /// Unlit, exactly decodable colours.
    pub flat: bool,
}

/// Where a piece lies and how far it is turned about its long axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Centroid [m].
    pub position: Vec3,
    /// Turn about the long axis [rad]: 0 or π at rest.
    pub turn: f32,
    /// Turn about the vertical [rad]: across the board, along the pan.
    pub yaw: f32,
}

impl Pose {
    /// The pose that the kitchen says.
    pub fn of(kitchen: &Kitchen, piece: &Piece) -> Self {
        let half = piece.model.rest_height(&piece.state) as f32;
        let lift = if piece.place == Place::Rest(RestOn::Rack) { RACK_HEIGHT } else { 0.0 };
        let (position, yaw) = match piece.place {
            Place::Pan(at) => {
                let floor = kitchen.pan_model().description.floor.thickness_mm as f32 * 1e-3;
                (pan_position(kitchen) + Vec3::new(at[0] as f32, at[1] as f32, floor + half), 0.0)
            }
            Place::Waiting | Place::Rest(_) => {
                (board_place(kitchen, piece) + Vec3::Z * (half + lift), -std::f32::consts::FRAC_PI_2)
            }
        };
        Self { position, turn: if piece.upside_down() { std::f32::consts::PI } else { 0.0 }, yaw }
    }

    /// Maps the rest frame to the world.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_rotation_translation(
            Quat::from_rotation_z(self.yaw) * Quat::from_rotation_x(self.turn),
            self.position,
        )
    }
}

/// Where the first piece on the board lies: near the pan, in view [m].
pub const FIRST_ON_BOARD: Vec3 = Vec3::new(BOARD_CENTRE.x - 0.07, BOARD_CENTRE.y, BOARD_CENTRE.z);

/// Pieces lie across the board, the first one nearest to the pan.
fn board_place(kitchen: &Kitchen, piece: &Piece) -> Vec3 {
    let index = kitchen.pieces().iter().filter(|p| !p.in_pan()).position(|p| p.id == piece.id).unwrap_or(0);
    FIRST_ON_BOARD + Vec3::X * (0.09 * index as f32)
}

/// Where things are in the picture while they are on their way; elsewhere the kitchen tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    /// Pieces, by id.
    pub pieces: BTreeMap<String, Pose>,
    /// The pan [m].
    pub pan: Option<Vec3>,
}

impl Places {
    /// Where a piece is.
    pub fn piece(&self, kitchen: &Kitchen, piece: &Piece) -> Pose {
        self.pieces.get(&piece.id).copied().unwrap_or_else(|| Pose::of(kitchen, piece))
    }

    /// Where the pan is [m].
    pub fn pan(&self, kitchen: &Kitchen) -> Vec3 {
        self.pan.unwrap_or_else(|| pan_position(kitchen))
    }
}

/// How much of the pan's way to the cloth the eye goes along [-] (chosen: hob and pan stay in view).
const EYE_FOLLOWS: f32 = 0.62;

/// The eye follows the pan to the cloth.
pub fn following(camera: &Camera, pan: Vec3) -> Camera {
    Camera { target: camera.target + pan.with_z(0.0) * EYE_FOLLOWS, ..camera.clone() }
}

/// Where the pan stands [m].
pub fn pan_position(kitchen: &Kitchen) -> Vec3 {
    if kitchen.cloth().is_some() {
        return CLOTH_PLACE;
    }
    let pose = kitchen.pan_state().pose;
    Vec3::new(pose.at[0] as f32, pose.at[1] as f32, pose.lift as f32)
}

/// Keeps the skins of the pieces between frames.
#[derive(Clone, Debug, Default)]
pub struct Stage {
    skins: BTreeMap<String, (u64, Skin)>,
}

impl Stage {
    /// Describes one frame.
    pub fn scene(&mut self, kitchen: &Kitchen, options: &StageOptions, places: &Places) -> SceneInput {
        let pan = places.pan(kitchen);
        let map = options.view.colour_map(options.map, options.scale.as_deref());
        self.skins.retain(|id, _| kitchen.piece(id).is_some());
        let foods = kitchen.pieces().iter().map(|p| self.food(kitchen, p, options, map.as_ref(), places)).collect();
        SceneInput {
            camera: following(&options.camera, pan),
            hob: HobLook { power: (kitchen.drawn_w() / 2000.0).min(1.0) as f32 },
            pan: PanLook { position: pan, ..pan_look(kitchen, options.view, map.as_ref()) },
            foods,
            rest: kitchen.pieces().iter().find_map(rest_look),
            steam: steam(kitchen, places),
            time_s: kitchen.time_s() as f32,
            colouring: map.map_or(Colouring::Look, |m| Colouring::Field { table: m.table, stepped: m.stepped }),
            flat: options.flat,
        }
    }

    fn food(
        &mut self,
        kitchen: &Kitchen,
        piece: &Piece,
        options: &StageOptions,
        map: Option<&ColourMap>,
        places: &Places,
    ) -> FoodLook {
        let identity = Arc::as_ptr(&piece.model) as u64;
        let entry = self.skins.entry(piece.id.clone()).or_insert_with(|| (identity, Skin::new(piece)));
        if entry.0 != identity {
            *entry = (identity, Skin::new(piece));
        }
        let skin = &entry.1;
        let pose = places.piece(kitchen, piece);
        FoodLook {
            mesh: skin.mesh.clone(),
            vertices: skin.vertices(&piece.model, &piece.state, options.view, map),
            world_from_rest: pose.matrix(),
            slice: options.slice.and_then(|s| slice(piece, s * half_length(piece), options.view, map)),
        }
    }
}

/// Rack or foil where a piece rests on or under one.
fn rest_look(piece: &Piece) -> Option<RestLook> {
    let kind = match piece.place {
        Place::Rest(RestOn::Rack) => RestKind::Rack,
        Place::Rest(RestOn::Foil) => RestKind::Foil,
        _ => return None,
    };
    // Pieces lie across the board: their length runs along y.
    let [length, width, thickness] = piece.model.size.map(|v| v as f32);
    Some(RestLook { kind, centre: FIRST_ON_BOARD, half: 0.5 * glam::Vec2::new(width, length), height: thickness })
}

/// The scale, where it says anything about what is cooked: about the first piece.
pub fn fitting(kitchen: &Kitchen, scale: &Arc<Scale>) -> Option<Arc<Scale>> {
    let first = kitchen.pieces().first();
    first.is_none_or(|p| scale.fits(&p.model.kinetics)).then(|| Arc::clone(scale))
}

/// How much nearer the eye goes to a small piece [-]: it fills as much of the picture as a steak of 120 mm, and never
/// nearer than is sharp (chosen).
pub fn nearness(piece: &Piece) -> f32 {
    ((half_length(piece) / 0.06) as f32).clamp(0.5, 1.0)
}

/// Half the longest extent of a piece [m].
pub fn half_length(piece: &Piece) -> f64 {
    0.5 * piece.model.size[0].max(piece.model.size[1])
}

fn pan_look(kitchen: &Kitchen, view: View, map: Option<&ColourMap>) -> PanLook {
    let description = &kitchen.pan_model().description;
    let look = &description.look;
    let linear = |v: u8| {
        let v = f32::from(v) / 255.0;
        if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
    };
    PanLook {
        floor_radius: description.floor.radius_mm as f32 * 1e-3,
        rim_radius: description.wall.rim_radius_mm as f32 * 1e-3,
        rim_height: description.wall.height_mm as f32 * 1e-3,
        thickness: description.floor.thickness_mm as f32 * 1e-3,
        colour: Vec3::from_array(look.colour_srgb.map(linear)),
        metalness: look.metalness as f32,
        roughness: look.roughness as f32,
        oil: 0.6,
        position: pan_position(kitchen),
        on_cloth: kitchen.cloth().is_some(),
        floor_field: floor_field(kitchen, map.filter(|_| view == View::Temperature)),
    }
}

/// Mean temperature of the floor in rings, as map coordinates; −1 where the view does not colour the pan.
fn floor_field(kitchen: &Kitchen, map: Option<&ColourMap>) -> [f32; FLOOR_FIELD_RINGS] {
    let Some(map) = map else { return [-1.0; FLOOR_FIELD_RINGS] };
    let (pan, state) = (kitchen.pan_model(), kitchen.pan_state());
    let floor = pan.description.floor.radius_mm * 1e-3;
    let mut sums = [(0.0, 0.0); FLOOR_FIELD_RINGS];
    for (p, t) in pan.section.points[..pan.floor_nodes].iter().zip(&state.temperature) {
        let place = p[0].hypot(p[1]) / floor * (FLOOR_FIELD_RINGS - 1) as f64;
        for (ring, sum) in sums.iter_mut().enumerate() {
            // A tent one node ring (8 mm) wide keeps every drawn ring fed.
            let weight = (1.0 - (place - ring as f64).abs() / 1.6).max(0.0);
            *sum = (sum.0 + weight * t, sum.1 + weight);
        }
    }
    let mean = celsius(kitchen.pan_temperature());
    sums.map(|(t, w)| map.coordinate(if w > 0.0 { celsius(t / w) } else { mean }))
}

/// Vapour leaves round the lower rim of a frying piece and from its upper face.
fn steam(kitchen: &Kitchen, places: &Places) -> Vec<SteamSource> {
    let mut sources = Vec::new();
    for piece in kitchen.pieces().iter().filter(|p| p.place != Place::Waiting && p.vapour_flow > 0.0) {
        let pose = places.piece(kitchen, piece);
        let [a, b] = [0.45 * piece.model.size[0] as f32, 0.45 * piece.model.size[1] as f32];
        let share = 1e3 * piece.vapour_flow as f32 / 7.0;
        for k in 0..6u8 {
            let angle = f32::from(k) * std::f32::consts::TAU / 6.0 + 0.4;
            let position = pose.position + Vec3::new(a * angle.cos(), b * angle.sin(), 0.0);
            sources.push(SteamSource { position, radius: 0.015f32.min(0.5 * b), flow_g_s: share });
        }
        let top = pose.position + Vec3::Z * 0.5 * piece.model.thickness(&piece.state) as f32;
        sources.push(SteamSource { position: top, radius: 0.5 * b, flow_g_s: share });
    }
    let (puddle, cloth) = kitchen.other_vapour();
    if puddle + cloth > 1e-6 {
        let flow_g_s = 1e3 * (puddle + 0.3 * cloth) as f32;
        sources.push(SteamSource { position: places.pan(kitchen) + Vec3::Z * 0.01, radius: 0.09, flow_g_s });
    }
    sources
}
