//! The collar of bubbles and juice round what fries: a strip along the edge of every foot, as wide as its steam asks.

use glam::Vec2;

use crate::input::{FILM_SIZE, OIL_RANGE, PanLook, SceneInput, WATER_RANGE};
use crate::mesh::foot::{CELL, Foot, FootGrid, Near};
use crate::mesh::steam::PuffVertex;

/// Cells of the grid that are drawn, at most (chosen: the floor of a pan of 30 cm).
const CELLS_MAX: usize = 12_000;
/// Vertices of all cells, at most.
pub(crate) const COLLAR_VERTICES_MAX: usize = CELLS_MAX * 6;

/// The liquid stands this much above the floor [m]: what lies in it is drawn over the floor.
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
/// Share of the collar that stands without a film, in the juice alone (chosen).
const DRY: f32 = 0.35;

/// Strips round the foods that lie in the pan.
pub(crate) fn collar(input: &SceneInput) -> Vec<PuffVertex> {
    let mut grid = FootGrid::over(input.pan.floor_radius);
    let mut any = false;
    for food in &input.foods {
        let Some(foot) = Foot::of(food, &input.pan) else { continue };
        let place = foot.edge[foot.edge.len() / 2][0];
        let width = width(food.steam_g_s / foot.length, liquid(&input.pan, place));
        grid.add(&foot, width.max(FILM), width);
        any = true;
    }
    if any { strips(&grid, input) } else { Vec::new() }
}

/// Width of the collar [m]; `flow` is steam along the edge [g/(s m)], `depth` that of the liquid [m]. Twice the steam
/// stands in half as many more bubbles, for larger ones rise faster.
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
        assert!(collar(&empty_pan()).is_empty());
        let mut scene = steak_in_pan(Doneness::HalfWay);
        let vertices = collar(&scene);
        assert!(!vertices.is_empty() && vertices.len() <= COLLAR_VERTICES_MAX);
        scene.foods[0].world_from_rest.w_axis.z += 0.05;
        assert!(collar(&scene).is_empty());
    }

    #[test]
    fn the_collar_follows_the_steam_and_the_depth_of_the_oil() {
        assert!(width(0.16, 1e-3) > 1.3 * width(0.08, 1e-3));
        assert!(width(0.15, 10e-3) > 2.0 * width(0.15, 1e-3));
        assert!(width(0.15, 0.0) < 0.5 * width(0.15, 0.3e-3));
        assert_eq!(width(0.0, 1e-3), 0.0);
    }
}
