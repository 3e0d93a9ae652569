//! What the finished picture shows: a frame that shows the same is not drawn again, and one that rests is drawn well.

use web_time::{Duration, Instant};

use crate::gpu::uniforms::FrameUniform;
use crate::mesh::steam::PuffVertex;
use crate::quality::Quality;

/// A picture that has rested this long is worth smooth edges everywhere (chosen: longer than between two ticks).
const RESTED: Duration = Duration::from_millis(350);

/// Everything but the foods that the picture was drawn from.
#[derive(Clone, Debug)]
pub(crate) struct Sight {
    pub frame: FrameUniform,
    pub sprites: Vec<PuffVertex>,
    pub quality: Quality,
}

impl Sight {
    fn same(&self, other: &Self) -> bool {
        self.quality == other.quality
            && bytemuck::bytes_of(&self.frame) == bytemuck::bytes_of(&other.frame)
            && self.sprite_bytes() == other.sprite_bytes()
    }

    fn sprite_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.sprites)
    }
}

/// What there is to do for a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Draw it.
    Draw,
    /// The picture stands.
    Nothing,
    /// Draw it once more, with smooth edges.
    Smooth,
}

/// What the picture shows, and since when.
#[derive(Debug)]
pub(crate) struct Shown {
    /// How long a picture must rest before it is smoothed.
    pub rest: Duration,
    sight: Option<Sight>,
    since: Option<Instant>,
    smooth: bool,
}

impl Default for Shown {
    fn default() -> Self {
        Self { rest: RESTED, sight: None, since: None, smooth: false }
    }
}

impl Shown {
    /// Says what a frame needs. `changed`: foods or targets did; `settled`: nothing is left to refine.
    pub fn work(&mut self, sight: Sight, changed: bool, settled: bool) -> Work {
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
}
