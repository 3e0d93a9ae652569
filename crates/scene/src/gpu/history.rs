//! Layers and shadow maps that are kept from frame to frame, and their validity.

use crate::gpu::dirty::DirtyRect;
use crate::gpu::solids::MovableKey;
use crate::gpu::still::{Still, StillKey};
use crate::gpu::uniforms::FrameUniform;
use crate::input::{SceneInput, ToolLook};
use crate::light::shadow::ShadowView;

/// Parts of the picture that are redrawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DirtyParts {
    /// Foods, the pan's floor, the tool.
    pub lively: DirtyRect,
    /// Steam, and collars round frying foods.
    pub sprites: DirtyRect,
}

impl DirtyParts {
    /// The whole picture.
    pub const WHOLE: Self = Self { lively: DirtyRect::WHOLE, sprites: DirtyRect::WHOLE };
}

/// Shadow casters other than the foods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShadowCasters {
    movable: MovableKey,
    tool: Option<ToolLook>,
    lidded: bool,
    view: ShadowView,
}

impl ShadowCasters {
    /// Reads it from a scene.
    pub fn of(input: &SceneInput) -> Self {
        Self {
            movable: MovableKey::of(input),
            tool: input.tool,
            lidded: input.pan.lid.is_some(),
            view: ShadowView::of(input),
        }
    }
}

/// How to update the static layer.
pub(crate) enum StillStep {
    /// It is valid.
    Keep,
    /// Draw it with anti-aliasing.
    Refine,
    /// The camera moves: no layer is cached.
    Skip,
}

/// The cached layers, and what they were drawn from.
pub(crate) struct History {
    still: Option<Still>,
    /// The present frame without its time.
    timeless: FrameUniform,
    /// The frame of the cached layer with the foods, without its time; none where the layer is invalid.
    lively: Option<FrameUniform>,
    /// Dirty part of the new frame.
    dirty: DirtyParts,
    /// Dirty part of the finished picture.
    drawn: DirtyParts,
    /// Number of changes of foods that are visible on pan wall and board, by reflection or shadow.
    disturbances: u64,
    shadow_of: Option<ShadowCasters>,
    /// True if the shadow map shows a sample of the light instead.
    shadow_lent: bool,
}

impl Default for History {
    fn default() -> Self {
        Self {
            still: None,
            timeless: bytemuck::Zeroable::zeroed(),
            lively: None,
            dirty: DirtyParts::WHOLE,
            drawn: DirtyParts::WHOLE,
            disturbances: 0,
            shadow_of: None,
            shadow_lent: false,
        }
    }
}

impl History {
    /// Invalidates all cached layers, as when their size changes.
    pub fn forget(&mut self) {
        (self.still, self.lively) = (None, None);
    }

    /// Notes a change that is visible on pan wall or board.
    pub fn disturb(&mut self) {
        self.disturbances += 1;
    }

    /// Number of changes visible on pan wall and board.
    pub fn disturbances(&self) -> u64 {
        self.disturbances
    }

    /// Invalidates the shadow map.
    pub fn forget_shadow(&mut self) {
        self.shadow_of = None;
    }

    /// Returns true if the last shadow map of a picture was drawn for these casters.
    pub fn casts(&self, casters: &ShadowCasters) -> bool {
        self.shadow_of.as_ref() == Some(casters)
    }

    /// Notes the casters for which the shadow map was drawn.
    pub fn cast(&mut self, casters: ShadowCasters) {
        (self.shadow_of, self.shadow_lent) = (Some(casters), false);
    }

    /// Lends the shadow map to a sample of the light.
    pub fn lend_shadow(&mut self) {
        self.shadow_lent = true;
    }

    /// Returns true if the shadow map shows these casters in the light of a picture of its own.
    pub fn shows_shadow_of(&self, casters: &ShadowCasters) -> bool {
        !self.shadow_lent && self.casts(casters)
    }

    /// Starts a frame: takes it without its time, and the dirty rectangle of its sprites.
    pub fn begin(&mut self, timeless: FrameUniform, sprites: DirtyRect) {
        (self.timeless, self.dirty.sprites) = (timeless, sprites);
    }

    /// Returns true if the cached layer with the foods shows this frame apart from its time.
    pub fn shows_lively(&self) -> bool {
        let same = |kept: &FrameUniform| bytemuck::bytes_of(kept) == bytemuck::bytes_of(&self.timeless);
        self.lively.as_ref().is_some_and(same)
    }

    /// Invalidates the cached layer with the foods; moving things cover `dirty`.
    pub fn change_lively(&mut self, dirty: DirtyRect) {
        (self.lively, self.dirty.lively) = (None, dirty);
    }

    /// Returns the rectangle in which the foods must be redrawn; none if their cached layer is valid.
    pub fn lively_to_draw(&self) -> Option<DirtyRect> {
        self.lively.is_none().then(|| self.dirty.lively.union(self.drawn.lively))
    }

    /// Returns the rectangle in which steam and other sprites must be redrawn.
    pub fn sprites_to_draw(&self) -> DirtyRect {
        self.dirty.sprites.union(self.drawn.sprites)
    }

    /// Notes that the picture was composed from the cached layers.
    pub fn drew_from_kept(&mut self) {
        (self.lively, self.drawn) = (Some(self.timeless), self.dirty);
    }

    /// Notes that the whole picture was drawn at once; the cached layer with the foods is invalid.
    pub fn drew_whole(&mut self) {
        (self.lively, self.drawn) = (None, DirtyParts::WHOLE);
    }

    /// Notes the key of the static layer; `drawn` is false while the camera moves, when only the key is kept.
    pub fn keep_still(&mut self, key: StillKey, drawn: bool) {
        self.still = Some(Still { key, drawn });
    }

    /// Invalidates the static layer.
    pub fn forget_still(&mut self) {
        self.still = None;
    }

    /// Returns true if the static layer is drawn in its final quality for a key.
    pub fn is_settled(&self, key: &StillKey) -> bool {
        self.still.as_ref().is_some_and(|still| still.is_best_for(key))
    }

    /// Returns how to update the static layer; `casts` is true if a food's shadow has moved.
    pub fn still_step(&self, key: &StillKey, casts: bool) -> StillStep {
        match &self.still {
            Some(still) if still.is_best_for(key) => StillStep::Keep,
            // A food in motion: its shadow on wall and board may lag until it rests.
            Some(still) if still.key.same_view(key) && casts && still.drawn => StillStep::Keep,
            // The eye rests. A food that moves on must not keep the layer from being drawn once.
            Some(still) if still.key.same_view(key) => StillStep::Refine,
            _ => StillStep::Skip,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::empty_pan;

    #[test]
    fn a_food_that_never_rests_leaves_the_still_layer_drawn_once() {
        let mut history = History::default();
        let mut step = |camera_moves: bool| {
            history.disturb();
            let mut scene = empty_pan();
            scene.camera.target.x += if camera_moves { 0.1 } else { 0.0 };
            let key = StillKey::new(&scene, [960, 540], history.disturbances());
            let step = history.still_step(&key, true);
            match step {
                StillStep::Skip => history.keep_still(key, false),
                StillStep::Refine => history.keep_still(key, true),
                StillStep::Keep => (),
            }
            step
        };
        assert!(matches!(step(true), StillStep::Skip), "the first picture");
        assert!(matches!(step(false), StillStep::Skip), "the eye has moved");
        assert!(matches!(step(false), StillStep::Refine), "it rests");
        assert!((0..9).all(|_| matches!(step(false), StillStep::Keep)));
    }
}
