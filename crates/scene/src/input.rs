//! What the scene renderer is given: one plain description of everything in the picture.
//!
//! World frame: metres, right-handed, x to the cook's right, y away from the cook, z up; the origin is the
//! centre of the hob ring on the glass. The renderer computes no physics and knows no kitchen.

use std::sync::Arc;

use glam::{Mat4, Quat, Vec3};

use crate::camera::Camera;
use crate::light::white_balance::WhiteBalance;
use crate::mesh::strings::StringLook;

/// One frame of the scene.
#[derive(Clone, Debug)]
pub struct SceneInput {
    /// Where the eye is.
    pub camera: Camera,
    /// The induction hob under the pan.
    pub hob: HobLook,
    /// The pan; stands on the hob, or on the wet cloth beside it.
    pub pan: PanLook,
    /// Foods, wherever they lie.
    pub foods: Vec<FoodLook>,
    /// The tool in the cook's hand.
    pub tool: Option<ToolLook>,
    /// Strings of a device that hold the pan.
    pub strings: Vec<StringLook>,
    /// What food on the board rests on or under.
    pub rest: Option<RestLook>,
    /// Places where water vapour leaves.
    pub steam: Vec<SteamSource>,
    /// Oil that spatters.
    pub spatter: SpatterLook,
    /// Simulated time [s]; moves steam and the shimmer of the oil, nothing else.
    pub time_s: f32,
    /// What the colours mean.
    pub colouring: Colouring,
    /// What the look calls white.
    pub white_balance: WhiteBalance,
    /// True writes the colours unlit, without tone mapping, shadow, dither or anti-aliasing, so that they decode exactly.
    pub flat: bool,
    /// How it is seen in a half mirror; none for the room.
    pub mirror: Option<MirrorLook>,
}

/// How a scene is seen in a half mirror, which only adds light to a real pan: food, oil, steam and tools on black.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorLook {
    /// Where the eye is [m]; it stands in for the camera's.
    pub eye: Vec3,
    /// Maps the world to clip space (depth 0–1); it stands in for the camera's.
    pub clip_from_world: Mat4,
    /// Whether the virtual pan is drawn; else it is black and hides what lies behind it.
    pub pan_shown: bool,
}

impl SceneInput {
    /// Position of the eye [m].
    pub fn eye(&self) -> Vec3 {
        self.mirror.map_or_else(|| self.camera.eye(), |mirror| mirror.eye)
    }

    /// Maps the world to clip space (depth 0–1) for a picture of the given width over height.
    pub fn view_projection(&self, aspect: f32) -> Mat4 {
        self.mirror.map_or_else(|| self.camera.view_projection(aspect), |mirror| mirror.clip_from_world)
    }
}

/// What the colours of foods and pan floor mean.
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
        /// Whether they hold nothing.
        open: bool,
    },
}

/// A wire rack under resting food, or loose foil over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestLook {
    /// Rack or foil.
    pub kind: RestKind,
    /// Middle of the resting food's place on the board [m].
    pub centre: Vec3,
    /// Half the food's extents along x and y [m].
    pub half: glam::Vec2,
    /// Top of the food above `centre` [m].
    pub height: f32,
}

/// Rack or foil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RestKind {
    /// Wire rack; its wires' tops lie `RACK_HEIGHT` above the board.
    Rack,
    /// A tent of foil, open in front.
    Foil,
}

/// Height of a rack's wires above the board [m] (chosen: a cooling rack).
pub const RACK_HEIGHT: f32 = 0.016;

/// How the hob looks.
#[derive(Clone, Copy, Debug)]
pub struct HobLook {
    /// Electrical power over the largest setting (0–1): the printed ring glows with it.
    pub power: f32,
}

/// How the pan looks.
#[derive(Clone, Debug)]
pub struct PanLook {
    /// Radius of the flat floor [m].
    pub floor_radius: f32,
    /// Radius at the top of the rim [m].
    pub rim_radius: f32,
    /// Height of the rim above the floor [m].
    pub rim_height: f32,
    /// Thickness of the floor [m].
    pub thickness: f32,
    /// Base colour, linear sRGB.
    pub colour: Vec3,
    /// 0 dielectric (coating) to 1 metal.
    pub metalness: f32,
    /// Microfacet roughness of the surface under the oil (0–1).
    pub roughness: f32,
    /// What lies on the floor; the same allocation as long as nothing in it has changed.
    pub film: Arc<FilmPicture>,
    /// What heat has done to its colour; the same allocation as long as nothing in it has changed.
    pub tint: Arc<TintPicture>,
    /// Colour of light that has passed through a millimetre of the oil, linear sRGB.
    pub oil_colour: Vec3,
    /// Ridges on the floor, along the pan's y, one through the centre: pitch, width and height [m].
    pub ridges: Option<[f32; 3]>,
    /// The lid, while it is on.
    pub lid: Option<LidLook>,
    /// Centre of the pan's underside, relative to the hob centre [m]; the cooking surface is `thickness` above it.
    pub position: Vec3,
    /// How it is turned about that point.
    pub rotation: Quat,
    /// True: a folded wet cloth lies under the pan (else it lies folded at the left of the hob).
    pub on_cloth: bool,
    /// Field coordinate (0–1) on `FLOOR_FIELD_RINGS` equidistant radii from the centre to `floor_radius`.
    pub floor_field: [f32; FLOOR_FIELD_RINGS],
}

/// Liquids and what they left on the floor of the pan, seen from above: `FILM_SIZE` squared texels over the square round
/// the floor, x fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilmPicture {
    /// Square roots of the thickness of oil over [`OIL_RANGE`] and of water over [`WATER_RANGE`]; browned fond; foam.
    pub texels: Vec<[u8; 4]>,
}

/// Reflectance of the pan's inside over that of the new pan: `FILM_SIZE` squared texels over the square round the floor with
/// the wall unrolled about it, x fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TintPicture {
    /// Shares of red, green and blue over [`TINT_RANGE`], linear.
    pub texels: Vec<[u8; 4]>,
}

/// Share of reflectance that byte 255 stands for [-].
pub const TINT_RANGE: f32 = 2.0;

/// Texels along each side of a film picture.
pub const FILM_SIZE: u32 = 64;
/// Thickness of oil that byte 255 stands for [m] (chosen: a puddle on one side of a tilted pan).
pub const OIL_RANGE: f32 = 1.0e-3;
/// Thickness of water that byte 255 stands for [m] (chosen: thicker puddles look the same).
pub const WATER_RANGE: f32 = 2.0e-3;

/// A glass lid on the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LidLook {
    /// How far its inside is fogged (0–1).
    pub fog: f32,
}

impl PanLook {
    /// Maps the pan's frame to the world; its origin is the centre of the underside.
    pub fn world_from_pan(&self) -> Mat4 {
        Mat4::from_rotation_translation(self.rotation, self.position)
    }
}

/// Radii at which the pan's field is given.
pub const FLOOR_FIELD_RINGS: usize = 16;

/// One food.
#[derive(Clone, Debug)]
pub struct FoodLook {
    /// Shape and what never changes.
    pub mesh: Arc<FoodMesh>,
    /// State of every vertex of `mesh`; the same allocation as long as nothing in it has changed.
    pub vertices: Arc<Vec<FoodVertex>>,
    /// Pose: maps the rest frame (origin at the rest shape's centroid) to the world.
    pub world_from_rest: Mat4,
    /// A cut that shows the inside; the food stays whole for everything else.
    pub slice: Option<SliceLook>,
    /// Lines that ridges seared into the lower and the upper face of the rest shape, the strongest first.
    pub sear: [[Option<SearLook>; SEAR_SETS]; 2],
}

/// Sets of seared lines that are drawn on each face (chosen: crossed lines).
pub const SEAR_SETS: usize = 2;

/// Parallel lines on which a face browned ahead of the rest, in the rest frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearLook {
    /// Unit vector along the lines.
    pub direction: glam::Vec2,
    /// Distance across, towards (d_y, −d_x), of the middle of one line from the origin [m].
    pub phase: f32,
    /// From line to line [m].
    pub pitch: f32,
    /// Width of a line [m].
    pub width: f32,
    /// Share of the face's browning that came while it lay on these ridges.
    pub share: f32,
    /// Browning that came then, on the lines and between them.
    pub browning: [f32; 2],
    /// Charring likewise.
    pub charring: [f32; 2],
}

/// The rest shape of a food; shared between frames.
#[derive(Clone, Debug)]
pub struct FoodMesh {
    /// Changes when the mesh or what grew in it changes; renderers cache by it.
    pub key: u64,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// What its flesh is made of finer than the mesh.
    pub texture: FleshTexture,
    /// Colours that browning goes through.
    pub palette: BrowningPalette,
    /// Fat, second tissue and borders in the flesh on a regular grid over the rest box.
    pub grain: GrainVolume,
}

/// What flesh is made of finer than the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FleshTexture {
    /// Muscle whose fibres run along z.
    Muscle,
    /// Ground meat: strands pressed together.
    Ground,
    /// A root: core, cortex and rays between.
    Root,
    /// A shaft of sheaths, one in the other.
    Sheaths,
    /// The segments of a shrimp.
    Shrimp,
    /// Even flesh.
    Plain,
}

/// Colours that browning goes through, L*a*b*.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BrowningPalette {
    /// Lean flesh at `golden_at`.
    pub golden: [f32; 3],
    /// Browning at which lean flesh is golden (0–1).
    pub golden_at: f32,
    /// Lean flesh wholly browned.
    pub crust: [f32; 3],
    /// Charred.
    pub char: [f32; 3],
    /// Fat wholly browned.
    pub fat_brown: [f32; 3],
    /// What the second tissue adds to flesh that has not browned.
    pub second: [f32; 3],
}

/// What grew in the flesh, on a regular grid.
#[derive(Clone, Debug)]
pub struct GrainVolume {
    /// Cells along x, y, z.
    pub size: [u32; 3],
    /// Lowest corner in the rest frame [m].
    pub origin: Vec3,
    /// Extent in the rest frame [m].
    pub extent: Vec3,
    /// Four bytes a cell, x fastest: depth within a seam of fat (see [`WITHIN_RANGE`]), share of the second tissue
    /// (255 = all), distance from the nearest border of a tissue (see [`BORDER_RANGE`]), a free tone of its sheath.
    pub cells: Vec<[u8; 4]>,
}

/// Depth within a seam of fat that the bytes 0 and 255 stand for, below and above its edge, in widths of the edge (chosen).
pub const WITHIN_RANGE: f32 = 3.0;
/// Distance from a border that byte 255 stands for [m] (chosen: half of a thick sheath).
pub const BORDER_RANGE: f32 = 1.5e-3;

/// A vertical cut through a food.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceLook {
    /// A point of the plane, rest frame [m].
    pub point: Vec3,
    /// Unit normal, rest frame; the side it points to is hidden (ghosted).
    pub normal: Vec3,
    /// Vertices of the cut face.
    pub vertices: Vec<FoodVertex>,
    /// Triangles of the cut face, facing along `normal`.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the hidden side is to be seen as a ghost; it is not where a knife has parted it.
    pub ghost: bool,
}

/// State of one vertex of a food; the colours before browning come from the core (L*a*b* over 100).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FoodVertex {
    /// Position in the rest shape, where the solid textures are sampled [m].
    pub rest: [f32; 3],
    /// Outward unit normal in the rest frame.
    pub normal: [f32; 3],
    /// Colour of lean flesh of the first tissue before it browns.
    pub lean: [f32; 3],
    /// Colour of fat before it browns.
    pub fat: [f32; 3],
    /// Browning (0–1).
    pub browning: f32,
    /// Charring (0–1).
    pub charring: f32,
    /// Liquid on the surface (0 dry crust – 1 glistening).
    pub wetness: f32,
    /// How far it is cooked (0 raw – 1 done): opaque, matt.
    pub cooked: f32,
    /// Coordinate into the colour table (0–1), linear between vertices.
    pub field: f32,
    /// Place along the body (0–1), where that matters: a shrimp's segments.
    pub along: f32,
    /// Belly (−1) to back (1), likewise.
    pub dorsal: f32,
    /// How dark seared lines are here over their mean on the face.
    pub seared: f32,
    /// Position in the present shape, in the same frame [m].
    pub position: [f32; 3],
    /// Juice that lies on the face over the most that stays there (0–1): it stands in beads.
    pub juice: f32,
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

/// A spot of oil on the pan's wall or beside the pan, world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLook {
    /// Its middle [m].
    pub position: Vec3,
    /// Unit normal of what it lies on.
    pub normal: Vec3,
    /// Its radius [m].
    pub radius: f32,
}

/// What rises from the pan.
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
    /// How much of it [g/s].
    pub flow_g_s: f32,
}
