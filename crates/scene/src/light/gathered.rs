//! Samples of light: a still that gathers light is the mean of many pictures, each with its own place in the pixel, in the
//! lens, and on the light.

use glam::{Mat4, Vec2, Vec3, Vec4};

/// Every so many samples one lights by the dome of the room alone; the others do by all else.
const DOME_EVERY: u32 = 4;
/// Radius of the aperture [m] (chosen: a steak is sharp from its nearest to its farthest edge in the working view; in a
/// close-up the far edge is a little soft).
const LENS_RADIUS: f32 = 0.0012;
/// Half the angle at which the light that casts shadows is seen [rad] (chosen: a window of a metre from three metres).
const LIGHT_RADIUS: f32 = 0.10;
/// Softness of the shadows of a sample over the usual one (chosen: the edges of the samples' shadows run into each other).
const DOME_SOFTNESS: f32 = 3.0;
const KEY_SOFTNESS: f32 = 0.8;
/// Lowest direction of the dome: what is lower is hidden by what stands in a kitchen (chosen).
const DOME_FROM: f32 = 0.12;

/// What the samples of one picture have in common.
#[derive(Clone, Copy, Debug)]
pub struct Gathers {
    /// Direction towards the light that casts shadows.
    pub towards: Vec3,
    /// Width of the aperture over the usual one [-].
    pub aperture: f32,
    /// Distance along the axis of the eye that is sharp [m].
    pub sharp: f32,
    /// Size of the whole picture [pixels].
    pub size: [u32; 2],
    /// Number of samples.
    pub count: u32,
}

/// One sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    index: u32,
    /// Shift in normalised device coordinates of the whole picture.
    pixel: Vec2,
    /// Place in the aperture, to the right and up [m], and the distance that is sharp [m].
    lens: Vec2,
    sharp: f32,
    /// Direction towards the light that casts shadows.
    towards: Vec3,
    /// True if only the dome of the room lights, from that direction.
    dome: bool,
    /// Shares of the light that casts shadows and of the dome that fall to it: their means over all samples are 1.
    shares: [f32; 2],
}

/// Element `index`, from 1, of the Halton sequence of a base, 0 to 1 (Halton 1964).
fn halton(mut index: u32, base: u32) -> f32 {
    let (mut sum, mut share) = (0.0, 1.0);
    while index > 0 {
        share /= base as f32;
        sum += share * (index % base) as f32;
        index /= base;
    }
    sum
}

/// A point of the unit square on the unit disc, areas in proportion.
fn on_disc([across, round]: [f32; 2]) -> Vec2 {
    across.sqrt() * Vec2::from_angle(round * std::f32::consts::TAU)
}

impl LightSample {
    /// Number of samples of pictures that are kept (chosen: shadows have soft edges without steps).
    pub const KEPT: u32 = 32;

    /// Number of samples after which their mean shows light of each kind in its proportion.
    pub const ROUND: u32 = DOME_EVERY;

    /// Sample `index`. Fewer than [`Self::ROUND`] have none of the dome.
    pub fn new(index: u32, all: &Gathers) -> Self {
        let at = |bases: [u32; 2], index| bases.map(|base| halton(index + 1, base));
        let size = Vec2::new(all.size[0] as f32, all.size[1] as f32);
        // Whole rounds only: otherwise the last samples would give one kind of light more than its share.
        let in_round = index < all.count / DOME_EVERY * DOME_EVERY;
        let dome = in_round && index % DOME_EVERY == DOME_EVERY - 1;
        let towards = if dome {
            dome_direction(at([2, 3], index / DOME_EVERY))
        } else {
            near(all.towards, on_disc(at([5, 7], index)))
        };
        let every = DOME_EVERY as f32;
        let shares = match (in_round, dome) {
            (false, _) => [1.0, 1.0],
            (true, true) => [0.0, every],
            (true, false) => [every / (every - 1.0), 0.0],
        };
        Self {
            index,
            pixel: (2.0 * Vec2::from_array(at([2, 3], index)) - 1.0) / size,
            lens: LENS_RADIUS * all.aperture * on_disc(at([11, 13], index)),
            sharp: all.sharp,
            towards,
            dome,
            shares,
        }
    }

    /// Unit vector towards what lights and casts shadows.
    pub(crate) fn towards(&self) -> Vec3 {
        self.towards
    }

    /// The eye's place in the aperture, to the right and up [m].
    pub(crate) fn in_lens(&self) -> Vec2 {
        self.lens
    }

    /// Maps the space of the eye to that of this sample: what is at the sharp distance stays where it is.
    pub(crate) fn through_lens(&self) -> Mat4 {
        let slant = self.lens / self.sharp;
        let shear = Mat4::from_cols(Vec4::X, Vec4::Y, (-slant).extend(1.0).extend(0.0), Vec4::W);
        shear * Mat4::from_translation((-self.lens).extend(0.0))
    }

    /// Shifts the picture within its pixels.
    pub(crate) fn in_pixel(&self) -> Mat4 {
        Mat4::from_translation(self.pixel.extend(0.0))
    }

    /// Light that casts shadows, other light, and three fills, for this sample alone: as the mean of all, each is whole.
    pub(crate) fn share(&self, lights: [Vec4; 5]) -> [Vec4; 5] {
        let [of_key, of_dome] = self.shares;
        let [key, other, fills @ ..] = lights;
        let [sky, ground, front] = fills.map(|light| light * of_dome);
        [key * of_key, other, sky, ground, front]
    }

    /// How much softer the shadows of this sample are than those of a picture of its own: few directions stand for a dome.
    pub(crate) fn softness(&self) -> f32 {
        if self.dome { DOME_SOFTNESS } else { KEY_SOFTNESS }
    }

    /// How far noise is shifted in this sample [pixels] (chosen: its mean over the samples is even).
    pub(crate) fn noise_shift(&self) -> f32 {
        5.588_238 * self.index as f32
    }

    /// Number of the kind of sample, as the shaders read it.
    pub(crate) fn kind(&self) -> f32 {
        if self.dome { 1.0 } else { 0.0 }
    }
}

/// A direction near another one, by a place on the unit disc.
fn near(direction: Vec3, at: Vec2) -> Vec3 {
    let (across, along) = direction.any_orthonormal_pair();
    (direction + LIGHT_RADIUS * (across * at.x + along * at.y)).normalize()
}

/// A direction of the dome, as often as its light falls on level ground.
fn dome_direction(at: [f32; 2]) -> Vec3 {
    let across = on_disc(at);
    across.extend((1.0 - across.length_squared()).max(0.0).sqrt().max(DOME_FROM)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(count: u32) -> Vec<LightSample> {
        let towards = Vec3::new(-0.6, 0.5, 0.62).normalize();
        let all = Gathers { towards, aperture: 1.0, sharp: 0.5, size: [640, 360], count };
        (0..count).map(|index| LightSample::new(index, &all)).collect()
    }

    #[test]
    fn the_mean_of_all_samples_has_all_the_light() {
        let light = [2.1, 0.8, 0.3, 0.1, 0.5].map(Vec4::splat);
        for count in [1, 2, 4, 6, 32] {
            let mut mean = [Vec4::ZERO; 5];
            for sample in samples(count) {
                sample.share(light).iter().zip(&mut mean).for_each(|(share, sum)| *sum += *share / count as f32);
            }
            let off = mean.iter().zip(light).map(|(mean, whole)| (*mean - whole).abs().max_element());
            assert!(off.fold(0.0, f32::max) < 1e-5, "{count}: {mean:?}");
        }
    }

    #[test]
    fn samples_stay_within_their_pixel_and_the_lens_and_are_spread_over_both() {
        let all = samples(32);
        let half = Vec2::new(1.0 / 640.0, 1.0 / 360.0);
        assert!(all.iter().all(|s| s.pixel.abs().cmple(half).all() && s.lens.length() <= LENS_RADIUS));
        let mean = |of: &dyn Fn(&LightSample) -> Vec2| all.iter().map(of).sum::<Vec2>() / 32.0;
        assert!((mean(&|s| s.pixel) / half).length() < 0.1 && mean(&|s| s.lens).length() < 0.2 * LENS_RADIUS);
    }

    #[test]
    fn what_is_sharp_stays_where_it_is_wherever_in_the_lens_it_is_seen_from() {
        for sample in samples(8) {
            let there = Vec3::new(0.03, -0.02, -sample.sharp);
            assert!(sample.through_lens().transform_point3(there).abs_diff_eq(there, 1e-6));
            let behind = Vec3::new(0.0, 0.0, -2.0 * sample.sharp);
            let moved = sample.through_lens().transform_point3(behind).truncate();
            assert!(moved.abs_diff_eq(sample.lens, 1e-6), "{moved}");
        }
    }

    #[test]
    fn light_comes_from_near_the_window_or_from_above() {
        let key = Vec3::new(-0.6, 0.5, 0.62).normalize();
        for sample in samples(32) {
            assert!((sample.towards.length() - 1.0).abs() < 1e-5);
            assert!(if sample.dome { sample.towards.z > 0.1 } else { sample.towards.angle_between(key) < 0.11 });
        }
        assert_eq!(samples(32).iter().filter(|s| s.dome).count(), 8);
    }
}
