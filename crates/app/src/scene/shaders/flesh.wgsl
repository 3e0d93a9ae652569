// Colour of flesh from its state, as the core computes it: browning leads from the unbrowned colour over golden to
// crust, charring to black. The solid texture shifts the state and the colour from place to place, about their means.

struct Food {
    world_from_rest: mat4x4<f32>,
    // Plane of the cut in the rest frame: normal and offset; offset is huge when there is no cut.
    cut: vec4<f32>,
    // w = depth in a seam that the ends of the byte stand for.
    grain_origin: vec4<f32>,
    // 1 / extent of the volume; w = distance from a border that the end of the byte stands for [m].
    grain_scale: vec4<f32>,
    // L*a*b* / 100; w = browning at which it is golden.
    golden: vec4<f32>,
    crust: vec4<f32>,
    char: vec4<f32>,
    fat_brown: vec4<f32>,
    second: vec4<f32>,
    // Lines of the lower and the upper face: direction, phase, pitch; width, share of the browning that came on them.
    sear: array<vec4<f32>, 4>,
};

@group(2) @binding(0) var<uniform> food: Food;
@group(2) @binding(1) var grain_volume: texture_3d<f32>;

// What is known of the flesh at one place.
struct Flesh {
    // L*a*b* / 100 before browning, lean and fat.
    lean: vec3<f32>,
    fat: vec3<f32>,
    browning: f32,
    charring: f32,
    // Share of fat.
    fatty: f32,
};

fn linear_from_lab(lab: vec3<f32>) -> vec3<f32> {
    let fy = (lab.x + 0.16) / 1.16;
    let f = vec3<f32>(fy + lab.y / 5.0, fy, fy - lab.z / 2.0);
    let decoded = select((f - 4.0 / 29.0) * 0.12841855, f * f * f, f > vec3<f32>(6.0 / 29.0));
    let xyz = decoded * vec3<f32>(0.95047, 1.0, 1.08883);
    return clamp(vec3<f32>(
        dot(xyz, vec3<f32>(3.240454, -1.537139, -0.498531)),
        dot(xyz, vec3<f32>(-0.969266, 1.876011, 0.041556)),
        dot(xyz, vec3<f32>(0.055643, -0.204026, 1.057225))), vec3<f32>(0.0), vec3<f32>(1.0));
}

fn browned(base: vec3<f32>, golden: vec3<f32>, crust: vec3<f32>, browning: f32, charring: f32) -> vec3<f32> {
    let at = food.golden.w;
    let first = mix(base, golden, clamp(browning / at, 0.0, 1.0));
    let brown = mix(first, crust, clamp((browning - at) / (1.0 - at), 0.0, 1.0));
    return mix(brown, food.char.xyz, clamp(charring, 0.0, 1.0));
}

// Colour of flesh in L*a*b* / 100.
fn flesh_colour(flesh: Flesh) -> vec3<f32> {
    let lean = browned(flesh.lean, food.golden.xyz, food.crust.xyz, flesh.browning, flesh.charring);
    let crisp = mix(flesh.fat, food.fat_brown.xyz, 0.6);
    let fat = browned(flesh.fat, crisp, food.fat_brown.xyz, flesh.browning, flesh.charring);
    return mix(lean, fat, flesh.fatty);
}

// Seam depth, second tissue, border, tone of the sheath at a place of the rest frame.
struct Grown {
    fatty: f32,
    second: f32,
    // Distance from the nearest border of a tissue [m].
    border: f32,
    tone: f32,
};

// `footprint`: over how many pixels an edge of fat is smoothed, so that it has no stairs; its mean stays.
fn grown(rest: vec3<f32>, footprint: f32) -> Grown {
    let at = (rest - food.grain_origin.xyz) * food.grain_scale.xyz;
    let cell = textureSampleLevel(grain_volume, clamp_sampler, at, 0.0);
    let within = (cell.r * 2.0 - 1.0) * food.grain_origin.w;
    let blur = min(0.5 * footprint * fwidth(within), 1.5);
    let fatty = smoothstep(-0.5 - blur, 0.5 + blur, within);
    return Grown(fatty, cell.g, cell.b * food.grain_scale.w, cell.a);
}

// Browning of a face whose ridges seared lines into it: ahead on the lines, behind between them, its mean kept.
fn on_lines(browning: f32, rest: vec3<f32>, normal: vec3<f32>, waver: f32) -> f32 {
    let face = select(0u, 2u, normal.z > 0.0);
    let lines = food.sear[face];
    let width = food.sear[face + 1u].x;
    let share = food.sear[face + 1u].y * smoothstep(0.45, 0.85, abs(normal.z));
    if (lines.w <= 0.0 || share <= 0.0) { return browning; }
    let across = rest.x * lines.y - rest.y * lines.x - lines.z + waver;
    let away = abs(fract(across / lines.w + 0.5) - 0.5) * lines.w;
    let duty = clamp(width / lines.w, 0.05, 1.0);
    let on = 1.0 - smoothstep(0.35 * width, 0.70 * width, away);
    // As much as fits onto the lines lies on them; the rest lies between.
    let line = min(browning / duty, 1.0);
    let between = max(browning - duty * line, 0.0) / max(1.0 - duty, 0.05);
    return mix(browning, mix(between, line, on), share);
}
