//! The whole window drawn off-screen, panels and scene, as a window would.

use egui::{FullOutput, RawInput, Rect, pos2, vec2};
use egui_wgpu::{RenderState, RendererOptions, ScreenDescriptor, WgpuConfiguration, WgpuError, WgpuSetup};

use crate::app::SauteApp;
use crate::start::{Start, StartError};

/// A window without a window.
pub struct Offscreen {
    /// The program.
    pub app: SauteApp,
    context: egui::Context,
    state: RenderState,
    target: wgpu::Texture,
    size: [u32; 2],
    pixels_per_point: f32,
}

/// Errors of drawing the window off-screen.
#[derive(Debug, thiserror::Error)]
pub enum OffscreenError {
    /// No graphics.
    #[error(
        "no graphics adapter can draw the window ({0}); install a Vulkan driver, for instance the package mesa-vulkan-drivers"
    )]
    Graphics(#[from] WgpuError),
    /// The program cannot start.
    #[error(transparent)]
    Start(#[from] StartError),
}

impl Offscreen {
    /// Opens the program at a size in pixels, one for each point of its layout.
    pub fn open(start: Start, size: [u32; 2]) -> Result<Self, OffscreenError> {
        Self::open_scaled(start, size, 1.0)
    }

    /// Opens the program at a size in pixels, with so many of them for a point of its layout along an edge.
    pub fn open_scaled(start: Start, size: [u32; 2], pixels_per_point: f32) -> Result<Self, OffscreenError> {
        let mut config = WgpuConfiguration::default();
        if let WgpuSetup::CreateNew(setup) = &mut config.wgpu_setup {
            setup.instance_descriptor.backends = wgpu::Backends::PRIMARY;
        }
        let instance = pollster::block_on(config.wgpu_setup.new_instance());
        let state = pollster::block_on(RenderState::create(
            &config,
            &instance,
            None,
            RendererOptions { dithering: false, ..RendererOptions::default() },
        ))?;
        let context = egui::Context::default();
        let app = SauteApp::start(&context, Some(&state), None, start)?;
        let target = state.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("window"),
            size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: state.target_format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        Ok(Self { app, context, state, target, size, pixels_per_point })
    }

    /// Name of the adapter.
    pub fn adapter(&self) -> String {
        let info = self.state.adapter.get_info();
        format!("{} ({:?})", info.name, info.backend)
    }

    /// Runs and draws one frame at wall time `time_s`, and waits until it is drawn.
    pub fn frame(&mut self, time_s: f64) {
        let size = vec2(self.size[0] as f32, self.size[1] as f32) / self.pixels_per_point;
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), size)),
            time: Some(time_s),
            ..Default::default()
        };
        input.viewports.entry(input.viewport_id).or_default().native_pixels_per_point = Some(self.pixels_per_point);
        let app = &mut self.app;
        let output = self.context.run_ui(input, |ui| app.frame(ui));
        self.draw(output);
    }

    /// The last frame: tight RGBA8 rows from the top.
    pub fn picture(&self) -> Vec<u8> {
        let (device, queue) = (&self.state.device, &self.state.queue);
        let encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("picture") });
        saute_scene::gpu::readback::read_picture(device, queue, encoder, &self.target)
    }

    fn draw(&mut self, mut output: FullOutput) {
        let (device, queue) = (&self.state.device, &self.state.queue);
        let mut renderer = self.state.renderer.write();
        for (id, images) in output.textures_delta.set.drain() {
            images.iter().for_each(|image| renderer.update_texture(device, queue, id, image));
        }
        let screen = ScreenDescriptor { size_in_pixels: self.size, pixels_per_point: output.pixels_per_point };
        let primitives = self.context.tessellate(output.shapes, output.pixels_per_point);
        let target = self.target.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("window") });
        let buffers = renderer.update_buffers(device, queue, &mut encoder, &primitives, &screen);
        {
            let mut pass = encoder
                .begin_render_pass(&wgpu::RenderPassDescriptor {
                    label: Some("window"),
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: &target,
                        resolve_target: None,
                        ops: wgpu::Operations {
                            load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                            store: wgpu::StoreOp::Store,
                        },
                        depth_slice: None,
                    })],
                    ..Default::default()
                })
                .forget_lifetime();
            renderer.render(&mut pass, &primitives, &screen);
        }
        queue.submit(buffers.into_iter().chain([encoder.finish()]));
        // A device that is lost gives no frame; the next frame reports its own error.
        let _ = device.poll(wgpu::PollType::wait_indefinitely());
        for id in output.textures_delta.free.drain() {
            renderer.free_texture(&id);
        }
    }
}
