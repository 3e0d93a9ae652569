//! Pools of juice round foods that lie on the board: a ring round the foot, widest before the cut face.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use crate::input::{FoodLook, FoodVertex, SceneInput};
use crate::mesh::props::BOARD_CENTRE;
use crate::mesh::steam::PuffVertex;

/// Corners of a pool's edge.
const AROUND: usize = 72;
/// Vertices of all pools, at most.
pub(crate) const POOL_VERTICES_MAX: usize = POOLS_MAX * AROUND * 6;
const POOLS_MAX: usize = 24;
/// Mean depth of a pool on oiled wood [m] (chosen: a quarter of the capillary length of water, 2.7 mm, as its edge is flat).
const DEPTH: f32 = 0.7e-3;
/// Widest pool [m] (chosen).
const WIDEST: f32 = 0.022;
/// Less juice than this is not seen [g] (chosen).
const LEAST: f32 = 0.05;
/// How far a pool reaches on the sides that are not cut, over the mean, and how much farther before the cut (chosen: juice
/// leaves where fibres end).
const ASIDE: f32 = 0.45;
const BEFORE_CUT: f32 = 1.9;
/// What is further above the lowest point does not touch the board [m] (chosen).
const TOUCHING: f32 = 4e-3;
/// The ring begins this far under the food, and is this much above the board [m] (chosen).
const UNDER: f32 = 2.5e-3;
const ABOVE: f32 = 6e-4;

/// Sprites of the pools of a scene.
pub(crate) fn pools(input: &SceneInput) -> Vec<PuffVertex> {
    let wet = input.foods.iter().filter(|food| food.juice_g > LEAST);
    wet.take(POOLS_MAX).flat_map(pool).collect()
}

/// The ring of one food; its corners hold the way across it, 0 at the food.
fn pool(food: &FoodLook) -> Vec<PuffVertex> {
    let points = seen_points(food);
    let lowest = points.iter().map(|p| p.z).fold(f32::INFINITY, f32::min);
    let foot: Vec<Vec2> = points.iter().filter(|p| p.z < lowest + TOUCHING).map(|p| p.truncate()).collect();
    let cut = food.slice.as_ref().filter(|slice| !slice.ghost);
    let before = cut.map_or(Vec2::ZERO, |slice| {
        food.world_from_rest.transform_vector3(slice.normal).truncate().normalize_or_zero()
    });
    let farthest = |out: Vec2| foot.iter().copied().max_by(|a, b| a.dot(out).total_cmp(&b.dot(out)));
    let share = |out: Vec2| if cut.is_some() { ASIDE + BEFORE_CUT * out.dot(before).max(0.0).powi(2) } else { 1.0 };
    let directions = (0..AROUND).map(|k| Vec2::from_angle(TAU * k as f32 / AROUND as f32));
    let edge: Vec<(Vec2, Vec2)> = directions.filter_map(|out| Some((farthest(out)?, out))).collect();
    let next = |k: usize| edge[(k + 1) % edge.len()];
    let length: f32 = (0..edge.len()).map(|k| edge[k].0.distance(next(k).0) * share(edge[k].1)).sum();
    let reach = 1e-6 * food.juice_g / (DEPTH * length.max(1e-3));
    let red = redness(food);
    let middle = foot.iter().sum::<Vec2>() / foot.len().max(1) as f32;
    // Where the foot has a corner, several directions share it, above and below.
    let under = |at: Vec2| at + (middle - at).normalize_or_zero() * UNDER;
    let vertex = |(at, out): (Vec2, Vec2), across: f32| {
        let place = if across > 0.0 { at + out * (reach * share(out)).min(WIDEST) } else { under(at) };
        let position = place.extend(BOARD_CENTRE.z + ABOVE).to_array();
        PuffVertex { position, corner: (out * across).to_array(), half_size: 0.0, opacity: red, random: 0.0 }
    };
    let strip = |k: usize| {
        let [a, b, c, d] =
            [(edge[k], 0.0), (next(k), 0.0), (next(k), 1.0), (edge[k], 1.0)].map(|(e, across)| vertex(e, across));
        [a, b, c, a, c, d]
    };
    (0..edge.len()).flat_map(strip).collect()
}

/// What is seen of a food, with its cut face, in the world [m].
fn seen_points(food: &FoodLook) -> Vec<Vec3> {
    let place = |v: &FoodVertex| food.world_from_rest.transform_point3(Vec3::from(v.position));
    let Some(cut) = food.slice.as_ref().filter(|slice| !slice.ghost) else {
        return food.vertices.iter().map(place).collect();
    };
    let kept = |v: &&FoodVertex| (Vec3::from(v.rest) - cut.point).dot(cut.normal) <= 0.0;
    food.vertices.iter().filter(kept).chain(&cut.vertices).map(place).collect()
}

/// How red the juice is (0–1): as raw as the flesh that it comes from.
fn redness(food: &FoodLook) -> f32 {
    let from = food.slice.as_ref().map_or(food.vertices.as_slice(), |slice| &slice.vertices);
    1.0 - from.iter().map(|v| v.cooked).sum::<f32>() / from.len().max(1) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Doneness, steak_in_pan};

    fn area(sprites: &[PuffVertex]) -> f32 {
        let place = |v: &PuffVertex| Vec3::from(v.position);
        let twice = |t: &[PuffVertex]| (place(&t[1]) - place(&t[0])).cross(place(&t[2]) - place(&t[0])).length();
        0.5 * sprites.chunks(3).map(twice).sum::<f32>()
    }

    #[test]
    fn a_pool_is_as_large_as_its_juice_and_dry_food_has_none() {
        let mut scene = steak_in_pan(Doneness::Browned);
        assert!(pools(&scene).is_empty());
        let mut of = |juice_g: f32| {
            scene.foods[0].juice_g = juice_g;
            pools(&scene)
        };
        // The part under the food is the same for any amount.
        let least = 1.2 * LEAST;
        let dry = area(&of(least));
        for juice_g in [0.5, 1.0, 2.0, 4.0] {
            let sprites = of(juice_g);
            let grown = (area(&sprites) - dry) / (1e-6 * (juice_g - least) / DEPTH);
            assert!((0.8..1.5).contains(&grown), "{juice_g} g: {grown}");
            assert!(sprites.len() <= POOL_VERTICES_MAX);
        }
    }
}
