//! A GPU without a window: for stills and measurements.

use saute_kitchen::Kitchen;
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;
use saute_scene::renderer::{SampleProgress, SceneRenderer};

use crate::cut::section::Picture;
use crate::stage::{Stage, StageOptions};

/// Errors of opening a graphics device.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// No adapter.
    #[error(
        "no graphics adapter was found ({0}); install a Vulkan driver, for instance the package mesa-vulkan-drivers"
    )]
    NoAdapter(#[from] wgpu::RequestAdapterError),
    /// No device.
    #[error("the graphics adapter gave no device: {0}")]
    NoDevice(#[from] wgpu::RequestDeviceError),
}

/// A graphics device with its queue.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// Device.
    pub device: wgpu::Device,
    /// Queue.
    pub queue: wgpu::Queue,
    /// Name of the adapter.
    pub adapter: String,
}

impl Gpu {
    /// Opens the best available adapter, a software one included.
    pub fn open() -> Result<Self, GpuError> {
        pollster::block_on(async {
            let adapter = match adapter(wgpu::Backends::PRIMARY).await {
                Ok(adapter) => adapter,
                Err(_) => adapter(wgpu::Backends::all()).await?,
            };
            let info = adapter.get_info();
            let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
            let descriptor = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
            let (device, queue) = adapter.request_device(&descriptor).await?;
            Ok(Self { device, queue, adapter: format!("{} ({:?})", info.name, info.backend) })
        })
    }
}

/// OpenGL is tried last: without a display its driver writes warnings to stderr.
async fn adapter(backends: wgpu::Backends) -> Result<wgpu::Adapter, wgpu::RequestAdapterError> {
    let descriptor =
        wgpu::InstanceDescriptor { backends, ..wgpu::InstanceDescriptor::new_without_display_handle_from_env() };
    wgpu::Instance::new(descriptor).request_adapter(&wgpu::RequestAdapterOptions::default()).await
}

/// Draws a kitchen once; at the best quality `samples` of light are gathered.
pub fn still(
    gpu: &Gpu,
    kitchen: &Kitchen,
    options: &StageOptions,
    size: [u32; 2],
    (quality, samples): (Quality, u32),
) -> Picture {
    let input = Stage::default().scene(kitchen, options, &Default::default());
    picture(gpu, &input, size, quality, Gather { samples, told: None })
}

/// Samples of light that a picture at the best level gathers.
#[derive(Default)]
pub struct Gather {
    /// Number of them; 0 and 1 gather none.
    pub samples: u32,
    /// Called after each.
    pub told: Option<SampleProgress>,
}

impl Gather {
    /// A renderer that gathers so.
    pub fn renderer(self, gpu: &Gpu) -> SceneRenderer {
        let mut renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
        renderer.set_samples(self.samples);
        if let Some(told) = self.told {
            renderer.on_sample(told);
        }
        renderer
    }
}

/// Draws a scene once, with a separate renderer: what an earlier picture left would show.
pub fn picture(gpu: &Gpu, input: &SceneInput, size: [u32; 2], quality: Quality, gather: Gather) -> Picture {
    let mut renderer = gather.renderer(gpu);
    let rgba = renderer.render_to_image(&gpu.device, &gpu.queue, input, size, quality);
    Picture { width: size[0] as usize, height: size[1] as usize, rgba }
}
