//! Render passes and the order of draw calls in them.

use crate::gpu::foods::Foods;
use crate::gpu::pipelines::{ColourPipelines, DepthPipelines, FlatPipelines};
use crate::gpu::solids::Solids;
use crate::gpu::sprites::SpriteBuffers;
use crate::gpu::targets::Kept;
use crate::gpu::targets::layer::{Attachments, Layer};

/// Colour around the subject in flat pictures, sRGB.
pub const FLAT_BACKGROUND: [u8; 3] = [24, 24, 24];

/// Bind groups every colour pass needs.
pub(crate) struct Groups<'a> {
    pub frame: &'a wgpu::BindGroup,
    pub textures: &'a wgpu::BindGroup,
}

impl Groups<'_> {
    fn set(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(0, self.frame, &[]);
        pass.set_bind_group(1, self.textures, &[]);
    }
}

/// Colour where a half mirror is to show nothing, sRGB.
const BLACK: [u8; 3] = [0; 3];

/// Begins a pass that clears both attachments, the first one to a colour, where there is one.
pub(crate) fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    to: &Attachments<'_>,
    clear: Option<[u8; 3]>,
) -> wgpu::RenderPass<'e> {
    let load = clear.map_or(wgpu::LoadOp::Load, |colour| {
        let [r, g, b] = colour.map(|v| f64::from(v) / 255.0);
        wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a: 1.0 })
    });
    let store = if to.resolve.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("scene"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: to.colour,
            depth_slice: None,
            resolve_target: to.resolve,
            ops: wgpu::Operations { load, store },
        })],
        depth_stencil_attachment: Some(depth_attachment(to.depth, clear.is_some(), store)),
        ..Default::default()
    })
}

/// Begins a pass with a rectangle of a kept picture brought back; nothing is drawn outside of it.
pub(crate) fn begin_restored<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    restore: &wgpu::RenderPipeline,
    to: &Attachments<'_>,
    from: &Kept,
    [left, top, width, height]: [u32; 4],
) -> wgpu::RenderPass<'e> {
    let mut pass = begin(encoder, to, None);
    pass.set_pipeline(restore);
    pass.set_bind_group(0, &from.restore, &[]);
    pass.set_scissor_rect(left, top, width, height);
    pass.draw(0..3, 0..1);
    pass
}

/// Begins a pass over a copy of a rectangle of a kept picture, for what is transparent: it is hidden by the kept depth,
/// which it leaves as it is.
pub(crate) fn begin_over<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    to: &Layer,
    kept: &Layer,
    [left, top, width, height]: [u32; 4],
) -> wgpu::RenderPass<'e> {
    let origin = wgpu::Origin3d { x: left, y: top, z: 0 };
    if width > 0 && height > 0 {
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        let [from, into] = [kept, to].map(|layer| layer.colour.texture().as_image_copy());
        let part = |whole| wgpu::TexelCopyTextureInfo { origin, ..whole };
        encoder.copy_texture_to_texture(part(from), part(into), size);
    }
    let to = Attachments { colour: &to.colour, resolve: None, depth: &kept.depth };
    let mut pass = begin(encoder, &to, None);
    pass.set_scissor_rect(left, top, width, height);
    pass
}

/// Begins a pass that only writes depth.
pub(crate) fn begin_depth<'e>(encoder: &'e mut wgpu::CommandEncoder, to: &wgpu::TextureView) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("depth"),
        depth_stencil_attachment: Some(depth_attachment(to, true, wgpu::StoreOp::Store)),
        ..Default::default()
    })
}

fn depth_attachment(
    view: &wgpu::TextureView,
    clear: bool,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    let load = if clear { wgpu::LoadOp::Clear(1.0) } else { wgpu::LoadOp::Load };
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load, store }),
        stencil_ops: None,
    }
}

/// Everything that casts a shadow, into both parts of the shadow map.
pub(crate) fn draw_shadows(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &DepthPipelines,
    views: [&wgpu::BindGroup; 2],
    size: u32,
    solids: &Solids,
    foods: &Foods,
) {
    let side = size as f32;
    for (view, left) in views.into_iter().zip([0.0, side]) {
        pass.set_viewport(left, 0.0, side, side, 0.0, 1.0);
        draw_shadow(pass, pipelines, view, solids, foods);
    }
}

fn draw_shadow(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &DepthPipelines,
    view: &wgpu::BindGroup,
    solids: &Solids,
    foods: &Foods,
) {
    pass.set_bind_group(0, view, &[]);
    pass.set_pipeline(&pipelines.solid);
    for solid in [&solids.surroundings, &solids.board, &solids.cloth, solids.pan_body(), solids.pan_floor()] {
        solid.draw(pass);
    }
    solids.casting_hob().into_iter().for_each(|hob| hob.draw(pass));
    solids.turner().into_iter().chain(solids.tool()).chain(solids.lid_steel()).for_each(|tool| tool.draw(pass));
    draw_food_depth(pass, pipelines, view, foods);
}

/// The foods alone.
pub(crate) fn draw_food_depth(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &DepthPipelines,
    view: &wgpu::BindGroup,
    foods: &Foods,
) {
    pass.set_bind_group(0, view, &[]);
    pass.set_pipeline(&pipelines.food);
    for food in &foods.slots {
        food.draw_depth(pass);
    }
}

/// Depth of what does not move, at one sample a pixel.
pub(crate) fn draw_still_depth(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &DepthPipelines,
    view: &wgpu::BindGroup,
    solids: &Solids,
) {
    pass.set_bind_group(0, view, &[]);
    pass.set_pipeline(&pipelines.still);
    for solid in [solids.pan_body(), &solids.cloth, &solids.hob, &solids.board, &solids.surroundings, &solids.room] {
        solid.draw(pass);
    }
    solids.turner().into_iter().for_each(|turner| turner.draw(pass));
}

/// Depth of all that is not transparent, at one sample a pixel.
pub(crate) fn draw_whole_depth(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &DepthPipelines,
    view: &wgpu::BindGroup,
    solids: &Solids,
    foods: &Foods,
) {
    draw_still_depth(pass, pipelines, view, solids);
    solids.pan_floor().draw(pass);
    solids.tool().into_iter().chain(solids.strings()).chain(solids.lid_steel()).for_each(|solid| solid.draw(pass));
    pass.set_pipeline(&pipelines.lively);
    foods.slots.iter().for_each(|food| food.draw_seen_depth(pass));
}

/// What does not move, nearest first. The pan's floor is drawn with the foods; a picture that is kept needs it all the
/// same, so that the smoothed edge of the wall round it is not mixed with what is under the pan.
pub(crate) fn draw_still(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &ColourPipelines,
    groups: &Groups<'_>,
    solids: &Solids,
    with_floor: bool,
) {
    groups.set(pass);
    pass.set_pipeline(&pipelines.metal);
    solids.pan_body().draw(pass);
    if with_floor {
        solids.pan_floor().draw(pass);
    }
    pass.set_pipeline(&pipelines.solid);
    solids.cloth.draw(pass);
    pass.set_pipeline(&pipelines.glass);
    solids.hob.draw(pass);
    pass.set_pipeline(&pipelines.wood);
    solids.board.draw(pass);
    pass.set_pipeline(&pipelines.solid);
    solids.surroundings.draw(pass);
    solids.turner().into_iter().for_each(|turner| turner.draw(pass));
    solids.room.draw(pass);
    if let (Some(pipeline), Some(flames)) = (&pipelines.flame, solids.flames()) {
        pass.set_pipeline(pipeline);
        flames.draw(pass);
    }
}

/// Foods, cut faces, the tool in the hand and the floor of the pan.
pub(crate) fn draw_lively(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &ColourPipelines,
    groups: &Groups<'_>,
    solids: &Solids,
    foods: &Foods,
) {
    groups.set(pass);
    for food in foods.nearest_first() {
        let Some(own) = pipelines.of(food.texture) else { continue };
        if food.has_cut() {
            pass.set_pipeline(&own.cut_face);
            food.draw_cut(pass);
        }
        pass.set_pipeline(if food.has_cut() { &own.food_cut } else { &own.food });
        food.draw(pass);
    }
    pass.set_pipeline(&pipelines.solid);
    let thin = solids.tool().into_iter().chain(solids.strings());
    thin.chain(solids.lid_steel()).for_each(|solid| solid.draw(pass));
    pass.set_pipeline(&pipelines.floor);
    solids.pan_floor().draw(pass);
}

/// Everything in a picture.
pub(crate) struct Subject<'a> {
    pub solids: &'a Solids,
    pub foods: &'a Foods,
    pub sprites: &'a SpriteBuffers,
}

/// A whole picture in one pass, what is near first.
pub(crate) fn draw_whole(
    encoder: &mut wgpu::CommandEncoder,
    to: &Attachments<'_>,
    pipelines: &ColourPipelines,
    groups: &Groups<'_>,
    subject: &Subject<'_>,
) {
    let mut pass = begin(encoder, to, Some(FLAT_BACKGROUND));
    draw_lively(&mut pass, pipelines, groups, subject.solids, subject.foods);
    draw_still(&mut pass, pipelines, groups, subject.solids, false);
    draw_spots(&mut pass, pipelines, subject.sprites);
    draw_veils(&mut pass, pipelines, groups, subject.solids, subject.foods, subject.sprites);
}

/// What a half mirror can show: on black, without room, hob and board. The pan is black unless it is to be seen, and
/// hides what is behind its wall.
pub(crate) fn draw_mirror(
    encoder: &mut wgpu::CommandEncoder,
    to: &Attachments<'_>,
    pipelines: &ColourPipelines,
    groups: &Groups<'_>,
    subject: &Subject<'_>,
    pan: bool,
) {
    let mut pass = begin(encoder, to, Some(BLACK));
    groups.set(&mut pass);
    pass.set_pipeline(pipelines.occluder.as_ref().filter(|_| !pan).unwrap_or(&pipelines.metal));
    subject.solids.pan_body().draw(&mut pass);
    draw_lively(&mut pass, pipelines, groups, subject.solids, subject.foods);
    draw_spots(&mut pass, pipelines, subject.sprites);
    draw_veils(&mut pass, pipelines, groups, subject.solids, subject.foods, subject.sprites);
}

/// Spots of oil on what is drawn already; the pass has the frame and texture groups set.
pub(crate) fn draw_spots(pass: &mut wgpu::RenderPass<'_>, pipelines: &ColourPipelines, sprites: &SpriteBuffers) {
    draw_sprites(pass, &pipelines.spot, &sprites.spots, 0..sprites.spot_vertices);
}

/// Collars round frying foods, the veils of cut foods, the glass of the lid, then steam.
pub(crate) fn draw_veils(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &ColourPipelines,
    groups: &Groups<'_>,
    solids: &Solids,
    foods: &Foods,
    sprites: &SpriteBuffers,
) {
    groups.set(pass);
    let [collars, pools, steam] = sprites.kinds.clone();
    draw_sprites(pass, &pipelines.collar, &sprites.moving, collars);
    draw_sprites(pass, &pipelines.pool, &sprites.moving, pools);
    pass.set_pipeline(&pipelines.ghost);
    for food in &foods.slots {
        food.draw_hidden(pass);
    }
    if let Some(glass) = solids.lid_glass() {
        pass.set_pipeline(&pipelines.lid);
        glass.draw(pass);
    }
    draw_sprites(pass, &pipelines.steam, &sprites.moving, steam);
}

fn draw_sprites(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    buffer: &wgpu::Buffer,
    range: std::ops::Range<u32>,
) {
    if !range.is_empty() {
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, buffer.slice(..));
        pass.draw(range, 0..1);
    }
}

/// The exact picture: foods and pan, nothing else.
pub(crate) fn draw_flat(
    pass: &mut wgpu::RenderPass<'_>,
    pipelines: &FlatPipelines,
    groups: &Groups<'_>,
    solids: &Solids,
    foods: &Foods,
) {
    groups.set(pass);
    pass.set_pipeline(&pipelines.food);
    for food in &foods.slots {
        food.draw(pass);
        food.draw_cut(pass);
    }
    pass.set_pipeline(&pipelines.solid);
    solids.pan_floor().draw(pass);
    solids.pan_body().draw(pass);
}
