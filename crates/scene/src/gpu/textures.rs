//! Textures that every surface reads, generated once, and their bind group.

use wgpu::util::{DeviceExt, TextureDataOrder};

use crate::gpu::post::AMBIENT_FORMAT;
use crate::gpu::targets::layer::DEPTH_FORMAT;
use crate::input::FILM_SIZE;
use crate::light::environment::{self, ENVIRONMENT_LEVELS, ENVIRONMENT_SIZE};
use crate::light::room_light::RoomLight;
use crate::noise::{bundles, halve_picture, halve_volume, solid_noise};
use crate::quality::Quality;

/// Shared textures and samplers.
pub(crate) struct SceneTextures {
    pub layout: wgpu::BindGroupLayout,
    pub bind_group: wgpu::BindGroup,
    pub shadow_map: wgpu::TextureView,
    pub contact_map: wgpu::TextureView,
    quality: Quality,
    environment: wgpu::TextureView,
    light: RoomLight,
    plain: Patterns,
    /// Made when they are first needed.
    fine: Option<Patterns>,
    table: wgpu::Texture,
    film: wgpu::Texture,
    tint: wgpu::Texture,
    /// Share of the room's light by pixel; white until the best level makes one.
    ambient: wgpu::TextureView,
    stepped: bool,
    samplers: Samplers,
}

/// The generated patterns in one fineness.
struct Patterns {
    noise: wgpu::TextureView,
    bundles: wgpu::TextureView,
}

/// Texels along each side of noise and bundles, as a rule and at their finest (chosen: the finest shows no facets where
/// a texel covers many pixels; 1 MiB and 2 MiB).
const PLAIN: [u32; 2] = [32, 256];
const FINEST: [u32; 2] = [64, 1024];

impl Patterns {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, [noise, bundles]: [u32; 2]) -> Self {
        Self { noise: noise_texture(device, queue, noise), bundles: bundle_texture(device, queue, bundles) }
    }
}

struct Samplers {
    depth: wgpu::Sampler,
    clamp: wgpu::Sampler,
    tile: wgpu::Sampler,
    nearest: wgpu::Sampler,
}

impl SceneTextures {
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, quality: Quality) -> Self {
        let layout = layout(device);
        let samplers = Samplers::new(device);
        let [shadow_map, contact_map] = depth_maps(device, quality);
        let light = RoomLight::default();
        let environment = environment_texture(device, queue, light);
        let plain = Patterns::new(device, queue, PLAIN);
        let fine = (quality == Quality::Best).then(|| Patterns::new(device, queue, FINEST));
        let patterns = fine.as_ref().unwrap_or(&plain);
        let table = plain_texture(device, "colour table", [256, 1]);
        let film = plain_texture(device, "pan film", [FILM_SIZE; 2]);
        let tint = plain_texture(device, "heat tint", [FILM_SIZE; 2]);
        let views = [&shadow_map, &contact_map, &environment, &patterns.noise, &patterns.bundles];
        let unshaded = sampled_texture(device, queue, [1; 3], 1, AMBIENT_FORMAT, &[255]);
        let pictures = [&table, &film, &tint];
        let bind_group = bind(device, &layout, views, pictures, &unshaded, &samplers, false);
        Self {
            layout,
            bind_group,
            shadow_map,
            contact_map,
            quality,
            environment,
            light,
            plain,
            fine,
            table,
            film,
            tint,
            ambient: unshaded,
            stepped: false,
            samplers,
        }
    }

    /// Sets the quality of maps and patterns; returns true if the maps must be redrawn.
    pub fn set_quality(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, quality: Quality) -> bool {
        if self.quality == quality {
            return false;
        }
        [self.shadow_map, self.contact_map] = depth_maps(device, quality);
        self.quality = quality;
        if quality == Quality::Best && self.fine.is_none() {
            self.fine = Some(Patterns::new(device, queue, FINEST));
        }
        self.rebind(device);
        true
    }

    /// True when the table is read by nearest entry.
    pub fn stepped(&self) -> bool {
        self.stepped
    }

    /// Takes another colour table.
    pub fn set_table(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        table: &[[u8; 3]; 256],
        classes: Option<&[u8; 256]>,
    ) {
        let (hatch, stepped) = (classes.copied().unwrap_or([0; 256]), classes.is_some());
        let texels: Vec<u8> = table.iter().zip(hatch).flat_map(|(c, pattern)| [c[0], c[1], c[2], pattern]).collect();
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(1024), rows_per_image: None };
        queue.write_texture(self.table.as_image_copy(), &texels, layout, self.table.size());
        if stepped != self.stepped {
            self.stepped = stepped;
            self.rebind(device);
        }
    }

    /// Takes another picture of what is in the pan.
    pub fn set_film(&mut self, queue: &wgpu::Queue, texels: &[[u8; 4]]) {
        write_picture(queue, &self.film, texels);
    }

    /// Takes another picture of what heat has done to the pan's colour.
    pub fn set_tint(&mut self, queue: &wgpu::Queue, texels: &[[u8; 4]]) {
        write_picture(queue, &self.tint, texels);
    }

    fn rebind(&mut self, device: &wgpu::Device) {
        let finest = self.fine.as_ref().filter(|_| self.quality == Quality::Best);
        let patterns = finest.unwrap_or(&self.plain);
        let views = [&self.shadow_map, &self.contact_map, &self.environment, &patterns.noise, &patterns.bundles];
        let pictures = [&self.table, &self.film, &self.tint];
        self.bind_group = bind(device, &self.layout, views, pictures, &self.ambient, &self.samplers, self.stepped);
    }

    /// Takes another light of the room.
    pub fn set_light(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, light: RoomLight) {
        if self.light != light {
            self.light = light;
            self.environment = environment_texture(device, queue, light);
            self.rebind(device);
        }
    }

    /// Takes another picture of the share of the room's light.
    pub fn set_ambient(&mut self, device: &wgpu::Device, ambient: &wgpu::TextureView) {
        if self.ambient != *ambient {
            self.ambient = ambient.clone();
            self.rebind(device);
        }
    }
}

/// Writes a picture of the pan, if it is whole.
fn write_picture(queue: &wgpu::Queue, to: &wgpu::Texture, texels: &[[u8; 4]]) {
    if texels.len() == (FILM_SIZE * FILM_SIZE) as usize {
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * FILM_SIZE), rows_per_image: None };
        queue.write_texture(to.as_image_copy(), bytemuck::cast_slice(texels), layout, to.size());
    }
}

impl Samplers {
    fn new(device: &wgpu::Device) -> Self {
        let make = |address: wgpu::AddressMode, filter: wgpu::FilterMode, compare: Option<wgpu::CompareFunction>| {
            let mipmap_filter = match filter {
                wgpu::FilterMode::Linear if compare.is_none() => wgpu::MipmapFilterMode::Linear,
                _ => wgpu::MipmapFilterMode::Nearest,
            };
            device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("scene"),
                address_mode_u: address,
                address_mode_v: address,
                address_mode_w: address,
                mag_filter: filter,
                min_filter: filter,
                mipmap_filter,
                compare,
                ..Default::default()
            })
        };
        use wgpu::{AddressMode::*, FilterMode::*};
        Self {
            depth: make(ClampToEdge, Linear, Some(wgpu::CompareFunction::LessEqual)),
            clamp: make(ClampToEdge, Linear, None),
            tile: make(Repeat, Linear, None),
            nearest: make(ClampToEdge, Nearest, None),
        }
    }
}

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::{BindingType, SamplerBindingType, TextureSampleType, TextureViewDimension};
    let texture =
        |sample_type, view_dimension| BindingType::Texture { sample_type, view_dimension, multisampled: false };
    let float = TextureSampleType::Float { filterable: true };
    let filtering = BindingType::Sampler(SamplerBindingType::Filtering);
    let types = [
        texture(TextureSampleType::Depth, TextureViewDimension::D2),
        texture(TextureSampleType::Depth, TextureViewDimension::D2),
        BindingType::Sampler(SamplerBindingType::Comparison),
        texture(float, TextureViewDimension::D2),
        filtering,
        texture(float, TextureViewDimension::D3),
        texture(float, TextureViewDimension::D2),
        filtering,
        texture(float, TextureViewDimension::D2),
        filtering,
        texture(float, TextureViewDimension::D2),
        texture(float, TextureViewDimension::D2),
        texture(float, TextureViewDimension::D2),
    ];
    let entries: Vec<_> = (0..).zip(types).map(|(binding, ty)| fragment_entry(binding, ty)).collect();
    device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("scene textures"), entries: &entries })
}

/// A layout entry that only fragments see.
pub(crate) fn fragment_entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None }
}

fn bind(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    [shadow, contact, environment, noise, bundles]: [&wgpu::TextureView; 5],
    [table, film, tint]: [&wgpu::Texture; 3],
    ambient: &wgpu::TextureView,
    samplers: &Samplers,
    stepped: bool,
) -> wgpu::BindGroup {
    use wgpu::BindingResource::{Sampler, TextureView};
    let [table, film, tint] = [table, film, tint].map(|t| t.create_view(&wgpu::TextureViewDescriptor::default()));
    let table_sampler = if stepped { &samplers.nearest } else { &samplers.clamp };
    let resources = [
        TextureView(shadow),
        TextureView(contact),
        Sampler(&samplers.depth),
        TextureView(environment),
        Sampler(&samplers.clamp),
        TextureView(noise),
        TextureView(bundles),
        Sampler(&samplers.tile),
        TextureView(&table),
        Sampler(table_sampler),
        TextureView(&film),
        TextureView(&tint),
        TextureView(ambient),
    ];
    let entries: Vec<_> =
        (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("scene textures"), layout, entries: &entries })
}

/// Shadow map, whose fine and coarse part are side by side, and contact map.
fn depth_maps(device: &wgpu::Device, quality: Quality) -> [wgpu::TextureView; 2] {
    let [shadow, contact] = quality.map_sizes();
    [[2 * shadow, shadow], [contact; 2]].map(|size| depth_map(device, size))
}

fn depth_map(device: &wgpu::Device, [width, height]: [u32; 2]) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("depth map"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: DEPTH_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Creates a texture that is only sampled; `texels` contains all levels one after another.
pub(crate) fn sampled_texture(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    size: [u32; 3],
    levels: u32,
    format: wgpu::TextureFormat,
    texels: &[u8],
) -> wgpu::TextureView {
    let dimension = if size[2] > 1 { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 };
    sampled_texture_of(device, queue, size, levels, format, dimension, texels)
}

/// As `sampled_texture`, with a stated dimension.
pub(crate) fn sampled_texture_of(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    [width, height, depth_or_array_layers]: [u32; 3],
    levels: u32,
    format: wgpu::TextureFormat,
    dimension: wgpu::TextureDimension,
    texels: &[u8],
) -> wgpu::TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: Some("generated"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers },
        mip_level_count: levels,
        sample_count: 1,
        dimension,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let texture = device.create_texture_with_data(queue, &descriptor, TextureDataOrder::MipMajor, texels);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

fn environment_texture(device: &wgpu::Device, queue: &wgpu::Queue, light: RoomLight) -> wgpu::TextureView {
    let texels: Vec<u16> = (0..ENVIRONMENT_LEVELS).flat_map(|level| environment::level(light, level)).collect();
    let size = [ENVIRONMENT_SIZE, ENVIRONMENT_SIZE, 1];
    let format = wgpu::TextureFormat::Rgba16Float;
    sampled_texture(device, queue, size, ENVIRONMENT_LEVELS, format, bytemuck::cast_slice(&texels))
}

/// Side of the coarsest level of noise and of bundles [texels] (chosen: a cell of the pattern still shows).
const COARSEST: [u32; 2] = [4, 8];

fn noise_texture(device: &wgpu::Device, queue: &wgpu::Queue, size: u32) -> wgpu::TextureView {
    let levels = (size / COARSEST[0]).ilog2() + 1;
    let mut texels = solid_noise(size);
    let mut level = texels.clone();
    for step in 0..levels - 1 {
        level = halve_volume(&level, size >> step);
        texels.extend_from_slice(&level);
    }
    sampled_texture(device, queue, [size; 3], levels, wgpu::TextureFormat::Rgba8Unorm, &texels)
}

fn bundle_texture(device: &wgpu::Device, queue: &wgpu::Queue, size: u32) -> wgpu::TextureView {
    let levels = (size / COARSEST[1]).ilog2() + 1;
    let mut texels = bundles(size);
    let mut level = texels.clone();
    for step in 0..levels - 1 {
        level = halve_picture(&level, size >> step);
        texels.extend_from_slice(&level);
    }
    sampled_texture(device, queue, [size, size, 1], levels, wgpu::TextureFormat::Rg8Unorm, &texels)
}

/// A texture that is written now and then.
fn plain_texture(device: &wgpu::Device, label: &str, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}
