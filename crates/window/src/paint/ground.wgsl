// The ground of a panel: one colour with rounded corners, far cheaper on a software rasteriser than a textured mesh.

struct Ground {
    // Premultiplied, in the target's encoding.
    colour: vec4<f32>,
    // Half width, half height and corner radius [pixels].
    shape: vec4<f32>,
};

@group(0) @binding(0) var<uniform> grounds: array<Ground, 8>;

struct GroundOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,
    @location(1) @interpolate(flat) colour: vec4<f32>,
    @location(2) @interpolate(flat) shape: vec3<f32>,
};

@vertex
fn vs_ground(@builtin(vertex_index) vertex: u32) -> GroundOut {
    let ground = grounds[vertex / 3u];
    let corner = vertex % 3u;
    let ndc = vec2<f32>(f32(corner & 1u) * 4.0 - 1.0, f32(corner & 2u) * 2.0 - 1.0);
    return GroundOut(vec4<f32>(ndc, 0.0, 1.0), ndc * ground.shape.xy, ground.colour, ground.shape.xyz);
}

@fragment
fn fs_ground(in: GroundOut) -> @location(0) vec4<f32> {
    let beyond = max(abs(in.at) - in.shape.xy + in.shape.z, vec2<f32>(0.0));
    return in.colour * clamp(in.shape.z - length(beyond) + 0.5, 0.0, 1.0);
}
