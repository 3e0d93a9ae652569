//! Promise: every food raw and fried, a steak turned, rested, burnt and cut, and every view look as they did when
//! somebody last looked at them. `./test.sh bless` rewrites the pictures and prints what has changed.

use std::path::PathBuf;
use std::sync::Arc;

use glam::Vec3;
use saute_kitchen::Library;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::food::tissue::noise::uniform;
use saute_picture::stage::{Stage, StageOptions, nearness, poses};
use saute_picture::still::headless::Gpu;
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::shot::cook_until;
use saute_picture::{Picture, View};
use saute_recipe::{Cook, Recipe};
use saute_scene::camera::Camera;
use saute_scene::input::{FoodVertex, SceneInput};
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;

use crate::adapter;
use crate::perceptual::Difference;

const SIZE: [u32; 2] = [320, 180];
/// From where a steak is looked at [m] (chosen: it fills half of the picture's width).
const DISTANCE: f32 = 0.24;

/// What is to be seen of a kitchen.
#[derive(Clone, Copy)]
struct Shown {
    view: View,
    cut: bool,
}

const LOOK: Shown = Shown { view: View::Look, cut: false };

struct Easel {
    gpu: Gpu,
    renderer: SceneRenderer,
    library: Library,
}

impl Easel {
    fn new(gpu: Gpu) -> Self {
        let renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
        Self { gpu, renderer, library: Library::embedded().expect("embedded data") }
    }

    fn cook(&self, recipe: &str, at_s: f64) -> Cook {
        let recipe = Recipe::parse(recipe, "looks.toml", &self.library).expect("parses");
        cook_until(recipe, &self.library, at_s).expect("cooks")
    }

    fn scene(&self, cook: &Cook, shown: Shown) -> SceneInput {
        let piece = &cook.kitchen.pieces()[0];
        let yaw = if shown.cut { saute_picture::stage::CUT_YAW } else { 0.1 };
        let mut target = poses(&cook.kitchen)[0].position;
        target.z *= 0.5;
        let distance = DISTANCE * nearness(piece);
        let options = StageOptions {
            camera: Camera { yaw, pitch: 0.8, distance, target, ..Camera::three_quarter() },
            view: shown.view,
            scales: ScaleChoice::new(&self.library.scales, DEFAULT_SCALE),
            slice: shown.cut.then_some(0.0),
            ..StageOptions::default()
        };
        Stage::default().scene(&cook.kitchen, &options, &Default::default())
    }

    fn draw(&mut self, scene: &SceneInput) -> Picture {
        let rgba = self.renderer.render_to_image(&self.gpu.device, &self.gpu.queue, scene, SIZE, Quality::Smooth);
        Picture { width: SIZE[0] as usize, height: SIZE[1] as usize, rgba }
    }

    fn picture(&mut self, cook: &Cook, shown: Shown) -> Picture {
        let scene = self.scene(cook, shown);
        self.draw(&scene)
    }
}

/// Looks at a cook at some moments and compares, or blesses.
fn look(recipe: &str, moments: &[(&str, f64, Shown)]) {
    let Some(gpu) = adapter() else { return };
    let mut easel = Easel::new(gpu);
    let mut cook: Option<(f64, Cook)> = None;
    let mut failures = Vec::new();
    for (name, at_s, shown) in moments {
        if cook.as_ref().is_none_or(|(cooked_to, _)| cooked_to != at_s) {
            cook = Some((*at_s, easel.cook(recipe, *at_s)));
        }
        let Some((_, cook)) = &cook else { return };
        let got = easel.picture(cook, *shown);
        if blessing() { bless(name, &got) } else { failures.extend(compare(name, &got)) }
    }
    assert!(failures.is_empty(), "\n{}\nIf that is meant, `./test.sh bless` replaces them.", failures.join("\n"));
}

fn blessing() -> bool {
    std::env::var_os("SAUTE_BLESS").is_some()
}

fn blessed_file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/pictures").join(format!("{name}.png"))
}

fn blessed(name: &str) -> Option<Picture> {
    let image = image::open(blessed_file(name)).ok()?.to_rgba8();
    Some(Picture { width: image.width() as usize, height: image.height() as usize, rgba: image.into_raw() })
}

fn bless(name: &str, got: &Picture) {
    let change = blessed(name).map(|expected| Difference::of(got, &expected));
    match change {
        Some(change) if change.passes() => return println!("{name}: as it was ({change})"),
        Some(change) => println!("{name}: {change}"),
        None => println!("{name}: new"),
    }
    std::fs::write(blessed_file(name), png_bytes(got).expect("encodes")).expect("writes");
}

/// The report on a picture that looks different.
fn compare(name: &str, got: &Picture) -> Option<String> {
    let Some(expected) = blessed(name) else {
        return Some(format!("{name}: there is no picture to compare with: {}", blessed_file(name).display()));
    };
    let apart = Difference::of(got, &expected);
    if apart.passes() {
        return None;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    std::fs::create_dir_all(&folder).expect("folder");
    let kept = [("got", got), ("expected", &expected), ("difference", &apart.picture(got))].map(|(which, picture)| {
        let file = folder.join(format!("{name}-{which}.png"));
        std::fs::write(&file, png_bytes(picture).expect("encodes")).expect("writes");
        file.display().to_string()
    });
    Some(format!("{name}: {apart}\n  {}", kept.join("\n  ")))
}

/// A food of one kind: heated for three minutes, turned, and heated for one more.
fn fried(kind: &str) -> String {
    format!(
        "[pan]\ninitial_c = 200\n[[food]]\nid = \"food\"\nkind = \"{kind}\"\n[[step]]\nhob_w = 900\n[[step]]\n\
         put = \"food\"\n[[step]]\nafter_s = 180\nflip = \"food\"\n[[step]]\nafter_s = 120\nend = true\n"
    )
}

fn raw_and_at_four_minutes(kind: &str) {
    look(&fried(kind), &[(&format!("{kind}-raw"), 1.0, LOOK), (&format!("{kind}-4-min"), 240.0, LOOK)]);
}

#[test]
fn a_lean_steak_looks_as_blessed() {
    raw_and_at_four_minutes("beef-lean");
}

#[test]
fn a_marbled_steak_looks_as_blessed() {
    raw_and_at_four_minutes("beef-marbled");
}

#[test]
fn a_patty_looks_as_blessed() {
    raw_and_at_four_minutes("beef-patty");
}

#[test]
fn a_shrimp_looks_as_blessed() {
    raw_and_at_four_minutes("shrimp");
}

#[test]
fn carrots_look_as_blessed() {
    raw_and_at_four_minutes("carrot-coin");
    raw_and_at_four_minutes("carrot-stick");
}

#[test]
fn a_leek_ring_looks_as_blessed() {
    raw_and_at_four_minutes("leek-ring");
}

const STEAK: &str = "[pan]\ninitial_c = 220\n[[food]]\nid = \"steak\"\nkind = \"beef-marbled\"\n[[step]]\nhob_w = 900\n\
    [[step]]\nput = \"steak\"\n[[step]]\nafter_s = 150\nflip = \"steak\"\n[[step]]\nafter_s = 120\nrest = \"steak\"\n\
    on = \"board\"\n[[step]]\nafter_s = 60\nend = true\n";

#[test]
fn a_steak_turned_rested_and_cut_and_every_view_of_it_look_as_blessed() {
    let cut = |view| Shown { view, cut: true };
    look(
        STEAK,
        &[
            ("steak-flipped", 160.0, LOOK),
            ("steak-cut", 260.0, cut(View::Look)),
            ("view-temperature", 260.0, cut(View::Temperature)),
            ("view-moisture", 260.0, cut(View::Moisture)),
            ("view-doneness", 260.0, cut(View::Doneness)),
            ("view-browning", 260.0, cut(View::Browning)),
            ("view-lethality", 260.0, cut(View::Lethality)),
            ("view-marbling", 260.0, cut(View::Marbling)),
            ("steak-rested", 320.0, LOOK),
        ],
    );
}

const BURNT: &str = "[pan]\ninitial_c = 300\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n[[step]]\nhob_w = 2000\n\
    [[step]]\nput = \"steak\"\n[[step]]\nafter_s = 300\nflip = \"steak\"\n[[step]]\nafter_s = 20\nend = true\n";

#[test]
fn a_burnt_steak_looks_as_blessed() {
    look(BURNT, &[("steak-burnt", 310.0, LOOK)]);
}

/// Linear light times a factor in every channel.
fn balanced(picture: &Picture, factors: [f64; 3]) -> Picture {
    let light = |v: u8| (f64::from(v) / 255.0).powf(2.2);
    let channel = |(k, v): (usize, &u8)| match k % 4 {
        3 => *v,
        k => (255.0 * (light(*v) * factors[k]).min(1.0).powf(1.0 / 2.2)).round() as u8,
    };
    Picture { rgba: picture.rgba.iter().enumerate().map(channel).collect(), ..picture.clone() }
}

/// A scene whose food has browned otherwise.
fn browned(scene: &SceneInput, factor: f32) -> SceneInput {
    let mut scene = scene.clone();
    let more = |v: &FoodVertex| FoodVertex { browning: (factor * v.browning).min(1.0), ..*v };
    scene.foods[0].vertices = Arc::new(scene.foods[0].vertices.iter().map(more).collect());
    scene
}

/// A scene whose food lies elsewhere.
fn shifted(scene: &SceneInput, by: Vec3) -> SceneInput {
    let mut scene = scene.clone();
    let food = &mut scene.foods[0];
    food.world_from_rest = glam::Mat4::from_translation(by) * food.world_from_rest;
    scene
}

#[test]
fn visible_changes_fail_and_rounding_passes() {
    let Some(gpu) = adapter() else { return };
    let mut easel = Easel::new(gpu);
    let cook = easel.cook(STEAK, 160.0);
    let scene = easel.scene(&cook, LOOK);
    let plain = easel.draw(&scene);
    let mut told = Vec::new();
    let mut see = |what: &str, picture: &Picture, passes: bool| {
        let apart = Difference::of(picture, &plain);
        println!("{what}: {apart}");
        if apart.passes() != passes {
            told.push(format!("{what}: {apart}"));
        }
    };
    see("drawn again", &easel.draw(&scene), true);
    let noise = |(i, v): (usize, &u8)| v.saturating_add_signed((3.0 * uniform(9, i as u64)) as i8 - 1);
    let noisy = Picture { rgba: plain.rgba.iter().enumerate().map(noise).collect(), ..plain.clone() };
    see("a step of rounding", &noisy, true);
    see("moved by 1 mm", &easel.draw(&shifted(&scene, Vec3::new(1e-3, 0.0, 0.0))), false);
    see("browned a tenth more", &easel.draw(&browned(&scene, 1.1)), false);
    see("browned a tenth less", &easel.draw(&browned(&scene, 0.9)), false);
    // About 5000 K against 5500 K.
    see("a warmer white", &balanced(&plain, [1.05, 1.0, 0.93]), false);
    see("a tenth of a stop brighter", &balanced(&plain, [1.07; 3]), false);
    assert!(told.is_empty(), "{}", told.join("\n"));
}
