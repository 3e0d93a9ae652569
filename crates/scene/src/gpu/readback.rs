//! Read-back: pictures as bytes, for stills and tests.

use crate::input::SceneInput;
use crate::quality::Quality;
use crate::renderer::SceneRenderer;

impl SceneRenderer {
    /// Draws a scene at a quality and reads it back: tight RGBA8 rows from the top, sRGB-encoded, opaque. Waits for the
    /// device, so it is of no use in a browser.
    pub fn render_to_image(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
        quality: Quality,
    ) -> Vec<u8> {
        let before = self.quality();
        self.set_quality(quality);
        let mut pixels = self.read_as_is(device, queue, input, size);
        if quality == Quality::Quick {
            // What does not move gets its patterns and smooth edges in the second frame.
            pixels = self.read_as_is(device, queue, input, size);
        }
        self.set_quality(before);
        pixels
    }

    /// As `render_to_image`, at the quality that is set.
    pub fn read_as_is(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
    ) -> Vec<u8> {
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("still") });
        self.render(device, queue, &mut encoder, input, size);
        read_picture(device, queue, encoder, self.picture())
    }
}

/// Submits the commands and reads a texture of four bytes a pixel: tight rows from the top.
pub fn read_picture(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    mut encoder: wgpu::CommandEncoder,
    texture: &wgpu::Texture,
) -> Vec<u8> {
    let tight = texture.width() as usize * 4;
    let row = (texture.width() * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("still"),
        size: u64::from(row) * u64::from(texture.height()),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    let target = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), target, texture.size());
    queue.submit([encoder.finish()]);
    read(device, &buffer).chunks(row as usize).flat_map(|line| &line[..tight]).copied().collect()
}

/// Contents of a buffer once the device is done; zeros when the device is lost.
fn read(device: &wgpu::Device, buffer: &wgpu::Buffer) -> Vec<u8> {
    buffer.map_async(wgpu::MapMode::Read, .., |_| ());
    let done = device.poll(wgpu::PollType::wait_indefinitely()).is_ok();
    let bytes = done.then(|| buffer.get_mapped_range(..).ok()).flatten().map(|view| view.to_vec());
    bytes.unwrap_or_else(|| vec![0; buffer.size() as usize])
}
