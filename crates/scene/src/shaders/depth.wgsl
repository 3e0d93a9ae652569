// Depth only: shadow map, contact map, and the depth of the still scene.

struct View {
    clip_from_world: mat4x4<f32>,
};

struct Pose {
    world_from_rest: mat4x4<f32>,
};

@group(0) @binding(0) var<uniform> view: View;
@group(1) @binding(0) var<uniform> pose: Pose;

@vertex
fn vs_solid_depth(@location(0) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    return view.clip_from_world * vec4<f32>(position, 1.0);
}

@vertex
fn vs_food_depth(@location(6) position: vec3<f32>) -> @builtin(position) vec4<f32> {
    return view.clip_from_world * pose.world_from_rest * vec4<f32>(position, 1.0);
}
