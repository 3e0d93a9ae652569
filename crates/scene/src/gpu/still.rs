//! Cache key of the static layer: when the kept picture of what does not move is still valid.

use crate::camera::Camera;
use crate::gpu::solids::MovableKey;
use crate::gpu::uniforms::{balance, exposure};
use crate::input::{SceneInput, StoveKind, Tile};
use crate::light::room_light::RoomLight;
use crate::light::white_balance::WhiteBalance;

/// Cache key of the static layer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StillKey {
    camera: Camera,
    size: [u32; 2],
    /// Hob power in steps too small to be seen.
    stove: (StoveKind, u32),
    pan: MovableKey,
    disturbances: u64,
    white: WhiteBalance,
    /// Exposure of the look [-].
    exposure: f32,
    /// Width of the aperture over the usual one [-].
    aperture: f32,
    tile: Option<Tile>,
    light: RoomLight,
}

impl StillKey {
    pub fn new(input: &SceneInput, size: [u32; 2], disturbances: u64) -> Self {
        Self {
            camera: input.camera.clone(),
            size,
            stove: (input.hob.kind, (input.hob.power * 128.0).round() as u32),
            pan: MovableKey::of(input),
            disturbances,
            white: balance(input),
            exposure: exposure(input),
            aperture: input.photo.aperture,
            tile: input.tile,
            light: input.light,
        }
    }

    /// Returns true if two keys differ only in their foods.
    pub fn same_view(&self, other: &Self) -> bool {
        Self { disturbances: other.disturbances, ..self.clone() } == *other
    }
}

/// The cached static layer.
pub(crate) struct Still {
    pub key: StillKey,
    /// False while the eye moves: then only the key is kept.
    pub drawn: bool,
}

impl Still {
    /// Returns true if the layer is drawn in its final quality for a key.
    pub fn is_best_for(&self, key: &StillKey) -> bool {
        self.key == *key && self.drawn
    }
}
