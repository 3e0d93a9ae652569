//! The light of the room: one definition for the shaders and for the white balance.

use glam::Vec3;

use crate::light::environment::{LAMP_DIRECTION, WINDOW_DIRECTION};

/// Irradiance / pi of window, lamp and fill, linear sRGB (chosen; the window matches the radiance in the environment
/// picture).
const KEY: Vec3 = Vec3::new(2.15, 2.12, 2.05);
const LAMP: Vec3 = Vec3::new(0.80, 0.55, 0.30);
const FILL_SKY: Vec3 = Vec3::new(0.33, 0.32, 0.31);
const FILL_GROUND: Vec3 = Vec3::new(0.13, 0.12, 0.11);
/// Light that comes back from the room behind the cook, and where from.
const FILL_FRONT: Vec3 = Vec3::new(0.52, 0.49, 0.44);
const FRONT: Vec3 = Vec3::new(0.12, -0.84, 0.53);
/// The lamp is near and large: it lights what is turned away from it a little (chosen).
const LAMP_WRAP: f32 = 0.25;

/// The same as constants of the shaders.
pub(crate) fn wgsl() -> String {
    let vector = |(name, v): (&str, Vec3)| format!("const {name} = vec3<f32>({:?}, {:?}, {:?});\n", v.x, v.y, v.z);
    let vectors = [
        ("KEY", KEY),
        ("LAMP", LAMP),
        ("FILL_SKY", FILL_SKY),
        ("FILL_GROUND", FILL_GROUND),
        ("FILL_FRONT", FILL_FRONT),
        ("FRONT", FRONT),
    ];
    vectors.map(vector).concat() + &format!("const LAMP_WRAP = {LAMP_WRAP:?};\n")
}

/// Radiance of a white patch that lies flat in the full light of window, lamp and room [linear sRGB].
pub(crate) fn white_patch() -> Vec3 {
    let lamp = LAMP_DIRECTION.normalize().z * (1.0 - LAMP_WRAP) + LAMP_WRAP;
    KEY * WINDOW_DIRECTION.normalize().z + LAMP * lamp + FILL_SKY + FILL_FRONT * FRONT.z
}
