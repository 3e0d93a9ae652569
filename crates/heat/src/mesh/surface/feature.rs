//! Sharp edges of a surface, chained into polylines.

use std::collections::BTreeMap;

use glam::DVec3;

use super::Surface;
use super::defect::neighbours;

/// Cosine of the angle between face normals above which an edge is sharp [-] (chosen: 35°; more than in a tessellated round).
const SHARP: f64 = 0.819;
/// Cosine of the turning angle at which a polyline of sharp edges ends [-] (chosen: 40°).
const TURN: f64 = 0.766;

/// A polyline of sharp edges between two corners, or a closed loop [m].
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// Its vertices in order [m].
    pub points: Vec<DVec3>,
    /// For each edge, the unit directions perpendicular to it into both adjacent faces [-].
    pub into: Vec<[DVec3; 2]>,
}

impl Feature {
    /// Returns the length [m].
    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|w| w[0].distance(w[1])).sum()
    }

    /// Returns the point at an arc length [m], with the directions into both faces there [-].
    pub fn at(&self, mut along: f64) -> (DVec3, [DVec3; 2]) {
        for (w, into) in self.points.windows(2).zip(&self.into) {
            let step = w[0].distance(w[1]);
            if along <= step {
                let share = along / step;
                return (w[0] + share * (w[1] - w[0]), *into);
            }
            along -= step;
        }
        let last = self.into.len() - 1;
        (self.points[last + 1], self.into[last])
    }
}

/// Sharp edges with the directions into their faces [-].
type Sharp = BTreeMap<[u32; 2], [DVec3; 2]>;

/// Returns the sharp edges of a surface as polylines [m].
pub fn features(surface: &Surface) -> Vec<Feature> {
    let mut left: Sharp = BTreeMap::new();
    for (edge, [s, t]) in neighbours(surface) {
        let (m, n) = (surface.normal(s as usize), surface.normal(t as usize));
        if m.dot(n) < SHARP {
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

/// Returns the key of an edge: its vertices in ascending order.
fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Returns the unit direction perpendicular to an edge into a triangle [-].
fn into(surface: &Surface, [a, b]: [u32; 2], triangle: usize) -> DVec3 {
    let ids = surface.triangles[triangle];
    let third = ids.into_iter().find(|v| *v != a && *v != b).unwrap_or(a);
    let [p, q, r] = [a, b, third].map(|v| surface.vertex(v));
    let edge = (q - p).normalize_or_zero();
    edge.cross(r - p).cross(edge).normalize_or_zero()
}

/// Returns true if a polyline ends at a vertex: a branch, an open end or a sharp turn.
fn ends_at(surface: &Surface, v: u32, to: &[u32]) -> bool {
    let &[a, b] = to else { return true };
    let p = |i: u32| surface.vertex(i);
    (p(v) - p(a)).normalize_or_zero().dot((p(b) - p(v)).normalize_or_zero()) < TURN
}

/// Returns the polyline of sharp edges from a vertex to its end, and removes these edges from `left`.
fn chain(
    surface: &Surface,
    [start, mut next]: [u32; 2],
    at: &BTreeMap<u32, Vec<u32>>,
    ends: &[u32],
    left: &mut Sharp,
) -> Feature {
    let mut feature = Feature { points: vec![surface.vertex(start)], into: Vec::new() };
    let mut from = start;
    while let Some(mut sides) = left.remove(&key(from, next)) {
        // The same face stays on the same side along the polyline.
        if let Some(&[before, _]) = feature.into.last()
            && before.dot(sides[1]) > before.dot(sides[0])
        {
            sides.swap(0, 1);
        }
        feature.into.push(sides);
        feature.points.push(surface.vertex(next));
        if ends.contains(&next) {
            break;
        }
        let onward = at[&next].iter().copied().find(|&v| v != from);
        let Some(onward) = onward else { break };
        (from, next) = (next, onward);
    }
    feature
}
