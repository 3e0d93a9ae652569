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
    let world = food.world_from_rest * vec4<f32>(in.rest, 1.0);
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
};

fn flesh(rest: vec3<f32>, lean: vec3<f32>, browner: vec3<f32>, fat_colour: vec3<f32>, crust: f32) -> Flesh {
    // Lattice cells of 2.5 mm and of 0.45 mm.
    let broad = textureSample(solid_noise, tile_sampler, rest * 50.0);
    let grain = textureSample(solid_noise, tile_sampler, rest.yzx * 277.0 + 0.37);
    // Bundles of about 1.3 mm run along z; the warp keeps them from being ruled lines.
    let warped = rest.xy + (broad.rg - 0.5) * 0.0022 + rest.z * vec2<f32>(0.06, -0.04);
    let bundle = textureSample(bundle_picture, tile_sampler, warped * 48.0);
    let warped_fat = (rest + (broad.gbr - 0.5) * 0.0016 - food.fat_origin.xyz) * food.fat_scale.xyz;
    let fraction = textureSample(fat_volume, clamp_sampler, warped_fat).r;
    let fat = smoothstep(0.20, 0.48, fraction + (grain.a - 0.5) * 0.22);
    let seam = 1.0 - smoothstep(0.0, 0.28, bundle.r);
    // Fields of browning of about a centimetre.
    let region = textureSample(solid_noise, tile_sampler, rest.zxy * 17.0 + 0.61);
    let uncooked = 1.0 - crust;
    let mottle = 0.52 * region.a + 0.26 * broad.a + 0.10 * grain.a + 0.12 * bundle.g;
    let brown = smoothstep(0.36, 0.64, mottle);
    var meat = mix(lean, browner, brown);
    meat *= 1.0 + mix(0.12, 0.30, uncooked) * (bundle.g - 0.5) + 0.30 * (grain.a - 0.5) + 0.25 * uncooked * (region.a - 0.5);
    meat = mix(meat, mix(meat, fat_colour, 0.30), seam * uncooked * 0.42);
    // Fat in a crust fries with the meat round it.
    let fatty = mix(fat_colour * (0.90 + 0.2 * grain.a), meat, 0.62 * crust);
    let pits = 1.0 - crust * (0.40 * smoothstep(0.50, 0.30, grain.a) + 0.35 * smoothstep(0.45, 0.25, broad.a));
    let slope = (region.brg - 0.5) * 0.35 + (broad.rgb - 0.5) * (0.22 + 0.45 * crust) + (grain.gbr - 0.5) * (0.20 + 0.75 * crust);
    return Flesh(mix(meat, fatty, fat) * pits, slope, fat, broad.a);
}

// Height of what the food lies on.
fn support(position: vec3<f32>) -> f32 {
    let local = position.xy - frame.pan_place.xy;
    if (dot(local, local) < frame.pan_shape.y * frame.pan_shape.y) { return frame.pan_place.z + frame.pan_place.w; }
    let on_board = position.x > frame.board.x && position.x < frame.board.z && position.y > frame.board.y && position.y < frame.board.w;
    return select(0.0, frame.mode.w, on_board);
}

fn world_normal(normal: vec3<f32>) -> vec3<f32> {
    return normalize((food.world_from_rest * vec4<f32>(normal, 0.0)).xyz);
}

fn lit_food(in: FoodOut) -> vec4<f32> {
    let wetness = in.state.x;
    let crust = in.state.y;
    let look = flesh(in.rest, in.lean, in.browner, in.fat, crust);
    let view = normalize(frame.eye.xyz - in.position);
    let rest_normal = normalize(in.normal);
    let slope = look.slope - rest_normal * dot(look.slope, rest_normal);
    let smooth_normal = world_normal(in.normal);
    let height = max(in.position.z - support(in.position), 0.0);
    let visibility = (0.35 + 0.65 * smoothstep(-0.002, 0.012, height)) * (0.72 + 0.28 * smooth_normal.z);
    let lit = shadow(in.position, smooth_normal);
    let raw = (1.0 - crust) * wetness;
    let bumpy = world_normal(rest_normal - slope * (0.9 - 0.35 * wetness));
    let wrap = vec3<f32>(0.36, 0.17, 0.12) * (1.0 - 0.85 * crust);
    let roughness = mix(mix(0.60, 0.82, crust), 0.42, wetness) - 0.12 * look.fat;
    let body = Surface(look.colour, vec3<f32>(0.035), roughness, bumpy, visibility, wrap);
    var radiance = diffuse(body, lit) + specular(body, in.position, view, lit) * (1.0 - 0.7 * raw);
    // Water or oil lies smoother than the flesh and gathers in its hollows.
    let film = wetness * smoothstep(0.10, 0.85, wetness * 0.75 + (0.5 - look.patchy) * 1.5);
    let film_normal = world_normal(rest_normal - slope * mix(0.75, 0.95, raw));
    let coat = Surface(vec3<f32>(0.0), vec3<f32>(0.026), mix(0.36, 0.20, wetness), film_normal, visibility, vec3<f32>(0.0));
    radiance += specular(coat, in.position, view, lit) * film;
    return pixel_from_radiance(radiance, in.clip.xy);
}

fn food_pixel(in: FoodOut) -> vec4<f32> {
    if (frame.mode.y > 0.5) {
        return vec4<f32>(lightly_lit(table_colour(in.state.z), world_normal(in.normal), 1.0), 1.0);
    }
    return lit_food(in);
}

@fragment
fn fs_food(in: FoodOut) -> @location(0) vec4<f32> {
    return food_pixel(in);
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
