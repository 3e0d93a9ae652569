//! The mirror's picture inside an egui window.

use egui_wgpu::{CallbackResources, CallbackTrait, ScreenDescriptor};
use saute_picture::mirrored::frame::MirrorFrame;
use saute_picture::mirrored::presenter::MirrorPresenter;

/// Paints the mirror's picture over the callback's rectangle.
pub struct MirrorCallback {
    /// What to draw.
    pub frame: MirrorFrame,
}

/// The format that egui draws into, from which the presenter is made when the mirror is first shown.
struct Target(wgpu::TextureFormat);

impl MirrorCallback {
    /// Notes the format that egui draws with. Called once, when the app starts.
    pub fn install(state: &egui_wgpu::RenderState) {
        state.renderer.write().callback_resources.insert(Target(state.target_format));
    }
}

impl CallbackTrait for MirrorCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if resources.get::<MirrorPresenter>().is_none()
            && let Some(Target(format)) = resources.get::<Target>()
        {
            let presenter = MirrorPresenter::new(device, *format);
            resources.insert(presenter);
        }
        if let Some(presenter) = resources.get_mut::<MirrorPresenter>() {
            presenter.prepare(device, queue, encoder, &self.frame);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(presenter) = resources.get::<MirrorPresenter>() {
            presenter.paint(pass);
        }
    }
}
