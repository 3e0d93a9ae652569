//! Buffers of what does not deform.

use glam::{Mat4, Vec3};
use wgpu::util::DeviceExt;

use super::input::{RestLook, SceneInput};
use super::mesh::Mesh;
use super::pan_mesh::pan_mesh;
use super::props::{self, CLOTH_PLACE, COUNTER_Z};
use super::rest_mesh::rest_mesh;

/// A mesh in buffers.
pub(super) struct SolidBuffers {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    count: u32,
}

impl SolidBuffers {
    pub fn new(device: &wgpu::Device, mesh: &Mesh) -> Self {
        let buffer = |contents, usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: Some("solid"), contents, usage })
        };
        Self {
            vertices: buffer(bytemuck::cast_slice(&mesh.vertices), wgpu::BufferUsages::VERTEX),
            indices: buffer(bytemuck::cast_slice(&mesh.indices), wgpu::BufferUsages::INDEX),
            count: mesh.indices.len() as u32,
        }
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.count, 0, 0..1);
    }
}

/// Shape, finish and place of the pan and of what food rests on, compared to know when to rebuild them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MovableKey {
    shape: [f32; 4],
    colour: Vec3,
    finish: [f32; 2],
    position: Vec3,
    on_cloth: bool,
    rest: Option<RestLook>,
}

impl MovableKey {
    pub fn of(input: &SceneInput) -> Self {
        let pan = &input.pan;
        Self {
            shape: [pan.floor_radius, pan.rim_radius, pan.rim_height, pan.thickness],
            colour: pan.colour,
            finish: [pan.metalness, pan.roughness],
            position: pan.position,
            on_cloth: pan.on_cloth,
            rest: input.rest,
        }
    }
}

/// All fixed things.
pub(super) struct Solids {
    pub room: SolidBuffers,
    pub surroundings: SolidBuffers,
    pub board: SolidBuffers,
    pub hob: SolidBuffers,
    pub cloth: SolidBuffers,
    pub pan_body: SolidBuffers,
    pub pan_floor: SolidBuffers,
    pub pan: MovableKey,
}

impl Solids {
    pub fn new(device: &wgpu::Device, input: &SceneInput) -> Self {
        let [cloth, pan_body, pan_floor] = movable(device, input);
        Self {
            room: SolidBuffers::new(device, &props::room()),
            surroundings: SolidBuffers::new(device, &props::surroundings()),
            board: SolidBuffers::new(device, &props::board()),
            hob: SolidBuffers::new(device, &props::hob()),
            cloth,
            pan_body,
            pan_floor,
            pan: MovableKey::of(input),
        }
    }

    /// Rebuilds what may move, when it did.
    pub fn update(&mut self, device: &wgpu::Device, input: &SceneInput) {
        let key = MovableKey::of(input);
        if key != self.pan {
            [self.cloth, self.pan_body, self.pan_floor] = movable(device, input);
            self.pan = key;
        }
    }
}

/// Cloth (with rack or foil), body and floor of the pan where they stand.
fn movable(device: &wgpu::Device, input: &SceneInput) -> [SolidBuffers; 3] {
    let pan = &input.pan;
    let mut meshes = pan_mesh(pan);
    let pose = Mat4::from_translation(pan.position);
    meshes.body.transform_from(0, pose);
    meshes.floor.transform_from(0, pose);
    let mut cloth = props::cloth();
    let place = if pan.on_cloth { pan.position } else { CLOTH_PLACE };
    cloth.transform_from(0, Mat4::from_translation(Vec3::new(place.x, place.y, COUNTER_Z)));
    if let Some(rest) = &input.rest {
        rest_mesh(&mut cloth, rest);
    }
    [&cloth, &meshes.body, &meshes.floor].map(|mesh| SolidBuffers::new(device, mesh))
}
