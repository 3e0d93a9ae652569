// What is behind the sharp part of the picture, blurred as a lens would: half size, only light from behind is gathered.

const TAPS = 22;
// Turn from one reading to the next on the spiral: the golden angle [rad].
const GOLDEN = 2.39996323;

// Light and weight of a pixel that is out of focus.
fn behind(pixel: vec2<i32>, reach: f32) -> vec4<f32> {
    let last = vec2<i32>(textureDimensions(first)) - 1;
    let at = clamp(pixel, vec2<i32>(0), last);
    let own = confusion(distance_at(at));
    // Only a circle that is wide enough reaches here; what is sharp stays where it is.
    let weight = smoothstep(0.4, 1.2, own) * clamp(0.5 * own - reach + 1.0, 0.0, 1.0);
    return vec4<f32>(min(radiance_from_target(textureLoad(first, at, 0).rgb), vec3<f32>(BRIGHTEST)), 1.0) * weight;
}

@fragment
fn fs_behind(in: Covered) -> @location(0) vec4<f32> {
    let centre = in.clip.xy * 2.0;
    var widest = 0.0;
    for (var k = 0; k < 8; k++) {
        let angle = f32(k) * 0.78539816;
        let at = vec2<i32>(centre + vec2<f32>(cos(angle), sin(angle)) * 3.0);
        widest = max(widest, confusion(distance_at(at)));
    }
    widest = max(widest, confusion(distance_at(vec2<i32>(centre))));
    if (widest < 0.4) { return vec4<f32>(0.0); }
    let turn = noise_at(floor(centre)) * 6.2831853;
    var sum = behind(vec2<i32>(centre), 0.0);
    for (var k = 1; k <= TAPS; k++) {
        let reach = 0.5 * widest * sqrt(f32(k) / f32(TAPS));
        let angle = turn + f32(k) * GOLDEN;
        sum += behind(vec2<i32>(centre + vec2<f32>(cos(angle), sin(angle)) * reach), reach);
    }
    let share = min(sum.a, 1.0);
    return vec4<f32>(sum.rgb / max(sum.a, 1e-4) * share, share);
}
