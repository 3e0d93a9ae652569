//! The surface of a slice across a shaft: its sheaths form steps, as they slipped when it was cut.
//!
//! The slip is drawn; heat sees the sheaths flush. What protrudes below is hidden by what the slice lies on.

use glam::{Vec2, Vec3};
use saute_kitchen::food::tissue::noise::uniform;
use saute_kitchen::food::{FoodModel, Form};
use saute_kitchen::heat::SweptMesh;

use crate::skin::fine::{Fine, Reads, normals};
use crate::skin::rim::{rim_inset, rim_radius};
use crate::skin::surface::uneven;

/// Levels at either end of which each has its row on the side, and how many are between rows farther in (chosen: browning ends
/// near the faces, and steps on both faces cost triangles enough).
const SIDE_DENSE: usize = 3;
const SIDE_APART: usize = 5;
/// How far the edges of a sheath are rounded down [m], and over which breadth [m] (chosen).
const ROUNDED: [f32; 2] = [0.22e-3, 0.35e-3];
/// Share of the sheaths that slip [-] (chosen: an inner one sticks to its neighbours now and then).
const SLIPS: f64 = 0.7;
/// Sheaths thinner than this are drawn with the next [m] (chosen: less than two rounded edges).
const THINNEST: f32 = 0.9e-3;

/// True if the faces of a piece have steps: a natural slice with sheaths.
pub(crate) fn stands_in_steps(model: &FoodModel) -> bool {
    let sheaths = model.description().form == Form::Ring && !model.tissue_field().is_plain();
    sheaths && model.natural().is_some_and(|form| form.slip_mm > 0.0)
}

/// The surface of a slice that is in steps; none of other pieces.
pub(crate) fn sheathed(model: &FoodModel) -> Option<Fine> {
    let slip = 1e-3 * model.natural()?.slip_mm;
    let mesh = model.mesh().swept().filter(|mesh| mesh.is_upright() && !mesh.section.triangles.is_empty())?;
    if !stands_in_steps(model) {
        return None;
    }
    let mut ring = Ring { model, mesh, edge: edge(mesh), slip, fine: Fine::default() };
    ring.side();
    ring.face(0);
    ring.face(mesh.levels.len() - 1);
    ring.fine.normals = normals(&ring.fine.positions, &ring.fine.triangles);
    Some(ring.fine)
}

/// A vertex around the slice: where it is in the section, outwards of it, and the node of the rim that feeds it.
struct EdgePoint {
    at: Vec2,
    out: Vec3,
    node: u32,
}

struct Ring<'a> {
    model: &'a FoodModel,
    mesh: &'a SweptMesh,
    edge: Vec<EdgePoint>,
    slip: f64,
    fine: Fine,
}

/// The outline, at every node of the rim.
fn edge(mesh: &SweptMesh) -> Vec<EdgePoint> {
    let rim = mesh.section.rim();
    let at = |k: usize| {
        let [x, y] = mesh.section.points[rim[k % rim.len()] as usize];
        Vec2::new(x as f32, y as f32)
    };
    let point = |k: usize| {
        let along = at(k + 1) - at(k + rim.len() - 1);
        EdgePoint { at: at(k), out: Vec3::new(along.y, -along.x, 0.0).normalize_or_zero(), node: rim[k] }
    };
    (0..rim.len()).map(point).collect()
}

impl Ring<'_> {
    /// Adds the outer side.
    fn side(&mut self) {
        let last = self.mesh.levels.len() - 1;
        let seen = |level: &usize| level.min(&(last - level)) < &SIDE_DENSE || level.is_multiple_of(SIDE_APART);
        for level in (0..=last).filter(seen) {
            let row = self.row(|ring, point| ring.on_side(point, level));
            if level > 0 {
                self.strip(row - self.edge.len() as u32, row);
            }
        }
    }

    /// Adds a face from the rim inwards, a step between any two sheaths.
    fn face(&mut self, level: usize) {
        let top = level > 0;
        let mut before = self.row(|ring, point| ring.on_side(point, level));
        let sheaths = self.sheaths();
        for (k, sheath) in sheaths.iter().enumerate().rev() {
            let outer = k + 1 == sheaths.len();
            let slip = self.slip_of(k, outer);
            let inner = k.checked_sub(1).map(|k| &sheaths[k]);
            // Outer edge, where it is rounded off, its inner edge in the same way; the last one ends in the middle.
            if !outer {
                let lower = self.row(|ring, j| ring.inside(j, sheath[j], slip - lowered(top, ROUNDED[0]), level));
                self.join(before, lower, top);
                before = lower;
            }
            let breadth = if outer { rim_radius(self.model) + ROUNDED[1] } else { ROUNDED[1] };
            // A sheath that is thin somewhere has a narrower rounding there.
            let [most, inwards] = if outer { [0.8, 0.2] } else { [0.3, 1.0] };
            let within =
                |j: usize, breadth: f32| breadth.min(most * (sheath[j] - inner.map_or(0.0, |inner| inner[j])).max(0.0));
            let crest = self.row(|ring, j| ring.inside(j, sheath[j] - within(j, breadth), slip, level));
            self.join(before, crest, top);
            before = crest;
            if let Some(inner) = inner {
                let crest = self.row(|ring, j| ring.inside(j, inner[j] + inwards * within(j, ROUNDED[1]), slip, level));
                self.join(before, crest, top);
                let lower = self.row(|ring, j| ring.inside(j, inner[j], slip - lowered(top, ROUNDED[0]), level));
                self.join(crest, lower, top);
                before = lower;
            } else {
                let middle = self.row(|ring, j| ring.inside(j, 0.0, slip, level));
                self.join(before, middle, top);
            }
        }
    }

    /// Outer radius of every sheath around the slice, from the middle outwards; the last one is the slice's own [m].
    fn sheaths(&self) -> Vec<Vec<f32>> {
        let field = self.model.tissue_field();
        let borders: Vec<Vec<f64>> =
            self.edge.iter().map(|p| field.sheath_borders(p.at.to_array().map(f64::from))).collect();
        let least = self.edge.iter().map(|p| p.at.length()).fold(f32::INFINITY, f32::min);
        // Inside the rounded rim of the slice.
        let rim = rim_radius(self.model) + THINNEST;
        let mut sheaths: Vec<Vec<f32>> = Vec::new();
        for k in 0..borders.first().map_or(0, Vec::len) {
            let radii: Vec<f32> = borders.iter().map(|b| b[k] as f32).collect();
            let largest = radii.iter().copied().fold(0.0, f32::max);
            let from = sheaths.last().map_or(0.0, |last: &Vec<f32>| last[0]);
            if largest < least - 0.5 * rim && radii[0] - from > THINNEST {
                // Nowhere beyond the slice's own edge.
                let inside = radii.iter().zip(&self.edge).map(|(r, p)| r.min(p.at.length() - rim));
                sheaths.push(inside.collect());
            }
        }
        sheaths.push(self.edge.iter().map(|p| p.at.length()).collect());
        sheaths
    }

    /// How far a sheath slipped upwards [m].
    fn slip_of(&self, sheath: usize, outer: bool) -> f32 {
        let share = |index: u64| uniform(self.model.seed(), index + sheath as u64);
        if outer || share(720) > SLIPS {
            return 0.0;
        }
        (self.slip * (1.6 * share(760) - 0.6)) as f32
    }

    /// Adds a vertex for each point of the edge; returns the index of the first.
    fn row(&mut self, at: impl Fn(&Self, usize) -> (Vec3, Reads)) -> u32 {
        let first = self.fine.positions.len() as u32;
        for j in 0..self.edge.len() {
            let (p, reads) = at(self, j);
            self.fine.positions.push(p);
            self.fine.reads.push(reads);
        }
        first
    }

    fn on_side(&self, j: usize, level: usize) -> (Vec3, Reads) {
        let EdgePoint { at, out, node } = &self.edge[j];
        let node = self.mesh.node(level, *node as usize);
        let p = at.extend(self.model.rest_position(node)[2] as f32);
        let p = p + rim_inset(self.model, self.mesh, level, *out) + uneven(p, self.model, self.mesh);
        let node = node as u32;
        (p, [(node, 1.0), (node, 0.0), (node, 0.0), (node, 0.0)])
    }

    /// A point of a face at a radius, lifted by a slip.
    fn inside(&self, j: usize, radius: f32, slip: f32, level: usize) -> (Vec3, Reads) {
        let at = self.edge[j].at.normalize_or_zero() * radius;
        let found = self.mesh.locate_or_nearest(at.to_array().map(f64::from));
        let node = |k: usize| self.mesh.node(level, found.nodes[k] as usize);
        let weight = |k: usize| found.weights[k] as f32;
        let z: f32 = (0..3).map(|k| weight(k) * self.model.rest_position(node(k))[2] as f32).sum();
        let p = at.extend(z);
        let p = p + uneven(p, self.model, self.mesh) + Vec3::Z * slip;
        let reads = [0, 1, 2].map(|k| (node(k) as u32, weight(k)));
        (p, [reads[0], reads[1], reads[2], (reads[0].0, 0.0)])
    }

    /// Joins two rows of a face, the second farther inside.
    fn join(&mut self, outer: u32, inner: u32, top: bool) {
        if top { self.strip(outer, inner) } else { self.strip(inner, outer) }
    }

    /// Joins two rows; the second is higher on the side.
    fn strip(&mut self, a: u32, b: u32) {
        let count = self.edge.len() as u32;
        for k in 0..count {
            let next = (k + 1) % count;
            self.fine.triangles.extend([[a + k, a + next, b + next], [a + k, b + next, b + k]]);
        }
    }
}

/// Shift down of a rounded edge on the upper face, up on the lower [m].
fn lowered(top: bool, by: f32) -> f32 {
    if top { by } else { -by }
}
