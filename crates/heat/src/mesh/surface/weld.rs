//! Vertex welding: loose triangles become an indexed surface.

use std::collections::BTreeMap;

use glam::DVec3;

use super::defect::{Defect, Trouble};
use super::{MOST_TRIANGLES, Soup, Surface};
use crate::mesh::bounds::bounds;

/// Weld distance ÷ diagonal of the bounding box [-] (chosen: ten times the rounding error of single precision).
const TOGETHER: f64 = 1e-6;

/// Width of a bucket ÷ weld distance [-] (chosen: few searches then reach into a second bucket).
const BUCKET: f64 = 16.0;

/// Returns the surface with coincident corners merged, scaled from a unit of the given length [m].
///
/// Triangles that collapse to an edge or a point are removed.
///
/// # Errors
/// A [`Defect`] if triangles are missing, too many, out of range, not finite or without area.
pub fn weld(soup: &Soup, metres: f64) -> Result<Surface, Defect> {
    sound(soup)?;
    let points: Vec<DVec3> = soup.vertices.iter().map(|p| DVec3::from(*p) * metres).collect();
    let used = soup.triangles.iter().flatten().map(|&i| points[i as usize]);
    let [low, high] = bounds(used);
    let tolerance = TOGETHER * low.distance(high);
    let mut welder = Welder { tolerance, vertices: Vec::new(), buckets: BTreeMap::new() };
    let mut index = vec![u32::MAX; points.len()];
    let mut triangles = Vec::with_capacity(soup.triangles.len());
    for corners in &soup.triangles {
        let joined = corners.map(|i| {
            let slot = &mut index[i as usize];
            if *slot == u32::MAX {
                *slot = welder.join(points[i as usize]);
            }
            *slot
        });
        if joined[0] != joined[1] && joined[1] != joined[2] && joined[2] != joined[0] {
            triangles.push(joined);
        }
    }
    if triangles.is_empty() {
        // Every triangle of the file is in one point or on one edge.
        return Err(Defect::Degenerate(Trouble::at(soup.triangles.len(), low.to_array())));
    }
    let surface = Surface { vertices: welder.vertices.iter().map(DVec3::to_array).collect(), triangles };
    without_slivers(&surface, tolerance)?;
    Ok(surface)
}

/// Checks the number of triangles, their indices and the coordinates.
fn sound(soup: &Soup) -> Result<(), Defect> {
    if soup.triangles.is_empty() {
        return Err(Defect::Empty);
    }
    if soup.triangles.len() > MOST_TRIANGLES {
        return Err(Defect::TooMany(soup.triangles.len()));
    }
    let missing = soup.triangles.iter().flatten().find(|&&i| soup.vertices.get(i as usize).is_none());
    if let Some(&i) = missing {
        return Err(Defect::NoSuchVertex(i));
    }
    match soup.vertices.iter().filter(|p| !DVec3::from(**p).is_finite()).count() {
        0 => Ok(()),
        count => Err(Defect::NotFinite(count)),
    }
}

/// Checks that no triangle has collinear corners, to the weld distance [m].
fn without_slivers(surface: &Surface, tolerance: f64) -> Result<(), Defect> {
    let found: Vec<usize> = (0..surface.triangles.len()).filter(|t| is_sliver(surface, *t, tolerance)).collect();
    match found.first() {
        None => Ok(()),
        Some(&first) => Err(Defect::Degenerate(Trouble::at(found.len(), surface.corners(first)[0].to_array()))),
    }
}

/// Returns true if the corners of a triangle are collinear, to a distance [m].
fn is_sliver(surface: &Surface, triangle: usize, tolerance: f64) -> bool {
    let [a, b, c] = surface.corners(triangle);
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    (b - a).cross(c - a).length() <= tolerance * longest
}

/// Returns those of some triangles of a welded surface whose corners are collinear.
pub fn slivers_among(surface: &Surface, triangles: &[usize]) -> Vec<usize> {
    let tolerance = TOGETHER * DVec3::from(surface.extent()).length();
    triangles.iter().copied().filter(|t| is_sliver(surface, *t, tolerance)).collect()
}

/// The vertices found so far, in buckets.
struct Welder {
    tolerance: f64,
    vertices: Vec<DVec3>,
    buckets: BTreeMap<[i64; 3], Vec<u32>>,
}

impl Welder {
    /// Returns the index of the vertex at a place, and adds a vertex if there is none.
    fn join(&mut self, p: DVec3) -> u32 {
        if let Some(found) = self.find(p) {
            return found;
        }
        let new = self.vertices.len() as u32;
        self.vertices.push(p);
        self.buckets.entry(self.bucket(p)).or_default().push(new);
        new
    }

    fn bucket(&self, p: DVec3) -> [i64; 3] {
        p.to_array().map(|v| libm::floor(v / (BUCKET * self.tolerance).max(f64::MIN_POSITIVE)) as i64)
    }

    /// Returns the first vertex within the weld distance of a place.
    fn find(&self, p: DVec3) -> Option<u32> {
        let [low, high] = [-self.tolerance, self.tolerance].map(|d| self.bucket(p + DVec3::splat(d)));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let near = |i: &&u32| self.vertices[**i as usize].distance(p) <= self.tolerance;
                    if let Some(&found) = self.buckets.get(&[x, y, z]).and_then(|b| b.iter().find(near)) {
                        return Some(found);
                    }
                }
            }
        }
        None
    }
}
