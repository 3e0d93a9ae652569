// Light that glints scatter in the lens: the part above white, halved level by level and added up again.

// From this brightness on a pixel scatters, and where it does so fully (chosen: white paper does not glow).
const GLOWS_FROM = 1.0;
const GLOWS_WHOLLY = 2.0;

fn luminance(c: vec3<f32>) -> f32 {
    return dot(c, vec3<f32>(0.2126, 0.7152, 0.0722));
}

fn glow(pixel: vec2<i32>) -> vec4<f32> {
    let at = clamp(pixel, vec2<i32>(0), vec2<i32>(textureDimensions(first)) - 1);
    let c = min(radiance_from_target(textureLoad(first, at, 0).rgb), vec3<f32>(BRIGHTEST));
    let bright = c * smoothstep(GLOWS_FROM, GLOWS_WHOLLY, luminance(c));
    // Weighed by its inverse brightness a lone bright pixel does not flicker.
    return vec4<f32>(bright, 1.0) / (1.0 + luminance(bright));
}

@fragment
fn fs_glow(in: Covered) -> @location(0) vec4<f32> {
    let corner = vec2<i32>(in.clip.xy) * 2;
    let sum = glow(corner) + glow(corner + vec2<i32>(1, 0)) + glow(corner + vec2<i32>(0, 1)) + glow(corner + vec2<i32>(1, 1));
    return vec4<f32>(sum.rgb / sum.w, 1.0);
}

// Four bilinear readings cover four by four texels.
@fragment
fn fs_halve(in: Covered) -> @location(0) vec4<f32> {
    let step = 1.0 / vec2<f32>(textureDimensions(first));
    let at = in.clip.xy * 2.0 * step;
    return 0.25 * (textureSampleLevel(first, linear_sampler, at + vec2<f32>(-1.0, -1.0) * step, 0.0)
        + textureSampleLevel(first, linear_sampler, at + vec2<f32>(1.0, -1.0) * step, 0.0)
        + textureSampleLevel(first, linear_sampler, at + vec2<f32>(-1.0, 1.0) * step, 0.0)
        + textureSampleLevel(first, linear_sampler, at + vec2<f32>(1.0, 1.0) * step, 0.0));
}

// A level with the coarser ones: a tent over three by three texels of the next.
@fragment
fn fs_gather(in: Covered) -> @location(0) vec4<f32> {
    let step = 1.0 / vec2<f32>(textureDimensions(second));
    let at = in.clip.xy * 0.5 * step;
    var sum = vec3<f32>(0.0);
    for (var j = -1; j <= 1; j++) {
        for (var i = -1; i <= 1; i++) {
            let weight = f32((2 - abs(i)) * (2 - abs(j))) / 16.0;
            sum += weight * textureSampleLevel(second, linear_sampler, at + vec2<f32>(f32(i), f32(j)) * step, 0.0).rgb;
        }
    }
    return vec4<f32>(textureLoad(first, vec2<i32>(in.clip.xy), 0).rgb + sum, 1.0);
}
