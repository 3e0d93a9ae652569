//! Shader modules, bind group layouts and render pipelines.

use std::collections::BTreeMap;

use crate::gpu::pipeline_build::{Detail, PipelineOptions, build};
use crate::gpu::targets::layer::DEPTH_FORMAT;
use crate::gpu::textures::fragment_entry;
use crate::input::{FleshTexture, FoodVertex, pan};
use crate::light::room_light;
use crate::mesh::solid::SolidVertex;
use crate::mesh::steam::PuffVertex;

const FRAME: &str = shader!("frame");
const LIGHT: &str = shader!("light");
const SOLID: &str = shader!("solid");
const FLESH: &str = shader!("flesh");
const GRAIN: &str = shader!("grain");
const BEADS: &str = shader!("beads");
const FOOD: &str = shader!("food");
const HATCH: &str = shader!("hatch");
const STEAM: &str = shader!("steam");
const FRY: &str = shader!("fry");
const DEPTH: &str = shader!("depth");
const RESTORE: &str = shader!("restore");

const SOLID_ATTRIBUTES: [wgpu::VertexAttribute; 4] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x4];
const FOOD_ATTRIBUTES: [wgpu::VertexAttribute; 7] = wgpu::vertex_attr_array![
    0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x3, 4 => Float32x4, 5 => Float32x4,
    6 => Float32x4];
const STEAM_ATTRIBUTES: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x2, 2 => Float32x3];

/// Layouts of the bind groups that belong to no texture set.
pub(crate) struct Layouts {
    pub frame: wgpu::BindGroupLayout,
    pub food: wgpu::BindGroupLayout,
    pub pose: wgpu::BindGroupLayout,
    pub restore: wgpu::BindGroupLayout,
}

/// Pipelines that draw colours in one detail.
pub(crate) struct ColourPipelines {
    detail: Detail,
    pub solid: wgpu::RenderPipeline,
    pub wood: wgpu::RenderPipeline,
    pub glass: wgpu::RenderPipeline,
    pub metal: wgpu::RenderPipeline,
    /// Flames of a burner; made when one first burns.
    pub flame: Option<wgpu::RenderPipeline>,
    /// Occluder: black with depth; made when a half mirror first needs it.
    pub occluder: Option<wgpu::RenderPipeline>,
    /// The pan's floor, which is drawn with the foods.
    pub floor: wgpu::RenderPipeline,
    /// The glass of the lid.
    pub lid: wgpu::RenderPipeline,
    /// Collars round frying foods, and drops in the air.
    pub collar: wgpu::RenderPipeline,
    /// Spots of oil.
    pub spot: wgpu::RenderPipeline,
    /// Pools of juice.
    pub pool: wgpu::RenderPipeline,
    /// By what the flesh is made of: made when such a food is first drawn.
    foods: BTreeMap<FleshTexture, FoodPipelines>,
    pub ghost: wgpu::RenderPipeline,
    pub steam: wgpu::RenderPipeline,
}

/// Pipelines that draw one kind of flesh.
pub(crate) struct FoodPipelines {
    pub food: wgpu::RenderPipeline,
    /// A cut food's outside: its inside faces show too.
    pub food_cut: wgpu::RenderPipeline,
    pub cut_face: wgpu::RenderPipeline,
}

impl ColourPipelines {
    /// Returns the pipelines of one kind of flesh; none before [`PipelineFactory::stock`] has made them.
    pub fn of(&self, texture: FleshTexture) -> Option<&FoodPipelines> {
        self.foods.get(&texture)
    }
}

/// Pipelines of the exact pictures.
pub(crate) struct FlatPipelines {
    pub solid: wgpu::RenderPipeline,
    pub food: wgpu::RenderPipeline,
}

/// Pipelines that write depth only.
pub(crate) struct DepthPipelines {
    pub solid: wgpu::RenderPipeline,
    pub food: wgpu::RenderPipeline,
    /// Without the bias that shadow maps need.
    pub still: wgpu::RenderPipeline,
    /// The same for foods.
    pub lively: wgpu::RenderPipeline,
}

/// Compiles pipelines on demand from modules that are parsed once.
pub(crate) struct PipelineFactory {
    pub layouts: Layouts,
    solid: wgpu::ShaderModule,
    food: wgpu::ShaderModule,
    sprites: wgpu::ShaderModule,
    depth: wgpu::ShaderModule,
    restore: wgpu::ShaderModule,
    solid_layout: wgpu::PipelineLayout,
    food_layout: wgpu::PipelineLayout,
}

impl PipelineFactory {
    pub fn new(device: &wgpu::Device, textures: &wgpu::BindGroupLayout) -> Self {
        let layouts = Layouts::new(device);
        let module = |label, parts: &[&str]| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(parts.concat().into()),
            })
        };
        let light = room_light::wgsl();
        let solid_layout = pipeline_layout(device, &[&layouts.frame, textures]);
        let food_layout = pipeline_layout(device, &[&layouts.frame, textures, &layouts.food]);
        Self {
            solid: module("solid", &[FRAME, &light, LIGHT, &pan::wgsl(), SOLID]),
            food: module("food", &[FRAME, &light, LIGHT, HATCH, FLESH, GRAIN, BEADS, FOOD]),
            sprites: module("sprites", &[FRAME, &light, LIGHT, STEAM, FRY]),
            depth: module("depth", &[DEPTH]),
            restore: module("restore", &[RESTORE]),
            layouts,
            solid_layout,
            food_layout,
        }
    }

    pub fn colour(&self, device: &wgpu::Device, lively: Detail) -> ColourPipelines {
        // At one sample what does not move is only drawn while the eye moves.
        let still = if lively == Detail::Usual { Detail::Quick } else { lively };
        let solid = |entry| self.solid_pipeline(device, entry, still);
        ColourPipelines {
            detail: lively,
            solid: solid("fs_solid"),
            wood: solid("fs_wood"),
            glass: solid("fs_glass"),
            metal: solid("fs_metal"),
            flame: None,
            occluder: None,
            floor: self.solid_pipeline(device, "fs_metal", lively),
            lid: self.veil_pipeline(device, "fs_lid", Some(wgpu::Face::Back), lively),
            collar: self.sprite_pipeline(device, ["vs_fry", "fs_collar"], lively),
            spot: self.sprite_pipeline(device, ["vs_fry", "fs_spot"], lively),
            pool: self.sprite_pipeline(device, ["vs_fry", "fs_pool"], lively),
            foods: BTreeMap::new(),
            // The ghost has no thickness: only the side that faces the eye is drawn.
            ghost: self.food_pipeline(device, "fs_ghost", Some(wgpu::Face::Back), true, lively, None),
            steam: self.sprite_pipeline(device, ["vs_steam", "fs_steam"], lively),
        }
    }

    /// Makes the pipelines of the kinds of flesh that are to be drawn, where there are none yet.
    pub fn stock(
        &self,
        device: &wgpu::Device,
        pipelines: &mut ColourPipelines,
        textures: impl Iterator<Item = FleshTexture>,
    ) {
        let detail = pipelines.detail;
        let make = |entry, cull, texture| self.food_pipeline(device, entry, cull, false, detail, Some(texture));
        for texture in textures {
            pipelines.foods.entry(texture).or_insert_with(|| FoodPipelines {
                food: make("fs_food", Some(wgpu::Face::Back), texture),
                food_cut: make("fs_food", None, texture),
                cut_face: make("fs_cut_face", None, texture),
            });
        }
    }

    /// Makes the pipeline of flames, which add their light.
    pub fn kindle(&self, device: &wgpu::Device, pipelines: &mut ColourPipelines) {
        let detail = if pipelines.detail == Detail::Usual { Detail::Quick } else { pipelines.detail };
        pipelines.flame.get_or_insert_with(|| self.veil_pipeline(device, "fs_flame", None, detail));
    }

    /// Makes the pipeline of occluders, which are black and write depth.
    pub fn occlude(&self, device: &wgpu::Device, pipelines: &mut ColourPipelines) {
        let detail = pipelines.detail;
        pipelines.occluder.get_or_insert_with(|| self.solid_pipeline(device, "fs_occluder", detail));
    }

    pub fn flat(&self, device: &wgpu::Device) -> FlatPipelines {
        FlatPipelines {
            solid: self.solid_pipeline(device, "fs_flat_solid", Detail::Usual),
            food: self.food_pipeline(device, "fs_flat_food", None, false, Detail::Usual, None),
        }
    }

    pub fn depth(&self, device: &wgpu::Device) -> DepthPipelines {
        let view_only = pipeline_layout(device, &[&self.layouts.frame]);
        let with_pose = pipeline_layout(device, &[&self.layouts.frame, &self.layouts.pose]);
        let bias = wgpu::DepthBiasState { constant: 2, slope_scale: 1.5, clamp: 0.0 };
        let make = |layout, entry, buffer, bias| {
            let depth = wgpu::DepthStencilState { bias, ..depth_state(true) };
            build(device, layout, (&self.depth, entry, Some(buffer)), None, depth, None, Detail::Usual)
        };
        DepthPipelines {
            solid: make(&view_only, "vs_solid_depth", solid_buffer(), bias),
            food: make(&with_pose, "vs_food_depth", food_buffer(), bias),
            still: make(&view_only, "vs_solid_depth", solid_buffer(), wgpu::DepthBiasState::default()),
            lively: make(&with_pose, "vs_food_depth", food_buffer(), wgpu::DepthBiasState::default()),
        }
    }

    pub fn restore(&self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let layout = pipeline_layout(device, &[&self.layouts.restore]);
        let depth = wgpu::DepthStencilState { depth_compare: Some(wgpu::CompareFunction::Always), ..depth_state(true) };
        let fragment = Some((&self.restore, "fs_restore", None));
        build(device, &layout, (&self.restore, "vs_restore", None), fragment, depth, None, Detail::Usual)
    }

    fn solid_pipeline(&self, device: &wgpu::Device, entry: &'static str, detail: Detail) -> wgpu::RenderPipeline {
        let vertex = (&self.solid, "vs_solid", Some(solid_buffer()));
        build(device, &self.solid_layout, vertex, Some((&self.solid, entry, None)), depth_state(true), None, detail)
    }

    /// A pipeline for what is seen through.
    fn veil_pipeline(
        &self,
        device: &wgpu::Device,
        entry: &'static str,
        cull: Option<wgpu::Face>,
        detail: Detail,
    ) -> wgpu::RenderPipeline {
        let vertex = (&self.solid, "vs_solid", Some(solid_buffer()));
        let fragment = Some((&self.solid, entry, Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING)));
        build(device, &self.solid_layout, vertex, fragment, depth_state(false), cull, detail)
    }

    fn food_pipeline(
        &self,
        device: &wgpu::Device,
        entry: &'static str,
        cull: Option<wgpu::Face>,
        veil: bool,
        detail: Detail,
        texture: Option<FleshTexture>,
    ) -> wgpu::RenderPipeline {
        let detail = PipelineOptions { detail, texture };
        let vertex = (&self.food, "vs_food", Some(food_buffer()));
        let blend = veil.then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        build(device, &self.food_layout, vertex, Some((&self.food, entry, blend)), depth_state(!veil), cull, detail)
    }

    fn sprite_pipeline(
        &self,
        device: &wgpu::Device,
        [vertex, fragment]: [&'static str; 2],
        detail: Detail,
    ) -> wgpu::RenderPipeline {
        let buffer = wgpu::VertexBufferLayout {
            array_stride: size_of::<PuffVertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &STEAM_ATTRIBUTES,
        };
        let blend = Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let vertex = (&self.sprites, vertex, Some(buffer));
        build(
            device,
            &self.solid_layout,
            vertex,
            Some((&self.sprites, fragment, blend)),
            depth_state(false),
            None,
            detail,
        )
    }
}

impl Layouts {
    fn new(device: &wgpu::Device) -> Self {
        let group = |label, entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
        };
        let texture = |sample_type, view_dimension| wgpu::BindingType::Texture {
            sample_type,
            view_dimension,
            multisampled: false,
        };
        use wgpu::{TextureSampleType, TextureViewDimension};
        let float = |filterable| TextureSampleType::Float { filterable };
        Self {
            frame: group("frame", &[uniform_entry(0)]),
            pose: group("pose", &[uniform_entry(0)]),
            food: group("food", &[uniform_entry(0), fragment_entry(1, texture(float(true), TextureViewDimension::D3))]),
            restore: group(
                "restore",
                &[
                    fragment_entry(0, texture(float(false), TextureViewDimension::D2)),
                    // Depth, read as a plain float.
                    fragment_entry(1, texture(float(false), TextureViewDimension::D2)),
                    fragment_entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::NonFiltering)),
                ],
            ),
        }
    }
}

fn uniform_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

fn solid_buffer() -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<SolidVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &SOLID_ATTRIBUTES,
    }
}

fn food_buffer() -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<FoodVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &FOOD_ATTRIBUTES,
    }
}

fn depth_state(write: bool) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(write),
        depth_compare: Some(wgpu::CompareFunction::LessEqual),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}

fn pipeline_layout(device: &wgpu::Device, groups: &[&wgpu::BindGroupLayout]) -> wgpu::PipelineLayout {
    let groups: Vec<_> = groups.iter().map(|group| Some(*group)).collect();
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("scene"),
        bind_group_layouts: &groups,
        immediate_size: 0,
    })
}
