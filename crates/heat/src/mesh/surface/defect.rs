//! Defects of a triangulated surface and the checks that find them.

use std::collections::BTreeMap;

use super::{EXTENT, MOST_TRIANGLES, Surface};

/// The number of occurrences of a defect [-] and the first place [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trouble {
    /// Number of occurrences [-].
    pub count: usize,
    /// First place [m].
    pub place: [f64; 3],
}

impl Trouble {
    /// Returns the record of `count` occurrences, the first at `place` [m].
    pub(super) fn at(count: usize, place: [f64; 3]) -> Self {
        Self { count, place }
    }
}

impl std::fmt::Display for Trouble {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let [x, y, z] = self.place.map(|v| 1e3 * v);
        write!(f, "{}, the first at ({x:.2}, {y:.2}, {z:.2}) mm", self.count)
    }
}

/// The reason why a surface does not bound a body that can be meshed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Defect {
    /// The file contains no triangle.
    #[error("contains no triangle")]
    Empty,
    /// There are more than [`MOST_TRIANGLES`] triangles.
    #[error("has {0} triangles; the limit is {MOST_TRIANGLES}")]
    TooMany(usize),
    /// A triangle refers to a corner that does not exist.
    #[error("a triangle refers to corner {0}, which does not exist")]
    NoSuchVertex(u32),
    /// Coordinates of corners are not finite.
    #[error("{0} corners are not finite numbers")]
    NotFinite(usize),
    /// Triangles have collinear corners.
    #[error("triangles without area: {0}")]
    Degenerate(Trouble),
    /// Edges belong to one triangle only.
    #[error("not closed: edges with one triangle alone: {0}")]
    Open(Trouble),
    /// Edges belong to more than two triangles, or parts of the surface touch in one corner.
    #[error("parts that merely touch: edges of more than two triangles, or corners between parts: {0}")]
    NonManifold(Trouble),
    /// Neighbouring triangles have opposite orientation.
    #[error("neighbouring triangles that face opposite ways: {0}")]
    Orientation(Trouble),
    /// The file contains several closed surfaces.
    #[error("{} separate bodies or hollows instead of one; another begins at ({:.2}, {:.2}, {:.2}) mm",
        .0.count, 1e3 * .0.place[0], 1e3 * .0.place[1], 1e3 * .0.place[2])]
    Bodies(Trouble),
    /// The smallest edge of the bounding box is below the limit [m].
    #[error("only {:.4} mm thick; the minimum is {} mm", 1e3 * .0, 1e3 * EXTENT[0])]
    TooSmall(f64),
    /// The largest edge of the bounding box is above the limit [m].
    #[error("{:.0} mm long; the maximum is {} mm", 1e3 * .0, 1e3 * EXTENT[1])]
    TooLarge(f64),
    /// Triangles intersect each other.
    #[error("crosses itself: pairs of intersecting triangles: {0}")]
    Crossing(Trouble),
    /// Ten thousands of long triangles are in each other's boxes, as in a fan around one point [m].
    #[error("too many long, thin triangles side by side, as around ({:.2}, {:.2}, {:.2}) mm", 1e3 * .0[0], 1e3 * .0[1], 1e3 * .0[2])]
    Dense([f64; 3]),
}

impl Defect {
    /// Returns the remedy, as an instruction to the user.
    pub fn remedy(&self) -> String {
        let remedy = match self {
            Self::Empty => "export the body as triangles (points, lines and curved patches are not read)",
            Self::TooMany(_) => "reduce it in your modeller (decimate) and export it again",
            Self::NoSuchVertex(_) | Self::NotFinite(_) => "the file is damaged: export it again",
            Self::Degenerate(_) => "in your modeller, merge vertices by distance and dissolve degenerate faces",
            Self::Open(_) => "fill the holes in your modeller and merge vertices that lie together",
            Self::NonManifold(_) => {
                "remove inner faces and doubled faces, and separate parts that touch at an edge or a corner"
            }
            Self::Orientation(_) => "in your modeller, recalculate the normals so that all point outwards",
            Self::Bodies(_) => "keep one closed body in the file: join the others to it by a union, or delete them",
            Self::TooSmall(_) | Self::TooLarge(_) => "give scale_mm, the length of the file's unit in millimetres",
            Self::Dense(_) => "in your modeller, remesh it with triangles of even size, and export it again",
            Self::Crossing(_) => "unite overlapping parts (boolean union, or remesh) and export it again",
        };
        remedy.to_owned()
    }
}

/// The triangles on both sides of an edge, with the number of triangles that run along it in either direction.
#[derive(Clone, Copy)]
struct Sides {
    forth: u32,
    back: u32,
    triangles: [u32; 2],
}

/// Checks that the surface is one closed, consistently oriented two-manifold.
///
/// # Errors
/// [`Defect::Empty`] without a triangle; else the first defect in the order open, non-manifold edge, orientation, several bodies, non-manifold corner.
pub fn closed(surface: &Surface) -> Result<(), Defect> {
    if surface.triangles.is_empty() {
        return Err(Defect::Empty);
    }
    let edges = edges(surface);
    let middle = |&[a, b]: &[u32; 2]| ((surface.vertex(a) + surface.vertex(b)) * 0.5).to_array();
    let trouble = |wrong: &dyn Fn(&Sides) -> bool| {
        let mut found = edges.iter().filter(|(_, s)| wrong(s));
        found.next().map(|(edge, _)| Trouble::at(1 + found.count(), middle(edge)))
    };
    if let Some(t) = trouble(&|s| s.forth + s.back == 1) {
        return Err(Defect::Open(t));
    }
    if let Some(t) = trouble(&|s| s.forth + s.back > 2) {
        return Err(Defect::NonManifold(t));
    }
    if let Some(t) = trouble(&|s| s.forth != s.back) {
        return Err(Defect::Orientation(t));
    }
    one_body(surface, &edges)?;
    whole_corners(surface)
}

/// Returns all edges, by their ascending ends, with the triangles on their sides.
fn edges(surface: &Surface) -> BTreeMap<[u32; 2], Sides> {
    let mut edges = BTreeMap::new();
    for (t, corners) in (0u32..).zip(&surface.triangles) {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let sides = edges.entry([a.min(b), a.max(b)]).or_insert(Sides { forth: 0, back: 0, triangles: [t; 2] });
            *if a < b { &mut sides.forth } else { &mut sides.back } += 1;
            sides.triangles[1] = t;
        }
    }
    edges
}

/// Returns the edges of a closed surface with the triangles on both sides.
pub(super) fn neighbours(surface: &Surface) -> Vec<([u32; 2], [u32; 2])> {
    edges(surface).into_iter().map(|(edge, sides)| (edge, sides.triangles)).collect()
}

/// Checks that all triangles are connected by edges.
fn one_body(surface: &Surface, edges: &BTreeMap<[u32; 2], Sides>) -> Result<(), Defect> {
    let mut groups = Groups::new(surface.triangles.len());
    edges.values().for_each(|s| groups.unite(s.triangles[0], s.triangles[1]));
    let first = groups.root(0);
    let roots: std::collections::BTreeSet<u32> = (0..surface.triangles.len() as u32).map(|t| groups.root(t)).collect();
    match (0..surface.triangles.len()).find(|&t| groups.root(t as u32) != first) {
        None => Ok(()),
        Some(other) => Err(Defect::Bodies(Trouble::at(roots.len(), surface.corners(other)[0].to_array()))),
    }
}

/// Checks that every vertex has one closed fan of triangles.
fn whole_corners(surface: &Surface) -> Result<(), Defect> {
    // A fan is closed if the walk from triangle to triangle around the vertex returns after all of them.
    let mut leaving: Vec<Vec<[u32; 2]>> = vec![Vec::new(); surface.vertices.len()];
    for &[a, b, c] in &surface.triangles {
        leaving[a as usize].push([b, c]);
        leaving[b as usize].push([c, a]);
        leaving[c as usize].push([a, b]);
    }
    // Sorted, so that a fan of many triangles takes no quadratic time.
    leaving.iter_mut().for_each(|spokes| spokes.sort_unstable());
    let next = |spokes: &[[u32; 2]], at: u32| spokes.binary_search_by_key(&at, |s| s[0]).ok().map(|i| spokes[i][1]);
    let broken = |spokes: &Vec<[u32; 2]>| {
        let Some(&[start, mut at]) = spokes.first() else { return false };
        let mut steps = 1;
        while at != start && steps <= spokes.len() {
            at = next(spokes, at).unwrap_or(start);
            steps += 1;
        }
        steps != spokes.len()
    };
    let mut found = leaving.iter().enumerate().filter(|(_, spokes)| broken(spokes));
    match found.next() {
        None => Ok(()),
        Some((first, _)) => Err(Defect::NonManifold(Trouble::at(1 + found.count(), surface.vertices[first]))),
    }
}

/// Checks the edges of the bounding box against [`EXTENT`].
pub fn sized(surface: &Surface) -> Result<(), Defect> {
    let extent = surface.extent();
    let largest = extent.into_iter().fold(0.0, f64::max);
    let smallest = extent.into_iter().fold(f64::INFINITY, f64::min);
    if largest > EXTENT[1] * (1.0 + 1e-9) {
        return Err(Defect::TooLarge(largest));
    }
    if smallest < EXTENT[0] * (1.0 - 1e-9) {
        return Err(Defect::TooSmall(smallest));
    }
    Ok(())
}

/// Disjoint sets of indices (union–find with path halving).
struct Groups(Vec<u32>);

impl Groups {
    fn new(n: usize) -> Self {
        Self((0..n as u32).collect())
    }

    fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            self.0[i as usize] = self.0[self.0[i as usize] as usize];
            i = self.0[i as usize];
        }
        i
    }

    fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
