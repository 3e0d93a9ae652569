//! GPU buffers of the sprites: bubbles around frying foods, pools of juice, drops in the air, steam, and spots of oil.

use std::ops::Range;
use std::sync::Arc;

use crate::input::{Colouring, SceneInput, SpotLook};
use crate::mesh::collar::{COLLAR_VERTICES_MAX, Collar};
use crate::mesh::pool::{POOL_VERTICES_MAX, pools};
use crate::mesh::spatter::{DROPS_MAX, SPOTS_MAX, drops, spots};
use crate::mesh::steam::{PUFFS_MAX, PuffVertex, puffs};

/// All sprites on the device.
pub(crate) struct SpriteBuffers {
    /// Collars round foods with the drops in the air, then pools, then steam.
    pub moving: wgpu::Buffer,
    /// Vertices of each of these.
    pub kinds: [Range<u32>; 3],
    /// Spots of oil, which do not move.
    pub spots: wgpu::Buffer,
    pub spot_vertices: u32,
    collar: Collar,
    /// What the spots were made for.
    spots_of: Arc<Vec<SpotLook>>,
}

impl SpriteBuffers {
    pub fn new(device: &wgpu::Device) -> Self {
        let room_for = |label, vertices: usize| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: (vertices * size_of::<PuffVertex>()) as u64,
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        Self {
            moving: room_for("sprites", (PUFFS_MAX + DROPS_MAX) * 6 + COLLAR_VERTICES_MAX + POOL_VERTICES_MAX),
            kinds: [0..0, 0..0, 0..0],
            spots: room_for("spots", SPOTS_MAX * 6),
            spot_vertices: 0,
            collar: Collar::default(),
            spots_of: Arc::default(),
        }
    }

    /// Steam, frying fat and drops in the air; none where they would falsify the colours of a field.
    pub fn update(&mut self, queue: &wgpu::Queue, input: &SceneInput) -> Vec<PuffVertex> {
        let kinds = if matches!(input.colouring, Colouring::Look) {
            let mut collars = self.collar.strips(input).to_vec();
            collars.extend(drops(input));
            [collars, pools(input), puffs(&input.steam, input.time_s)]
        } else {
            [const { Vec::new() }; 3]
        };
        let mut end = 0;
        self.kinds = kinds.each_ref().map(|kind| {
            let start = end;
            end += kind.len() as u32;
            start..end
        });
        let sprites = kinds.concat();
        queue.write_buffer(&self.moving, 0, bytemuck::cast_slice(&sprites));
        sprites
    }

    /// Takes other spots of oil in the same way; returns those that have come or gone.
    pub fn update_spots(&mut self, queue: &wgpu::Queue, input: &SceneInput) -> Vec<SpotLook> {
        let seen = matches!(input.colouring, Colouring::Look);
        let wanted = if seen { Arc::clone(&input.spatter.spots) } else { Arc::default() };
        if Arc::ptr_eq(&self.spots_of, &wanted) || self.spots_of == wanted {
            return Vec::new();
        }
        let sprites = spots(&wanted);
        queue.write_buffer(&self.spots, 0, bytemuck::cast_slice(&sprites));
        self.spot_vertices = sprites.len() as u32;
        let old = std::mem::replace(&mut self.spots_of, wanted);
        let same = old.iter().zip(self.spots_of.iter()).take_while(|(a, b)| a == b).count();
        [&old[same..], &self.spots_of[same..]].concat()
    }
}
