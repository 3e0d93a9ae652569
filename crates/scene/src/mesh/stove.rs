//! The stoves: induction hob, gas burner with grate and flame, radiant glass-ceramic, iron plate. A pan is at z = 0.

use std::f32::consts::TAU;

use glam::{Mat4, Vec2, Vec3};

use crate::input::StoveKind;
use crate::mesh::props::COUNTER_Z;
use crate::mesh::solid::{Finish, Material, Mesh, Station, with_normals};

/// Glass of a hob, and the well of a burner: centre and size [m] (a single portable hob).
const HOB_CENTRE: Vec2 = Vec2::new(0.0, -0.022);
const HOB_SIZE: Vec2 = Vec2::new(0.36, 0.43);
/// Bottom of a burner's well [m].
const WELL_Z: f32 = -0.044;
/// Ring of a burner's ports: radius and height [m].
const PORTS: [f32; 2] = [0.043, -0.027];
/// Flames on that ring [-] (chosen: as on a household burner).
const FLAMES: u32 = 36;
/// Length of the smallest and of the largest flame [m] (chosen).
const FLAME_LENGTH: [f32; 2] = [0.012, 0.052];
/// Highest middle of a flame, which spreads below the pan from there [m]: half its width is above.
const FLAME_TOP: f32 = -0.0046;
/// Top of the enamelled sheet round an iron plate, and radius of the plate [m].
const SHEET_Z: f32 = -0.0035;
const PLATE_RADIUS: f32 = 0.090;

const IRON: Finish =
    Finish { colour: Vec3::new(0.030, 0.029, 0.028), roughness: 0.62, metalness: 0.3, material: Material::Plain };
const STEEL: Finish =
    Finish { colour: Vec3::new(0.42, 0.42, 0.43), roughness: 0.32, metalness: 0.9, material: Material::Plain };

/// The stove that stands on the counter or is let into it.
pub(crate) fn stove(kind: StoveKind) -> Mesh {
    match kind {
        StoveKind::Induction => glass_hob(Material::Glass),
        StoveKind::Radiant => glass_hob(Material::Zone),
        StoveKind::Gas => burner(),
        StoveKind::Plate => plate(),
    }
}

/// Hole in the counter for a stove that is let into it: its lowest and highest corner [m].
pub(crate) fn hole(kind: StoveKind) -> Option<[Vec2; 2]> {
    (kind == StoveKind::Gas).then(|| [HOB_CENTRE - 0.5 * HOB_SIZE, HOB_CENTRE + 0.5 * HOB_SIZE])
}

/// The glass of a hob and its metal frame.
fn glass_hob(material: Material) -> Mesh {
    let mut mesh = Mesh::default();
    let frame = Finish { colour: Vec3::splat(0.035), roughness: 0.5, metalness: 0.6, material: Material::Plain };
    let base = HOB_CENTRE.extend(COUNTER_Z);
    mesh.slab(base, (HOB_SIZE + 0.006).extend(-COUNTER_Z - 0.0012), 0.014, 0.001, &frame);
    let glass = Finish { colour: Vec3::new(0.0065, 0.0066, 0.0072), roughness: 0.06, metalness: 0.0, material };
    mesh.slab(base, HOB_SIZE.extend(-COUNTER_Z), 0.012, 0.0012, &glass);
    mesh
}

/// A well of enamelled steel with a burner in it and a grate over it.
fn burner() -> Mesh {
    let mut mesh = Mesh::default();
    well(&mut mesh);
    let head: Vec<Vec2> = [
        (0.052, WELL_Z),
        (0.048, -0.036),
        (0.043, -0.032),
        (0.043, -0.0265),
        (0.045, -0.0250),
        (0.043, -0.0215),
        (0.030, -0.0195),
        (0.0005, -0.0190),
    ]
    .map(|(r, z)| Vec2::new(r, z))
    .into();
    let mut profile = with_normals(&head);
    profile.iter_mut().for_each(|point| point.normal = -point.normal);
    mesh.lathe(&profile, 48, &IRON);
    for finger in 0..6 {
        let first = mesh.vertices.len();
        mesh.sweep(&finger_stations(), &IRON);
        mesh.transform_from(first, Mat4::from_rotation_z(TAU * (finger as f32 + 0.5) / 6.0));
    }
    mesh.sweep(&ring_stations(0.137, -0.0085), &IRON);
    mesh
}

/// Bottom, sides and steel edge of the well.
fn well(mesh: &mut Mesh) {
    let enamel =
        Finish { colour: Vec3::new(0.05, 0.051, 0.054), roughness: 0.22, metalness: 0.0, material: Material::Plain };
    let half = 0.5 * HOB_SIZE;
    let corner = |x: f32, y: f32, z: f32| (HOB_CENTRE + half * Vec2::new(x, y)).extend(z);
    mesh.grid(8, 8, &enamel, |i, j| {
        let at = Vec2::new(i as f32, j as f32) / 4.0 - 1.0;
        (corner(at.x, at.y, WELL_Z), Vec3::Z, 0.75 - 0.25 * at.abs().max_element())
    });
    for side in 0..4 {
        let turn = Vec2::from_angle(TAU * side as f32 / 4.0).round();
        mesh.grid(8, 2, &enamel, |i, j| {
            let along = i as f32 / 4.0 - 1.0;
            let at = turn + turn.perp() * along;
            let up = j as f32 / 2.0;
            (corner(at.x, at.y, WELL_Z + (COUNTER_Z - WELL_Z) * up), (-turn).extend(0.0), 0.45 + 0.4 * up)
        });
        let out = turn * half;
        let size = Vec2::new(0.009, 0.009) + 2.0 * half * turn.perp().abs();
        mesh.slab((HOB_CENTRE + out).extend(COUNTER_Z), size.extend(0.002), 0.002, 0.0006, &STEEL);
    }
}

/// A finger of the grate along +x: from the middle outwards, then down to the bottom of the well.
fn finger_stations() -> Vec<Station> {
    let path = [
        (0.026, -0.0045),
        (0.030, -0.0040),
        (0.080, -0.0040),
        (0.140, -0.0040),
        (0.150, -0.0080),
        (0.153, -0.0200),
        (0.154, WELL_Z),
    ]
    .map(|(x, z)| Vec2::new(x, z));
    let along = |i: usize| (path[(i + 1).min(path.len() - 1)] - path[i.saturating_sub(1)]).normalize();
    let station = |i: usize| {
        let forward = Vec3::new(along(i).x, 0.0, along(i).y);
        let half = Vec2::new(0.0035, if i == 0 { 0.002 } else { 0.004 });
        Station { centre: Vec3::new(path[i].x, 0.0, path[i].y), side: Vec3::Y, up: forward.cross(Vec3::Y), half }
    };
    (0..path.len()).map(station).collect()
}

/// A closed bar round the middle.
fn ring_stations(radius: f32, z: f32) -> Vec<Station> {
    let station = |i: u32| {
        let out = Vec2::from_angle(TAU * i as f32 / 48.0);
        let half = Vec2::new(0.003, 0.0035);
        Station { centre: (out * radius).extend(z), side: out.extend(0.0), up: Vec3::Z, half }
    };
    (0..=48).map(station).collect()
}

/// The flames of a burner at a share of its power: a cone from each port, which leans outwards and then up along the pan.
///
/// The place along a flame, 0 at the port to 1 at the tip, is in place of the roughness.
pub(crate) fn flames(power: f32) -> Mesh {
    let mut mesh = Mesh::default();
    if power <= 0.0 {
        return mesh;
    }
    let length = FLAME_LENGTH[0] + (FLAME_LENGTH[1] - FLAME_LENGTH[0]) * power.sqrt();
    for flame in 0..FLAMES {
        let first = mesh.vertices.len();
        // Every flame burns a little otherwise: by the golden ratio, for no two neighbours are alike.
        let own = 0.85 + 0.3 * (flame as f32 * 0.618_034).fract();
        cone(&mut mesh, length * own);
        mesh.transform_from(first, Mat4::from_rotation_z(TAU * flame as f32 / FLAMES as f32));
    }
    mesh
}

/// One flame along +x.
fn cone(mesh: &mut Mesh, length: f32) {
    const SIDES: u32 = 12;
    const ROWS: u32 = 8;
    let at = |t: f32| {
        let height = PORTS[1] + 0.25 * length * t.min(0.4) + 0.55 * length * t * t;
        Vec3::new(PORTS[0] + 0.85 * length * t, 0.0, height.min(FLAME_TOP))
    };
    let first = mesh.vertices.len();
    let finish = Finish { colour: Vec3::ONE, roughness: 0.0, metalness: 0.0, material: Material::Plain };
    mesh.grid(SIDES, ROWS, &finish, |i, j| {
        let t = j as f32 / ROWS as f32;
        let (sin, cos) = (TAU * i as f32 / SIDES as f32).sin_cos();
        let wide = (0.0011 + 0.0030 * (TAU * 0.5 * t.powf(0.6)).sin()) * (1.0 - 0.6 * t * t);
        let out = Vec3::new(0.0, cos, sin);
        (at(t) + out * wide, out, 1.0)
    });
    for (k, vertex) in mesh.vertices[first..].iter_mut().enumerate() {
        vertex.surface[0] = (k as u32 / (SIDES + 1)) as f32 / ROWS as f32;
    }
}

/// An iron plate in an enamelled sheet, with a steel ring round it and the red mark of a fast plate.
fn plate() -> Mesh {
    let mut mesh = Mesh::default();
    let enamel =
        Finish { colour: Vec3::new(0.52, 0.515, 0.50), roughness: 0.25, metalness: 0.0, material: Material::Plain };
    let base = HOB_CENTRE.extend(COUNTER_Z);
    mesh.slab(base, HOB_SIZE.extend(SHEET_Z - COUNTER_Z), 0.016, 0.0015, &enamel);
    turned(
        &mut mesh,
        &[(0.0965, SHEET_Z), (0.0958, -0.0018), (0.0925, -0.0012), (PLATE_RADIUS + 0.0006, -0.0016)],
        &STEEL,
    );
    let top = [
        (PLATE_RADIUS, -0.0022),
        (PLATE_RADIUS - 0.0008, -0.0002),
        (0.070, 0.0),
        (0.034, 0.0),
        (0.031, -0.0008),
        (0.0005, -0.0008),
    ];
    turned(&mut mesh, &top, &IRON);
    let mark =
        Finish { colour: Vec3::new(0.35, 0.02, 0.015), roughness: 0.5, metalness: 0.0, material: Material::Plain };
    turned(&mut mesh, &[(0.016, -0.00078), (0.0155, -0.0006), (0.0005, -0.0006)], &mark);
    mesh
}

/// A profile from the outside inwards, turned about the middle.
fn turned(mesh: &mut Mesh, profile: &[(f32, f32)], finish: &Finish) {
    let points: Vec<Vec2> = profile.iter().map(|(r, z)| Vec2::new(*r, *z)).collect();
    let mut profile = with_normals(&points);
    profile.iter_mut().for_each(|point| point.normal = -point.normal);
    mesh.lathe(&profile, 72, finish);
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [StoveKind; 4] = [StoveKind::Induction, StoveKind::Gas, StoveKind::Radiant, StoveKind::Plate];

    #[test]
    fn a_pan_stands_on_every_stove_at_zero_height() {
        for kind in KINDS {
            let mesh = stove(kind);
            let top = mesh.vertices.iter().map(|v| v.position[2]).fold(f32::MIN, f32::max);
            assert!(top.abs() < 1e-4, "{kind:?}: {top}");
            let last = mesh.vertices.len() as u32;
            assert!(
                mesh.indices.iter().all(|i| *i < last)
                    && mesh.vertices.iter().all(|v| v.position.iter().all(|x| x.is_finite()))
            );
        }
    }

    #[test]
    fn flames_grow_with_the_power_and_stay_below_the_pan() {
        let reach = |power: f32| flames(power).vertices.iter().map(|v| v.position[0]).fold(0.0, f32::max);
        assert!(flames(0.0).vertices.is_empty());
        assert!(reach(0.1) < reach(0.5) && reach(0.5) < reach(1.0) && reach(1.0) < 0.11, "{}", reach(1.0));
        let top = flames(1.0).vertices.iter().map(|v| v.position[2]).fold(f32::MIN, f32::max);
        assert!(top < 0.0, "{top}");
    }
}
