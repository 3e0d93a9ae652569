//! Film on the pan's floor as a small picture for the renderer: oil, water, fond, foam.

use std::sync::Arc;

use saute_kitchen::Kitchen;
use saute_kitchen::heat::Located;
use saute_kitchen::pan::PanModel;
use saute_scene::input::{FILM_SIZE, FilmPicture, OIL_RANGE, WATER_RANGE};

use crate::pace::Pace;

/// Caches where the texels are on the pan's mesh, and the picture while it is valid.
#[derive(Clone, Debug, Default)]
pub(crate) struct PanFilm {
    /// The pan to which the places belong.
    pan: usize,
    places: Vec<Option<Located>>,
    drawn: Option<(u64, Arc<FilmPicture>)>,
}

impl PanFilm {
    /// Returns the picture of the last look.
    pub(crate) fn picture(&mut self, kitchen: &Kitchen, pace: &Pace) -> Arc<FilmPicture> {
        let model = kitchen.pan_model();
        let pan = std::ptr::from_ref(model) as usize;
        if self.pan != pan || self.places.is_empty() {
            *self = Self { pan, places: places(model), drawn: None };
        }
        match &self.drawn {
            Some((tick, picture)) if *tick == kitchen.tick() || !pace.is_due() => Arc::clone(picture),
            _ => {
                let fresh = Arc::new(FilmPicture { texels: self.texels(kitchen) });
                // An equal picture keeps its allocation, so that nothing is redrawn for it.
                let kept = self.drawn.take().map(|(_, old)| old).filter(|old| *old == fresh).unwrap_or(fresh);
                self.drawn = Some((kitchen.tick(), Arc::clone(&kept)));
                kept
            }
        }
    }

    fn texels(&self, kitchen: &Kitchen) -> Vec<[u8; 4]> {
        let (model, state) = (kitchen.pan_model(), kitchen.pan_state());
        let water = |node: usize| state.liquids.water.mass[node] / (WATER_DENSITY * model.section.areas[node]);
        let foam = state.foam();
        let byte = |share: f64| (255.0 * share.clamp(0.0, 1.0)).round() as u8;
        let texel = |place: &Option<Located>| {
            let Some(at) = place else { return [0; 4] };
            let mixed =
                |f: &dyn Fn(usize) -> f64| -> f64 { (0..3).map(|k| at.weights[k] * f(at.nodes[k] as usize)).sum() };
            let oil = state.oil_film(at);
            let wet = (mixed(&water) / f64::from(WATER_RANGE)).sqrt();
            let fond = mixed(&|node| state.liquids.fond.share[node]);
            let standing = if foam > 0.0 { foam * (oil / FOAMING).clamp(0.0, 1.0).sqrt() } else { 0.0 };
            [byte((oil / f64::from(OIL_RANGE)).sqrt()), byte(wet), byte(fond), byte(standing)]
        };
        self.places.iter().map(texel).collect()
    }
}

/// Thickness of butter on which foam is at its full strength [m] (chosen).
const FOAMING: f64 = 0.06e-3;
/// Density of water in a film [kg/m³].
const WATER_DENSITY: f64 = 1000.0;

/// Where each texel is on the pan's mesh; none off the floor.
fn places(model: &PanModel) -> Vec<Option<Located>> {
    let radius = model.description.floor.radius_mm * 1e-3;
    let at = |k: u32| (2.0 * (f64::from(k) + 0.5) / f64::from(FILM_SIZE) - 1.0) * radius;
    let of = |index: u32| model.locator.locate(&model.section, [at(index % FILM_SIZE), at(index / FILM_SIZE)]);
    (0..FILM_SIZE * FILM_SIZE).map(of).collect()
}
