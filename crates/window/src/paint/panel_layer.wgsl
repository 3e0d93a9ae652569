// Lays the kept picture of the panels over the scene.

@group(0) @binding(0) var panels: texture_2d<f32>;

@fragment
fn fs_panels(in: Covered) -> @location(0) vec4<f32> {
    return textureLoad(panels, vec2<i32>(in.clip.xy), 0);
}
