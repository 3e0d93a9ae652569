// Samples of a still become their mean: the sum of light is linear, what leaves the scene is encoded.

// One sample, to be mixed with the mean of those before it; its alpha is the share of light that scatters, as is.
@fragment
fn fs_sample(in: Covered) -> @location(0) vec4<f32> {
    let own = textureLoad(first, vec2<i32>(in.clip.xy), 0);
    return vec4<f32>(min(radiance_from_target(own.rgb), vec3<f32>(BRIGHTEST)), own.a);
}

// The mean, encoded as a single picture is.
@fragment
fn fs_mean(in: Covered) -> @location(0) vec4<f32> {
    let mean = textureLoad(first, vec2<i32>(in.clip.xy), 0);
    return vec4<f32>(target_from_radiance(mean.rgb), mean.a);
}
