//! White balance of the look, by the apparent colour temperature of a white plate.

use glam::{Mat3, Vec3};

use crate::light::room_light::RoomLight;

/// White balance of the look; views of fields and flat pictures are not balanced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WhiteBalance {
    /// A kitchen in the evening sun, a little warm.
    #[default]
    AsShot,
    /// White is white.
    Neutral,
    /// As under an overcast sky.
    Cool,
    /// As under a lamp.
    Warm,
}

/// Exposure and balance as shot, linear sRGB (chosen: as bright as pictures of food are; a flat white patch in
/// the full light of window, lamp and room is on the shoulder of the curve, and is a little warm).
const AS_SHOT: Vec3 = Vec3::new(0.602, 0.618, 0.629);
/// Share of the linear sRGB components in the luminance (IEC 61966-2-1 `[@iec-61966-2-1]`).
const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);
/// Linear sRGB from CIE XYZ (IEC 61966-2-1 `[@iec-61966-2-1]`), by columns.
const SRGB_FROM_XYZ: Mat3 = Mat3::from_cols(
    Vec3::new(3.240_454_2, -0.969_266, 0.055_643_4),
    Vec3::new(-1.537_138_5, 1.876_010_8, -0.204_025_9),
    Vec3::new(-0.498_531_4, 0.041_556, 1.057_225_2),
);
/// Colour temperature of the white of sRGB, D65 [K].
const D65_K: f32 = 6504.0;

impl WhiteBalance {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::AsShot, Self::Neutral, Self::Cool, Self::Warm];

    /// Correlated colour temperature that a white patch in the room has in the picture [K].
    pub fn appears_k(self) -> f32 {
        match self {
            // What the constants above amount to; a test computes it.
            Self::AsShot => 5750.0,
            Self::Neutral => D65_K,
            // An overcast sky, and a lamp to which the eye has half adapted (chosen).
            Self::Cool => 8000.0,
            Self::Warm => 4500.0,
        }
    }

    /// As [`Self::appears_k`], under a light of the room [K].
    pub fn appears_in(self, light: RoomLight) -> f32 {
        match (self, light) {
            // The eye adapts to a lamp, but not wholly (chosen).
            (Self::AsShot, RoomLight::Evening) => 4700.0,
            _ => self.appears_k(),
        }
    }

    /// What radiances are multiplied by, exposure included [linear sRGB]: von Kries' scaling in linear sRGB, of one
    /// luminance for a white patch under every balance and light.
    pub(crate) fn gains(self, light: RoomLight) -> Vec3 {
        if (self, light) == (Self::AsShot, RoomLight::Daylight) {
            return AS_SHOT;
        }
        let patch = light.white_patch();
        let white = daylight(self.appears_in(light)) / daylight(D65_K);
        let exposed = LUMINANCE.dot(AS_SHOT * RoomLight::Daylight.white_patch());
        white / patch * (exposed / LUMINANCE.dot(white))
    }
}

/// Colour of daylight of a colour temperature from 4000 to 25 000 K, of luminance 1 [linear sRGB] (CIE 15:2018
/// `[@cie-15-2018]`, 4.1.2).
fn daylight(kelvin: f32) -> Vec3 {
    let t = 1000.0 / kelvin;
    let x = if kelvin <= 7000.0 {
        0.244_063 + t * (0.099_11 + t * (2.967_8 - 4.607_0 * t))
    } else {
        0.237_040 + t * (0.247_48 + t * (1.901_8 - 2.006_4 * t))
    };
    let y = -0.275 + x * (2.870 - 3.0 * x);
    SRGB_FROM_XYZ * Vec3::new(x / y, 1.0, (1.0 - x - y) / y)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The white patch in the picture before the tone curve, green = 1.
    fn seen(balance: WhiteBalance) -> Vec3 {
        let seen = RoomLight::Daylight.white_patch() * balance.gains(RoomLight::Daylight);
        seen / seen.y
    }

    /// CIE 1931 chromaticity of a linear sRGB colour.
    fn chromaticity(rgb: Vec3) -> [f32; 2] {
        let xyz = SRGB_FROM_XYZ.inverse() * rgb;
        [xyz.x, xyz.y].map(|v| v / xyz.element_sum())
    }

    #[test]
    fn a_white_patch_comes_out_neutral_under_neutral() {
        assert!(seen(WhiteBalance::Neutral).abs_diff_eq(Vec3::ONE, 1e-5), "{}", seen(WhiteBalance::Neutral));
    }

    #[test]
    fn a_lower_colour_temperature_is_redder_and_less_blue() {
        let mut order = WhiteBalance::ALL;
        order.sort_by(|a, b| a.appears_k().total_cmp(&b.appears_k()));
        for pair in order.windows(2) {
            let [warmer, cooler] = [seen(pair[0]), seen(pair[1])];
            assert!(warmer.x > cooler.x + 0.02 && warmer.z < cooler.z - 0.02, "{pair:?}: {warmer} {cooler}");
        }
    }

    #[test]
    fn every_balance_is_equally_bright() {
        let brightness =
            |balance: WhiteBalance, light: RoomLight| LUMINANCE.dot(light.white_patch() * balance.gains(light));
        let as_shot = brightness(WhiteBalance::AsShot, RoomLight::Daylight);
        for (balance, light) in WhiteBalance::ALL.iter().flat_map(|b| RoomLight::ALL.map(|light| (*b, light))) {
            assert!((brightness(balance, light) / as_shot - 1.0).abs() < 1e-4, "{balance:?} {light:?}");
        }
    }

    #[test]
    fn the_picture_as_shot_lies_on_daylight_of_its_colour_temperature() {
        // McCamy (1992) [@mccamy-1992]: CCT = 449 n³ + 3525 n² + 6823.3 n + 5520.33.
        let [x, y] = chromaticity(seen(WhiteBalance::AsShot));
        let n = (x - 0.3320) / (0.1858 - y);
        let kelvin = 5520.33 + n * (6823.3 + n * (3525.0 + 449.0 * n));
        assert!((kelvin - WhiteBalance::AsShot.appears_k()).abs() < 30.0, "{kelvin}");
        let locus = chromaticity(daylight(kelvin));
        assert!((locus[0] - x).hypot(locus[1] - y) < 0.003, "{locus:?} {x} {y}");
    }

    #[test]
    fn daylight_of_6504_k_is_d65() {
        let [x, y] = chromaticity(daylight(D65_K));
        assert!((x - 0.3127).abs() < 2e-4 && (y - 0.3290).abs() < 2e-4, "{x} {y}");
    }
}
