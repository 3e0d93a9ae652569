//! Sharp edges of a surface, chained into lines.

use std::collections::BTreeMap;

use super::Surface;
use super::defect::neighbours;
use crate::vector::{Vec3, cross, distance, dot, sub, unit};

/// Faces that meet at more than this angle meet at a sharp edge: its cosine [-] (chosen: 35°; a tessellated round has less).
const SHARP: f64 = 0.819;
/// A line of sharp edges that turns by more than this ends: its cosine [-] (chosen: 40°).
const TURN: f64 = 0.766;

/// A stretch of sharp edge between two corners, or a loop of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// Its corners in order [m].
    pub points: Vec<Vec3>,
    /// For each of its edges, the directions into the faces on both sides, across the edge.
    pub into: Vec<[Vec3; 2]>,
}

impl Feature {
    /// Length [m].
    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|w| distance(w[0], w[1])).sum()
    }

    /// The point at a length along it [m], and the directions into both faces there.
    pub fn at(&self, mut along: f64) -> (Vec3, [Vec3; 2]) {
        for (w, into) in self.points.windows(2).zip(&self.into) {
            let step = distance(w[0], w[1]);
            if along <= step {
                let share = along / step;
                return ([0, 1, 2].map(|k| w[0][k] + share * (w[1][k] - w[0][k])), *into);
            }
            along -= step;
        }
        let last = self.into.len() - 1;
        (self.points[last + 1], self.into[last])
    }
}

/// A sharp edge and the directions into its faces.
type Sharp = BTreeMap<[u32; 2], [Vec3; 2]>;

/// The sharp edges of a surface.
pub fn features(surface: &Surface) -> Vec<Feature> {
    let mut left: Sharp = BTreeMap::new();
    for (edge, [s, t]) in neighbours(surface) {
        let (m, n) = (surface.normal(s as usize), surface.normal(t as usize));
        if dot(m, n) < SHARP {
            left.insert(edge, [into(surface, edge, s as usize), into(surface, edge, t as usize)]);
        }
    }
    let mut at: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &[a, b] in left.keys() {
        at.entry(a).or_default().push(b);
        at.entry(b).or_default().push(a);
    }
    let ends: Vec<u32> = at.iter().filter(|(v, to)| ends_at(surface, **v, to)).map(|(v, _)| *v).collect();
    let starts: Vec<u32> = ends.iter().copied().chain(at.keys().copied()).collect();
    let mut features = Vec::new();
    for start in starts {
        for &next in &at[&start] {
            if left.contains_key(&key(start, next)) {
                features.push(chain(surface, [start, next], &at, &ends, &mut left));
            }
        }
    }
    features
}

fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Direction across an edge into a triangle.
fn into(surface: &Surface, [a, b]: [u32; 2], triangle: usize) -> Vec3 {
    let ids = surface.triangles[triangle];
    let third = ids.into_iter().find(|v| *v != a && *v != b).unwrap_or(a);
    let [p, q, r] = [a, b, third].map(|v| surface.vertices[v as usize]);
    let (edge, to) = (unit(sub(q, p)), sub(r, p));
    unit(cross(cross(edge, to), edge))
}

fn ends_at(surface: &Surface, v: u32, to: &[u32]) -> bool {
    let &[a, b] = to else { return true };
    let p = |i: u32| surface.vertices[i as usize];
    dot(unit(sub(p(v), p(a))), unit(sub(p(b), p(v)))) < TURN
}

/// Follows sharp edges from a corner to the next one, taking them out of what is left.
fn chain(
    surface: &Surface,
    [start, mut next]: [u32; 2],
    at: &BTreeMap<u32, Vec<u32>>,
    ends: &[u32],
    left: &mut Sharp,
) -> Feature {
    let mut feature = Feature { points: vec![surface.vertices[start as usize]], into: Vec::new() };
    let mut from = start;
    while let Some(mut sides) = left.remove(&key(from, next)) {
        // The same face stays on the same side along the line.
        if let Some(&[before, _]) = feature.into.last()
            && dot(before, sides[1]) > dot(before, sides[0])
        {
            sides.swap(0, 1);
        }
        feature.into.push(sides);
        feature.points.push(surface.vertices[next as usize]);
        if ends.contains(&next) {
            break;
        }
        let onward = at[&next].iter().copied().find(|&v| v != from);
        let Some(onward) = onward else { break };
        (from, next) = (next, onward);
    }
    feature
}
