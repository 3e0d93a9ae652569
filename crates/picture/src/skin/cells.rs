//! Skin and cuts of a piece with a cell mesh: their points read nodes by weights.

use glam::Vec3;
use saute_kitchen::food::change::colour::Appearance;
use saute_kitchen::food::readings::changed_at;
use saute_kitchen::food::{FoodModel, FoodState};
use saute_kitchen::heat::CellMesh;
use saute_scene::input::{FoodVertex, SliceLook};

use crate::colour::map::ColourMap;
use crate::skin::surface::{CUT_MOISTURE, Place, vertex};
use crate::view::View;

/// Reads a field of the nodes at one point.
pub(crate) type Reads<'a> = &'a dyn Fn(&dyn Fn(usize) -> f64) -> f64;

/// A piece and how it is viewed.
#[derive(Clone, Copy)]
pub(crate) struct CellLook<'a> {
    pub(crate) cells: &'a CellMesh,
    pub(crate) model: &'a FoodModel,
    pub(crate) state: &'a FoodState,
    pub(crate) view: View,
    pub(crate) map: Option<&'a ColourMap>,
}

impl CellLook<'_> {
    /// State of every vertex of the skin; node fields give how dark seared lines are and how much juice lies on them.
    pub(crate) fn skin(&self, seared: &dyn Fn(usize) -> f64, juice: &dyn Fn(usize) -> f64) -> Vec<FoodVertex> {
        let skin = &self.cells.skin;
        let of = |v: usize| {
            let corner = |f: &dyn Fn(usize) -> f64, k: usize| skin.weights[v][k] * f(skin.nodes[v][k] as usize);
            let reads = |f: &dyn Fn(usize) -> f64| (0..4).map(|k| corner(f, k)).sum();
            let seen = self.vertex(&reads, skin.vertices[v], skin.normals[v], 1.0);
            FoodVertex { seared: reads(seared) as f32, juice: reads(juice) as f32, ..seen }
        };
        (0..skin.vertices.len()).map(of).collect()
    }

    /// The cut across the longest axis at `x` [m].
    pub(crate) fn slice(&self, x: f64) -> Option<SliceLook> {
        let axis = longest_axis(self.model);
        let cut = self.cells.slice(axis, x).ok()?;
        let mut normal = [0.0; 3];
        normal[axis] = 1.0;
        let of = |i: usize| {
            let reads = |f: &dyn Fn(usize) -> f64| cut.read(i, f);
            self.vertex(&reads, cut.points[i], normal, CUT_MOISTURE)
        };
        let vertices = (0..cut.points.len()).map(of).collect();
        let normal = Vec3::from_array(normal.map(|v| v as f32));
        Some(SliceLook { point: normal * x as f32, normal, vertices, triangles: cut.triangles, ghost: true })
    }

    /// Appearance of a point, and the value of the view's field there.
    pub(crate) fn appearance(&self, reads: Reads) -> (Appearance, f64) {
        let state = self.state;
        let appearance = Appearance {
            changed: changed_at(state, |field| reads(&|i| field[i])),
            browning: reads(&|i| state.browning[i]),
            charring: reads(&|i| state.charring[i]),
            tissue: reads(&|i| self.model.second_tissue()[i]),
        };
        let change = self.map.and_then(ColourMap::change);
        (appearance, reads(&|i| self.view.value(self.model, state, i, change)))
    }

    fn vertex(&self, reads: Reads, rest: [f64; 3], normal: [f64; 3], moist: f64) -> FoodVertex {
        let (appearance, value) = self.appearance(reads);
        let moisture = moist * reads(&|i| self.state.water[i] / self.model.initial_water()[i]);
        let field = self.map.map_or(0.0, |m| m.coordinate(value));
        let single = |v: [f64; 3]| v.map(|x| x as f32);
        let place =
            Place { rest: single(rest), now: single(rest.map(|v| v * self.state.stretch.lateral)), body: [0.0; 2] };
        vertex(self.model, appearance, moisture, field, place, single(normal))
    }
}

/// The axis across which a piece is cut.
pub(crate) fn longest_axis(model: &FoodModel) -> usize {
    if model.size()[0] >= model.size()[1] { 0 } else { 1 }
}
