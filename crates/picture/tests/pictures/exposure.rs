//! Promise: the kitchen is well exposed in daylight and in the evening, glints are white and matt surfaces are not, a seared
//! steak stands out from the board, and a picture drawn in tiles is the picture drawn at once.

use std::sync::OnceLock;

use glam::{Vec2, Vec3};
use saute_kitchen::{Kitchen, Library};
use saute_picture::stage::{Stage, StageOptions};
use saute_picture::still::headless::Gpu;
use saute_picture::still::shot::cook_until;
use saute_recipe::Recipe;
use saute_scene::camera::Camera;
use saute_scene::input::SceneInput;
use saute_scene::light::room_light::RoomLight;
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;

use crate::adapter;

/// Means and shares are those of a picture four times as large.
const SIZE: [u32; 2] = [640, 360];
const MEDIUM: &str = include_str!("../../../../recipes/medium.toml");
const OILED: &str = "[pan]\ninitial_c = 220\n[[food]]\nid = \"steak\"\nkind = \"beef-marbled\"\n[[step]]\nhob_w = 900\n\
    [[step]]\noil_g = 10\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 150\nflip = \"steak\"\n[[step]]\nafter_s = 120\n\
    end = true\n";

/// A picture with the scene that it shows.
struct Seen {
    scene: SceneInput,
    rgba: Vec<u8>,
}

impl Seen {
    fn of(gpu: &Gpu, scene: SceneInput, quality: Quality) -> Self {
        let mut renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
        let rgba = renderer.render_to_image(&gpu.device, &gpu.queue, &scene, SIZE, quality);
        Self { scene, rgba }
    }

    /// Every pixel with the ray through it.
    fn pixels(&self) -> impl Iterator<Item = ((Vec3, Vec3), &[u8])> {
        let size = Vec2::from_array(SIZE.map(|side| side as f32));
        self.rgba.chunks(4).enumerate().map(move |(index, pixel)| {
            let at = Vec2::new((index as u32 % SIZE[0]) as f32 + 0.5, (index as u32 / SIZE[0]) as f32 + 0.5) / size;
            (self.scene.camera.ray([2.0 * at.x - 1.0, 1.0 - 2.0 * at.y], size.x / size.y), pixel)
        })
    }

    /// Mean encoded grey (0–1) of the pixels whose ray meets a plane `z` [m] at a place that is requested.
    fn grey(&self, z: f32, wanted: impl Fn(Vec3) -> bool) -> f64 {
        let on_plane = |(eye, ray): (Vec3, Vec3)| eye + ray * ((z - eye.z) / ray.z);
        let greys: Vec<f64> =
            self.pixels().filter(|(ray, _)| wanted(on_plane(*ray))).map(|(_, pixel)| grey(pixel)).collect();
        greys.iter().sum::<f64>() / greys.len() as f64
    }

    /// As [`Self::grey`], CIE L* of the mean.
    fn lightness(&self, z: f32, wanted: impl Fn(Vec3) -> bool) -> f64 {
        let encoded = self.grey(z, wanted);
        116.0 * ((encoded + 0.055) / 1.055).powf(2.4).cbrt() - 16.0
    }

    fn pan(&self) -> f64 {
        let pan = &self.scene.pan;
        let (middle, reach) = (pan.position.truncate(), pan.rim_radius);
        self.grey(pan.position.z + pan.rim_height, |at| at.truncate().distance(middle) < reach)
    }

    /// Share of pixels whose grey is white after rounding [%], and of those among them on the board or the cloth.
    fn clipped(&self) -> [f64; 2] {
        let matt = |(eye, ray): (Vec3, Vec3)| {
            let at = eye + ray * ((BOARD_TOP - eye.z) / ray.z);
            at.x > 0.21 || at.x < -0.26
        };
        let white = |pixel: &[u8]| grey(pixel) >= 254.5 / 255.0;
        let clipped: Vec<bool> = self.pixels().filter(|(_, pixel)| white(pixel)).map(|(ray, _)| matt(ray)).collect();
        let share = |count: usize| 100.0 * count as f64 / (SIZE[0] * SIZE[1]) as f64;
        [share(clipped.len()), share(clipped.iter().filter(|matt| **matt).count())]
    }
}

/// Top of the board [m], and a part of it that nothing lies on.
const BOARD_TOP: f32 = 0.016;
fn on_board(at: Vec3) -> bool {
    (0.24..0.40).contains(&at.x) && (-0.10..0.10).contains(&at.y)
}

/// Luma of an encoded pixel, 0–1.
fn grey(pixel: &[u8]) -> f64 {
    (0.2126 * f64::from(pixel[0]) + 0.7152 * f64::from(pixel[1]) + 0.0722 * f64::from(pixel[2])) / 255.0
}

fn cooked(recipe: &str, at_s: f64) -> Kitchen {
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(recipe, "exposure.toml", &library).expect("parses");
    cook_until(recipe, &library, at_s).expect("cooks").kitchen
}

/// The oiled steak, turned, cooked once for all tests.
fn oiled() -> &'static Kitchen {
    static COOKED: OnceLock<Kitchen> = OnceLock::new();
    COOKED.get_or_init(|| cooked(OILED, 165.0))
}

fn scene(kitchen: &Kitchen, light: RoomLight) -> SceneInput {
    let options = StageOptions { camera: Camera::three_quarter(), light, ..StageOptions::default() };
    Stage::default().scene(kitchen, &options, &Default::default())
}

#[test]
fn daylight_is_bright_the_pan_is_not_dim_and_only_glints_are_white() {
    let Some(gpu) = adapter() else { return };
    for (name, kitchen) in [("medium", &cooked(MEDIUM, 240.0)), ("oiled", oiled())] {
        for quality in Quality::ALL {
            let seen = Seen::of(&gpu, scene(kitchen, RoomLight::Daylight), quality);
            let all = seen.grey(0.0, |_| true);
            let ([clipped, matt], pan) = (seen.clipped(), seen.pan());
            println!("{name} {quality:?}: grey {all:.3}, pan {pan:.3}, clipped {clipped:.3} %, matt {matt:.4} %");
            assert!((0.40..=0.55).contains(&all), "{name} {quality:?}: mean grey {all:.3}");
            assert!(pan >= 0.28, "{name} {quality:?}: the pan {pan:.3}");
            assert!(matt == 0.0, "{name} {quality:?}: {matt:.4} % clipped on board and cloth");
            assert!((0.05..=1.0).contains(&clipped), "{name} {quality:?}: {clipped:.3} % clipped");
        }
    }
}

#[test]
fn the_evening_is_warm_and_not_dim() {
    let Some(gpu) = adapter() else { return };
    for quality in Quality::ALL {
        let [day, evening] =
            [RoomLight::Daylight, RoomLight::Evening].map(|light| Seen::of(&gpu, scene(oiled(), light), quality));
        let all = evening.grey(0.0, |_| true);
        let redness = |seen: &Seen| {
            let (red, blue) = seen.rgba.chunks(4).fold((0, 0), |(r, b), p| (r + u64::from(p[0]), b + u64::from(p[2])));
            red as f64 / blue as f64
        };
        println!("{quality:?}: evening {all:.3}, red over blue {:.2} against {:.2}", redness(&evening), redness(&day));
        assert!(all >= 0.30, "{quality:?}: {all:.3}");
        assert!(redness(&evening) > 1.1 * redness(&day), "{quality:?}");
    }
}

#[test]
fn a_seared_steak_is_much_darker_than_the_board() {
    let Some(gpu) = adapter() else { return };
    let kitchen = cooked(MEDIUM, 560.0);
    for quality in Quality::ALL {
        let seen = Seen::of(&gpu, scene(&kitchen, RoomLight::Daylight), quality);
        let place = seen.scene.foods[0].world_from_rest.w_axis.truncate();
        let crust = seen.lightness(place.z + 0.011, |at| at.truncate().distance(place.truncate()) < 0.025);
        let board = seen.lightness(BOARD_TOP, on_board);
        println!("{quality:?}: crust L* {crust:.1}, board L* {board:.1}");
        assert!(board - crust >= 25.0, "{quality:?}: crust {crust:.1}, board {board:.1}");
    }
}

#[test]
fn a_picture_in_tiles_is_the_picture_drawn_at_once() {
    let Some(gpu) = adapter() else { return };
    let scene = scene(oiled(), RoomLight::Daylight);
    let size = [640, 360];
    let mut renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
    for (quality, largest) in [(Quality::Quick, 300), (Quality::Smooth, 300), (Quality::Best, 400)] {
        let whole = renderer.render_to_image(&gpu.device, &gpu.queue, &scene, size, quality);
        let tiled = renderer.render_in_tiles(&gpu.device, &gpu.queue, &scene, size, quality, largest);
        let apart: Vec<u8> = whole.iter().zip(&tiled).map(|(a, b)| a.abs_diff(*b)).collect();
        let more = apart.iter().filter(|d| **d > 1).count() as f64 / apart.len() as f64;
        let mean = apart.iter().map(|d| f64::from(*d)).sum::<f64>() / apart.len() as f64;
        println!("{quality:?}: {:.2} % of the values more than 1 apart, mean {mean:.4}", 100.0 * more);
        // Seams of triangles and spots of oil of a pixel fall on a sample or next to it by rounding of the projection.
        assert!(more <= 0.01 && mean <= 0.1, "{quality:?}: {more} of the values more than 1 apart, mean {mean}");
    }
}
