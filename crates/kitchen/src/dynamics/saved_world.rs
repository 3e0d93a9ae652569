//! The rigid-body world as data. The shape of the pan and the parameters of the solver follow from the pan and the program.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::engine::Engine;
use super::pan_motion::PanMotion;
use super::pan_shape::PanShape;
use super::rigid_state::RigidState;
use super::world::World;

/// What of a [`World`] does not follow from the pan.
#[derive(Deserialize, Serialize)]
pub(crate) struct SavedWorld<'a> {
    rigid: Cow<'a, RigidState>,
    motion: PanMotion,
    may_sleep: bool,
    settled: bool,
}

impl World {
    /// Returns what does not follow from the pan.
    pub(crate) fn saved(&self) -> SavedWorld<'_> {
        SavedWorld {
            rigid: Cow::Borrowed(&self.rigid),
            motion: self.motion,
            may_sleep: self.may_sleep,
            settled: self.settled,
        }
    }

    /// Returns the world again, around a pan; `None` if a body or a shape is missing.
    pub(crate) fn of_saved(saved: SavedWorld, shape: PanShape) -> Option<Self> {
        let SavedWorld { rigid, motion, may_sleep, settled } = saved;
        let rigid = rigid.into_owned();
        rigid.is_whole().then(|| Self { rigid, motion, may_sleep, settled, engine: Engine::new(), shape })
    }
}
