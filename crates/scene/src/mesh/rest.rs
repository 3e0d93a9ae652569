//! What food rests on or under: a wire rack, a tent of foil, the plate on which it is served.

use std::f32::consts::PI;

use glam::{Vec2, Vec3};

use crate::input::{PLATE_HEIGHT, RACK_HEIGHT, RestKind, RestLook};
use crate::mesh::solid::{Finish, Material, Mesh, ProfilePoint};

/// Thickness of a wire [m] and distance between wires [m] (chosen: a cooling rack).
const WIRE: f32 = 0.0024;
const WIRE_GAP: f32 = 0.013;
/// How far rack and foil reach beyond the food [m] (chosen).
const MARGIN: f32 = 0.014;
/// Room between food and foil [m] (chosen: a loose tent).
const LOOSE: f32 = 0.016;

/// Adds a wire rack or a tent of foil.
pub(crate) fn rest_mesh(mesh: &mut Mesh, rest: &RestLook) {
    match rest.kind {
        RestKind::Rack => rack(mesh, rest),
        RestKind::Foil => foil(mesh, rest),
        RestKind::Plate => plate(mesh, rest.centre),
    }
}

/// Radius [m] and height [m] of a plate along its profile, from the middle over the well and the lip to the foot below (chosen: a
/// dinner plate of 25 cm with a flat well of 17 cm).
const PLATE: [[f32; 2]; 12] = [
    [0.000, PLATE_HEIGHT],
    [0.078, PLATE_HEIGHT],
    [0.085, 0.0067],
    [0.090, 0.0088],
    [0.094, 0.0120],
    [0.098, 0.0139],
    [0.121, 0.0178],
    [0.1250, 0.0182],
    [0.1262, 0.0170],
    [0.1246, 0.0155],
    [0.098, 0.0095],
    [0.070, 0.0],
];
const PLATE_AROUND: u32 = 96;

/// A porcelain plate.
fn plate(mesh: &mut Mesh, centre: Vec3) {
    let glaze =
        Finish { colour: Vec3::new(0.66, 0.65, 0.625), roughness: 0.22, metalness: 0.0, material: Material::Plain };
    let at = |k: usize| Vec2::from(PLATE[k.min(PLATE.len() - 1)]);
    let profile: Vec<ProfilePoint> = (0..PLATE.len())
        .map(|k| {
            let along = at(k + 1) - at(k.saturating_sub(1));
            // Below its lip the plate is in its own shade.
            let visibility = if k > 8 { 0.5 } else { 1.0 };
            ProfilePoint { at: at(k), normal: along.perp().normalize_or(Vec2::Y), visibility }
        })
        .collect();
    let first = mesh.vertices.len();
    mesh.lathe(&profile, PLATE_AROUND, &glaze);
    mesh.vertices[first..].iter_mut().for_each(|v| v.position = (Vec3::from(v.position) + centre).into());
}

fn rack(mesh: &mut Mesh, rest: &RestLook) {
    let steel = Finish { colour: Vec3::splat(0.60), roughness: 0.28, metalness: 1.0, material: Material::Plain };
    let half = rest.half + MARGIN;
    let mut wire = |centre: Vec2, along: Vec2, lift: f32| {
        let base = rest.centre + centre.extend(RACK_HEIGHT - WIRE - lift);
        mesh.slab(base, along.max(Vec2::splat(WIRE)).extend(WIRE), 0.45 * WIRE, 0.35 * WIRE, &steel);
    };
    let count = (2.0 * half.x / WIRE_GAP).ceil().max(2.0) as u32;
    for i in 0..=count {
        let x = half.x * (2.0 * i as f32 / count as f32 - 1.0);
        wire(Vec2::new(x, 0.0), Vec2::new(0.0, 2.0 * half.y), 0.0);
    }
    for y in [-0.8, 0.8] {
        wire(Vec2::new(0.0, y * half.y), Vec2::new(2.0 * half.x, 0.0), WIRE);
    }
    let foot = Vec3::new(2.0 * WIRE, 2.0 * WIRE, RACK_HEIGHT - WIRE);
    for corner in [Vec2::new(-1.0, -1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, 1.0), Vec2::new(1.0, 1.0)] {
        mesh.slab(rest.centre + (corner * half * 0.96).extend(0.0), foot, 0.9 * WIRE, 0.3 * WIRE, &steel);
    }
}

/// An arch of crumpled sheet over the back of the food; it is seen from outside and inside alike.
fn foil(mesh: &mut Mesh, rest: &RestLook) {
    const AROUND: u32 = 36;
    const ALONG: u32 = 40;
    let aluminium = Finish { colour: Vec3::splat(0.80), roughness: 0.42, metalness: 1.0, material: Material::Plain };
    let half = rest.half + MARGIN;
    let rise = rest.height + LOOSE;
    let at = |u: f32, v: f32| {
        let (sine, cosine) = (PI * u).sin_cos();
        let fold = (17.0 * u + 5.0 * (7.0 * v).sin()).sin() * (13.0 * v - 4.0 * (9.0 * u).sin()).sin();
        let crease = (41.0 * u - 23.0 * v).sin() * (29.0 * u + 37.0 * v).cos();
        let crumple = 1.0 + 0.016 * fold + 0.007 * crease;
        let across = -half.x * cosine * crumple;
        // The front third is open, so that the food is seen.
        let y = half.y * (-0.30 + 1.36 * v);
        rest.centre + Vec3::new(across, y, rise * sine.powf(0.72) * crumple)
    };
    for side in [1.0f32, -1.0] {
        mesh.grid(AROUND, ALONG, &aluminium, |i, j| {
            let u = if side > 0.0 { i as f32 } else { (AROUND - i) as f32 } / AROUND as f32;
            let v = j as f32 / ALONG as f32;
            let step = 0.01;
            let normal = (at(u + step, v) - at(u - step, v)).cross(at(u, v + step) - at(u, v - step));
            let outward = if normal.dot(at(u, v) - rest.centre) < 0.0 { -normal } else { normal };
            (at(u, v) - outward.normalize() * (0.5 - 0.5 * side) * 0.0004, outward.normalize() * side, 0.85)
        });
    }
}
