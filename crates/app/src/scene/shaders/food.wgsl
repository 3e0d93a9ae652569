// Food: solid textures in the rest frame, so that a cut shows what the surface hides.

struct Food {
    world_from_rest: mat4x4<f32>,
    // Plane of the cut in the rest frame: normal and offset; offset is huge when there is no cut.
    cut: vec4<f32>,
    fat_origin: vec4<f32>,
    // 1 / extent of the fat volume.
    fat_scale: vec4<f32>,
};

@group(2) @binding(0) var<uniform> food: Food;
@group(2) @binding(1) var fat_volume: texture_3d<f32>;

struct FoodIn {
    @location(0) rest: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) lean: vec3<f32>,
    @location(3) browner: vec3<f32>,
    @location(4) fat: vec3<f32>,
    // Wetness, crust, field.
    @location(5) state: vec3<f32>,
    // In the present shape; rest is in the shape before cooking.
    @location(6) position: vec3<f32>,
};

struct FoodOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) rest: vec3<f32>,
    @location(2) normal: vec3<f32>,
    @location(3) lean: vec3<f32>,
    @location(4) browner: vec3<f32>,
    @location(5) fat: vec3<f32>,
    @location(6) state: vec3<f32>,
};

@vertex
fn vs_food(in: FoodIn) -> FoodOut {
    let world = food.world_from_rest * vec4<f32>(in.position, 1.0);
    let clip = frame.clip_from_world * world;
    return FoodOut(clip, world.xyz, in.rest, in.normal, in.lean, in.browner, in.fat, in.state);
}

fn hidden_by_cut(rest: vec3<f32>) -> bool {
    return dot(rest, food.cut.xyz) > food.cut.w + 1e-5;
}

// What the solid textures say at one place.
struct Flesh {
    // Colour under the light.
    colour: vec3<f32>,
    // Slope of the relief, rest frame.
    slope: vec3<f32>,
    fat: f32,
    // Free value in 0-1 on a scale of millimetres.
    patchy: f32,
    // Slope of the film that lies over the relief, and where the film is thick.
    film_slope: vec3<f32>,
    ridges: f32,
    // Burnt black (0-1).
    charred: f32,
};

// Bundles of fibres cut across: tone of the place, and the pale tissue between the larger bundles.
struct Fibres {
    tone: f32,
    seam: f32,
    // Where a crust cracks.
    crack: f32,
    // Between the small bundles.
    strand: f32,
};

fn fibres(rest: vec3<f32>, broad: vec4<f32>) -> Fibres {
    // Fibres run along z; the warp keeps them from being ruled lines.
    let warped = rest.xy + (broad.rg - 0.5) * 0.0022 + rest.z * vec2<f32>(0.06, -0.04);
    // Bundles of 0.8 mm in fascicles of 3.6 mm.
    let bundle = textureSample(bundle_picture, tile_sampler, warped * 78.0);
    let fascicle = textureSample(bundle_picture, tile_sampler, warped.yx * 17.3 + 0.29);
    let tone = 0.20 * (bundle.g - 0.5) + 0.16 * (fascicle.g - 0.5) - 0.10 * (1.0 - smoothstep(0.0, 0.5, bundle.r));
    let strand = 1.0 - smoothstep(0.0, 0.35, bundle.r);
    let seam = (1.0 - smoothstep(0.05, 0.24, fascicle.r)) * smoothstep(0.46, 0.66, broad.a);
    return Fibres(tone, seam, 1.0 - smoothstep(0.0, 0.26, fascicle.r), strand);
}

fn flesh(in: FoodOut, rest_normal: vec3<f32>) -> Flesh {
    let rest = in.rest;
    let crust = in.state.y;
    let uncooked = 1.0 - crust;
    // Char is the only thing that is as dark as this.
    let charred = crust * (1.0 - smoothstep(0.022, 0.050, dot(in.lean, vec3<f32>(0.21, 0.72, 0.07))));
    // Lattice cells of 8 mm, 2.3 mm, 0.5 mm and 0.2 mm; the small ones are drawn out along the fibres.
    let region = textureSample(solid_noise, tile_sampler, rest.zxy * 15.6 + 0.61);
    let broad = textureSample(solid_noise, tile_sampler, rest * 54.0);
    let grain = textureSample(solid_noise, tile_sampler, rest * vec3<f32>(250.0, 250.0, 42.0) + 0.37);
    let fine = textureSample(solid_noise, tile_sampler, rest.yxz * vec3<f32>(610.0, 610.0, 120.0) + 0.11);
    let fibre = fibres(rest, broad);
    let warped_fat = (rest + (broad.gbr - 0.5) * 0.0012 - food.fat_origin.xyz) * food.fat_scale.xyz;
    let fraction = textureSample(fat_volume, clamp_sampler, warped_fat).r;
    let fat = 0.92 * smoothstep(0.42, 0.92, fraction + (grain.a - 0.5) * 0.20);
    // Lean strands run through broad fat.
    let shown_fat = fat * (1.0 - 0.40 * fibre.strand - 0.35 * smoothstep(0.50, 0.66, broad.a));
    // The edge between face and side browns first.
    let upright = abs(rest_normal.z);
    let rim = smoothstep(0.10, 0.55, upright) * (1.0 - smoothstep(0.75, 0.995, upright));
    let mottle = 1.5 * (broad.a - 0.5) + 0.85 * (region.a - 0.5) + 0.45 * (grain.a - 0.5) + 0.6 * fibre.tone;
    var meat = mix(in.lean, in.browner, clamp(0.66 + 2.2 * mottle, 0.0, 1.0));
    // Where flesh is darker it is also redder: less light comes back out of it.
    let tone = 0.97 + fibre.tone * (0.35 + 0.95 * uncooked) + mix(0.42, 0.36, crust) * (grain.a - 0.5) + 0.26 * (fine.a - 0.5) + uncooked * (0.62 * (region.a - 0.5) + 0.30 * (broad.a - 0.5));
    meat *= vec3<f32>(tone, tone * tone, tone * tone) * (1.0 - 0.45 * rim * crust);
    meat = mix(meat, mix(meat, in.fat, 0.34), 0.30 * fibre.seam * uncooked);
    // Fat in a crust fries with the meat round it.
    let fatty = mix(in.fat * (0.80 + 0.18 * grain.a + 0.18 * broad.a), meat, 0.80 * smoothstep(0.0, 0.7, crust));
    let pits = 1.0 - crust * (0.10 + 0.34 * smoothstep(0.52, 0.26, grain.a) + 0.16 * smoothstep(0.56, 0.20, broad.a));
    let cracks = mix(1.0, (0.75 + 0.9 * broad.a) * (1.0 - 0.85 * fibre.crack), charred);
    let slope = (region.brg - 0.5) * 0.10 + (broad.rgb - 0.5) * (0.16 + 0.40 * crust) + (grain.rgb - 0.5) * (0.42 + 0.45 * crust) + (fine.grb - 0.5) * (0.22 + 0.50 * crust);
    let film_slope = (broad.rgb - 0.5) * 0.75 + (grain.rgb - 0.5) * 0.40;
    let ridges = smoothstep(0.49, 0.62, 0.55 * broad.a + 0.45 * grain.a);
    return Flesh(mix(meat, fatty, shown_fat) * pits * cracks, slope * (1.0 + 0.6 * charred), fat, broad.a, film_slope, ridges, charred);
}

// Height of what the food lies on.
fn support(position: vec3<f32>) -> f32 {
    let local = in_pan(position);
    let over_pan = local.z > 0.0 && dot(local.xy, local.xy) < frame.pan_shape.y * frame.pan_shape.y;
    if (over_pan) { return position.z - (local.z - frame.pan_place.w); }
    let on_board = position.x > frame.board.x && position.x < frame.board.z && position.y > frame.board.y && position.y < frame.board.w;
    return select(0.0, frame.mode.w, on_board);
}

fn world_normal(normal: vec3<f32>) -> vec3<f32> {
    return normalize((food.world_from_rest * vec4<f32>(normal, 0.0)).xyz);
}

fn lit_food(in: FoodOut) -> vec4<f32> {
    let rest_normal = normalize(in.normal);
    let look = flesh(in, rest_normal);
    let wetness = in.state.x * (1.0 - look.charred);
    let crust = in.state.y;
    let view = normalize(frame.eye.xyz - in.position);
    let slope = look.slope - rest_normal * dot(look.slope, rest_normal);
    let smooth_normal = world_normal(in.normal);
    let height = max(in.position.z - support(in.position), 0.0);
    let visibility = (0.30 + 0.70 * smoothstep(-0.001, 0.010, height)) * (0.80 + 0.20 * smooth_normal.z);
    let lit = shadow(in.position, smooth_normal);
    let bumpy = world_normal(rest_normal - slope * (0.85 - 0.35 * wetness));
    let wrap = vec3<f32>(0.26, 0.14, 0.10) * (1.0 - 0.85 * crust);
    let roughness = mix(mix(0.60, 0.80, crust), 0.45, wetness) - 0.12 * look.fat + 0.15 * look.charred;
    let body = Surface(look.colour, vec3<f32>(0.03), roughness, bumpy, visibility, wrap);
    var radiance = diffuse(body, lit) + look.colour * side_fill(smooth_normal) * visibility;
    radiance += specular(body, in.position, view, lit) * mix(0.42, 0.18, wetness) * (1.0 - 0.6 * look.charred);
    let film_slope = look.film_slope - rest_normal * dot(look.film_slope, rest_normal);
    radiance += sheen(in, look, rest_normal - film_slope * mix(0.8, 1.2, wetness), view, lit, visibility, wetness) * (0.35 + 0.65 * max(smooth_normal.z, 0.0));
    return pixel_from_radiance(radiance, in.clip.xy);
}

// The side that the cook sees gets the light that the room behind him gives back.
fn side_fill(normal: vec3<f32>) -> vec3<f32> {
    return FILL_FRONT * max(dot(normal, FRONT), 0.0) * (1.0 - max(normal.z, 0.0)) * 1.1;
}

// Reflections weaker than this do not count as glints (chosen).
const GLINT = 0.075;

// Water on raw flesh, oil on a crust: a thin film that breaks the window into small glints.
fn sheen(in: FoodOut, look: Flesh, bent: vec3<f32>, view: vec3<f32>, lit: f32, visibility: f32, wetness: f32) -> vec3<f32> {
    let oily = 0.45 * in.state.y * (1.0 - look.charred) * smoothstep(0.38, 0.62, look.patchy) * look.ridges;
    let film = max(wetness * (0.06 + 0.94 * look.ridges), oily);
    let coat = Surface(vec3<f32>(0.0), vec3<f32>(0.026), mix(0.30, 0.15, wetness), world_normal(bent), visibility, vec3<f32>(0.0));
    // Only the bright parts of the room show as glints; the rest would lie on the flesh like milk.
    return max(specular(coat, in.position, view, lit) - GLINT, vec3<f32>(0.0)) * (1.35 * film);
}

// A fresh cut is shown, not lit by the room: a soft light of its own lets crust, band, gradient and centre be read.
fn lit_cut(in: FoodOut) -> vec4<f32> {
    let rest_normal = normalize(in.normal);
    let look = flesh(in, rest_normal);
    let view = normalize(frame.eye.xyz - in.position);
    let slope = look.slope - rest_normal * dot(look.slope, rest_normal);
    let bent = world_normal(rest_normal - slope * 0.35);
    let shape = 0.95 + 0.17 * clamp(dot(bent, normalize(view + vec3<f32>(-0.3, 0.1, 0.9))), 0.0, 1.0);
    let moist = specular(Surface(vec3<f32>(0.0), vec3<f32>(0.024), 0.30, bent, 1.0, vec3<f32>(0.0)), in.position, view, 1.0);
    return pixel_from_radiance(look.colour * shape / WHITE + moist * 0.5 * in.state.x, in.clip.xy);
}

fn food_pixel(in: FoodOut) -> vec4<f32> {
    if (frame.mode.y > 0.5) {
        return vec4<f32>(lightly_lit(hatched_colour(in.state.z, in.clip.xy), world_normal(in.normal), 1.0), 1.0);
    }
    return lit_food(in);
}

@fragment
fn fs_food(in: FoodOut) -> @location(0) vec4<f32> {
    return food_pixel(in);
}

@fragment
fn fs_cut_face(in: FoodOut) -> @location(0) vec4<f32> {
    if (frame.mode.y > 0.5) { return food_pixel(in); }
    return lit_cut(in);
}

@fragment
fn fs_food_cut(in: FoodOut) -> @location(0) vec4<f32> {
    let pixel = food_pixel(in);
    if (hidden_by_cut(in.rest)) { discard; }
    return pixel;
}

// The part behind the cut stays visible as a veil, denser along its outline, so that the food reads as whole.
@fragment
fn fs_ghost(in: FoodOut) -> @location(0) vec4<f32> {
    if (!hidden_by_cut(in.rest)) { discard; }
    let view = normalize(frame.eye.xyz - in.position);
    let rim = 1.0 - abs(dot(world_normal(in.normal), view));
    let alpha = 0.05 + 0.30 * rim * rim * rim;
    return vec4<f32>(vec3<f32>(0.86, 0.84, 0.82) * alpha, alpha);
}

fn flat_pixel(in: FoodOut) -> vec4<f32> {
    if (frame.mode.y > 0.5) { return vec4<f32>(table_colour(in.state.z), 1.0); }
    return vec4<f32>(srgb_from_linear(in.lean), 1.0);
}

@fragment
fn fs_flat_food(in: FoodOut) -> @location(0) vec4<f32> {
    if (hidden_by_cut(in.rest)) { discard; }
    return flat_pixel(in);
}
