//! What is kept from frame to frame, and what of it still holds.

use crate::gpu::dirty::DirtyRect;
use crate::gpu::solids::MovableKey;
use crate::gpu::still::{Still, StillKey};
use crate::gpu::uniforms::FrameUniform;
use crate::input::{SceneInput, ToolLook};

/// What is drawn anew covers this part of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touched {
    /// Foods, the pan's floor, the tool.
    pub lively: DirtyRect,
    /// Steam and what lies round frying foods.
    pub sprites: DirtyRect,
}

impl Touched {
    /// The whole picture.
    pub const WHOLE: Self = Self { lively: DirtyRect::WHOLE, sprites: DirtyRect::WHOLE };
}

/// What besides the foods casts a shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Casting {
    movable: MovableKey,
    tool: Option<ToolLook>,
    lidded: bool,
}

impl Casting {
    /// Reads it from a scene.
    pub fn of(input: &SceneInput) -> Self {
        Self { movable: MovableKey::of(input), tool: input.tool, lidded: input.pan.lid.is_some() }
    }
}

/// What to do about the kept picture of the still things.
pub(crate) enum StillStep {
    /// It stands.
    Keep,
    /// Draw it smoothly.
    Refine,
    /// Nothing is worth keeping while the eye moves.
    Skip,
}

/// The kept pictures, and what they were drawn from.
pub(crate) struct History {
    still: Option<Still>,
    /// The frame as it is now but for the time.
    timeless: FrameUniform,
    /// That of the kept picture with the foods; none where it does not stand.
    lively: Option<FrameUniform>,
    /// What moves covers this in the new frame.
    dirty: Touched,
    /// What moved covers this in the picture as it stands.
    drawn: Touched,
    /// Counts the moves of foods that pan wall and board show.
    disturbances: u64,
    shadow_of: Option<Casting>,
}

impl Default for History {
    fn default() -> Self {
        Self {
            still: None,
            timeless: bytemuck::Zeroable::zeroed(),
            lively: None,
            dirty: Touched::WHOLE,
            drawn: Touched::WHOLE,
            disturbances: 0,
            shadow_of: None,
        }
    }
}

impl History {
    /// Forgets all kept pictures, as when their size changes.
    pub fn forget(&mut self) {
        (self.still, self.lively) = (None, None);
    }

    /// Notes that pan wall or board show something else.
    pub fn disturb(&mut self) {
        self.disturbances += 1;
    }

    /// How often pan wall and board have come to show something else.
    pub fn disturbances(&self) -> u64 {
        self.disturbances
    }

    /// Forgets the shadow map.
    pub fn forget_shadow(&mut self) {
        self.shadow_of = None;
    }

    /// Returns true if the shadow map was drawn for this.
    pub fn casts(&self, casting: &Casting) -> bool {
        self.shadow_of.as_ref() == Some(casting)
    }

    /// Notes what the shadow map was drawn for.
    pub fn cast(&mut self, casting: Casting) {
        self.shadow_of = Some(casting);
    }

    /// Takes the frame that is drawn next, without its time.
    pub fn begin(&mut self, timeless: FrameUniform, sprites: DirtyRect) {
        (self.timeless, self.dirty.sprites) = (timeless, sprites);
    }

    /// Returns true if the kept picture with the foods shows this frame but for the time.
    pub fn shows_lively(&self) -> bool {
        let same = |kept: &FrameUniform| bytemuck::bytes_of(kept) == bytemuck::bytes_of(&self.timeless);
        self.lively.as_ref().is_some_and(same)
    }

    /// The kept picture with the foods no longer stands; what moves covers `dirty`.
    pub fn change_lively(&mut self, dirty: DirtyRect) {
        (self.lively, self.dirty.lively) = (None, dirty);
    }

    /// What the foods must be drawn over, if their kept picture does not stand.
    pub fn lively_to_draw(&self) -> Option<DirtyRect> {
        self.lively.is_none().then(|| self.dirty.lively.union(self.drawn.lively))
    }

    /// What steam and the like must be drawn over.
    pub fn sprites_to_draw(&self) -> DirtyRect {
        self.dirty.sprites.union(self.drawn.sprites)
    }

    /// The picture was put together from the kept ones.
    pub fn drew_from_kept(&mut self) {
        (self.lively, self.drawn) = (Some(self.timeless), self.dirty);
    }

    /// The whole picture was drawn at once; the kept picture with the foods does not stand.
    pub fn drew_whole(&mut self) {
        (self.lively, self.drawn) = (None, Touched::WHOLE);
    }

    /// The kept picture of the still things was drawn for a key, or, while the eye moves, only noted.
    pub fn keep_still(&mut self, key: StillKey, drawn: bool) {
        self.still = Some(Still { key, drawn });
    }

    /// Forgets the picture of the still things.
    pub fn forget_still(&mut self) {
        self.still = None;
    }

    /// Returns true if the picture of the still things is as good as it gets for a key.
    pub fn is_settled(&self, key: &StillKey) -> bool {
        self.still.as_ref().is_some_and(|still| still.is_best_for(key))
    }

    /// What to do about the picture of the still things; `casts` says that a food's shadow has moved.
    pub fn still_step(&self, key: &StillKey, casts: bool) -> StillStep {
        match &self.still {
            Some(still) if still.is_best_for(key) => StillStep::Keep,
            // A food in motion: its shadow on wall and board may lag until it rests.
            Some(still) if still.key.same_view(key) && casts && still.drawn => StillStep::Keep,
            Some(still) if still.key.same_view(key) && !casts => StillStep::Refine,
            _ => StillStep::Skip,
        }
    }
}
