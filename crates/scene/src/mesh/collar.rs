//! The collar of bubbles and juice round what fries: a strip along the edge of every foot, as wide as its steam requires.

use std::sync::Arc;

use glam::{Mat4, Vec2};

use crate::input::{FILM_SIZE, FoodLook, FoodVertex, OIL_RANGE, PanLook, SceneInput, WATER_RANGE};
use crate::mesh::foot::{CELL, Foot, FootGrid, Near};
use crate::mesh::stays::{same_shape, stays};
use crate::mesh::steam::PuffVertex;

/// Cells of the grid that are drawn, at most (chosen: the floor of a pan of 30 cm).
const CELLS_MAX: usize = 12_000;
/// Vertices of all cells, at most.
pub(crate) const COLLAR_VERTICES_MAX: usize = CELLS_MAX * 6;

/// The liquid is this much above the floor [m]: what is in it is drawn over the floor.
const ABOVE: f32 = 4e-4;
/// The dark film of juice at the foot reaches so far [m] (chosen).
const FILM: f32 = 3.5e-3;
/// Steam along the edge of a steak that sears [g/(s m)], and the width of its collar in a film of oil [m] (chosen).
const SEARING: f32 = 0.11;
const SEARED_WIDTH: f32 = 5.2e-3;
/// Widest collar in a film [m] (chosen).
const WIDEST: f32 = 8e-3;
/// Liquid in which the collar is as wide as in any film [m] (chosen), and depth that makes it twice as wide, for the
/// bubbles rise through it.
const FULL_FILM: f32 = 0.12e-3;
const DOUBLING_DEPTH: f32 = 5e-3;
/// Share of the collar that is there without a film, in the juice alone (chosen).
const DRY: f32 = 0.35;

/// Strips round the foods that lie in the pan, kept from frame to frame as long as nothing moves.
#[derive(Debug, Default)]
pub(crate) struct Collar {
    feet: Vec<KeptFoot>,
    /// Pan's floor radius and pose, edge and width of every foot: what the strips were made for.
    made_for: Option<(f32, Mat4)>,
    strips: Vec<PuffVertex>,
}

/// A foot and what it was found for.
#[derive(Debug)]
struct KeptFoot {
    vertices: Arc<Vec<FoodVertex>>,
    /// The last ones that were seen to have the same shape.
    shown: Arc<Vec<FoodVertex>>,
    pan_from_rest: Mat4,
    foot: Option<Foot>,
    /// Width of its collar, in steps.
    width: f32,
}

/// Steps of the width of a collar [m] (chosen: a finer change is not seen).
const WIDTH_STEP: f32 = 2.5e-4;

impl Collar {
    /// Returns the strips of a scene.
    pub fn strips(&mut self, input: &SceneInput) -> &[PuffVertex] {
        let mut same = self.feet.len() == input.foods.len();
        let mut old = std::mem::take(&mut self.feet).into_iter();
        for food in &input.foods {
            let (foot, changed) = KeptFoot::updated(old.next(), food, &input.pan);
            same &= !changed;
            self.feet.push(foot);
        }
        let place = (input.pan.floor_radius, input.pan.world_from_pan());
        if !same || self.made_for != Some(place) {
            self.strips = self.made(input);
            self.made_for = Some(place);
        }
        &self.strips
    }

    fn made(&self, input: &SceneInput) -> Vec<PuffVertex> {
        let mut grid = FootGrid::over(input.pan.floor_radius);
        let found: Vec<_> = self.feet.iter().filter_map(|kept| Some((kept.foot.as_ref()?, kept.width))).collect();
        for (foot, width) in &found {
            grid.add(foot, width.max(FILM), *width);
        }
        if found.is_empty() { Vec::new() } else { strips(&grid, input) }
    }
}

impl KeptFoot {
    /// The foot of a food, found again if it has moved; true if its collar is another one.
    fn updated(old: Option<Self>, food: &FoodLook, pan: &PanLook) -> (Self, bool) {
        let pan_from_rest = pan.world_from_pan().inverse() * food.world_from_rest;
        let kept = old.filter(|kept| stays(&kept.pan_from_rest, &pan_from_rest));
        let kept = kept.and_then(|kept| kept.with_shape_of(food));
        let before = kept.as_ref().map(|kept| kept.width);
        let mut kept = kept.unwrap_or_else(|| Self::found(food, pan, pan_from_rest));
        kept.width = kept.foot.as_ref().map_or(0.0, |foot| {
            let width = width(food.steam_g_s / foot.length, liquid(pan, foot.edge[foot.edge.len() / 2][0]));
            (width / WIDTH_STEP).round() * WIDTH_STEP
        });
        let changed = before != Some(kept.width);
        (kept, changed)
    }

    fn found(food: &FoodLook, pan: &PanLook, pan_from_rest: Mat4) -> Self {
        let foot = Foot::of(food, pan, pan_from_rest);
        let vertices = Arc::clone(&food.vertices);
        Self { shown: Arc::clone(&vertices), vertices, pan_from_rest, foot, width: 0.0 }
    }

    /// Itself if a food has the shape for which the foot was found, whatever its colours are now.
    fn with_shape_of(self, food: &FoodLook) -> Option<Self> {
        if Arc::ptr_eq(&self.shown, &food.vertices) {
            return Some(self);
        }
        same_shape(&self.vertices, &food.vertices).then(|| Self { shown: Arc::clone(&food.vertices), ..self })
    }
}

/// Width of the collar [m]; `flow` is steam along the edge [g/(s m)], `depth` that of the liquid [m]. Twice the steam
/// is in half as many more bubbles, for larger ones rise faster.
fn width(flow: f32, depth: f32) -> f32 {
    let wet = DRY + (1.0 - DRY) * (depth / FULL_FILM).min(1.0);
    (SEARED_WIDTH * (flow.max(0.0) / SEARING).sqrt() * wet).min(WIDEST) * (1.0 + depth / DOUBLING_DEPTH)
}

/// Depth of oil and water at a place of the floor [m].
fn liquid(pan: &PanLook, place: Vec2) -> f32 {
    let texel = ((place / pan.floor_radius * 0.5 + 0.5) * FILM_SIZE as f32)
        .clamp(Vec2::ZERO, Vec2::splat(FILM_SIZE as f32 - 1.0));
    let at = texel.y as usize * FILM_SIZE as usize + texel.x as usize;
    let depth = |byte: u8, range: f32| (f32::from(byte) / 255.0).powi(2) * range;
    pan.film.texels.get(at).map_or(0.0, |t| depth(t[0], OIL_RANGE) + depth(t[1], WATER_RANGE))
}

fn strips(grid: &FootGrid, input: &SceneInput) -> Vec<PuffVertex> {
    let world_from_pan = input.pan.world_from_pan();
    let vertex = |at: [usize; 2], near: &Near| {
        let place = grid.place(at).extend(input.pan.thickness + ABOVE);
        let position = world_from_pan.transform_point3(place).to_array();
        PuffVertex { position, corner: near.away.to_array(), half_size: 0.0, opacity: near.bubbles, random: -1.0 }
    };
    let mut vertices = Vec::new();
    let floor = input.pan.floor_radius - CELL;
    for j in 0..grid.side - 1 {
        for i in 0..grid.side - 1 {
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            let near = corners.map(|[i, j]| grid.points[j * grid.side + i]);
            let reached = near.iter().any(|n| n.reach > 0.0 && n.away.length() < n.reach);
            let hidden = near.iter().all(|n| !n.outside);
            if !reached || hidden || near.iter().any(|n| n.reach == 0.0) || grid.place([i, j]).length() > floor {
                continue;
            }
            vertices.extend([0, 1, 2, 0, 2, 3].map(|k: usize| vertex(corners[k], &near[k])));
        }
    }
    vertices.truncate(COLLAR_VERTICES_MAX);
    vertices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Doneness, empty_pan, steak_in_pan};

    #[test]
    fn only_what_lies_in_the_pan_has_a_collar() {
        let mut collar = Collar::default();
        assert!(collar.strips(&empty_pan()).is_empty());
        let mut scene = steak_in_pan(Doneness::HalfWay);
        assert!(!collar.strips(&scene).is_empty() && collar.strips.len() <= COLLAR_VERTICES_MAX);
        scene.foods[0].world_from_rest.w_axis.z += 0.05;
        assert!(collar.strips(&scene).is_empty());
    }

    #[test]
    fn kept_strips_are_those_of_a_new_collar_whatever_moves() {
        let mut kept = Collar::default();
        let mut scene = steak_in_pan(Doneness::HalfWay);
        let mut all = Vec::new();
        for step in 0..6 {
            match step {
                1 => scene.foods[0].world_from_rest.w_axis.x += 0.01,
                2 => scene.pan.position.y += 0.02,
                3 => scene.foods[0].steam_g_s *= 0.3,
                4 => scene.pan.film = empty_film(),
                5 => scene.foods.push(scene.foods[0].clone()),
                _ => (),
            }
            let strips = bytemuck::cast_slice::<_, u8>(kept.strips(&scene)).to_vec();
            assert_eq!(strips, bytemuck::cast_slice::<_, u8>(Collar::default().strips(&scene)), "step {step}");
            all.push(strips);
        }
        assert!(all[..5].windows(2).all(|pair| pair[0] != pair[1]), "each step but the last changes it");
    }

    #[test]
    fn a_foot_is_found_anew_where_the_shape_or_the_place_is_another_not_where_colours_are() {
        let mut scene = steak_in_pan(Doneness::HalfWay);
        let mut collar = Collar::default();
        let mut is_found_for = |scene: &SceneInput, vertices: &Arc<Vec<FoodVertex>>| {
            collar.strips(scene);
            Arc::ptr_eq(&collar.feet[0].vertices, vertices)
        };
        let first = Arc::clone(&scene.foods[0].vertices);
        assert!(is_found_for(&scene, &first));
        Arc::make_mut(&mut scene.foods[0].vertices)[0].browning += 0.1;
        let browned = Arc::clone(&scene.foods[0].vertices);
        assert!(is_found_for(&scene, &first) && is_found_for(&scene, &first), "browned");
        scene.foods[0].world_from_rest.w_axis.x += 1e-3;
        assert!(is_found_for(&scene, &browned), "moved");
        Arc::make_mut(&mut scene.foods[0].vertices).iter_mut().for_each(|v| v.position[0] *= 0.98);
        assert!(is_found_for(&scene, &scene.foods[0].vertices), "shrunk");
    }

    fn empty_film() -> Arc<crate::input::FilmPicture> {
        Arc::new(crate::input::FilmPicture { texels: vec![[0; 4]; (FILM_SIZE * FILM_SIZE) as usize] })
    }

    #[test]
    fn the_collar_follows_the_steam_and_the_depth_of_the_oil() {
        assert!(width(0.16, 1e-3) > 1.3 * width(0.08, 1e-3));
        assert!(width(0.15, 10e-3) > 2.0 * width(0.15, 1e-3));
        assert!(width(0.15, 0.0) < 0.5 * width(0.15, 0.3e-3));
        assert_eq!(width(0.0, 1e-3), 0.0);
    }
}
