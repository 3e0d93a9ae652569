//! Evenly distributed samples of a surface, each with its patch of nearest surface points.

use glam::DVec3;

use crate::mesh::bounds::bounds;
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::surface::{DepthFinder, features};

/// Candidates per square of the spacing [-] (chosen: patch areas are then exact to a few percent).
const CANDIDATES: f64 = 40.0;
/// Least distance of accepted candidates ÷ spacing [-] (chosen: the mean distance of random sequential packing is then the
/// spacing).
const APART: f64 = 0.78;
/// Lloyd iterations [-] (chosen: after four, points move by less than a tenth of the spacing).
const ROUNDS: usize = 4;
/// Cosine of the angle between normals below which two points are on the same side of a body [-] (chosen: 73°).
const SAME_SIDE: f64 = 0.3;

/// A sample of the surface: the mean plane of its patch [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Point on the mean plane of the patch [m].
    pub position: DVec3,
    /// Mean outward unit normal of the patch [-].
    pub normal: DVec3,
}

/// A point of the surface with its normal.
#[derive(Clone, Copy)]
struct Candidate {
    position: DVec3,
    normal: DVec3,
}

/// Returns samples of a surface with a mean distance of `spacing` [m].
///
/// Dart throwing followed by Lloyd relaxation. Along sharp edges samples come in pairs, half a spacing into either face: the
/// perpendicular bisector of a pair contains the edge, so that cells end exactly where faces do.
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

/// Returns candidates of equal area: strata over the triangles, each with a point of the R₂ sequence (Roberts 2018
/// `[@roberts-2018]`).
fn candidates(finder: &DepthFinder, spacing: f64) -> Vec<Candidate> {
    let surface = finder.surface();
    let area = surface.area();
    let count = libm::ceil(CANDIDATES * area / (spacing * spacing));
    let mut candidates = Vec::with_capacity(count as usize);
    let (mut before, mut k) = (0.0, 0.0);
    for t in 0..surface.triangles.len() {
        let after = before + 0.5 * surface.doubled_area(t).length() * count / area;
        let [a, b, c] = surface.corners(t);
        while k + 0.5 < after {
            // Multiples of the inverse powers of the plastic number have low discrepancy in the unit square.
            let fraction = |v: f64| v - libm::floor(v);
            let (mut u, mut v) = (fraction(0.754_877_666_246_692_7 * k), fraction(0.569_840_290_998_053_2 * k));
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let position = a + u * (b - a) + v * (c - a);
            candidates.push(Candidate { position, normal: finder.normal(t as u32) });
            k += 1.0;
        }
        before = after;
    }
    candidates
}

/// Returns pairs of points on both sides of sharp edges.
fn pairs_along_edges(finder: &DepthFinder, spacing: f64) -> Vec<Candidate> {
    let surface = finder.surface();
    let mut chosen: Vec<Candidate> = Vec::new();
    for feature in features(surface) {
        let length = feature.length();
        let stations = libm::round(length / spacing).max(1.0);
        for k in 0..stations as usize {
            let (p, into) = feature.at((k as f64 + 0.5) * length / stations);
            let on = into.map(|d| finder.depth(p + 0.5 * spacing * d));
            let pair = on.map(|d| Candidate { position: d.nearest, normal: finder.normal(d.triangle) });
            // A pair is accepted as a whole or not at all.
            let free = |c: &Candidate| chosen.iter().all(|o| o.position.distance(c.position) > 0.4 * spacing);
            let taken = |c: &Candidate| chosen.iter().any(|o| o.position.distance(c.position) < 1e-3 * spacing);
            let fits = [free(&pair[0]) || taken(&pair[0]), free(&pair[1]) || taken(&pair[1])];
            if fits == [true, true] {
                let new: Vec<Candidate> = pair.into_iter().filter(|c| !taken(c)).collect();
                chosen.extend(new);
            }
        }
    }
    chosen
}

/// Accepts candidates in scattered order if no accepted one is too close (dart throwing).
fn fill(candidates: &[Candidate], chosen: &mut Vec<Candidate>, spacing: f64) {
    let mut grid = PointGrid::over(bounds(candidates.iter().map(|c| c.position)), spacing);
    chosen.iter().for_each(|c| grid.push(c.position));
    for i in scattered(candidates.len()) {
        let c = candidates[i];
        let same_side = |o: u32| chosen[o as usize].normal.dot(c.normal) > 0.0;
        if !grid.any_within(c.position, APART * spacing, same_side) {
            grid.push(c.position);
            chosen.push(c);
        }
    }
}

/// Returns the numbers below n in golden-ratio order, in which successive numbers are far apart.
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

/// Returns the nearest chosen point on the same side of the body, for each candidate.
fn owners(candidates: &[Candidate], chosen: &[Candidate], spacing: f64) -> Vec<u32> {
    let positions: Vec<DVec3> = chosen.iter().map(|c| c.position).collect();
    let grid = PointGrid::of(&positions, spacing);
    let owner = |c: &Candidate| {
        let same_side = |o: u32| chosen[o as usize].normal.dot(c.normal) > SAME_SIDE;
        let near = grid.nearest(c.position, spacing, |_| true).unwrap_or(0);
        let reach = 2.0 * c.position.distance(positions[near as usize]);
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

/// Moves every point after the first `fixed` ones to the candidate nearest to the centroid of its patch (Lloyd iteration).
fn even_out(candidates: &[Candidate], chosen: &mut [Candidate], fixed: usize, spacing: f64) {
    let owners = owners(candidates, chosen, spacing);
    let mut sums = vec![(DVec3::ZERO, 0.0); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners) {
        let (sum, count) = &mut sums[o as usize];
        *sum += c.position;
        *count += 1.0;
    }
    let mut nearest = vec![(f64::INFINITY, None); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners) {
        let (sum, count) = sums[o as usize];
        let d = c.position.distance(sum * (1.0 / count));
        if d < nearest[o as usize].0 {
            nearest[o as usize] = (d, Some(*c));
        }
    }
    for (point, (_, best)) in chosen.iter_mut().zip(nearest).skip(fixed) {
        *point = best.unwrap_or(*point);
    }
}

/// Returns the mean planes of all patches, so that the planes together enclose the body's volume [m].
fn mean_planes(candidates: &[Candidate], chosen: &[Candidate], spacing: f64) -> Vec<Sample> {
    let owners = owners(candidates, chosen, spacing);
    let facing = |c: &Candidate, o: u32| c.normal.dot(chosen[o as usize].normal) > SAME_SIDE;
    let mut normals = vec![DVec3::ZERO; chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners).filter(|(c, o)| facing(c, **o)) {
        normals[o as usize] += c.normal;
    }
    let normals: Vec<DVec3> = normals.into_iter().map(DVec3::normalize_or_zero).collect();
    let mut offsets = vec![(0.0, 0.0); chosen.len()];
    for (c, &o) in candidates.iter().zip(&owners).filter(|(c, o)| facing(c, **o)) {
        let (sum, count) = &mut offsets[o as usize];
        *sum += (c.position - chosen[o as usize].position).dot(normals[o as usize]);
        *count += 1.0;
    }
    let plane = |((c, normal), (sum, count)): ((&Candidate, DVec3), (f64, f64))| {
        (count > 0.0).then(|| Sample { position: c.position + sum / count * normal, normal })
    };
    chosen.iter().zip(normals).zip(offsets).filter_map(plane).collect()
}

/// Returns true if the surface is convex or flat between two samples.
pub fn convex(a: &Sample, b: &Sample) -> bool {
    let way = b.position - a.position;
    let tolerance = 1e-6 * way.length();
    way.dot(a.normal) <= tolerance && way.dot(b.normal) >= -tolerance
}
