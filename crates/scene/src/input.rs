//! Input of the scene renderer: one plain description of everything in the picture.
//!
//! World frame: metres, right-handed, x to the cook's right, y away from the cook, z up; the origin is the
//! centre of the hob ring on the glass. The renderer computes no physics and does not depend on a kitchen.

mod food;
pub(crate) mod pan;

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};

use crate::camera::Camera;
use crate::light::gathered::LightSample;
use crate::light::photo::Photo;
use crate::light::room_light::RoomLight;
use crate::light::white_balance::WhiteBalance;
use crate::mesh::strings::StringLook;

pub use self::food::{
    BORDER_RANGE, BrowningPalette, FleshTexture, FoodLook, FoodMesh, FoodVertex, GrainVolume, SEAR_SETS, SearLook,
    SliceLook, WITHIN_RANGE,
};
pub use self::pan::{
    FILM_SIZE, FLOOR_FIELD_RINGS, FilmPicture, LidLook, OIL_RANGE, PanLook, TINT_RANGE, TintPicture, WATER_RANGE,
};

/// One frame of the scene.
#[derive(Clone, Debug)]
pub struct SceneInput {
    /// Where the eye is.
    pub camera: Camera,
    /// The hob under the pan.
    pub hob: HobLook,
    /// The pan; stands on the hob, or on the wet cloth next to it.
    pub pan: PanLook,
    /// Foods, wherever they lie.
    pub foods: Vec<FoodLook>,
    /// The tool in the cook's hand.
    pub tool: Option<ToolLook>,
    /// Strings of a device that hold the pan.
    pub strings: Vec<StringLook>,
    /// Rack under, or foil over, food that rests on the board.
    pub rest: Option<RestLook>,
    /// Places where water vapour leaves.
    pub steam: Vec<SteamSource>,
    /// Oil that spatters.
    pub spatter: SpatterLook,
    /// Simulated time [s]; moves steam and the shimmer of the oil, nothing else.
    pub time_s: f32,
    /// View that the colours show.
    pub colouring: Colouring,
    /// White balance of the look.
    pub white_balance: WhiteBalance,
    /// Light of the room.
    pub light: RoomLight,
    /// Exposure and aperture of the look.
    pub photo: Photo,
    /// True writes the colours unlit, without tone mapping, shadow, dither or anti-aliasing, so that they decode
    /// exactly.
    pub flat: bool,
    /// View in a half mirror; none for the room.
    pub mirror: Option<MirrorLook>,
    /// The part of a larger picture that is drawn; none for all of it.
    pub tile: Option<Tile>,
    /// One of the samples of which a still that gathers light is the mean; none for a picture of its own.
    pub sample: Option<LightSample>,
}

/// A part of a picture, drawn by itself with an off-centre projection [pixels].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Width and height of the whole picture.
    pub whole: [u32; 2],
    /// Left and upper edge of the part.
    pub origin: [u32; 2],
    /// Width and height of the part.
    pub size: [u32; 2],
}

impl Tile {
    /// Width over height of the whole picture [-].
    fn aspect(&self) -> f32 {
        self.whole[0] as f32 / self.whole[1] as f32
    }

    /// Maps clip space of the whole picture to that of the part.
    fn part_from_whole(&self) -> Mat4 {
        let scale: [f32; 2] = std::array::from_fn(|i| self.whole[i] as f32 / self.size[i] as f32);
        // Middle of the part in the normalised device coordinates of the whole.
        let middle = std::array::from_fn::<f32, 2, _>(|i| {
            (2.0 * self.origin[i] as f32 + self.size[i] as f32) / self.whole[i] as f32 - 1.0
        });
        let shift = Vec3::new(-middle[0] * scale[0], middle[1] * scale[1], 0.0);
        Mat4::from_translation(shift) * Mat4::from_scale(Vec3::new(scale[0], scale[1], 1.0))
    }
}

/// View of a scene in a half mirror, which only adds light to a real pan: food, oil, steam and tools on black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorLook {
    /// Where the eye is [m]; it replaces the camera's.
    pub eye: Vec3,
    /// Maps the world to clip space (depth 0–1); it replaces the camera's.
    pub clip_from_world: Mat4,
    /// True if the virtual pan is drawn; otherwise it is black and hides what is behind it.
    pub pan_shown: bool,
}

impl SceneInput {
    /// Position of the eye [m].
    pub fn eye(&self) -> Vec3 {
        let in_lens = self.sample.map_or(Vec2::ZERO, |sample| sample.in_lens());
        self.mirror.map_or_else(|| self.camera.eye() + self.camera.aside(in_lens), |mirror| mirror.eye)
    }

    /// Unit vector towards the light that casts shadows.
    pub(crate) fn towards_light(&self) -> Vec3 {
        self.sample.map_or_else(|| self.light.sources().key_direction.normalize(), |sample| sample.towards())
    }

    /// Maps the world to clip space (depth 0–1) for a picture of the given width over height.
    pub fn view_projection(&self, aspect: f32) -> Mat4 {
        let whole = |aspect| self.mirror.map_or_else(|| self.through_camera(aspect), |m| m.clip_from_world);
        self.tile.map_or_else(|| whole(aspect), |tile| tile.part_from_whole() * whole(tile.aspect()))
    }

    /// Maps the world to the camera's clip space, as far as the sample goes from its own place.
    fn through_camera(&self, aspect: f32) -> Mat4 {
        let Some(sample) = self.sample else { return self.camera.view_projection(aspect) };
        sample.in_pixel() * self.camera.projection(aspect) * sample.through_lens() * self.camera.view()
    }

    /// Maps the space of the camera to clip space, for a picture of the given width over height.
    pub(crate) fn projection(&self, aspect: f32) -> Mat4 {
        let tiled = |tile: Tile| tile.part_from_whole() * self.camera.projection(tile.aspect());
        self.tile.map_or_else(|| self.camera.projection(aspect), tiled)
    }
}

/// Meaning of the colours of foods and pan floor.
#[derive(Clone, Debug)]
pub enum Colouring {
    /// As the eye sees it.
    Look,
    /// `FoodVertex::field` and `PanLook::floor_field` are coordinates (0–1) into this table of sRGB colours.
    Field {
        /// 256 sRGB colours.
        table: Arc<[[u8; 3]; 256]>,
        /// Numbers of the patterns of the entries, as in `hatch.wgsl`, where entries are classes: then the nearest
        /// entry is taken. None where colours are interpolated.
        classes: Option<Arc<[u8; 256]>>,
    },
}

/// A tool in the cook's hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolLook {
    /// Which tool.
    pub kind: ToolKind,
    /// Pose: maps the tool's frame to the world; its origin is the middle of the blade, or between the fingers' tips.
    pub world_from_tool: Mat4,
}

/// Which tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolKind {
    /// A blade that goes under food along +x.
    Turner,
    /// Two fingers that hold food from above.
    Tongs {
        /// True if they are empty.
        open: bool,
    },
}

/// A wire rack under resting food, loose foil over it, or the plate on which it is served.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestLook {
    /// Rack, foil or plate.
    pub kind: RestKind,
    /// Middle of the resting food's place on the board [m].
    pub centre: Vec3,
    /// Half the food's extents along x and y [m].
    pub half: glam::Vec2,
    /// Top of the food above `centre` [m].
    pub height: f32,
}

/// Rack, foil or plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RestKind {
    /// A plate, on which the food is served; its well is `PLATE_HEIGHT` above the board.
    Plate,
    /// Wire rack; its wires' tops are `RACK_HEIGHT` above the board.
    Rack,
    /// A tent of foil, open in front.
    Foil,
}

/// Height of a plate's well above the board [m] (chosen: a dinner plate).
pub const PLATE_HEIGHT: f32 = 0.006;
/// Height of a rack's wires above the board [m] (chosen: a cooling rack).
pub const RACK_HEIGHT: f32 = 0.016;

/// Kind of a stove.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StoveKind {
    /// Induction hob with a glass.
    #[default]
    Induction,
    /// Gas burner with a grate.
    Gas,
    /// Radiant elements behind glass-ceramic.
    Radiant,
    /// Iron plate.
    Plate,
}

/// Appearance of the hob.
#[derive(Clone, Copy, Debug)]
pub struct HobLook {
    /// Kind.
    pub kind: StoveKind,
    /// How strongly it shows that it heats (0–1): the power over the largest setting, by which flames grow and the printed ring
    /// of an induction hob glows; the glow of an element.
    pub power: f32,
}

/// Oil that spatters.
#[derive(Clone, Debug, Default)]
pub struct SpatterLook {
    /// Drops in the air.
    pub drops: Vec<DropLook>,
    /// Spots where drops have landed; the same allocation as long as nothing in it has changed.
    pub spots: Arc<Vec<SpotLook>>,
}

/// A drop of oil in the air, world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropLook {
    /// Where [m].
    pub position: Vec3,
    /// How fast [m/s].
    pub velocity: Vec3,
    /// Its radius [m].
    pub radius: f32,
}

/// A spot of oil on the pan's wall or next to the pan, world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLook {
    /// Its middle [m].
    pub position: Vec3,
    /// Unit normal of what it lies on.
    pub normal: Vec3,
    /// Its radius [m].
    pub radius: f32,
}

/// Kinds of vapour that rise from the pan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vapour {
    /// Water.
    Steam,
    /// Oil that smokes.
    Smoke,
    /// Oil that burns.
    Flame,
}

/// A place where vapour leaves.
#[derive(Clone, Copy, Debug)]
pub struct SteamSource {
    /// What it is.
    pub kind: Vapour,
    /// Where, world frame [m].
    pub position: Vec3,
    /// Radius of the patch [m].
    pub radius: f32,
    /// Mass flow [g/s].
    pub flow_g_s: f32,
}
