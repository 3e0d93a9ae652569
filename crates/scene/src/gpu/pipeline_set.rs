//! The pipelines of one renderer: made when they are first needed, then kept.

use std::collections::BTreeMap;

use crate::gpu::pipeline_build::Detail;
use crate::gpu::pipelines::{ColourPipelines, DepthPipelines, FlatPipelines, Layouts, PipelineFactory};
use crate::input::FleshTexture;

/// Pipelines by what they draw.
pub(crate) struct PipelineSet {
    factory: PipelineFactory,
    depth: DepthPipelines,
    restore: wgpu::RenderPipeline,
    colour: BTreeMap<Detail, ColourPipelines>,
    flat: Option<FlatPipelines>,
    /// True while a flame is to be drawn.
    pub burns: bool,
}

impl PipelineSet {
    /// Compiles the shaders; `textures` is the layout of the bind group of the scene's textures.
    pub fn new(device: &wgpu::Device, textures: &wgpu::BindGroupLayout) -> Self {
        let factory = PipelineFactory::new(device, textures);
        let (depth, restore) = (factory.depth(device), factory.restore(device));
        Self { factory, depth, restore, colour: BTreeMap::new(), flat: None, burns: false }
    }

    /// Layouts of the bind groups that belong to no texture set.
    pub fn layouts(&self) -> &Layouts {
        &self.factory.layouts
    }

    /// Pipelines that write depth only.
    pub fn depth(&self) -> &DepthPipelines {
        &self.depth
    }

    /// Brings a kept picture back.
    pub fn restore(&self) -> &wgpu::RenderPipeline {
        &self.restore
    }

    /// Makes the pipelines of a detail, with those of the kinds of flesh that are drawn.
    pub fn stock(&mut self, device: &wgpu::Device, detail: Detail, flesh: impl Iterator<Item = FleshTexture>) {
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, flesh);
        if self.burns {
            self.factory.kindle(device, pipelines);
        }
    }

    /// As [`Self::stock`], with what a half mirror needs.
    pub fn stock_mirror(&mut self, device: &wgpu::Device, detail: Detail, flesh: impl Iterator<Item = FleshTexture>) {
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, flesh);
        if self.burns {
            self.factory.kindle(device, pipelines);
        }
        self.factory.occlude(device, pipelines);
    }

    /// The pipelines of a detail, once they were stocked.
    pub fn colour(&self, detail: Detail) -> Option<&ColourPipelines> {
        self.colour.get(&detail)
    }

    /// The pipelines of the exact pictures.
    pub fn flat(&mut self, device: &wgpu::Device) -> &FlatPipelines {
        self.flat.get_or_insert_with(|| self.factory.flat(device))
    }
}
