//! Targets and passes after the scene, for one picture size.

use crate::gpu::post::gathering::Gathering;
use crate::gpu::post::kit::{AMBIENT_FORMAT, HDR_FORMAT, Post, PostKit};
use crate::gpu::post::lens::LensUniform;
use crate::gpu::targets::layer::{Attachments, DEPTH_FORMAT, Layer, MSAA_SAMPLES, texture, view};

/// Least height of the coarsest level of the bloom, of the whole picture [texels] (chosen: its halo is as wide as a pan).
const COARSEST: u32 = 16;

/// One pass.
pub(super) struct Step {
    post: Post,
    group: wgpu::BindGroup,
    to: wgpu::TextureView,
}

/// Targets and passes of one size.
pub(crate) struct Chain {
    msaa: Layer,
    /// Radiances, encoded.
    colour: wgpu::TextureView,
    /// Share of the room's light, half size.
    pub ambient: wgpu::TextureView,
    before: Vec<Step>,
    after: Vec<Step>,
    lens: wgpu::Buffer,
    /// Made when a still first gathers light.
    gathering: Option<Gathering>,
}

/// Number of levels of the bloom for a height of the whole picture [pixels].
pub(crate) fn bloom_levels(height: u32) -> u32 {
    (height / COARSEST).max(2).ilog2().min(8)
}

impl Chain {
    /// `picture` is the finished picture with its depth; `whole` the height of the whole picture if this is a tile.
    pub fn new(device: &wgpu::Device, kit: &PostKit, size: [u32; 2], picture: &Layer, whole: u32) -> Self {
        let target = |size, format| view(&texture(device, size, format, 1));
        let lens = LensUniform::buffer(device);
        let bench = Bench::new(device, kit, &lens, &picture.depth);
        let sizes: Vec<[u32; 2]> = halves(size).take(bloom_levels(whole) as usize).collect();
        let half = sizes[0];
        let colour = target(size, HDR_FORMAT);
        let [noisy, ambient] = [(); 2].map(|()| target(half, AMBIENT_FORMAT));
        let before = vec![bench.step(Post::Ambient, [], &noisy), bench.step(Post::Even, [&noisy], &ambient)];
        let [rows, flesh] = [(); 2].map(|()| target(size, HDR_FORMAT));
        let mut after = vec![bench.step(Post::Rows, [&colour], &rows), bench.step(Post::Columns, [&rows], &flesh)];
        let glow = bench.bloom(&mut after, &flesh, &sizes, target);
        let far = target(half, HDR_FORMAT);
        after.push(bench.step(Post::Behind, [&flesh], &far));
        after.push(bench.step(Post::Develop, [&flesh, &glow, &far], &picture.colour));
        let msaa = Layer {
            colour: view(&texture(device, size, HDR_FORMAT, MSAA_SAMPLES)),
            depth: view(&texture(device, size, DEPTH_FORMAT, MSAA_SAMPLES)),
        };
        Self { msaa, colour, ambient, before, after, lens, gathering: None }
    }

    /// Makes what a still that gathers light needs besides, when it is first needed.
    pub fn gather(&mut self, device: &wgpu::Device, kit: &PostKit, picture: &Layer, size: [u32; 2]) {
        if self.gathering.is_none() {
            let bench = Bench::new(device, kit, &self.lens, &picture.depth);
            self.gathering = Some(Gathering::new(&bench, size, &self.colour));
        }
    }

    /// What a still that gathers light needs besides.
    pub fn gathering(&self) -> Option<&Gathering> {
        self.gathering.as_ref()
    }

    /// What the scene is drawn into.
    pub fn attachments(&self) -> Attachments<'_> {
        Attachments { colour: &self.msaa.colour, resolve: Some(&self.colour), depth: &self.msaa.depth }
    }

    /// Sets how the passes read the picture.
    pub fn write(&self, queue: &wgpu::Queue, lens: &LensUniform) {
        queue.write_buffer(&self.lens, 0, bytemuck::bytes_of(lens));
    }

    /// Passes between the depth of the picture and its colours.
    pub fn shade(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit) {
        self.before.iter().for_each(|step| step.run(encoder, kit));
    }

    /// Passes after the colours.
    pub fn develop(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit) {
        self.after.iter().for_each(|step| step.run(encoder, kit));
    }
}

/// A size halved again and again, each time rounded up.
fn halves(size: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
    std::iter::successors(Some(size), |size| Some(size.map(|side| side.div_ceil(2)))).skip(1)
}

/// What all steps of a chain share while it is made.
pub(super) struct Bench<'a> {
    pub device: &'a wgpu::Device,
    kit: &'a PostKit,
    lens: &'a wgpu::Buffer,
    depth: &'a wgpu::TextureView,
    /// Bound where a pass reads fewer pictures.
    blank: wgpu::TextureView,
}

impl<'a> Bench<'a> {
    fn new(device: &'a wgpu::Device, kit: &'a PostKit, lens: &'a wgpu::Buffer, depth: &'a wgpu::TextureView) -> Self {
        Self { device, kit, lens, depth, blank: view(&texture(device, [1; 2], HDR_FORMAT, 1)) }
    }

    pub fn step<const N: usize>(&self, post: Post, from: [&wgpu::TextureView; N], to: &wgpu::TextureView) -> Step {
        use wgpu::BindingResource::{Sampler, TextureView};
        let from = |k: usize| TextureView(from.get(k).copied().unwrap_or(&self.blank));
        let resources = [
            self.lens.as_entire_binding(),
            Sampler(&self.kit.sampler),
            from(0),
            from(1),
            from(2),
            TextureView(self.depth),
        ];
        let entries: Vec<_> =
            (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        let layout = &self.kit.layout;
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("post"),
            layout,
            entries: &entries,
        });
        Step { post, group, to: to.clone() }
    }

    /// Passes of the bloom; returns where it ends up, in half size.
    fn bloom(
        &self,
        steps: &mut Vec<Step>,
        colour: &wgpu::TextureView,
        sizes: &[[u32; 2]],
        target: impl Fn([u32; 2], wgpu::TextureFormat) -> wgpu::TextureView,
    ) -> wgpu::TextureView {
        let levels: Vec<_> = sizes.iter().map(|size| target(*size, HDR_FORMAT)).collect();
        steps.push(self.step(Post::Glow, [colour], &levels[0]));
        for pair in levels.windows(2) {
            steps.push(self.step(Post::Halve, [&pair[0]], &pair[1]));
        }
        let mut sum = levels[levels.len() - 1].clone();
        for (level, size) in levels.iter().zip(sizes).rev().skip(1) {
            let to = target(*size, HDR_FORMAT);
            steps.push(self.step(Post::Gather, [level, &sum], &to));
            sum = to;
        }
        sum
    }
}

impl Step {
    /// Draws it in the place of what its target holds.
    pub fn run(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit) {
        self.run_mixed(encoder, kit, 1.0, wgpu::LoadOp::Clear(wgpu::Color::BLACK));
    }

    /// Mixes it with what its target holds; `share` is that of the new one.
    pub fn run_over(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit, share: f64) {
        self.run_mixed(encoder, kit, share, wgpu::LoadOp::Load);
    }

    fn run_mixed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        kit: &PostKit,
        share: f64,
        load: wgpu::LoadOp<wgpu::Color>,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("post"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.to,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        let Some(pipeline) = kit.pipeline(self.post) else { return };
        pass.set_pipeline(pipeline);
        pass.set_blend_constant(wgpu::Color { r: share, g: share, b: share, a: share });
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
