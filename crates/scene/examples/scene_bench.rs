//! Prints the median time of a frame of the made-up scene, for every way of drawing it.

use std::time::Instant;

use saute_heat::sorted::{Quantile, Sorted};
use saute_scene::input::{Colouring, SceneInput};
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;
use saute_scene::sample::{Doneness, cut, heat_table, steak_in_pan};

type Failure = Box<dyn std::error::Error>;

const FRAMES: usize = 40;
const SIZE: [u32; 2] = [960, 540];

fn main() -> Result<(), Failure> {
    let (device, queue) = pollster::block_on(open_device())?;
    let start = Instant::now();
    let mut renderer = SceneRenderer::new(&device, &queue);
    println!("new            {:7.1} ms", milliseconds(start));
    let scene = steak_in_pan(Doneness::HalfWay);
    println!("vertices       {:7}", scene.foods[0].vertices.len());
    let start = Instant::now();
    frame(&mut renderer, &device, &queue, &scene);
    println!("first frame    {:7.1} ms", milliseconds(start));
    let mut sliced = scene.clone();
    cut(&mut sliced.foods[0], Doneness::HalfWay);
    let field = Colouring::Field { table: heat_table(), classes: None };
    let coloured = SceneInput { colouring: field, ..sliced.clone() };
    let mut bench = |name: &str, quality, scene: &SceneInput, change: fn(&mut SceneInput, usize)| {
        renderer.set_quality(quality);
        let median = median(&mut renderer, &device, &queue, scene, change);
        println!("{name:15}{median:7.1} ms");
    };
    bench("at rest", Quality::Quick, &scene, |_, _| ());
    bench("sliced", Quality::Quick, &sliced, |_, _| ());
    bench("field", Quality::Quick, &coloured, |_, _| ());
    bench("food moves", Quality::Quick, &scene, |scene, i| scene.foods[0].world_from_rest.w_axis.z += 0.001 * i as f32);
    bench("eye moves", Quality::Quick, &scene, |scene, i| scene.camera.orbit(0.01 * i as f32, 0.0));
    bench("smooth", Quality::Smooth, &scene, |_, _| ());
    bench("best", Quality::Best, &scene, |_, _| ());
    Ok(())
}

async fn open_device() -> Result<(wgpu::Device, wgpu::Queue), Failure> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = instance.request_adapter(&wgpu::RequestAdapterOptions::default()).await?;
    println!("{}", adapter.get_info().name);
    let required_limits = wgpu::Limits::downlevel_webgl2_defaults();
    Ok(adapter.request_device(&wgpu::DeviceDescriptor { required_limits, ..Default::default() }).await?)
}

fn median(
    renderer: &mut SceneRenderer,
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    scene: &SceneInput,
    change: fn(&mut SceneInput, usize),
) -> f64 {
    let times = (0..FRAMES)
        .map(|i| {
            let mut scene = scene.clone();
            scene.time_s += i as f32 / 60.0;
            change(&mut scene, i);
            let start = Instant::now();
            frame(renderer, device, queue, &scene);
            milliseconds(start)
        })
        .collect();
    Sorted::new(times).quantile(0.5, Quantile::After).unwrap_or(f64::NAN)
}

fn frame(renderer: &mut SceneRenderer, device: &wgpu::Device, queue: &wgpu::Queue, scene: &SceneInput) {
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    renderer.render(device, queue, &mut encoder, scene, SIZE);
    queue.submit([encoder.finish()]);
    if let Err(error) = device.poll(wgpu::PollType::wait_indefinitely()) {
        eprintln!("{error}");
    }
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1000.0
}
