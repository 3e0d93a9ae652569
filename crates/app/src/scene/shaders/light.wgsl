// Light of the room on a surface: window (shadowed), lamp, fill, and reflections from the environment picture.

@group(1) @binding(0) var shadow_map: texture_depth_2d;
@group(1) @binding(1) var contact_map: texture_depth_2d;
@group(1) @binding(2) var depth_sampler: sampler_comparison;
@group(1) @binding(3) var environment: texture_2d<f32>;
@group(1) @binding(4) var clamp_sampler: sampler;
@group(1) @binding(5) var solid_noise: texture_3d<f32>;
@group(1) @binding(6) var bundle_picture: texture_2d<f32>;
@group(1) @binding(7) var tile_sampler: sampler;
@group(1) @binding(8) var colour_table: texture_2d<f32>;
@group(1) @binding(9) var table_sampler: sampler;
// Oil, water, fond, foam on the floor of the pan.
@group(1) @binding(10) var pan_film: texture_2d<f32>;
// Reflectance of the unrolled inside of the pan over that of a new one, halved.
@group(1) @binding(11) var pan_tint: texture_2d<f32>;

// Irradiance / pi of window, lamp and fill (chosen; the window matches the radiance in the environment picture).
const KEY = vec3<f32>(2.15, 2.12, 2.05);
const LAMP = vec3<f32>(0.80, 0.55, 0.30);
const FILL_SKY = vec3<f32>(0.33, 0.32, 0.31);
const FILL_GROUND = vec3<f32>(0.13, 0.12, 0.11);
// Light that comes back from the room behind the cook.
const FILL_FRONT = vec3<f32>(0.52, 0.49, 0.44);
const FRONT = vec3<f32>(0.12, -0.84, 0.53);

struct Surface {
    albedo: vec3<f32>,
    // Reflectance at normal incidence.
    f0: vec3<f32>,
    roughness: f32,
    normal: vec3<f32>,
    // Share of the room seen from here (0-1).
    visibility: f32,
    // How far light creeps round the terminator (0-1), by colour: light scattered under the surface.
    wrap: vec3<f32>,
};

// True takes more samples of the depth maps.
override fine: bool = false;
// True leaves the patterns of the surroundings out and takes one sample of the depth maps: the eye is moving.
override quick: bool = false;

fn depth_test(map: texture_depth_2d, uv: vec2<f32>, step: f32, depth: f32) -> f32 {
    if (fine) {
        var sum = 0.0;
        for (var j = -1; j <= 1; j++) {
            for (var i = -1; i <= 1; i++) {
                sum += textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(f32(i), f32(j)) * step * 1.25, depth);
            }
        }
        return sum / 9.0;
    }
    if (quick) { return textureSampleCompareLevel(map, depth_sampler, uv, depth); }
    return 0.25 * (textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(0.4, 1.0) * step, depth)
        + textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(-1.0, 0.4) * step, depth)
        + textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(-0.4, -1.0) * step, depth)
        + textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(1.0, -0.4) * step, depth));
}

// Share of the window's light that arrives; the softness is the window's size seen from a few centimetres (chosen).
fn shadow(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let at = frame.light_from_world * vec4<f32>(position + normal * 0.0014, 1.0);
    return depth_test(shadow_map, at.xy * vec2<f32>(0.5, -0.5) + 0.5, frame.key.w, at.z - 0.0009);
}

// 1 in the open, lower where food hangs just above; never dark, as under a cut food the ground is seen through its
// ghost (chosen).
fn openness(position: vec3<f32>) -> f32 {
    let uv = (position.xy - frame.contact_rect.xy) * frame.contact_rect.zw;
    let low = (position.z + 0.006 - frame.contact_height.x) * frame.contact_height.y;
    return mix(0.5, 1.0, depth_test(contact_map, uv, frame.contact_height.z, low));
}

// Radiance from a direction, blurred for the roughness. The room is near: a step aside shifts the reflection.
fn reflected(position: vec3<f32>, direction: vec3<f32>, roughness: f32) -> vec3<f32> {
    let d = normalize(direction + position * 1.5);
    let uv = d.xy / (1.0 + max(d.z, -0.2)) * 0.5 + 0.5;
    var level = sqrt(roughness) * roughness * frame.lamp.w;
    // One level is read faster than two.
    if (quick) { level = round(level); }
    let above = smoothstep(-0.25, 0.0, d.z);
    return textureSampleLevel(environment, clamp_sampler, uv, level).rgb * mix(0.10, 1.0, above);
}

// Integral of the GGX lobe over a uniform environment (polynomial fit for split-sum image-based lighting).
fn lobe(f0: vec3<f32>, roughness: f32, n_dot_v: f32) -> vec3<f32> {
    let r = roughness * vec4<f32>(-1.0, -0.0275, -0.572, 0.022) + vec4<f32>(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    let scale = vec2<f32>(-1.04, 1.04) * a + r.zw;
    return f0 * scale.x + scale.y;
}

fn diffuse(s: Surface, lit: f32) -> vec3<f32> {
    let n_dot_l = dot(s.normal, frame.key.xyz);
    let key = max((vec3<f32>(n_dot_l) + s.wrap) / (1.0 + s.wrap), vec3<f32>(0.0)) * (lit + s.wrap * 0.2 * (1.0 - lit));
    let n_dot_lamp = max(dot(s.normal, frame.lamp.xyz) * 0.75 + 0.25, 0.0);
    let fill = mix(FILL_GROUND, FILL_SKY, s.normal.z * 0.5 + 0.5) + FILL_FRONT * max(dot(s.normal, FRONT), 0.0);
    return s.albedo * (KEY * key + (LAMP * n_dot_lamp + fill) * s.visibility);
}

fn specular(s: Surface, position: vec3<f32>, view: vec3<f32>, lit: f32) -> vec3<f32> {
    let n_dot_v = clamp(dot(s.normal, view), 0.02, 1.0);
    let towards = reflect(-view, s.normal);
    let occlusion = mix(s.visibility * s.visibility, 1.0, 0.15) * mix(0.55, 1.0, lit);
    return reflected(position, towards, s.roughness) * lobe(s.f0, s.roughness, n_dot_v) * occlusion;
}

// Field colour as sRGB; decoded to linear only where it is lit.
fn table_colour(coordinate: f32) -> vec3<f32> {
    let u = (clamp(coordinate, 0.0, 1.0) * 255.0 + 0.5) / 256.0;
    return textureSampleLevel(colour_table, table_sampler, vec2<f32>(u, 0.5), 0.0).rgb;
}

// Light enough that shape reads, even enough that colours can be compared with the legend; stays in sRGB.
fn lightly_lit(colour: vec3<f32>, normal: vec3<f32>, open: f32) -> vec3<f32> {
    let light = 0.80 + 0.20 * dot(normal, normalize(frame.key.xyz + vec3<f32>(0.0, -0.4, 0.6)));
    return colour * light * mix(0.8, 1.0, open);
}

fn floor_field(radius: f32) -> f32 {
    let at = clamp(radius / frame.pan_shape.x, 0.0, 1.0) * 15.0;
    let low = u32(floor(at));
    let high = min(low + 1u, 15u);
    let a = frame.floor_field[low / 4u][low % 4u];
    let b = frame.floor_field[high / 4u][high % 4u];
    return mix(a, b, fract(at));
}
