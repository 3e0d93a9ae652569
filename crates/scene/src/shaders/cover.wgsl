// Begins every overlay's shader: one triangle over the whole of the viewport, and what targets that encode sRGB need.

struct Covered {
    @builtin(position) clip: vec4<f32>,
    // Shares of the viewport's sides, from its upper left corner.
    @location(0) uv: vec2<f32>,
};

@vertex
fn vs_cover(@builtin(vertex_index) index: u32) -> Covered {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return Covered(vec4<f32>(corner.x * 2.0 - 1.0, 1.0 - corner.y * 2.0, 0.0, 1.0), corner);
}

fn linear_from_srgb(c: vec3<f32>) -> vec3<f32> {
    return select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c <= vec3<f32>(0.04045));
}

