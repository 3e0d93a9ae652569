//! A made-up scene for stills, benchmarks and tests of the renderer: a steak whose states are painted, not computed.

use std::f32::consts::TAU;
use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};

use crate::camera::Camera;
use crate::input::{
    BrowningPalette, Colouring, FILM_SIZE, FLOOR_FIELD_RINGS, FilmPicture, FleshTexture, FoodLook, FoodMesh,
    FoodVertex, GrainVolume, HobLook, PanLook, SceneInput, SliceLook, SteamSource, StoveKind, TintPicture, Vapour,
};
use crate::noise::gradient_noise;

const HALF: Vec3 = Vec3::new(0.060, 0.040, 0.0125);
const AROUND: usize = 96;
const RINGS: usize = 11;
const SIDE_ROWS: usize = 7;

/// How far the painted steak is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doneness {
    /// Cold and wet.
    Raw,
    /// The upper side still pink and wet, the lower edge browned.
    HalfWay,
    /// Turned: well browned above.
    Browned,
}

/// A carbon steel pan on the hob, empty.
pub fn empty_pan() -> SceneInput {
    let pan = PanLook {
        floor_radius: 0.098,
        rim_radius: 0.130,
        rim_height: 0.042,
        thickness: 0.003,
        colour: Vec3::new(0.105, 0.115, 0.135),
        metalness: 0.85,
        roughness: 0.42,
        film: Arc::new(FilmPicture { texels: vec![[110, 0, 0, 0]; (FILM_SIZE * FILM_SIZE) as usize] }),
        tint: Arc::new(TintPicture { texels: vec![[128; 4]; (FILM_SIZE * FILM_SIZE) as usize] }),
        oil_colour: Vec3::new(0.75, 0.62, 0.22),
        oil_turbidity: 0.0,
        ridges: None,
        lid: None,
        position: Vec3::ZERO,
        rotation: glam::Quat::IDENTITY,
        on_cloth: false,
        floor_field: std::array::from_fn(|ring| 0.75 - 0.25 * ring as f32 / FLOOR_FIELD_RINGS as f32),
    };
    SceneInput {
        camera: Camera::three_quarter(),
        hob: HobLook { kind: StoveKind::Induction, power: 0.6 },
        pan,
        foods: Vec::new(),
        tool: None,
        strings: Vec::new(),
        rest: None,
        steam: Vec::new(),
        spatter: Default::default(),
        time_s: 3.0,
        colouring: Colouring::Look,
        white_balance: Default::default(),
        light: Default::default(),
        photo: Default::default(),
        flat: false,
        mirror: None,
        tile: None,
        sample: None,
    }
}

/// The same with a steak in the pan.
pub fn steak_in_pan(doneness: Doneness) -> SceneInput {
    let mut scene = empty_pan();
    let lift = scene.pan.thickness + HALF.z + 0.0004;
    let pose = Mat4::from_translation(Vec3::new(-0.008, 0.004, lift)) * Mat4::from_rotation_z(0.35);
    scene.foods.push(steak(doneness, pose));
    if doneness != Doneness::Raw {
        let place = |x: f32, y: f32| SteamSource {
            kind: Vapour::Steam,
            position: Vec3::new(x, y, 0.02),
            radius: 0.02,
            flow_g_s: 0.12,
        };
        scene.steam = vec![place(-0.05, 0.03), place(0.04, 0.02), place(0.0, -0.03)];
    }
    scene
}

/// A steak at a pose.
pub fn steak(doneness: Doneness, world_from_rest: Mat4) -> FoodLook {
    let (places, triangles) = body();
    let vertices = places.iter().map(|&(rest, normal)| painted(doneness, rest, normal)).collect();
    let palette = BrowningPalette {
        golden: [45.0, 13.0, 24.0],
        golden_at: 0.4,
        crust: [31.0, 5.0, 6.0],
        char: [14.0, 1.0, 1.0],
        fat_brown: [48.0, 12.0, 32.0],
        second: [0.0; 3],
    };
    let mesh = Arc::new(FoodMesh {
        key: 1,
        triangles,
        texture: FleshTexture::Muscle,
        texture_place: Vec3::ZERO,
        grew_along_x: false,
        palette,
        grain: marbling(),
    });
    FoodLook {
        mesh,
        vertices: Arc::new(vertices),
        world_from_rest,
        slice: None,
        sear: Default::default(),
        steam_g_s: if doneness == Doneness::Raw { 0.0 } else { 0.05 },
        juice_g: 0.0,
    }
}

/// Cuts a steak across its middle; the half towards the cook is hidden.
pub fn cut(steak: &mut FoodLook, doneness: Doneness) {
    const COLUMNS: usize = 48;
    const ROWS: usize = 16;
    let normal = Vec3::NEG_Y;
    let mut vertices = Vec::new();
    for j in 0..=ROWS {
        for i in 0..=COLUMNS {
            let across = Vec2::new(i as f32 / COLUMNS as f32, j as f32 / ROWS as f32) * 2.0 - 1.0;
            let x = across.x * outline(if across.x < 0.0 { TAU * 0.5 } else { 0.0 }).length();
            let bulge = (1.0 - 0.10 * across.y * across.y) * x;
            let rest = Vec3::new(bulge, 0.0, across.y * thickness(Vec2::new(across.x, 0.0)));
            vertices.push(FoodVertex { normal: normal.to_array(), ..painted_inside(doneness, rest) });
        }
    }
    let at = |i: usize, j: usize| (j * (COLUMNS + 1) + i) as u32;
    let mut triangles = Vec::new();
    for j in 0..ROWS {
        for i in 0..COLUMNS {
            triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    steak.slice = Some(SliceLook { point: Vec3::ZERO, normal, vertices, triangles, ghost: true });
}

/// A table from dark blue over purple and orange to pale yellow, sRGB.
pub fn heat_table() -> Arc<[[u8; 3]; 256]> {
    let stops =
        [[20.0, 20.0, 80.0], [120.0, 30.0, 130.0], [220.0, 80.0, 60.0], [250.0, 180.0, 60.0], [255.0, 250.0, 200.0]]
            .map(|[r, g, b]: [f32; 3]| Vec3::new(r, g, b));
    Arc::new(std::array::from_fn(|i| {
        let at = i as f32 / 255.0 * (stops.len() - 1) as f32;
        let low = (at as usize).min(stops.len() - 2);
        let colour = stops[low].lerp(stops[low + 1], at - low as f32);
        colour.to_array().map(|c| c.round() as u8)
    }))
}

/// Outline of the steak by angle: an oval with a straighter fat side.
fn outline(angle: f32) -> Vec2 {
    let (sin, cos) = angle.sin_cos();
    let power = 2.6;
    let radius = (cos.abs().powf(power) + sin.abs().powf(power)).powf(-1.0 / power);
    let wobble =
        1.0 + 0.045 * (angle * 2.0 + 0.6).sin() + 0.022 * (angle * 3.0 + 2.0).sin() + 0.010 * (angle * 7.0).sin();
    Vec2::new(cos * HALF.x, sin * HALF.y) * radius * wobble
}

/// Half the thickness over the outline's unit disc.
fn thickness(disc: Vec2) -> f32 {
    HALF.z * (1.0 + 0.05 * (disc.x * 3.0 + 1.0).sin() + 0.04 * (disc.y * 4.0).cos() - 0.10 * disc.length_squared())
}

/// Vertices (place, normal) and triangles of the steak.
fn body() -> (Vec<(Vec3, Vec3)>, Vec<[u32; 3]>) {
    let mut places = Vec::new();
    for side in [1.0, -1.0] {
        for ring in 0..=RINGS {
            let share = ring as f32 / RINGS as f32;
            places.extend((0..AROUND).map(|k| cap_point(share * 0.955, k, side)));
        }
        if side > 0.0 {
            for row in 1..SIDE_ROWS {
                places.extend((0..AROUND).map(|k| side_point(row as f32 / SIDE_ROWS as f32, k)));
            }
        }
    }
    let rows = RINGS + 1;
    let mut triangles = Vec::new();
    // Rows run from the middle of the top over the side; the bottom's are stored from its middle outwards.
    let row_start = |row: usize| -> usize {
        if row < rows + SIDE_ROWS - 1 {
            row * AROUND
        } else {
            (rows + SIDE_ROWS - 1 + (2 * rows + SIDE_ROWS - 2 - row)) * AROUND
        }
    };
    for row in 0..2 * rows + SIDE_ROWS - 2 {
        for k in 0..AROUND {
            let next = (k + 1) % AROUND;
            let [a, b] = [row_start(row), row_start(row + 1)];
            let [p, q, r, s] = [a + k, a + next, b + k, b + next].map(|i| i as u32);
            triangles.extend([[p, r, s], [p, s, q]]);
        }
    }
    let normals = smooth_normals(&places, &triangles);
    (places.into_iter().zip(normals).collect(), triangles)
}

fn cap_point(share: f32, k: usize, side: f32) -> Vec3 {
    let angle = TAU * k as f32 / AROUND as f32;
    let disc = Vec2::from_angle(angle) * share;
    let rounding = 1.0 - 0.10 * ((share - 0.85) / 0.105).max(0.0).powi(2);
    (outline(angle) * share).extend(side * thickness(disc) * rounding)
}

fn side_point(share: f32, k: usize) -> Vec3 {
    let angle = TAU * k as f32 / AROUND as f32;
    let lean = (share - 0.5) * 2.0;
    let out = 1.0 - 0.045 * lean.abs().powi(3);
    (outline(angle) * out).extend(-lean * thickness(Vec2::from_angle(angle)) * 0.86)
}

fn smooth_normals(places: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; places.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| places[i as usize]);
        let normal = (b - a).cross(c - a);
        triangle.iter().for_each(|&i| normals[i as usize] += normal);
    }
    // The middles of the caps are many vertices at one place.
    normals.iter().zip(places).map(|(n, p)| n.normalize_or(Vec3::new(0.0, 0.0, p.z.signum()))).collect()
}

/// Marbling: thin wandering sheets, and a cap of fat along one side.
fn marbling() -> GrainVolume {
    let size = [96u32, 64, 24];
    let origin = -HALF * 1.15;
    let extent = HALF * 2.3;
    let mut cells = Vec::with_capacity(size.iter().product::<u32>() as usize);
    for index in 0..size.iter().product::<u32>() {
        let cell =
            Vec3::new((index % size[0]) as f32, (index / size[0] % size[1]) as f32, (index / size[0] / size[1]) as f32);
        let at = origin + extent * (cell + 0.5) / Vec3::new(size[0] as f32, size[1] as f32, size[2] as f32);
        cells.push([(fat_at(at) * 255.0) as u8, 0, 255, 128]);
    }
    GrainVolume { size, origin, extent, cells }
}

fn fat_at(at: Vec3) -> f32 {
    let noise = |scale: f32, shift: f32| gradient_noise(at * scale + shift).0;
    let warp = Vec3::new(noise(60.0, 1.5), noise(60.0, 2.5), noise(60.0, 3.5)) * 0.35;
    let vein = |scale: f32, width: f32| 1.0 - gradient_noise(at * scale + warp + 5.0).0.abs() / width;
    let patches = (noise(45.0, 6.0) * 2.0 + 0.45).clamp(0.0, 1.0);
    let veins = vein(52.0, 0.055).max(0.8 * vein(115.0, 0.09)).clamp(0.0, 1.0) * patches;
    let rim = outline(at.y.atan2(at.x)).length() - at.truncate().length();
    let cap = (1.4 - rim / 0.0045).clamp(0.0, 1.0) * ((at.y / HALF.y - 0.35) * 4.0).clamp(0.0, 1.0);
    veins.max(cap)
}

/// State of a place of the surface.
fn painted(doneness: Doneness, rest: Vec3, normal: Vec3) -> FoodVertex {
    let height = rest.z / HALF.z;
    let browning = match doneness {
        Doneness::Raw => 0.0,
        Doneness::HalfWay => (-0.55 - height).max(0.0) * 2.2,
        Doneness::Browned => {
            (0.30 + 0.32 * normal.z.abs() + 0.25 * (rest.truncate().length() / 0.05 - 0.6)).clamp(0.0, 1.0)
        }
    };
    let cooked = match doneness {
        Doneness::Raw => 0.0,
        Doneness::HalfWay => (0.15 - height).clamp(0.0, 1.0),
        Doneness::Browned => 1.0,
    };
    let mut vertex = coloured(rest, normal, cooked, browning.min(1.0));
    vertex.wetness = (1.0 - 0.35 * cooked) * (1.0 - 0.75 * browning.min(1.0));
    vertex
}

/// State of a place of the cut: colour by the distance from the surface.
fn painted_inside(doneness: Doneness, rest: Vec3) -> FoodVertex {
    let half = thickness(Vec2::new(rest.x / HALF.x, 0.0));
    let from_bottom = (rest.z + half) * 1000.0;
    let from_top = (half - rest.z) * 1000.0;
    let depth = match doneness {
        Doneness::Raw => 99.0,
        Doneness::HalfWay => from_bottom,
        Doneness::Browned => from_bottom.min(from_top),
    };
    let browning = (1.0 - depth / 0.9).clamp(0.0, 1.0);
    let cooked = (1.0 - (depth - 2.0) / 5.0).clamp(0.0, 1.0);
    let mut vertex = coloured(rest, Vec3::NEG_Y, cooked, browning);
    vertex.wetness = 0.55 - 0.25 * cooked;
    vertex
}

fn coloured(rest: Vec3, normal: Vec3, cooked: f32, browning: f32) -> FoodVertex {
    let lean = [[38.0, 20.0, 11.0], [50.0, 15.0, 12.0], [53.0, 8.0, 14.0]];
    let fat = [[76.0, 4.0, 11.0], [70.0, 3.0, 14.0], [62.0, 5.0, 22.0]];
    FoodVertex {
        rest: rest.to_array(),
        position: rest.to_array(),
        normal: normal.to_array(),
        lean: ramp(lean, cooked),
        fat: ramp(fat, cooked),
        browning,
        charring: 0.0,
        wetness: 1.0,
        cooked,
        field: 0.15 + 0.3 * cooked + 0.5 * browning,
        along: 0.0,
        dorsal: 0.0,
        seared: 0.0,
        juice: 0.0,
    }
}

/// A colour between three, L*a*b* over 100.
fn ramp(colours: [[f32; 3]; 3], t: f32) -> [f32; 3] {
    let colours = colours.map(Vec3::from);
    let t = t.clamp(0.0, 1.0) * 2.0;
    let lab = if t < 1.0 { colours[0].lerp(colours[1], t) } else { colours[1].lerp(colours[2], t - 1.0) };
    (0.01 * lab).to_array()
}
