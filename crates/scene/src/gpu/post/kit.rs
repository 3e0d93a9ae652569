//! Pipelines of the passes after the scene.

use std::collections::BTreeMap;

use crate::gpu::overlay::{self, Overlay, PICTURE, SAMPLER, UNIFORM, VS_COVER};
use crate::gpu::targets::layer::COLOUR_FORMAT;

/// Format of radiances.
pub(crate) const HDR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Format of the share of the room's light.
pub(crate) const AMBIENT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// The depth of a picture, read as a plain float.
pub(crate) const DEPTH: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Float { filterable: false },
    view_dimension: wgpu::TextureViewDimension::D2,
    multisampled: false,
};

const AMBIENT: &str = concat!(shader!("lens"), shader!("radiance"), shader!("ambient"));
const BLOOM: &str = concat!(shader!("lens"), shader!("radiance"), shader!("bloom"));
const FOCUS: &str = concat!(shader!("lens"), shader!("radiance"), shader!("focus"));
const DEVELOP: &str = concat!(shader!("lens"), shader!("radiance"), shader!("develop"));
const SCATTER: &str = concat!(shader!("lens"), shader!("radiance"), shader!("scatter"));

const GATHER: &str = concat!(shader!("lens"), shader!("radiance"), shader!("gather"));

/// A pass over the whole of its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Post {
    /// Share of the room's light, from depth.
    Ambient,
    /// The same without its noise.
    Even,
    /// Light that travels in flesh, along the rows.
    Rows,
    /// The same along the columns.
    Columns,
    /// What glows.
    Glow,
    /// Half the size.
    Halve,
    /// A level of the glow with the coarser ones.
    Gather,
    /// What is behind the sharp part.
    Behind,
    /// The picture.
    Develop,
    /// A sample of a still that gathers light, into the mean of them.
    Sample,
    /// Their mean as radiances of a picture.
    Mean,
}

impl Post {
    const ALL: [Self; 11] = [
        Self::Ambient,
        Self::Even,
        Self::Rows,
        Self::Columns,
        Self::Glow,
        Self::Halve,
        Self::Gather,
        Self::Behind,
        Self::Develop,
        Self::Sample,
        Self::Mean,
    ];

    /// How a pass is mixed with what its target holds; the constant is the new one's share.
    fn blend(self) -> Option<wgpu::BlendState> {
        use wgpu::{BlendComponent, BlendFactor, BlendOperation};
        let mixed = BlendComponent {
            src_factor: BlendFactor::Constant,
            dst_factor: BlendFactor::OneMinusConstant,
            operation: BlendOperation::Add,
        };
        (self == Self::Sample).then_some(wgpu::BlendState { color: mixed, alpha: mixed })
    }

    fn shader(self) -> (&'static str, &'static str, wgpu::TextureFormat) {
        match self {
            Self::Ambient => (AMBIENT, "fs_ambient", AMBIENT_FORMAT),
            Self::Even => (AMBIENT, "fs_even", AMBIENT_FORMAT),
            Self::Rows => (SCATTER, "fs_along_rows", HDR_FORMAT),
            Self::Columns => (SCATTER, "fs_along_columns", HDR_FORMAT),
            Self::Glow => (BLOOM, "fs_glow", HDR_FORMAT),
            Self::Halve => (BLOOM, "fs_halve", HDR_FORMAT),
            Self::Gather => (BLOOM, "fs_gather", HDR_FORMAT),
            Self::Behind => (FOCUS, "fs_behind", HDR_FORMAT),
            Self::Develop => (DEVELOP, "fs_develop", COLOUR_FORMAT),
            Self::Sample => (GATHER, "fs_sample", HDR_FORMAT),
            Self::Mean => (GATHER, "fs_mean", HDR_FORMAT),
        }
    }
}

/// Pipelines, and what all of their bind groups share.
pub(crate) struct PostKit {
    pub layout: wgpu::BindGroupLayout,
    pub sampler: wgpu::Sampler,
    pipelines: BTreeMap<Post, wgpu::RenderPipeline>,
}

impl PostKit {
    /// Compiles the shaders.
    pub fn new(device: &wgpu::Device) -> Self {
        let kinds = [UNIFORM, SAMPLER, PICTURE, PICTURE, PICTURE, DEPTH];
        let layout = overlay::layout(device, "post", wgpu::ShaderStages::FRAGMENT, kinds);
        let make = |post: Post| {
            let (shader, fragment, format) = post.shader();
            let target = wgpu::ColorTargetState { blend: post.blend(), ..format.into() };
            Overlay { label: fragment, shader, vertex: VS_COVER, fragment, layout: &layout, target }.pipeline(device)
        };
        let pipelines = Post::ALL.into_iter().map(|post| (post, make(post))).collect();
        Self { pipelines, sampler: overlay::sampler(device, "post"), layout }
    }

    /// Pipeline of a pass.
    pub fn pipeline(&self, post: Post) -> Option<&wgpu::RenderPipeline> {
        self.pipelines.get(&post)
    }
}
