//! The pan as the renderer's input: shape, surface, film, tint and lid.

use std::sync::Arc;

use glam::{Mat4, Quat, Vec3};

/// Appearance of the pan.
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
    /// Film on the floor; the same allocation as long as it is unchanged.
    pub film: Arc<FilmPicture>,
    /// Heat tint; the same allocation as long as it is unchanged.
    pub tint: Arc<TintPicture>,
    /// Colour of the oil in its bottle, linear sRGB.
    pub oil_colour: Vec3,
    /// How cloudy the oil is: 0 clear, 1 molten butter with its milk solids.
    pub oil_turbidity: f32,
    /// Ridges on the floor, along the pan's y, one through the centre: pitch, width and height [m].
    pub ridges: Option<[f32; 3]>,
    /// The lid, while it is on.
    pub lid: Option<LidLook>,
    /// Centre of the pan's underside, relative to the hob centre [m]; the cooking surface is `thickness` above it.
    pub position: Vec3,
    /// Rotation about that point.
    pub rotation: Quat,
    /// True: a folded wet cloth is under the pan (else it lies folded at the left of the hob).
    pub on_cloth: bool,
    /// Field coordinate (0–1) on `FLOOR_FIELD_RINGS` equidistant radii from the centre to `floor_radius`.
    pub floor_field: [f32; FLOOR_FIELD_RINGS],
}

/// Liquids and what they left on the floor of the pan, seen from above: `FILM_SIZE` squared texels over the square
/// round the floor, x fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilmPicture {
    /// Square roots of the thickness of oil over [`OIL_RANGE`] and of water over [`WATER_RANGE`]; browned fond; foam.
    pub texels: Vec<[u8; 4]>,
}

/// Reflectance of the pan's inside over that of the new pan: `FILM_SIZE` squared texels over the square round the floor
/// with the wall unrolled about it, x fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TintPicture {
    /// Shares of red, green and blue over [`TINT_RANGE`], linear.
    pub texels: Vec<[u8; 4]>,
}

/// Share of reflectance that byte 255 encodes [-].
pub const TINT_RANGE: f32 = 2.0;

/// Texels along each side of a film picture.
pub const FILM_SIZE: u32 = 64;
/// Thickness of oil that byte 255 encodes [m] (chosen: deep frying; roots keep thin films apart).
pub const OIL_RANGE: f32 = 20.0e-3;
/// Thickness of water that byte 255 encodes [m] (chosen in the same way).
pub const WATER_RANGE: f32 = 20.0e-3;

/// What the ranges are as constants of the shaders; thickness in millimetres.
pub(crate) fn wgsl() -> String {
    let [oil, water] = [OIL_RANGE, WATER_RANGE].map(|m| 1e3 * m);
    format!("const OIL_MM = {oil:?};\nconst WATER_MM = {water:?};\nconst TINT_RANGE = {TINT_RANGE:?};\n")
}

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
