//! Heat between foods that touch: patches of one that face patches of another.

use glam::DVec3;
use saute_food::PatchPose;

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

/// For each patch of `a` the nearest patch of `b` that faces it within reach; `b`'s pose is seen from `a`.
fn links(a: &Piece, b: &Piece, relative: &Pose) -> Vec<Link> {
    let seen = |p: &PatchPose| {
        (relative.to_world(DVec3::from_array(p.position)), relative.rotation * DVec3::from_array(p.normal))
    };
    let others: Vec<(DVec3, DVec3)> = b.patch_poses().iter().map(seen).collect();
    let (low, high) = bounds(a.patch_poses().iter().map(|p| DVec3::from_array(p.position)));
    let near: Vec<usize> = (0..others.len()).filter(|&i| within(others[i].0, low, high)).collect();
    let (low, high) = bounds(near.iter().map(|&i| others[i].0));
    let mut links = Vec::new();
    for (i, pose) in a.patch_poses().iter().enumerate() {
        let (p, n) = (DVec3::from_array(pose.position), DVec3::from_array(pose.normal));
        let area = a.patch_area(i);
        if area <= 0.0 || !within(p, low, high) {
            continue;
        }
        let facing = near.iter().copied().filter(|&j| others[j].1.dot(n) < FACING && b.patch_area(j) > 0.0);
        let nearest = facing.min_by(|&j, &k| (others[j].0 - p).length_squared().total_cmp(&(others[k].0 - p).length_squared()));
        let Some(j) = nearest else { continue };
        let way = others[j].0 - p;
        let off = way.dot(n);
        let beside = (way - off * n).length_squared();
        if off.abs() < TOUCHING && beside < area + b.patch_area(j) {
            links.push(Link { a: i as u32, b: j as u32, area });
        }
    }
    share_out(&mut links, |j| b.patch_area(j as usize));
    links
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
