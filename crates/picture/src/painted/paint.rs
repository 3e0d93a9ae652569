//! The colour of a food at a vertex.

use glam::{Vec3, Vec3Swizzles};
use saute_kitchen::food::change::colour::Appearance;
use saute_kitchen::food::{FoodModel, Lab};
use saute_scene::input::{FoodLook, FoodVertex, SEAR_SETS, SearLook};

/// The flesh of a food and the lines on it.
pub(super) struct Paint<'a> {
    model: &'a FoodModel,
    sear: &'a [[Option<SearLook>; SEAR_SETS]; 2],
    /// Height of the mesh's frame over the rest frame [m].
    lifted: f64,
}

/// Ease from 0 to 1 between two edges [-].
fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

impl<'a> Paint<'a> {
    pub(super) fn of(model: &'a FoodModel, look: &'a FoodLook) -> Self {
        Self { model, sear: &look.sear, lifted: model.rest_position(0)[2] - model.mesh().position(0)[2] }
    }

    /// Colour of a vertex in linear sRGB, 0 to 1 [-].
    pub(super) fn colour(&self, v: &FoodVertex) -> [f32; 3] {
        let [x, y, z] = v.rest.map(f64::from);
        let place = [x, y, z - self.lifted];
        let [browning, charring] = self.on_lines(v).map(f64::from);
        let seen = Appearance { browning, charring, ..Appearance::default() };
        let (palette, tissue) = (self.model.palette(), self.model.tissue_at(place));
        let second = palette.second_tissue();
        let lean = Lab(std::array::from_fn(|k| 100.0 * f64::from(v.lean[k]) + tissue * second[k]));
        let fat = Lab(v.fat.map(|channel| 100.0 * f64::from(channel)));
        let share = self.model.marbling().at(place);
        palette.lean_over(lean, seen).lerp(palette.fat_over(fat, seen), share).linear_srgb().map(|c| c as f32)
    }

    /// Browning and charring with the lines that ridges seared, as the renderer lays them.
    fn on_lines(&self, v: &FoodVertex) -> [f32; 2] {
        let sets = &self.sear[usize::from(v.normal[2] > 0.0)];
        let facing = smoothstep(0.45, 0.85, v.normal[2].abs());
        let (mut share, mut came) = (0.0, [0.0; 2]);
        for set in sets.iter().flatten().filter(|set| set.pitch > 0.0) {
            let across = Vec3::from(v.rest).xy().dot(glam::Vec2::new(set.direction.y, -set.direction.x)) - set.phase;
            let place = across / set.pitch + 0.5;
            let away = (place - place.floor() - 0.5).abs() * set.pitch;
            let on = 1.0 - smoothstep(0.30 * set.width, 0.70 * set.width, away);
            share += set.share;
            for (sum, [line, between]) in came.iter_mut().zip([set.browning, set.charring]) {
                *sum += (between + on * (line - between)) * v.seared;
            }
        }
        let elsewhere = (1.0 - share * facing).max(0.0);
        let [browning, charring] = [v.browning, v.charring].map(|value| value * elsewhere);
        [browning + came[0] * facing, charring + came[1] * facing].map(|value| value.min(1.0))
    }
}
