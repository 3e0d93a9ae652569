//! Which patches of a piece are near to the pan, how far they are off, and where on the pan they lie.

use glam::DVec3;
use saute_food::limp::Limp;
use saute_food::{FoodModel, Patch, PatchPose};
use saute_heat::Located;

use crate::dynamics::pan_shape::OverPan;
use crate::dynamics::{PanShape, Pose};
use crate::pan::pan_model::PanModel;

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
/// How far a limp piece bends down at most [m] (chosen: half a shrimp's thickness; what stands up higher is propped).
const BEND: f64 = 8.0e-3;
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

/// The shape of a piece as its patches stand now.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// Its patches and their poses.
    pub patches: (&'a [Patch], &'a [PatchPose]),
    /// How it bends under its weight, if it is long.
    pub limp: Option<&'a Limp>,
    /// Counts the changes of its shape.
    pub count: u64,
}

impl NearPan {
    /// Looks again, unless neither pose nor shape have changed.
    pub fn look(&mut self, pan: &PanModel, surface: &PanShape, piece: &Pose, shape: Seen<'_>) {
        let same = |(pose, count): &(Pose, u64)| {
            *count == shape.count
                && (pose.position - piece.position).length() < SAME
                && ((pose.rotation - piece.rotation).length() * 0.1 < SAME)
        };
        if self.seen.as_ref().is_some_and(same) {
            return;
        }
        self.seen = Some((*piece, shape.count));
        let mut facing = facing(surface, piece, shape.patches.1, if shape.limp.is_some() { BEND } else { 0.0 });
        let nearest = facing.iter().map(|(_, over)| over.gap).fold(f64::INFINITY, f64::min);
        self.patches.clear();
        if nearest > LYING {
            return;
        }
        if let Some(limp) = shape.limp {
            settle(&mut facing, limp, shape.patches.0);
        }
        facing.retain(|(_, over)| over.gap < REACH + LYING);
        let face = facing.iter().map(|(_, over)| over.gap).filter(|gap| *gap < nearest + FACE);
        let (sum, count) = face.fold((0.0, 0.0), |(sum, count), gap| (sum + gap, count + 1.0));
        let mean = if count > 0.0 { sum / count } else { nearest };
        let near = |(patch, over): (u32, OverPan)| {
            let gap = (over.gap - mean - GIVE).max(0.0);
            let located = pan.locator.locate_or_nearest(&pan.section, over.on_mesh);
            (gap < REACH).then_some(NearPatch { patch, gap, located })
        };
        self.patches.extend(facing.into_iter().filter_map(near));
    }

    /// Forgets what was seen.
    pub fn forget(&mut self) {
        self.seen = None;
        self.patches.clear();
    }
}

/// The patches that face the surface within reach, or as much farther as the piece may bend.
fn facing(surface: &PanShape, piece: &Pose, poses: &[PatchPose], bend: f64) -> Vec<(u32, OverPan)> {
    let facing = |(index, patch): (usize, &PatchPose)| {
        let over = surface.over(piece.to_world(DVec3::from_array(patch.position)))?;
        let towards = (piece.rotation * DVec3::from_array(patch.normal)).dot(over.normal) < FACING;
        (towards && over.gap < REACH + LYING + bend).then_some((index as u32, over))
    };
    poses.iter().enumerate().filter_map(facing).collect()
}

/// Bends a limp piece down: each station's patches come as much nearer as the station does.
fn settle(facing: &mut [(u32, OverPan)], limp: &Limp, patches: &[Patch]) {
    let station = |patch: u32| limp.station(patches[patch as usize].node);
    let mut gaps = vec![f64::INFINITY; limp.stations()];
    for (patch, over) in facing.iter() {
        let gap = &mut gaps[station(*patch)];
        *gap = gap.min(over.gap);
    }
    let settled = limp.settled(gaps.clone());
    for (patch, over) in facing {
        let at = station(*patch);
        over.gap -= gaps[at] - settled[at];
    }
}

/// How uneven a piece's surface is at each patch [m]: seeded noise of a wavelength, each face of mean 0 and of the given
/// standard deviation.
pub fn unevenness(model: &FoodModel, seed: u64, wavelength: f64, deviation: f64) -> Vec<f64> {
    use saute_food::Face;
    use saute_food::noise::fractal;
    let noise = |patch: &saute_food::Patch| {
        let [x, y, z] = model.mesh().position(patch.node as usize);
        let third = match (model.mesh().is_slice(), patch.face) {
            (true, Face::Bottom) => 0.0,
            (true, Face::Top) => 31.0,
            _ => 57.0 + z / wavelength,
        };
        fractal(seed ^ 0xc0_47ac, [x / wavelength, y / wavelength, third])
    };
    let mut uneven: Vec<f64> = model.patches().iter().map(noise).collect();
    for face in [Face::Bottom, Face::Top, Face::Side] {
        let of_face: Vec<usize> = (0..uneven.len()).filter(|&i| model.patches()[i].face == face).collect();
        let count = of_face.len().max(1) as f64;
        let mean = of_face.iter().map(|&i| uneven[i]).sum::<f64>() / count;
        let square = of_face.iter().map(|&i| (uneven[i] - mean) * (uneven[i] - mean)).sum::<f64>() / count;
        let scale = deviation / libm::sqrt(square).max(1e-9);
        of_face.iter().for_each(|&i| uneven[i] = (uneven[i] - mean) * scale);
    }
    uneven
}

#[cfg(test)]
mod tests {
    use crate::{Command, Kitchen, Library, MeshSize, PieceOrder, kelvin};

    /// Share of its stations with which a piece is near to the pan, ten seconds after it was put there.
    fn share_that_lies(kind: &str) -> f64 {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(23.0)).expect("kitchen");
        let food = &library.foods[kind];
        let order = PieceOrder {
            id: "s".into(),
            kind: kind.into(),
            size: food.form.extent(&food.size.default_mm).expect("a size").map(|mm| 1e-3 * mm),
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 1.0,
            rules: saute_food::Rules::Full,
            mesh: MeshSize::Default,
        };
        kitchen.add(&library, &order).expect("is built");
        kitchen.apply(&Command::Put { food: "s".into(), at: [0.0, 0.0], heap: false }).expect("is put in");
        while kitchen.time_s() < 10.0 {
            kitchen.step();
        }
        let piece = &kitchen.pieces()[0];
        let limp = piece.model.limp(&piece.state).expect("lies along stations");
        let near = piece.near.patches.iter().filter(|near| near.gap == 0.0);
        let stations: std::collections::BTreeSet<usize> =
            near.map(|near| limp.station(piece.model.patches()[near.patch as usize].node)).collect();
        stations.len() as f64 / limp.stations() as f64
    }

    #[test]
    fn a_raw_shrimp_lies_with_nearly_all_its_length() {
        let share = share_that_lies("shrimp");
        assert!(share > 0.8, "{share}");
    }
}
