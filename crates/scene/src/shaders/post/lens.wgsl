// What every pass over the finished radiances knows: where this picture lies in the whole one, and how depth is read.

struct Lens {
    // This picture [pixels]: width, height, and its left and upper edge in the whole picture.
    part: vec4<f32>,
    // The whole picture [pixels]: width, height; share of bloom; how much the corners are darkened.
    whole: vec4<f32>,
    // Normalised device coordinates of this picture over view x / distance: scale x, y, then shift x, y.
    projection: vec4<f32>,
    // Nearest and farthest distance of the depth; distance up to which all is sharp [m]; width of the aperture [m].
    depth: vec4<f32>,
};

@group(0) @binding(0) var<uniform> lens: Lens;
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
    let d = textureLoad(scene_depth, at, 0).r;
    return lens.depth.x * lens.depth.y / (lens.depth.y - d * (lens.depth.y - lens.depth.x));
}

// Interleaved gradient noise of a pixel of the whole picture, 0 to 1 (Jimenez 2014 `[@jimenez-2014]`).
fn noise_at(pixel: vec2<f32>) -> f32 {
    return fract(52.9829189 * fract(dot(pixel + lens.part.zw, vec2<f32>(0.06711056, 0.00583715))));
}

// Diameter of the circle of confusion [pixels]; 0 up to the far end of what is sharp.
fn confusion(distance: f32) -> f32 {
    let far = max(1.0 / lens.depth.z - 1.0 / max(distance, lens.depth.z), 0.0);
    return lens.depth.w * far * lens.projection.y * 0.5 * lens.part.y;
}
