//! Render targets for one picture size.

pub(crate) mod layer;

use self::layer::{Attachments, COLOUR_FORMAT, DEPTH_FORMAT, Layer, MSAA_SAMPLES, layer, texture, view};
use crate::gpu::post::Chain;

/// A cached layer, with the bind group that restores it.
pub(crate) struct Kept {
    pub layer: Layer,
    pub restore: wgpu::BindGroup,
}

impl Kept {
    fn new(device: &wgpu::Device, size: [u32; 2], restore_layout: &wgpu::BindGroupLayout) -> Self {
        let layer = layer(device, size, 1);
        let exact = device.create_sampler(&wgpu::SamplerDescriptor { label: Some("restore"), ..Default::default() });
        let restore = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("restore"),
            layout: restore_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&layer.colour) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&layer.depth) },
                wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::Sampler(&exact) },
            ],
        });
        Self { layer, restore }
    }
}

/// Render targets: the picture, and two cached layers.
pub(crate) struct Targets {
    pub size: [u32; 2],
    pub texture: wgpu::Texture,
    /// The finished picture.
    pub picture: Layer,
    /// What does not move, kept between frames.
    pub still: Kept,
    /// That with the foods and the pan's floor, kept as long as they look the same.
    pub lively: Layer,
    msaa: Option<Layer>,
    /// What turns radiances into the picture.
    pub chain: Option<Chain>,
}

impl Targets {
    pub fn new(device: &wgpu::Device, size: [u32; 2], restore_layout: &wgpu::BindGroupLayout) -> Self {
        let texture = texture(device, size, COLOUR_FORMAT, 1);
        let (still, lively) = (Kept::new(device, size, restore_layout), layer(device, size, 1));
        let picture = Layer { colour: view(&texture), depth: view(&layer::texture(device, size, DEPTH_FORMAT, 1)) };
        Self { size, texture, picture, still, lively, msaa: None, chain: None }
    }

    /// The multisampled layer, made when first needed.
    pub fn msaa(&mut self, device: &wgpu::Device) {
        if self.msaa.is_none() {
            self.msaa = Some(layer(device, self.size, MSAA_SAMPLES));
        }
    }

    /// Attachments that resolve the multisampled layer into `into`; plain ones before `msaa` was called.
    pub fn multisampled<'a>(&'a self, into: &'a Layer) -> Attachments<'a> {
        match &self.msaa {
            Some(msaa) => Attachments { colour: &msaa.colour, resolve: Some(&into.colour), depth: &msaa.depth },
            None => into.attachments(),
        }
    }
}
