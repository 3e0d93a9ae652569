//! Contact detection between a piece and the pan: patches near the pan, their gaps and their places on its mesh.

use glam::DVec3;
use saute_food::body::limp::Limp;
use saute_food::{FoodModel, Patch, PatchPose, Rules};
use saute_heat::Located;
use serde::{Deserialize, Serialize};

use crate::data::room::Room;
use crate::dynamics::pan_shape::OverPan;
use crate::dynamics::{PanShape, Pose};
use crate::pan::pan_model::PanModel;

/// Largest gap of a patch in contact with the pan [m] (chosen: 3 mm of vapour conduct as much as free convection).
const REACH: f64 = 3.0e-3;
/// Largest distance of the nearest patch at which a piece lies on the pan [m] (chosen: deviation of the collision shape
/// from the surface plus compliance of rigid contacts).
const LYING: f64 = 1.0e-3;
/// Largest cosine between the normals of a patch and of the surface it faces [-] (chosen: 60°).
const FACING: f64 = -0.5;
/// Compliance: gap beyond that of the lowest tenth that closes under the weight [m] (chosen: a 25 mm slab of 10–20 kPa
/// yields by 0.3 mm under its own weight, and the lowest tenth of a hand-cut face is 0.2 mm below its mean).
const GIVE: f64 = 0.6e-3;
/// The same by the rules of 2013, beyond the face's mean [m].
const GIVE_2013: f64 = 0.3e-3;
/// Share of the face that carries it: its mean gap is that below the mean gap of the face [-] (chosen: soft food rests on
/// its lowest tenth).
const CARRIES: f64 = 0.1;
/// By the rules of 2013: largest gap beyond the nearest patch's within the supporting face [m].
const FACE_2013: f64 = 1.0e-3;
/// Largest deflection of a limp piece [m] (chosen: half a shrimp's thickness; a higher part is propped up).
const BEND: f64 = 8.0e-3;
/// Displacement below which the last result is reused [m] (chosen: far below the mesh of pan and piece).
const SAME: f64 = 0.1e-3;

/// A patch that faces the pan.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct NearPatch {
    /// Index of the patch.
    pub patch: u32,
    /// Gap beyond the mean of the supporting face and the food's compliance [m].
    pub gap: f64,
    /// Place on the pan's mesh.
    pub located: Located,
}

/// All patches of a piece that face the pan.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct NearPan {
    /// The patches, in their order.
    pub patches: Vec<NearPatch>,
    seen: Option<(Pose, u64)>,
}

/// Present shape of a piece.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// Its patches and their poses.
    pub patches: (&'a [Patch], &'a [PatchPose]),
    /// Bending under its weight, for long pieces.
    pub limp: Option<&'a Limp>,
    /// Number of changes of its shape [-].
    pub count: u64,
    /// Rules that it follows.
    pub rules: Rules,
}

impl NearPan {
    /// Updates the patches, unless pose and shape are unchanged.
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
        let closes = match shape.rules {
            Rules::Paper2013 => lies_2013(&facing, nearest) + GIVE_2013,
            Rules::Full => lies(&facing, nearest) + GIVE,
        };
        let near = |(patch, over): (u32, OverPan)| {
            let gap = (over.gap - closes).max(0.0);
            let located = pan.locator.locate_or_nearest(&pan.section, over.on_mesh);
            (gap < REACH).then_some(NearPatch { patch, gap, located })
        };
        self.patches.extend(facing.into_iter().filter_map(near));
    }

    /// Clears the result.
    pub fn forget(&mut self) {
        self.seen = None;
        self.patches.clear();
    }
}

/// Gap at which a face lies: that of its lowest tenth [m].
fn lies(facing: &[(u32, OverPan)], nearest: f64) -> f64 {
    let mut gaps: Vec<f64> = facing.iter().map(|(_, over)| over.gap).collect();
    gaps.sort_by(f64::total_cmp);
    let count = libm::ceil(CARRIES * gaps.len() as f64) as usize;
    if count == 0 { nearest } else { gaps[..count].iter().sum::<f64>() / count as f64 }
}

/// Gap at which a face lies by the rules of 2013: the mean of its supporting part [m].
fn lies_2013(facing: &[(u32, OverPan)], nearest: f64) -> f64 {
    let face = facing.iter().map(|(_, over)| over.gap).filter(|gap| *gap < nearest + FACE_2013);
    let (sum, count) = face.fold((0.0, 0.0), |(sum, count), gap| (sum + gap, count + 1.0));
    if count > 0.0 { sum / count } else { nearest }
}

/// Patches that face the surface within reach plus the largest bend [m].
fn facing(surface: &PanShape, piece: &Pose, poses: &[PatchPose], bend: f64) -> Vec<(u32, OverPan)> {
    let facing = |(index, patch): (usize, &PatchPose)| {
        let over = surface.over(piece.to_world(DVec3::from_array(patch.position)))?;
        let towards = (piece.rotation * DVec3::from_array(patch.normal)).dot(over.normal) < FACING;
        (towards && over.gap < REACH + LYING + bend).then_some((index as u32, over))
    };
    poses.iter().enumerate().filter_map(facing).collect()
}

/// Bends a limp piece down: the gaps of a station's patches shrink by the station's deflection.
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

/// Returns the unevenness of the faces of a piece in a room [m].
pub(crate) fn uneven_of(model: &FoodModel, seed: u64, room: &Room) -> Vec<f64> {
    let gap = &room.contact;
    unevenness(model, seed, 1e-3 * gap.unevenness_scale_mm, 1e-3 * gap.unevenness_mm)
}

/// Unevenness of a piece's surface at each patch [m]: seeded noise of a wavelength, with mean 0 and the given standard
/// deviation on each face.
pub fn unevenness(model: &FoodModel, seed: u64, wavelength: f64, deviation: f64) -> Vec<f64> {
    use saute_food::Face;
    use saute_food::tissue::noise::fractal;
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
    use crate::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};

    /// Share of a piece's stations in contact with the pan, ten seconds after it was put there.
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
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &order).expect("is built");
        kitchen.apply(&Command::Put { food: "s".into(), at: [0.0, 0.0], heap: false }).expect("is put in");
        while kitchen.time_s() < 10.0 {
            kitchen.step();
        }
        let piece = &kitchen.pieces()[0];
        let limp = piece.model.limp(&piece.state).expect("lies along stations");
        let near = piece.near_patches().iter().filter(|near| near.gap == 0.0);
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
