//! Colour and depth of a pass: formats, textures, attachments.

/// Depth of pictures and of shadow maps.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
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

pub(crate) fn layer(device: &wgpu::Device, size: [u32; 2], samples: u32) -> Layer {
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
