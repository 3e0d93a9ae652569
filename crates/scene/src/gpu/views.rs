//! The uniform buffers of one renderer: the frame, and the views of camera, window light and contact map.

use glam::Mat4;
use wgpu::util::DeviceExt;

use crate::gpu::uniforms::FrameUniform;
use crate::light::shadow::{ContactMap, light_from_world};

/// Buffers with their bind groups.
pub(crate) struct Views {
    frame: Uniform,
    camera: Uniform,
    light: Uniform,
    contact: Uniform,
}

impl Views {
    /// `layout` is that of the frame's bind group.
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, contact: &ContactMap) -> Self {
        let uniform = |contents: &[u8]| Uniform::new(device, layout, contents);
        Self {
            frame: uniform(&[0; size_of::<FrameUniform>()]),
            camera: uniform(&[0; 64]),
            light: uniform(bytemuck::bytes_of(&light_from_world())),
            contact: uniform(bytemuck::bytes_of(&contact.clip_from_world())),
        }
    }

    /// Writes the frame and the camera's view.
    pub fn write(&self, queue: &wgpu::Queue, frame: &FrameUniform, clip_from_world: &Mat4) {
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

    /// Bind group of the view of the window's light.
    pub fn light(&self) -> &wgpu::BindGroup {
        &self.light.group
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
