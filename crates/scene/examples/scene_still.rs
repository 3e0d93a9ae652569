//! Draws made-up scenes without a window and writes them as PNG files into a directory (default: `scene`).

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use glam::{Mat4, Vec3};
use saute_scene::camera::Camera;
use saute_scene::input::{Colouring, SceneInput};
use saute_scene::mesh::props::{BOARD_CENTRE, CLOTH_PLACE};
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;
use saute_scene::sample::{Doneness, cut, empty_pan, heat_table, steak, steak_in_pan};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let directory = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "scene".into()));
    let only = std::env::args().nth(2).unwrap_or_default();
    std::fs::create_dir_all(&directory)?;
    let (device, queue) = pollster::block_on(open_device())?;
    let mut renderer = SceneRenderer::new(&device, &queue);
    for (name, scene, size) in pictures().into_iter().filter(|(name, ..)| name.contains(&only)) {
        let pixels = renderer.render_to_image(&device, &queue, &scene, size, Quality::Smooth);
        write_png(&directory.join(name).with_extension("png"), &pixels, size)?;
    }
    Ok(())
}

async fn open_device() -> Result<(wgpu::Device, wgpu::Queue), Failure> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = instance.request_adapter(&wgpu::RequestAdapterOptions::default()).await?;
    let required_limits = wgpu::Limits::downlevel_webgl2_defaults();
    Ok(adapter.request_device(&wgpu::DeviceDescriptor { required_limits, ..Default::default() }).await?)
}

fn pictures() -> Vec<(&'static str, SceneInput, [u32; 2])> {
    let wide = [1280, 720];
    let phone = [390, 844];
    let seen = |scene: SceneInput, camera: Camera| SceneInput { camera, ..scene };
    let field = |scene: SceneInput, flat| SceneInput {
        colouring: Colouring::Field { table: heat_table(), classes: None },
        flat,
        ..scene
    };
    vec![
        ("empty", empty_pan(), wide),
        ("raw", steak_in_pan(Doneness::Raw), wide),
        ("half_way", steak_in_pan(Doneness::HalfWay), wide),
        ("browned", steak_in_pan(Doneness::Browned), wide),
        ("browned_phone", steak_in_pan(Doneness::Browned), phone),
        ("browned_above", seen(steak_in_pan(Doneness::Browned), Camera::above()), wide),
        ("browned_close", seen(steak_in_pan(Doneness::Browned), Camera::close_up()), wide),
        ("raw_close", seen(steak_in_pan(Doneness::Raw), Camera::close_up()), wide),
        ("slice", seen(sliced(Doneness::Browned), Camera::close_up()), wide),
        ("slice_half_way", sliced(Doneness::HalfWay), wide),
        ("field", field(sliced(Doneness::HalfWay), false), wide),
        ("field_flat", field(sliced(Doneness::HalfWay), true), wide),
        ("corner", resting(), wide),
    ]
}

fn sliced(doneness: Doneness) -> SceneInput {
    let mut scene = steak_in_pan(doneness);
    scene.steam.clear();
    cut(&mut scene.foods[0], doneness);
    scene
}

/// The steak on the board, the pan on the cloth, seen from further away.
fn resting() -> SceneInput {
    let mut scene = empty_pan();
    scene.foods.push(steak(Doneness::Browned, Mat4::from_translation(BOARD_CENTRE + Vec3::Z * 0.0128)));
    scene.pan.position = CLOTH_PLACE;
    scene.pan.on_cloth = true;
    scene.camera = Camera { pitch: 0.6, distance: 1.15, ..Camera::three_quarter() };
    scene
}

fn write_png(path: &Path, pixels: &[u8], [width, height]: [u32; 2]) -> Result<(), Failure> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(())
}
