// Colour of flesh from its state, as the core computes it: browning leads from the unbrowned colour over golden to
// crust, charring to black. The solid texture shifts the state and the colour from place to place, about their means.

struct Food {
    world_from_rest: mat4x4<f32>,
    // Its place in the solid textures [m]; w = 1 where it grew along x.
    place: vec4<f32>,
    // w = depth in a seam that the ends of the byte represent.
    grain_origin: vec4<f32>,
    // 1 / extent of the volume; w = distance from a border that the end of the byte represents [m].
    grain_scale: vec4<f32>,
    // L*a*b* / 100; w = browning at which it is golden.
    golden: vec4<f32>,
    crust: vec4<f32>,
    char: vec4<f32>,
    fat_brown: vec4<f32>,
    second: vec4<f32>,
    // Two sets of lines for the lower and for the upper face: direction, phase, pitch; width, share of the browning that came
    // on these ridges, browning on the lines and between; charring on the lines and between.
    sear: array<vec4<f32>, 12>,
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

// Fat at a place as it is seen near by.
struct Fat {
    grew: Grown,
    // Where the silver-skin is, and where the fat is creased (0-1).
    silver: f32,
    crease: f32,
};

// How far round about a place fat is looked for to tell a cap from a seam [m], how far the border of a cap strays by region
// [m], how much the lace of thin seams adds to the depth in fat, and the share of it that is seam (chosen: the mean stays).
const CAP_ROUND = 0.0032;
const CAP_STRAYS = 0.0125;
const LACE = 1.7;
const LACE_SHARE = 0.44;
// Share of the lean that is seen through a thin seam (chosen).
const THIN = 0.42;
// How much softer the edge of a thin seam is (chosen: it lies at a slant in the flesh, which is seen through it).
const MELTS = 0.5;
// Patterns of the lace over a metre, across and along the fibres.
const LACES = vec3<f32>(105.0, 105.0, 74.0);

// 1 within a cap, 0 at its border, less at a thin seam.
fn capped(at: vec3<f32>) -> f32 {
    let x = vec3<f32>(CAP_ROUND, 0.0, 0.0) * food.grain_scale.xyz;
    let y = vec3<f32>(0.0, CAP_ROUND, 0.0) * food.grain_scale.xyz;
    let round = textureSampleLevel(grain_volume, clamp_sampler, at + x, 0.0).r + textureSampleLevel(grain_volume, clamp_sampler, at - x, 0.0).r
        + textureSampleLevel(grain_volume, clamp_sampler, at + y, 0.0).r + textureSampleLevel(grain_volume, clamp_sampler, at - y, 0.0).r;
    return 0.5 * round - 1.0;
}

// Fat finer than the volume has it: seams fray into lace along the fibres, a cap interlocks with the lean.
fn fat_near(rest: vec3<f32>, stray: vec3<f32>) -> Fat {
    let place = rest + food.place.xyz;
    let far = textureSampleLevel(solid_noise, tile_sampler, place.yxz * 9.0 + 0.41, 0.0).rgb - 0.5;
    let fine_grain = textureSample(solid_noise, tile_sampler, place * LACES + 0.13);
    let bent = rest + stray + far * CAP_STRAYS + (fine_grain.gbr - 0.5) * 0.0008;
    let at = (bent - food.grain_origin.xyz) * food.grain_scale.xyz;
    let cell = textureSampleLevel(grain_volume, clamp_sampler, at, 0.0);
    let cap = capped(at);
    let loose = 1.0 - smoothstep(-0.15, 0.35, cap);
    let lace = 1.0 - smoothstep(0.02, 0.10, abs(fine_grain.a - 0.5));
    let within = (cell.r * 2.0 - 1.0) * food.grain_origin.w + LACE * (lace - LACE_SHARE) * loose;
    let blur = min(0.5 * fwidth(within), 1.5);
    let through = THIN * loose * (1.0 - smoothstep(-0.3, 5.0, within));
    let soft = 0.5 + blur + MELTS * loose;
    let fatty = smoothstep(-soft, soft, within) * (1.0 - through);
    let silver = (1.0 - smoothstep(0.2, 1.1, abs(within + 0.3))) * smoothstep(-0.32, -0.05, cap);
    let folds = textureSampleLevel(solid_noise, tile_sampler, place * vec3<f32>(16.0, 16.0, 30.0) + 0.67, 0.0);
    let crease = (1.0 - smoothstep(0.0, 0.07, abs(folds.a + 0.10 * (fine_grain.a - 0.5) - 0.5))) * smoothstep(0.45, 0.65, folds.r);
    return Fat(Grown(fatty, cell.g, cell.b * food.grain_scale.w, cell.a), silver, crease * fatty);
}

// Sets of lines on each face, and the data of a set.
const SEAR_SETS = 2u;
const SEAR_ROWS = 3u;

// What ridges seared into a place.
struct Seared {
    browning: f32,
    charring: f32,
    // Share of the face's browning that came on ridges.
    share: f32,
};

// Browning and charring of a face into which ridges seared lines: what came on them is on the lines, what is more than
// fits there is between, and what came elsewhere is as the mesh has it.
fn on_lines(browning: f32, charring: f32, strength: f32, rest: vec3<f32>, normal: vec3<f32>, waver: f32) -> Seared {
    let face = select(0u, SEAR_SETS * SEAR_ROWS, normal.z > 0.0);
    let facing = smoothstep(0.45, 0.85, abs(normal.z));
    var share = 0.0;
    var came = vec2<f32>(0.0);
    for (var k = 0u; k < SEAR_SETS; k++) {
        let at = face + k * SEAR_ROWS;
        let lines = food.sear[at];
        if (lines.w <= 0.0) { break; }
        let told = food.sear[at + 1u];
        let across = rest.x * lines.y - rest.y * lines.x - lines.z + waver;
        let away = abs(fract(across / lines.w + 0.5) - 0.5) * lines.w;
        let on = 1.0 - smoothstep(0.30 * told.x, 0.70 * told.x, away);
        share += told.y;
        came += mix(vec2<f32>(told.w, food.sear[at + 2u].y), vec2<f32>(told.z, food.sear[at + 2u].x), on) * strength;
    }
    share *= facing;
    let seared = vec2<f32>(browning, charring) * max(1.0 - share, 0.0) + came * facing;
    return Seared(min(seared.x, 1.0), min(seared.y, 1.0), share);
}
