//! The uniform buffers of one renderer: the frame, and the views of camera, window light and contact map.

use glam::Mat4;
use wgpu::util::DeviceExt;

use crate::gpu::uniforms::FrameUniform;
use crate::light::shadow::{ContactMap, ShadowView};

/// Buffers with their bind groups.
pub(crate) struct Views {
    frame: Uniform,
    camera: Uniform,
    light: [Uniform; 2],
    contact: Uniform,
}

impl Views {
    /// `layout` is that of the frame's bind group.
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, contact: &ContactMap) -> Self {
        let uniform = |contents: &[u8]| Uniform::new(device, layout, contents);
        Self {
            frame: uniform(&[0; size_of::<FrameUniform>()]),
            camera: uniform(&[0; 64]),
            light: [uniform(&[0; 64]), uniform(&[0; 64])],
            contact: uniform(bytemuck::bytes_of(&contact.clip_from_world())),
        }
    }

    /// Writes the frame, the camera's view and where the shadow map looks.
    pub fn write(&self, queue: &wgpu::Queue, frame: &FrameUniform, clip_from_world: &Mat4, shadow: &ShadowView) {
        for (view, matrix) in self.light.iter().zip([shadow.fine(), shadow.coarse()]) {
            queue.write_buffer(&view.buffer, 0, bytemuck::bytes_of(&matrix));
        }
        queue.write_buffer(&self.frame.buffer, 0, bytemuck::bytes_of(frame));
        queue.write_buffer(&self.camera.buffer, 0, bytemuck::bytes_of(clip_from_world));
    }

    /// Bind group of the frame.
    pub fn frame(&self) -> &wgpu::BindGroup {
        &self.frame.group
    }

    /// Bind group of the camera's view.
    pub fn camera(&self) -> &wgpu::BindGroup {
        &self.camera.group
    }

    /// Bind groups of the views of the light that casts shadows: fine and coarse.
    pub fn light(&self) -> [&wgpu::BindGroup; 2] {
        self.light.each_ref().map(|view| &view.group)
    }

    /// Bind group of the view of the contact map.
    pub fn contact(&self) -> &wgpu::BindGroup {
        &self.contact.group
    }
}

/// A uniform buffer with its bind group.
struct Uniform {
    buffer: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl Uniform {
    fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, contents: &[u8]) -> Self {
        let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("uniform"),
            contents,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("uniform"),
            layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
        });
        Self { buffer, group }
    }
}
