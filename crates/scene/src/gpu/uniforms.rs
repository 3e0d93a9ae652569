//! The uniform blocks, laid out as the shaders read them.

use glam::{Mat4, Vec3, Vec4};

use crate::input::{Colouring, FLOOR_FIELD_RINGS, SEAR_SETS, SceneInput};
use crate::light::environment::ENVIRONMENT_LEVELS;
use crate::light::shadow::{ContactMap, ShadowView};
use crate::light::white_balance::WhiteBalance;
use crate::mesh::props::{BOARD_CENTRE, BOARD_SIZE};
use crate::quality::Quality;

/// After this the time in the shaders starts again, so that single precision stays fine [s].
const TIME_WRAP: f32 = 1000.0;

/// Mirrors `Frame` in `frame.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct FrameUniform {
    clip_from_world: Mat4,
    light_from_world: Mat4,
    eye: Vec4,
    key: Vec4,
    other: Vec4,
    lights: [Vec4; 5],
    as_shot: Vec4,
    pan_from_world: Mat4,
    contact_rect: Vec4,
    contact_height: Vec4,
    pan_place: Vec4,
    pan_shape: Vec4,
    mode: Vec4,
    board: Vec4,
    oil: Vec4,
    white: Vec4,
    shadow_fine: Vec4,
    origin: Vec4,
    floor_field: [f32; FLOOR_FIELD_RINGS],
}

impl FrameUniform {
    /// True for the exact pictures.
    pub fn is_flat(&self) -> bool {
        self.mode.z > 0.5
    }

    /// The same at time 0: what is seen of things that only the clock moves is left out.
    pub fn timeless(mut self) -> Self {
        self.eye.w = 0.0;
        self
    }

    pub fn new(input: &SceneInput, aspect: f32, quality: Quality, contact: &ContactMap) -> Self {
        let (shadow, lit) = (ShadowView::of(input), input.light.sources());
        let (kind, shift) = input.sample.map_or((0.0, 0.0), |sample| (sample.kind(), sample.noise_shift()));
        let [left, top] = input.tile.map_or([0; 2], |tile| tile.origin);
        let pan = &input.pan;
        let field = matches!(input.colouring, Colouring::Field { .. });
        let [low, high] = [BOARD_CENTRE - BOARD_SIZE * 0.5, BOARD_CENTRE + BOARD_SIZE * 0.5];
        Self {
            clip_from_world: input.view_projection(aspect),
            light_from_world: shadow.coarse(),
            eye: input.eye().extend(input.time_s.rem_euclid(TIME_WRAP)),
            key: input.towards_light().extend(0.0),
            other: lit.other_direction.normalize().extend((ENVIRONMENT_LEVELS - 1) as f32),
            lights: input.sample.map_or(input.light.uniform(), |sample| sample.share(input.light.uniform())),
            as_shot: WhiteBalance::AsShot.gains(input.light).extend(0.0),
            pan_from_world: pan.world_from_pan().inverse(),
            contact_rect: contact.rect(),
            contact_height: contact.height(),
            pan_place: pan.position.extend(pan.thickness),
            pan_shape: Vec4::new(pan.floor_radius, pan.rim_radius, pan.rim_height, pan.lid.map_or(0.0, |lid| lid.fog)),
            mode: Vec4::new(input.hob.power, f32::from(field), f32::from(input.flat), BOARD_CENTRE.z),
            board: Vec4::new(low.x, low.y, high.x, high.y),
            oil: pan.oil_colour.extend(f32::from(input.mirror.is_some_and(|mirror| !mirror.pan_shown))),
            white: (exposure(input) * balance(input).gains(input.light)).extend(pan.oil_turbidity),
            shadow_fine: shadow.uniform(quality),
            origin: Vec4::new(left as f32, top as f32, kind, shift),
            floor_field: pan.floor_field,
        }
    }
}

/// The balance of the look; what surrounds the colours of a field stays as it is.
pub(crate) fn balance(input: &SceneInput) -> WhiteBalance {
    if matches!(input.colouring, Colouring::Look) { input.white_balance } else { WhiteBalance::default() }
}

/// What the look's radiances are multiplied by for its exposure [-].
pub(crate) fn exposure(input: &SceneInput) -> f32 {
    if matches!(input.colouring, Colouring::Look) { input.photo.gain() } else { 1.0 }
}

/// Mirrors `Food` in `food.wgsl`; its head is `Pose` in `depth.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct FoodUniform {
    pub world_from_rest: Mat4,
    /// Its place in the textures of flesh [m]; w = 1 where it grew along x.
    pub place: Vec4,
    pub grain_origin: Vec4,
    pub grain_scale: Vec4,
    pub golden: Vec4,
    pub crust: Vec4,
    pub char: Vec4,
    pub fat_brown: Vec4,
    pub second: Vec4,
    pub sear: [[[Vec4; 3]; SEAR_SETS]; 2],
}

/// One over every component, 0 where there is no extent.
pub(crate) fn reciprocal(extent: Vec3) -> Vec3 {
    Vec3::select(extent.cmpgt(Vec3::splat(1e-9)), extent.recip(), Vec3::ZERO)
}
