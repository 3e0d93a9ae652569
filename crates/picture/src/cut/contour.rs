//! Where the drawn surface of a food meets the plane of a cut, as open lines of vertices.

use std::collections::BTreeMap;

use glam::Vec3;
use saute_scene::input::FoodVertex;

/// The drawn surface of a food.
#[derive(Clone, Copy)]
pub(crate) struct Outside<'a> {
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) vertices: &'a [FoodVertex],
}

impl Outside<'_> {
    /// The lines in which the surface meets a plane, given by a point [m] and its unit normal; those that close on themselves
    /// are left out, as faces and sides end at an edge.
    pub(crate) fn contour(&self, point: Vec3, normal: Vec3) -> Vec<Vec<FoodVertex>> {
        let height = |i: u32| (Vec3::from(self.vertices[i as usize].rest) - point).dot(normal);
        let mut beside: BTreeMap<[u32; 2], Vec<[u32; 2]>> = BTreeMap::new();
        for t in self.triangles {
            let sides = [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]].map(|[a, b]| [a.min(b), a.max(b)]);
            let mut met = sides.into_iter().filter(|[a, b]| (height(*a) > 0.0) != (height(*b) > 0.0));
            if let (Some(from), Some(to)) = (met.next(), met.next()) {
                beside.entry(from).or_default().push(to);
                beside.entry(to).or_default().push(from);
            }
        }
        let at = |[a, b]: [u32; 2]| {
            let (from, to) = (height(a), height(b));
            self.vertices[a as usize].lerp(&self.vertices[b as usize], from / (from - to))
        };
        let mut lines = Vec::new();
        let ends: Vec<[u32; 2]> = beside.iter().filter(|(_, next)| next.len() == 1).map(|(side, _)| *side).collect();
        for start in ends {
            let line = walk(&mut beside, start);
            if line.len() > 1 {
                lines.push(line.into_iter().map(at).collect());
            }
        }
        lines
    }
}

/// Follows a line from side to side and takes it out.
fn walk(beside: &mut BTreeMap<[u32; 2], Vec<[u32; 2]>>, start: [u32; 2]) -> Vec<[u32; 2]> {
    let (mut line, mut here) = (Vec::new(), Some(start));
    while let Some(side) = here {
        line.push(side);
        let next = beside.remove(&side).unwrap_or_default();
        here = next.into_iter().find(|side| beside.contains_key(side));
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contour_of_a_wall_runs_from_edge_to_edge_through_every_triangle() {
        let vertex =
            |x: f32, y: f32| FoodVertex { rest: [x, y, 0.0], browning: 0.5 + 0.5 * x, ..FoodVertex::default() };
        // Three quads side by side, of which the plane x = 0 halves each.
        let vertices: Vec<FoodVertex> = (0..4).flat_map(|row| [-1.0, 1.0].map(|x| vertex(x, row as f32))).collect();
        let quad = |row: u32| [[2 * row, 2 * row + 1, 2 * row + 3], [2 * row, 2 * row + 3, 2 * row + 2]];
        let triangles: Vec<[u32; 3]> = (0..3).flat_map(quad).collect();
        let outside = Outside { triangles: &triangles, vertices: &vertices };
        let lines = outside.contour(Vec3::ZERO, Vec3::X);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].len(), 7, "four edges and three diagonals");
        assert!(lines[0].iter().all(|v| v.rest[0].abs() < 1e-6 && (v.browning - 0.5).abs() < 1e-6));
        let apart = lines[0].windows(2).map(|pair| (pair[1].rest[1] - pair[0].rest[1]).abs());
        assert!(apart.into_iter().all(|step| (step - 0.5).abs() < 1e-6));
        assert!(outside.contour(Vec3::X * 2.0, Vec3::X).is_empty());
    }
}
