//! Read-back: pictures as bytes, for stills and tests.

use std::ops::Range;

use crate::gpu::post::bloom_levels;
use crate::input::{SceneInput, Tile};
use crate::quality::Quality;
use crate::renderer::SceneRenderer;

/// Longest side that is drawn at once [pixels] (chosen: half a gigabyte of targets at the best level).
const LARGEST: u32 = 2560;

/// Overlap of tiles at the best level, and the grid on which they begin [pixels], for a height of the whole picture: the
/// bloom of a glint in the next tile reaches into this one, and its levels must be placed as in the whole.
fn overlap(height: u32) -> [u32; 2] {
    let grid = 1 << bloom_levels(height);
    [3 * grid, grid]
}

/// A tile along one side of the picture [pixels].
#[derive(Clone, Debug, PartialEq)]
struct Span {
    from: u32,
    length: u32,
    /// What is kept of it, in the whole picture.
    kept: Range<u32>,
}

/// Tiles along a side, no longer than `largest` each where overlap and grid leave room for that.
fn spans(side: u32, largest: u32, [overlap, grid]: [u32; 2]) -> Vec<Span> {
    if side <= largest {
        return vec![Span { from: 0, length: side, kept: 0..side }];
    }
    let core = (largest.saturating_sub(2 * overlap) / grid * grid).max(grid);
    let tile = |start: u32| {
        let (from, end) = (start.saturating_sub(overlap), (start + core).min(side));
        Span { from, length: (end + overlap).min(side) - from, kept: start..end }
    };
    (0..side).step_by(core as usize).map(tile).collect()
}

impl SceneRenderer {
    /// Draws a scene at a quality and reads it back: tight RGBA8 rows from the top, sRGB-encoded, opaque. What is larger
    /// than the device draws at once is drawn in tiles. Waits for the device, so it is of no use in a browser.
    pub fn render_to_image(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
        quality: Quality,
    ) -> Vec<u8> {
        let largest = device.limits().max_texture_dimension_2d.min(LARGEST);
        self.render_in_tiles(device, queue, input, size, quality, largest)
    }

    /// As `render_to_image`, with no side drawn at once longer than `largest` [pixels].
    pub fn render_in_tiles(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
        quality: Quality,
        largest: u32,
    ) -> Vec<u8> {
        if input.tile.is_some() || size.iter().all(|side| *side <= largest) {
            return self.render_at_once(device, queue, input, size, quality);
        }
        let overlap = if quality == Quality::Best { overlap(size[1]) } else { [8, 8] };
        let [columns, rows] = size.map(|side| spans(side, largest, overlap));
        let mut whole = vec![0; 4 * (size[0] * size[1]) as usize];
        for (down, across) in rows.iter().flat_map(|down| columns.iter().map(move |across| (down, across))) {
            let tile = Tile { whole: size, origin: [across.from, down.from], size: [across.length, down.length] };
            let input = SceneInput { tile: Some(tile), ..input.clone() };
            let part = self.render_at_once(device, queue, &input, tile.size, quality);
            let width = 4 * (across.kept.end - across.kept.start) as usize;
            for row in down.kept.clone() {
                let from = 4 * ((row - down.from) * across.length + across.kept.start - across.from) as usize;
                let to = 4 * (row * size[0] + across.kept.start) as usize;
                whole[to..to + width].copy_from_slice(&part[from..from + width]);
            }
        }
        whole
    }

    fn render_at_once(
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
        if self.gather(device, queue, input, size) {
            pixels = self.read_as_is(device, queue, input, size);
        }
        if quality == Quality::Quick {
            // What does not move gets its patterns and smooth edges in the second frame.
            pixels = self.read_as_is(device, queue, input, size);
        }
        self.set_quality(before);
        pixels
    }

    /// Draws the samples of a picture that gathers light; returns true if there were any.
    fn gather(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, input: &SceneInput, size: [u32; 2]) -> bool {
        let mut drawn = false;
        while self.has_samples_left() {
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("sample") });
            self.render(device, queue, &mut encoder, input, size);
            queue.submit([encoder.finish()]);
            // A lost device draws nothing more, and says so when it is read.
            let _ = device.poll(wgpu::PollType::wait_indefinitely());
            drawn = true;
        }
        drawn
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_a_side_once_and_are_no_longer_than_allowed() {
        for (side, largest, overlap) in [(3840, 2048, [384, 128]), (2160, 2560, [384, 128]), (641, 200, [8, 8])] {
            let tiles = spans(side, largest, overlap);
            assert!(tiles.iter().all(|t| t.length <= largest && t.from % overlap[1] == 0), "{tiles:?}");
            let ends = tiles.iter().fold(0, |end, t| if t.kept.start == end { t.kept.end } else { u32::MAX });
            assert_eq!(ends, side, "{tiles:?}");
        }
    }
}
