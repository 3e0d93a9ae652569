//! The light of the room: a soft window, a warm lamp, a dim fill, as a small prefiltered picture of the upper half
//! space. Roughness grows with the mip level; the shapes are simple enough to be blurred in closed form.

use glam::{Vec2, Vec3};

use crate::light::room_light::{RoomLight, Sources};

/// Texels along the finest level.
pub(crate) const ENVIRONMENT_SIZE: u32 = 256;
/// Levels from mirror (0) to fully rough.
pub(crate) const ENVIRONMENT_LEVELS: u32 = 7;
/// Unit vector towards the middle of the window, left and behind the hob (chosen).
pub(crate) const WINDOW_DIRECTION: Vec3 = Vec3::new(-0.585, 0.515, 0.627);
/// Unit vector towards the lamp, above, a little to the right and to the front (chosen).
pub(crate) const LAMP_DIRECTION: Vec3 = Vec3::new(0.24, -0.10, 0.966);

/// Unit vector towards the brightest part of the sky (chosen: seen in the oil from the working view).
const SUN_DIRECTION: Vec3 = Vec3::new(-0.342, 0.583, 0.738);

/// One level of the environment as RGBA16F, x fastest.
pub(crate) fn level(light: RoomLight, level: u32) -> Vec<u16> {
    let size = ENVIRONMENT_SIZE >> level;
    let blur = 0.035 + 1.1 * (level as f32 / (ENVIRONMENT_LEVELS - 1) as f32).powi(2);
    let mut texels = Vec::with_capacity((size * size * 4) as usize);
    for index in 0..size * size {
        let at = Vec2::new((index % size) as f32 + 0.5, (index / size) as f32 + 0.5) / size as f32 * 2.0 - 1.0;
        let colour = radiance(light.sources(), direction(at), blur);
        texels.extend([half(colour.x), half(colour.y), half(colour.z), half(1.0)]);
    }
    texels
}

/// Direction of a point of the picture (paraboloid map of the upper half space, continued a little below it).
fn direction(at: Vec2) -> Vec3 {
    let square = at.length_squared();
    Vec3::new(2.0 * at.x, 2.0 * at.y, 1.0 - square) / (1.0 + square)
}

/// Radiance from a direction, blurred by an angle [rad].
fn radiance(lit: &Sources, direction: Vec3, blur: f32) -> Vec3 {
    room(direction, blur) * lit.walls
        + lit.window * window(direction, blur)
        + lit.sun * sun(direction, blur)
        + lit.lamp * lamp(direction, blur)
}

/// Walls and ceiling: lighter above and on the window's side, dark towards the counter.
fn room(direction: Vec3, blur: f32) -> Vec3 {
    let up = step(direction.z, 0.35 + blur);
    let side = 0.5 - 0.5 * (direction.x * 0.8 - direction.y * 0.25);
    let wall = Vec3::new(0.52, 0.50, 0.47) * (0.55 + 0.7 * side);
    let ceiling = Vec3::new(0.78, 0.74, 0.68);
    let ground = Vec3::new(0.085, 0.078, 0.07);
    ground.lerp(wall.lerp(ceiling, step(direction.z - 0.62, 0.25 + blur)), up)
}

/// Share of the window seen: two panes by two, on a plane left and behind.
fn window(direction: Vec3, blur: f32) -> f32 {
    let out = Vec3::new(WINDOW_DIRECTION.x, WINDOW_DIRECTION.y, 0.0).normalize();
    let across = Vec3::new(-out.y, out.x, 0.0);
    let depth = direction.dot(out);
    if depth < 0.02 {
        return 0.0;
    }
    let (u, v) = (direction.dot(across) / depth, direction.z / depth);
    // Blur on the plane grows where the plane is seen obliquely.
    let spread = blur * (1.0 + 0.5 * v);
    let mullions = (1.0 - 0.8 * bar(u, -0.02, 0.02, spread)) * (1.0 - 0.8 * bar(v, 0.83, 0.87, spread));
    bar(u, -0.50, 0.50, spread) * bar(v, 0.38, 1.32, spread) * mullions
}

/// A bulb under its shade.
fn lamp(direction: Vec3, blur: f32) -> f32 {
    spot(direction, LAMP_DIRECTION, 0.002, blur)
}

/// The brightest part of the sky: a cloud in the sun, in the window's upper corner.
fn sun(direction: Vec3, blur: f32) -> f32 {
    spot(direction, SUN_DIRECTION, 0.0012, blur)
}

/// A round light, 1 in its middle, of a width in the cosine; blurring keeps its energy.
fn spot(direction: Vec3, towards: Vec3, size: f32, blur: f32) -> f32 {
    let width = size + blur * blur;
    let away = 1.0 - direction.dot(towards.normalize());
    size / width * (-away / width).exp()
}

/// A box from `low` to `high` after blurring: keeps its area.
fn bar(x: f32, low: f32, high: f32, blur: f32) -> f32 {
    step(x - low, blur) - step(x - high, blur)
}

fn step(x: f32, blur: f32) -> f32 {
    0.5 + 0.5 * (1.4 * x / blur).tanh()
}

/// IEEE half of a value in the normal range; smaller ones become 0.
fn half(value: f32) -> u16 {
    let bits = value.clamp(0.0, 65000.0).to_bits();
    let exponent = (bits >> 23) as i32 - 127 + 15;
    if exponent <= 0 { 0 } else { ((exponent as u32) << 10 | (bits >> 13 & 0x3ff)) as u16 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_decode_to_what_was_encoded() {
        assert_eq!(half(1.0), 0x3c00);
        assert_eq!(half(0.5), 0x3800);
        assert_eq!(half(9.0), 0x4880);
        assert_eq!(half(0.0), 0);
    }

    #[test]
    fn the_window_is_brightest_in_its_own_direction() {
        assert!(window(WINDOW_DIRECTION, 0.2) > 0.6);
        assert!(window(-WINDOW_DIRECTION, 0.2) < 0.01);
    }
}
