//! Buffers of what does not deform.

use glam::{Mat4, Quat, Vec3};
use wgpu::util::DeviceExt;

use super::input::{RestLook, SceneInput, ToolKind, ToolLook};
use super::mesh::Mesh;
use super::pan_mesh::pan_mesh;
use super::props::{self, CLOTH_PLACE, COUNTER_Z};
use super::rest_mesh::rest_mesh;
use super::tool_mesh::tool_mesh;

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
            vertices: buffer(
                bytemuck::cast_slice(&mesh.vertices),
                wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            ),
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

/// What the pan is made like, compared to know when to build it anew.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PanKey {
    shape: [f32; 4],
    colour: Vec3,
    finish: [f32; 2],
}

/// The pan with its place, and what else moves now and then, compared to know when to draw them anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MovableKey {
    pan: PanKey,
    position: Vec3,
    rotation: Quat,
    on_cloth: bool,
    rest: Option<RestLook>,
    turner_in_hand: bool,
}

impl MovableKey {
    pub fn of(input: &SceneInput) -> Self {
        let pan = &input.pan;
        Self {
            pan: PanKey {
                shape: [pan.floor_radius, pan.rim_radius, pan.rim_height, pan.thickness],
                colour: pan.colour,
                finish: [pan.metalness, pan.roughness],
            },
            position: pan.position,
            rotation: pan.rotation,
            on_cloth: pan.on_cloth,
            rest: input.rest,
            turner_in_hand: input.tool.is_some_and(|tool| tool.kind == ToolKind::Turner),
        }
    }

    /// What cloth and rest depend on.
    fn cloth(&self) -> (Option<Vec3>, Option<RestLook>) {
        (self.on_cloth.then_some(self.position), self.rest)
    }
}

/// A mesh that keeps its shape and moves.
struct Posed {
    local: Mesh,
    buffers: SolidBuffers,
}

impl Posed {
    fn new(device: &wgpu::Device, local: Mesh, pose: Mat4) -> Self {
        let buffers = SolidBuffers::new(device, &local.posed(pose));
        Self { local, buffers }
    }

    fn place(&self, queue: &wgpu::Queue, pose: Mat4) {
        let vertices = self.local.posed(pose).vertices;
        queue.write_buffer(&self.buffers.vertices, 0, bytemuck::cast_slice(&vertices));
    }
}

/// All solid things.
pub(super) struct Solids {
    pub room: SolidBuffers,
    pub surroundings: SolidBuffers,
    pub board: SolidBuffers,
    pub hob: SolidBuffers,
    pub cloth: SolidBuffers,
    turner: SolidBuffers,
    pan_body: Posed,
    pan_floor: Posed,
    tool: Option<(ToolLook, Mesh, SolidBuffers)>,
    key: MovableKey,
}

impl Solids {
    pub fn new(device: &wgpu::Device, input: &SceneInput) -> Self {
        let [pan_body, pan_floor] = pan(device, input);
        Self {
            room: SolidBuffers::new(device, &props::room()),
            surroundings: SolidBuffers::new(device, &props::surroundings()),
            board: SolidBuffers::new(device, &props::board()),
            hob: SolidBuffers::new(device, &props::hob()),
            cloth: cloth(device, input),
            turner: SolidBuffers::new(device, &props::turner()),
            pan_body,
            pan_floor,
            tool: None,
            key: MovableKey::of(input),
        }
    }

    /// Moves what has moved, and builds anew what has changed.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, input: &SceneInput) {
        let key = MovableKey::of(input);
        if key.pan != self.key.pan {
            [self.pan_body, self.pan_floor] = pan(device, input);
        } else if (key.position, key.rotation) != (self.key.position, self.key.rotation) {
            let pose = input.pan.world_from_pan();
            self.pan_body.place(queue, pose);
            self.pan_floor.place(queue, pose);
        }
        if key.cloth() != self.key.cloth() {
            self.cloth = cloth(device, input);
        }
        self.key = key;
        if self.tool.as_ref().map(|(look, ..)| *look) != input.tool {
            self.tool = input.tool.map(|look| {
                let mesh = tool_mesh(&look);
                let buffers = SolidBuffers::new(device, &mesh);
                (look, mesh, buffers)
            });
        }
    }

    pub fn pan_body(&self) -> &SolidBuffers {
        &self.pan_body.buffers
    }

    pub fn pan_floor(&self) -> &SolidBuffers {
        &self.pan_floor.buffers
    }

    /// The tool in the cook's hand.
    pub fn tool(&self) -> Option<&SolidBuffers> {
        self.tool.as_ref().map(|(.., buffers)| buffers)
    }

    /// Where the tool in the hand is to be seen [m].
    pub fn tool_points(&self) -> impl Iterator<Item = Vec3> {
        self.tool.iter().flat_map(|(_, mesh, _)| mesh.vertices.iter().map(|v| Vec3::from(v.position)))
    }

    /// The turner behind the hob, while no hand holds it.
    pub fn turner(&self) -> Option<&SolidBuffers> {
        (!self.key.turner_in_hand).then_some(&self.turner)
    }
}

/// Body and floor of the pan where it stands.
fn pan(device: &wgpu::Device, input: &SceneInput) -> [Posed; 2] {
    let meshes = pan_mesh(&input.pan);
    [meshes.body, meshes.floor].map(|mesh| Posed::new(device, mesh, input.pan.world_from_pan()))
}

/// The cloth, with rack or foil.
fn cloth(device: &wgpu::Device, input: &SceneInput) -> SolidBuffers {
    let pan = &input.pan;
    let mut cloth = props::cloth();
    let place = if pan.on_cloth { pan.position } else { CLOTH_PLACE };
    cloth.transform_from(0, Mat4::from_translation(Vec3::new(place.x, place.y, COUNTER_Z)));
    if let Some(rest) = &input.rest {
        rest_mesh(&mut cloth, rest);
    }
    SolidBuffers::new(device, &cloth)
}
