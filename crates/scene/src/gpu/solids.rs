//! GPU buffers of rigid things: room, hob, pan, lid, tools.

use glam::{Mat4, Quat, Vec3};
use wgpu::util::DeviceExt;

use crate::input::{RestLook, SceneInput, StoveKind, ToolKind, ToolLook};
use crate::mesh::lid::lid_mesh;
use crate::mesh::pan::pan_mesh;
use crate::mesh::props::{self, CLOTH_PLACE, COUNTER_Z};
use crate::mesh::rest::rest_mesh;
use crate::mesh::solid::{Mesh, SolidVertex};
use crate::mesh::stove;
use crate::mesh::strings::{StringLook, string_mesh};
use crate::mesh::tool::tool_mesh;

/// A mesh in buffers.
pub(crate) struct SolidBuffers {
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

/// Properties of the pan's mesh; another value means that it must be rebuilt.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PanKey {
    shape: [f32; 4],
    colour: Vec3,
    finish: [f32; 2],
    ridges: Option<[f32; 3]>,
}

/// The pan with its pose, and whatever else moves now and then; another value means that they must be redrawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MovableKey {
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
                ridges: pan.ridges,
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
    /// With its present pose.
    posed: Vec<SolidVertex>,
    buffers: SolidBuffers,
}

impl Posed {
    fn new(device: &wgpu::Device, local: Mesh, pose: Mat4) -> Self {
        let posed = local.posed(pose);
        let buffers = SolidBuffers::new(device, &posed);
        Self { local, posed: posed.vertices, buffers }
    }

    fn place(&mut self, queue: &wgpu::Queue, pose: Mat4) {
        self.posed = self.local.posed(pose).vertices;
        queue.write_buffer(&self.buffers.vertices, 0, bytemuck::cast_slice(&self.posed));
    }
}

/// All solid things.
pub(crate) struct Solids {
    pub room: SolidBuffers,
    /// Kind of the stove, and the power at which it burns.
    stove: (StoveKind, f32),
    /// Flames of a burner; none without.
    flames: Option<SolidBuffers>,
    pub surroundings: SolidBuffers,
    pub board: SolidBuffers,
    pub hob: SolidBuffers,
    pub cloth: SolidBuffers,
    turner: SolidBuffers,
    pan_body: Posed,
    pan_floor: Posed,
    /// Glass and steel of the lid, while it is on.
    lid: Option<[Posed; 2]>,
    tool: Option<(ToolLook, Mesh, SolidBuffers)>,
    strings: Option<(Vec<StringLook>, SolidBuffers)>,
    key: MovableKey,
}

impl Solids {
    pub fn new(device: &wgpu::Device, input: &SceneInput) -> Self {
        let [pan_body, pan_floor] = pan(device, input);
        Self {
            room: SolidBuffers::new(device, &props::room(stove::hole(input.hob.kind))),
            stove: (input.hob.kind, input.hob.power),
            flames: flames(device, input),
            surroundings: SolidBuffers::new(device, &props::surroundings()),
            board: SolidBuffers::new(device, &props::board()),
            hob: SolidBuffers::new(device, &stove::stove(input.hob.kind)),
            cloth: cloth(device, input),
            turner: SolidBuffers::new(device, &props::turner()),
            pan_body,
            pan_floor,
            lid: lid(device, input),
            tool: None,
            strings: None,
            key: MovableKey::of(input),
        }
    }

    /// Moves what has moved, and rebuilds what has changed.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, input: &SceneInput) {
        let key = MovableKey::of(input);
        if key.pan != self.key.pan {
            [self.pan_body, self.pan_floor] = pan(device, input);
        } else if (key.position, key.rotation) != (self.key.position, self.key.rotation) {
            let pose = input.pan.world_from_pan();
            self.pan_body.place(queue, pose);
            self.pan_floor.place(queue, pose);
            self.lid.iter_mut().flatten().for_each(|part| part.place(queue, pose));
        }
        if key.pan != self.key.pan || self.lid.is_some() != input.pan.lid.is_some() {
            self.lid = lid(device, input);
        }
        if key.cloth() != self.key.cloth() {
            self.cloth = cloth(device, input);
        }
        self.key = key;
        self.change_stove(device, input);
        if !self.shows(&input.strings) {
            let mesh = (!input.strings.is_empty()).then(|| SolidBuffers::new(device, &string_mesh(&input.strings)));
            self.strings = mesh.map(|buffers| (input.strings.clone(), buffers));
        }
        if self.tool.as_ref().map(|(look, ..)| *look) != input.tool {
            self.tool = input.tool.map(|look| {
                let mesh = tool_mesh(&look);
                let buffers = SolidBuffers::new(device, &mesh);
                (look, mesh, buffers)
            });
        }
    }

    /// Sets another stove out, and lets flames grow with the power.
    fn change_stove(&mut self, device: &wgpu::Device, input: &SceneInput) {
        let stove = (input.hob.kind, input.hob.power);
        if stove.0 != self.stove.0 {
            self.room = SolidBuffers::new(device, &props::room(stove::hole(stove.0)));
            self.hob = SolidBuffers::new(device, &stove::stove(stove.0));
        }
        if stove != self.stove {
            self.flames = flames(device, input);
        }
        self.stove = stove;
    }

    /// The hob, unless it is a pale sheet just above the counter, on which the coarse shadow map would show.
    pub fn casting_hob(&self) -> Option<&SolidBuffers> {
        (self.stove.0 != StoveKind::Plate).then_some(&self.hob)
    }

    /// The flames of a burner.
    pub fn flames(&self) -> Option<&SolidBuffers> {
        self.flames.as_ref()
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

    /// The strings of a device.
    pub fn strings(&self) -> Option<&SolidBuffers> {
        self.strings.as_ref().map(|(_, buffers)| buffers)
    }

    /// Returns true if these strings are the ones in the buffers.
    pub fn shows(&self, strings: &[StringLook]) -> bool {
        self.strings.as_ref().map_or(&[][..], |(shown, _)| shown) == strings
    }

    /// The glass of the lid.
    pub fn lid_glass(&self) -> Option<&SolidBuffers> {
        self.lid.as_ref().map(|[glass, _]| &glass.buffers)
    }

    /// The steel of the lid.
    pub fn lid_steel(&self) -> Option<&SolidBuffers> {
        self.lid.as_ref().map(|[_, steel]| &steel.buffers)
    }

    /// Where the tool in the hand, the strings and the lid are to be seen [m].
    pub fn moving_points(&self) -> impl Iterator<Item = Vec3> {
        let place = |v: &SolidVertex| Vec3::from(v.position);
        let tool = self.tool.iter().flat_map(move |(_, mesh, _)| mesh.vertices.iter().map(place));
        let strings = self.strings.iter().flat_map(|(shown, _)| shown.iter().flat_map(|string| string.ends));
        tool.chain(strings).chain(self.lid.iter().flatten().flat_map(move |part| part.posed.iter().map(place)))
    }

    /// The turner behind the hob, while no hand holds it.
    pub fn turner(&self) -> Option<&SolidBuffers> {
        (!self.key.turner_in_hand).then_some(&self.turner)
    }
}

/// The flames of a burner that burns.
fn flames(device: &wgpu::Device, input: &SceneInput) -> Option<SolidBuffers> {
    let burns = input.hob.kind == StoveKind::Gas && input.hob.power > 0.0;
    burns.then(|| SolidBuffers::new(device, &stove::flames(input.hob.power)))
}

/// Body and floor of the pan at its place.
fn pan(device: &wgpu::Device, input: &SceneInput) -> [Posed; 2] {
    let meshes = pan_mesh(&input.pan);
    [meshes.body, meshes.floor].map(|mesh| Posed::new(device, mesh, input.pan.world_from_pan()))
}

/// Glass and steel of the lid at the place of the pan.
fn lid(device: &wgpu::Device, input: &SceneInput) -> Option<[Posed; 2]> {
    input.pan.lid?;
    Some(lid_mesh(&input.pan).map(|mesh| Posed::new(device, mesh, input.pan.world_from_pan())))
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
