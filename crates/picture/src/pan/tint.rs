//! Heat tint of the pan as a small picture of its unrolled inside for the renderer.

use std::sync::Arc;

use saute_kitchen::heat::Located;
use saute_kitchen::pan::PanModel;
use saute_kitchen::{Kitchen, celsius};
use saute_scene::input::{FILM_SIZE, TINT_RANGE, TintPicture};

use crate::pace::Pace;

/// Ticks between two pictures (chosen: ten seconds; everything still is redrawn for each that differs).
const LOOK_TICKS: u64 = 100;
/// Looks at foods and film for which there is one at the tint at most (chosen: the same, where those are apart).
const LOOKS: u64 = 30;
/// Temperatures that differ by less look the same [K] (chosen).
const SAME: f64 = 2.0;

/// Caches where the texels are on the pan's mesh, and the picture while it is valid.
#[derive(Clone, Debug, Default)]
pub(crate) struct PanTint {
    /// The pan to which the places belong.
    pan: usize,
    places: Vec<Located>,
    drawn: Option<(u64, Arc<TintPicture>)>,
}

impl PanTint {
    /// Returns the picture; it may be up to an interval old.
    pub(crate) fn picture(&mut self, kitchen: &Kitchen, pace: &Pace) -> Arc<TintPicture> {
        let model = kitchen.pan_model();
        let pan = std::ptr::from_ref(model) as usize;
        if self.pan != pan || self.places.is_empty() {
            *self = Self { pan, places: places(model), drawn: None };
        }
        let look = kitchen.tick() / LOOK_TICKS.max(LOOKS * pace.every());
        match &self.drawn {
            Some((drawn, picture)) if *drawn == look => Arc::clone(picture),
            _ => {
                let fresh = Arc::new(TintPicture { texels: self.texels(kitchen) });
                let kept = self.drawn.take().map(|(_, old)| old).filter(|old| *old == fresh).unwrap_or(fresh);
                self.drawn = Some((look, Arc::clone(&kept)));
                kept
            }
        }
    }

    fn texels(&self, kitchen: &Kitchen) -> Vec<[u8; 4]> {
        let Some(tint) = &kitchen.pan_model().description.heat_tint else {
            return vec![texel([1.0; 3]); self.places.len()];
        };
        let state = kitchen.pan_state();
        let highest = |at: &Located| SAME * (celsius(state.peak_at(at)) / SAME).round();
        self.places.iter().map(|at| texel(tint.share_at(highest(at)))).collect()
    }
}

fn texel(share: [f64; 3]) -> [u8; 4] {
    let [r, g, b] = share.map(|v| (255.0 * (v / f64::from(TINT_RANGE)).clamp(0.0, 1.0)).round() as u8);
    [r, g, b, 255]
}

/// Texels farther out than this share of the mesh's reach are read there [-] (chosen: half a texel within its rim, as a search
/// for the nearest node takes long).
const OUTMOST: f64 = 0.985;

/// Where each texel is on the pan's mesh; of those beyond its rim the place on the way to the middle.
fn places(model: &PanModel) -> Vec<Located> {
    let wall = &model.description.wall;
    let floor = model.description.floor.radius_mm;
    let radius = 1e-3 * (floor + wall.height_mm.hypot(wall.rim_radius_mm - floor));
    let at = |k: u32| (2.0 * (f64::from(k) + 0.5) / f64::from(FILM_SIZE) - 1.0) * radius;
    let reach = model.section.points.iter().map(|p| p[0].hypot(p[1])).fold(0.0, f64::max);
    let of = |k: u32| {
        let [x, y] = [at(k % FILM_SIZE), at(k / FILM_SIZE)];
        let inwards = (OUTMOST * reach / x.hypot(y)).min(1.0);
        model.locator.locate_or_nearest(&model.section, [inwards * x, inwards * y])
    };
    (0..FILM_SIZE * FILM_SIZE).map(of).collect()
}
