//! Self-intersection of a surface, by exact orientation predicates.

use glam::DVec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

use super::defect::{Defect, Trouble};
use super::triangle_tree::TriangleTree;
use super::{MOST_TRIANGLES, Surface};
use crate::mesh::bounds::bounds;

/// Largest number of pairs of triangles whose boxes overlap [-] (measured: cooked foods have 24 for each triangle; more take
/// seconds).
const MOST_PAIRS: usize = 25 * MOST_TRIANGLES;

/// Returns the pairs of given triangles with any others that intersect; a pair of two given ones is found once.
///
/// The vertices are within `margin` [m] of their places in the tree.
///
/// # Errors
/// [`Defect::Dense`] if there are too many pairs to look at.
pub fn crossing_pairs(
    surface: &Surface,
    tree: &TriangleTree,
    given: impl Iterator<Item = usize>,
    margin: f64,
) -> Result<Vec<[u32; 2]>, Defect> {
    let mut found = Vec::new();
    let mut is_done = vec![false; surface.triangles.len()];
    let mut pairs = 0;
    for t in given {
        let [low, high] = bounds(surface.corners(t));
        let is_near = |other: usize| {
            let [l, h] = bounds(surface.corners(other));
            l.cmple(high).all() && low.cmple(h).all()
        };
        is_done[t] = true;
        tree.overlapping(low - DVec3::splat(margin), high + DVec3::splat(margin), |other| {
            pairs += 1;
            let is_open = !is_done[other as usize];
            if is_open && is_near(other as usize) && cross_each_other(surface, t, other as usize) {
                found.push([t as u32, other]);
            }
        });
        if pairs > MOST_PAIRS {
            return Err(Defect::Dense(surface.corners(t)[0].to_array()));
        }
    }
    Ok(found)
}

/// Returns the number of pairs and the first place; none without a pair.
pub fn trouble(surface: &Surface, pairs: &[[u32; 2]]) -> Option<Trouble> {
    let [first, _] = pairs.first()?;
    Some(Trouble::at(pairs.len(), surface.corners(*first as usize)[0].to_array()))
}

/// Returns the side of the plane through a, b, c on which p is, exactly: 1, 0 or −1.
fn side(a: DVec3, b: DVec3, c: DVec3, p: DVec3) -> i8 {
    let at = |v: DVec3| Coord3D { x: v.x, y: v.y, z: v.z };
    sign(orient3d(at(a), at(b), at(c), at(p)))
}

fn sign(v: f64) -> i8 {
    i8::from(v > 0.0) - i8::from(v < 0.0)
}

/// Returns true if two triangles have a common point that is no common corner or edge.
fn cross_each_other(surface: &Surface, s: usize, t: usize) -> bool {
    let (left, right) = (surface.triangles[s], surface.triangles[t]);
    let shared = left.iter().filter(|v| right.contains(v)).count();
    let (p, q) = (surface.corners(s), surface.corners(t));
    // A common corner is in the plane; the exact predicate takes longest to find that.
    let sides = [0, 1, 2].map(|k| if left.contains(&right[k]) { 0 } else { side(p[0], p[1], p[2], q[k]) });
    if sides == [0; 3] {
        return overlap_in_plane(left, right, p, q);
    }
    let on_one_side = !(sides.contains(&1) && sides.contains(&-1));
    if on_one_side && sides.iter().filter(|s| **s == 0).count() == shared {
        // The second triangle meets the plane of the first in common corners alone.
        return false;
    }
    // Two triangles with a common edge that are not coplanar have no other common point.
    shared < 2 && (pierces(left, right, p, q) || pierces(right, left, q, p))
}

/// Returns true if an edge of one triangle, without a common corner, passes through the other triangle.
fn pierces(edges_of: [u32; 3], through: [u32; 3], p: [DVec3; 3], [a, b, c]: [DVec3; 3]) -> bool {
    (0..3).any(|k| {
        let next = (k + 1) % 3;
        if through.contains(&edges_of[k]) || through.contains(&edges_of[next]) {
            return false;
        }
        let (u, v) = (p[k], p[next]);
        if side(a, b, c, u) * side(a, b, c, v) >= 0 {
            return false;
        }
        let turns = [side(u, v, a, b), side(u, v, b, c), side(u, v, c, a)];
        turns.iter().all(|&s| s >= 0) || turns.iter().all(|&s| s <= 0)
    })
}

/// Returns true if two coplanar triangles overlap beyond their common corners and edge.
fn overlap_in_plane(left: [u32; 3], right: [u32; 3], p: [DVec3; 3], q: [DVec3; 3]) -> bool {
    let normal = (p[1] - p[0]).cross(p[2] - p[0]);
    let drop = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(2);
    let flat = |v: DVec3| Coord { x: v[(drop + 1) % 3], y: v[(drop + 2) % 3] };
    let (p, q) = (p.map(flat), q.map(flat));
    let edges_cross = (0..9).any(|k| {
        let (i, j) = (k / 3, k % 3);
        properly_cross([p[i], p[(i + 1) % 3]], [q[j], q[(j + 1) % 3]])
    });
    let inside = |corner: u32, at: Coord<f64>, ids: [u32; 3], t: [Coord<f64>; 3]| {
        let turns = [0, 1, 2].map(|k| sign(orient2d(t[k], t[(k + 1) % 3], at)));
        !ids.contains(&corner) && (turns == [1; 3] || turns == [-1; 3])
    };
    edges_cross
        || (0..3).any(|k| inside(left[k], p[k], right, q) || inside(right[k], q[k], left, p))
        || folded(left, right, p, q)
}

/// Returns true if two segments cross in one inner point.
fn properly_cross([a, b]: [Coord<f64>; 2], [c, d]: [Coord<f64>; 2]) -> bool {
    let turn = |a, b, c| sign(orient2d(a, b, c));
    turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
}

/// Returns true if the third corners of two triangles with a common edge are on the same side of it.
fn folded(left: [u32; 3], right: [u32; 3], p: [Coord<f64>; 3], q: [Coord<f64>; 3]) -> bool {
    let (Some(i), Some(j)) = ((0..3).find(|&i| !right.contains(&left[i])), (0..3).find(|&j| !left.contains(&right[j])))
    else {
        return left != right;
    };
    let (a, b) = (p[(i + 1) % 3], p[(i + 2) % 3]);
    let shared = left.iter().filter(|v| right.contains(v)).count();
    shared == 2 && sign(orient2d(a, b, p[i])) == sign(orient2d(a, b, q[j]))
}
