//! GPU buffers of the foods: topology and marbling are cached by key, states are uploaded every frame.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{Vec3, Vec4};
use wgpu::util::DeviceExt;

use crate::gpu::clip::Parted;
use crate::gpu::pipelines::Layouts;
use crate::gpu::textures::sampled_texture_of;
use crate::gpu::uniforms::{FoodUniform, reciprocal};
use crate::input::{
    BORDER_RANGE, FleshTexture, FoodLook, FoodMesh, FoodVertex, GrainVolume, SearLook, SliceLook, WITHIN_RANGE,
};
use crate::mesh::stays::stays;

/// A shape that has moved by less than this still casts the same shadow [m].
const SHADOW_TOLERANCE: f32 = 3e-4;
/// A shape that has moved by less than this leaves the look of pan wall and board as it was [m].
const STILL_TOLERANCE: f32 = 2e-3;

/// What foods with the same mesh share.
struct MeshBuffers {
    indices: wgpu::Buffer,
    count: u32,
    grain: wgpu::TextureView,
    used: bool,
}

/// One food on the device.
pub(crate) struct FoodBuffers {
    key: u64,
    pub texture: FleshTexture,
    vertices: wgpu::Buffer,
    uniform: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
    pose_group: wgpu::BindGroup,
    indices: wgpu::Buffer,
    count: u32,
    cut: Option<CutBuffers>,
    /// What was uploaded.
    shown: Option<FoodLook>,
    /// World positions when the shadow map was drawn.
    shadowed: Vec<Vec3>,
    /// World positions when the still picture was drawn.
    stilled: Vec<Vec3>,
}

/// The cut face of a food, and its outside sorted by the side of the cut.
struct CutBuffers {
    vertices: wgpu::Buffer,
    face: Indices,
    /// Vertices of the outside, with those on the plane of the cut.
    outside: wgpu::Buffer,
    kept: Indices,
    hidden: Indices,
    /// True if a knife has halved it: then the hidden half is not drawn.
    parted: bool,
}

/// Triangles in a buffer.
struct Indices {
    buffer: wgpu::Buffer,
    count: u32,
}

impl Indices {
    fn new(device: &wgpu::Device, triangles: &[[u32; 3]]) -> Self {
        let buffer = buffer(device, bytemuck::cast_slice(triangles), wgpu::BufferUsages::INDEX);
        Self { buffer, count: triangles.len() as u32 * 3 }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if self.count > 0 {
            pass.set_index_buffer(self.buffer.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.count, 0, 0..1);
        }
    }
}

impl CutBuffers {
    fn new(device: &wgpu::Device, food: &FoodLook, slice: &SliceLook) -> Self {
        let parted = Parted::new(food, slice);
        Self {
            vertices: buffer(device, bytemuck::cast_slice(&slice.vertices), wgpu::BufferUsages::VERTEX),
            face: Indices::new(device, &slice.triangles),
            outside: buffer(device, bytemuck::cast_slice(&parted.vertices), wgpu::BufferUsages::VERTEX),
            kept: Indices::new(device, &parted.kept),
            hidden: Indices::new(device, if slice.ghost { &parted.hidden } else { &[] }),
            parted: !slice.ghost,
        }
    }
}

/// What a change of the foods makes stale.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Moved {
    /// Any state or pose, by as much as can be seen.
    pub look: bool,
    pub shadow: bool,
    pub still: bool,
}

/// All foods on the device, in the order of the input.
#[derive(Default)]
pub(crate) struct Foods {
    meshes: HashMap<u64, MeshBuffers>,
    pub slots: Vec<FoodBuffers>,
    /// Slots from the nearest to the farthest: what is hidden is then not shaded.
    order: Vec<usize>,
}

impl Foods {
    /// The foods, the nearest first.
    pub fn nearest_first(&self) -> impl Iterator<Item = &FoodBuffers> {
        self.order.iter().filter_map(|slot| self.slots.get(*slot))
    }

    /// What their flesh is made of.
    pub fn textures(&self) -> impl Iterator<Item = FleshTexture> {
        self.slots.iter().map(|slot| slot.texture)
    }

    /// Sorts the foods by their distance from the eye.
    pub fn sort(&mut self, foods: &[FoodLook], eye: Vec3) {
        let away = |slot: &usize| foods[*slot].world_from_rest.transform_point3(Vec3::ZERO).distance_squared(eye);
        self.order = (0..foods.len()).collect();
        self.order.sort_by(|a, b| away(a).total_cmp(&away(b)));
    }

    /// Uploads the states; returns what has moved far enough to be seen.
    pub fn update(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layouts: &Layouts,
        foods: &[FoodLook],
    ) -> Moved {
        let changed = self.slots.len() != foods.len();
        let mut moved = Moved { look: changed, shadow: changed, still: changed };
        self.slots.truncate(foods.len());
        self.meshes.values_mut().for_each(|mesh| mesh.used = false);
        for (index, food) in foods.iter().enumerate() {
            let mesh = self.meshes.entry(food.mesh.key).or_insert_with(|| MeshBuffers::new(device, queue, &food.mesh));
            mesh.used = true;
            let fits = self.slots.get(index).is_some_and(|slot| slot.fits(food));
            if !fits {
                let slot = FoodBuffers::new(device, layouts, mesh, food);
                self.slots.splice(index..(index + 1).min(self.slots.len()), [slot]);
            }
            let slot = &mut self.slots[index];
            if slot.shows(food) {
                continue;
            }
            moved.look = true;
            slot.update(device, queue, food);
            moved.shadow |= differs(food, &slot.shadowed, SHADOW_TOLERANCE);
            moved.still |= differs(food, &slot.stilled, STILL_TOLERANCE);
        }
        self.meshes.retain(|_, mesh| mesh.used);
        for (slot, food) in self.slots.iter_mut().zip(foods) {
            if moved.shadow {
                slot.shadowed = world_positions(food).collect();
            }
            if moved.still {
                slot.stilled = world_positions(food).collect();
            }
        }
        moved
    }
}

impl MeshBuffers {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, mesh: &FoodMesh) -> Self {
        Self {
            indices: buffer(device, bytemuck::cast_slice(&mesh.triangles), wgpu::BufferUsages::INDEX),
            count: mesh.triangles.len() as u32 * 3,
            grain: grain_texture(device, queue, &mesh.grain),
            used: true,
        }
    }
}

impl FoodBuffers {
    fn new(device: &wgpu::Device, layouts: &Layouts, mesh: &MeshBuffers, food: &FoodLook) -> Self {
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("food"),
            size: size_of::<FoodUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let whole = wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() };
        let grain = wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&mesh.grain) };
        let group = |layout, entries: &[wgpu::BindGroupEntry<'_>]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("food"), layout, entries })
        };
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Self {
            key: food.mesh.key,
            texture: food.mesh.texture,
            vertices: buffer(device, bytemuck::cast_slice(food.vertices.as_slice()), usage),
            bind_group: group(&layouts.food, &[whole.clone(), grain]),
            pose_group: group(&layouts.pose, &[whole]),
            uniform,
            indices: mesh.indices.clone(),
            count: mesh.count,
            cut: None,
            shown: None,
            shadowed: Vec::new(),
            stilled: Vec::new(),
        }
    }

    fn fits(&self, food: &FoodLook) -> bool {
        let bytes = std::mem::size_of_val(food.vertices.as_slice()) as u64;
        self.key == food.mesh.key && self.vertices.size() == bytes
    }

    fn shows(&self, food: &FoodLook) -> bool {
        self.shown.as_ref().is_some_and(|shown| {
            same_pose(shown, food) && same_vertices(shown, food) && shown.slice == food.slice && shown.sear == food.sear
        })
    }

    fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, food: &FoodLook) {
        if !self.shown.as_ref().is_some_and(|shown| same_vertices(shown, food)) {
            queue.write_buffer(&self.vertices, 0, bytemuck::cast_slice(food.vertices.as_slice()));
        }
        self.shown = Some(food.clone());
        queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(&uniform(food)));
        self.cut = food.slice.as_ref().map(|slice| CutBuffers::new(device, food, slice));
    }

    pub fn has_cut(&self) -> bool {
        self.cut.is_some()
    }

    /// Draws the outside, without what a cut hides; the pass has the frame and texture groups set.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(2, &self.bind_group, &[]);
        match &self.cut {
            Some(cut) => {
                pass.set_vertex_buffer(0, cut.outside.slice(..));
                cut.kept.draw(pass);
            }
            None => self.draw_shape(pass),
        }
    }

    /// Draws what a cut hides.
    pub fn draw_hidden(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(cut) = &self.cut else { return };
        pass.set_bind_group(2, &self.bind_group, &[]);
        pass.set_vertex_buffer(0, cut.outside.slice(..));
        cut.hidden.draw(pass);
    }

    /// Draws the cut face, if there is one.
    pub fn draw_cut(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(cut) = self.cut.as_ref().filter(|cut| cut.face.count > 0) else {
            return;
        };
        pass.set_bind_group(2, &self.bind_group, &[]);
        pass.set_vertex_buffer(0, cut.vertices.slice(..));
        cut.face.draw(pass);
    }

    /// Draws the shape into a depth map.
    pub fn draw_depth(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(1, &self.pose_group, &[]);
        let parted = self.cut.as_ref().is_some_and(|cut| cut.parted);
        if parted { self.draw_seen_depth(pass) } else { self.draw_shape(pass) }
    }

    /// Draws into a depth map what is seen of the shape: without what a cut hides.
    pub fn draw_seen_depth(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(1, &self.pose_group, &[]);
        match &self.cut {
            Some(cut) => {
                pass.set_vertex_buffer(0, cut.outside.slice(..));
                cut.kept.draw(pass);
                pass.set_vertex_buffer(0, cut.vertices.slice(..));
                cut.face.draw(pass);
            }
            None => self.draw_shape(pass),
        }
    }

    fn draw_shape(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.count, 0, 0..1);
    }
}

fn same_pose(a: &FoodLook, b: &FoodLook) -> bool {
    stays(&a.world_from_rest, &b.world_from_rest)
}

fn same_vertices(a: &FoodLook, b: &FoodLook) -> bool {
    Arc::ptr_eq(&a.vertices, &b.vertices) || a.vertices == b.vertices
}

/// True when some vertex is further than the tolerance from where it was.
fn differs(food: &FoodLook, before: &[Vec3], tolerance: f32) -> bool {
    before.len() != food.vertices.len() || !world_positions(food).zip(before).all(|(a, b)| a.abs_diff_eq(*b, tolerance))
}

/// World positions of a food's vertices.
pub(crate) fn world_positions(food: &FoodLook) -> impl Iterator<Item = Vec3> {
    food.vertices.iter().map(|vertex: &FoodVertex| food.world_from_rest.transform_point3(Vec3::from(vertex.position)))
}

fn uniform(food: &FoodLook) -> FoodUniform {
    let (grain, palette) = (&food.mesh.grain, &food.mesh.palette);
    let lab = |colour: [f32; 3], w: f32| (Vec3::from(colour) * 0.01).extend(w);
    FoodUniform {
        world_from_rest: food.world_from_rest,
        place: food.mesh.texture_place.extend(f32::from(food.mesh.grew_along_x)),
        grain_origin: grain.origin.extend(WITHIN_RANGE),
        grain_scale: reciprocal(grain.extent).extend(BORDER_RANGE),
        golden: lab(palette.golden, palette.golden_at.max(1e-3)),
        crust: lab(palette.crust, 0.0),
        char: lab(palette.char, 0.0),
        fat_brown: lab(palette.fat_brown, 0.0),
        second: lab(palette.second, 0.0),
        sear: food.sear.map(|face| face.map(|lines| lines.map_or([Vec4::ZERO; 3], seared))),
    }
}

/// A set of seared lines as the shader reads it.
fn seared(lines: SearLook) -> [Vec4; 3] {
    let [on, between] = lines.browning;
    [
        lines.direction.extend(lines.phase).extend(lines.pitch),
        Vec4::new(lines.width, lines.share, on, between),
        Vec4::new(lines.charring[0], lines.charring[1], 0.0, 0.0),
    ]
}

fn buffer(device: &wgpu::Device, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: Some("food"), contents, usage })
}

/// What grew in the flesh; a volume whose size is not the stated one is taken as even and lean.
fn grain_texture(device: &wgpu::Device, queue: &wgpu::Queue, grain: &GrainVolume) -> wgpu::TextureView {
    let limit = device.limits().max_texture_dimension_3d;
    let full = grain.size.iter().map(|&n| n as usize).product::<usize>() == grain.cells.len();
    let sound = full && grain.size.iter().all(|&n| n > 0 && n <= limit);
    let (size, cells) = if sound { (grain.size, grain.cells.as_slice()) } else { ([1; 3], [[0; 4]].as_slice()) };
    let format = wgpu::TextureFormat::Rgba8Unorm;
    sampled_texture_of(device, queue, size, 1, format, wgpu::TextureDimension::D3, bytemuck::cast_slice(cells))
}
