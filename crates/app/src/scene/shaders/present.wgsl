// Draws the finished picture over the callback's rectangle.

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var picture_sampler: sampler;

struct Presented {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
};

@vertex
fn vs_present(@builtin(vertex_index) index: u32) -> Presented {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return Presented(vec4<f32>(corner.x * 2.0 - 1.0, 1.0 - corner.y * 2.0, 0.0, 1.0), corner);
}

// The picture holds sRGB-encoded values; a target that stores them as they are takes them as they are.
@fragment
fn fs_present_encoded(in: Presented) -> @location(0) vec4<f32> {
    return vec4<f32>(textureSampleLevel(picture, picture_sampler, in.uv, 0.0).rgb, 1.0);
}

// An sRGB target encodes what it is given, so the values are decoded first.
@fragment
fn fs_present_linear(in: Presented) -> @location(0) vec4<f32> {
    let c = textureSampleLevel(picture, picture_sampler, in.uv, 0.0).rgb;
    let linear = select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c <= vec3<f32>(0.04045));
    return vec4<f32>(linear, 1.0);
}
