//! The cut face of a slice whose faces have steps: it ends where its drawn surface meets the plane of the cut, and
//! every column of it follows the step above or below.

use glam::{Vec2, Vec3};
use saute_kitchen::heat::Cut;
use saute_scene::input::FoodVertex;

use crate::cut::contour::Outside;
use crate::cut::face::CutFace;
use crate::cut::rim::Plane;
use crate::skin::surface::CUT_MOISTURE;

/// Lines of the drawn surface in the plane of a cut, each ordered along the cut or, on the sides, upwards.
pub(crate) struct Steps {
    lower: Vec<FoodVertex>,
    upper: Vec<FoodVertex>,
    sides: [Vec<FoodVertex>; 2],
}

impl Steps {
    /// None where the plane meets no such surface.
    pub(crate) fn new(outside: Outside<'_>, plane: Plane, normal: Vec3) -> Option<Self> {
        let along = |v: &FoodVertex| plane.along(Vec3::from(v.rest));
        let mut lines = outside.contour(plane.point(Vec2::ZERO), normal);
        let wide = |line: &[FoodVertex]| along(&line[line.len() - 1]) - along(&line[0]);
        lines.iter_mut().for_each(|line| {
            line.iter_mut().for_each(|v| {
                let wetness = CUT_MOISTURE as f32 * v.wetness;
                *v = FoodVertex { normal: normal.to_array(), wetness, juice: 0.0, seared: 0.0, ..*v };
            });
        });
        let most = lines.iter().map(|line| wide(line).abs()).fold(0.0, f32::max);
        let (mut faces, mut sides): (Vec<_>, Vec<_>) =
            lines.into_iter().partition(|line| wide(line).abs() > 0.5 * most);
        let height = |line: &[FoodVertex]| line.iter().map(|v| v.rest[2]).sum::<f32>() / line.len() as f32;
        // A wall between two sheaths may lean a little; along the cut no point is before the last one.
        faces.iter_mut().for_each(|line| {
            if wide(line) < 0.0 {
                line.reverse();
            }
            line.sort_by(|a, b| along(a).total_cmp(&along(b)));
        });
        faces.sort_by(|a, b| height(a).total_cmp(&height(b)));
        sides.iter_mut().for_each(|line| line.sort_by(|a, b| a.rest[2].total_cmp(&b.rest[2])));
        sides.sort_by(|a, b| along(&a[0]).total_cmp(&along(&b[0])));
        let [lower, upper] = <[_; 2]>::try_from(faces).ok()?;
        Some(Self { lower, upper, sides: <[_; 2]>::try_from(sides).ok()? })
    }

    /// The points of every level, in order along the cut.
    pub(crate) fn rows(&self, face: &CutFace<'_>, plane: Plane, cut: &Cut) -> Vec<Vec<FoodVertex>> {
        let last = face.mesh.levels.len() - 1;
        (0..=last)
            .map(|level| match level {
                0 => self.lower.clone(),
                _ if level == last => self.upper.clone(),
                _ => self.row(face, plane, cut, level),
            })
            .collect()
    }

    /// A level between the faces: a column under each point of the nearer face.
    fn row(&self, face: &CutFace<'_>, plane: Plane, cut: &Cut, level: usize) -> Vec<FoodVertex> {
        let last = face.mesh.levels.len() - 1;
        let (near, line) = if 2 * level > last { (last, &self.upper) } else { (0, &self.lower) };
        let flesh =
            |level: usize| -> Vec<FoodVertex> { cut.points.iter().map(|point| face.seen(level, point)).collect() };
        let (here, edge) = (flesh(level), flesh(near));
        let inner = &line[1..line.len() - 1];
        let column = |top: &FoodVertex| {
            let place = |row: &[FoodVertex]| at(row, plane.along(Vec3::from(top.rest)), plane);
            let (own, flush) = (place(&here), place(&edge));
            let shift = Vec3::from(top.rest) - Vec3::from(flush.rest);
            let moved = |p: [f32; 3]| (Vec3::from(p) + shift).to_array();
            FoodVertex { rest: moved(own.rest), position: moved(own.position), ..own }
        };
        let height = here[0].rest[2];
        let [left, right] = [0, 1].map(|k| upwards(&self.sides[k], height));
        [left].into_iter().chain(inner.iter().map(column)).chain([right]).collect()
    }
}

/// A row of vertices at a place along the cut.
fn at(row: &[FoodVertex], along: f32, plane: Plane) -> FoodVertex {
    between(row, along, |v| plane.along(Vec3::from(v.rest)))
}

/// A side at a height.
fn upwards(side: &[FoodVertex], height: f32) -> FoodVertex {
    between(side, height, |v| v.rest[2])
}

/// A line of vertices where a measure that ascends along it has a value.
fn between(line: &[FoodVertex], value: f32, measure: impl Fn(&FoodVertex) -> f32) -> FoodVertex {
    let right = line.partition_point(|v| measure(v) < value).clamp(1, line.len() - 1);
    let (a, b) = (&line[right - 1], &line[right]);
    let run = measure(b) - measure(a);
    let share = if run > 0.0 { ((value - measure(a)) / run).clamp(0.0, 1.0) } else { 0.0 };
    a.lerp(b, share)
}
