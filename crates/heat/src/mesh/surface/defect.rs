//! What may be wrong with a surface, and how one finds it.

use std::collections::BTreeMap;

use super::{EXTENT, MOST_TRIANGLES, Surface};
use crate::vector::{Vec3, add, scale};

/// How often something is wrong, and where first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trouble {
    /// How often.
    pub count: usize,
    /// The first place [m].
    pub place: Vec3,
}

impl Trouble {
    /// Some trouble, first at a place [m].
    pub fn at(count: usize, place: Vec3) -> Self {
        Self { count, place }
    }
}

impl std::fmt::Display for Trouble {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let [x, y, z] = self.place.map(|v| 1e3 * v);
        write!(f, "{}, the first at ({x:.2}, {y:.2}, {z:.2}) mm", self.count)
    }
}

/// Why a surface cannot be meshed inside.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Defect {
    /// No triangle at all.
    #[error("holds no triangle")]
    Empty,
    /// More than [`MOST_TRIANGLES`].
    #[error("has {0} triangles, more than {MOST_TRIANGLES}")]
    TooMany(usize),
    /// A triangle names a corner that there is not.
    #[error("a triangle names corner {0}, which there is not")]
    NoSuchVertex(u32),
    /// Corners that are no finite numbers.
    #[error("{0} corners are not finite numbers")]
    NotFinite(usize),
    /// Triangles whose corners lie on a line.
    #[error("triangles without area: {0}")]
    Degenerate(Trouble),
    /// Edges that belong to one triangle alone.
    #[error("not closed: edges with one triangle alone: {0}")]
    Open(Trouble),
    /// Edges of more than two triangles, and corners at which parts of the surface merely touch.
    #[error("parts that merely touch: edges of more than two triangles, or corners between parts: {0}")]
    NonManifold(Trouble),
    /// Neighbouring triangles of which one shows its back.
    #[error("neighbouring triangles that face opposite ways: {0}")]
    Orientation(Trouble),
    /// Several closed surfaces.
    #[error("{} separate bodies or hollows instead of one; another begins at ({:.2}, {:.2}, {:.2}) mm",
        .0.count, 1e3 * .0.place[0], 1e3 * .0.place[1], 1e3 * .0.place[2])]
    Bodies(Trouble),
    /// Too thin in one direction [m].
    #[error("only {:.4} mm thick; a body may be {} mm and more", 1e3 * .0, 1e3 * EXTENT[0])]
    TooSmall(f64),
    /// Too long in one direction [m].
    #[error("{:.0} mm long; a body may be {} mm at most", 1e3 * .0, 1e3 * EXTENT[1])]
    TooLarge(f64),
    /// Triangles that pass through each other.
    #[error("crosses itself: pairs of triangles that pass through each other: {0}")]
    Crossing(Trouble),
}

impl Defect {
    /// What to do about it.
    pub fn remedy(&self) -> String {
        let remedy = match self {
            Self::Empty => "export the body as triangles (points, lines and curved patches are not read)",
            Self::TooMany(_) => "reduce it in your modeller (decimate) and export it again",
            Self::NoSuchVertex(_) | Self::NotFinite(_) => "the file is damaged: export it again",
            Self::Degenerate(_) => "in your modeller, merge vertices by distance and dissolve degenerate faces",
            Self::Open(_) => "fill the holes in your modeller and merge vertices that lie together",
            Self::NonManifold(_) => {
                "remove inner faces and doubled faces, and pull apart what touches at an edge or a corner"
            }
            Self::Orientation(_) => "in your modeller, recalculate the normals so that all point outwards",
            Self::Bodies(_) => "keep one closed body in the file: join the others to it by a union, or delete them",
            Self::TooSmall(_) | Self::TooLarge(_) => "give scale_mm, the millimetres in one unit of the file",
            Self::Crossing(_) => "unite the parts that overlap (boolean union, or remesh) and export it again",
        };
        remedy.to_owned()
    }
}

/// One side of a triangle: its ends in the triangle's order.
#[derive(Clone, Copy)]
struct Sides {
    forth: u32,
    back: u32,
    triangles: [u32; 2],
}

/// Checks that edges have two triangles each which face the same way, and that all is one body.
pub fn closed(surface: &Surface) -> Result<(), Defect> {
    let edges = edges(surface);
    let middle = |&[a, b]: &[u32; 2]| scale(add(surface.vertices[a as usize], surface.vertices[b as usize]), 0.5);
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

/// The edges of a closed surface with the triangles on both sides.
pub(super) fn neighbours(surface: &Surface) -> Vec<([u32; 2], [u32; 2])> {
    edges(surface).into_iter().map(|(edge, sides)| (edge, sides.triangles)).collect()
}

fn one_body(surface: &Surface, edges: &BTreeMap<[u32; 2], Sides>) -> Result<(), Defect> {
    let mut groups = Groups::new(surface.triangles.len());
    edges.values().for_each(|s| groups.unite(s.triangles[0], s.triangles[1]));
    let first = groups.root(0);
    let roots: std::collections::BTreeSet<u32> = (0..surface.triangles.len() as u32).map(|t| groups.root(t)).collect();
    match (0..surface.triangles.len()).find(|&t| groups.root(t as u32) != first) {
        None => Ok(()),
        Some(other) => Err(Defect::Bodies(Trouble::at(roots.len(), surface.corners(other)[0]))),
    }
}

/// Every corner must have one fan of triangles around it.
fn whole_corners(surface: &Surface) -> Result<(), Defect> {
    // A fan is closed where following the edges that leave a corner comes round after all of them.
    let mut leaving: Vec<Vec<[u32; 2]>> = vec![Vec::new(); surface.vertices.len()];
    for &[a, b, c] in &surface.triangles {
        leaving[a as usize].push([b, c]);
        leaving[b as usize].push([c, a]);
        leaving[c as usize].push([a, b]);
    }
    let broken = |spokes: &Vec<[u32; 2]>| {
        let Some(&[start, mut at]) = spokes.first() else { return false };
        let mut steps = 1;
        while at != start && steps <= spokes.len() {
            at = spokes.iter().find(|s| s[0] == at).map_or(start, |s| s[1]);
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

/// Checks the edges of the box around it.
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

/// Disjoint groups of indices.
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
