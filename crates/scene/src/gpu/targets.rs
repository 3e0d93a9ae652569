//! Render targets for one picture size.

use crate::gpu::post::Chain;
use crate::gpu::textures::DEPTH_FORMAT;

/// Contains sRGB-encoded values in a format without sRGB: the shaders encode, so that they control blending and exact
/// colours.
pub(crate) const COLOUR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Samples of an anti-aliased pixel.
pub(crate) const MSAA_SAMPLES: u32 = 4;

/// Colour and depth of one pass.
pub(crate) struct Layer {
    pub colour: wgpu::TextureView,
    pub depth: wgpu::TextureView,
}

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
        let picture = Layer { colour: view(&texture), depth: view(&self::texture(device, size, DEPTH_FORMAT, 1)) };
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

/// Attachments of a pass.
pub(crate) struct Attachments<'a> {
    pub colour: &'a wgpu::TextureView,
    pub resolve: Option<&'a wgpu::TextureView>,
    pub depth: &'a wgpu::TextureView,
}

impl Layer {
    pub fn attachments(&self) -> Attachments<'_> {
        Attachments { colour: &self.colour, resolve: None, depth: &self.depth }
    }
}

fn layer(device: &wgpu::Device, size: [u32; 2], samples: u32) -> Layer {
    Layer {
        colour: view(&texture(device, size, COLOUR_FORMAT, samples)),
        depth: view(&texture(device, size, DEPTH_FORMAT, samples)),
    }
}

pub(crate) fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

pub(crate) fn texture(
    device: &wgpu::Device,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
) -> wgpu::Texture {
    let mut usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    if sample_count == 1 {
        usage |= wgpu::TextureUsages::TEXTURE_BINDING;
    }
    if sample_count == 1 && format == COLOUR_FORMAT {
        usage |= wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::COPY_DST;
    }
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("scene target"),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}
