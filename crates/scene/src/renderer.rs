//! Draws the scene into its own texture.

use std::sync::Arc;

use crate::gpu::backdrop::{Backdrop, Blurred};
use crate::gpu::dirty::DirtyRect;
use crate::gpu::foods::{Foods, Moved};
use crate::gpu::history::{History, ShadowCasters, StillStep};
use crate::gpu::passes::{self, Groups, Subject};
use crate::gpu::pipeline_build::Detail;
use crate::gpu::pipeline_set::PipelineSet;
use crate::gpu::post::{LensUniform, PostKit};
use crate::gpu::shown::{Shown, ShownFrame, Work};
use crate::gpu::solids::Solids;
use crate::gpu::sprites::SpriteBuffers;
use crate::gpu::still::StillKey;
use crate::gpu::targets::Targets;
use crate::gpu::textures::SceneTextures;
use crate::gpu::uniforms::FrameUniform;
use crate::gpu::views::Views;
use crate::input::{Colouring, FilmPicture, SceneInput, StoveKind, TintPicture};
use crate::light::shadow::{ContactMap, ShadowView};
use crate::quality::Quality;
use crate::renderer::developed::Samples;

mod developed;

pub use self::developed::SampleProgress;
pub use crate::gpu::passes::FLAT_BACKGROUND;

/// Draws scenes. Pictures of one renderer must be submitted one after another: they share its buffers.
pub struct SceneRenderer {
    quality: Quality,
    pipelines: PipelineSet,
    textures: SceneTextures,
    views: Views,
    contents: Contents,
    pictures: Pictures,
    targets: Targets,
    shown: Shown,
    history: History,
    /// Made when the best level first needs it.
    post: Option<PostKit>,
    /// Made when another level first needs it.
    backdrop: Option<Backdrop>,
    /// True if the device can draw radiances in half floats: not OpenGL, whose pictures are those of WebGL2.
    half_floats: bool,
    samples: Samples,
}

/// Buffers of what is drawn.
struct Contents {
    contact: ContactMap,
    solids: Option<Solids>,
    foods: Foods,
    sprites: SpriteBuffers,
    /// What has moved of the foods since the last frame.
    moved: Moved,
}

/// Sources of the textures' present contents.
#[derive(Default)]
struct Pictures {
    table: Option<Arc<[[u8; 3]; 256]>>,
    film: Option<Arc<FilmPicture>>,
    tint: Option<Arc<TintPicture>>,
}

impl SceneRenderer {
    /// Compiles the shaders and generates the textures.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let quality = Quality::default();
        let textures = SceneTextures::new(device, queue, quality);
        let pipelines = PipelineSet::new(device, &textures.layout);
        let contact = ContactMap::default();
        let sprites = SpriteBuffers::new(device);
        Self {
            quality,
            views: Views::new(device, &pipelines.layouts().frame, &contact),
            targets: Targets::new(device, [16, 16], &pipelines.layouts().restore),
            pipelines,
            textures,
            contents: Contents { contact, solids: None, foods: Foods::default(), sprites, moved: Moved::default() },
            pictures: Pictures::default(),
            shown: Shown::default(),
            history: History::default(),
            post: None,
            backdrop: None,
            half_floats: device.adapter_info().backend != wgpu::Backend::Gl,
            samples: Samples::default(),
        }
    }

    /// The quality at which pictures are drawn.
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// Sets the quality at which the next pictures are drawn.
    pub fn set_quality(&mut self, quality: Quality) {
        self.quality = quality;
    }

    /// The finished picture: sRGB-encoded values in a format without sRGB.
    pub fn color_view(&self) -> &wgpu::TextureView {
        &self.targets.picture.colour
    }

    /// Size of the finished picture in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.targets.size
    }

    /// Sets how long a picture must rest before it is drawn once more with smooth edges: a third of a second unless set.
    pub fn set_rest(&mut self, rest: web_time::Duration) {
        self.shown.rest = rest;
    }

    /// Returns true if the last picture stays as it is while its scene does.
    pub fn is_final(&self) -> bool {
        self.shown.is_final() && self.samples.are_taken()
    }

    /// Draws the best level as devices without half floats do.
    #[cfg(test)]
    pub(crate) fn never_develop(&mut self) {
        self.half_floats = false;
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
        let key = StillKey::new(input, size, self.history.disturbances());
        let settled = input.mirror.is_some() || self.history.is_settled(&key);
        let work = self.shown.work(sight, changed, settled);
        if work == Work::Nothing {
            self.draw_next_sample(device, queue, encoder, input);
            return;
        }
        self.samples.begin(self.develops(input));
        if input.flat {
            self.draw_flat(device, encoder);
            return;
        }
        self.update_shadow(encoder, input);
        if let Some(mirror) = input.mirror {
            let smooth = self.quality != Quality::Quick || work == Work::Smooth;
            self.draw_mirror(device, encoder, mirror.pan_shown, smooth);
        } else if self.develops(input) {
            self.draw_developed(device, queue, encoder, input);
        } else {
            let backdrop = self.backdrop.get_or_insert_with(|| Backdrop::new(device));
            backdrop.write(queue, &LensUniform::on_target(input, size));
            if self.quality != Quality::Quick || work == Work::Smooth {
                self.draw_fine(device, encoder);
            } else {
                self.draw_fast(device, encoder, key, size);
            }
        }
    }

    /// Updates buffers and targets; returns what is seen, and true if foods or targets have changed.
    fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        input: &SceneInput,
        size: [u32; 2],
    ) -> (ShownFrame, bool) {
        let resized = self.targets.size != size;
        if resized {
            self.targets = Targets::new(device, size, &self.pipelines.layouts().restore);
            self.history.forget();
        }
        if self.textures.set_quality(device, queue, self.quality) {
            self.history.forget_shadow();
        }
        self.textures.set_light(device, queue, input.light);
        let pulled = self.contents.solids.as_ref().is_some_and(|solids| !solids.shows(&input.strings));
        match &mut self.contents.solids {
            Some(solids) => solids.update(device, queue, input),
            None => self.contents.solids.insert(Solids::new(device, input)).update(device, queue, input),
        }
        let coloured = self.update_table(device, queue, &input.colouring)
            | self.update_film(queue, &input.pan.film)
            | self.update_tint(queue, &input.pan.tint);
        let spots = self.contents.sprites.update_spots(queue, input);
        let aspect = size[0] as f32 / size[1] as f32;
        let frame = FrameUniform::new(input, aspect, self.quality, &self.contents.contact);
        self.views.write(queue, &frame, &input.view_projection(aspect), &ShadowView::of(input));
        self.update_foods(device, queue, input);
        let sprites = self.contents.sprites.update(queue, input);
        self.history.begin(frame.timeless(), DirtyRect::of_sprites(input, &sprites, size));
        let pan_moved = !self.history.casts(&ShadowCasters::of(input));
        let changed = resized || coloured || !spots.is_empty() || pan_moved || pulled || self.contents.moved.look;
        // Kept pictures hold as long as only time has passed: oil and water ripple when the state is read again.
        if changed || !self.history.shows_lively() {
            let tool: Vec<_> = self.contents.solids.iter().flat_map(Solids::moving_points).collect();
            // Spots that were there before stay in the kept picture.
            let dirty = DirtyRect::of_lively(input, &tool, size).union(DirtyRect::of_spots(input, &spots, size));
            self.history.change_lively(dirty);
        }
        let sight = ShownFrame { frame, sprites, quality: self.quality };
        (sight, changed)
    }

    fn update_foods(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, input: &SceneInput) {
        self.pipelines.burns = input.hob.kind == StoveKind::Gas;
        let Contents { foods, moved, .. } = &mut self.contents;
        *moved = foods.update(device, queue, self.pipelines.layouts(), &input.foods);
        foods.sort(&input.foods, input.eye());
        if moved.shadow {
            self.history.forget_shadow();
        }
        if moved.still {
            self.history.disturb();
        }
    }

    /// Updates the colour table; returns true if it has changed.
    fn update_table(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, colouring: &Colouring) -> bool {
        let Colouring::Field { table, classes } = colouring else {
            return false;
        };
        let same = self.pictures.table.as_ref().is_some_and(|old| Arc::ptr_eq(old, table));
        let other = !same || classes.is_some() != self.textures.stepped();
        if other {
            self.textures.set_table(device, queue, table, classes.as_deref());
            self.pictures.table = Some(table.clone());
        }
        other
    }

    /// Updates the picture of the pan's floor; returns true if it has changed.
    fn update_film(&mut self, queue: &wgpu::Queue, film: &Arc<FilmPicture>) -> bool {
        let same = self.pictures.film.as_ref().is_some_and(|old| Arc::ptr_eq(old, film));
        if !same {
            self.textures.set_film(queue, &film.texels);
            self.pictures.film = Some(Arc::clone(film));
        }
        !same
    }

    /// Updates the picture of the pan's heat tint, which its wall shows too; returns true if it has changed.
    fn update_tint(&mut self, queue: &wgpu::Queue, tint: &Arc<TintPicture>) -> bool {
        let same = self.pictures.tint.as_ref().is_some_and(|old| Arc::ptr_eq(old, tint) || old == tint);
        if !same {
            self.textures.set_tint(queue, &tint.texels);
            self.pictures.tint = Some(Arc::clone(tint));
            self.history.disturb();
        }
        !same
    }

    /// Redraws shadow and contact map when something moved.
    fn update_shadow(&mut self, encoder: &mut wgpu::CommandEncoder, input: &SceneInput) {
        let Some(solids) = &self.contents.solids else { return };
        let casters = ShadowCasters::of(input);
        if input.sample.is_none() && self.history.shows_shadow_of(&casters) {
            return;
        }
        let (depth, foods) = (self.pipelines.depth(), &self.contents.foods);
        let mut pass = passes::begin_depth(encoder, &self.textures.shadow_map);
        let size = self.quality.map_sizes()[0];
        passes::draw_shadows(&mut pass, depth, self.views.light(), size, solids, foods);
        drop(pass);
        let mut pass = passes::begin_depth(encoder, &self.textures.contact_map);
        passes::draw_food_depth(&mut pass, depth, self.views.contact(), foods);
        drop(pass);
        match input.sample {
            Some(_) => self.history.lend_shadow(),
            None => self.history.cast(casters),
        }
    }

    fn groups(&self) -> Groups<'_> {
        Groups { frame: self.views.frame(), textures: &self.textures.bind_group }
    }

    /// Everything that is drawn; none before the first scene.
    fn subject(&self) -> Option<Subject<'_>> {
        let Contents { solids, foods, sprites, .. } = &self.contents;
        Some(Subject { solids: solids.as_ref()?, foods, sprites })
    }

    fn draw_flat(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let pipelines = self.pipelines.flat(device);
        let Some(solids) = &self.contents.solids else { return };
        let groups = Groups { frame: self.views.frame(), textures: &self.textures.bind_group };
        let mut pass = passes::begin(encoder, &self.targets.picture.attachments(), Some(FLAT_BACKGROUND));
        passes::draw_flat(&mut pass, pipelines, &groups, solids, &self.contents.foods);
        drop(pass);
        self.history.drew_whole();
    }

    /// Draws what a half mirror can show, at once: without the room no layer is worth caching.
    fn draw_mirror(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, pan: bool, smooth: bool) {
        let detail = match (self.quality, smooth) {
            (Quality::Best, _) => Detail::Best,
            (_, true) => Detail::Fine,
            _ => Detail::Usual,
        };
        self.pipelines.stock_mirror(device, detail, self.contents.foods.textures());
        if smooth {
            self.targets.msaa(device);
        }
        let (Some(pipelines), Some(subject)) = (self.pipelines.colour(detail), self.subject()) else { return };
        let picture = &self.targets.picture;
        let to = if smooth { self.targets.multisampled(picture) } else { picture.attachments() };
        passes::draw_mirror(encoder, &to, pipelines, &self.groups(), &subject, pan);
        self.history.forget_still();
        self.history.drew_whole();
    }

    fn draw_fine(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder) {
        let detail = if self.quality == Quality::Best { Detail::Best } else { Detail::Fine };
        self.pipelines.stock(device, detail, self.contents.foods.textures());
        self.targets.msaa(device);
        let (Some(pipelines), Some(subject), Some(backdrop)) =
            (self.pipelines.colour(detail), self.subject(), &self.backdrop)
        else {
            return;
        };
        let Targets { picture, lively, .. } = &self.targets;
        // The kept layer with the foods is free: it is drawn again after this.
        let to = self.targets.multisampled(lively);
        passes::draw_whole(encoder, &to, pipelines, &self.groups(), &subject);
        let mut pass = passes::begin_depth(encoder, &picture.depth);
        let Subject { solids, foods, .. } = subject;
        passes::draw_whole_depth(&mut pass, self.pipelines.depth(), self.views.camera(), solids, foods);
        drop(pass);
        let blurred = Blurred { sharp: &lively.colour, depth: &picture.depth, into: &picture.colour };
        backdrop.blur(device, encoder, &blurred);
        self.history.drew_whole();
    }

    fn draw_fast(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey, size: [u32; 2]) {
        match self.history.still_step(&key, self.contents.moved.shadow) {
            StillStep::Skip => return self.draw_direct(device, encoder, key),
            StillStep::Refine => self.refine_still(device, encoder, key),
            StillStep::Keep => {}
        }
        self.pipelines.stock(device, Detail::Usual, self.contents.foods.textures());
        let (Some(pipelines), Some(subject)) = (self.pipelines.colour(Detail::Usual), self.subject()) else { return };
        let (groups, restore, targets) = (self.groups(), self.pipelines.restore(), &self.targets);
        let Subject { solids, foods, sprites } = subject;
        let mut touched = self.history.sprites_to_draw();
        if let Some(lively) = self.history.lively_to_draw() {
            let to = targets.lively.attachments();
            let mut pass = passes::begin_restored(encoder, restore, &to, &targets.still, lively.scissor(size));
            passes::draw_lively(&mut pass, pipelines, &groups, solids, foods);
            passes::draw_spots(&mut pass, pipelines, sprites);
            touched = touched.union(lively);
        }
        let mut pass = passes::begin_over(encoder, &targets.picture, &targets.lively, touched.scissor(size));
        passes::draw_veils(&mut pass, pipelines, &groups, solids, foods, sprites);
        drop(pass);
        self.history.drew_from_kept();
    }

    /// While the camera moves no layer is cached: everything is drawn at once with one sample a pixel.
    fn draw_direct(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey) {
        self.pipelines.stock(device, Detail::Usual, self.contents.foods.textures());
        let (Some(pipelines), Some(subject)) = (self.pipelines.colour(Detail::Usual), self.subject()) else { return };
        let to = self.targets.picture.attachments();
        passes::draw_whole(encoder, &to, pipelines, &self.groups(), &subject);
        self.history.keep_still(key, false);
        self.history.drew_whole();
    }

    /// Draws the static layer with anti-aliasing once the camera rests, and blurs what is behind the pan.
    fn refine_still(&mut self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, key: StillKey) {
        self.pipelines.stock(device, Detail::Fine, std::iter::empty());
        self.targets.msaa(device);
        let (Some(pipelines), Some(solids), Some(backdrop)) =
            (self.pipelines.colour(Detail::Fine), &self.contents.solids, &self.backdrop)
        else {
            return;
        };
        let (still, sharp) = (&self.targets.still.layer, &self.targets.lively);
        let mut pass = passes::begin(encoder, &self.targets.multisampled(sharp), Some(FLAT_BACKGROUND));
        passes::draw_still(&mut pass, pipelines, &self.groups(), solids, true);
        drop(pass);
        let mut pass = passes::begin_depth(encoder, &still.depth);
        passes::draw_still_depth(&mut pass, self.pipelines.depth(), self.views.camera(), solids);
        drop(pass);
        let blurred = Blurred { sharp: &sharp.colour, depth: &still.depth, into: &still.colour };
        backdrop.blur(device, encoder, &blurred);
        self.history.keep_still(key, true);
        self.history.drew_whole();
    }
}
