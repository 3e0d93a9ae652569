//! Where foods meet the floor of the pan: on a grid, the way from the nearest edge of a foot.

use glam::{IVec3, Mat4, Vec2, Vec3};

use crate::input::{FoodLook, PanLook};

/// Distance between the points of the grid [m] (chosen: half the narrowest collar that is seen).
pub(crate) const CELL: f32 = 2.5e-3;
/// What is further above the floor does not touch it [m] (chosen).
const TOUCHING: f32 = 2.5e-3;
/// Vertices this close are one [m] (chosen: a crease has several at one place).
const WELD: f32 = 2e-5;

/// The edge of one food's foot in the pan's frame. Triangles run counter-clockwise as seen from outside, so the food
/// lies to the right of its edge.
#[derive(Debug)]
pub(crate) struct Foot {
    /// Segments of the edge on the floor [m].
    pub edge: Vec<[Vec2; 2]>,
    /// Length of the edge [m].
    pub length: f32,
}

impl Foot {
    /// Finds the triangles of a food that touch the floor, and the edge round them; none if nothing touches.
    pub fn of(food: &FoodLook, pan: &PanLook, pan_from_rest: Mat4) -> Option<Self> {
        let middle = pan_from_rest.transform_point3(Vec3::ZERO);
        if middle.truncate().length() > pan.rim_radius {
            return None;
        }
        let points: Vec<Vec3> =
            food.vertices.iter().map(|v| pan_from_rest.transform_point3(Vec3::from(v.position))).collect();
        let touches = |k: &u32| points[*k as usize].z < pan.thickness + TOUCHING;
        let mut sides: Vec<[IVec3; 2]> = Vec::new();
        for triangle in food.mesh.triangles.iter().filter(|t| t.iter().all(touches)) {
            let [a, b, c] = triangle.map(|k| (points[k as usize] / WELD).round().as_ivec3());
            sides.extend([[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| a != b));
        }
        sides.sort_unstable_by_key(order);
        let is_open = |[a, b]: &&[IVec3; 2]| sides.binary_search_by_key(&order(&[*b, *a]), order).is_err();
        let place = |at: IVec3| at.truncate().as_vec2() * WELD;
        let edge: Vec<_> = sides.iter().filter(is_open).map(|side| side.map(place)).collect();
        let length = edge.iter().map(|[a, b]| a.distance(*b)).sum();
        (length > 0.0).then_some(Self { edge, length })
    }
}

fn order(side: &[IVec3; 2]) -> [[i32; 3]; 2] {
    side.map(|at| at.to_array())
}

/// A point of the grid.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Near {
    /// Way from the nearest edge [m].
    pub away: Vec2,
    /// How far that foot makes itself felt [m]; 0 where no foot is near.
    pub reach: f32,
    /// Width of the bubbles round it [m].
    pub bubbles: f32,
    /// True if the point is outside of that foot.
    pub outside: bool,
}

/// The grid over the floor of a pan.
pub(crate) struct FootGrid {
    /// Points along each side.
    pub side: usize,
    /// Points, x fastest, from the corner with the lowest x and y.
    pub points: Vec<Near>,
}

impl FootGrid {
    /// Makes the grid for a floor without food.
    pub fn over(floor_radius: f32) -> Self {
        let side = 2 * (floor_radius / CELL).ceil() as usize + 1;
        Self { side, points: vec![Near::default(); side * side] }
    }

    /// Place of a point in the pan's frame [m].
    pub fn place(&self, [i, j]: [usize; 2]) -> Vec2 {
        (Vec2::new(i as f32, j as f32) - 0.5 * (self.side - 1) as f32) * CELL
    }

    /// Adds a foot that makes itself felt so far, with bubbles of a width [m].
    pub fn add(&mut self, foot: &Foot, reach: f32, bubbles: f32) {
        for side in &foot.edge {
            self.add_side(side, reach, bubbles);
        }
    }

    fn add_side(&mut self, [a, b]: &[Vec2; 2], reach: f32, bubbles: f32) {
        let [low, high] = [a.min(*b) - reach - CELL, a.max(*b) + reach + CELL].map(|p| p / CELL);
        let index = |v: f32| (v + 0.5 * (self.side - 1) as f32).clamp(0.0, self.side as f32);
        let (columns, rows) =
            (index(low.x) as usize..index(high.x) as usize, index(low.y) as usize..index(high.y) as usize);
        for j in rows {
            for i in columns.clone() {
                let place = self.place([i, j]);
                let away = from_segment(place, *a, *b);
                let near = &mut self.points[j * self.side + i];
                if near.reach == 0.0 || away.length_squared() < near.away.length_squared() {
                    *near = Near { away, reach, bubbles, outside: (*b - *a).perp_dot(place - *a) > 0.0 };
                }
            }
        }
    }
}

/// Way to a point from the nearest point of a segment.
fn from_segment(point: Vec2, a: Vec2, b: Vec2) -> Vec2 {
    let along = b - a;
    let share = ((point - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    point - (a + along * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::SceneInput;
    use crate::sample::{Doneness, steak_in_pan};

    fn found(scene: &SceneInput) -> Option<Foot> {
        let food = &scene.foods[0];
        Foot::of(food, &scene.pan, scene.pan.world_from_pan().inverse() * food.world_from_rest)
    }

    #[test]
    fn the_grid_holds_the_way_from_the_edge() {
        let scene = steak_in_pan(Doneness::HalfWay);
        let foot = found(&scene).expect("the steak touches");
        // The painted steak is 120 × 80 mm with round corners.
        assert!((0.28..0.40).contains(&foot.length), "{}", foot.length);
        let mut grid = FootGrid::over(scene.pan.floor_radius);
        grid.add(&foot, 0.005, 0.005);
        for j in 0..grid.side {
            for i in 0..grid.side {
                let near = grid.points[j * grid.side + i];
                let place = grid.place([i, j]);
                let exact =
                    foot.edge.iter().map(|[a, b]| from_segment(place, *a, *b).length()).fold(f32::MAX, f32::min);
                if exact < 0.005 {
                    assert!((near.away.length() - exact).abs() < 1e-6, "{near:?} at {place}");
                }
            }
        }
    }

    #[test]
    fn what_is_lifted_has_no_foot() {
        let mut scene = steak_in_pan(Doneness::HalfWay);
        scene.foods[0].world_from_rest.w_axis.z += 0.05;
        assert!(found(&scene).is_none());
    }
}
