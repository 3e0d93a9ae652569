//! Food as it is served: on a plate; a thick slice is cut, one half laid on the other.

use std::f32::consts::PI;

use glam::{Mat4, Quat, Vec2, Vec3};
use saute_kitchen::{Kitchen, Piece};
use saute_scene::camera::Camera;
use saute_scene::input::{FoodLook, PLATE_HEIGHT, RestKind, RestLook, SceneInput, SliceLook};
use saute_scene::mesh::props::BOARD_CENTRE;

use crate::skin::halves::mirrored;
use crate::stage::{Stage, StageOptions};

/// Middle of the plate, on the board [m].
const MIDDLE: Vec3 = BOARD_CENTRE;
/// Radius of the plate's well that food takes [m].
const WELL: f32 = 0.072;
/// A single slice at least so long and thick is cut [m] (chosen: what is eaten with a knife).
const CUT_FROM: [f64; 2] = [0.055, 0.011];
/// Where the cut of the lower half is before the middle of the plate [m], and how far both halves turn about the vertical [rad]
/// (chosen: both cuts are seen, neither is parallel to the picture).
const BEFORE: f32 = 0.038;
const TURNED: [f32; 2] = [0.26, -0.08];
/// How far the upper half lies behind the cut of the lower one, over its own length [-], and to its side [m] (chosen: its centre of
/// mass is above the lower one, so that it lies there).
const SET_BACK: f32 = 0.40;
const ASIDE: f32 = 0.012;
/// Share of the plate's well from which a piece takes the middle for itself [-], and where round it the others begin, over the well's
/// radius [-] (chosen: a steak with its vegetables).
const MAIN: f32 = 0.3;
const ROUND_MAIN: f32 = 0.85;
/// Turn from one piece of many to the next: the golden angle [rad].
const GOLDEN: f32 = 2.399_963_2;
/// The eye: its turn about the vertical, its height above the horizontal [rad] and its distance [m] (chosen: from a chair).
const EYE: [f32; 3] = [0.16, 0.62, 0.27];

/// Returns the scene of a serving; the eye is at the plate.
pub fn plated(kitchen: &Kitchen, options: &StageOptions) -> SceneInput {
    let mut stage = Stage::default();
    let options = StageOptions { slice: None, ..options.clone() };
    let scene = stage.scene(kitchen, &options, &Default::default());
    let alone = if let [piece] = kitchen.pieces() { halved(&stage, piece, &options) } else { None };
    let foods = alone.unwrap_or_else(|| heaped(&scene.foods));
    let [yaw, pitch, distance] = EYE;
    let distance = distance * nearness(&foods);
    let target = MIDDLE + Vec3::new(0.0, 0.004, PLATE_HEIGHT + 0.012);
    let camera = Camera { yaw, pitch, distance, target, ..options.camera.clone() };
    let rest = RestLook { kind: RestKind::Plate, centre: MIDDLE, half: Vec2::splat(WELL), height: 0.0 };
    SceneInput { camera, foods, rest: Some(rest), tool: None, steam: Vec::new(), ..scene }
}

/// Factor by which the eye is nearer to a small serving [-] (chosen: food fills half of the picture, and some of the plate is seen).
fn nearness(foods: &[FoodLook]) -> f32 {
    let corners = foods.iter().map(extent).flat_map(|(low, high)| [low, high]);
    let far = corners.map(|p| (p - MIDDLE).truncate().length()).fold(0.0, f32::max);
    (far / 0.068).clamp(0.55, 1.1)
}

/// Both halves of a slice that is thick enough to be cut; none of another piece.
fn halved(stage: &Stage, piece: &Piece, options: &StageOptions) -> Option<Vec<FoodLook>> {
    let [length, width, thickness] = piece.model.size();
    let slice = piece.model.mesh().is_slice() && piece.model.pool().is_none();
    if !slice || length.max(width) < CUT_FROM[0] || thickness < CUT_FROM[1] {
        return None;
    }
    let (whole, cut) = stage.cut_in_half(piece, options)?;
    let upright = if piece.upside_down() { Quat::from_rotation_x(PI) } else { Quat::IDENTITY };
    let [near, far] = [cut.clone(), mirrored(&cut)].map(|cut| Half::new(&whole, cut, upright));
    let below = Mat4::from_rotation_z(TURNED[0]) * Mat4::from_translation(Vec3::new(0.0, -BEFORE, 0.0));
    let place = Vec3::new(ASIDE, SET_BACK * near.length - BEFORE, near.height);
    let above = Mat4::from_rotation_z(TURNED[1]) * Mat4::from_translation(place);
    Some(vec![near.look(&whole, below), far.look(&whole, above)])
}

/// A half in a frame whose origin is in the middle of the cut's lower edge; the cut looks to −y.
struct Half {
    cut: SliceLook,
    own_from_rest: Mat4,
    length: f32,
    height: f32,
}

impl Half {
    fn new(whole: &FoodLook, cut: SliceLook, upright: Quat) -> Self {
        let turned = |v: Vec3| upright * v;
        let normal = turned(cut.normal);
        let turn = Quat::from_rotation_z(-PI * 0.5 - normal.y.atan2(normal.x)) * upright;
        let face = cut.vertices.iter().map(|v| turn * Vec3::from(v.position));
        let (low, high) = bounds(face);
        let kept = whole.vertices.iter().map(|v| turn * Vec3::from(v.position)).filter(|p| p.y > low.y);
        let (least, most) = bounds(kept);
        let origin = Vec3::new(0.5 * (low.x + high.x), low.y, least.z);
        Self {
            cut: SliceLook { ghost: false, ..cut },
            own_from_rest: Mat4::from_translation(-origin) * Mat4::from_quat(turn),
            length: most.y - low.y,
            height: high.z - low.z,
        }
    }

    fn look(&self, whole: &FoodLook, plate_from_own: Mat4) -> FoodLook {
        let world_from_rest = Mat4::from_translation(on_plate(Vec2::ZERO)) * plate_from_own * self.own_from_rest;
        FoodLook { world_from_rest, slice: Some(self.cut.clone()), juice_g: 0.0, steam_g_s: 0.0, ..whole.clone() }
    }
}

/// A place in the plate's well.
fn on_plate(at: Vec2) -> Vec3 {
    MIDDLE + at.extend(PLATE_HEIGHT)
}

fn bounds(points: impl Iterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

/// Pieces in a heap: the first of those that fill much of the plate in the middle, the others on a spiral round it; where there is no
/// room for all side by side one lies on the other.
fn heaped(foods: &[FoodLook]) -> Vec<FoodLook> {
    let boxes: Vec<(Vec3, Vec3)> = foods.iter().map(extent).collect();
    let share = |(low, high): &(Vec3, Vec3)| (high.x - low.x) * (high.y - low.y) / (PI * WELL * WELL);
    let main = boxes.iter().position(|extent| share(extent) > MAIN).filter(|_| foods.len() > 1);
    let crowd: f32 = boxes.iter().enumerate().filter(|(k, _)| Some(*k) != main).map(|(_, extent)| share(extent)).sum();
    let served = foods.iter().zip(&boxes).enumerate().map(|(k, (food, (low, high)))| {
        let spread = ((k as f32 + 0.5) / foods.len() as f32).sqrt();
        let out = if main.is_some() { ROUND_MAIN + (1.0 - ROUND_MAIN) * spread } else { spread };
        let reach = 0.5 * (high - low).truncate().max_element();
        let alone = foods.len() == 1 || main == Some(k);
        let far = if alone { 0.0 } else { (WELL - 0.6 * reach).max(0.2 * WELL) * crowd.sqrt().clamp(0.5, 1.0) };
        let lift = if alone { 0.0 } else { (high.z - low.z) * 0.75 * (crowd - 0.7).max(0.0) * (1.0 - out) };
        let angle = if alone { 0.0 } else { GOLDEN * k as f32 };
        let place = on_plate(out * far * Vec2::from_angle(angle)) + Vec3::Z * lift;
        let middle = (0.5 * (*low + *high)).with_z(low.z);
        let moved = Mat4::from_translation(place) * Mat4::from_rotation_z(angle) * Mat4::from_translation(-middle);
        FoodLook { world_from_rest: moved * food.world_from_rest, juice_g: 0.0, steam_g_s: 0.0, ..food.clone() }
    });
    served.collect()
}

/// Lowest and highest corner of what is seen of a food, in the world.
fn extent(food: &FoodLook) -> (Vec3, Vec3) {
    let seen = |p: &Vec3| food.slice.as_ref().is_none_or(|cut| (*p - cut.point).dot(cut.normal) <= 1e-4);
    let places = food.vertices.iter().map(|v| Vec3::from(v.position)).filter(seen);
    bounds(places.map(|p| food.world_from_rest.transform_point3(p)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;
    use saute_recipe::Recipe;

    use super::*;
    use crate::still::shot::cook_until;

    fn served(text: &str) -> SceneInput {
        let library = Library::embedded().unwrap();
        let recipe = Recipe::parse(text, "test.toml", &library).unwrap();
        let cook = cook_until(recipe, &library, 1.0).unwrap();
        plated(&cook.kitchen, &StageOptions::default())
    }

    /// Lowest point of what is seen of each food above the plate's well [m], and the farthest from its middle [m].
    fn lies(scene: &SceneInput) -> Vec<[f32; 2]> {
        let measure = |food: &FoodLook| {
            let (low, high) = extent(food);
            let far = [low, high].map(|p| (p - MIDDLE).truncate().length());
            [low.z - on_plate(Vec2::ZERO).z, far[0].max(far[1])]
        };
        scene.foods.iter().map(measure).collect()
    }

    #[test]
    fn a_steak_is_cut_and_one_half_lies_on_the_other() {
        let steak = "[pan]\nkind = \"cast-iron-26\"\n[[food]]\nid = \"it\"\nkind = \"beef-lean\"\n[[step]]\nput = \"it\"\n[[step]]\nafter_s = 5\nend = true\n";
        let scene = served(steak);
        let [below, above] = lies(&scene)[..] else { panic!("two halves") };
        assert!(below[0].abs() < 1e-3 && (0.020..0.030).contains(&above[0]), "{below:?} {above:?}");
        assert!(below[1] < 0.10 && above[1] < 0.10, "{below:?} {above:?}");
        assert!(scene.foods.iter().all(|food| food.slice.as_ref().is_some_and(|cut| !cut.ghost)));
    }

    #[test]
    fn many_pieces_lie_in_the_well_of_the_plate() {
        let coins = "[pan]\nkind = \"cast-iron-26\"\n[[food]]\nid = \"it\"\nkind = \"carrot-coin\"\ncount = 12\n[[step]]\nput = \"it\"\n[[step]]\nafter_s = 5\nend = true\n";
        let lies = lies(&served(coins));
        assert_eq!(lies.len(), 12);
        assert!(lies.iter().all(|[low, far]| (-1e-3..0.02).contains(low) && *far < 0.10), "{lies:?}");
    }
}
