//! Overlay pipelines that draw into a window's own pass: one triangle, no vertex buffer, no depth.

/// First part of every overlay's shader.
const COVER: &str = shader!("cover");
/// The vertex function that covers the whole viewport.
pub const VS_COVER: &str = "vs_cover";

/// A picture that the fragment function samples.
pub const PICTURE: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Float { filterable: true },
    view_dimension: wgpu::TextureViewDimension::D2,
    multisampled: false,
};
/// A filtering sampler.
pub const SAMPLER: wgpu::BindingType = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
/// A uniform buffer.
pub const UNIFORM: wgpu::BindingType = wgpu::BindingType::Buffer {
    ty: wgpu::BufferBindingType::Uniform,
    has_dynamic_offset: false,
    min_binding_size: None,
};

/// Bind group layout of some stages, with bindings numbered from 0.
pub fn layout<const N: usize>(
    device: &wgpu::Device,
    label: &'static str,
    visibility: wgpu::ShaderStages,
    kinds: [wgpu::BindingType; N],
) -> wgpu::BindGroupLayout {
    let entry = |(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let entries: Vec<_> = (0..).zip(kinds).map(entry).collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
}

/// Makes a sampler with linear filtering.
pub fn sampler(device: &wgpu::Device, label: &'static str) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some(label),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    })
}

/// Description of a pipeline that covers the pass's viewport.
pub struct Overlay<'a> {
    /// Label of module, layout and pipeline.
    pub label: &'static str,
    /// WGSL source, after that of the covering triangle.
    pub shader: &'static str,
    /// Entry point of the vertex stage.
    pub vertex: &'static str,
    /// Entry point of the fragment stage.
    pub fragment: &'static str,
    /// Layout of the only bind group.
    pub layout: &'a wgpu::BindGroupLayout,
    /// What it draws into.
    pub target: wgpu::ColorTargetState,
}

impl Overlay<'_> {
    /// Makes the pipeline.
    pub fn pipeline(self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.label),
            source: wgpu::ShaderSource::Wgsl([COVER, self.shader].concat().into()),
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: &[Some(self.layout)],
            immediate_size: 0,
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(self.fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(self.target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
