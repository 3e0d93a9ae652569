//! The tools in the cook's hand: a turner, tongs.

use glam::{Mat4, Vec2, Vec3};

use crate::input::{ToolKind, ToolLook};
use crate::mesh::solid::{Finish, Material, Mesh, Station};

/// Half length of the blade [m] (chosen: as it collides).
const BLADE: f32 = 0.045;
/// Half the distance between the tongs' tips, open and closed [m] (chosen).
const TIPS: [f32; 2] = [0.020, 0.007];
/// Where the tongs' arms meet above the tips [m] (chosen: they lean towards the cook).
const JOINT: Vec3 = Vec3::new(0.02, -0.10, 0.17);
/// Steps along a bent part.
const STEPS: u32 = 14;

fn steel() -> Finish {
    Finish { colour: Vec3::splat(0.55), roughness: 0.40, metalness: 0.45, material: Material::Plain }
}

fn wood() -> Finish {
    Finish { colour: Vec3::new(0.10, 0.055, 0.030), roughness: 0.5, metalness: 0.0, material: Material::Plain }
}

/// The tool where it is held.
pub(crate) fn tool_mesh(tool: &ToolLook) -> Mesh {
    let mut mesh = Mesh::default();
    match tool.kind {
        ToolKind::Turner => turner(&mut mesh, &tool.world_from_tool),
        ToolKind::Tongs { open } => tongs(&mut mesh, &tool.world_from_tool, TIPS[usize::from(!open)]),
    }
    mesh
}

/// The blade lies as the tool does; its shaft always rises from the blade's rear, whichever face is up.
fn turner(mesh: &mut Mesh, pose: &Mat4) {
    let at = |x: f32| pose.transform_point3(Vec3::X * x);
    let across = pose.transform_vector3(Vec3::Y).normalize();
    let blade: Vec<Vec3> = (0..=4).map(|i| at(BLADE * (0.5 * i as f32 - 1.0))).collect();
    // Its rolled edge is thinner than a pixel: what it mirrors must be even.
    let sheet = Finish { roughness: 0.6, ..steel() };
    mesh.sweep(&rod(&blade, across, |t| Vec2::new(0.033 + 0.007 * t, 0.0008)), &sheet);
    let forward = pose.transform_vector3(Vec3::X).with_z(0.0).normalize_or(Vec3::Y);
    let back = |away: f32, up: f32| at(-BLADE) - forward * away + Vec3::Z * up;
    let shaft = bent([back(-0.006, 0.0), back(0.020, 0.010), back(0.040, 0.075), back(0.110, 0.105)]);
    let side = forward.cross(Vec3::Z);
    mesh.sweep(&rod(&shaft, side, |_| Vec2::new(0.0045, 0.0016)), &steel());
    let grip: Vec<Vec3> = (0..=8).map(|i| back(0.108 + 0.0145 * i as f32, 0.1043 + 0.0055 * i as f32)).collect();
    mesh.sweep(&rod(&grip, side, rounded), &wood());
}

fn tongs(mesh: &mut Mesh, pose: &Mat4, half: f32) {
    let origin = pose.transform_point3(Vec3::ZERO);
    let across = pose.transform_vector3(Vec3::X).with_z(0.0).normalize_or(Vec3::X);
    for side in [-1.0, 1.0] {
        let tip = origin + across * (side * half) - Vec3::Z * 0.004;
        let bow = across * (side * (half + 0.016));
        let arm =
            bent([tip, tip + Vec3::Z * 0.03, origin + bow + 0.5 * JOINT, origin + JOINT + across * (side * 0.006)]);
        // Broad, flat fingers at the tips.
        mesh.sweep(&rod(&arm, JOINT.cross(across), |t| Vec2::new(0.0085 - 0.003 * t, 0.0011)), &steel());
    }
    let top: Vec<Vec3> = (0..=4).map(|i| origin + JOINT * (0.97 + 0.03 * i as f32)).collect();
    mesh.sweep(&rod(&top, across, rounded), &wood());
}

/// Section of a grip with rounded ends.
fn rounded(t: f32) -> Vec2 {
    Vec2::new(0.0105 - 0.003 * t, 0.008) * (4.0 * t * (1.0 - t)).powf(0.18).max(0.05)
}

fn bent(control: [Vec3; 4]) -> Vec<Vec3> {
    let point = |t: f32| {
        let s = 1.0 - t;
        control[0] * s * s * s + control[1] * 3.0 * s * s * t + control[2] * 3.0 * s * t * t + control[3] * t * t * t
    };
    (0..=STEPS).map(|i| point(i as f32 / STEPS as f32)).collect()
}

/// Stations along a path whose width is about along `side`.
fn rod(path: &[Vec3], side: Vec3, section: impl Fn(f32) -> Vec2) -> Vec<Station> {
    let last = path.len() - 1;
    (0..path.len())
        .map(|i| {
            let forward = (path[(i + 1).min(last)] - path[i.saturating_sub(1)]).normalize_or(Vec3::X);
            let up = forward.cross(side).normalize_or(Vec3::Z);
            Station { centre: path[i], side: up.cross(forward), up, half: section(i as f32 / last as f32) }
        })
        .collect()
}
