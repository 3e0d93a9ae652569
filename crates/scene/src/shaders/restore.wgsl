// Puts the still picture and its depth back before what moves is drawn.

@group(0) @binding(0) var still_colour: texture_2d<f32>;
@group(0) @binding(1) var still_depth: texture_2d<f32>;
// Nearest. WebGL2 reads a depth texture as zeros unless a sampler without filtering is bound to it.
@group(0) @binding(2) var exact: sampler;

struct Restored {
    @location(0) colour: vec4<f32>,
    @builtin(frag_depth) depth: f32,
};

@vertex
fn vs_restore(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0);
    return vec4<f32>(corner, 0.0, 1.0);
}

@fragment
fn fs_restore(@builtin(position) at: vec4<f32>) -> Restored {
    let depth = textureSampleLevel(still_depth, exact, at.xy / vec2<f32>(textureDimensions(still_depth)), 0.0).r;
    return Restored(textureLoad(still_colour, vec2<i32>(at.xy), 0), depth);
}
