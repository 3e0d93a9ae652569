//! The panels as a kept picture: on a software rasteriser their many small triangles cost more than the scene, so they are
//! drawn again a few times a second and laid over the scene in between.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use egui::epaint::ClippedShape;
use egui::{ClippedPrimitive, Context, FullOutput, Rect, Shape, TextureId};
use egui_wgpu::{Callback, CallbackResources, CallbackTrait, Renderer, RendererOptions, ScreenDescriptor};
use saute_scene::gpu::overlay::{self, Overlay, VS_COVER};

use crate::paint::damage::covered;
use crate::paint::ground::GroundCallback;

const LABEL: &str = "panels";
const SHADER: &str = include_str!("panel_layer.wgsl");
/// Format of the kept picture: sRGB-encoded, premultiplied.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Panels are drawn this often while nothing is touched, and while pointer or keys are used [s] (chosen: readings can be
/// followed; a button answers within a frame of a slow machine).
const PERIOD_S: f64 = 0.25;
const TOUCHED_PERIOD_S: f64 = 0.08;
/// How long a touch counts [s] (chosen: hovered buttons have changed their colour).
const TOUCH_S: f64 = 0.3;

/// What is to be drawn next.
#[derive(Default)]
struct Pending {
    /// The panels, if they are to be drawn again.
    panels: Option<Vec<ClippedPrimitive>>,
    textures: egui::TexturesDelta,
}

type Shared = Arc<Mutex<Pending>>;

fn lock(shared: &Shared) -> MutexGuard<'_, Pending> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes the panels out of egui's output and puts one callback in their place.
pub struct PanelLayer {
    shared: Shared,
    rects: Arc<Vec<Rect>>,
    drawn_s: f64,
    touched_s: f64,
    window: Option<(Rect, f32)>,
}

impl PanelLayer {
    /// Sets it up for a context and the format that egui draws with; does nothing where the target encodes sRGB itself.
    pub fn install(context: &Context, state: &egui_wgpu::RenderState) {
        if state.target_format.is_srgb() {
            return;
        }
        let shared = Shared::default();
        let presenter = PanelPresenter::new(&state.device, state.target_format, Arc::clone(&shared));
        state.renderer.write().callback_resources.insert(presenter);
        let never = f64::NEG_INFINITY;
        context.add_plugin(Self { shared, rects: Arc::default(), drawn_s: never, touched_s: never, window: None });
    }

    /// Returns true if the panels are to be drawn again.
    fn is_due(&mut self, ctx: &Context, points: f32) -> bool {
        let (now, touched) = ctx.input(|i| (i.time, !i.events.is_empty() || i.pointer.any_down()));
        if touched {
            self.touched_s = now;
        }
        let window = Some((ctx.content_rect(), points));
        let other = std::mem::replace(&mut self.window, window) != window;
        let period = if now - self.touched_s < TOUCH_S { TOUCHED_PERIOD_S } else { PERIOD_S };
        let due = other || now - self.drawn_s >= period;
        if due {
            self.drawn_s = now;
        } else {
            ctx.request_repaint_after_secs(period as f32);
        }
        due
    }
}

impl egui::Plugin for PanelLayer {
    fn debug_name(&self) -> &'static str {
        LABEL
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let points = output.pixels_per_point;
        // The scenes come first.
        let scenes = output.shapes.iter().take_while(|s| matches!(s.shape, Shape::Callback(_) | Shape::Noop)).count();
        let panels = output.shapes.split_off(scenes);
        let due = self.is_due(ctx, points);
        let mut pending = lock(&self.shared);
        pending.textures.append(output.textures_delta.clone());
        if due {
            let panels = ctx.tessellate(panels, points);
            self.rects = Arc::new(covered(&panels));
            pending.panels = Some(panels);
        }
        let callback = PanelCallback { rects: Arc::clone(&self.rects), points };
        let shape = Shape::Callback(Callback::new_paint_callback(ctx.content_rect(), callback));
        output.shapes.push(ClippedShape::new(ctx.content_rect(), shape));
    }
}

/// Lays the kept picture over the scene.
struct PanelCallback {
    /// Where there is something in it [points].
    rects: Arc<Vec<Rect>>,
    points: f32,
}

impl CallbackTrait for PanelCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let presenter = resources.get_mut::<PanelPresenter>();
        presenter.map(|presenter| presenter.draw(device, queue, screen, encoder)).unwrap_or_default()
    }

    fn paint(
        &self,
        info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        let Some(PanelPresenter { kept: Some(kept), pipeline, .. }) = resources.get::<PanelPresenter>() else { return };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &kept.group, &[]);
        for rect in self.rects.iter() {
            let [left, top, right, bottom] = pixels(*rect, self.points, info.screen_size_px);
            if left < right && top < bottom {
                pass.set_scissor_rect(left, top, right - left, bottom - top);
                pass.draw(0..3, 0..1);
            }
        }
    }
}

/// Left, top, right and bottom of a rectangle [pixels].
fn pixels(rect: Rect, points: f32, size: [u32; 2]) -> [u32; 4] {
    let within = |value: f32, most: u32| (value.max(0.0) as u32).min(most);
    let [low, high] = [rect.min * points, rect.max * points];
    [
        within(low.x.floor(), size[0]),
        within(low.y.floor(), size[1]),
        within(high.x.ceil(), size[0]),
        within(high.y.ceil(), size[1]),
    ]
}

/// The kept picture and what draws it; lives in egui's callback resources.
struct PanelPresenter {
    shared: Shared,
    renderer: Renderer,
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    kept: Option<Kept>,
}

struct Kept {
    view: wgpu::TextureView,
    group: wgpu::BindGroup,
    size: [u32; 2],
}

impl PanelPresenter {
    fn new(device: &wgpu::Device, target: wgpu::TextureFormat, shared: Shared) -> Self {
        let options = RendererOptions { dithering: false, ..RendererOptions::default() };
        let mut renderer = Renderer::new(device, FORMAT, options);
        GroundCallback::install_in(&mut renderer.callback_resources, device, FORMAT);
        let layout = overlay::layout(device, LABEL, wgpu::ShaderStages::FRAGMENT, [overlay::PICTURE]);
        let target = wgpu::ColorTargetState {
            format: target,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let pipeline =
            Overlay { label: LABEL, shader: SHADER, vertex: VS_COVER, fragment: "fs_panels", layout: &layout, target }
                .pipeline(device);
        Self { shared, renderer, pipeline, layout, kept: None }
    }

    /// Draws the panels, if they are to be drawn again.
    fn draw(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Vec<wgpu::CommandBuffer> {
        let Pending { panels, mut textures } = std::mem::take(&mut *lock(&self.shared));
        for (id, images) in textures.set.drain() {
            images.iter().for_each(|image| self.renderer.update_texture(device, queue, id, image));
        }
        let Some(panels) = panels else {
            // What is freed may still be in a picture that comes later.
            lock(&self.shared).textures.free.extend(textures.free.drain());
            return Vec::new();
        };
        let size = screen.size_in_pixels;
        let kept = self.kept.take().filter(|kept| kept.size == size);
        let kept = self.kept.insert(kept.unwrap_or_else(|| Kept::new(device, &self.layout, size)));
        let buffers = self.renderer.update_buffers(device, queue, encoder, &panels, screen);
        let mut pass = begin(encoder, &kept.view);
        self.renderer.render(&mut pass, &panels, screen);
        drop(pass);
        textures.free.iter().for_each(|id: &TextureId| self.renderer.free_texture(id));
        buffers
    }
}

impl Kept {
    fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, [width, height]: [u32; 2]) -> Self {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some(LABEL),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let entry = wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) };
        let group =
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(LABEL), layout, entries: &[entry] });
        Self { view, group, size: [width, height] }
    }
}

fn begin(encoder: &mut wgpu::CommandEncoder, view: &wgpu::TextureView) -> wgpu::RenderPass<'static> {
    encoder
        .begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(LABEL),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
                depth_slice: None,
            })],
            ..Default::default()
        })
        .forget_lifetime()
}
