// What the passes over the finished radiances read.

@group(0) @binding(1) var linear_sampler: sampler;
@group(0) @binding(2) var first: texture_2d<f32>;
@group(0) @binding(3) var second: texture_2d<f32>;
@group(0) @binding(4) var third: texture_2d<f32>;
@group(0) @binding(5) var scene_depth: texture_2d<f32>;

// Brighter than this no radiance counts (chosen: the lamp in a mirror; keeps one bad pixel from filling the picture).
const BRIGHTEST = 64.0;

// Radiances leave the scene encoded, so that edges and veils blend as in the other pictures.
fn radiance_from_target(encoded: vec3<f32>) -> vec3<f32> {
    return linear_from_srgb(clamp(encoded, vec3<f32>(0.0), vec3<f32>(8.0)));
}

fn target_from_radiance(linear: vec3<f32>) -> vec3<f32> {
    return select(1.055 * pow(linear, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * linear, linear < vec3<f32>(0.0031308));
}

// Distance along the axis of the eye [m].
fn distance_at(pixel: vec2<i32>) -> f32 {
    let at = clamp(pixel, vec2<i32>(0), vec2<i32>(textureDimensions(scene_depth)) - 1);
    return distance_of(textureLoad(scene_depth, at, 0).r);
}
