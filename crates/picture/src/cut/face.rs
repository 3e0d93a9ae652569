//! The cut face of a piece as the renderer's input.

use glam::Vec3;
use saute_kitchen::Piece;
use saute_kitchen::food::change::colour::Appearance;
use saute_kitchen::food::readings::changed_at;
use saute_kitchen::food::{FoodModel, FoodState};
use saute_kitchen::heat::{BodyMesh, CutPoint, SweptMesh};
use saute_scene::input::{FoodVertex, SliceLook};

use crate::colour::map::ColourMap;
use crate::cut::contour::Outside;
use crate::cut::rim::{CutRim, Plane};
use crate::cut::steps::Steps;
use crate::skin::cells::CellLook;
use crate::skin::sheaths::stands_in_steps;
use crate::skin::surface::{CUT_MOISTURE, Place, PresentShape, on_body, vertex};
use crate::view::View;

/// The cut at `x` [m] along the longest axis, its hidden side away from the origin of that axis or towards +x; a body
/// that is no slice is cut along its middle plane, its upper half hidden. `outside` is the drawn surface.
pub(crate) fn slice(
    piece: &Piece,
    outside: Outside<'_>,
    x: f64,
    view: View,
    map: Option<&ColourMap>,
) -> Option<SliceLook> {
    let (model, state) = (&*piece.model, &piece.state);
    let mesh = match model.mesh() {
        BodyMesh::Swept(mesh) => mesh,
        BodyMesh::Cells(cells) => return CellLook { cells, model, state, view, map }.slice(x),
    };
    let cut = model.cut_across(x);
    if cut.points.len() < 2 {
        return None;
    }
    let (along_x, slice) = (model.size()[0] >= model.size()[1], mesh.is_upright());
    let normal = match (slice, along_x) {
        (false, _) if piece.upside_down() => Vec3::NEG_Z,
        (false, _) => Vec3::Z,
        (true, true) => Vec3::X,
        (true, false) => Vec3::Y,
    };
    let face = CutFace { model, mesh, state, view, map, normal, shape: PresentShape::new(model, state) };
    let levels = 0..mesh.levels.len();
    let rows: Vec<Vec<FoodVertex>> = if slice {
        let plane = Plane { x, along_x };
        let steps = stands_in_steps(model).then(|| Steps::new(outside, plane, normal)).flatten();
        steps.map_or_else(
            || {
                let rim = CutRim::new(model, mesh, plane, &cut);
                levels.map(|level| face.crusted(level, rim.row(level))).collect()
            },
            |steps| steps.rows(&face, plane, &cut),
        )
    } else {
        let sides = mesh.section.sides();
        levels.map(|level| face.row(level, face.middle(level, &sides))).collect()
    };
    let mut triangles = joined(&rows);
    let vertices = rows.concat();
    if !slice && !piece.upside_down() {
        // Across and along the path come in the other order, seen from above.
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    let point = if slice { normal * x as f32 } else { Vec3::ZERO };
    Some(SliceLook { point, normal, vertices, triangles, ghost: true })
}

/// Samples the points of a cut.
pub(crate) struct CutFace<'a> {
    pub model: &'a FoodModel,
    pub mesh: &'a SweptMesh,
    pub state: &'a FoodState,
    pub view: View,
    pub map: Option<&'a ColourMap>,
    pub normal: Vec3,
    pub shape: PresentShape,
}

impl CutFace<'_> {
    fn row(&self, level: usize, points: impl IntoIterator<Item = (CutPoint, Vec3)>) -> Vec<FoodVertex> {
        points.into_iter().map(|(point, rest)| self.vertex(self.nodes(level, &point), point.share, rest)).collect()
    }

    /// A level of an upright slice: each point has its depth below both faces and how far they are browned.
    fn crusted(&self, level: usize, points: impl IntoIterator<Item = (CutPoint, Vec3)>) -> Vec<FoodVertex> {
        let last = self.mesh.levels.len() - 1;
        // A wedge is thicker at one end.
        let height = |level: usize, point: &CutPoint| self.rest(level, point).z;
        let browned = |level: usize, point: &CutPoint| {
            between(self.nodes(level, point), point.share, &|node| self.state.browning[node]) as f32
        };
        let of = |(point, rest): (CutPoint, Vec3)| FoodVertex {
            along: browned(last, &point),
            dorsal: browned(0, &point),
            juice: height(last, &point) - height(level, &point),
            seared: height(level, &point) - height(0, &point),
            ..self.vertex(self.nodes(level, &point), point.share, rest)
        };
        points.into_iter().map(of).collect()
    }

    /// Where the sides of a station's section meet the middle plane of a body along a path, in order across it: a section
    /// that tapers meets it elsewhere than the first one.
    fn middle(&self, level: usize, sides: &[[u32; 2]]) -> Vec<(CutPoint, Vec3)> {
        let met = |nodes: &[u32; 2]| {
            let [from, to] = nodes.map(|i| self.model.rest_position(self.mesh.node(level, i as usize))[2]);
            // A node in the plane counts as above it, so that every crossing is proper.
            let crosses = (from >= 0.0) != (to >= 0.0);
            let point = CutPoint { along: 0.0, nodes: *nodes, share: from / (from - to) };
            crosses.then(|| (point, self.rest(level, &point).with_z(0.0)))
        };
        let across = |point: &CutPoint| {
            let section = self.mesh.section_at(level);
            let [a, b] = point.nodes.map(|i| section.points[i as usize][0]);
            a * (1.0 - point.share) + b * point.share
        };
        let mut points: Vec<_> = sides.iter().filter_map(met).collect();
        points.sort_by(|(p, _), (q, _)| across(p).total_cmp(&across(q)));
        points
    }

    /// Nodes of a level that feed a point.
    fn nodes(&self, level: usize, point: &CutPoint) -> [usize; 2] {
        point.nodes.map(|i| self.mesh.node(level, i as usize))
    }

    /// What is seen at a point of the cut, where the mesh has it.
    pub(crate) fn seen(&self, level: usize, point: &CutPoint) -> FoodVertex {
        self.vertex(self.nodes(level, point), point.share, self.rest(level, point))
    }

    /// Where the mesh has a point [m].
    fn rest(&self, level: usize, point: &CutPoint) -> Vec3 {
        let [a, b] = self.nodes(level, point).map(|node| self.model.rest_position(node));
        Vec3::from_array(std::array::from_fn(|k| (a[k] * (1.0 - point.share) + b[k] * point.share) as f32))
    }

    /// What is seen at a share of the way from a node to another, at a place of the rest frame [m].
    pub fn vertex(&self, [a, b]: [usize; 2], share: f64, rest: Vec3) -> FoodVertex {
        let (model, state) = (self.model, self.state);
        let mix = |f: &dyn Fn(usize) -> f64| between([a, b], share, f);
        let appearance = Appearance {
            changed: changed_at(state, |field| mix(&|i| field[i])),
            browning: mix(&|i| state.browning[i]),
            charring: mix(&|i| state.charring[i]),
            tissue: mix(&|i| model.second_tissue()[i]),
        };
        let field = self.map.map_or(0.0, |m| m.coordinate(mix(&|i| self.view.value(model, state, i, m.change()))));
        let moisture = mix(&|i| state.water[i] / model.initial_water()[i]);
        let rest = rest.to_array();
        let now = self.shape.moved(rest, |f| {
            let (from, to) = (f(a), f(b));
            std::array::from_fn(|axis| from[axis] * (1.0 - share) + to[axis] * share)
        });
        let (from, to) = (on_body(model, a), on_body(model, b));
        let body = std::array::from_fn(|i| from[i] * (1.0 - share as f32) + to[i] * share as f32);
        let place = Place { rest, now, body };
        vertex(model, appearance, CUT_MOISTURE * moisture, field, place, self.normal.to_array())
    }
}

/// A field at a share of the way from a node to another.
fn between([a, b]: [usize; 2], share: f64, field: &dyn Fn(usize) -> f64) -> f64 {
    field(a) * (1.0 - share) + field(b) * share
}

/// Triangles between rows of points, which need not be equally many.
fn joined(rows: &[Vec<FoodVertex>]) -> Vec<[u32; 3]> {
    let (mut triangles, mut first) = (Vec::new(), 0u32);
    for pair in rows.windows(2) {
        let [lower, upper] = [shares(&pair[0]), shares(&pair[1])];
        let above = first + lower.len() as u32;
        let (mut i, mut j) = (0, 0);
        while i + 1 < lower.len() || j + 1 < upper.len() {
            let (a, b) = (first + i as u32, above + j as u32);
            if j + 1 == upper.len() || (i + 1 < lower.len() && lower[i + 1] <= upper[j + 1]) {
                triangles.push([a, a + 1, b]);
                i += 1;
            } else {
                triangles.push([a, b + 1, b]);
                j += 1;
            }
        }
        first = above;
    }
    triangles
}

/// How far along its row each point is (0–1).
fn shares(row: &[FoodVertex]) -> Vec<f32> {
    let place = |v: &FoodVertex| Vec3::from_array(v.rest);
    let (Some(first), Some(last)) = (row.first().map(place), row.last().map(place)) else { return Vec::new() };
    let length = first.distance(last).max(f32::MIN_POSITIVE);
    row.iter().map(|v| place(v).distance(first) / length).collect()
}
