//! Promise: pictures are true: the temperature view decodes to the field of the core, and the look follows it.

use std::sync::OnceLock;

use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::food::FoodModel;
use saute_kitchen::food::tissue::noise::uniform;
use saute_kitchen::{Library, Piece, celsius};
use saute_picture::stage::{Pose, StageOptions, half_length, poses};
use saute_picture::still::headless::still;
use saute_picture::still::shot::{ShotError, cook_until};
use saute_picture::{Picture, TemperatureMap, View};
use saute_recipe::{Cook, Recipe};
use saute_scene::camera::Camera;
use saute_scene::quality::Quality;

use crate::adapter;

const SIZE: [u32; 2] = [1280, 720];
/// Smooth edges, one sample of light.
const PLAIN: (Quality, u32) = (Quality::Smooth, 1);

const SEARED: &str = "[pan]\ninitial_c = 210\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
    [[step]]\nhob_w = 800\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 200\nflip = \"steak\"\n\
    [[step]]\nafter_s = 200\nend = true\n";

/// The seared steak at 300 s, cooked once for all tests.
fn seared() -> &'static Cook {
    static COOKED: OnceLock<Cook> = OnceLock::new();
    COOKED.get_or_init(|| {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(SEARED, "seared.toml", &library).expect("parses");
        cook_until(recipe, &library, 300.0).expect("cooks")
    })
}

fn options(view: View, slice: Option<f64>, flat: bool) -> StageOptions {
    let camera = Camera { yaw: saute_picture::stage::CUT_YAW, ..Camera::three_quarter() };
    StageOptions { camera, view, map: TemperatureMap::Uniform, slice, flat, ..StageOptions::default() }
}

fn pixel(picture: &Picture, [x, y]: [usize; 2]) -> [u8; 3] {
    let at = 4 * (y * picture.width + x);
    [picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]
}

/// A plane of the rest frame (origin: centre of the bottom face) on which points are taken.
enum Plane {
    /// The face that is above.
    Upper,
    /// The cut.
    Cut(f64),
}

fn thickness(model: &FoodModel) -> f64 {
    model.mesh().swept().expect("a slice").thickness()
}

/// How far a point of the rest shape has moved as the piece contracted and bent [m].
fn moved(piece: &Piece, point: [f64; 3]) -> glam::Vec3 {
    let (mesh, half) = (piece.model.mesh(), 0.5 * thickness(&piece.model));
    let now = piece.model.positions(&piece.state);
    let shift = |axis: usize| {
        let rest = |node: usize| mesh.position(node)[axis] - if axis == 2 { half } else { 0.0 };
        let field: Vec<f64> = now.iter().enumerate().map(|(node, p)| p[axis] - rest(node)).collect();
        piece.model.at(&field, point).expect("inside") as f32
    };
    glam::Vec3::new(shift(0), shift(1), shift(2))
}

/// The rest-frame point of a plane that the centre of the pixel nearest to `near` shows, with that pixel.
fn seen(piece: &Piece, pose: &Pose, camera: &Camera, plane: &Plane, near: [f64; 3]) -> ([usize; 2], [f64; 3]) {
    let aspect = SIZE[0] as f32 / SIZE[1] as f32;
    let half = 0.5 * thickness(&piece.model);
    let centred = glam::Vec3::new(near[0] as f32, near[1] as f32, (near[2] - half) as f32);
    let shift = moved(piece, near);
    let ndc = camera.project(pose.matrix().transform_point3(centred + shift), aspect).expect("in view");
    let column = ((ndc[0] + 1.0) * 0.5 * SIZE[0] as f32).floor();
    let row = ((1.0 - ndc[1]) * 0.5 * SIZE[1] as f32).floor();
    let centre = [2.0 * (column + 0.5) / SIZE[0] as f32 - 1.0, 1.0 - 2.0 * (row + 0.5) / SIZE[1] as f32];
    let (origin, direction) = camera.ray(centre, aspect);
    let inverse = pose.matrix().inverse();
    let (from, d) = (inverse.transform_point3(origin), inverse.transform_vector3(direction));
    let mut point = near;
    // Near a hot face flesh has moved differently a tenth of a millimetre further on.
    for _ in 0..4 {
        let o = from - moved(piece, point);
        let t = match plane {
            Plane::Upper => ((near[2] - half) as f32 - o.z) / d.z,
            Plane::Cut(x) => (*x as f32 - o.x) / d.x,
        };
        let hit = o + d * t;
        point = [f64::from(hit.x), f64::from(hit.y), (f64::from(hit.z) + half).clamp(0.0, 2.0 * half)];
    }
    ([column as usize, row as usize], point)
}

#[test]
fn the_flat_temperature_view_decodes_to_the_cores_field_within_a_kelvin() {
    let Some(gpu) = adapter() else { return };
    let cook = seared();
    let piece = &cook.kitchen.pieces()[0];
    let pose = poses(&cook.kitchen)[0];
    let options = options(View::Temperature, Some(0.2), true);
    let picture = still(&gpu, &cook.kitchen, &options, SIZE, PLAIN);
    let map = TemperatureMap::Uniform.map();
    let (thickness, cut) = (thickness(&piece.model), 0.2 * half_length(piece));
    let upper = if piece.upside_down() { 0.0 } else { thickness };
    for i in 0..40u64 {
        let random = |k: u64| uniform(2013, 10 * i + k);
        let (plane, near) = if i % 2 == 0 {
            (Plane::Upper, [-0.045 + random(0) * (cut + 0.035), (random(1) - 0.5) * 0.055, upper])
        } else {
            (Plane::Cut(cut), [cut, (random(0) - 0.5) * 0.06, 0.0015 + random(1) * (thickness - 0.003)])
        };
        let (at, point) = seen(piece, &pose, &options.camera, &plane, near);
        let truth = celsius(piece.model.at(&piece.state.temperature, point).expect("inside"));
        let (decoded, distance) = map.decode(pixel(&picture, at));
        assert!(distance < 4.0, "point {i}: {:?} is no colour of the map", pixel(&picture, at));
        assert!(
            (decoded - truth).abs() < 1.0,
            "point {i} at {point:?}: {decoded} °C in the picture, {truth} °C in the core"
        );
    }
}

#[test]
fn flat_views_of_every_field_decode_to_the_cores_values() {
    let Some(gpu) = adapter() else { return };
    let cook = seared();
    let piece = &cook.kitchen.pieces()[0];
    let (model, state) = (&*piece.model, &piece.state);
    let pose = poses(&cook.kitchen)[0];
    let (thickness, cut) = (thickness(model), 0.2 * half_length(piece));
    for view in [View::Moisture, View::Browning, View::Lethality, View::Marbling] {
        let options = options(view, Some(0.2), true);
        let picture = still(&gpu, &cook.kitchen, &options, SIZE, PLAIN);
        let map = view.colour_map(TemperatureMap::Uniform, None).expect("a field");
        let field: Vec<f64> =
            (0..model.mesh().node_count()).map(|node| view.value(model, state, node, map.change())).collect();
        for i in 0..30u64 {
            let random = |k: u64| uniform(77, 10 * i + k);
            let near = [cut, (random(0) - 0.5) * 0.06, 0.004 + random(1) * (thickness - 0.008)];
            let (at, point) = seen(piece, &pose, &options.camera, &Plane::Cut(cut), near);
            let value = |dz: f64| model.at(&field, [point[0], point[1], point[2] + dz]).expect("inside").min(map.to);
            // Lethality changes tenfold in a millimetre, so half a pixel moves it: what is that near counts.
            let reach = if view == View::Lethality { 5e-4 } else { 0.0 };
            let truth = [-reach, 0.0, reach].map(value);
            let (low, high) = (truth.into_iter().fold(f64::MAX, f64::min), truth.into_iter().fold(f64::MIN, f64::max));
            let (decoded, distance) = map.decode(pixel(&picture, at));
            let off = (low - decoded).max(decoded - high).max(0.0) / (map.to - map.from);
            assert!(distance < 4.0 && off < 0.02, "{view:?} {i}: {decoded} in the picture, {truth:?} in the core");
        }
    }
}

/// Classes differ by patterns as well as by colours, but a picture for measuring contains nothing but its classes'
/// colours.
#[test]
fn lit_doneness_is_hatched_and_flat_doneness_is_not() {
    let Some(gpu) = adapter() else { return };
    let cook = seared();
    let library = Library::embedded().expect("embedded data");
    let scale = library.scales[0].clone();
    let picture = |flat: bool| {
        let options = StageOptions {
            scales: ScaleChoice::new(&library.scales, &scale.id),
            ..options(View::Doneness, Some(0.2), flat)
        };
        still(&gpu, &cook.kitchen, &options, SIZE, PLAIN)
    };
    let table = View::Doneness.colour_map(TemperatureMap::Uniform, Some(&scale)).expect("a field").table;
    let (flat, lit) = (picture(true), picture(false));
    let of_class = |p: &[u8]| table.iter().any(|c| (0..3).all(|k| p[k].abs_diff(c[k]) <= 1));
    let count = flat.rgba.chunks(4).filter(|p| of_class(p)).count();
    assert!(count > 5_000, "{count} pixels in the colours of the classes");
    // In the light the upper face, all of one class, is inked in places and not in others.
    let piece = &cook.kitchen.pieces()[0];
    let upper = if piece.upside_down() { 0.0 } else { 0.999 * thickness(&piece.model) };
    let camera = options(View::Doneness, None, false).camera;
    let (at, _) = seen(piece, &poses(&cook.kitchen)[0], &camera, &Plane::Upper, [-0.03, 0.0, upper]);
    let level = |picture: &Picture, dx: usize, dy: usize| -> f64 {
        pixel(picture, [at[0] + dx, at[1] + dy]).map(f64::from).iter().sum::<f64>()
    };
    let spread = |picture: &Picture| {
        let levels: Vec<f64> = (0..144).map(|i| level(picture, i % 12, i / 12)).collect();
        let (low, high) =
            (levels.iter().copied().fold(f64::INFINITY, f64::min), levels.iter().copied().fold(0.0, f64::max));
        low / high
    };
    assert!(spread(&flat) > 0.99, "{}", spread(&flat));
    assert!(spread(&lit) < 0.75, "{}", spread(&lit));
}

const BURNT: &str = "[pan]\ninitial_c = 300\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
    [[step]]\nhob_w = 2000\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 900\nflip = \"steak\"\n\
    [[step]]\nafter_s = 20\nend = true\n";

#[test]
fn a_burnt_face_is_far_darker_than_a_raw_one() {
    let Some(gpu) = adapter() else { return };
    let lightness = |at_s: f64| {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(BURNT, "burnt.toml", &library).expect("parses");
        let cook = cook_until(recipe, &library, at_s).expect("cooks");
        let picture = still(&gpu, &cook.kitchen, &options(View::Look, None, false), SIZE, PLAIN);
        let piece = &cook.kitchen.pieces()[0];
        let pose = poses(&cook.kitchen)[0];
        let mut sum = 0.0;
        for i in 0..400u64 {
            let [x, y] = [(uniform(5, 2 * i) - 0.5) * 0.08, (uniform(5, 2 * i + 1) - 0.5) * 0.05];
            // A hair below the upper face, whose height differs from place to place.
            let upper = 0.999 * piece.model.height_above([x, y]).expect("inside");
            let near = [x, y, if piece.upside_down() { 0.0 } else { upper }];
            let (at, _) = seen(piece, &pose, &options(View::Look, None, false).camera, &Plane::Upper, near);
            sum += pixel(&picture, at).map(f64::from).iter().sum::<f64>() / 1200.0;
        }
        sum
    };
    let (raw, burnt) = (lightness(1.0), lightness(910.0));
    assert!(burnt < 0.7 * raw, "raw {raw}, burnt {burnt}");
}

#[test]
fn a_time_past_the_end_is_refused_with_the_recipes_end() {
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(SEARED, "seared.toml", &library).expect("parses");
    let error = cook_until(recipe, &library, 5000.0).map(|_| ()).expect_err("refused");
    assert!(matches!(&error, ShotError::PastTheEnd { end_s, .. } if (end_s - 400.0).abs() < 0.3), "{error}");
    assert!(error.to_string().contains("remedy"), "{error}");
}

#[test]
fn board_rack_and_foil_are_told_apart() {
    let Some(gpu) = adapter() else { return };
    let resting = |on: &str| {
        let text = format!(
            "[pan]\ninitial_c = 100\n[[food]]\nid = \"s\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 20]\n\
             [[step]]\nput = \"s\"\n[[step]]\nafter_s = 1\nrest = \"s\"\non = \"{on}\"\n[[step]]\nafter_s = 8\nend = true\n"
        );
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(&text, "rest.toml", &library).expect("parses");
        let cook = cook_until(recipe, &library, 6.0).expect("cooks");
        let mut options = options(View::Look, None, false);
        options.camera.target = poses(&cook.kitchen)[0].position;
        still(&gpu, &cook.kitchen, &options, [640, 360], PLAIN)
    };
    let pictures = ["board", "rack", "foil"].map(resting);
    for (a, b) in [(0, 1), (0, 2), (1, 2)] {
        let differing = pictures[a].rgba.chunks(4).zip(pictures[b].rgba.chunks(4)).filter(|(p, q)| p != q).count();
        assert!(differing > 500, "{a} and {b} differ in {differing} pixels");
    }
}
