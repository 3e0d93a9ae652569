//! The quiet corner around the stove: counter, wall, board, cloth, turner, oil bottle.

use glam::{Mat4, Vec2, Vec3};

use crate::mesh::solid::{Finish, Material, Mesh, Station, bezier, with_normals};

/// Height of the counter under the glass of the hob [m].
pub const COUNTER_Z: f32 = -0.006;
/// Centre of the wooden board's top surface [m].
pub const BOARD_CENTRE: Vec3 = Vec3::new(0.335, 0.03, 0.016);
/// Size of the wooden board [m].
pub const BOARD_SIZE: Vec3 = Vec3::new(0.26, 0.36, 0.022);
/// Thickness of the folded cloth with a pan on it [m].
pub const CLOTH_THICKNESS: f32 = 0.008;
/// A good place for the pan (centre of its underside) when it stands on the cloth next to the hob [m].
pub const CLOTH_PLACE: Vec3 = Vec3::new(-0.345, -0.02, COUNTER_Z + CLOTH_THICKNESS);

const CLOTH_SIZE: Vec2 = Vec2::new(0.215, 0.235);
/// Counter and wall: below and behind everything; casts no shadow, because the window is in the wall.
///
/// The counter has a hole for a stove that is let into it.
pub(crate) fn room(hole: Option<[Vec2; 2]>) -> Mesh {
    let mut mesh = Mesh::default();
    counter(&mut mesh, hole);
    wall(&mut mesh);
    mesh
}

/// Everything else that never moves.
pub(crate) fn surroundings() -> Mesh {
    let mut mesh = Mesh::default();
    bottle(&mut mesh, Vec3::new(-0.205, 0.275, COUNTER_Z));
    mesh
}

/// A cloth folded once, with its centre at the origin on the counter.
pub(crate) fn cloth() -> Mesh {
    let mut mesh = Mesh::default();
    let finish =
        Finish { colour: Vec3::new(0.30, 0.36, 0.38), roughness: 0.95, metalness: 0.0, material: Material::Cloth };
    for (layer, turn) in [(0.0, 0.05_f32), (1.0, 0.02)] {
        let first = mesh.vertices.len();
        cloth_layer(&mut mesh, 0.5 * CLOTH_THICKNESS * (layer + 1.0), &finish);
        mesh.transform_from(first, Mat4::from_rotation_z(turn));
    }
    mesh
}

/// A soft sheet whose edge droops to the layer below.
fn cloth_layer(mesh: &mut Mesh, top: f32, finish: &Finish) {
    const CELLS: u32 = 40;
    let droop = 0.5 * CLOTH_THICKNESS;
    let height = |u: Vec2| {
        let edge = (1.0 - u.abs().max_element()).clamp(0.0, 0.06) / 0.06;
        let wave = (u.x * 9.0 + u.y * 2.0).sin() * (u.y * 5.0 - u.x).cos();
        top - droop * (1.0 - edge) * (1.0 - edge) + 0.0003 * wave * edge
    };
    let at = |u: Vec2| {
        let ragged = 1.0 + 0.008 * (u.y * 6.0).sin() * (u.x * 7.0).cos();
        let xy = u * CLOTH_SIZE * 0.5 * ragged;
        xy.extend(height(u))
    };
    mesh.grid(CELLS, CELLS, finish, |i, j| {
        let u = Vec2::new(i as f32, j as f32) / CELLS as f32 * 2.0 - 1.0;
        let step = 0.02;
        let across = at(u + Vec2::X * step) - at(u - Vec2::X * step);
        let along = at(u + Vec2::Y * step) - at(u - Vec2::Y * step);
        (at(u), across.cross(along).normalize(), 1.0)
    });
}

fn counter(mesh: &mut Mesh, hole: Option<[Vec2; 2]>) {
    let stone =
        Finish { colour: Vec3::new(0.225, 0.222, 0.216), roughness: 0.42, metalness: 0.0, material: Material::Counter };
    let Some([low, high]) = hole else {
        mesh.grid(8, 8, &stone, |i, j| {
            let at = Vec3::new(i as f32 * 0.5 - 2.0, j as f32 * 0.325 - 2.0, COUNTER_Z);
            (at, Vec3::Z, 1.0)
        });
        return;
    };
    let first = mesh.indices.len();
    let lines = [[-2.0, low.x, high.x, 2.0], [-2.0, low.y, high.y, 0.6]];
    mesh.grid(3, 3, &stone, |i, j| (Vec3::new(lines[0][i as usize], lines[1][j as usize], COUNTER_Z), Vec3::Z, 1.0));
    // The middle one of nine fields is open.
    mesh.indices.drain(first + 4 * 6..first + 5 * 6);
}

fn wall(mesh: &mut Mesh) {
    let plaster =
        Finish { colour: Vec3::new(0.50, 0.52, 0.53), roughness: 0.9, metalness: 0.0, material: Material::Plain };
    // The window is in this wall, so it is lit only by the room: its normal leans towards the ceiling.
    let lit_from = Vec3::new(0.3, -0.75, 0.59);
    mesh.grid(1, 12, &plaster, |i, j| {
        let height = j as f32 / 12.0;
        let at = Vec3::new(i as f32 * 4.0 - 2.0, 0.6, COUNTER_Z + height * 3.0);
        // Darkens towards the counter, where less of the room is seen.
        (at, lit_from, 0.45 + 0.55 * height.sqrt())
    });
}

/// The wooden board.
pub(crate) fn board() -> Mesh {
    let mut mesh = Mesh::default();
    let wood =
        Finish { colour: Vec3::new(0.300, 0.175, 0.085), roughness: 0.60, metalness: 0.0, material: Material::Wood };
    mesh.slab(BOARD_CENTRE - Vec3::Z * BOARD_SIZE.z, BOARD_SIZE, 0.018, 0.003, &wood);
    mesh
}

fn bottle(mesh: &mut Mesh, base: Vec3) {
    let oil =
        Finish { colour: Vec3::new(0.19, 0.125, 0.016), roughness: 0.06, metalness: 0.0, material: Material::Plain };
    let cork = Finish { colour: Vec3::new(0.030, 0.028, 0.026), roughness: 0.5, ..oil };
    // Profiles run downwards, so that the outside is on their left.
    let body = [
        (0.0, 0.150),
        (0.0110, 0.150),
        (0.0110, 0.128),
        (0.0130, 0.120),
        (0.0240, 0.108),
        (0.0290, 0.096),
        (0.0295, 0.084),
        (0.0295, 0.006),
        (0.0285, 0.001),
        (0.0265, 0.0),
    ];
    let cap = [(0.0, 0.172), (0.0110, 0.172), (0.0122, 0.170), (0.0122, 0.151), (0.0112, 0.1495)];
    for (profile, finish) in [(&body[..], &oil), (&cap[..], &cork)] {
        let first = mesh.vertices.len();
        let points: Vec<Vec2> = profile.iter().map(|&(r, z)| Vec2::new(r, z)).collect();
        mesh.lathe(&with_normals(&points), 32, finish);
        mesh.transform_from(first, Mat4::from_translation(base));
    }
}

/// A slotted steel turner that is behind the hob.
pub(crate) fn turner() -> Mesh {
    let mut mesh = Mesh::default();
    let steel = Finish { colour: Vec3::splat(0.52), roughness: 0.34, metalness: 1.0, material: Material::Plain };
    let grip =
        Finish { colour: Vec3::new(0.10, 0.055, 0.030), roughness: 0.5, metalness: 0.0, material: Material::Plain };
    let spine = [Vec2::new(-0.13, 0.016), Vec2::new(-0.03, 0.016), Vec2::new(0.03, 0.010), Vec2::new(0.075, 0.004)];
    let shaft: Vec<Vec2> = bezier(spine, 10).collect();
    mesh.sweep(&bar(&shaft, |_| Vec2::new(0.0045, 0.0012)), &steel);
    let blade = [Vec2::new(0.07, 0.004), Vec2::new(0.09, 0.0025), Vec2::new(0.165, 0.0010)];
    mesh.sweep(
        &bar(&blade, |t| Vec2::new(0.028 + 0.010 * t, 0.0006)),
        // Its rolled edge is thinner than a pixel: what it mirrors must be even.
        &Finish { roughness: 0.6, ..steel },
    );
    let handle: Vec<Vec2> = (0..=8).map(|i| Vec2::new(-0.24 + 0.0145 * i as f32, 0.016)).collect();
    mesh.sweep(
        &bar(&handle, |t| Vec2::new(0.0105 - 0.003 * t, 0.008) * (4.0 * t * (1.0 - t)).powf(0.18).max(0.05)),
        &grip,
    );
    let pose = Mat4::from_translation(Vec3::new(0.05, 0.265, COUNTER_Z)) * Mat4::from_rotation_z(-0.10);
    mesh.transform_from(0, pose);
    mesh
}

/// Stations of a bar along +x in the xz-plane; `section` gives half width and half thickness by fraction of length.
fn bar(path: &[Vec2], section: impl Fn(f32) -> Vec2) -> Vec<Station> {
    (0..path.len())
        .map(|i| {
            let along = path[(i + 1).min(path.len() - 1)] - path[i.saturating_sub(1)];
            let forward = Vec3::new(along.x, 0.0, along.y).normalize();
            let half = section(i as f32 / (path.len() - 1) as f32);
            Station { centre: Vec3::new(path[i].x, 0.0, path[i].y), side: Vec3::Y, up: forward.cross(Vec3::Y), half }
        })
        .collect()
}
