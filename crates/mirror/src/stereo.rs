//! Two eyes: how their pictures share one device.

use glam::{DMat3, DVec3};

use crate::rig::Rig;

/// Stereo modes: how two eyes' pictures share the device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stereo {
    /// One picture for the point between the eyes.
    #[default]
    Off,
    /// The left eye's in red, the right eye's in cyan, for glasses of those colours.
    Anaglyph,
    /// The left eye's in the left half, the right eye's in the right half, each squeezed to half its width, as
    /// projectors and screens with shutter or polarised glasses take it.
    SideBySide,
}

impl Stereo {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Off, Self::Anaglyph, Self::SideBySide];

    /// The eyes that see a picture each, the left one first [m].
    pub fn eyes(self, rig: &Rig, distance: f64) -> Vec<DVec3> {
        let half = 0.5 * distance * DVec3::X;
        if self == Self::Off { vec![rig.eye] } else { vec![rig.eye - half, rig.eye + half] }
    }
}

/// Share of linear sRGB's red, green and blue in luminance (IEC 61966-2-1 `[@iec-61966-2-1]`).
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// What each eye's picture gives to an anaglyph, in linear sRGB: matrices for the left and the right eye's colours,
/// whose results are added.
///
/// The rule: through its glass each eye sees the luminance of its picture, as a share of what white has there, whatever
/// the colours; so that a red steak is as bright to one eye as to the other. Red is the left picture's luminance. Green
/// and blue are the right picture's, both shifted alike until their own luminance is the picture's.
pub fn anaglyph() -> [DMat3; 2] {
    let left = DMat3::from_cols(DVec3::X * LUMINANCE.x, DVec3::X * LUMINANCE.y, DVec3::X * LUMINANCE.z);
    let cyan = DVec3::new(0.0, LUMINANCE.y, LUMINANCE.z) / (LUMINANCE.y + LUMINANCE.z);
    // By columns: what a unit of each colour adds to the shift.
    let shift = LUMINANCE - cyan;
    let both = DVec3::new(0.0, 1.0, 1.0);
    let kept = DMat3::from_diagonal(both);
    let right = kept + DMat3::from_cols(both * shift.x, both * shift.y, both * shift.z);
    [left, right]
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, Mat4, Vec3};

    use super::*;
    use crate::rig_file::shipped;

    #[test]
    fn both_eyes_see_the_luminance_of_their_picture_whatever_its_colour() {
        let [left, right] = anaglyph();
        for colour in [DVec3::ONE, DVec3::new(0.4, 0.12, 0.08), DVec3::new(0.1, 0.5, 0.2), DVec3::splat(0.18)] {
            let luminance = LUMINANCE.dot(colour);
            let shown = left * colour + right * colour;
            assert!((shown.x - luminance).abs() < 1e-12, "{shown}");
            let through_cyan = (LUMINANCE.y * shown.y + LUMINANCE.z * shown.z) / (LUMINANCE.y + LUMINANCE.z);
            assert!((through_cyan - luminance).abs() < 1e-12, "{shown}");
        }
        assert!((left * DVec3::ONE + right * DVec3::ONE).distance(DVec3::ONE) < 1e-12, "white stays white");
    }

    /// How far to the right of the left eye's the right eye shows a point that is above the image's plane [pixels].
    fn parallax(rig: &Rig, above: f64) -> f64 {
        let foot = rig.image.point(DVec2::splat(0.5));
        let middle = foot + rig.image.normal() * above;
        let [left, right] = [0, 1].map(|side| {
            let eye = Stereo::SideBySide.eyes(rig, 0.063)[side];
            let clip: Mat4 = rig.image.view_projection(eye).as_mat4();
            let ndc = clip.project_point3(Vec3::new(middle.x as f32, middle.y as f32, middle.z as f32));
            f64::from(0.5 + 0.5 * ndc.x) * 1920.0
        });
        right - left
    }

    #[test]
    fn what_is_nearer_than_the_image_is_shown_further_left_to_the_right_eye_by_as_much_as_its_height_says() {
        let rig = shipped("flat-screen").expect("is there").expect("is read");
        let eye_above = (rig.eye - rig.image.corner).dot(rig.image.normal());
        let pixel = rig.image.size.x / 1920.0;
        for above in [0.0, 0.02, 0.05, -0.02] {
            // Similar triangles: the eyes' distance is to the shift as the way up to the eyes is to the way down.
            let expected = -0.063 * above / (eye_above - above) / pixel;
            let seen = parallax(&rig, above);
            assert!((seen - expected).abs() < 0.01, "{above}: {seen} {expected}");
        }
        assert!(parallax(&rig, 0.02) < -8.0 && parallax(&rig, 0.02) > -9.0, "{}", parallax(&rig, 0.02));
    }
}
