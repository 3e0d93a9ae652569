//! Triangles over vertices of a food: clipped at a plane, refined, with normals.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use saute_kitchen::heat::mesh::surface::refine::{Vertices, halve_long_edges};
use saute_scene::input::FoodVertex;

use crate::painted::unit;

/// Most bisections of an edge [-] (chosen: an edge of 300 mm is then shorter than half a millimetre).
const HALVINGS: usize = 10;

/// A triangulated part of a surface.
#[derive(Clone, Debug)]
pub(super) struct Mesh {
    pub(super) vertices: Vec<FoodVertex>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// The vertices of a mesh in their present places.
struct Present(Vec<FoodVertex>);

impl Vertices for Present {
    fn position(&self, vertex: u32) -> DVec3 {
        Vec3::from(self.0[vertex as usize].position).as_dvec3()
    }

    fn add_middle(&mut self, a: u32, b: u32) -> u32 {
        let middle = self.0[a as usize].lerp(&self.0[b as usize], 0.5);
        self.0.push(middle);
        self.0.len() as u32 - 1
    }
}

impl Mesh {
    /// Returns a mesh without the triangles that have no area or are outside of the vertices.
    pub(super) fn new(vertices: Vec<FoodVertex>, triangles: Vec<[u32; 3]>) -> Self {
        let mut mesh = Self { vertices, triangles };
        let mut triangles = std::mem::take(&mut mesh.triangles);
        triangles.retain(|t| t.iter().all(|i| (*i as usize) < mesh.vertices.len()) && mesh.doubled(t).length() > 0.0);
        Self { triangles, ..mesh }
    }

    fn at(&self, vertex: u32) -> Vec3 {
        self.vertices[vertex as usize].position.into()
    }

    /// Normal of a triangle; its length is twice the area [m²].
    fn doubled(&self, [a, b, c]: &[u32; 3]) -> Vec3 {
        (self.at(*b) - self.at(*a)).cross(self.at(*c) - self.at(*a))
    }

    /// Area [m²].
    pub(super) fn area(&self) -> f32 {
        self.triangles.iter().map(|t| 0.5 * self.doubled(t).length()).sum()
    }

    /// Bisects edges longer than `longest` [m].
    pub(super) fn refined(self, longest: f32) -> Self {
        let (mut vertices, mut triangles) = (Present(self.vertices), self.triangles);
        for _ in 0..HALVINGS {
            if !halve_long_edges(&mut vertices, &mut triangles, f64::from(longest)) {
                break;
            }
        }
        Self::new(vertices.0, triangles)
    }

    /// Returns the part behind a plane of the rest frame, which the normal points away from.
    pub(super) fn clipped(self, point: Vec3, normal: Vec3) -> Self {
        let beyond = |v: &FoodVertex| normal.dot(Vec3::from(v.rest) - point);
        let away: Vec<f32> = self.vertices.iter().map(beyond).collect();
        let mut clip = Clip { vertices: self.vertices, away, on_edge: BTreeMap::new(), triangles: Vec::new() };
        self.triangles.iter().for_each(|t| clip.keep(t));
        Self::new(clip.vertices, clip.triangles).compact()
    }

    /// Leaves out the vertices that no triangle has.
    fn compact(self) -> Self {
        let mut place = vec![u32::MAX; self.vertices.len()];
        let mut vertices = Vec::new();
        let mut moved = |corner: u32| {
            let at = &mut place[corner as usize];
            if *at == u32::MAX {
                *at = vertices.len() as u32;
                vertices.push(self.vertices[corner as usize]);
            }
            *at
        };
        let triangles = self.triangles.iter().map(|t| t.map(&mut moved)).collect();
        Self { vertices, triangles }
    }

    /// Normals as the rest shape has them.
    pub(super) fn rest_normals(&self) -> Vec<[f32; 3]> {
        self.vertices.iter().map(|v| unit(v.normal.into())).collect()
    }

    /// Mean normals of the triangles around each vertex in the present shape.
    pub(super) fn present_normals(&self) -> Vec<[f32; 3]> {
        let mut sums = vec![Vec3::ZERO; self.vertices.len()];
        for t in &self.triangles {
            let normal = self.doubled(t);
            t.iter().for_each(|corner| sums[*corner as usize] += normal);
        }
        // A vertex whose triangles cancel keeps what it had.
        let or_rest =
            |(sum, v): (Vec3, &FoodVertex)| if sum.length() > 0.0 { unit(sum) } else { unit(v.normal.into()) };
        sums.into_iter().zip(&self.vertices).map(or_rest).collect()
    }
}

/// Triangles that are being cut off at a plane.
struct Clip {
    vertices: Vec<FoodVertex>,
    /// Distance of each vertex beyond the plane [m].
    away: Vec<f32>,
    /// Vertices where the plane cuts an edge.
    on_edge: BTreeMap<[u32; 2], u32>,
    triangles: Vec<[u32; 3]>,
}

impl Clip {
    /// Keeps the part of a triangle that is behind the plane: a triangle or a quadrilateral.
    fn keep(&mut self, t: &[u32; 3]) {
        let mut kept = Vec::with_capacity(4);
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            let [p, q] = [a, b].map(|v| self.away[v as usize] <= 0.0);
            if p {
                kept.push(a);
            }
            if p != q {
                kept.push(self.cut(a, b));
            }
        }
        for k in 2..kept.len() {
            self.triangles.push([kept[0], kept[k - 1], kept[k]]);
        }
    }

    fn cut(&mut self, a: u32, b: u32) -> u32 {
        let key = [a.min(b), a.max(b)];
        if let Some(known) = self.on_edge.get(&key) {
            return *known;
        }
        let [from, to] = key.map(|v| self.away[v as usize]);
        let share = from / (from - to);
        let vertex = self.vertices[key[0] as usize].lerp(&self.vertices[key[1] as usize], share);
        self.vertices.push(vertex);
        self.away.push(0.0);
        let index = self.vertices.len() as u32 - 1;
        self.on_edge.insert(key, index);
        index
    }
}
