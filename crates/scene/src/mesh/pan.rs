//! The frying pan: a turned body with a rolled rim, and a riveted bar handle.

use glam::{Vec2, Vec3};

use crate::input::PanLook;
use crate::mesh::solid::{Finish, Material, Mesh, ProfilePoint, Station, bezier, bezier_at, with_normals};

/// Thickness of the wall [m] (chosen).
const WALL: f32 = 0.0025;
/// Radius of the rolled lip [m] (chosen).
const LIP: f32 = 0.0022;
const SEGMENTS: u32 = 96;
/// Direction of the handle, seen from above [rad]: towards the cook's right (chosen).
pub const HANDLE_ANGLE: f32 = -0.98;
const HANDLE_LENGTH: f32 = 0.205;
/// How far the handle's tip is from the pan's middle, about [m]: where it is grabbed.
pub const HANDLE_REACH: f32 = 0.32;

/// The floor is separate from the rest, because its colour changes every frame.
pub(crate) struct PanMesh {
    pub body: Mesh,
    pub floor: Mesh,
}

/// Builds the pan with the centre of its underside at the origin.
pub(crate) fn pan_mesh(pan: &PanLook) -> PanMesh {
    let metal =
        Finish { colour: pan.colour, roughness: pan.roughness, metalness: pan.metalness, material: Material::Metal };
    let mut body = Mesh::default();
    body.lathe(&wall_profile(pan), SEGMENTS, &metal);
    body.lathe(&outside_profile(pan), SEGMENTS, &metal);
    handle(&mut body, pan, &metal);
    let mut floor = Mesh::default();
    let mut rings: Vec<Vec2> = (0..=8)
        .map(|i| {
            Vec2::new(pan.floor_radius * i as f32 / 8.0, pan.thickness - pan.ridges.map_or(0.0, |[.., height]| height))
        })
        .collect();
    if pan.ridges.is_some() {
        // The plate between ridges is lower than the foot of the wall.
        rings.push(Vec2::new(pan.floor_radius, pan.thickness));
    }
    floor.lathe(&with_normals(&rings), SEGMENTS, &Finish { material: Material::PanFloor, ..metal });
    if let Some(ridges) = pan.ridges {
        raise(&mut body, pan, ridges, &Finish { roughness: pan.roughness * 0.85, ..metal });
    }
    PanMesh { body, floor }
}

/// Ridges across the floor: rounded bars along y whose tops are `height` above the plate.
fn raise(mesh: &mut Mesh, pan: &PanLook, [pitch, width, height]: [f32; 3], finish: &Finish) {
    let reach = 0.97 * pan.floor_radius;
    let count = (reach / pitch) as i32;
    for k in -count..=count {
        let x = k as f32 * pitch;
        let half_length = (reach * reach - x * x).max(0.0).sqrt();
        // Stations crowd towards the ends, which slope down to the plate.
        let station = |t: f32| {
            let end = (1.0 - ((t.abs() - 0.94) / 0.06).max(0.0).powi(2)).max(0.0).sqrt();
            let half = Vec2::new(0.5 * width * (0.6 + 0.4 * end), 0.5 * height * end + 1e-5);
            let centre =
                Vec3::new(x, t * half_length, pan.thickness - 0.5 * height + half.y - 0.5 * height * (1.0 - end));
            Station { centre, side: Vec3::NEG_X, up: Vec3::Z, half }
        };
        let stations: Vec<Station> = [-1.0, -0.97, -0.94, -0.5, 0.0, 0.5, 0.94, 0.97, 1.0].map(station).into();
        mesh.sweep(&stations, finish);
    }
}

/// Inner wall from the floor's edge upwards; tangent to the floor, so that the fillet is round.
fn inner_curve(pan: &PanLook) -> [Vec2; 4] {
    let run = pan.rim_radius - LIP - pan.floor_radius;
    let (base, top) = (pan.thickness, pan.thickness + pan.rim_height - LIP);
    [
        Vec2::new(pan.floor_radius, base),
        Vec2::new(pan.floor_radius + 0.55 * run, base),
        Vec2::new(pan.floor_radius + 0.72 * run, base + 0.38 * pan.rim_height),
        Vec2::new(pan.floor_radius + run, top),
    ]
}

/// Point of the inner wall at a height above the floor, as radius and height over the underside [m], and the unit
/// normal there, into the pan.
pub fn on_wall(pan: &PanLook, height: f32) -> (Vec2, Vec2) {
    let (curve, wanted) = (inner_curve(pan), pan.thickness + height);
    let points: Vec<Vec2> = bezier(curve, 32).collect();
    let at = points.windows(2).position(|w| w[1].y >= wanted).unwrap_or(points.len() - 2);
    let (low, high) = (points[at], points[at + 1]);
    let share = ((wanted - low.y) / (high.y - low.y).max(1e-9)).clamp(0.0, 1.0);
    (low.lerp(high, share), (high - low).perp().normalize_or(Vec2::Y))
}

fn wall_profile(pan: &PanLook) -> Vec<ProfilePoint> {
    let points: Vec<Vec2> = bezier(inner_curve(pan), 18).collect();
    let mut profile = with_normals(&points);
    // The floor starts here: same normal on both sides of the joint.
    profile[0].normal = Vec2::Y;
    for point in &mut profile {
        let height = (point.at.y - pan.thickness) / pan.rim_height;
        point.visibility = 0.55 + 0.45 * height.clamp(0.0, 1.0);
    }
    profile
}

fn outside_profile(pan: &PanLook) -> Vec<ProfilePoint> {
    let mut points = vec![inner_curve(pan)[3]];
    let lip = points[0] + Vec2::new(LIP * 0.9, -LIP * 0.1);
    points.extend((0..=6).map(|i| lip + Vec2::from_angle(2.9 - 3.6 * i as f32 / 6.0) * LIP));
    let mut outer: Vec<Vec2> = bezier(inner_curve(pan), 14).collect();
    outer.reverse();
    let offset = Vec2::new(WALL, -0.35 * WALL);
    points.extend(outer.into_iter().skip(2).map(|p| Vec2::new(p.x + offset.x, (p.y + offset.y).max(0.0012))));
    let foot = pan.floor_radius + WALL;
    points.extend([Vec2::new(foot, 0.0006), Vec2::new(foot - 0.002, 0.0), Vec2::new(0.0, 0.0004)]);
    let mut profile = with_normals(&points);
    for point in &mut profile {
        point.visibility = 0.25 + 0.75 * (point.at.y / (0.6 * pan.rim_height)).clamp(0.0, 1.0);
    }
    profile
}

/// A flat bar that leaves the wall below the rim, rises and ends in a rounded tip.
fn handle(mesh: &mut Mesh, pan: &PanLook, metal: &Finish) {
    let along = Vec2::from_angle(HANDLE_ANGLE).extend(0.0);
    let side = Vec3::new(-along.y, along.x, 0.0);
    let finish = Finish { roughness: (pan.roughness * 0.9).max(0.32), ..*metal };
    let root_height = pan.thickness + 0.62 * pan.rim_height;
    let wall = bezier(inner_curve(pan), 40).find(|p| p.y >= root_height).map_or(pan.rim_radius, |p| p.x);
    let start = wall + 0.6 * WALL;
    let curve = [
        Vec2::new(start, root_height),
        Vec2::new(start + 0.035, root_height + 0.012),
        Vec2::new(start + 0.090, root_height + 0.042),
        Vec2::new(start + HANDLE_LENGTH, root_height + 0.050),
    ];
    let station = |t: f32| {
        let at = bezier_at(curve, t);
        let slope = bezier_at(curve, t + 0.01) - bezier_at(curve, t - 0.01);
        let forward = (along * slope.x + Vec3::Z * slope.y).normalize();
        let centre = along * at.x + Vec3::Z * at.y;
        // `side × up` must point along the sweep for the faces to look outwards.
        Station { centre, side: -side, up: forward.cross(-side), half: handle_section(t) }
    };
    // Stations crowd towards the tip, which is round.
    let stations: Vec<Station> = (0..=40).map(|i| station(1.0 - (1.0 - i as f32 / 40.0).powi(2))).collect();
    mesh.sweep(&stations, &finish);
    hanging_hole(mesh, &station(0.925), along);
    rivets(mesh, pan, along, side, &finish);
}

/// Half width and half thickness of the handle at a fraction of its length (chosen).
fn handle_section(t: f32) -> Vec2 {
    let root = (1.0 - t / 0.22).max(0.0);
    let width = 0.0085 + 0.010 * root * root + 0.0052 * smooth((t - 0.2) / 0.7);
    let tip = (1.0 - ((t - 0.92) / 0.08).max(0.0).powi(2)).max(0.0).sqrt();
    Vec2::new(width * tip + 1e-4, 0.0026 + 0.0012 * smooth(t / 0.5) * tip)
}

fn hanging_hole(mesh: &mut Mesh, station: &Station, along: Vec3) {
    let dark = Finish { colour: Vec3::splat(0.012), roughness: 0.9, metalness: 0.0, material: Material::Plain };
    let top = station.centre + station.up.normalize() * station.up.z.signum() * (station.half.y + 0.0002);
    let centre = mesh.push(top, Vec3::Z, &dark, 0.5);
    let ring: Vec<u32> = (0..=16)
        .map(|i| {
            let (sin, cos) = (std::f32::consts::TAU * i as f32 / 16.0).sin_cos();
            mesh.push(top + along * cos * 0.0062 + station.side * sin * 0.0036, Vec3::Z, &dark, 0.5)
        })
        .collect();
    for pair in ring.windows(2) {
        mesh.indices.extend([centre, pair[0], pair[1]]);
    }
}

/// Three rivet heads on the inner wall where the handle is fixed.
fn rivets(mesh: &mut Mesh, pan: &PanLook, along: Vec3, side: Vec3, finish: &Finish) {
    let steel = Finish { colour: finish.colour.lerp(Vec3::splat(0.45), 0.35), roughness: 0.38, ..*finish };
    let wall = with_normals(&bezier(inner_curve(pan), 40).collect::<Vec<_>>());
    for (height, sideways) in [(0.50, -0.0105), (0.50, 0.0105), (0.74, 0.0)] {
        let z = pan.thickness + height * pan.rim_height;
        let Some(point) = wall.iter().find(|point| point.at.y >= z) else {
            continue;
        };
        let radial = (along * point.at.x + side * sideways).normalize();
        let normal = radial * point.normal.x + Vec3::Z * point.normal.y;
        let centre = radial * point.at.x + Vec3::Z * point.at.y;
        mesh.dome(centre, normal, 0.0046, 0.0022, &steel);
    }
}

fn smooth(t: f32) -> f32 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
