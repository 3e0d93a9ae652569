//! What the pictures must hold. Without a graphics adapter there is nothing to test, and the tests pass.

use std::sync::{Arc, Mutex};

use crate::camera::Camera;
use crate::input::{Colouring, MirrorLook, SceneInput};
use crate::light::room_light::RoomLight;
use crate::light::white_balance::WhiteBalance;
use crate::quality::Quality;
use crate::renderer::{FLAT_BACKGROUND, SceneRenderer};
use crate::sample::{Doneness, cut, empty_pan, heat_table, steak_in_pan};

const SIZE: [u32; 2] = [320, 180];

fn device() -> Option<(wgpu::Device, wgpu::Queue)> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).ok()?;
    let required_limits = wgpu::Limits::downlevel_webgl2_defaults();
    let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
    pollster::block_on(adapter.request_device(&descriptor)).ok()
}

fn flat_field(coordinate: f32, sliced: bool) -> SceneInput {
    let mut scene = steak_in_pan(Doneness::HalfWay);
    if sliced {
        cut(&mut scene.foods[0], Doneness::HalfWay);
    }
    std::sync::Arc::make_mut(&mut scene.foods[0].vertices).iter_mut().for_each(|vertex| vertex.field = coordinate);
    scene.pan.floor_field = [coordinate; 16];
    scene.colouring = Colouring::Field { table: heat_table(), classes: None };
    scene.flat = true;
    scene
}

#[test]
fn flat_pictures_hold_exact_table_colours() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    let table = heat_table();
    for index in [0usize, 77, 128, 255] {
        let scene = flat_field(index as f32 / 255.0, false);
        let pixels = renderer.read_as_is(&device, &queue, &scene, SIZE);
        let mut coloured = 0;
        for pixel in pixels.chunks(4).filter(|pixel| pixel[..3] != FLAT_BACKGROUND) {
            coloured += 1;
            let off = (0..3).map(|c| pixel[c].abs_diff(table[index][c])).max();
            assert!(off <= Some(1), "{index}: {pixel:?} instead of {:?}", table[index]);
        }
        assert!(coloured > 2000, "{index}: {coloured} coloured pixels");
    }
}

#[test]
fn every_way_of_drawing_fills_the_picture() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    for quality in Quality::ALL {
        renderer.set_quality(quality);
        for flat in [false, true] {
            let scene = SceneInput { flat, ..flat_field(0.5, true) };
            let pixels = renderer.read_as_is(&device, &queue, &scene, SIZE);
            assert_eq!(pixels.len(), 4 * 320 * 180);
            assert!(pixels.chunks(4).all(|pixel| pixel[3] == 255), "{quality:?} {flat}");
        }
    }
}

#[test]
fn a_resting_scene_is_drawn_alike_fast_and_fine() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    renderer.set_rest(web_time::Duration::MAX);
    let scene = steak_in_pan(Doneness::Browned);
    let fast = (0..3).map(|_| renderer.read_as_is(&device, &queue, &scene, SIZE)).last().unwrap_or_default();
    renderer.set_quality(Quality::Smooth);
    let fine = renderer.read_as_is(&device, &queue, &scene, SIZE);
    let off: u64 = fast.iter().zip(&fine).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    let mean = off as f64 / fast.len() as f64;
    assert!(mean < 3.0, "mean difference {mean}");
}

#[test]
fn a_moved_food_leaves_no_trace() {
    let Some((device, queue)) = device() else {
        return;
    };
    let draw = |renderer: &mut SceneRenderer, scene: &SceneInput| {
        renderer.set_rest(web_time::Duration::MAX);
        (0..5).map(|_| renderer.read_as_is(&device, &queue, scene, SIZE)).last().unwrap_or_default()
    };
    let mut away = steak_in_pan(Doneness::Browned);
    away.foods[0].world_from_rest.w_axis.x += 0.3;
    let home = steak_in_pan(Doneness::Browned);
    let mut renderer = SceneRenderer::new(&device, &queue);
    draw(&mut renderer, &away);
    let after = draw(&mut renderer, &home);
    let fresh = draw(&mut SceneRenderer::new(&device, &queue), &home);
    assert!(after == fresh);
}

#[test]
fn steam_leaves_no_trace_on_what_is_kept() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    renderer.set_rest(web_time::Duration::MAX);
    let at = |time_s: f32| SceneInput { time_s, ..steak_in_pan(Doneness::Browned) };
    let mut draw = |time_s: f32| renderer.read_as_is(&device, &queue, &at(time_s), SIZE);
    draw(3.0);
    let before = draw(3.0);
    let later = draw(3.4);
    assert!(later != before, "the steam moves");
    assert!(draw(3.0) == before);
}

#[test]
fn a_pan_without_a_field_is_not_coloured() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut scene = flat_field(1.0, false);
    scene.foods.clear();
    scene.pan.floor_field = [-1.0; 16];
    let pixels = SceneRenderer::new(&device, &queue).render_to_image(&device, &queue, &scene, SIZE, Quality::Smooth);
    assert!(pixels.chunks(4).all(|pixel| pixel[..3] == FLAT_BACKGROUND));
}

/// Mean colour of the floor of a grey, matt, dry pan seen from above, 0–255.
fn grey_floor(
    renderer: &mut SceneRenderer,
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    white: WhiteBalance,
) -> [f64; 3] {
    let mut scene = SceneInput { camera: Camera::above(), white_balance: white, ..empty_pan() };
    // Dark enough to stay on the straight part of the tone curve.
    (scene.pan.colour, scene.pan.metalness, scene.pan.roughness) = (glam::Vec3::splat(0.3), 0.0, 1.0);
    scene.pan.film = Default::default();
    let pixels = renderer.render_to_image(device, queue, &scene, SIZE, Quality::Smooth);
    let size = SIZE.map(|side| side as usize);
    let middle =
        (size[1] / 2 - 10..size[1] / 2 + 10).flat_map(|y| (size[0] / 2 - 10..size[0] / 2 + 10).map(move |x| (x, y)));
    let seen: Vec<&[u8]> = middle.map(|(x, y)| &pixels[4 * (y * size[0] + x)..][..3]).collect();
    std::array::from_fn(|c| seen.iter().map(|p| f64::from(p[c])).sum::<f64>() / seen.len() as f64)
}

#[test]
fn grey_looks_grey_under_the_neutral_balance_redder_below_and_bluer_above() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    let mut at = |white| grey_floor(&mut renderer, &device, &queue, white);
    let neutral = at(WhiteBalance::Neutral);
    // The wall shades the floor from some of the room, whose light is not all of one colour.
    assert!((neutral[0] - neutral[1]).abs() < 4.0 && (neutral[2] - neutral[1]).abs() < 4.0, "{neutral:?}");
    let [cool, as_shot, warm] = [WhiteBalance::Cool, WhiteBalance::AsShot, WhiteBalance::Warm].map(at);
    let redness = [cool, neutral, as_shot, warm].map(|c| c[0] - c[2]);
    assert!(redness.windows(2).all(|pair| pair[1] > pair[0] + 3.0), "{redness:?}");
}

#[test]
fn the_white_balance_leaves_fields_and_flat_pictures_as_they_are() {
    let Some((device, queue)) = device() else {
        return;
    };
    let flat = flat_field(0.5, true);
    let lit = SceneInput { flat: false, ..flat.clone() };
    let flat_look = SceneInput { colouring: Colouring::Look, ..flat.clone() };
    for scene in [flat, lit, flat_look] {
        let draw = |white_balance| {
            let scene = SceneInput { white_balance, ..scene.clone() };
            SceneRenderer::new(&device, &queue).render_to_image(&device, &queue, &scene, SIZE, Quality::Smooth)
        };
        assert!(draw(WhiteBalance::AsShot) == draw(WhiteBalance::Warm));
    }
}

#[test]
fn what_is_kept_follows_the_white_balance() {
    let Some((device, queue)) = device() else {
        return;
    };
    let draw = |renderer: &mut SceneRenderer, white_balance| {
        renderer.set_rest(web_time::Duration::MAX);
        let scene = SceneInput { white_balance, ..steak_in_pan(Doneness::Browned) };
        (0..4).map(|_| renderer.read_as_is(&device, &queue, &scene, SIZE)).last().unwrap_or_default()
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    let as_shot = draw(&mut renderer, WhiteBalance::AsShot);
    let cool = draw(&mut renderer, WhiteBalance::Cool);
    assert!(as_shot != cool);
    assert!(cool == draw(&mut SceneRenderer::new(&device, &queue), WhiteBalance::Cool));
}

/// Mean brightness of a grey, matt, dry floor next to a steak, seen from above: 7 mm and 30 mm from its edge.
fn beside_steak(
    renderer: &mut SceneRenderer,
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    quality: Quality,
) -> [f64; 2] {
    const PICTURE: [u32; 2] = [960, 540];
    let mut scene = SceneInput { camera: Camera::above(), ..steak_in_pan(Doneness::Raw) };
    (scene.pan.colour, scene.pan.metalness, scene.pan.roughness) = (glam::Vec3::splat(0.3), 0.0, 1.0);
    (scene.pan.film, scene.steam) = (Default::default(), Vec::new());
    let pixels = renderer.render_to_image(device, queue, &scene, PICTURE, quality);
    let middle = scene.foods[0].world_from_rest.w_axis.truncate();
    let seen = |angle: f32, reach: f32| {
        let place =
            glam::Vec3::new(middle.x + reach * angle.cos(), middle.y + reach * angle.sin(), scene.pan.thickness);
        let ndc = scene.camera.project(place, 16.0 / 9.0).expect("is seen");
        let at = [0.5 + 0.5 * ndc[0], 0.5 - 0.5 * ndc[1]];
        let [x, y] = std::array::from_fn(|i| (at[i] * PICTURE[i] as f32) as usize);
        <[u8; 3]>::try_from(&pixels[4 * (y * PICTURE[0] as usize + x)..][..3]).expect("three bytes").map(f64::from)
    };
    let edge = |angle: f32| {
        let mut reaches = (20..80).map(|mm| 1e-3 * mm as f32);
        let grey = |c: [f64; 3]| c[0] < 1.3 * c[2];
        reaches.rfind(|reach| !grey(seen(angle, *reach))).unwrap_or(0.0)
    };
    let angles: Vec<f32> = (0..64).map(|k| std::f32::consts::TAU * k as f32 / 64.0).collect();
    [0.007, 0.030]
        .map(|away| angles.iter().map(|&angle| seen(angle, edge(angle) + away)[1]).sum::<f64>() / angles.len() as f64)
}

#[test]
fn the_best_level_shades_the_ground_where_food_touches_it_and_nowhere_else() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    renderer.never_develop();
    let [smooth, best] =
        [Quality::Smooth, Quality::Best].map(|quality| beside_steak(&mut renderer, &device, &queue, quality));
    assert!(best[0] < 0.98 * smooth[0], "near: {best:?} {smooth:?}");
    assert!((best[1] / smooth[1] - 1.0).abs() < 0.01, "far: {best:?} {smooth:?}");
}

#[test]
fn the_best_level_develops_the_look_and_leaves_data_colours_and_the_half_mirror_as_they_are() {
    let Some((device, queue)) = device() else {
        return;
    };
    let [mut plain, mut developed] = [(); 2].map(|()| SceneRenderer::new(&device, &queue));
    plain.never_develop();
    let mut draw = |scene: &SceneInput| {
        let read = |r: &mut SceneRenderer| r.render_to_image(&device, &queue, scene, SIZE, Quality::Best);
        [read(&mut plain), read(&mut developed)]
    };
    let look = steak_in_pan(Doneness::Browned);
    let flat_field = flat_field(0.5, true);
    let lit_field = SceneInput { flat: false, ..flat_field.clone() };
    let flat_look = SceneInput { flat: true, ..look.clone() };
    let clip_from_world = look.camera.view_projection(16.0 / 9.0);
    let mirror = MirrorLook { eye: look.camera.eye(), clip_from_world, pan_shown: false };
    let mirrored = SceneInput { mirror: Some(mirror), ..look.clone() };
    for scene in [flat_field, lit_field, flat_look, mirrored] {
        let [plain, developed] = draw(&scene);
        assert!(plain == developed, "flat {}, mirror {}", scene.flat, scene.mirror.is_some());
    }
    let [plain, developed] = draw(&look);
    assert!(plain != developed);
    assert!(developed.chunks(4).all(|pixel| pixel[3] == 255));
}

#[test]
fn the_evening_leaves_fields_and_flat_pictures_readable_and_follows_what_is_kept() {
    let Some((device, queue)) = device() else {
        return;
    };
    let flat = flat_field(0.5, true);
    let evening = SceneInput { light: RoomLight::Evening, ..flat.clone() };
    let [day, night] =
        [flat, evening].map(|scene| SceneRenderer::new(&device, &queue).read_as_is(&device, &queue, &scene, SIZE));
    assert!(day == night);
    let draw = |renderer: &mut SceneRenderer, light| {
        renderer.set_rest(web_time::Duration::MAX);
        let scene = SceneInput { light, ..steak_in_pan(Doneness::Browned) };
        (0..4).map(|_| renderer.read_as_is(&device, &queue, &scene, SIZE)).last().unwrap_or_default()
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    let day = draw(&mut renderer, RoomLight::Daylight);
    let evening = draw(&mut renderer, RoomLight::Evening);
    assert!(day != evening);
    assert!(evening == draw(&mut SceneRenderer::new(&device, &queue), RoomLight::Evening));
}

#[test]
fn the_lower_levels_blur_the_room_behind_the_pan_and_leave_the_pan_sharp() {
    let Some((device, queue)) = device() else {
        return;
    };
    let mut renderer = SceneRenderer::new(&device, &queue);
    renderer.set_rest(web_time::Duration::MAX);
    for quality in [Quality::Quick, Quality::Smooth] {
        renderer.set_quality(quality);
        let mut drawn = |aperture: f32| {
            let mut scene = steak_in_pan(Doneness::Browned);
            scene.camera = Camera { pitch: 0.35, ..Camera::default() };
            scene.photo.aperture = aperture;
            (0..3).map(|_| renderer.read_as_is(&device, &queue, &scene, SIZE)).last().unwrap_or_default()
        };
        let pictures = [0.0, 1.0, 4.0].map(&mut drawn);
        let rows = |picture: &[u8], part: std::ops::Range<usize>| picture[1280 * part.start..1280 * part.end].to_vec();
        // The edge of the worktop runs across the picture.
        let edges = |picture: &Vec<u8>| -> u32 {
            let room = rows(picture, 0..50);
            room.windows(1281).map(|column| u32::from(column[0].abs_diff(column[1280])).pow(2)).sum()
        };
        let [sharp, usual, soft] = [0, 1, 2].map(|k| edges(&pictures[k]));
        assert!(soft < usual && usual < sharp && 2 * soft < sharp, "{quality:?}: {sharp}, {usual}, {soft}");
        assert!(pictures.iter().all(|picture| rows(picture, 90..180) == rows(&pictures[0], 90..180)), "{quality:?}");
    }
}

#[allow(clippy::unwrap_used)]
#[test]
fn a_still_that_gathers_light_is_the_same_each_time_and_as_bright_as_a_single_picture() {
    let Some((device, queue)) = device() else {
        return;
    };
    let scene = steak_in_pan(Doneness::Browned);
    let mut renderer = SceneRenderer::new(&device, &queue);
    let mut drawn = |samples| {
        renderer.set_samples(samples);
        let told: Arc<Mutex<Vec<u32>>> = Arc::default();
        let telling = Arc::clone(&told);
        renderer.on_sample(Box::new(move |taken, _| telling.lock().unwrap().push(taken)));
        let pixels = renderer.render_to_image(&device, &queue, &scene, SIZE, Quality::Best);
        let told = told.lock().unwrap().clone();
        (pixels, told)
    };
    let (single, none) = drawn(1);
    let (gathered, told) = drawn(8);
    assert!(none.is_empty() && told == [1, 2, 3, 4, 5, 6, 7, 8], "{none:?} {told:?}");
    assert!(gathered != single && drawn(8).0 == gathered, "the same samples give the same bytes");
    assert!(drawn(1).0 == single, "a single picture is what it was");
    let grey = |pixels: &[u8]| pixels.iter().map(|v| f64::from(*v)).sum::<f64>() / pixels.len() as f64;
    let change = grey(&gathered) / grey(&single);
    assert!((0.97..1.03).contains(&change), "{change}");
}

#[test]
fn only_a_developed_look_gathers_light() {
    let Some((device, queue)) = device() else {
        return;
    };
    let scene = flat_field(0.5, false);
    let drawn = |samples, scene: &SceneInput, quality| {
        let mut renderer = SceneRenderer::new(&device, &queue);
        renderer.set_samples(samples);
        renderer.render_to_image(&device, &queue, scene, SIZE, quality)
    };
    assert!(drawn(8, &scene, Quality::Best) == drawn(1, &scene, Quality::Best));
    let look = steak_in_pan(Doneness::Raw);
    assert!(drawn(8, &look, Quality::Smooth) == drawn(1, &look, Quality::Smooth));
}
