// Data of the frame for every pass, and how a radiance becomes a pixel.

struct Frame {
    clip_from_world: mat4x4<f32>,
    // Shadow map: clip space of its coarse part, seen from the light that casts shadows.
    light_from_world: mat4x4<f32>,
    // Position of the eye; w = simulated time [s], wrapped.
    eye: vec4<f32>,
    // Unit vector towards the light that casts shadows.
    key: vec4<f32>,
    // Unit vector towards the other light; w = levels of the environment - 1.
    other: vec4<f32>,
    // Irradiance / pi of both; light of the room from above, from below, from the front.
    key_light: vec4<f32>,
    other_light: vec4<f32>,
    fill_sky: vec4<f32>,
    fill_ground: vec4<f32>,
    fill_front: vec4<f32>,
    // Exposure and balance as shot.
    as_shot: vec4<f32>,
    // The pan's frame: its origin is the centre of the underside.
    pan_from_world: mat4x4<f32>,
    // Contact map: lowest corner x, y, then 1 / extent.
    contact_rect: vec4<f32>,
    // Contact map: lowest height, 1 / range; sample step.
    contact_height: vec4<f32>,
    // Centre of the pan's underside; w = thickness of the floor.
    pan_place: vec4<f32>,
    // Floor radius, rim radius, rim height, fog on the lid.
    pan_shape: vec4<f32>,
    // x = hob power, y = 1 for field colours, z = 1 for flat, w = top of the board.
    mode: vec4<f32>,
    // Left, front, right, back edge of the board.
    board: vec4<f32>,
    // Colour of oil in its bottle; w = 1 where only the light that it adds to a real pan is drawn.
    oil: vec4<f32>,
    // Exposure and white balance; w = how cloudy the oil is.
    white: vec4<f32>,
    // Middle of the shadow map's fine part in the clip space of the coarse one; scale to it; sample step over the coarse one.
    shadow_fine: vec4<f32>,
    // Left and upper edge of this picture in a larger one [pixels]; z = 1 where the dome of the room alone lights, from `key`;
    // w = shift of noise, another one in each sample.
    origin: vec4<f32>,
    // Rings of the pan floor's field.
    floor_field: array<vec4<f32>, 4>,
};

@group(0) @binding(0) var<uniform> frame: Frame;

// A point of the world in the pan's frame.
fn in_pan(position: vec3<f32>) -> vec3<f32> {
    return (frame.pan_from_world * vec4<f32>(position, 1.0)).xyz;
}

fn srgb_from_linear(linear: vec3<f32>) -> vec3<f32> {
    let c = max(linear, vec3<f32>(0.0));
    return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c < vec3<f32>(0.0031308));
}

// Below this the curve is straight, so that flesh keeps its own colour; above it highlights roll off (chosen).
const SHOULDER = 0.62;

// True where a later pass develops the picture: then radiances leave encoded, without curve and dither.
override hdr: bool = false;

fn filmic(radiance: vec3<f32>) -> vec3<f32> {
    let x = max(radiance * frame.white.rgb, vec3<f32>(0.0));
    if (hdr) { return x; }
    // A parabola that reaches white at twice the way from the shoulder to 1, where it is level: there glints of the window are
    // white, as in the developed pictures.
    let rest = max(1.0 - max(x - SHOULDER, vec3<f32>(0.0)) / (2.0 * (1.0 - SHOULDER)), vec3<f32>(0.0));
    return min(x, vec3<f32>(SHOULDER)) + (1.0 - SHOULDER) * (1.0 - rest * rest);
}

// Interleaved gradient noise of a pixel of the whole picture, 0 to 1.
fn gradient_noise(pixel: vec2<f32>) -> f32 {
    return fract(52.9829189 * fract(dot(pixel, vec2<f32>(0.06711056, 0.00583715))));
}

// It breaks the bands of 8-bit gradients.
fn dither(pixel: vec2<f32>) -> f32 {
    if (hdr) { return 0.0; }
    return gradient_noise(pixel) - 0.5;
}

fn pixel_from_radiance(radiance: vec3<f32>, pixel: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(srgb_from_linear(filmic(radiance)) + dither(pixel + frame.origin.xy) / 255.0, 1.0);
}
