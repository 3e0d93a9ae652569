// Fat and juice: the collar of bubbles round a frying food, drops in the air, spots on the pan.

struct FryOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    // Drop and spot: place on the disc. Collar: way from the food's edge [m].
    @location(1) corner: vec2<f32>,
    // Opacity, kind: -1 a collar, whose width [m] replaces the opacity; 2 a drop in the air, 4 a spot of oil, 6 a pool of
    // juice, whose redness replaces it.
    @location(2) look: vec2<f32>,
};

@vertex
fn vs_fry(in: PuffIn) -> FryOut {
    let place = in.position + vec3<f32>(in.corner * in.look.x, 0.0);
    return FryOut(frame.clip_from_world * vec4<f32>(place, 1.0), place, in.corner, in.look.yz);
}

fn liquid(normal: vec3<f32>, position: vec3<f32>) -> vec3<f32> {
    let s = Surface(vec3<f32>(0.0), vec3<f32>(0.045), 0.10, normal, 1.0, vec3<f32>(0.0));
    return specular(s, position, normalize(frame.eye.xyz - position), 1.0);
}

// How far the dark film of juice reaches from the foot [m].
const FILM_REACH = 0.0035;
// Sides of the cells of three sizes of bubbles [m], and how long they last [s] (chosen: large ones rise and burst).
const CELLS = vec3<f32>(0.0056, 0.0034, 0.0020);
const LIVES = vec3<f32>(0.55, 0.40, 0.30);

fn random3(at: vec3<f32>) -> vec3<f32> {
    var p = fract(at * vec3<f32>(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.xxy + p.yxx) * p.zyx);
}

// A bubble of one size at a place: the way from its middle over its radius in x and y, its opacity in z.
fn bubble_at(place: vec2<f32>, strip: Strip, size: i32) -> vec3<f32> {
    let side = CELLS[size];
    // The sizes lie askew to each other, so that no rows are seen.
    let askew = f32(size) * 0.9 + 0.35;
    let turned = vec2<f32>(cos(askew) * place.x - sin(askew) * place.y, sin(askew) * place.x + cos(askew) * place.y) / side;
    let row = floor(turned.y);
    let shifted = vec2<f32>(turned.x + 0.5 * fract(row * 0.5) * 2.0, turned.y);
    let cell = floor(shifted);
    let phase = random3(vec3<f32>(cell, f32(size) + 7.0));
    let turn = frame.eye.w / (LIVES[size] * (0.6 + 0.8 * phase.y)) + phase.x * 17.0;
    let now = random3(vec3<f32>(cell + 0.5, floor(turn) + 31.0 * f32(size)));
    let age = fract(turn);
    let radius = mix(0.24, 0.46, now.z) * (0.55 + 0.45 * sqrt(age));
    let middle = 0.5 + (now.xy - 0.5) * (1.0 - 2.0 * radius);
    let off = fract(shifted) - middle;
    // Whether there is one is decided at its middle, so that none is cut off at the strip's end.
    let back = vec2<f32>(cos(askew) * off.x + sin(askew) * off.y, cos(askew) * off.y - sin(askew) * off.x) * side;
    let share = strip.share - dot(back, strip.outward) / strip.width;
    // Near the food every place has its bubble; large ones keep close to it.
    let wanted = smoothstep(1.0, 0.15 + 0.25 * f32(size), share) * step(0.0, share + 0.25);
    let there = select(0.0, 1.0, phase.z < wanted) * min(age * 8.0, 1.0) * min((1.0 - age) * 10.0, 1.0);
    return vec3<f32>(off / radius, there);
}

struct Strip {
    // Unit vector away from the food.
    outward: vec2<f32>,
    // Place across the strip: 0 at the food, 1 where it ends.
    share: f32,
    // [m]
    width: f32,
};

// The film of juice at the foot, steep at the food and flat outside.
fn juice(in: FryOut, far: f32, outward: vec2<f32>) -> vec4<f32> {
    let noise = textureSampleLevel(solid_noise, tile_sampler, in.position * 26.0, 0.0).a - 0.5;
    let across = far / FILM_REACH;
    let edge = clamp(across + 0.9 * noise * across, 0.0, 1.0);
    let steep = (1.0 - edge) * (1.0 - edge);
    let normal = normalize(vec3<f32>(outward * 1.6 * steep, 1.0));
    let alpha = (1.0 - smoothstep(0.25, 0.85, edge)) * 0.6;
    let brown = vec3<f32>(0.075, 0.045, 0.020);
    return vec4<f32>(pixel_from_radiance(brown + liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

// A dome of clear fat: bright where it scatters at its rim, with the window in it.
fn dome(in: FryOut, place: vec2<f32>) -> vec4<f32> {
    let away = dot(place, place);
    let normal = normalize(vec3<f32>(place * 0.95, sqrt(max(1.0 - 0.9 * away, 0.02))));
    let body = smoothstep(1.0, 0.82, away);
    let rim = away * away * away;
    let alpha = body * mix(0.10, 0.50, rim);
    let fat = mix(vec3<f32>(0.16, 0.12, 0.07), vec3<f32>(0.36, 0.31, 0.22), rim);
    return vec4<f32>(pixel_from_radiance(fat + 2.0 * liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

// Bubbles too small to be seen: pale, and open (chosen).
const FOAM = vec4<f32>(0.40, 0.34, 0.23, 1.0);
const FOAM_COVER = 0.26;
const FINE_COVER = 0.14;

// The collar: juice, then bubbles of three sizes, the largest on top.
fn collar(in: FryOut, pixel: f32) -> vec4<f32> {
    let far = length(in.corner);
    let width = in.look.x;
    let strip = Strip(in.corner / max(far, 1e-5), far / max(width, 1e-5), width);
    var seen = juice(in, far, strip.outward);
    if (width < 0.0007 || strip.share > 1.3) { return seen; }
    // Between the bubbles that are seen are finer ones.
    let fine = FOAM * (FINE_COVER * smoothstep(1.0, 0.3, strip.share));
    seen = seen * (1.0 - fine.a) + fine;
    let place = in_pan(in.position).xy;
    // From afar the smallest are lost in the foam.
    for (var size = select(2, 1, quick); size >= 0; size--) {
        let found = bubble_at(place, strip, size);
        if (found.z <= 0.0 || dot(found.xy, found.xy) >= 1.0) { continue; }
        // Bubbles of few pixels are seen as foam, not as sparks.
        let sharp = clamp(CELLS[size] / (3.0 * pixel) - 0.4, 0.0, 1.0);
        let over = mix(FOAM * FOAM_COVER, dome(in, found.xy), sharp) * found.z;
        seen = seen * (1.0 - over.a) + over;
    }
    return seen;
}

// A drop in the air: amber, bright along its middle where it catches the window.
fn drop(in: FryOut) -> vec4<f32> {
    let away = dot(in.corner, in.corner);
    let body = smoothstep(1.0, 0.45, away);
    let glint = smoothstep(0.55, 0.05, away);
    let colour = vec3<f32>(0.22, 0.16, 0.07) + vec3<f32>(0.22, 0.20, 0.16) * glint;
    let alpha = in.look.x * body * 0.65;
    return vec4<f32>(pixel_from_radiance(colour, in.clip.xy).rgb * alpha, alpha);
}

// A low cap of oil that does not move: faint in its middle, a darker edge, the window in it.
fn spot(in: FryOut, spread: f32) -> vec4<f32> {
    let away = dot(in.corner, in.corner);
    let normal = normalize(vec3<f32>(in.corner * 0.30, 1.0));
    let alpha = smoothstep(1.0, 0.65, away) * mix(0.40, 0.60, away * away);
    let fat = vec3<f32>(0.085, 0.060, 0.024);
    // A spot of few pixels shows no window: its glint would be a spark.
    let glint = 0.25 * clamp(1.0 / (2.0 * spread) - 0.25, 0.0, 1.0);
    return vec4<f32>(pixel_from_radiance(fat + glint * liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

// Colour of juice through which the board is seen, from flesh that is done and from raw flesh (chosen by eye).
const JUICE_BROWN = vec3<f32>(0.070, 0.026, 0.008);
const JUICE_RED = vec3<f32>(0.095, 0.006, 0.004);
// The same where it is thin (chosen by eye).
const JUICE_THIN = vec3<f32>(0.24, 0.090, 0.030);

// Weaker reflections than this are left out: they would lie on the board like milk (chosen).
const MILK = 0.025;

// A pool of juice on the board: clear and red to brown, darkest at the meat, with an edge that its tension rounds; at its edge it
// creeps along the grain of the wood.
fn pool(in: FryOut) -> vec4<f32> {
    let across = length(in.corner);
    let coarse = textureSampleLevel(solid_noise, tile_sampler, in.position * 13.0, 0.0).a - 0.5;
    let fine = textureSampleLevel(solid_noise, tile_sampler, in.position * 60.0, 0.0).a - 0.5;
    let along_grain = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(150.0, 9.0, 9.0), 0.0).a - 0.5;
    let edge = across * (1.0 + 0.62 * coarse + 0.03 * fine + 0.10 * along_grain);
    let body = smoothstep(0.86, 0.78, edge);
    if (body <= 0.0) { return vec4<f32>(0.0); }
    let rim = smoothstep(0.50, 0.82, edge);
    let normal = normalize(vec3<f32>(in.corner / max(across, 1e-4) * 0.35 * rim * rim, 1.0));
    let lit = shadow(in.position, vec3<f32>(0.0, 0.0, 1.0));
    // Deep at the meat, thin and pale at its edge.
    let thin = smoothstep(0.15, 0.85, edge);
    let alpha = body * mix(0.70, 0.34, thin);
    let s = Surface(mix(mix(JUICE_BROWN, JUICE_RED, in.look.x), JUICE_THIN * mix(vec3<f32>(1.0), vec3<f32>(1.1, 0.55, 0.5), in.look.x), 0.8 * thin), vec3<f32>(0.0), 1.0, normal, 0.8, vec3<f32>(0.0));
    return vec4<f32>(pixel_from_radiance(diffuse(s, lit) + max(liquid(normal, in.position) - MILK, vec3<f32>(0.0)) * mix(0.6, 0.9, lit), in.clip.xy).rgb * alpha, alpha);
}

@fragment
fn fs_fry(in: FryOut) -> @location(0) vec4<f32> {
    let pixel = length(fwidth(in.position.xy));
    let spread = length(fwidth(in.corner));
    // Interpolated kinds are a little off.
    if (in.look.y > 5.0) { return pool(in); }
    if (in.look.y > 3.0) { return spot(in, spread); }
    if (in.look.y > 1.0) { return drop(in); }
    return collar(in, pixel);
}
