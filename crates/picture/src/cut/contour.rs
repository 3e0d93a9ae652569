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
    /// The lines in which the surface meets a plane, given by a point [m] and its unit normal.
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
        // Lines that end somewhere begin at an end; then what is left are rings.
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
