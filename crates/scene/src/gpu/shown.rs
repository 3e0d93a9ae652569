//! What the finished picture shows: an equal frame is not drawn again, and a resting one is drawn once with
//! anti-aliasing.

use web_time::{Duration, Instant};

use crate::gpu::uniforms::FrameUniform;
use crate::mesh::steam::PuffVertex;
use crate::quality::Quality;

/// Time at rest after which a picture is drawn with anti-aliasing (chosen: longer than between two ticks).
const RESTED: Duration = Duration::from_millis(350);

/// Everything the picture was drawn from, except the foods.
#[derive(Clone, Debug)]
pub(crate) struct ShownFrame {
    pub frame: FrameUniform,
    pub sprites: Vec<PuffVertex>,
    pub quality: Quality,
}

impl ShownFrame {
    fn same(&self, other: &Self) -> bool {
        self.quality == other.quality
            && bytemuck::bytes_of(&self.frame) == bytemuck::bytes_of(&other.frame)
            && self.sprite_bytes() == other.sprite_bytes()
    }

    fn sprite_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.sprites)
    }
}

/// Work that a frame needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Draw it.
    Draw,
    /// The picture stays as it is.
    Nothing,
    /// Draw it once more, with smooth edges.
    Smooth,
}

/// Contents of the picture, and since when it shows them.
#[derive(Debug)]
pub(crate) struct Shown {
    /// How long a picture must rest before it is smoothed.
    pub rest: Duration,
    sight: Option<ShownFrame>,
    since: Option<Instant>,
    smooth: bool,
}

impl Default for Shown {
    fn default() -> Self {
        Self { rest: RESTED, sight: None, since: None, smooth: false }
    }
}

impl Shown {
    /// Returns what a frame needs. `changed`: foods or targets have changed; `settled`: nothing is left to refine.
    pub fn work(&mut self, sight: ShownFrame, changed: bool, settled: bool) -> Work {
        let same = self.sight.as_ref().is_some_and(|old| old.same(&sight));
        if changed || !same {
            self.smooth = sight.quality != Quality::Quick || sight.frame.is_flat();
            self.sight = Some(sight);
            self.since = Some(Instant::now());
            return Work::Draw;
        }
        if self.smooth {
            return Work::Nothing;
        }
        if !settled {
            return Work::Draw;
        }
        if self.since.is_some_and(|since| since.elapsed() > self.rest) {
            self.smooth = true;
            return Work::Smooth;
        }
        Work::Nothing
    }

    /// Draws the next frame whatever is shown.
    pub fn forget(&mut self) {
        (self.sight, self.smooth) = (None, false);
    }

    /// Returns true if an equal frame would not be drawn again, however long it rests.
    pub fn is_final(&self) -> bool {
        self.smooth
    }
}
