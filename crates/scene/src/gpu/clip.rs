//! Clips the outside of a food at the plane of a cut: its edge then is in the plane, smooth and without holes.

use std::collections::HashMap;

use glam::Vec3;

use crate::input::{FoodLook, FoodVertex, SliceLook};

/// The outside of a food, parted by a plane.
#[derive(Debug, Default)]
pub(crate) struct Parted {
    /// All vertices: those of the food, then those on the plane.
    pub vertices: Vec<FoodVertex>,
    /// Triangles that are seen, and those that the cut hides.
    pub kept: Vec<[u32; 3]>,
    pub hidden: Vec<[u32; 3]>,
}

impl Parted {
    pub(crate) fn new(food: &FoodLook, slice: &SliceLook) -> Self {
        let vertices = food.vertices.as_slice();
        let height = |v: &FoodVertex| (Vec3::from(v.rest) - slice.point).dot(slice.normal);
        let mut parting = Parting {
            heights: vertices.iter().map(height).collect(),
            between: HashMap::new(),
            parted: Self { vertices: vertices.to_vec(), ..Self::default() },
        };
        let fits = |t: &&[u32; 3]| t.iter().all(|i| (*i as usize) < vertices.len());
        food.mesh.triangles.iter().filter(fits).for_each(|t| parting.part(*t));
        parting.parted
    }
}

/// Work of parting: heights over the plane [m], and the vertex made on each edge that crosses it.
struct Parting {
    heights: Vec<f32>,
    between: HashMap<(u32, u32), u32>,
    parted: Parted,
}

impl Parting {
    fn part(&mut self, triangle: [u32; 3]) {
        let above = triangle.map(|i| self.heights[i as usize] > 0.0);
        match above {
            [false, false, false] => self.parted.kept.push(triangle),
            [true, true, true] => self.parted.hidden.push(triangle),
            _ => self.cross(triangle, above),
        }
    }

    /// Parts a triangle with one corner on the other side than the rest.
    fn cross(&mut self, t: [u32; 3], above: [bool; 3]) {
        let alone = (0..3).find(|&k| above[k] != above[(k + 1) % 3] && above[k] != above[(k + 2) % 3]).unwrap_or(0);
        let [a, b, c] = [0, 1, 2].map(|k| t[(alone + k) % 3]);
        let (ab, ac) = (self.on_plane(a, b), self.on_plane(a, c));
        let (tip, rest) = ([a, ab, ac], [[ab, b, c], [ab, c, ac]]);
        if above[alone] {
            self.parted.hidden.push(tip);
            self.parted.kept.extend(rest);
        } else {
            self.parted.kept.push(tip);
            self.parted.hidden.extend(rest);
        }
    }

    /// The vertex where an edge meets the plane; one for both of its triangles.
    fn on_plane(&mut self, a: u32, b: u32) -> u32 {
        let (low, high) = (a.min(b), a.max(b));
        if let Some(known) = self.between.get(&(low, high)) {
            return *known;
        }
        let [from, to] = [low, high].map(|i| self.heights[i as usize]);
        let [v, w] = [low, high].map(|i| self.parted.vertices[i as usize]);
        let made = self.parted.vertices.len() as u32;
        self.parted.vertices.push(v.lerp(&w, from / (from - to)));
        self.between.insert((low, high), made);
        made
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{self, Doneness};

    #[test]
    fn both_parts_of_a_clipped_food_end_in_the_plane_and_make_up_the_whole() {
        let food = sample::steak_in_pan(Doneness::Raw).foods.remove(0);
        let slice = SliceLook {
            point: Vec3::new(0.003, 0.0, 0.0),
            normal: Vec3::X,
            vertices: Vec::new(),
            triangles: Vec::new(),
            ghost: false,
        };
        let parted = Parted::new(&food, &slice);
        let rest = |i: u32| Vec3::from(parted.vertices[i as usize].rest);
        let area = |ts: &[[u32; 3]]| -> f32 {
            ts.iter().map(|t| (rest(t[1]) - rest(t[0])).cross(rest(t[2]) - rest(t[0])).length()).sum()
        };
        let whole = area(&food.mesh.triangles);
        assert!((area(&parted.kept) + area(&parted.hidden) - whole).abs() < 1e-4 * whole);
        assert!(parted.kept.iter().flatten().all(|i| rest(*i).x <= slice.point.x + 1e-6));
        assert!(parted.hidden.iter().flatten().all(|i| rest(*i).x >= slice.point.x - 1e-6));
        assert!(!parted.kept.is_empty() && !parted.hidden.is_empty());
    }
}
