//! Which patches of a piece are near to the pan, how far they are off, and where on the pan they lie.

use glam::DVec3;
use saute_food::{FoodModel, PatchPose};
use saute_heat::Located;

use crate::dynamics::{PanShape, Pose};
use crate::pan::PanModel;

/// Distance beyond which a patch no longer faces the pan through a film of its own [m] (chosen: 3 mm of vapour conduct as
/// much as free air does).
const REACH: f64 = 3.0e-3;
/// Distance of the nearest patch up to which a piece lies on the pan [m] (chosen: what the solid that stands for the
/// piece may stray from its surface, and the rigid bodies' give).
const LYING: f64 = 1.0e-3;
/// Cosine between a patch's normal and the surface's below which they face each other [-] (chosen: 60°).
const FACING: f64 = -0.5;
/// How much farther than the face's mean a patch may be before that counts [m] (chosen: a 25 mm slab of 10–20 kPa gives
/// by 0.3 mm under its own weight).
const GIVE: f64 = 0.3e-3;
/// Patches up to this much farther off than the nearest make up the face on which the piece lies [m] (chosen: above the
/// bumps of a hand-cut face, which the measured conductances behind the mean gap include).
const FACE: f64 = 1.0e-3;
/// Movement below which everything is as before [m] (chosen: far below the mesh of pan and piece).
const SAME: f64 = 0.1e-3;

/// A patch that faces the pan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearPatch {
    /// Index of the patch.
    pub patch: u32,
    /// How much farther from the pan it is than the face on which the piece lies, beyond what the food gives [m].
    pub gap: f64,
    /// Place on the pan's mesh.
    pub located: Located,
}

/// All patches of a piece that face the pan.
#[derive(Clone, Debug, Default)]
pub struct NearPan {
    /// The patches, in their order.
    pub patches: Vec<NearPatch>,
    seen: Option<(Pose, u64)>,
}

impl NearPan {
    /// Looks again, unless neither pose nor shape have changed; `shape` counts the changes of the piece's shape.
    pub fn look(&mut self, pan: &PanModel, surface: &PanShape, piece: &Pose, poses: &[PatchPose], shape: u64) {
        let same = |(pose, count): &(Pose, u64)| {
            *count == shape
                && (pose.position - piece.position).length() < SAME
                && ((pose.rotation - piece.rotation).length() * 0.1 < SAME)
        };
        if self.seen.as_ref().is_some_and(same) {
            return;
        }
        self.seen = Some((*piece, shape));
        self.patches.clear();
        let mut nearest = f64::INFINITY;
        for (index, patch) in poses.iter().enumerate() {
            let place = piece.to_world(DVec3::from_array(patch.position));
            let Some(over) = surface.over(place) else { continue };
            let facing = (piece.rotation * DVec3::from_array(patch.normal)).dot(over.normal);
            if facing < FACING && over.gap < REACH + LYING {
                nearest = nearest.min(over.gap);
                let located = pan.locator.locate_or_nearest(&pan.section, over.on_mesh);
                self.patches.push(NearPatch { patch: index as u32, gap: over.gap, located });
            }
        }
        if nearest > LYING {
            self.patches.clear();
        }
        let face = self.patches.iter().map(|p| p.gap).filter(|gap| *gap < nearest + FACE);
        let (sum, count) = face.fold((0.0, 0.0), |(sum, count), gap| (sum + gap, count + 1.0));
        let mean = if count > 0.0 { sum / count } else { nearest };
        self.patches.iter_mut().for_each(|p| p.gap = (p.gap - mean - GIVE).max(0.0));
        self.patches.retain(|p| p.gap < REACH);
    }

    /// Forgets what was seen.
    pub fn forget(&mut self) {
        self.seen = None;
        self.patches.clear();
    }
}

/// How uneven a piece's surface is at each patch [m]: seeded noise of a wavelength, each face of mean 0 and of the given
/// standard deviation.
pub fn unevenness(model: &FoodModel, seed: u64, wavelength: f64, deviation: f64) -> Vec<f64> {
    use saute_food::Face;
    use saute_food::noise::fractal;
    let noise = |patch: &saute_food::Patch| {
        let [x, y, z] = model.mesh.position(patch.node as usize);
        let third = match (model.is_slice(), patch.face) {
            (true, Face::Bottom) => 0.0,
            (true, Face::Top) => 31.0,
            _ => 57.0 + z / wavelength,
        };
        fractal(seed ^ 0xc0_47ac, [x / wavelength, y / wavelength, third])
    };
    let mut uneven: Vec<f64> = model.patches.iter().map(noise).collect();
    for face in [Face::Bottom, Face::Top, Face::Side] {
        let of_face: Vec<usize> = (0..uneven.len()).filter(|&i| model.patches[i].face == face).collect();
        let count = of_face.len().max(1) as f64;
        let mean = of_face.iter().map(|&i| uneven[i]).sum::<f64>() / count;
        let square = of_face.iter().map(|&i| (uneven[i] - mean) * (uneven[i] - mean)).sum::<f64>() / count;
        let scale = deviation / libm::sqrt(square).max(1e-9);
        of_face.iter().for_each(|&i| uneven[i] = (uneven[i] - mean) * scale);
    }
    uneven
}
