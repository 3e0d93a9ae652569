//! The glass lid: a shallow dome with a steel band and a knob.

use glam::Vec2;
use glam::Vec3;

use crate::input::PanLook;
use crate::mesh::solid::{Finish, Material, Mesh, with_normals};

/// Height of the dome above the rim of the pan [m] (chosen: a common glass lid).
const RISE: f32 = 0.032;
/// Half the width of the band [m] (chosen).
const BAND: f32 = 0.0035;
const SEGMENTS: u32 = 72;

/// Glass and steel of a lid in the pan's frame.
pub(crate) fn lid_mesh(pan: &PanLook) -> [Mesh; 2] {
    let (radius, rim) = (pan.rim_radius - 0.001, pan.thickness + pan.rim_height);
    let glass = Finish { colour: Vec3::splat(0.9), roughness: 0.05, metalness: 0.0, material: Material::Glass };
    let steel = Finish { colour: Vec3::splat(0.55), roughness: 0.30, metalness: 0.8, material: Material::Plain };
    let knob = Finish { colour: Vec3::splat(0.012), roughness: 0.35, metalness: 0.0, material: Material::Plain };
    // Profiles run from the top outwards, so that the outside is on their left.
    let dome = (0..=16).map(|i| {
        let out = i as f32 / 16.0;
        Vec2::new(radius * out, rim + 0.004 + RISE * (1.0 - out * out))
    });
    let band = [(-BAND, 0.0055), (BAND * 0.4, 0.0055), (BAND, 0.0035), (BAND, 0.0), (0.0, -0.001)];
    let handle = [(0.0, 0.026), (0.011, 0.026), (0.015, 0.022), (0.015, 0.017), (0.010, 0.010), (0.008, 0.0)];
    let mut parts = [Mesh::default(), Mesh::default()];
    parts[0].lathe(&with_normals(&dome.collect::<Vec<_>>()), SEGMENTS, &glass);
    let band: Vec<Vec2> = band.iter().map(|&(out, up)| Vec2::new(radius + out, rim + up)).collect();
    parts[1].lathe(&with_normals(&band), SEGMENTS, &steel);
    let handle: Vec<Vec2> = handle.iter().map(|&(out, up)| Vec2::new(out, rim + 0.004 + RISE + up)).collect();
    parts[1].lathe(&with_normals(&handle), 28, &knob);
    parts
}
