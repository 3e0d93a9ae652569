//! Draws the scene into a texture of its own.

use std::collections::BTreeMap;
use std::sync::Arc;

use wgpu::util::DeviceExt;

use crate::gpu::dirty::DirtyRect;
use crate::gpu::foods::{Foods, Moved};
use crate::gpu::passes::{self, Groups, Subject};
use crate::gpu::pipelines::{ColourPipelines, DepthPipelines, Detail, FlatPipelines, PipelineFactory};
use crate::gpu::shown::{Shown, Sight, Work};
use crate::gpu::solids::{MovableKey, Solids};
use crate::gpu::sprites::SpriteBuffers;
use crate::gpu::still::{Still, StillKey};
use crate::gpu::targets::Targets;
use crate::gpu::textures::SceneTextures;
use crate::gpu::uniforms::FrameUniform;
use crate::input::{Colouring, FilmPicture, SceneInput, TintPicture, ToolLook};
use crate::light::shadow::{ContactMap, light_from_world};
use crate::quality::Quality;

pub use crate::gpu::passes::FLAT_BACKGROUND;

/// Draws scenes. Pictures of one renderer must be submitted one after another: they share its buffers.
pub struct SceneRenderer {
    /// How much work a picture is worth.
    pub quality: Quality,
    factory: PipelineFactory,
    textures: SceneTextures,
    depth: DepthPipelines,
    restore: wgpu::RenderPipeline,
    /// Made when they are first needed.
    colour: BTreeMap<Detail, ColourPipelines>,
    flat: Option<FlatPipelines>,
    frame: Uniform,
    camera_view: Uniform,
    light_view: Uniform,
    contact_view: Uniform,
    contact: ContactMap,
    solids: Option<Solids>,
    foods: Foods,
    sprites: SpriteBuffers,
    shown: Shown,
    targets: Targets,
    still: Option<Still>,
    /// The frame as it is now but for the time.
    timeless: FrameUniform,
    /// That of the kept picture with the foods; none where it does not stand.
    lively: Option<FrameUniform>,
    /// What moves covers this in the new frame, and covered that in the picture as it stands.
    dirty: Touched,
    drawn: Touched,
    moved: Moved,
    /// Counts the moves of foods that pan wall and board show.
    disturbances: u64,
    shadow_of: Option<Casting>,
    table: Option<Arc<[[u8; 3]; 256]>>,
    film: Option<Arc<FilmPicture>>,
    tint: Option<Arc<TintPicture>>,
}

/// What is drawn anew covers this much.
#[derive(Clone, Copy, Debug)]
struct Touched {
    /// Foods, the pan's floor, the tool.
    lively: DirtyRect,
    /// Steam and what lies round frying foods.
    sprites: DirtyRect,
}

impl Touched {
    const WHOLE: Self = Self { lively: DirtyRect::WHOLE, sprites: DirtyRect::WHOLE };
}

/// What besides the foods casts a shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Casting {
    movable: MovableKey,
    tool: Option<ToolLook>,
    lidded: bool,
}

impl Casting {
    fn of(input: &SceneInput) -> Self {
        Self { movable: MovableKey::of(input), tool: input.tool, lidded: input.pan.lid.is_some() }
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

impl SceneRenderer {
    /// Compiles the shaders and generates the textures.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let quality = Quality::default();
        let textures = SceneTextures::new(device, queue, quality);
        let factory = PipelineFactory::new(device, &textures.layout);
        let contact = ContactMap::default();
        let uniform = |contents: &[u8]| Uniform::new(device, &factory.layouts.frame, contents);
        let frame = uniform(&[0; size_of::<FrameUniform>()]);
        let camera_view = uniform(&[0; 64]);
        let light_view = uniform(bytemuck::bytes_of(&light_from_world()));
        let contact_view = uniform(bytemuck::bytes_of(&contact.clip_from_world()));
        Self {
            quality,
            depth: factory.depth(device),
            restore: factory.restore(device),
            colour: BTreeMap::new(),
            flat: None,
            targets: Targets::new(device, [16, 16], &factory.layouts.restore),
            textures,
            factory,
            frame,
            camera_view,
            light_view,
            contact_view,
            contact,
            solids: None,
            foods: Foods::default(),
            sprites: SpriteBuffers::new(device),
            shown: Shown::default(),
            still: None,
            timeless: bytemuck::Zeroable::zeroed(),
            lively: None,
            dirty: Touched::WHOLE,
            drawn: Touched::WHOLE,
            moved: Moved::default(),
            disturbances: 0,
            shadow_of: None,
            table: None,
            film: None,
            tint: None,
        }
    }

    /// The finished picture: sRGB-encoded values in a format without sRGB.
    pub fn color_view(&self) -> &wgpu::TextureView {
        &self.targets.picture.colour
    }

    /// Size of the finished picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.targets.size
    }

    /// Leaves resting pictures as they are, however slow the machine.
    #[cfg(test)]
    pub(crate) fn never_smooth(&mut self) {
        self.shown.rest = web_time::Duration::MAX;
    }

    pub(crate) fn picture(&self) -> &wgpu::Texture {
        &self.targets.texture
    }

    /// Draws a scene; `color_view` shows it once the encoder's commands are submitted.
    pub fn render(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        input: &SceneInput,
        size: [u32; 2],
    ) {
        let limit = device.limits().max_texture_dimension_2d;
        let size = size.map(|side| side.clamp(1, limit));
        let (sight, changed) = self.prepare(device, queue, input, size);
        let key = StillKey::new(input, size, self.disturbances);
        let settled = input.mirror.is_some() || self.still.as_ref().is_some_and(|still| still.is_best_for(&key));
        let work = self.shown.work(sight, changed, settled);
        if work == Work::Nothing {
            return;
        }
        if input.flat {
            self.draw_flat(device, encoder);
            return;
        }
        self.update_shadow(encoder, input);
        if let Some(mirror) = input.mirror {
            let smooth = self.quality != Quality::Quick || work == Work::Smooth;
            self.draw_mirror(device, encoder, mirror.pan_shown, smooth);
        } else if self.quality != Quality::Quick || work == Work::Smooth {
            self.draw_fine(device, encoder);
        } else {
            self.draw_fast(device, encoder, key, size);
        }
    }

    /// Brings buffers and targets up to date; tells what is to be seen, and whether foods or targets changed.
    fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
    ) -> (Sight, bool) {
        let resized = self.targets.size != size;
        if resized {
            self.targets = Targets::new(device, size, &self.factory.layouts.restore);
            self.still = None;
            self.lively = None;
        }
        if self.textures.set_quality(device, queue, self.quality) {
            self.shadow_of = None;
        }
        let pulled = self.solids.as_ref().is_some_and(|solids| !solids.shows(&input.strings));
        match &mut self.solids {
            Some(solids) => solids.update(device, queue, input),
            None => self.solids.insert(Solids::new(device, input)).update(device, queue, input),
        }
        let coloured = self.update_table(device, queue, &input.colouring)
            | self.update_film(queue, &input.pan.film)
            | self.update_tint(queue, &input.pan.tint);
        let spots = self.sprites.update_spots(queue, input);
        let aspect = size[0] as f32 / size[1] as f32;
        let frame = FrameUniform::new(input, aspect, self.quality, &self.contact);
        self.timeless = frame.timeless();
        queue.write_buffer(&self.frame.buffer, 0, bytemuck::bytes_of(&frame));
        let view = input.view_projection(aspect);
        queue.write_buffer(&self.camera_view.buffer, 0, bytemuck::bytes_of(&view));
        self.moved = self.foods.update(device, queue, &self.factory.layouts, &input.foods);
        self.foods.sort(&input.foods, input.eye());
        if self.moved.shadow {
            self.shadow_of = None;
        }
        self.disturbances += u64::from(self.moved.still);
        let sprites = self.sprites.update(queue, input);
        self.dirty.sprites = DirtyRect::of_sprites(input, &sprites, size);
        let pan_moved = self.shadow_of != Some(Casting::of(input));
        let changed = resized || coloured || !spots.is_empty() || pan_moved || pulled || self.moved.look;
        // What is kept stands as long as only time has passed: oil and water ripple when the state is read anew.
        let same = |kept: &FrameUniform| bytemuck::bytes_of(kept) == bytemuck::bytes_of(&self.timeless);
        if changed || !self.lively.as_ref().is_some_and(same) {
            self.lively = None;
            let tool: Vec<_> = self.solids.iter().flat_map(Solids::moving_points).collect();
            // Spots that were there before stay in the kept picture.
            self.dirty.lively =
                DirtyRect::of_lively(input, &tool, size).union(DirtyRect::of_spots(input, &spots, size));
        }
        let sight = Sight { frame, sprites, quality: self.quality };
        (sight, changed)
    }

    /// Takes another colour table; tells whether it is another.
    fn update_table(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, colouring: &Colouring) -> bool {
        let Colouring::Field { table, classes } = colouring else {
            return false;
        };
        let same = self.table.as_ref().is_some_and(|old| Arc::ptr_eq(old, table));
        let other = !same || classes.is_some() != self.textures.stepped();
        if other {
            self.textures.set_table(device, queue, table, classes.as_deref());
            self.table = Some(table.clone());
        }
        other
    }

    /// Takes another picture of the pan's floor; tells whether it is another.
    fn update_film(&mut self, queue: &wgpu::Queue, film: &Arc<FilmPicture>) -> bool {
        let same = self.film.as_ref().is_some_and(|old| Arc::ptr_eq(old, film));
        if !same {
            self.textures.set_film(queue, &film.texels);
            self.film = Some(Arc::clone(film));
        }
        !same
    }

    /// Takes another picture of what heat has done to the pan's colour, which its wall shows too; tells whether it is another.
    fn update_tint(&mut self, queue: &wgpu::Queue, tint: &Arc<TintPicture>) -> bool {
        let same = self.tint.as_ref().is_some_and(|old| Arc::ptr_eq(old, tint) || old == tint);
        if !same {
            self.textures.set_tint(queue, &tint.texels);
            self.tint = Some(Arc::clone(tint));
            self.disturbances += 1;
        }
        !same
    }

    /// Redraws shadow and contact map when something moved.
    fn update_shadow(&mut self, encoder: &mut wgpu::CommandEncoder, input: &SceneInput) {
        let Some(solids) = &self.solids else { return };
        let solid = Casting::of(input);
        if self.shadow_of == Some(solid) {
            return;
        }
        let mut pass = passes::begin_depth(encoder, &self.textures.shadow_map);
        passes::draw_shadow(&mut pass, &self.depth, &self.light_view.group, solids, &self.foods);
        drop(pass);
        let mut pass = passes::begin_depth(encoder, &self.textures.contact_map);
        passes::draw_food_depth(&mut pass, &self.depth, &self.contact_view.group, &self.foods);
        drop(pass);
        self.shadow_of = Some(solid);
    }

    fn draw_flat(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let pipelines = self.flat.get_or_insert_with(|| self.factory.flat(device));
        let Some(solids) = &self.solids else { return };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        let mut pass = passes::begin(encoder, &self.targets.picture.attachments(), Some(FLAT_BACKGROUND));
        passes::draw_flat(&mut pass, pipelines, &groups, solids, &self.foods);
        drop(pass);
        self.lively = None;
        self.drawn = Touched::WHOLE;
    }

    /// What a half mirror can show, at once: nothing of it is worth keeping, for there is no room.
    fn draw_mirror(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, pan: bool, smooth: bool) {
        let detail = match (self.quality, smooth) {
            (Quality::Best, _) => Detail::Best,
            (_, true) => Detail::Fine,
            _ => Detail::Usual,
        };
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, self.foods.textures());
        self.factory.occlude(device, pipelines);
        let Some(solids) = &self.solids else { return };
        if smooth {
            self.targets.msaa(device);
        }
        let picture = &self.targets.picture;
        let to = if smooth { self.targets.multisampled(picture) } else { picture.attachments() };
        let subject = Subject { solids, foods: &self.foods, sprites: &self.sprites };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        passes::draw_mirror(encoder, &to, pipelines, &groups, &subject, pan);
        self.still = None;
        self.lively = None;
        self.drawn = Touched::WHOLE;
    }

    fn draw_fine(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let detail = if self.quality == Quality::Best { Detail::Best } else { Detail::Fine };
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, self.foods.textures());
        let Some(solids) = &self.solids else { return };
        self.targets.msaa(device);
        let to = self.targets.multisampled(&self.targets.picture);
        let subject = Subject { solids, foods: &self.foods, sprites: &self.sprites };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        passes::draw_whole(encoder, &to, pipelines, &groups, &subject);
        self.lively = None;
        self.drawn = Touched::WHOLE;
    }

    fn draw_fast(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey, size: [u32; 2]) {
        match self.still_step(&key) {
            StillStep::Skip => return self.draw_direct(device, encoder, key),
            StillStep::Refine => self.refine_still(device, encoder, key),
            StillStep::Keep => {}
        }
        let detail = Detail::Usual;
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, self.foods.textures());
        let Some(solids) = &self.solids else { return };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        let mut touched = self.dirty.sprites.union(self.drawn.sprites);
        if self.lively.is_none() {
            let lively = self.dirty.lively.union(self.drawn.lively);
            let to = self.targets.lively.layer.attachments();
            let mut pass =
                passes::begin_restored(encoder, &self.restore, &to, &self.targets.still, lively.scissor(size));
            passes::draw_lively(&mut pass, pipelines, &groups, solids, &self.foods);
            passes::draw_spots(&mut pass, pipelines, &self.sprites);
            touched = touched.union(lively);
        }
        let to = self.targets.picture.attachments();
        let mut pass = passes::begin_restored(encoder, &self.restore, &to, &self.targets.lively, touched.scissor(size));
        passes::draw_veils(&mut pass, pipelines, &groups, solids, &self.foods, &self.sprites);
        drop(pass);
        self.lively = Some(self.timeless);
        self.drawn = self.dirty;
    }

    fn still_step(&self, key: &StillKey) -> StillStep {
        match &self.still {
            Some(still) if still.is_best_for(key) => StillStep::Keep,
            // A food in motion: its shadow on wall and board may lag until it rests.
            Some(still) if still.key.same_view(key) && self.moved.shadow && still.drawn => StillStep::Keep,
            Some(still) if still.key.same_view(key) && !self.moved.shadow => StillStep::Refine,
            _ => StillStep::Skip,
        }
    }

    /// While the eye moves nothing is worth keeping: everything is drawn at once with one sample a pixel.
    fn draw_direct(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey) {
        let detail = Detail::Usual;
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        self.factory.stock(device, pipelines, self.foods.textures());
        let Some(solids) = &self.solids else { return };
        let to = self.targets.picture.attachments();
        let subject = Subject { solids, foods: &self.foods, sprites: &self.sprites };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        passes::draw_whole(encoder, &to, pipelines, &groups, &subject);
        self.still = Some(Still { key, drawn: false });
        self.lively = None;
        self.drawn = Touched::WHOLE;
    }

    /// Draws the still things smoothly, as soon as they rest.
    fn refine_still(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey) {
        let detail = Detail::Fine;
        let pipelines = self.colour.entry(detail).or_insert_with(|| self.factory.colour(device, detail));
        let Some(solids) = &self.solids else { return };
        let groups = Groups { frame: &self.frame.group, textures: &self.textures.bind_group };
        self.targets.msaa(device);
        let mut pass =
            passes::begin(encoder, &self.targets.multisampled(&self.targets.still.layer), Some(FLAT_BACKGROUND));
        passes::draw_still(&mut pass, pipelines, &groups, solids, true);
        drop(pass);
        let mut pass = passes::begin_depth(encoder, &self.targets.still.layer.depth);
        passes::draw_still_depth(&mut pass, &self.depth, &self.camera_view.group, solids);
        drop(pass);
        self.still = Some(Still { key, drawn: true });
        self.lively = None;
        self.drawn = Touched::WHOLE;
    }
}

/// What to do about the kept picture of the still things.
enum StillStep {
    Keep,
    Refine,
    Skip,
}
