//! Building one render pipeline: its detail, and the constants that its shaders leave open.

use crate::gpu::post::HDR_FORMAT;
use crate::gpu::targets::layer::{COLOUR_FORMAT, MSAA_SAMPLES};
use crate::input::FleshTexture;

/// Rendering detail of a pixel, lowest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Detail {
    /// Without the patterns of the surroundings.
    Quick,
    Usual,
    /// Anti-aliased, with more samples of the depth maps.
    Fine,
    /// Besides, with still more of them, and shadows where food touches the ground.
    Best,
    /// As `Best`, for radiances in half floats that are developed later.
    Hdr,
    /// As `Hdr`, for one of many samples of a pixel.
    Sample,
}

impl Detail {
    fn format(self) -> wgpu::TextureFormat {
        if self >= Self::Hdr { HDR_FORMAT } else { COLOUR_FORMAT }
    }

    fn samples(self) -> u32 {
        if self >= Self::Fine && self != Self::Sample { MSAA_SAMPLES } else { 1 }
    }
}

/// Description of a pipeline.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PipelineOptions {
    pub detail: Detail,
    /// Which solid texture, of those pipelines that have one.
    pub texture: Option<FleshTexture>,
}

impl From<Detail> for PipelineOptions {
    fn from(detail: Detail) -> Self {
        Self { detail, texture: None }
    }
}

impl PipelineOptions {
    /// Values of the constants that the shaders leave open.
    fn constants(self) -> Vec<(&'static str, f64)> {
        let mut constants = match self.detail {
            Detail::Quick => vec![("quick", 1.0)],
            Detail::Usual => Vec::new(),
            Detail::Fine => vec![("fine", 1.0)],
            Detail::Best => vec![("fine", 1.0), ("contact", 1.0)],
            Detail::Hdr | Detail::Sample => vec![("fine", 1.0), ("contact", 1.0), ("hdr", 1.0)],
        };
        // The numbers in `grain.wgsl`.
        constants.extend(self.texture.map(|texture| ("texture_kind", f64::from(texture as u8))));
        constants
    }
}

pub(crate) type VertexStage<'a> = (&'a wgpu::ShaderModule, &'static str, Option<wgpu::VertexBufferLayout<'static>>);
pub(crate) type FragmentStage<'a> = (&'a wgpu::ShaderModule, &'static str, Option<wgpu::BlendState>);

pub(crate) fn build(
    device: &wgpu::Device,
    layout: &wgpu::PipelineLayout,
    (vertex, vertex_entry, buffer): VertexStage<'_>,
    fragment: Option<FragmentStage<'_>>,
    depth: wgpu::DepthStencilState,
    cull_mode: Option<wgpu::Face>,
    options: impl Into<PipelineOptions>,
) -> wgpu::RenderPipeline {
    let options = options.into();
    let constants = options.constants();
    let buffers = buffer.map(Some);
    let target = fragment.as_ref().map(|(_, _, blend)| {
        let (format, write_mask) = (options.detail.format(), wgpu::ColorWrites::ALL);
        [Some(wgpu::ColorTargetState { format, blend: *blend, write_mask })]
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(fragment.as_ref().map_or(vertex_entry, |(_, entry, _)| entry)),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: vertex,
            entry_point: Some(vertex_entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: buffers.as_slice(),
        },
        primitive: wgpu::PrimitiveState { cull_mode, ..Default::default() },
        depth_stencil: Some(depth),
        multisample: wgpu::MultisampleState { count: options.detail.samples(), ..Default::default() },
        fragment: fragment.as_ref().zip(target.as_ref()).map(|((module, entry, _), target)| wgpu::FragmentState {
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() },
            targets: target,
        }),
        multiview_mask: None,
        cache: None,
    })
}
