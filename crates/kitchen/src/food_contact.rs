//! Heat between foods that touch: patches of one that face patches of another.

use glam::{DMat3, DVec3};

use crate::dynamics::Pose;
use crate::piece::Piece;
use crate::room::FoodContact;

/// Distance along the normal within which two patches touch [m] (chosen: a millimetre of juice and give either way).
const TOUCHING: f64 = 1.0e-3;
/// Cosine between the normals of patches that face each other [-] (chosen: 120°).
const FACING: f64 = -0.5;
/// Movement against each other below which the links stay as they are [m] (chosen: a tenth of a patch).
const SAME: f64 = 0.3e-3;

/// Two patches that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Patch of the first piece.
    pub a: u32,
    /// Patch of the second piece.
    pub b: u32,
    /// Area over which they touch [m²].
    pub area: f64,
}

/// Two pieces that touch.
#[derive(Clone, Debug)]
pub struct Touching {
    /// Keys of the pieces, ascending.
    pub pair: [u32; 2],
    /// Their patches.
    pub links: Vec<Link>,
    seen: (Pose, [u64; 2]),
}

impl Touching {
    /// The links of a pair; those of `before` where hardly anything has moved.
    pub fn between(a: &Piece, b: &Piece, before: Option<Self>) -> Self {
        let relative = b.pose.seen_from(&a.pose);
        let shapes = [a.shape_count(), b.shape_count()];
        if let Some(before) = before
            && before.seen.1 == shapes
            && (before.seen.0.position - relative.position).length() < SAME
            && (before.seen.0.rotation - relative.rotation).length() * 0.05 < SAME
        {
            return before;
        }
        Self { pair: [a.key, b.key], links: links(a, b, &relative), seen: (relative, shapes) }
    }
}

/// A patch of the second piece that may be touched, seen from the first.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    patch: u32,
    position: DVec3,
    normal: DVec3,
    area: f64,
}

/// For each patch of `a` the nearest patch of `b` that faces it within reach; `b`'s pose is seen from `a`.
fn links(a: &Piece, b: &Piece, relative: &Pose) -> Vec<Link> {
    let places = |piece: &Piece| -> Vec<DVec3> {
        piece.patch_poses().iter().map(|p| DVec3::from_array(p.position)).collect()
    };
    let (own, turn) = (places(a), DMat3::from_quat(relative.rotation));
    let (candidates, widest) = candidates(b, bounds(own.iter().copied()), relative.position, turn);
    let (low, high) = bounds(candidates.iter().map(|c| c.position));
    let sorted = Sorted::along_longest(candidates);
    let mut links = Vec::new();
    for (i, (p, pose)) in own.iter().zip(a.patch_poses()).enumerate() {
        if !within(*p, low, high) {
            continue;
        }
        let (area, n) = (a.patch_area(i), DVec3::from_array(pose.normal));
        // What lies farther off is not touched.
        let reach = libm::sqrt(TOUCHING * TOUCHING + area + widest);
        if area > 0.0
            && let Some(other) = sorted.nearest_facing(*p, n, reach)
            && touches(other.position - *p, n, area + other.area)
        {
            links.push(Link { a: i as u32, b: other.patch, area });
        }
    }
    share_out(&mut links, |j| b.patch_area(j as usize));
    links
}

fn touches(way: DVec3, normal: DVec3, areas: f64) -> bool {
    let off = way.dot(normal);
    off.abs() < TOUCHING && (way - off * normal).length_squared() < areas
}

/// Patches of a piece within a box of the other's frame, and the largest of their areas [m²].
fn candidates(b: &Piece, (low, high): (DVec3, DVec3), at: DVec3, turn: DMat3) -> (Vec<Candidate>, f64) {
    let mut found = Vec::new();
    let mut widest = 0.0f64;
    for (j, pose) in b.patch_poses().iter().enumerate() {
        let position = at + turn * DVec3::from_array(pose.position);
        let area = if within(position, low, high) { b.patch_area(j) } else { 0.0 };
        if area > 0.0 {
            widest = widest.max(area);
            found.push(Candidate { patch: j as u32, position, normal: turn * DVec3::from_array(pose.normal), area });
        }
    }
    (found, widest)
}

/// Candidates in the order of one coordinate, so that a few of them need to be looked at for each place.
struct Sorted {
    axis: usize,
    candidates: Vec<Candidate>,
}

impl Sorted {
    fn along_longest(mut candidates: Vec<Candidate>) -> Self {
        let (low, high) = bounds(candidates.iter().map(|c| c.position));
        let axis = (high - low).to_array().into_iter().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |m| m.0);
        candidates.sort_by(|p, q| p.position[axis].total_cmp(&q.position[axis]));
        Self { axis, candidates }
    }

    /// The nearest candidate within `reach` of a place that faces a normal.
    fn nearest_facing(&self, place: DVec3, normal: DVec3, reach: f64) -> Option<&Candidate> {
        let from = self.candidates.partition_point(|c| c.position[self.axis] < place[self.axis] - reach);
        let mut nearest = (reach * reach, None);
        for candidate in &self.candidates[from..] {
            if candidate.position[self.axis] > place[self.axis] + reach {
                break;
            }
            let distance = (candidate.position - place).length_squared();
            if distance < nearest.0 && candidate.normal.dot(normal) < FACING {
                nearest = (distance, Some(candidate));
            }
        }
        nearest.1
    }
}

/// No patch of the second piece touches over more than its own area.
fn share_out(links: &mut [Link], area: impl Fn(u32) -> f64) {
    let mut total = std::collections::BTreeMap::<u32, f64>::new();
    links.iter().for_each(|l| *total.entry(l.b).or_default() += l.area);
    for link in links {
        link.area *= (area(link.b) / total[&link.b]).min(1.0);
    }
}

fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let margin = DVec3::splat(2.0 * TOUCHING);
    let (low, high) = points
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (low - margin, high + margin)
}

fn within(p: DVec3, low: DVec3, high: DVec3) -> bool {
    p.cmpge(low).all() && p.cmple(high).all()
}

/// Passes heat through all links of a pair for `dt` [s]: each link brings its two nodes towards their common mean, and
/// what one gives the other gets.
pub fn exchange(data: &FoodContact, a: &mut Piece, b: &mut Piece, links: &[Link], dt: f64) {
    for link in links {
        let (i, j) = (a.node_of(link.a), b.node_of(link.b));
        let (hot, cold) = (a.state.temperature[i], b.state.temperature[j]);
        let (Some(ca), Some(cb)) = (a.capacity(i), b.capacity(j)) else { continue };
        let conductance = data.conductance_w_m2k * link.area * dt;
        let heat = conductance * (hot - cold) / (1.0 + conductance * (1.0 / ca + 1.0 / cb));
        a.give(i, -heat);
        b.give(j, heat);
    }
}
