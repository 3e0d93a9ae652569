// Puffs of steam, smoke and flame: soft sprites that face the eye.

struct PuffIn {
    @location(0) position: vec3<f32>,
    // Corner of the sprite, -1 to 1.
    @location(1) corner: vec2<f32>,
    // Half size [m], opacity, random value.
    @location(2) look: vec3<f32>,
};

struct PuffOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) corner: vec2<f32>,
    @location(1) look: vec2<f32>,
};

@vertex
fn vs_steam(in: PuffIn) -> PuffOut {
    let forward = normalize(in.position - frame.eye.xyz);
    let right = normalize(cross(forward, vec3<f32>(0.0, 0.0, 1.0)) + vec3<f32>(1e-4, 0.0, 0.0));
    let up = cross(right, forward);
    let offset = (right * in.corner.x + up * in.corner.y * 1.35) * in.look.x;
    return PuffOut(frame.clip_from_world * vec4<f32>(in.position + offset, 1.0), in.corner, in.look.yz);
}

@fragment
fn fs_steam(in: PuffOut) -> @location(0) vec4<f32> {
    let away = dot(in.corner, in.corner);
    let wisp = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(in.corner * vec2<f32>(0.16, 0.10), in.look.y), 0.0).a;
    let body = max(1.0 - away, 0.0);
    let alpha = body * body * smoothstep(0.30, 0.75, wisp + 0.12) * in.look.x;
    if (in.look.y >= 4.0) {
        // A flame gives light: yellow at its heart, orange at its edge, and hides little.
        let heart = smoothstep(0.0, 0.6, body * (0.6 + 0.8 * wisp));
        return vec4<f32>(mix(vec3<f32>(0.95, 0.30, 0.04), vec3<f32>(1.0, 0.82, 0.36), heart) * alpha, 0.35 * alpha);
    }
    if (in.look.y >= 2.0) { return vec4<f32>(vec3<f32>(0.56, 0.60, 0.68) * alpha, alpha); }
    return vec4<f32>(vec3<f32>(0.86, 0.87, 0.88) * alpha, alpha);
}
