//! Present shape of a piece: geometry of its patches and bending under its weight, derived from the food's state.

use saute_food::body::limp::Limp;
use saute_food::{FoodModel, FoodState, PatchGeometry, PatchPose};
use serde::{Deserialize, Serialize};

use crate::pan::near_pan::Seen;

/// Ticks between two updates of the shape [-] (chosen: the ticks at which the food model recomputes it).
const SHAPE_TICKS: u64 = 20;

/// Present shape of a piece.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct PieceShape {
    geometry: PatchGeometry,
    limp: Option<Limp>,
    count: u64,
    /// Tick of the last update [-].
    updated_at: u64,
}

impl PieceShape {
    /// Derives the shape of a piece.
    pub(crate) fn of(model: &FoodModel, state: &FoodState) -> Self {
        let mut geometry = PatchGeometry::default();
        model.patch_geometry_into(state, &mut geometry);
        Self { geometry, limp: model.limp(state), count: 0, updated_at: 0 }
    }

    /// Returns true if it has the patches and stations of a model.
    pub(crate) fn fits(&self, model: &FoodModel) -> bool {
        self.geometry.poses.len() == model.patches().len() && self.limp.as_ref().is_none_or(|limp| limp.fits(model))
    }

    /// Derives the shape again.
    pub(crate) fn update(&mut self, model: &FoodModel, state: &FoodState) {
        self.count += 1;
        model.patch_geometry_into(state, &mut self.geometry);
        self.limp = model.limp(state);
    }

    /// Returns true if [`SHAPE_TICKS`] have passed since the last update.
    pub(crate) fn is_due(&self, state: &FoodState) -> bool {
        state.ticks >= self.updated_at + SHAPE_TICKS
    }

    /// Derives the shape again every [`SHAPE_TICKS`]; returns true if it did.
    pub(crate) fn follow(&mut self, model: &FoodModel, state: &FoodState) -> bool {
        if !self.is_due(state) {
            return false;
        }
        self.updated_at = state.ticks;
        self.update(model, state);
        true
    }

    /// Returns the poses of the patches in the body's frame.
    pub(crate) fn poses(&self) -> &[PatchPose] {
        &self.geometry.poses
    }

    /// Returns the number of updates [-].
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// Returns the shape for contact detection.
    pub(crate) fn seen<'a>(&'a self, model: &'a FoodModel) -> Seen<'a> {
        Seen {
            patches: (model.patches(), self.poses()),
            limp: self.limp.as_ref(),
            count: self.count,
            rules: model.rules(),
        }
    }
}
