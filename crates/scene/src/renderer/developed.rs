//! Pictures that are developed: radiances in half floats, of one picture or as the mean of many samples.

use super::SceneRenderer;
use crate::gpu::passes::{self, Subject};
use crate::gpu::pipeline_build::Detail;
use crate::gpu::post::{Chain, LensUniform, PostKit, sharp_distance};
use crate::gpu::targets::Targets;
use crate::gpu::uniforms::FrameUniform;
use crate::input::{Colouring, SceneInput};
use crate::light::gathered::{Gathers, LightSample};
use crate::light::shadow::ShadowView;
use crate::quality::Quality;

/// Called after each sample with the number of samples so far and of all.
pub type SampleProgress = Box<dyn FnMut(u32, u32) + Send + Sync>;

/// How many samples a picture that is developed gathers once nothing in it changes, and how many it has.
pub(super) struct Samples {
    wanted: u32,
    taken: u32,
    /// True if the picture that is shown is one that gathers.
    gathers: bool,
    told: Option<SampleProgress>,
}

impl Default for Samples {
    fn default() -> Self {
        Self { wanted: 1, taken: 0, gathers: false, told: None }
    }
}

impl Samples {
    /// Begins a new picture; `develops`: it is one that can gather light.
    pub fn begin(&mut self, develops: bool) {
        (self.taken, self.gathers) = (0, develops && self.wanted > 1);
    }

    /// True if no sample is left to be taken.
    pub fn are_taken(&self) -> bool {
        !self.gathers || self.taken >= self.wanted
    }

    /// Counts a sample; returns true if the mean has light of all kinds in proportion, so that it can be shown.
    fn count(&mut self) -> bool {
        self.taken += 1;
        if let Some(told) = &mut self.told {
            told(self.taken, self.wanted);
        }
        self.taken.is_multiple_of(LightSample::ROUND) || self.taken == self.wanted
    }
}

impl SceneRenderer {
    /// Sets how many samples of light a picture at the best level is the mean of, once nothing in it changes; 1 unless set.
    pub fn set_samples(&mut self, count: u32) {
        if self.samples.wanted != count.max(1) {
            self.samples.wanted = count.max(1);
            self.shown.forget();
        }
    }

    /// True while the picture gathers light and not all samples are taken.
    pub(crate) fn has_samples_left(&self) -> bool {
        !self.samples.are_taken()
    }

    /// Sets what is called after each sample.
    pub fn on_sample(&mut self, told: SampleProgress) {
        self.samples.told = Some(told);
    }

    /// Returns true if a scene is drawn as radiances that are developed: the look at the best level, no data colours.
    pub(super) fn develops(&self, input: &SceneInput) -> bool {
        let look = matches!(input.colouring, Colouring::Look);
        self.quality == Quality::Best && self.half_floats && look && !input.flat && input.mirror.is_none()
    }

    /// Draws radiances in half floats and develops them.
    pub(super) fn draw_developed(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        input: &SceneInput,
    ) {
        self.pipelines.stock(device, Detail::Hdr, self.contents.foods.textures());
        let kit = self.post.get_or_insert_with(|| PostKit::new(device));
        let Targets { size, picture, chain, .. } = &mut self.targets;
        let whole = input.tile.map_or(size[1], |tile| tile.whole[1]);
        let chain = chain.get_or_insert_with(|| Chain::new(device, kit, *size, picture, whole));
        chain.write(queue, &LensUniform::new(input, *size));
        self.textures.set_ambient(device, &chain.ambient);
        let (Some(pipelines), Some(subject)) = (self.pipelines.colour(Detail::Hdr), self.subject()) else { return };
        let (Some(kit), Some(chain)) = (&self.post, &self.targets.chain) else { return };
        let mut pass = passes::begin_depth(encoder, &self.targets.picture.depth);
        let Subject { solids, foods, .. } = subject;
        passes::draw_whole_depth(&mut pass, self.pipelines.depth(), self.views.camera(), solids, foods);
        drop(pass);
        chain.shade(encoder, kit);
        passes::draw_whole(encoder, &chain.attachments(), pipelines, &self.groups(), &subject);
        chain.develop(encoder, kit);
        self.history.drew_whole();
    }

    /// Draws one more sample of the picture that is shown, if it gathers light and not all are taken.
    pub(super) fn draw_next_sample(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        input: &SceneInput,
    ) {
        if self.samples.are_taken() {
            return;
        }
        let size = self.targets.size;
        let whole = input.tile.map_or(size, |tile| tile.whole);
        let before = self.samples.taken;
        let all = Gathers {
            towards: input.towards_light(),
            aperture: input.photo.aperture,
            sharp: sharp_distance(input),
            size: whole,
            count: self.samples.wanted,
        };
        let input = SceneInput { sample: Some(LightSample::new(before, &all)), ..input.clone() };
        self.write_sample(queue, &input);
        self.update_shadow(encoder, &input);
        self.pipelines.stock(device, Detail::Sample, self.contents.foods.textures());
        let shown = self.samples.count();
        let Targets { picture, chain, .. } = &mut self.targets;
        let (Some(kit), Some(chain)) = (&self.post, chain) else { return };
        chain.write(queue, &LensUniform::new(&input, size));
        chain.gather(device, kit, picture, size);
        let (Some(pipelines), Some(subject)) = (self.pipelines.colour(Detail::Sample), self.subject()) else { return };
        let Some((chain, gathering)) = self.targets.chain.as_ref().and_then(|c| Some((c, c.gathering()?))) else {
            return;
        };
        passes::draw_whole(encoder, &gathering.attachments(), pipelines, &self.groups(), &subject);
        gathering.add(encoder, kit, before);
        if shown {
            gathering.show(encoder, kit);
            chain.develop(encoder, kit);
        }
    }

    /// Writes what the shaders read of a sample.
    fn write_sample(&self, queue: &wgpu::Queue, input: &SceneInput) {
        let [width, height] = self.targets.size;
        let aspect = width as f32 / height as f32;
        let frame = FrameUniform::new(input, aspect, self.quality, &self.contents.contact);
        self.views.write(queue, &frame, &input.view_projection(aspect), &ShadowView::of(input));
    }
}
