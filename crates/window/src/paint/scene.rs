//! The scene inside an egui window.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use egui_wgpu::{CallbackResources, CallbackTrait, ScreenDescriptor};
use saute_scene::gpu::overlay::{self, Overlay, VS_COVER};
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;

const LABEL: &str = "present";
const PRESENT: &str = include_str!("scene.wgsl");

/// Paints the scene over the callback's rectangle.
///
/// `SceneCallback::install` must have been called with the resources of the same egui renderer.
pub struct SceneCallback {
    /// What to draw.
    pub input: Arc<SceneInput>,
    /// Size drawn at [pixels]; scaled to the rectangle.
    pub size: [u32; 2],
    /// Rendering quality.
    pub quality: Quality,
    /// Samples of light that a picture at the best level gathers once it stays the same; 1 for none.
    pub samples: u32,
    /// Which part of a split window, from 0: each has its own renderer, made when it is first used.
    pub pane: usize,
    /// Takes note of a picture that is not final.
    pub rest: SceneRest,
}

/// Whether the pictures of a window's scene are final.
#[derive(Clone, Debug, Default)]
pub struct SceneRest {
    /// True smooths a picture in the frame after it was drawn, however little time has passed.
    pub at_once: bool,
    /// Pictures of the last frame that are drawn once more.
    unfinished: Arc<AtomicUsize>,
}

impl SceneRest {
    /// Begins a frame.
    pub(crate) fn begin(&self) {
        self.unfinished.store(0, Ordering::Relaxed);
    }

    fn note(&self, is_final: bool) {
        self.unfinished.fetch_add(usize::from(!is_final), Ordering::Relaxed);
    }

    /// Returns true if the pictures of the last frame stay as they are while their scenes do.
    pub fn is_final(&self) -> bool {
        self.unfinished.load(Ordering::Relaxed) == 0
    }
}

/// A presenter for each part of the window; lives in egui's callback resources.
struct Presenters {
    panes: BTreeMap<usize, ScenePresenter>,
    target: wgpu::TextureFormat,
}

/// The renderer and what copies its picture to the window.
pub struct ScenePresenter {
    renderer: SceneRenderer,
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    group: Option<wgpu::BindGroup>,
    size: [u32; 2],
}

impl ScenePresenter {
    /// `target` is the format egui draws into (`egui_wgpu::RenderState::target_format`).
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, target: wgpu::TextureFormat) -> Self {
        let layout = overlay::layout(device, LABEL, wgpu::ShaderStages::FRAGMENT, [overlay::PICTURE, overlay::SAMPLER]);
        let sampler = overlay::sampler(device, LABEL);
        let pipeline = pipeline(device, &layout, target);
        Self { renderer: SceneRenderer::new(device, queue), pipeline, layout, sampler, group: None, size: [0; 2] }
    }

    /// Draws the scene and points the copy at the picture.
    pub(crate) fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        callback: &SceneCallback,
    ) {
        self.renderer.set_quality(callback.quality);
        self.renderer.set_samples(callback.samples);
        if callback.rest.at_once {
            self.renderer.set_rest(web_time::Duration::ZERO);
        }
        self.renderer.render(device, queue, encoder, &callback.input, callback.size);
        callback.rest.note(self.renderer.is_final());
        if self.group.is_some() && self.size == self.renderer.size() {
            return;
        }
        self.size = self.renderer.size();
        self.group = Some(device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(LABEL),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(self.renderer.color_view()),
                },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&self.sampler) },
            ],
        }));
    }
}

impl ScenePresenter {
    /// Copies the picture over the pass's viewport.
    pub(crate) fn paint(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(group) = &self.group else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw(0..3, 0..1);
    }
}

impl SceneCallback {
    /// Prepares renderers, for the format egui draws with. Called once, when the app starts; the first frame makes them.
    pub fn install(state: &egui_wgpu::RenderState) {
        let presenters = Presenters { panes: BTreeMap::new(), target: state.target_format };
        state.renderer.write().callback_resources.insert(presenters);
    }
}

impl CallbackTrait for SceneCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(Presenters { panes, target }) = resources.get_mut::<Presenters>() {
            let presenter = panes.entry(self.pane).or_insert_with(|| ScenePresenter::new(device, queue, *target));
            presenter.prepare(device, queue, encoder, self);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(presenter) = resources.get::<Presenters>().and_then(|p| p.panes.get(&self.pane)) {
            presenter.paint(pass);
        }
    }
}

fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    target: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let fragment = if target.is_srgb() { "fs_present_linear" } else { "fs_present_encoded" };
    let target = target.into();
    Overlay { label: LABEL, shader: PRESENT, vertex: VS_COVER, fragment, layout, target }.pipeline(device)
}

#[cfg(test)]
mod tests {
    use saute_scene::gpu::readback::read_picture;
    use saute_scene::sample::{Doneness, steak_in_pan};

    use super::*;

    const SIZE: [u32; 2] = [320, 180];

    fn device() -> Option<(wgpu::Device, wgpu::Queue)> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).ok()?;
        let required_limits = wgpu::Limits::downlevel_webgl2_defaults();
        let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
        pollster::block_on(adapter.request_device(&descriptor)).ok()
    }

    /// The scene as a window of the given format shows it, as stored bytes.
    fn presented(device: &wgpu::Device, queue: &wgpu::Queue, format: wgpu::TextureFormat) -> Vec<u8> {
        let callback = SceneCallback {
            input: Arc::new(steak_in_pan(Doneness::Raw)),
            size: SIZE,
            quality: Quality::Quick,
            samples: 1,
            pane: 0,
            rest: SceneRest::default(),
        };
        let mut presenter = ScenePresenter::new(device, queue, format);
        let window = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = window.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        presenter.prepare(device, queue, &mut encoder, &callback);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..Default::default()
        });
        presenter.paint(&mut pass);
        drop(pass);
        read_picture(device, queue, encoder, &window)
    }

    #[test]
    fn windows_of_both_encodings_store_the_same_picture() {
        let Some((device, queue)) = device() else {
            return;
        };
        let mut renderer = SceneRenderer::new(&device, &queue);
        let direct = renderer.read_as_is(&device, &queue, &steak_in_pan(Doneness::Raw), SIZE);
        for format in [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb] {
            let shown = presented(&device, &queue, format);
            let off = direct.iter().zip(&shown).map(|(a, b)| a.abs_diff(*b)).max();
            assert!(off <= Some(1), "{format:?}: {off:?}");
        }
    }
}
