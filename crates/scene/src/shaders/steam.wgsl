// Puffs of steam, smoke and flame: soft sprites that face the eye.

struct PuffIn {
    @location(0) position: vec3<f32>,
    // Corner of the sprite, -1 to 1.
    @location(1) corner: vec2<f32>,
    // Half size [m], opacity, random value.
    @location(2) look: vec3<f32>,
};

struct PuffOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) corner: vec2<f32>,
    // Opacity, of smoke so that thin smoke is seen as well; random value and kind.
    @location(1) look: vec2<f32>,
    // Height above the floor of the pan [m].
    @location(2) height: f32,
};

// Width and height of the sprites over their half size: steam, smoke and flames (chosen: smoke rolls broadly, flames lick up).
const STEAM_SHAPE = vec2<f32>(1.0, 1.5);
const SMOKE_SHAPE = vec2<f32>(1.45, 1.7);
const FLAME_SHAPE = vec2<f32>(1.5, 2.4);
// Half the thickness of a flame [m] (chosen: it is in front of a steak among the flames, but not of the pan's wall).
const FLAME_DEPTH = 0.05;

@vertex
fn vs_steam(in: PuffIn) -> PuffOut {
    let forward = normalize(in.position - frame.eye.xyz);
    let right = normalize(cross(forward, vec3<f32>(0.0, 0.0, 1.0)) + vec3<f32>(1e-4, 0.0, 0.0));
    let up = cross(right, forward);
    let shape = select(STEAM_SHAPE, SMOKE_SHAPE, in.look.z >= 2.0);
    var place = in.position + (right * in.corner.x * shape.x + up * in.corner.y * shape.y) * in.look.x;
    let floor = frame.pan_place.z + frame.pan_place.w;
    if (in.look.z >= 4.0) {
        // A flame stands on the fat, however high its tip has risen.
        let tip = in.position.z + FLAME_SHAPE.y * in.look.x;
        let sideways = right.xy * in.corner.x * FLAME_SHAPE.x * (0.016 + 0.9 * in.look.x);
        place = vec3<f32>(in.position.xy + sideways, mix(floor + 0.001, tip, in.corner.y * 0.5 + 0.5));
    }
    var clip = frame.clip_from_world * vec4<f32>(place, 1.0);
    if (in.look.z >= 4.0) {
        // A flame is as thick as it is broad: food in its middle must not cut it along a line.
        let front = frame.clip_from_world * vec4<f32>(place - forward * FLAME_DEPTH, 1.0);
        clip.z = front.z / front.w * clip.w;
    }
    let smoke = in.look.z >= 2.0 && in.look.z < 4.0;
    return PuffOut(clip, in.corner, vec2<f32>(select(in.look.y, 1.0 - exp(-5.0 * in.look.y), smoke), in.look.z), place.z - floor);
}

// What rises past a place: a free value (about 0 to 1) of broad whirls with threads that they carry along, and how far those sway.
// Software takes every branch for every pixel, so all kinds read their noise here, once.
struct Whirl {
    value: f32,
    sway: f32,
};

// Ways of steam, smoke and flames through the noise: its scale across and up, its speed upwards.
const STEAM_WAY = vec3<f32>(0.17, 0.12, 0.060);
const SMOKE_WAY = vec3<f32>(0.17, 0.12, 0.030);
const FLAME_WAY = vec3<f32>(0.13, 0.08, 0.230);
// How much threads of steam and of smoke count.
const THREADS = vec2<f32>(0.12, 0.24);

fn whirl_at(corner: vec2<f32>, random: f32) -> Whirl {
    let flame = random >= 4.0;
    let smoke = random >= 2.0;
    let own = fract(random);
    let way = select(select(STEAM_WAY, SMOKE_WAY, smoke), FLAME_WAY, flame);
    let start = select(vec3<f32>(0.0, 0.0, random), vec3<f32>(own, 0.08, 3.0 * own), flame);
    let at = vec3<f32>(corner * way.xy, 0.0) - vec3<f32>(0.0, frame.eye.w * way.z, 0.0) + start;
    let broad = textureSampleLevel(solid_noise, tile_sampler, at, 0.0);
    let sway = broad.g - 0.5;
    if (quick) { return Whirl(broad.a, sway); }
    let high = corner.y * 0.5 + 0.5;
    let threads = at * vec3<f32>(1.9, 1.5, 1.0) + vec3<f32>((broad.rg - 0.5) * 0.22, 0.37);
    let licks = vec3<f32>(corner.x * 0.30 + (broad.r - 0.5) * 0.30 * high + own, high * 0.26 - frame.eye.w * 0.41, own * 5.0);
    let carried = textureSampleLevel(solid_noise, tile_sampler, select(threads, licks, flame), 0.0).a;
    let off = 2.0 * carried - 1.0;
    let rolled = broad.a + select(THREADS.x, THREADS.y, smoke) * (0.35 - min(5.0 * off * off, 1.0));
    return Whirl(select(rolled, 0.75 * (broad.a + carried) - 0.25, flame), sway);
}

// Share of a puff that is there at a place: torn at its edge, not round.
fn torn(corner: vec2<f32>, whirl: f32, ragged: f32) -> f32 {
    let away = dot(corner, corner);
    let body = 1.0 - away + ragged * (whirl - 0.5);
    return smoothstep(0.0, 1.25, body) * smoothstep(1.0, 0.25, away);
}

// Tongues of burning fat: yellow low in their middle, orange above, red where they end.
fn tongues(in: PuffOut, whirl: Whirl) -> vec4<f32> {
    let high = in.corner.y * 0.5 + 0.5;
    let lick = whirl.value - 0.5;
    // It sways, most at its tip, and narrows upwards; the licks tear it into tongues.
    let aside = in.corner.x + whirl.sway * 1.2 * high;
    let width = mix(0.80, 0.42, high);
    // A young and a dying flame is low, not faint.
    let strength = min(in.look.x / 0.9, 1.0);
    let heat = 0.40 + 0.55 * strength - aside * aside / (width * width) * 1.05 - 0.80 * high + 2.6 * lick * (0.25 + high) - 0.5 * in.corner.x * in.corner.x * smoothstep(0.25, 0.0, high);
    let inside = smoothstep(1.0, 0.70, abs(in.corner.x)) * smoothstep(1.0, 0.82, high);
    let body = smoothstep(0.02, 0.50, heat) * inside;
    let red = mix(vec3<f32>(0.72, 0.13, 0.01), vec3<f32>(1.0, 0.48, 0.07), smoothstep(0.05, 0.45, heat));
    let colour = mix(red, vec3<f32>(1.10, 0.88, 0.48), smoothstep(0.35, 0.95, heat));
    // A flame gives light and hides hardly anything; at its root it is thin.
    let alpha = body * smoothstep(0.0, 0.5, strength) * 0.85 * smoothstep(0.0, 0.30, high);
    return vec4<f32>(colour * alpha, 0.25 * alpha);
}

@fragment
fn fs_steam(in: PuffOut) -> @location(0) vec4<f32> {
    let whirled = whirl_at(in.corner, in.look.y);
    if (in.look.y >= 4.0) { return tongues(in, whirled); }
    if (dot(in.corner, in.corner) >= 1.0) { return vec4<f32>(0.0); }
    let whirl = whirled.value;
    let smoke = in.look.y >= 2.0;
    // Smoke lies dense over the pan and thins out above it; steam is thin and torn.
    let high = smoothstep(0.03, 0.30, in.height);
    let bounds = select(vec2<f32>(0.25, 0.90), vec2<f32>(0.14 * high, 1.05), smoke);
    let there = torn(in.corner, whirl, select(2.0, 1.9, smoke)) * smoothstep(bounds.x, bounds.y, whirl);
    let alpha = min(there * in.look.x * select(1.0, mix(1.25, 0.65, high), smoke), select(1.0, 0.92, smoke));
    let colour = select(vec3<f32>(0.86, 0.87, 0.88), mix(vec3<f32>(0.46, 0.49, 0.54), vec3<f32>(0.60, 0.62, 0.65), whirl), smoke);
    return vec4<f32>(colour * alpha, alpha);
}
