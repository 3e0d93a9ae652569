//! The light of the room: one definition for the shaders, the environment picture and the white balance.

use glam::{Vec3, Vec4};

use crate::light::environment::{LAMP_DIRECTION, WINDOW_DIRECTION};

/// Where the light comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RoomLight {
    /// From the window; the lamp over the hob helps.
    #[default]
    Daylight,
    /// From the lamp; the window is dark blue.
    Evening,
}

/// Light that one time of the day gives [linear sRGB].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sources {
    /// Unit vector towards the light that casts the shadows, and its irradiance / pi.
    pub key_direction: Vec3,
    pub key: Vec3,
    /// Unit vector towards the other light, and its irradiance / pi.
    pub other_direction: Vec3,
    pub other: Vec3,
    /// Light of the room from above, from below, and from behind the cook.
    pub fill_sky: Vec3,
    pub fill_ground: Vec3,
    pub fill_front: Vec3,
    /// Radiance of the window's panes, of the brightest part of the sky in them, of the lamp, and of the walls over those of the day.
    pub window: Vec3,
    pub sun: Vec3,
    pub lamp: Vec3,
    pub walls: Vec3,
}

/// Daylight at 5500 K and tungsten at 3000 K under a white balance between them (chosen; the window matches the radiance
/// in the environment picture; its image is a little warmer than its light, so that it lights flesh and crust without a
/// violet cast).
const DAYLIGHT: Sources = Sources {
    key_direction: WINDOW_DIRECTION,
    key: Vec3::new(2.15, 2.12, 2.05),
    other_direction: LAMP_DIRECTION,
    other: Vec3::new(0.80, 0.55, 0.30),
    fill_sky: Vec3::new(0.33, 0.32, 0.31),
    fill_ground: Vec3::new(0.13, 0.12, 0.11),
    fill_front: Vec3::new(0.52, 0.49, 0.44),
    window: Vec3::new(8.9, 8.7, 8.4),
    sun: Vec3::new(190.0, 187.0, 180.0),
    lamp: Vec3::new(65.0, 46.0, 27.0),
    walls: Vec3::ONE,
};

/// The lamp alone, turned up, its light thrown back by the walls; dusk in the window (chosen).
const EVENING: Sources = Sources {
    key_direction: Vec3::new(0.30, 0.22, 0.93),
    key: Vec3::new(2.40, 1.66, 0.95),
    other_direction: WINDOW_DIRECTION,
    other: Vec3::new(0.050, 0.075, 0.140),
    fill_sky: Vec3::new(0.46, 0.34, 0.22),
    fill_ground: Vec3::new(0.17, 0.12, 0.08),
    fill_front: Vec3::new(0.50, 0.37, 0.25),
    window: Vec3::new(0.10, 0.17, 0.36),
    // A lamp across the room, in the pane.
    sun: Vec3::new(120.0, 84.0, 50.0),
    lamp: Vec3::new(200.0, 140.0, 82.0),
    walls: Vec3::new(0.85, 0.62, 0.42),
};

/// Where the light from behind the cook comes from.
const FRONT: Vec3 = Vec3::new(0.12, -0.84, 0.53);
/// The other light is near and large: it lights what is turned away from it a little (chosen).
const OTHER_WRAP: f32 = 0.25;

impl RoomLight {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Daylight, Self::Evening];

    pub(crate) fn sources(self) -> &'static Sources {
        match self {
            Self::Daylight => &DAYLIGHT,
            Self::Evening => &EVENING,
        }
    }

    /// Radiance of a flat white patch in the full light of the room [linear sRGB].
    pub(crate) fn white_patch(self) -> Vec3 {
        let lit = self.sources();
        let other = lit.other_direction.normalize().z * (1.0 - OTHER_WRAP) + OTHER_WRAP;
        lit.key * lit.key_direction.normalize().z + lit.other * other + lit.fill_sky + lit.fill_front * FRONT.z
    }

    /// Key, other light, fill from above, below and the front, as the shaders read them.
    pub(crate) fn uniform(self) -> [Vec4; 5] {
        let lit = self.sources();
        [lit.key, lit.other, lit.fill_sky, lit.fill_ground, lit.fill_front].map(|light| light.extend(0.0))
    }
}

/// What does not depend on the time of the day, as constants of the shaders.
pub(crate) fn wgsl() -> String {
    format!(
        "const FRONT = vec3<f32>({:?}, {:?}, {:?});\nconst OTHER_WRAP = {OTHER_WRAP:?};\n",
        FRONT.x, FRONT.y, FRONT.z
    )
}
