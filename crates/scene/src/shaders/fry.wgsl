// Fat and juice round a frying food: a ring that climbs its side, and bubbles in it.

struct FryOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    // Bubble, drop and spot: place on the disc. Ring: outward direction.
    @location(1) corner: vec2<f32>,
    // Opacity, random value; a ring has -1 - (share of its width), a drop in the air 2, a spot of oil 4.
    @location(2) look: vec2<f32>,
};

@vertex
fn vs_fry(in: PuffIn) -> FryOut {
    let place = in.position + vec3<f32>(in.corner * in.look.x, 0.0);
    return FryOut(frame.clip_from_world * vec4<f32>(place, 1.0), place, in.corner, in.look.yz);
}

// How far the place on the disc moves within a pixel: what is smaller than a pixel has no sharp glint.
var<private> disc_turn: vec2<f32>;

fn liquid(normal: vec3<f32>, position: vec3<f32>) -> vec3<f32> {
    let s = Surface(vec3<f32>(0.0), vec3<f32>(0.045), widened(0.10, vec3<f32>(disc_turn, 0.0)), normal, 1.0, vec3<f32>(0.0));
    return specular(s, position, normalize(frame.eye.xyz - position), 1.0);
}

// A dark film, steep at the food and flat outside.
fn ring(in: FryOut) -> vec4<f32> {
    let noise = textureSampleLevel(solid_noise, tile_sampler, in.position * 26.0, 0.0).a - 0.5;
    let across = clamp(-1.0 - in.look.y + 0.9 * noise * (-1.0 - in.look.y), 0.0, 1.0);
    let steep = (1.0 - across) * (1.0 - across);
    let normal = normalize(vec3<f32>(in.corner * 1.6 * steep, 1.0));
    let alpha = in.look.x * (1.0 - smoothstep(0.25, 0.85, across)) * 0.7;
    let juice = vec3<f32>(0.075, 0.045, 0.020);
    return vec4<f32>(pixel_from_radiance(juice + liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

// A dome of clear fat: dark at its foot, with the window in it.
fn bubble(in: FryOut) -> vec4<f32> {
    let away = dot(in.corner, in.corner);
    let normal = vec3<f32>(in.corner * 0.92, sqrt(max(1.0 - 0.85 * away, 0.02)));
    let alpha = in.look.x * smoothstep(1.0, 0.80, away) * mix(0.30, 0.75, away * away);
    let fat = vec3<f32>(0.16, 0.115, 0.06) * (1.15 - away);
    return vec4<f32>(pixel_from_radiance(fat + 2.2 * liquid(normalize(normal), in.position), in.clip.xy).rgb * alpha, alpha);
}

// A drop in the air: amber, bright along its middle where it catches the window.
fn drop(in: FryOut) -> vec4<f32> {
    let away = dot(in.corner, in.corner);
    let body = smoothstep(1.0, 0.45, away);
    let glint = smoothstep(0.55, 0.05, away);
    let colour = vec3<f32>(0.30, 0.22, 0.10) + vec3<f32>(0.55, 0.50, 0.40) * glint;
    let alpha = in.look.x * body * 0.85;
    return vec4<f32>(pixel_from_radiance(colour, in.clip.xy).rgb * alpha, alpha);
}

// A low cap of oil that lies still: faint in its middle, a darker edge, the window in it.
fn spot(in: FryOut) -> vec4<f32> {
    let away = dot(in.corner, in.corner);
    let normal = normalize(vec3<f32>(in.corner * 0.45, 1.0));
    let alpha = smoothstep(1.0, 0.70, away) * mix(0.40, 0.65, away * away);
    let fat = vec3<f32>(0.085, 0.060, 0.024);
    return vec4<f32>(pixel_from_radiance(fat + 0.32 * liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

@fragment
fn fs_fry(in: FryOut) -> @location(0) vec4<f32> {
    disc_turn = fwidth(in.corner);
    if (in.look.y < 0.0) { return ring(in); }
    if (in.look.y >= 4.0) { return spot(in); }
    if (in.look.y >= 2.0) { return drop(in); }
    return bubble(in);
}
