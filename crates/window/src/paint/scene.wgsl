// Draws the finished picture over the callback's rectangle.

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var picture_sampler: sampler;

// The picture contains sRGB-encoded values; a target that stores them as they are takes them as they are.
@fragment
fn fs_present_encoded(in: Covered) -> @location(0) vec4<f32> {
    return vec4<f32>(textureSampleLevel(picture, picture_sampler, in.uv, 0.0).rgb, 1.0);
}

// An sRGB target encodes what it is given, so the values are decoded first.
@fragment
fn fs_present_linear(in: Covered) -> @location(0) vec4<f32> {
    return vec4<f32>(linear_from_srgb(textureSampleLevel(picture, picture_sampler, in.uv, 0.0).rgb), 1.0);
}
