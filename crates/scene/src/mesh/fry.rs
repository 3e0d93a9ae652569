//! Fat and juice round a frying food: a ring that climbs its side, and bubbles in it.

use std::f32::consts::TAU;

use glam::{Mat4, Vec2, Vec3};

use crate::input::{FoodLook, SceneInput, Vapour};
use crate::mesh::steam::{CORNERS, PuffVertex};

/// Directions in which the foot of a food is looked up.
const DIRECTIONS: usize = 48;
/// Bubbles round all foods, at most.
const BUBBLES_MAX: usize = 56;
/// Foods with a ring, at most.
const RINGS_MAX: usize = 4;
/// Vertices of all sprites, at most.
pub(crate) const FRY_VERTICES_MAX: usize = RINGS_MAX * DIRECTIONS * 6 + BUBBLES_MAX * 6;

/// Width of the ring [m] (chosen).
const RING: f32 = 4.5e-3;
/// How far under the food the ring begins [m].
const UNDER: f32 = 1.0e-3;
/// The liquid stands this much above the floor [m]: what lies in it is drawn over the floor.
const ABOVE: f32 = 4e-4;
/// A food whose underside is further above the floor does not fry [m].
const TOUCHING: f32 = 2.5e-3;
/// The middle of a food that fries is at most this far from the floor [m] (chosen: twice a thick steak's).
const TALLEST: f32 = 0.03;
/// Bubbles for each g/s of vapour (chosen).
const BUBBLES_PER_FLOW: f32 = 400.0;
/// Life of a bubble [s] (chosen).
const LIFE: f32 = 0.8;

/// Sprites round the foods that lie in the pan, lowest first.
pub(crate) fn fry(input: &SceneInput) -> Vec<PuffVertex> {
    let feet: Vec<Foot> = input.foods.iter().filter_map(|food| Foot::of(food, input)).take(RINGS_MAX).collect();
    let steam = input.steam.iter().filter(|source| source.kind == Vapour::Steam);
    let flow: f32 = steam.map(|source| source.flow_g_s).sum();
    let mut vertices = Vec::new();
    for foot in &feet {
        foot.ring(&mut vertices, 0.45 + 0.55 * (flow * 12.0).min(1.0));
    }
    let count = ((flow * BUBBLES_PER_FLOW) as usize).min(BUBBLES_MAX);
    for k in 0..count {
        if let Some(foot) = feet.get(k % feet.len().max(1)) {
            foot.bubble(&mut vertices, k as f32, input.time_s);
        }
    }
    vertices
}

/// Where a food meets the floor: its reach in every direction from its middle.
struct Foot {
    /// In the pan's frame [m].
    middle: Vec3,
    world_from_pan: Mat4,
    reach: [f32; DIRECTIONS],
}

impl Foot {
    fn of(food: &FoodLook, input: &SceneInput) -> Option<Self> {
        let world_from_pan = input.pan.world_from_pan();
        let pan_from_rest = world_from_pan.inverse() * food.world_from_rest;
        let points = || food.vertices.iter().map(|v| pan_from_rest.transform_point3(Vec3::from(v.position)));
        let middle = pan_from_rest.transform_point3(Vec3::ZERO);
        let floor = input.pan.thickness;
        if middle.truncate().length() > input.pan.floor_radius || (middle.z - floor).abs() > TALLEST {
            return None;
        }
        let bottom = points().fold(f32::INFINITY, |low, p| low.min(p.z));
        if (bottom - floor).abs() > TOUCHING {
            return None;
        }
        let middle = middle.with_z(floor + ABOVE);
        let mut reach = [0.0f32; DIRECTIONS];
        for point in points() {
            let away = (point - middle).truncate();
            let turn = away.to_angle().rem_euclid(TAU) / TAU * DIRECTIONS as f32;
            let slot = &mut reach[turn as usize % DIRECTIONS];
            *slot = slot.max(away.length());
        }
        let smooth = |k: usize| {
            let [a, b, c] = [DIRECTIONS - 1, 0, 1].map(|step| reach[(k + step) % DIRECTIONS]);
            0.25 * a + 0.5 * b + 0.25 * c
        };
        Some(Self { middle, world_from_pan, reach: std::array::from_fn(smooth) })
    }

    /// Outward direction and reach at a turn (0–1).
    fn edge(&self, turn: f32) -> (Vec2, f32) {
        let at = turn.rem_euclid(1.0) * DIRECTIONS as f32 - 0.5;
        let low = at.floor().rem_euclid(DIRECTIONS as f32) as usize % DIRECTIONS;
        let share = at - at.floor();
        let reach = self.reach[low] * (1.0 - share) + self.reach[(low + 1) % DIRECTIONS] * share;
        (Vec2::from_angle(turn * TAU), reach)
    }

    fn in_world(&self, point: Vec3) -> [f32; 3] {
        self.world_from_pan.transform_point3(point).to_array()
    }

    fn ring(&self, vertices: &mut Vec<PuffVertex>, opacity: f32) {
        let vertex = |k: usize, across: f32| {
            let (out, reach) = self.edge(k as f32 / DIRECTIONS as f32);
            let distance = reach - UNDER + across * (RING + UNDER);
            let position = self.in_world(self.middle + (out * distance).extend(0.0));
            PuffVertex { position, corner: out.to_array(), half_size: 0.0, opacity, random: -1.0 - across }
        };
        for k in 0..DIRECTIONS {
            let corners = [(k, 0.0), (k, 1.0), (k + 1, 1.0), (k, 0.0), (k + 1, 1.0), (k + 1, 0.0)];
            vertices.extend(corners.map(|(k, across)| vertex(k, across)));
        }
    }

    fn bubble(&self, vertices: &mut Vec<PuffVertex>, seed: f32, time: f32) {
        let turn = time / LIFE + seed * 0.618;
        let age = turn.rem_euclid(1.0);
        let random =
            |k: f32| ((turn.floor() * 12.9898 + seed * 78.233 + k * 37.719).sin() * 43_758.547).rem_euclid(1.0);
        let (out, reach) = self.edge(random(1.0));
        let half_size = (0.7e-3 + 1.8e-3 * random(2.0) * random(2.0)) * (0.5 + 0.5 * age);
        let distance = reach + 0.6 * half_size + 3.0e-3 * random(3.0) * random(3.0);
        let position = self.in_world(self.middle + (out * distance).extend(0.2e-3));
        let opacity = (age * 8.0).min(1.0) * ((1.0 - age) * 12.0).min(1.0);
        vertices.extend(CORNERS.map(|corner| PuffVertex { position, corner, half_size, opacity, random: random(4.0) }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Doneness, empty_pan, steak_in_pan};

    #[test]
    fn only_what_lies_in_the_pan_fries() {
        assert!(fry(&empty_pan()).is_empty());
        let mut scene = steak_in_pan(Doneness::HalfWay);
        let vertices = fry(&scene);
        assert!(!vertices.is_empty() && vertices.len() <= FRY_VERTICES_MAX);
        scene.foods[0].world_from_rest.w_axis.z += 0.05;
        assert!(fry(&scene).is_empty());
    }
}
