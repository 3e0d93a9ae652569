//! Where the drawn surface of a slice meets the plane of a cut: there the cut face ends, and both show the same flesh.

use std::collections::BTreeSet;

use glam::{Vec2, Vec3};
use saute_kitchen::food::FoodModel;
use saute_kitchen::heat::{Cut, CutPoint, SweptMesh};

use crate::skin::rim::{Rim, rim_radius};
use crate::skin::surface::{UNEVEN, fineness, uneven};

/// Distance from the surface over which the cut face follows its rounded and uneven rim, over the radius of the rim [-]
/// (chosen: further in a cut shows every point where it is; wide enough that nothing folds).
const FOLLOWS: f32 = 4.0;
/// Depth below a big face over which it follows the uneven face, over the unevenness [-] (chosen in the same way).
const FACE_FOLLOWS: f32 = 2.0;
/// Edges of the outline farther than this from the plane do not meet it as drawn [m] (chosen: an edge and its shift).
const REACH: f64 = 10.0e-3;

/// Where a level meets the surface.
#[derive(Clone, Copy)]
struct End {
    /// Which nodes feed it.
    point: CutPoint,
    /// Along the cut and upwards, in the rest frame [m].
    at: Vec2,
    /// How far that is from where the mesh has it [m].
    shift: Vec2,
}

/// The plane of a cut and the direction along it, in the section.
#[derive(Clone, Copy)]
pub(crate) struct Plane {
    /// Place along the normal [m].
    pub(crate) x: f64,
    /// True if the normal is x rather than y.
    pub(crate) along_x: bool,
}

impl Plane {
    /// A point of the plane in the rest frame [m].
    pub(crate) fn point(self, at: Vec2) -> Vec3 {
        let x = self.x as f32;
        if self.along_x { Vec3::new(x, at.x, at.y) } else { Vec3::new(-at.x, x, at.y) }
    }

    /// Place of a point of the rest frame along the cut [m].
    pub(crate) fn along(self, p: Vec3) -> f32 {
        self.seen(p).1.x
    }

    /// Distance from the plane, and place along the cut and upwards [m].
    fn seen(self, p: Vec3) -> (f32, Vec2) {
        let x = self.x as f32;
        if self.along_x { (p.x - x, Vec2::new(p.y, p.z)) } else { (p.y - x, Vec2::new(-p.x, p.z)) }
    }
}

/// The seam between the cut face and the drawn surface.
pub(crate) struct CutRim<'a> {
    model: &'a FoodModel,
    mesh: &'a SweptMesh,
    plane: Plane,
    cut: &'a Cut,
    /// Edges of the section near the plane, and those of its outline among them.
    edges: Vec<[u32; 2]>,
    outline: Vec<[u32; 2]>,
    rim: Rim<'a>,
}

impl<'a> CutRim<'a> {
    /// Of a cut with at least two points.
    pub(crate) fn new(model: &'a FoodModel, mesh: &'a SweptMesh, plane: Plane, cut: &'a Cut) -> Self {
        let section = &mesh.section;
        let axis = usize::from(!plane.along_x);
        let close = |i: u32| (section.points[i as usize][axis] - plane.x).abs() < REACH;
        let near = |e: &[u32; 2]| e.iter().any(|i| close(*i));
        let outline = section.boundary.iter().copied().filter(near).collect();
        let sides = section.triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
        let edges: BTreeSet<[u32; 2]> = sides.filter(near).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        let edges = edges.into_iter().collect();
        Self { model, mesh, plane, cut, edges, outline, rim: Rim::new(model, mesh) }
    }

    /// One level of the face: which nodes feed each point, and where in the rest frame it is [m], in order along the
    /// cut.
    pub(crate) fn row(&self, level: usize) -> Vec<(CutPoint, Vec3)> {
        if level == 0 || level + 1 == self.mesh.levels.len() {
            let met = self.meeting(level, &self.edges);
            if met.len() > 1 {
                return met.iter().map(|end| (end.point, self.plane.point(end.at))).collect();
            }
        }
        let ends = self.ends(level);
        let last = self.cut.points.len() - 1;
        let point = |(k, point): (usize, &CutPoint)| match k {
            0 => (ends[0].point, self.plane.point(ends[0].at)),
            _ if k == last => (ends[1].point, self.plane.point(ends[1].at)),
            _ => (*point, self.plane.point(self.inside(level, point, &ends))),
        };
        self.cut.points.iter().enumerate().map(point).collect()
    }

    /// A point between the ends: near them it follows the rim, below the faces it follows them.
    fn inside(&self, level: usize, point: &CutPoint, ends: &[End; 2]) -> Vec2 {
        let rest = self.rest(level, point);
        let wide = FOLLOWS * rim_radius(self.model);
        let weights = ends.map(|end| (1.0 - (rest.x - (end.at.x - end.shift.x)).abs() / wide).max(0.0));
        let inner = (1.0 - weights[0] - weights[1]).max(0.0);
        rest + weights[0] * ends[0].shift + weights[1] * ends[1].shift + Vec2::Y * (inner * self.face(level, point))
    }

    /// How far the uneven face above or below shifts a point upwards [m].
    fn face(&self, level: usize, point: &CutPoint) -> f32 {
        let mesh = self.mesh;
        let (z, thickness) = (mesh.levels[level], mesh.thickness());
        let depth = z.min(thickness - z) as f32;
        let share = 1.0 - depth / (FACE_FOLLOWS * (UNEVEN[0] * fineness(self.model)) as f32);
        if share <= 0.0 {
            return 0.0;
        }
        let face = if 2.0 * z > thickness { mesh.levels.len() - 1 } else { 0 };
        let wave = |i: u32| {
            let p = self.model.rest_position(mesh.node(face, i as usize));
            uneven(Vec3::from_array(p.map(|v| v as f32)), self.model, mesh).z
        };
        share * (wave(point.nodes[0]) * (1.0 - point.share as f32) + wave(point.nodes[1]) * point.share as f32)
    }

    /// Where the mesh has a point [m].
    fn rest(&self, level: usize, point: &CutPoint) -> Vec2 {
        let z = |i: u32| self.model.rest_position(self.mesh.node(level, i as usize))[2];
        let height = z(point.nodes[0]) * (1.0 - point.share) + z(point.nodes[1]) * point.share;
        Vec2::new(point.along as f32, height as f32)
    }

    /// The first and the last point of a level; where the drawn side does not reach the plane, those of the mesh.
    fn ends(&self, level: usize) -> [End; 2] {
        let rest = [self.cut.points[0], self.cut.points[self.cut.points.len() - 1]];
        let met = self.meeting(level, &self.outline);
        let ends = [met.first(), met.last()];
        std::array::from_fn(|k| {
            let at = self.rest(level, &rest[k]);
            let unmoved = End { point: rest[k], at, shift: Vec2::ZERO };
            let found = ends[k].filter(|_| met.len() > 1);
            found.map_or(unmoved, |end| End { shift: end.at - at, ..*end })
        })
    }

    /// Where edges, as they are drawn at a level, meet the plane, in order along the cut.
    fn meeting(&self, level: usize, edges: &[[u32; 2]]) -> Vec<End> {
        let mut met: Vec<End> = edges.iter().filter_map(|edge| self.met(level, *edge)).collect();
        met.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
        met
    }

    /// Where an edge, as it is drawn at a level, meets the plane.
    fn met(&self, level: usize, nodes: [u32; 2]) -> Option<End> {
        let [(from, p), (to, q)] = nodes.map(|i| self.plane.seen(self.rim.place(level, i as usize)));
        if (from >= 0.0) == (to >= 0.0) {
            return None;
        }
        let share = from / (from - to);
        let at = p.lerp(q, share);
        let point = CutPoint { along: f64::from(at.x), nodes, share: f64::from(share) };
        Some(End { point, at, shift: Vec2::ZERO })
    }
}
