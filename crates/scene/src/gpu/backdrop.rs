//! The room behind the pan, out of focus, at the levels that draw finished colours.

use crate::gpu::overlay::{self, Overlay, PICTURE, UNIFORM, VS_COVER};
use crate::gpu::post::{DEPTH, LensUniform};
use crate::gpu::targets::layer::COLOUR_FORMAT;

const SHADER: &str = concat!(shader!("lens"), shader!("backdrop"));
const NEAREST: wgpu::BindingType = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::NonFiltering);

/// A pass that blurs what is behind the sharp part of a picture.
pub(crate) struct Backdrop {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    lens: wgpu::Buffer,
    exact: wgpu::Sampler,
}

/// A sharp picture with its depth, and where the one with the blurred backdrop goes.
pub(crate) struct Blurred<'a> {
    pub sharp: &'a wgpu::TextureView,
    pub depth: &'a wgpu::TextureView,
    pub into: &'a wgpu::TextureView,
}

impl Backdrop {
    /// Compiles the shader.
    pub fn new(device: &wgpu::Device) -> Self {
        let layout =
            overlay::layout(device, "backdrop", wgpu::ShaderStages::FRAGMENT, [UNIFORM, NEAREST, PICTURE, DEPTH]);
        let (fragment, target) = ("fs_backdrop", COLOUR_FORMAT.into());
        let overlay =
            Overlay { label: "backdrop", shader: SHADER, vertex: VS_COVER, fragment, layout: &layout, target };
        let exact = device.create_sampler(&wgpu::SamplerDescriptor { label: Some("backdrop"), ..Default::default() });
        Self { pipeline: overlay.pipeline(device), lens: LensUniform::buffer(device), exact, layout }
    }

    /// Sets how the picture of the next submission is read, and what of it is sharp.
    pub fn write(&self, queue: &wgpu::Queue, lens: &LensUniform) {
        queue.write_buffer(&self.lens, 0, bytemuck::bytes_of(lens));
    }

    /// Blurs a picture that is drawn with the next submission.
    pub fn blur(&self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, picture: &Blurred<'_>) {
        let group = self.group(device, picture);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("backdrop"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: picture.into,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.draw(0..3, 0..1);
    }

    fn group(&self, device: &wgpu::Device, picture: &Blurred<'_>) -> wgpu::BindGroup {
        use wgpu::BindingResource::{Sampler, TextureView};
        let resources = [
            self.lens.as_entire_binding(),
            Sampler(&self.exact),
            TextureView(picture.sharp),
            TextureView(picture.depth),
        ];
        let entry = |(binding, resource)| wgpu::BindGroupEntry { binding, resource };
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("backdrop"),
            layout: &self.layout,
            entries: &(0..).zip(resources).map(entry).collect::<Vec<_>>(),
        })
    }
}
