//! Loose triangles become an indexed surface.

use std::collections::BTreeMap;

use super::defect::{Defect, Trouble};
use super::{MOST_TRIANGLES, Soup, Surface};
use crate::vector::{Vec3, bounds, cross, distance, length, scale, sub};

/// Corners nearer than this share of the body's diagonal are one [-] (chosen: single precision leaves about a tenth of it).
const TOGETHER: f64 = 1e-6;

/// Width of a bucket over the distance within which corners are one [-] (chosen: few searches then look into a second bucket).
const BUCKET: f64 = 16.0;

/// Joins corners that lie together, drops triangles that shrank to an edge, and scales to metres.
pub fn weld(soup: &Soup, metres: f64) -> Result<Surface, Defect> {
    sound(soup)?;
    let points: Vec<Vec3> = soup.vertices.iter().map(|p| scale(*p, metres)).collect();
    let used = soup.triangles.iter().flatten().map(|&i| points[i as usize]);
    let [low, high] = bounds(used);
    let tolerance = TOGETHER * distance(low, high);
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
    let surface = Surface { vertices: welder.vertices, triangles };
    slivers(&surface, tolerance)?;
    Ok(surface)
}

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
    let finite = |p: &Vec3| p.iter().all(|v| v.is_finite());
    match soup.vertices.iter().filter(|p| !finite(p)).count() {
        0 => Ok(()),
        count => Err(Defect::NotFinite(count)),
    }
}

/// Triangles without height: their corners lie on a line.
fn slivers(surface: &Surface, tolerance: f64) -> Result<(), Defect> {
    let flat = |&t: &usize| {
        let [a, b, c] = surface.corners(t);
        let longest = distance(a, b).max(distance(b, c)).max(distance(c, a));
        length(cross(sub(b, a), sub(c, a))) <= tolerance * longest
    };
    let found: Vec<usize> = (0..surface.triangles.len()).filter(flat).collect();
    match found.first() {
        None => Ok(()),
        Some(&first) => Err(Defect::Degenerate(Trouble::at(found.len(), surface.corners(first)[0]))),
    }
}

/// Buckets of the corners so far.
struct Welder {
    tolerance: f64,
    vertices: Vec<Vec3>,
    buckets: BTreeMap<[i64; 3], Vec<u32>>,
}

impl Welder {
    /// Index of the corner at a place, a new one if there is none.
    fn join(&mut self, p: Vec3) -> u32 {
        if let Some(found) = self.find(p) {
            return found;
        }
        let new = self.vertices.len() as u32;
        self.vertices.push(p);
        self.buckets.entry(self.bucket(p)).or_default().push(new);
        new
    }

    fn bucket(&self, p: Vec3) -> [i64; 3] {
        p.map(|v| libm::floor(v / (BUCKET * self.tolerance).max(f64::MIN_POSITIVE)) as i64)
    }

    fn find(&self, p: Vec3) -> Option<u32> {
        let [low, high] = [-self.tolerance, self.tolerance].map(|d| self.bucket(p.map(|v| v + d)));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let near = |i: &&u32| distance(self.vertices[**i as usize], p) <= self.tolerance;
                    if let Some(&found) = self.buckets.get(&[x, y, z]).and_then(|b| b.iter().find(near)) {
                        return Some(found);
                    }
                }
            }
        }
        None
    }
}
