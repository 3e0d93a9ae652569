//! Points spread evenly over a surface, each with the patch of surface that is nearest to it.

use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::surface::{DepthFinder, features};
use crate::vector::{Vec3, add, along, distance, dot, length, scale, sub, unit};

/// Candidates in a square of the spacing (chosen: patch areas then come out to a few percent).
const CANDIDATES: f64 = 40.0;
/// Smallest distance of accepted points over the spacing [-] (chosen: randomly filled to the brim, the mean distance is the
/// spacing).
const APART: f64 = 0.78;
/// Rounds of evening out (chosen: after four, points move by less than a tenth of the spacing).
const ROUNDS: usize = 4;
/// Cosine beyond which two directions belong to the same side of a body [-] (chosen: 73°).
const SAME_SIDE: f64 = 0.3;

/// A point of the surface that stands for the patch around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// On the mean plane of its patch [m].
    pub position: Vec3,
    /// Mean outward normal of its patch.
    pub normal: Vec3,
}

/// A point of the surface with the normal there.
#[derive(Clone, Copy)]
struct Candidate {
    position: Vec3,
    normal: Vec3,
}

/// Spreads points over a surface about `spacing` apart [m].
///
/// Along sharp edges they stand in pairs, half a spacing into either face: the bisecting planes between the two then
/// meet in the edge, and cells end exactly where faces do.
pub fn samples(finder: &DepthFinder, spacing: f64) -> Vec<Sample> {
    let candidates = candidates(finder, spacing);
    let mut chosen = pairs_along_edges(finder, spacing);
    let fixed = chosen.len();
    fill(&candidates, &mut chosen, spacing);
    for _ in 0..ROUNDS {
        even_out(&candidates, &mut chosen, fixed, spacing);
    }
    mean_planes(&candidates, &chosen, spacing)
}

/// Points that cover the surface evenly: strata of equal area, each with a point of an additive sequence.
fn candidates(finder: &DepthFinder, spacing: f64) -> Vec<Candidate> {
    let surface = finder.surface();
    let area = surface.area();
    let count = libm::ceil(CANDIDATES * area / (spacing * spacing));
    let mut candidates = Vec::with_capacity(count as usize);
    let (mut before, mut k) = (0.0, 0.0);
    for t in 0..surface.triangles.len() {
        let after = before + 0.5 * length(surface.doubled_area(t)) * count / area;
        let [a, b, c] = surface.corners(t);
        while k + 0.5 < after {
            // The plastic number's sequence fills the square evenly.
            let fraction = |v: f64| v - libm::floor(v);
            let (mut u, mut v) = (fraction(0.754_877_666_246_692_7 * k), fraction(0.569_840_290_998_053_2 * k));
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let position = along(along(a, sub(b, a), u), sub(c, a), v);
            candidates.push(Candidate { position, normal: finder.normal(t as u32) });
            k += 1.0;
        }
        before = after;
    }
    candidates
}

/// Pairs of points on both sides of sharp edges.
fn pairs_along_edges(finder: &DepthFinder, spacing: f64) -> Vec<Candidate> {
    let surface = finder.surface();
    let mut chosen: Vec<Candidate> = Vec::new();
    for feature in features(surface) {
        let length = feature.length();
        let stations = libm::round(length / spacing).max(1.0);
        for k in 0..stations as usize {
            let (p, into) = feature.at((k as f64 + 0.5) * length / stations);
            let on = into.map(|d| finder.depth(along(p, d, 0.5 * spacing)));
            let pair = on.map(|d| Candidate { position: d.nearest, normal: finder.normal(d.triangle) });
            // Of a pair both stand or none does.
            let free = |c: &Candidate| chosen.iter().all(|o| distance(o.position, c.position) > 0.4 * spacing);
            let taken = |c: &Candidate| chosen.iter().any(|o| distance(o.position, c.position) < 1e-3 * spacing);
            let fits = [free(&pair[0]) || taken(&pair[0]), free(&pair[1]) || taken(&pair[1])];
            if fits == [true, true] {
                let new: Vec<Candidate> = pair.into_iter().filter(|c| !taken(c)).collect();
                chosen.extend(new);
            }
        }
    }
    chosen
}

/// Accepts candidates in scattered order wherever there is room.
fn fill(candidates: &[Candidate], chosen: &mut Vec<Candidate>, spacing: f64) {
    let positions: Vec<Vec3> = candidates.iter().map(|c| c.position).collect();
    let mut grid = PointGrid::over(crate::vector::bounds(positions.iter().copied()), spacing);
    chosen.iter().for_each(|c| grid.push(c.position));
    for i in scattered(candidates.len()) {
        let c = candidates[i];
        let same_side = |o: u32| dot(chosen[o as usize].normal, c.normal) > 0.0;
        if !grid.any_within(c.position, APART * spacing, same_side) {
            grid.push(c.position);
            chosen.push(c);
        }
    }
}

/// The numbers below n in an order in which neighbours lie far apart.
fn scattered(n: usize) -> impl Iterator<Item = usize> {
    let mut stride = ((n as f64 * 0.618_033_988_749_894_9) as usize).max(1);
    let common = |mut a: usize, mut b: usize| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    while common(stride, n) != 1 && n > 1 {
        stride += 1;
    }
    (0..n).map(move |i| (i * stride) % n)
}

/// For each candidate the nearest chosen point on its side of the body.
fn owners(candidates: &[Candidate], chosen: &[Candidate], spacing: f64) -> Vec<u32> {
    let positions: Vec<Vec3> = chosen.iter().map(|c| c.position).collect();
    let grid = PointGrid::of(&positions, spacing);
    let owner = |c: &Candidate| {
        let same_side = |o: u32| dot(chosen[o as usize].normal, c.normal) > SAME_SIDE;
        let near = grid.nearest(c.position, spacing, |_| true).unwrap_or(0);
        let reach = 2.0 * distance(c.position, positions[near as usize]);
        let mut best = (f64::INFINITY, near);
        grid.within(c.position, reach, |i, d| {
            if d < best.0 && same_side(i) {
                best = (d, i);
            }
        });
        best.1
    };
    candidates.iter().map(owner).collect()
}

/// Moves every point that is free to move to the middle of its patch.
fn even_out(candidates: &[Candidate], chosen: &mut [Candidate], fixed: usize, spacing: f64) {
    let owners = owners(candidates, chosen, spacing);
    let mut sums = vec![([0.0; 3], 0.0); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners) {
        let (sum, count) = &mut sums[o as usize];
        *sum = add(*sum, c.position);
        *count += 1.0;
    }
    let mut nearest = vec![(f64::INFINITY, None); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners) {
        let (sum, count) = sums[o as usize];
        let d = distance(c.position, scale(sum, 1.0 / count));
        if d < nearest[o as usize].0 {
            nearest[o as usize] = (d, Some(*c));
        }
    }
    for (point, (_, best)) in chosen.iter_mut().zip(nearest).skip(fixed) {
        *point = best.unwrap_or(*point);
    }
}

/// Puts every point onto the mean plane of its patch, so that the planes enclose the body's volume.
fn mean_planes(candidates: &[Candidate], chosen: &[Candidate], spacing: f64) -> Vec<Sample> {
    let owners = owners(candidates, chosen, spacing);
    let facing = |c: &Candidate, o: u32| dot(c.normal, chosen[o as usize].normal) > SAME_SIDE;
    let mut normals = vec![[0.0; 3]; chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners).filter(|(c, o)| facing(c, **o)) {
        normals[o as usize] = add(normals[o as usize], c.normal);
    }
    let normals: Vec<Vec3> = normals.into_iter().map(unit).collect();
    let mut offsets = vec![(0.0, 0.0); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners).filter(|(c, o)| facing(c, **o)) {
        let (sum, count) = &mut offsets[o as usize];
        *sum += dot(sub(c.position, chosen[o as usize].position), normals[o as usize]);
        *count += 1.0;
    }
    let plane = |((c, normal), (sum, count)): ((&Candidate, Vec3), (f64, f64))| {
        (count > 0.0).then(|| Sample { position: along(c.position, normal, sum / count), normal })
    };
    chosen.iter().zip(normals).zip(offsets).filter_map(plane).collect()
}

/// Whether the surface is convex, or flat, from one sample to another.
pub fn convex(a: &Sample, b: &Sample) -> bool {
    let way = sub(b.position, a.position);
    let tolerance = 1e-6 * length(way);
    dot(way, a.normal) <= tolerance && dot(way, b.normal) >= -tolerance
}
