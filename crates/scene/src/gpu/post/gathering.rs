//! Targets and passes of a still that gathers light, for one picture size.

use super::chain::{Bench, Step};
use super::kit::{HDR_FORMAT, Post, PostKit};
use crate::gpu::targets::layer::{Attachments, DEPTH_FORMAT, Layer, texture, view};

/// The samples of one size, and their mean so far.
pub(crate) struct Gathering {
    /// The sample that is drawn: radiances, encoded.
    sample: Layer,
    add: Step,
    mean: Step,
}

impl Gathering {
    /// `into` takes the mean, encoded.
    pub(super) fn new(bench: &Bench<'_>, size: [u32; 2], into: &wgpu::TextureView) -> Self {
        let target = |format| view(&texture(bench.device, size, format, 1));
        let (colour, sum) = (target(HDR_FORMAT), target(HDR_FORMAT));
        Self {
            add: bench.step(Post::Sample, [&colour], &sum),
            mean: bench.step(Post::Mean, [&sum], into),
            sample: Layer { colour, depth: target(DEPTH_FORMAT) },
        }
    }

    /// What a sample is drawn into.
    pub fn attachments(&self) -> Attachments<'_> {
        self.sample.attachments()
    }

    /// Takes the sample that was drawn, after `before` others, into the mean.
    pub fn add(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit, before: u32) {
        self.add.run_over(encoder, kit, 1.0 / f64::from(before + 1));
    }

    /// Puts the mean where the passes after the scene read it.
    pub fn show(&self, encoder: &mut wgpu::CommandEncoder, kit: &PostKit) {
        self.mean.run(encoder, kit);
    }
}
