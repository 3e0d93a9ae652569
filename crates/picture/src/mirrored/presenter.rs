//! Draws the eyes' pictures and warps them to the device, in a window or for a still.

use saute_scene::gpu::overlay::{self, Overlay, VS_COVER};
use saute_scene::renderer::SceneRenderer;

use super::frame::{MirrorFrame, WarpUniform};

const LABEL: &str = "mirror";
const SHADER: &str = include_str!("mirror.wgsl");

/// A renderer for each eye, and the pass that shows their pictures.
pub struct MirrorPresenter {
    eyes: Vec<SceneRenderer>,
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    warp: wgpu::Buffer,
    /// Shows the pictures of these sizes.
    group: Option<(Vec<[u32; 2]>, wgpu::BindGroup)>,
}

impl MirrorPresenter {
    /// For a device and the format that the last pass draws into.
    pub fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> Self {
        let kinds = [overlay::UNIFORM, overlay::PICTURE, overlay::PICTURE, overlay::SAMPLER];
        let layout = overlay::layout(device, LABEL, wgpu::ShaderStages::FRAGMENT, kinds);
        let fragment = if target.is_srgb() { "fs_mirror_linear" } else { "fs_mirror_encoded" };
        let target = target.into();
        let overlay = Overlay { label: LABEL, shader: SHADER, vertex: VS_COVER, fragment, layout: &layout, target };
        let sampler = overlay::sampler(device, LABEL);
        let warp = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(LABEL),
            size: size_of::<WarpUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { eyes: Vec::new(), pipeline: overlay.pipeline(device), layout, sampler, warp, group: None }
    }

    /// Draws the eyes' pictures.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        frame: &MirrorFrame,
    ) {
        while self.eyes.len() < frame.eyes.len() {
            self.eyes.push(SceneRenderer::new(device, queue));
        }
        for (renderer, eye) in self.eyes.iter_mut().zip(&frame.eyes) {
            renderer.set_quality(frame.quality);
            renderer.render(device, queue, encoder, eye, frame.size);
        }
        queue.write_buffer(&self.warp, 0, bytemuck::bytes_of(&frame.warp));
        let shown: Vec<[u32; 2]> = self.eyes.iter().take(frame.eyes.len()).map(SceneRenderer::size).collect();
        if self.group.as_ref().is_none_or(|(of, _)| *of != shown) {
            let views: Vec<_> = self.eyes.iter().take(frame.eyes.len()).map(SceneRenderer::color_view).collect();
            if let [left, .., right] | [left @ right] = views.as_slice() {
                self.group = Some((shown, self.group(device, left, right)));
            }
        }
    }

    /// Shows them over the pass's viewport.
    pub fn paint(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some((_, group)) = &self.group else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw(0..3, 0..1);
    }

    fn group(&self, device: &wgpu::Device, left: &wgpu::TextureView, right: &wgpu::TextureView) -> wgpu::BindGroup {
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(LABEL),
            layout: &self.layout,
            entries: &[
                entry(0, self.warp.as_entire_binding()),
                entry(1, wgpu::BindingResource::TextureView(left)),
                entry(2, wgpu::BindingResource::TextureView(right)),
                entry(3, wgpu::BindingResource::Sampler(&self.sampler)),
            ],
        })
    }
}
