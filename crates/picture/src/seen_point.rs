//! The point of the flesh that a place in the window shows, on the surface or on a cut.

use std::sync::Arc;

use glam::Vec3;
use saute_kitchen::food::FoodModel;
use saute_kitchen::heat::mesh::cells::CellSlice;
use saute_kitchen::heat::{BodyMesh, Cut, SweptMesh};
use saute_kitchen::{Kitchen, Piece};
use saute_recipe::probe::{NodeShares, SeenPoint};
use saute_scene::input::{FoodLook, FoodVertex, SceneInput};

use crate::skin::cells::longest_axis;
use crate::skin::surface::Skin;
use crate::stage::{Stage, half_length};

/// A ray [m].
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Origin [m].
    pub origin: Vec3,
    /// Direction.
    pub direction: Vec3,
}

/// A triangle that a ray meets.
#[derive(Clone, Copy)]
struct Hit {
    /// Along the ray [m].
    away: f32,
    corners: [u32; 3],
    weights: [f32; 3],
}

impl Stage {
    /// The point of a piece that a ray in the world meets first, in the scene that was drawn last; `cut` is the place
    /// of the cut (−1…1), if there is one.
    pub fn seen_point(&self, kitchen: &Kitchen, input: &SceneInput, cut: Option<f64>, ray: Ray) -> Option<SeenPoint> {
        let pieces = kitchen.pieces().iter().zip(&input.foods);
        let met = pieces.filter_map(|(piece, food)| {
            let (met, on_cut) = meet_food(food, ray)?;
            Some((met, on_cut, piece))
        });
        let (met, on_cut, piece) = met.min_by(|a, b| a.0.away.total_cmp(&b.0.away))?;
        let vertices = match cut {
            Some(place) if on_cut => Vertices::of_cut(piece, place)?,
            _ => Vertices::Skin(self.skin(&piece.id)?),
        };
        let mut shares = NodeShares::default();
        for (corner, weight) in met.corners.into_iter().zip(met.weights) {
            shares.add(&vertices.shares(&piece.model, corner as usize)?, f64::from(weight));
        }
        Some(SeenPoint { piece: piece.id.clone(), shares, model: Arc::clone(&piece.model) })
    }
}

/// Returns where a ray first meets what is drawn of a food, and true if that is on its cut.
fn meet_food(food: &FoodLook, ray: Ray) -> Option<(Hit, bool)> {
    let inverse = food.world_from_rest.inverse();
    let local =
        Ray { origin: inverse.transform_point3(ray.origin), direction: inverse.transform_vector3(ray.direction) };
    let hidden = |rest: Vec3| food.slice.as_ref().is_some_and(|cut| cut.normal.dot(rest - cut.point) > 1e-5);
    let skin = meet(&food.mesh.triangles, &food.vertices, local, hidden).map(|met| (met, false));
    let cut = food.slice.as_ref().and_then(|cut| meet(&cut.triangles, &cut.vertices, local, |_| false));
    skin.into_iter().chain(cut.map(|met| (met, true))).min_by(|a, b| a.0.away.total_cmp(&b.0.away))
}

/// The nearest triangle that a ray meets where it is not hidden.
fn meet(triangles: &[[u32; 3]], vertices: &[FoodVertex], ray: Ray, hidden: impl Fn(Vec3) -> bool) -> Option<Hit> {
    let at = |i: u32| Vec3::from(vertices[i as usize].position);
    let rest = |i: u32| Vec3::from(vertices[i as usize].rest);
    let met = triangles.iter().filter(|t| t.iter().all(|i| (*i as usize) < vertices.len())).filter_map(|&corners| {
        let [a, b, c] = corners.map(at);
        let (ab, ac) = (b - a, c - a);
        let across = ray.direction.cross(ac);
        let scale = ab.dot(across);
        let from = ray.origin - a;
        let v = from.dot(across) / scale;
        let turned = from.cross(ab);
        let (w, away) = (ray.direction.dot(turned) / scale, ac.dot(turned) / scale);
        // A degenerate triangle gives no number, which is in no range.
        if !(v >= 0.0 && w >= 0.0 && v + w <= 1.0 && away > 0.0) {
            return None;
        }
        let weights = [1.0 - v - w, v, w];
        let shown: Vec3 = (0..3).map(|k| rest(corners[k]) * weights[k]).sum();
        (!hidden(shown)).then_some(Hit { away, corners, weights })
    });
    met.min_by(|a, b| a.away.total_cmp(&b.away))
}

impl Skin {
    /// The nodes that a vertex reads.
    fn shares(&self, model: &FoodModel, vertex: usize) -> NodeShares {
        match model.mesh() {
            BodyMesh::Cells(cells) => {
                let (nodes, weights) = (cells.skin.nodes[vertex], cells.skin.weights[vertex]);
                NodeShares(nodes.into_iter().zip(weights).collect())
            }
            BodyMesh::Swept(_) => NodeShares(self.reads(vertex)),
        }
    }
}

/// Where the drawn vertices of a piece or of its cut come from.
enum Vertices<'a> {
    Skin(&'a Skin),
    Cut(&'a SweptMesh, Cut),
    CellCut(CellSlice),
}

impl<'a> Vertices<'a> {
    /// Those of the cut at `place` (−1…1) along a piece.
    fn of_cut(piece: &'a Piece, place: f64) -> Option<Self> {
        let (model, x) = (&piece.model, place * half_length(piece));
        match model.mesh() {
            BodyMesh::Cells(cells) => cells.slice(longest_axis(model), x).ok().map(Self::CellCut),
            BodyMesh::Swept(mesh) => Some(Self::Cut(mesh, model.cut_across(x))),
        }
    }

    /// The nodes that a vertex reads.
    fn shares(&self, model: &FoodModel, vertex: usize) -> Option<NodeShares> {
        Some(match self {
            Self::Skin(skin) => skin.shares(model, vertex),
            Self::CellCut(cut) => NodeShares(cut.weights.get(vertex)?.clone()),
            Self::Cut(mesh, cut) => {
                let point = cut.points.get(vertex % cut.points.len().max(1))?;
                let level = vertex / cut.points.len();
                let node = |k: usize| mesh.node(level, point.nodes[k] as usize) as u32;
                NodeShares(vec![(node(0), 1.0 - point.share), (node(1), point.share)])
            }
        })
    }
}
