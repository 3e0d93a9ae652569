//! The ground of a panel, drawn by its own small pipeline.

use egui_wgpu::{CallbackResources, CallbackTrait, ScreenDescriptor};
use saute_scene::gpu::overlay::{self, Overlay};

const SHADER: &str = include_str!("ground.wgsl");
/// Panels that can have a ground; as in the shader.
pub const MOST_GROUNDS: u32 = 8;
/// Bytes of one ground in the uniform buffer.
const STRIDE: u64 = 32;

/// Paints the ground of panel number `index` over the callback's rectangle.
pub struct GroundCallback {
    /// Which panel, below [`MOST_GROUNDS`]; each panel of a frame has its own.
    pub index: u32,
    /// Colour, premultiplied sRGB (0–1).
    pub colour: [f32; 4],
    /// Size of the rectangle [pixels].
    pub size: [f32; 2],
    /// Corner radius [pixels].
    pub radius: f32,
}

/// Pipeline and numbers of all grounds; lives in egui's callback resources.
struct GroundPresenter {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    grounds: wgpu::Buffer,
    /// True if the target stores linear values, which the device encodes.
    linear: bool,
}

impl GroundCallback {
    /// Makes the pipeline. Called once, when the app starts.
    pub fn install(state: &egui_wgpu::RenderState) {
        Self::install_in(&mut state.renderer.write().callback_resources, &state.device, state.target_format);
    }

    /// As [`Self::install`], for any renderer of egui.
    pub(crate) fn install_in(resources: &mut CallbackResources, device: &wgpu::Device, target: wgpu::TextureFormat) {
        resources.insert(GroundPresenter::new(device, target));
    }

    fn bytes(&self, linear: bool) -> Vec<u8> {
        let decode = |v: f32| if linear { ((v + 0.055) / 1.055).max(0.0).powf(2.4) } else { v };
        let [r, g, b, a] = self.colour;
        let numbers = [decode(r), decode(g), decode(b), a, 0.5 * self.size[0], 0.5 * self.size[1], self.radius, 0.0];
        bytemuck::cast_slice(&numbers).to_vec()
    }
}

impl GroundPresenter {
    fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> Self {
        let grounds = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("grounds"),
            size: STRIDE * u64::from(MOST_GROUNDS),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let layout = overlay::layout(device, "grounds", wgpu::ShaderStages::VERTEX, [overlay::UNIFORM]);
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("grounds"),
            layout: &layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: grounds.as_entire_binding() }],
        });
        Self { pipeline: pipeline(device, &layout, target), group, grounds, linear: target.is_srgb() }
    }
}

fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let target = wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    };
    Overlay { label: "ground", shader: SHADER, vertex: "vs_ground", fragment: "fs_ground", layout, target }
        .pipeline(device)
}

impl CallbackTrait for GroundCallback {
    fn prepare(
        &self,
        _device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(presenter) = resources.get::<GroundPresenter>() {
            queue.write_buffer(&presenter.grounds, STRIDE * u64::from(self.index), &self.bytes(presenter.linear));
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        let Some(presenter) = resources.get::<GroundPresenter>() else { return };
        pass.set_pipeline(&presenter.pipeline);
        pass.set_bind_group(0, &presenter.group, &[]);
        pass.draw(3 * self.index..3 * self.index + 3, 0..1);
    }
}
