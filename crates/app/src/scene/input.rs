//! What the scene renderer is given: one plain description of everything in the picture.
//!
//! World frame: metres, right-handed, x to the cook's right, y away from the cook, z up; the origin is the
//! centre of the hob ring on the glass. The renderer computes no physics and knows no kitchen.

use std::sync::Arc;

use glam::{Mat4, Quat, Vec3};

use super::camera::Camera;

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
    /// What food on the board rests on or under.
    pub rest: Option<RestLook>,
    /// Places where water vapour leaves.
    pub steam: Vec<SteamSource>,
    /// Simulated time [s]; moves steam and the shimmer of the oil, nothing else.
    pub time_s: f32,
    /// What the colours mean.
    pub colouring: Colouring,
    /// True writes the colours unlit, without tone mapping, shadow, dither or anti-aliasing, so that they decode exactly.
    pub flat: bool,
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
        /// True: take the nearest entry (classes); false: interpolate.
        stepped: bool,
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
    /// Oil film over the floor (0 none – 1 glossy pool).
    pub oil: f32,
    /// Centre of the pan's underside, relative to the hob centre [m]; the cooking surface is `thickness` above it.
    pub position: Vec3,
    /// How it is turned about that point.
    pub rotation: Quat,
    /// True: a folded wet cloth lies under the pan (else it lies folded at the left of the hob).
    pub on_cloth: bool,
    /// Field coordinate (0–1) on `FLOOR_FIELD_RINGS` equidistant radii from the centre to `floor_radius`.
    pub floor_field: [f32; FLOOR_FIELD_RINGS],
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
}

/// The rest shape of a food; shared between frames.
#[derive(Clone, Debug)]
pub struct FoodMesh {
    /// Changes when the mesh or the marbling changes; renderers cache by it.
    pub key: u64,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Fat seen in the flesh: fraction (0–255 for 0–1) on a regular grid over the rest box, x fastest.
    pub fat: FatVolume,
}

/// Fat fraction on a regular grid, for the marbling that is seen.
#[derive(Clone, Debug)]
pub struct FatVolume {
    /// Cells along x, y, z.
    pub size: [u32; 3],
    /// Lowest corner in the rest frame [m].
    pub origin: Vec3,
    /// Extent in the rest frame [m].
    pub extent: Vec3,
    /// One byte a cell, x fastest, 255 = pure fat.
    pub cells: Vec<u8>,
}

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
}

/// State of one vertex of a food, colours already computed by the core (linear sRGB reflectance).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FoodVertex {
    /// Position in the rest shape, where the solid textures are sampled [m].
    pub rest: [f32; 3],
    /// Outward unit normal in the rest frame.
    pub normal: [f32; 3],
    /// Colour of lean flesh in this state.
    pub lean: [f32; 3],
    /// Colour of lean flesh in this state, browned somewhat further: the shader mixes towards it in a mottled pattern.
    pub browner: [f32; 3],
    /// Colour of fat in this state.
    pub fat: [f32; 3],
    /// Liquid on the surface (0 dry crust – 1 glistening).
    pub wetness: f32,
    /// Crust (0 none – 1 thick): roughness, relief.
    pub crust: f32,
    /// Coordinate into the colour table (0–1), linear between vertices.
    pub field: f32,
    /// Position in the present shape, in the same frame [m].
    pub position: [f32; 3],
}

/// A place where vapour leaves.
#[derive(Clone, Copy, Debug)]
pub struct SteamSource {
    /// Where, world frame [m].
    pub position: Vec3,
    /// Radius of the patch [m].
    pub radius: f32,
    /// Vapour [g/s].
    pub flow_g_s: f32,
}
