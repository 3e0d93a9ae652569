//! Contact conductance between pieces: links between patches of one that face patches of another.

use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

use crate::data::room::FoodContact;
use crate::dynamics::Pose;
use crate::piece::piece_state::Piece;

/// Distance along the normal within which two patches are in contact [m] (chosen: 1 mm of juice and compliance).
const TOUCHING: f64 = 1.0e-3;
/// Largest cosine between the normals of patches that face each other [-] (chosen: 120°).
const FACING: f64 = -0.5;
/// Relative displacement below which links are reused [m] (chosen: a tenth of a patch).
const SAME: f64 = 0.3e-3;

/// Two patches in contact.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Link {
    /// Patch of the first piece.
    pub a: u32,
    /// Patch of the second piece.
    pub b: u32,
    /// Area of contact [m²].
    pub area: f64,
}

/// Two pieces in contact.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Touching {
    /// Keys of the pieces, ascending.
    pub pair: [u32; 2],
    /// Their patches.
    pub links: Vec<Link>,
    seen: (Pose, [u64; 2]),
}

impl Touching {
    /// Finds the links of a pair; returns `before` if the relative pose and both shapes are almost unchanged.
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

/// A patch of the second piece near the first, in the frame of the first.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    patch: u32,
    position: DVec3,
    normal: DVec3,
    area: f64,
}

/// Links each patch of `a` to the nearest patch of `b` that faces it within reach; `relative` is the pose of `b` in the
/// frame of `a`.
fn links(a: &Piece, b: &Piece, relative: &Pose) -> Vec<Link> {
    let places =
        |piece: &Piece| -> Vec<DVec3> { piece.patch_poses().iter().map(|p| DVec3::from_array(p.position)).collect() };
    let (own, turn) = (places(a), DMat3::from_quat(relative.rotation));
    let reach = libm::sqrt(TOUCHING * TOUCHING + widest(a) + widest(b));
    let candidates = candidates(b, bounds(own.iter().copied(), reach), relative.position, turn);
    let (low, high) = bounds(candidates.iter().map(|c| c.position), reach);
    let sorted = Sorted::along_longest(candidates);
    let mut links = Vec::new();
    for (i, (p, pose)) in own.iter().zip(a.patch_poses()).enumerate() {
        if !within(*p, low, high) {
            continue;
        }
        let (area, n) = (a.patch_area(i), DVec3::from_array(pose.normal));
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

/// Largest area of a patch [m²].
fn widest(piece: &Piece) -> f64 {
    (0..piece.patch_poses().len()).map(|i| piece.patch_area(i)).fold(0.0, f64::max)
}

/// Returns true if two patches at offset `way` [m] are in contact, given the sum of their areas [m²].
fn touches(way: DVec3, normal: DVec3, areas: f64) -> bool {
    let off = way.dot(normal);
    off.abs() < TOUCHING && (way - off * normal).length_squared() < areas
}

/// Patches of a piece inside a box of the other's frame.
fn candidates(b: &Piece, (low, high): (DVec3, DVec3), at: DVec3, turn: DMat3) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (j, pose) in b.patch_poses().iter().enumerate() {
        let position = at + turn * DVec3::from_array(pose.position);
        let area = if within(position, low, high) { b.patch_area(j) } else { 0.0 };
        if area > 0.0 {
            found.push(Candidate { patch: j as u32, position, normal: turn * DVec3::from_array(pose.normal), area });
        }
    }
    found
}

/// Candidates sorted along one axis: a query visits only those within reach along it.
struct Sorted {
    axis: usize,
    candidates: Vec<Candidate>,
}

impl Sorted {
    fn along_longest(mut candidates: Vec<Candidate>) -> Self {
        let (low, high) = bounds(candidates.iter().map(|c| c.position), 0.0);
        let axis =
            (high - low).to_array().into_iter().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |m| m.0);
        candidates.sort_by(|p, q| p.position[axis].total_cmp(&q.position[axis]));
        Self { axis, candidates }
    }

    /// Returns the nearest candidate within `reach` of a place that faces a normal.
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

/// Limits the sum of the contact areas of each patch of the second piece to its own area.
fn share_out(links: &mut [Link], area: impl Fn(u32) -> f64) {
    let mut total = std::collections::BTreeMap::<u32, f64>::new();
    links.iter().for_each(|l| *total.entry(l.b).or_default() += l.area);
    for link in links {
        link.area *= (area(link.b) / total[&link.b]).min(1.0);
    }
}

/// Bounding box of points with a margin [m].
fn bounds(points: impl Iterator<Item = DVec3>, margin: f64) -> (DVec3, DVec3) {
    let margin = DVec3::splat(margin);
    let (low, high) = points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (low - margin, high + margin)
}

fn within(p: DVec3, low: DVec3, high: DVec3) -> bool {
    p.cmpge(low).all() && p.cmple(high).all()
}

/// Exchanges heat through all links of a pair for `dt` [s]. Each link is solved implicitly for its two nodes and
/// conserves energy: q = K Δt (T_a − T_b) / (1 + K Δt (1/C_a + 1/C_b)).
pub fn exchange(data: &FoodContact, a: &mut Piece, b: &mut Piece, links: &[Link], dt: f64) {
    for link in links {
        let (i, j) = (a.node_of(link.a), b.node_of(link.b));
        let (hot, cold) = (a.state.temperature[i], b.state.temperature[j]);
        let (Some(ca), Some(cb)) = (a.capacity(i), b.capacity(j)) else { continue };
        let conductance = data.conductance_w_m2k * link.area * dt;
        let heat = conductance * (hot - cold) / (1.0 + conductance * (1.0 / ca + 1.0 / cb));
        // A piece that is about to be restored gives its neighbours nothing.
        if heat.is_finite() {
            a.give(i, -heat);
            b.give(j, heat);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use saute_food::{MeshSize, OutlineKind, PatchPose, Rules};

    use super::*;
    use crate::{Command, Kitchen, Library, PieceOrder, kelvin};

    /// Five shrimps over each other at temperatures by their number [K].
    fn heap(temperature: impl Fn(u64) -> f64) -> Kitchen {
        let library = Library::embedded().unwrap();
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).unwrap();
        for seed in 1..=5 {
            let order = PieceOrder {
                id: format!("{seed}"),
                kind: "shrimp".into(),
                size: library.foods["shrimp"].form.extent(&[75.0, 15.0]).unwrap().map(|mm| 1e-3 * mm),
                temperature: temperature(seed),
                seed,
                coarseness: 1.0,
                mesh: MeshSize::Default,
                rules: Rules::Full,
                outline: OutlineKind::Plain,
            };
            kitchen.add(&library, &order).unwrap();
            let at = [0.01 * seed as f64, 0.0];
            kitchen.apply(&Command::Put { food: order.id, at, heap: true }).unwrap();
            (0..5).for_each(|_| kitchen.step());
        }
        kitchen
    }

    /// The nearest of all facing patches, with or without contact.
    fn nearest(a: &PatchPose, b: &Piece, relative: &Pose) -> Option<(u32, DVec3)> {
        let (p, n) = (DVec3::from_array(a.position), DVec3::from_array(a.normal));
        let way = |q: &PatchPose| relative.to_world(DVec3::from_array(q.position)) - p;
        let facing = |q: &PatchPose| (relative.rotation * DVec3::from_array(q.normal)).dot(n) < FACING;
        let others = b.patch_poses().iter().enumerate().filter(|(j, q)| facing(q) && b.patch_area(*j) > 0.0);
        others.map(|(j, q)| (j as u32, way(q))).min_by(|v, w| v.1.length_squared().total_cmp(&w.1.length_squared()))
    }

    #[test]
    fn each_link_is_to_the_nearest_of_all_patches_and_none_is_missed() {
        let kitchen = heap(|_| kelvin(20.0));
        let mut count = 0;
        for touching in &kitchen.touching {
            let [a, b] = touching.pair.map(|key| kitchen.pieces.iter().find(|p| p.key == key).unwrap());
            let relative = b.pose.seen_from(&a.pose);
            let linked = |i: usize| {
                let (j, way) = nearest(&a.patch_poses()[i], b, &relative)?;
                let (n, areas) =
                    (DVec3::from_array(a.patch_poses()[i].normal), a.patch_area(i) + b.patch_area(j as usize));
                (a.patch_area(i) > 0.0 && touches(way, n, areas)).then_some((i as u32, j))
            };
            let expected: Vec<(u32, u32)> = (0..a.patch_poses().len()).filter_map(linked).collect();
            let found: Vec<(u32, u32)> = links(a, b, &relative).iter().map(|l| (l.a, l.b)).collect();
            assert_eq!(found, expected);
            count += found.len();
        }
        assert!(count > 20, "{count} links: the shrimps hardly touch");
    }

    /// Promise: the warmer of two pieces that touch gives heat to the colder, and what it gives arrives.
    #[test]
    fn heat_goes_from_the_warmer_to_the_colder_and_arrives() {
        let mut kitchen = heap(|number| kelvin(if number % 2 == 0 { 60.0 } else { 10.0 }));
        let data = kitchen.room().food_contact.clone();
        let mut count = 0;
        for touching in kitchen.touching.clone() {
            let [i, j] = touching.pair.map(|key| kitchen.pieces.iter().position(|p| p.key == key).unwrap());
            let [a, b] = kitchen.pieces.get_disjoint_mut([i, j]).unwrap();
            let warm =
                |piece: &Piece| piece.state.temperature.iter().sum::<f64>() / piece.state.temperature.len() as f64;
            if touching.links.is_empty() || (warm(a) - warm(b)).abs() < 20.0 {
                continue;
            }
            let held = |piece: &Piece| piece.state.total_enthalpy();
            let (before, is_a_warmer) = ([held(a), held(b)], warm(a) > warm(b));
            exchange(&data, a, b, &touching.links, 1.0);
            let [given, got] = [before[0] - held(a), held(b) - before[1]].map(|j| if is_a_warmer { j } else { -j });
            assert!(given > 0.0 && (given - got).abs() < 1e-9 * given, "{given} J given, {got} J arrived");
            count += 1;
        }
        assert!(count > 0, "no warm shrimp touches a cold one");
    }
}
