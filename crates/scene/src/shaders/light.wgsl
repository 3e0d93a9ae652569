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

// Share of the room's light that the neighbourhood lets through, half the size of the picture.
@group(1) @binding(12) var ambient: texture_2d<f32>;

// FRONT and OTHER_WRAP are those of `room_light.rs`.

// Three values from 0 to 1 of a cell, without a sine: that one differs from device to device.
fn random3(at: vec3<f32>) -> vec3<f32> {
    var p = fract(at * vec3<f32>(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.xxy + p.yxx) * p.zyx);
}

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
// True adds shadows where food touches the ground, and takes still more samples: there is a graphics card.
override contact: bool = false;

fn depth_test(map: texture_depth_2d, uv: vec2<f32>, step: vec2<f32>, depth: f32) -> f32 {
    if (contact) {
        var sum = 0.0;
        for (var j = -2; j <= 2; j++) {
            for (var i = -2; i <= 2; i++) {
                sum += textureSampleCompareLevel(map, depth_sampler, uv + vec2<f32>(f32(i), f32(j)) * step * 0.7, depth);
            }
        }
        return sum / 25.0;
    }
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

// Width over height of what the coarse part of the shadow map shows, and the part of the fine one that is used (chosen: its
// edge has room for the samples).
const SHADOW_ASPECT = 1.0 / 0.82;
const SHADOW_USED = 0.97;

// Share of the light that casts shadows that arrives. The map's left half shows the food finely, its right half everything.
fn shadow(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let at = frame.light_from_world * vec4<f32>(position + normal * 0.0010, 1.0);
    let near = (at.xy - frame.shadow_fine.xy) * frame.shadow_fine.z;
    let is_near = max(abs(near.x), abs(near.y)) < SHADOW_USED;
    if (!is_near && max(abs(at.x), abs(at.y)) > SHADOW_USED) { return 1.0; }
    let place = select(at.xy, near, is_near);
    let uv = (place * vec2<f32>(0.5, -0.5) + 0.5) * vec2<f32>(0.5, 1.0) + vec2<f32>(select(0.5, 0.0, is_near), 0.0);
    let step = vec2<f32>(0.5, SHADOW_ASPECT) * frame.shadow_fine.w * select(1.0, frame.shadow_fine.z, is_near);
    // A finer map needs less room between a surface and its own image.
    return depth_test(shadow_map, uv, step, at.z - select(0.0012, 0.0006, is_near));
}

// How thick a food is taken to be, as only its underside is known [m] (chosen: between a coin of carrot and a steak).
const CONTACT_THICKNESS = 0.010;
// Steps towards the window and how far they reach [m] (chosen: where the shadow map's bias lets light in under a food).
const CONTACT_STEPS = 8;
const CONTACT_REACH = 0.009;
// Directions round about, their slope, and how far food shades the ground [m] (chosen: under the round edge of a steak
// nothing is free).
const ROUND = 12;
const ROUND_SLOPE = 0.45;
const ROUND_REACH = 0.022;

// 1 inside a food, by the heights of the undersides; near the ground only, as they give no information about the tops.
fn inside_food(at: vec3<f32>) -> f32 {
    let uv = (at.xy - frame.contact_rect.xy) * frame.contact_rect.zw;
    let height = (at.z - frame.contact_height.x) * frame.contact_height.y;
    let thick = CONTACT_THICKNESS * frame.contact_height.y;
    let over = 1.0 - textureSampleCompareLevel(contact_map, depth_sampler, uv, height);
    return over * textureSampleCompareLevel(contact_map, depth_sampler, uv, height - thick);
}

// Share of the window's light that gets past the foot of the food close by.
fn past_contact(position: vec3<f32>) -> f32 {
    if (!contact) { return 1.0; }
    var dark = 0.0;
    for (var i = 0; i < CONTACT_STEPS; i++) {
        let share = (f32(i) + 0.5) / f32(CONTACT_STEPS);
        let at = position + frame.key.xyz * (CONTACT_REACH * share * share);
        dark = max(dark, inside_food(at) * (1.0 - share * share));
    }
    return 1.0 - dark;
}

// Share of the room's light that food close by leaves: a wall takes the squared sine of its height above the horizon.
fn free_round(position: vec3<f32>) -> f32 {
    var shut = 0.0;
    for (var k = 0; k < ROUND; k++) {
        let turn = 6.2831853 * (f32(k) + 0.5) / f32(ROUND);
        let towards = vec3<f32>(cos(turn), sin(turn), ROUND_SLOPE);
        var nearest = 0.0;
        for (var reach = 0.0010; reach < ROUND_REACH; reach *= 1.5) {
            let wall = CONTACT_THICKNESS * CONTACT_THICKNESS / (CONTACT_THICKNESS * CONTACT_THICKNESS + reach * reach);
            let fading = 1.0 - smoothstep(0.6, 1.0, reach / ROUND_REACH);
            nearest = max(nearest, inside_food(position + towards * reach) * wall * fading);
        }
        shut += nearest;
    }
    return 1.0 - shut / f32(ROUND);
}

// As `shadow`, on what food lies on.
fn shadow_on_ground(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    return min(shadow(position, normal), past_contact(position));
}

// 1 in the open, lower where food hangs just above or is next to it; never dark, as under a cut food the ground is seen
// through its ghost (chosen).
fn openness(position: vec3<f32>) -> f32 {
    if (contact) { return max(0.3, free_round(position)); }
    let uv = (position.xy - frame.contact_rect.xy) * frame.contact_rect.zw;
    let low = (position.z + 0.006 - frame.contact_height.x) * frame.contact_height.y;
    return mix(0.5, 1.0, depth_test(contact_map, uv, vec2<f32>(frame.contact_height.z), low));
}

// Share of the room's light at a pixel, by what is seen round it; the pan's corners and the foot of food have theirs as well.
fn nearby(pixel: vec2<f32>) -> f32 {
    if (!hdr) { return 1.0; }
    return textureSampleLevel(ambient, clamp_sampler, pixel * 0.5 / vec2<f32>(textureDimensions(ambient)), 0.0).r;
}

// Radiance from a direction, blurred for the roughness. The room is near: a step aside shifts the reflection.
fn reflected(position: vec3<f32>, direction: vec3<f32>, roughness: f32) -> vec3<f32> {
    let d = normalize(direction + position * 1.5);
    let uv = d.xy / (1.0 + max(d.z, -0.2)) * 0.5 + 0.5;
    var level = sqrt(roughness) * roughness * frame.other.w;
    // One level is read faster than two.
    if (quick) { level = round(level); }
    let above = smoothstep(-0.25, 0.0, d.z);
    return textureSampleLevel(environment, clamp_sampler, uv, level).rgb * mix(0.10, 1.0, above);
}

// Roughness where the normal turns within a pixel: its glints spread over the pixel instead of flickering.
fn widened(roughness: f32, turn: vec3<f32>) -> f32 {
    return min(sqrt(roughness * roughness + 0.16 * dot(turn, turn)), max(roughness, 0.6));
}

// Integral of the GGX lobe over a uniform environment (polynomial fit for split-sum image-based lighting).
fn lobe(f0: vec3<f32>, roughness: f32, n_dot_v: f32) -> vec3<f32> {
    let r = roughness * vec4<f32>(-1.0, -0.0275, -0.572, 0.022) + vec4<f32>(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    let scale = vec2<f32>(-1.04, 1.04) * a + r.zw;
    return f0 * scale.x + scale.y;
}

// Share of the dome's light that arrives in this sample of it: as the mean of all of them, that of the directions that are open.
fn from_dome(normal: vec3<f32>, lit: f32) -> f32 {
    let faced = smoothstep(-0.05, 0.05, dot(normal, frame.key.xyz));
    return lit * faced * 2.0 / max(1.0 + normal.z, 0.3);
}

fn diffuse(s: Surface, lit: f32) -> vec3<f32> {
    let n_dot_l = dot(s.normal, frame.key.xyz);
    let key = max((vec3<f32>(n_dot_l) + s.wrap) / (1.0 + s.wrap), vec3<f32>(0.0)) * (lit + s.wrap * 0.2 * (1.0 - lit));
    let n_dot_other = max(dot(s.normal, frame.other.xyz) * (1.0 - OTHER_WRAP) + OTHER_WRAP, 0.0);
    let round = select(s.visibility, from_dome(s.normal, lit), frame.origin.z > 0.5);
    let upwards = s.normal.z * 0.5 + 0.5;
    let above = frame.fill_sky.rgb * upwards + frame.fill_front.rgb * max(dot(s.normal, FRONT), 0.0);
    let below = frame.other_light.rgb * n_dot_other + frame.fill_ground.rgb * (1.0 - upwards);
    return s.albedo * (frame.key_light.rgb * key + below * s.visibility + above * round);
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
