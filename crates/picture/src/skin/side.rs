//! The side of a natural slice as it is drawn: bulged and slanted by up to a millimetre, while heat sees a vertical wall.

use core::f32::consts::TAU;

use glam::Vec3;
use saute_kitchen::food::FoodModel;
use saute_kitchen::food::tissue::noise::uniform;
use saute_kitchen::heat::SweptMesh;

/// Slant at the rims over the bulge at mid-height [-] (chosen: a knife leans a little).
const SLANT: f32 = 0.6;

/// How far the side protrudes at a level [m], and its slope over the height [-]; both 0 in a plain piece.
pub(crate) fn bulge(model: &FoodModel, mesh: &SweptMesh, level: usize, out: Vec3) -> [f32; 2] {
    let Some(form) = model.natural() else { return [0.0; 2] };
    let share = |index: u64| uniform(model.seed(), index) as f32;
    let most = 1e-3 * form.bulge_mm as f32;
    let bulge = most * (0.45 + 0.55 * share(701));
    let lean = TAU * share(702);
    let slant = most * SLANT * share(703) * (out.x * lean.cos() + out.y * lean.sin());
    let half = 0.5 * mesh.thickness() as f32;
    let height = mesh.levels[level] as f32 / half - 1.0;
    [bulge * (1.0 - height * height) + slant * height, (slant - 2.0 * bulge * height) / half]
}
