//! The skin of a piece of food: a surface with a state at every vertex, as the renderer reads it.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::Vec3;
use saute_kitchen::Piece;
use saute_kitchen::food::change::colour::Appearance;
use saute_kitchen::food::tissue::noise::{fractal, mix};
use saute_kitchen::food::{FoodModel, FoodState};
use saute_kitchen::heat::{Layout, SweptMesh};
use saute_scene::input::{FoodMesh, FoodVertex};

use crate::colour::map::ColourMap;
use crate::skin::cells::CellLook;
use crate::skin::fine::{Fine, Reads, normals};
use crate::skin::grain::{browning_palette, flesh_texture, grain_volume};
use crate::skin::poured;
use crate::skin::rim::{Rim, outward_normals};
use crate::skin::sheaths::sheathed;
use crate::view::View;

/// How far the drawn surface of a steak strays from the smooth shape [m], and over which distance [m] (chosen:
/// hand-cut).
pub(crate) const UNEVEN: [f64; 2] = [0.7e-3, 11.0e-3];
/// Moisture that shows on a cut over that of the flesh [-] (chosen: the blade wipes it).
pub(crate) const CUT_MOISTURE: f64 = 0.75;
/// Least extent of a piece to which both apply; with a smaller one they shrink [m] (chosen: a thick steak).
const TUNED_FOR: f64 = 0.022;

/// The drawn surface of one piece: which node feeds each vertex, and where it is.
#[derive(Clone, Debug)]
pub struct Skin {
    /// What the renderer caches.
    pub mesh: Arc<FoodMesh>,
    nodes: Vec<u32>,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    /// Place on the body of each vertex; empty where the look does not depend on it.
    bodies: Vec<[f32; 2]>,
    /// Nodes of the lower and the upper face at whose edge each vertex of a slice's side is; none on the faces.
    edges: Vec<Option<[u32; 2]>>,
    /// Nodes that feed each vertex of a finer skin, by weights; empty where `nodes` feeds them.
    blends: Vec<Reads>,
}

/// Size of rim and unevenness over those of a steak [-].
pub(crate) fn fineness(model: &FoodModel) -> f64 {
    let least = model.size().iter().fold(f64::INFINITY, |least, v| least.min(*v));
    (least / TUNED_FOR).min(1.0)
}

impl Skin {
    /// Builds the skin of a piece: of a slice both faces from the section's triangles and the side from its boundary,
    /// with a sharp rim between; of any other body its smooth surface.
    pub fn new(piece: &Piece) -> Self {
        let model = &piece.model;
        match model.mesh().layout() {
            Layout::Upright(mesh) => poured::fine(model)
                .or_else(|| sheathed(model))
                .map_or_else(|| Self::with_rims(piece, mesh), |fine| Self::fine(piece, fine)),
            Layout::Along(..) => Fine::of(model).map_or_else(|| Self::smooth(piece), |fine| Self::fine(piece, fine)),
            // Its vertices read several nodes each: see [`CellLook`].
            Layout::Cells(cells) => Self::empty(food_mesh(piece, cells.skin.triangles.clone())),
        }
    }

    fn empty(mesh: Arc<FoodMesh>) -> Self {
        let (nodes, bodies, edges, blends) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { mesh, nodes, positions: Vec::new(), normals: Vec::new(), bodies, edges, blends }
    }

    /// A finer surface than the nodes'.
    fn fine(piece: &Piece, fine: Fine) -> Self {
        let mut skin = Self::empty(food_mesh(piece, fine.triangles));
        let mut place_of = BTreeMap::new();
        for (node, _) in fine.reads.iter().flatten() {
            let next = place_of.len() as u32;
            place_of.entry(*node).or_insert(next);
        }
        skin.nodes = vec![0; place_of.len()];
        place_of.iter().for_each(|(node, place)| skin.nodes[*place as usize] = *node);
        skin.blends = fine.reads.iter().map(|reads| reads.map(|(node, weight)| (place_of[&node], weight))).collect();
        let bodies = fine.reads.iter().map(|reads| {
            let read = |k: usize| reads.iter().map(|(node, w)| w * on_body(&piece.model, *node as usize)[k]).sum();
            [read(0), read(1)]
        });
        skin.bodies = bodies.collect();
        skin.positions = fine.positions.iter().map(|p| p.to_array()).collect();
        skin.normals = fine.normals.iter().map(|n| n.to_array()).collect();
        skin
    }

    /// The two faces and the side of a slice.
    fn with_rims(piece: &Piece, mesh: &SweptMesh) -> Self {
        let model = &piece.model;
        let mut skin = Self::empty(food_mesh(piece, Vec::new()));
        let mut triangles = Vec::new();
        let rim = Rim::new(model, mesh);
        let last = mesh.levels.len() - 1;
        skin.add_face(&rim, 0, &mut triangles);
        skin.add_face(&rim, last, &mut triangles);
        skin.add_side(&rim, &mut triangles);
        skin.mesh = Arc::new(FoodMesh { triangles, ..(*skin.mesh).clone() });
        skin
    }

    /// The surface over the nodes of a body without rims.
    fn smooth(piece: &Piece) -> Self {
        let model = &piece.model;
        let mut normal_of = vec![Vec3::ZERO; model.mesh().node_count()];
        for (patch, normal) in model.patches().iter().zip(model.rest_normals()).take(model.fresh_faces().start) {
            let normal = Vec3::from_array(normal.map(|v| v as f32));
            normal_of[patch.node as usize] += normal * patch.area as f32;
        }
        let mut vertex_of = vec![u32::MAX; normal_of.len()];
        let (mut nodes, mut positions, mut normals) = (Vec::new(), Vec::new(), Vec::new());
        let mut vertex = |node: u32| {
            let place = &mut vertex_of[node as usize];
            if *place == u32::MAX {
                *place = nodes.len() as u32;
                nodes.push(node);
                positions.push(model.rest_position(node as usize).map(|v| v as f32));
                normals.push(normal_of[node as usize].normalize_or_zero().to_array());
            }
            *place
        };
        let triangles = model.surface().triangles.iter().map(|t| t.map(&mut vertex)).collect();
        let mesh = food_mesh(piece, triangles);
        let bodies = nodes.iter().map(|node| on_body(model, *node as usize)).collect();
        Self { mesh, nodes, positions, normals, bodies, edges: Vec::new(), blends: Vec::new() }
    }

    fn add_face(&mut self, rim: &Rim<'_>, level: usize, triangles: &mut Vec<[u32; 3]>) {
        let section = &rim.mesh.section;
        let first = self.nodes.len() as u32;
        let up = if level == 0 { -1.0 } else { 1.0 };
        let places: Vec<Vec3> = (0..section.points.len()).map(|i| rim.place(level, i)).collect();
        for (i, slope) in normals(&places, &section.triangles).into_iter().enumerate() {
            let normal = rim.outward[i].map_or(slope * up, |_| rim.normal(level, i));
            self.push(rim.mesh.node(level, i) as u32, places[i], normal);
            self.edges.push(None);
        }
        for t in &section.triangles {
            let [a, b, c] = t.map(|i| first + i);
            triangles.push(if level == 0 { [a, c, b] } else { [a, b, c] });
        }
    }

    fn add_side(&mut self, rim: &Rim<'_>, triangles: &mut Vec<[u32; 3]>) {
        let mesh = rim.mesh;
        let mut first_of = vec![0u32; rim.outward.len()];
        for (i, _) in rim.outward.iter().enumerate().filter(|(_, out)| out.is_some()) {
            first_of[i] = self.nodes.len() as u32;
            for level in 0..mesh.levels.len() {
                self.push(mesh.node(level, i) as u32, rim.place(level, i), rim.normal(level, i));
                self.edges.push(Some([0, mesh.levels.len() - 1].map(|level| mesh.node(level, i) as u32)));
            }
        }
        for &[a, b] in &mesh.section.boundary {
            let (a, b) = (first_of[a as usize], first_of[b as usize]);
            for level in 0..mesh.levels.len() as u32 - 1 {
                triangles.push([a + level, b + level, b + level + 1]);
                triangles.push([a + level, b + level + 1, a + level + 1]);
            }
        }
    }

    fn push(&mut self, node: u32, place: Vec3, normal: Vec3) {
        self.nodes.push(node);
        self.positions.push(place.to_array());
        self.normals.push(normal.to_array());
    }

    /// The nodes that feed a vertex, with their weights.
    pub(crate) fn reads(&self, vertex: usize) -> Vec<(u32, f64)> {
        match self.blends.get(vertex) {
            Some(blend) => blend.iter().map(|(k, w)| (self.nodes[*k as usize], f64::from(*w))).collect(),
            None => vec![(self.nodes[vertex], 1.0)],
        }
    }

    /// State of every vertex.
    pub fn vertices(&self, piece: &Piece, view: View, map: Option<&ColourMap>) -> Vec<FoodVertex> {
        let (model, state) = (&*piece.model, &piece.state);
        let strength = piece.sear_strength();
        let juice = model.juice_films(state);
        let seared = |node: usize| strength.get(node).copied().unwrap_or(0.0);
        if let Some(cells) = model.mesh().cells() {
            return CellLook { cells, model, state, view, map }.skin(&seared, &|node| juice[node]);
        }
        let (shape, is_poured) = (PresentShape::new(model, state), model.pool().is_some());
        let state_of = |k: usize, place: Place, normal: [f32; 3]| {
            let node = self.nodes[k] as usize;
            let field = map.map_or(0.0, |m| m.coordinate(view.value(model, state, node, m.change())));
            let moisture = state.water[node] / model.initial_water()[node];
            let seen = vertex(model, model.appearance(state, node), moisture, field, place, normal);
            let lean = if is_poured { poured::seen(model, state, node, seen.lean) } else { seen.lean };
            FoodVertex { lean, seared: seared(node) as f32, juice: juice[node] as f32, ..seen }
        };
        // The side of a slice shows the browning of its faces: it creeps over the edge.
        let crept = |k: usize| self.edges[k].map(|nodes| nodes.map(|node| state.browning[node as usize] as f32));
        let body = |k: usize| match self.edges.get(k).and_then(|_| crept(k)) {
            Some([lower, upper]) => [upper, lower],
            None => self.bodies.get(k).copied().unwrap_or_default(),
        };
        if self.blends.is_empty() {
            let vertex = |k: usize| {
                let (rest, node) = (self.positions[k], self.nodes[k] as usize);
                state_of(k, Place { rest, now: shape.moved(rest, |f| f(node)), body: body(k) }, self.normals[k])
            };
            return (0..self.nodes.len()).map(vertex).collect();
        }
        let sunk = (state.stretch.draped > 0.0).then(|| poured::draped(&self.normals));
        let normals = sunk.as_ref().unwrap_or(&self.normals);
        let nowhere = Place { rest: [0.0; 3], now: [0.0; 3], body: [0.0; 2] };
        let coarse: Vec<FoodVertex> = (0..self.nodes.len()).map(|k| state_of(k, nowhere, [0.0; 3])).collect();
        let vertex = |k: usize| {
            let (rest, blend) = (self.positions[k], &self.blends[k]);
            let mean = |f: &dyn Fn(usize) -> [f64; 3]| {
                let part = |(i, w): &(u32, f32)| f(self.nodes[*i as usize] as usize).map(|v| f64::from(*w) * v);
                blend.iter().map(part).fold([0.0; 3], |sum, v| [0, 1, 2].map(|axis| sum[axis] + v[axis]))
            };
            let place = Place { rest, now: shape.moved(rest, mean), body: body(k) };
            blended(blend.map(|(i, w)| (&coarse[i as usize], w)), place, normals[k])
        };
        (0..self.blends.len()).map(vertex).collect()
    }
}

/// A vertex between others.
fn blended(corners: [(&FoodVertex, f32); 4], place: Place, normal: [f32; 3]) -> FoodVertex {
    FoodVertex {
        rest: place.rest,
        position: place.now,
        normal,
        along: place.body[0],
        dorsal: place.body[1],
        ..FoodVertex::mean(corners)
    }
}

/// How far every node has moved from the rest shape [m].
pub(crate) struct PresentShape {
    moved: Vec<[f64; 3]>,
}

impl PresentShape {
    pub(crate) fn new(model: &FoodModel, state: &FoodState) -> Self {
        let mut moved = model.positions(state);
        for (node, shift) in moved.iter_mut().enumerate() {
            let rest = model.rest_position(node);
            (0..3).for_each(|axis| shift[axis] -= rest[axis]);
        }
        if let Layout::Upright(mesh) = model.mesh().layout() {
            bulge_sides(model, state, mesh, &mut moved);
        }
        Self { moved }
    }

    /// Where a point of the rest shape is now; `at` reads the shift off its nodes.
    pub(crate) fn moved(&self, rest: [f32; 3], at: impl Fn(&dyn Fn(usize) -> [f64; 3]) -> [f64; 3]) -> [f32; 3] {
        let shift = at(&|node| self.moved[node]);
        std::array::from_fn(|axis| rest[axis] + shift[axis] as f32)
    }
}

/// Moves the side of a slice out or in where its levels contract less or more than the whole [m].
fn bulge_sides(model: &FoodModel, state: &FoodState, mesh: &SweptMesh, moved: &mut [[f64; 3]]) {
    let shifts = model.edge_shifts(state);
    for (i, out) in outward_normals(&mesh.section).into_iter().enumerate() {
        let Some(out) = out else { continue };
        for (level, shift) in shifts.iter().enumerate() {
            let shifted = &mut moved[mesh.node(level, i)];
            shifted[0] += shift * f64::from(out.x);
            shifted[1] += shift * f64::from(out.y);
        }
    }
}

/// A point in the rest shape and in the present one [m], and where on the body that is.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub(crate) rest: [f32; 3],
    pub(crate) now: [f32; 3],
    /// Share of the body's length, and belly to back: see [`FoodVertex`].
    pub(crate) body: [f32; 2],
}

pub(crate) fn vertex(
    model: &FoodModel,
    a: Appearance,
    moisture: f64,
    field: f32,
    place: Place,
    normal: [f32; 3],
) -> FoodVertex {
    let lab = |lab: saute_kitchen::food::Lab| lab.0.map(|v| 0.01 * v as f32);
    // A film of water is on raw flesh; cooked flesh is matt, and fried flesh sheds it (chosen).
    let done = a.changed[model.change_count() - 1];
    let matt = (1.0 - 0.5 * done) * (1.0 - 0.9 * (2.5 * a.browning).min(1.0));
    let wet = ((moisture - 0.25) / 0.75).clamp(0.0, 1.0) * matt;
    FoodVertex {
        rest: place.rest,
        position: place.now,
        normal,
        lean: lab(model.palette().without_second(a)),
        fat: lab(model.palette().fat_unbrowned(a)),
        browning: a.browning as f32,
        charring: a.charring as f32,
        wetness: wet as f32,
        cooked: a.opaque() as f32,
        field,
        along: place.body[0],
        dorsal: place.body[1],
        seared: 0.0,
        juice: 0.0,
    }
}

/// Where a node of a body that is carried along stations is: share of the length, and belly (−1) to back (1).
pub(crate) fn on_body(model: &FoodModel, node: usize) -> [f32; 2] {
    let Layout::Along(mesh, stations) = model.mesh().layout() else { return [0.0; 2] };
    let n = mesh.nodes_per_level();
    let (level, i) = (node / n, node % n);
    let points = &stations[level].section.points;
    let reach = points.iter().fold(1e-9f64, |most, p| most.max(p[0].abs()));
    [mesh.levels[level] / mesh.thickness(), points[i][0] / reach].map(|v| v as f32)
}

/// A hand-cut surface: faces undulate, and the side with them. Where both meet, both give the same.
pub(crate) fn uneven(p: Vec3, model: &FoodModel, mesh: &SweptMesh) -> Vec3 {
    // A liquid sets smooth.
    if model.pool().is_some() {
        return Vec3::ZERO;
    }
    let (thickness, [height, run]) = (mesh.thickness() as f32, UNEVEN.map(|v| v * fineness(model)));
    let own = model.natural().map_or(0, |_| mix(model.seed()));
    let wave = |seed: u64| (height * fractal(seed ^ own, p.to_array().map(|v| f64::from(v) / run))) as f32;
    let face = (2.0 * p.z.abs() / thickness).powi(8);
    Vec3::new(wave(21), wave(22), wave(23) * face)
}

fn key(piece: &Piece) -> u64 {
    let bits =
        piece.model.size().into_iter().map(f64::to_bits).chain([piece.seed, piece.model.mesh().node_count() as u64]);
    let bits = bits.chain([u64::from(piece.model.natural().is_some())]);
    let reach = piece.model.pool().map_or(&[][..], |pool| &pool.reach[..]);
    let dome = piece.model.pool().map(|pool| [pool.dome.at[0], pool.dome.at[1], pool.dome.height, pool.height[0][0]]);
    let bits = bits.chain(reach.iter().chain(dome.iter().flatten()).map(|v| v.to_bits()));
    let text = piece.kind.bytes().map(u64::from);
    bits.chain(text).fold(0x5a07e, |hash, v| mix(hash ^ mix(v)))
}

/// Extent of the texture over which pieces are spread [m] (chosen: several periods of its largest pattern).
const TEXTURE_EXTENT: f32 = 0.4;

/// Where in the texture of its flesh a piece is [m].
fn texture_place(seed: u64) -> Vec3 {
    let share = |axis: u64| (mix(seed ^ mix(0x7e97_0000 + axis)) >> 40) as f32 / (1u64 << 24) as f32;
    Vec3::new(share(0), share(1), share(2)) * TEXTURE_EXTENT
}

fn food_mesh(piece: &Piece, triangles: Vec<[u32; 3]>) -> Arc<FoodMesh> {
    let model = &piece.model;
    Arc::new(FoodMesh {
        key: key(piece),
        triangles,
        texture: flesh_texture(model),
        texture_place: texture_place(piece.seed),
        grew_along_x: model.description().form.grown_along() == 0,
        palette: browning_palette(model),
        grain: grain_volume(model),
    })
}
