//! A still of the half mirror: what the device shows at one instant of a recipe.

use crate::cut::section::Picture;
use crate::stage::Stage;
use crate::still::headless::Gpu;
use crate::still::shot::{ShotError, ShotOptions, cook_to};
use glam::DVec2;
use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};
use saute_scene::gpu::readback::read_picture;
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;

use super::frame::MirrorFrame;
use super::presenter::MirrorPresenter;
use saute_mirror::options::MirrorOptions;
use saute_mirror::rig::Rig;

/// Cooks up to a time and draws what the rig's device shows.
pub fn mirror_shot(
    recipe: Recipe,
    library: &Library,
    at_s: f64,
    shot: &ShotOptions,
    (rig, options): (&Rig, &MirrorOptions),
    size: [u32; 2],
) -> Result<Picture, ShotError> {
    mirror_shot_of(Cook::new(recipe, library)?, at_s, shot, (rig, options), size)
}

/// Cooks on to a time, or plays a session again up to it, and draws what the rig's device shows.
pub fn mirror_shot_of(
    mut cook: Cook,
    at_s: f64,
    shot: &ShotOptions,
    (rig, options): (&Rig, &MirrorOptions),
    size: [u32; 2],
) -> Result<Picture, ShotError> {
    cook_to(&mut cook, at_s)?;
    let gpu = Gpu::open()?;
    let scene = Stage::default().scene(&cook.kitchen, &shot.stage(&cook.kitchen), &Default::default());
    Ok(mirror_still(&gpu, &scene, rig, options, size, shot.quality))
}

/// Draws a scene as the rig's device shows it, with the warp that follows from the rig's numbers.
pub fn mirror_still(
    gpu: &Gpu,
    scene: &SceneInput,
    rig: &Rig,
    options: &MirrorOptions,
    size: [u32; 2],
    quality: Quality,
) -> Picture {
    let device = DVec2::from_array(size.map(f64::from));
    let warp = rig.nominal.scaled(rig.screen.pixels(), device);
    let frame = MirrorFrame::new(scene, rig, &warp, options, device, quality);
    let rgba = drawn(gpu, &frame, size);
    Picture { width: size[0] as usize, height: size[1] as usize, rgba }
}

/// What a frame shows on a device of a size: tight RGBA8 rows from the top.
fn drawn(gpu: &Gpu, frame: &MirrorFrame, [width, height]: [u32; 2]) -> Vec<u8> {
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("mirror"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let mut presenter = MirrorPresenter::new(&gpu.device, format);
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("mirror") });
    presenter.prepare(&gpu.device, &gpu.queue, &mut encoder, frame);
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("mirror"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
        })],
        ..Default::default()
    });
    presenter.paint(&mut pass);
    drop(pass);
    read_picture(&gpu.device, &gpu.queue, encoder, &texture)
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};
    use saute_scene::input::DropLook;
    use saute_scene::sample::{Doneness, empty_pan, steak_in_pan};

    use super::*;
    use saute_mirror::rig_file::shipped;
    use saute_mirror::stereo::Stereo;

    const SIZE: [u32; 2] = [960, 540];

    fn options(stereo: Stereo) -> MirrorOptions {
        MirrorOptions { stereo, eye_distance: 0.063, pan_shown: false }
    }

    fn rig(name: &str) -> Rig {
        shipped(name).expect("is there").expect("is read")
    }

    fn pixel(picture: &Picture, x: usize, y: usize) -> [u8; 3] {
        let at = 4 * (y * picture.width + x);
        [picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]
    }

    /// Middle of what is bright, weighted by how bright, and its weight [pixels].
    fn bright(picture: &Picture, columns: std::ops::Range<usize>) -> (DVec2, f64) {
        let (mut sum, mut weight) = (DVec2::ZERO, 0.0);
        for y in 0..picture.height {
            for x in columns.clone() {
                let w = pixel(picture, x, y).iter().map(|v| f64::from(*v)).sum::<f64>();
                sum += w * DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                weight += w;
            }
        }
        (sum / weight.max(1e-9), weight)
    }

    /// A scene with nothing in it but a drop of oil in the air at a point.
    fn drop_at(point: DVec3) -> SceneInput {
        let mut scene = empty_pan();
        scene.pan.film = Default::default();
        scene.steam.clear();
        let position = point.as_vec3();
        scene.spatter.drops = vec![DropLook { position, velocity: Vec3::ZERO, radius: 2.0e-3 }];
        scene
    }

    #[test]
    fn a_drop_in_the_air_is_drawn_on_the_pixel_that_the_warp_names() {
        let gpu = Gpu::open().expect("a graphics adapter");
        for name in ["flat-screen", "projector"] {
            let rig = rig(name);
            let warp = rig.nominal.scaled(rig.screen.pixels(), DVec2::new(960.0, 540.0));
            for point in [DVec3::new(0.03, 0.01, 0.08), DVec3::new(-0.08, 0.05, 0.11)] {
                let picture = mirror_still(&gpu, &drop_at(point), &rig, &options(Stereo::Off), SIZE, Quality::Smooth);
                let (seen, weight) = bright(&picture, 0..960);
                let expected = warp.pixel(rig.seen(rig.eye, point).expect("before the eye"));
                eprintln!("{name}: drop at {seen:.2}, expected {expected:.2}, weight {weight:.0}");
                assert!(weight > 100.0, "{weight}");
                assert!(seen.distance(expected) < 0.3, "{seen} {expected}");
            }
        }
    }

    #[test]
    fn round_the_food_everything_is_black_and_the_pan_shows_only_when_it_is_asked_for() {
        let (gpu, rig) = (Gpu::open().expect("a graphics adapter"), rig("flat-screen"));
        let scene = steak_in_pan(Doneness::Browned);
        let lit = |picture: &Picture| {
            let bright = |p: &&[u8]| p[..3].iter().any(|v| *v > 2);
            picture.rgba.chunks(4).filter(bright).count()
        };
        let hidden = mirror_still(&gpu, &scene, &rig, &options(Stereo::Off), SIZE, Quality::Smooth);
        let shown = MirrorOptions { pan_shown: true, ..options(Stereo::Off) };
        let shown = mirror_still(&gpu, &scene, &rig, &shown, SIZE, Quality::Smooth);
        for [x, y] in [[4, 4], [955, 4], [4, 535], [955, 535]] {
            assert_eq!(pixel(&hidden, x, y), [0; 3]);
            assert_eq!(pixel(&shown, x, y), [0; 3], "no room, no hob");
        }
        let warp = rig.nominal.scaled(rig.screen.pixels(), DVec2::new(960.0, 540.0));
        let at = |p: DVec3| warp.pixel(rig.seen(rig.eye, p).expect("before the eye")).round().to_array();
        let [x, y] = at(DVec3::new(0.0, 0.0, 0.028)).map(|v| v as usize);
        assert!(pixel(&hidden, x, y).iter().any(|v| *v > 20), "the steak is seen: {:?}", pixel(&hidden, x, y));
        assert!(lit(&shown) > lit(&hidden) + 3000, "{} {}", lit(&shown), lit(&hidden));
    }

    #[test]
    fn side_by_side_shows_a_point_over_the_image_with_the_parallax_of_its_height() {
        let (gpu, rig) = (Gpu::open().expect("a graphics adapter"), rig("flat-screen"));
        let point = DVec3::new(0.02, 0.0, 0.10);
        let picture = mirror_still(&gpu, &drop_at(point), &rig, &options(Stereo::SideBySide), SIZE, Quality::Smooth);
        let [left, right] = [bright(&picture, 0..480), bright(&picture, 480..960)].map(|(at, _)| at);
        let seen = 2.0 * (right.x - 480.0 - left.x);
        let pixels = rig.image.size.x / 960.0;
        let [eye, above] = [rig.eye, point].map(|p| (p - rig.image.corner).dot(rig.image.normal()));
        // The panel is flipped, so that what the right eye is shown further left lies further right on it.
        let expected = 0.063 * above / (eye - above) / pixels;
        eprintln!("parallax {seen:.1} px, expected {expected:.1} px");
        assert!((seen - expected).abs() < 0.5, "{seen} {expected}");
    }

    #[test]
    fn an_anaglyph_has_red_for_the_left_eye_and_cyan_for_the_right() {
        let (gpu, rig) = (Gpu::open().expect("a graphics adapter"), rig("flat-screen"));
        let point = DVec3::new(0.02, 0.0, 0.10);
        let picture = mirror_still(&gpu, &drop_at(point), &rig, &options(Stereo::Anaglyph), SIZE, Quality::Smooth);
        let only = |channel: usize| {
            let mut one = picture.clone();
            one.rgba.chunks_mut(4).for_each(|p| (0..3).filter(|c| *c != channel).for_each(|c| p[c] = 0));
            bright(&one, 0..960).0
        };
        let warp = rig.nominal.scaled(rig.screen.pixels(), DVec2::new(960.0, 540.0));
        for (channel, side) in [(0, 0), (1, 1), (2, 1)] {
            let eye = Stereo::Anaglyph.eyes(&rig, 0.063)[side];
            let expected = warp.pixel(rig.seen(eye, point).expect("before the eye"));
            assert!(only(channel).distance(expected) < 0.3, "{channel}: {} {expected}", only(channel));
        }
    }
}
