// Fat and juice: the collar of bubbles round a frying food, drops in the air, spots on the pan.

struct FryOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    // Drop and spot: place on the disc. Collar: way from the food's edge [m].
    @location(1) corner: vec2<f32>,
    // Opacity; of a collar its width [m], of a pool its redness. Then 1 a drop in the air, -1 a collar.
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
// Sides of the cells of three sizes of bubbles [m], and how often they change [1/s] (chosen: large ones rise and burst).
const CELLS = vec3<f32>(0.0062, 0.0036, 0.0020);
const TURNS = vec3<f32>(1.4, 2.2, 3.2);
// Share of the cells that have a bubble where they crowd (chosen: few large ones among many small).
const SHARES = vec3<f32>(0.50, 0.85, 1.0);

struct Strip {
    // Unit vector away from the food.
    outward: vec2<f32>,
    // Way from the food, and where the bubbles end here [m].
    far: f32,
    end: f32,
    // What is drawn ends here [m].
    width: f32,
};

// The highest of the bubbles at a place, as `found` was: the way from its middle over its radius, how high it is there [m], its
// radius [m]; no radius where there is none.
fn bubble_at(place: vec2<f32>, strip: Strip, size: i32, found: vec4<f32>) -> vec4<f32> {
    var best = found;
    let side = CELLS[size];
    // The sizes lie askew to each other, so that no rows are seen.
    let askew = f32(size) * 0.9 + 0.35;
    let at = vec2<f32>(cos(askew) * place.x - sin(askew) * place.y, sin(askew) * place.x + cos(askew) * place.y) / side;
    // Bubbles that keep to their cells are found with one look.
    let first = select(floor(at - 0.5), floor(at), quick);
    for (var k = 0; k < select(4, 1, quick); k++) {
        let cell = first + vec2<f32>(f32(k & 1), f32(k >> 1));
        let own = random3(vec3<f32>(cell, f32(size) + 7.0));
        // Whole turns in the time after which the clock begins anew.
        let turn = frame.eye.w * 0.001 * floor(1000.0 * TURNS[size] * (0.6 + 0.8 * own.y)) + own.x * 17.0;
        let now = random3(vec3<f32>(cell + 0.5, floor(turn) + 31.0 * f32(size)));
        let age = fract(turn);
        // Small ones are many, large ones few; they swell, and burst.
        let most = select(0.64, 0.46, quick);
        let radius = mix(0.24, most, own.z * sqrt(own.z)) * (0.45 + 0.55 * sqrt(age)) * min((1.0 - age) * 12.0, 1.0);
        let middle = 0.5 + (now.xy - 0.5) * select(0.66, 1.0 - 2.0 * radius, quick);
        let off = (at - cell - middle) / max(radius, 0.01);
        let away = dot(off, off);
        if (away >= 1.0) { continue; }
        let back = vec2<f32>(cos(askew) * off.x + sin(askew) * off.y, cos(askew) * off.y - sin(askew) * off.x);
        // Whether there is one is decided at its middle, so that none is cut off at the strip's end.
        let from_food = strip.far - dot(back, strip.outward) * radius * side;
        let wanted = SHARES[size] * smoothstep(1.1, 0.45 + 0.10 * f32(size), from_food / strip.end);
        if (now.z > wanted || from_food + radius * side > strip.width + 0.0015) { continue; }
        let height = (sqrt(1.0 - away) - 0.2) * radius * side;
        if (height > best.z || best.w == 0.0) { best = vec4<f32>(back, height, radius * side); }
    }
    return best;
}

// The film of juice at the foot, steep at the food and flat outside; in places there is none.
fn juice(in: FryOut, far: f32, outward: vec2<f32>) -> vec4<f32> {
    let noise = textureSampleLevel(solid_noise, tile_sampler, in.position * 26.0, 0.0).a - 0.5;
    let across = far / FILM_REACH;
    let edge = clamp(across * (1.0 + 1.6 * noise), 0.0, 1.0);
    let steep = (1.0 - edge) * (1.0 - edge);
    let normal = normalize(vec3<f32>(outward * (0.9 + 2.0 * noise) * steep, 1.0));
    let alpha = (1.0 - smoothstep(0.25, 0.85, edge)) * 0.55 * smoothstep(-0.22, 0.10, noise);
    let brown = vec3<f32>(0.060, 0.036, 0.016);
    return vec4<f32>(pixel_from_radiance(brown + 0.6 * liquid(normal, in.position), in.clip.xy).rgb * alpha, alpha);
}

// How white with milk bubbles are: fresh butter foams white, brown butter hardly.
fn milkiness() -> f32 {
    return frame.white.w * smoothstep(0.10, 0.45, frame.oil.g);
}

// A bubble of clear fat: the window in its crown, the window's light gathered at its far side, a dark line where it touches the
// pan. In butter its skin is white with milk.
fn dome(in: FryOut, place: vec2<f32>) -> vec4<f32> {
    let away = dot(place, place);
    let normal = normalize(vec3<f32>(place * 0.95, sqrt(max(1.0 - 0.9 * away, 0.02))));
    let rim = away * away;
    let far = max(-dot(place, normalize(frame.key.xy)), 0.0) * smoothstep(1.0, 0.80, away);
    let line = smoothstep(0.62, 0.95, away) * (0.45 + 0.55 * smoothstep(0.5, -0.5, dot(place, normalize(frame.key.xy))));
    let lit = shadow(in.position, vec3<f32>(0.0, 0.0, 1.0));
    let glint = 2.2 * liquid(normal, in.position) * mix(0.6, 1.0, lit);
    let gathered = vec3<f32>(0.95, 0.76, 0.44) * (far * far * mix(0.35, 0.8, lit));
    let clear = mix(vec3<f32>(0.20, 0.15, 0.08), vec3<f32>(0.030, 0.020, 0.010), line) + gathered;
    let milky = mix(vec3<f32>(0.74, 0.66, 0.49), vec3<f32>(0.44, 0.34, 0.19), rim) * mix(0.5, 1.0, lit);
    let milk = 0.8 * milkiness();
    let bright = dot(glint + gathered, vec3<f32>(0.30, 0.45, 0.25));
    let alpha = clamp(mix(0.10 + 0.38 * line, mix(0.55, 0.85, rim), milk) + 0.8 * bright, 0.0, 0.92) * smoothstep(1.0, 0.90, away);
    return vec4<f32>(pixel_from_radiance(mix(clear, milky, milk) + glint, in.clip.xy).rgb * alpha, alpha);
}

// Bubbles too small to be seen: pale, and open (chosen).
const FOAM = vec3<f32>(0.36, 0.30, 0.19);
const BUTTER_FOAM = vec3<f32>(0.62, 0.56, 0.43);
const FOAM_COVER = 0.34;
const FINE_COVER = 0.22;

// How far the bubbles reach here, over the width of their strip: they crowd at some stretches of the edge, others are free of them.
fn crowding(place: vec2<f32>) -> f32 {
    let broad = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(place * 5.5, 0.13 + frame.eye.w * 0.02), 0.0).a;
    if (quick) { return 0.15 + 1.15 * smoothstep(0.25, 0.60, broad); }
    let small = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(place * 17.0, 0.57 + frame.eye.w * 0.06), 0.0).a;
    return 0.12 + 1.25 * smoothstep(0.25, 0.60, broad + 0.7 * (small - 0.5));
}

// The collar: juice, then froth, then bubbles of three sizes.
fn collar(in: FryOut, pixel: f32) -> vec4<f32> {
    let far = length(in.corner);
    let width = in.look.x;
    let outward = in.corner / max(far, 1e-5);
    var seen = juice(in, far, outward);
    if (width < 0.0007 || far > width + 0.0025) { return seen; }
    let place = in_pan(in.position).xy;
    let strip = Strip(outward, far, max(width * crowding(place), 1e-4), width);
    let foam = mix(FOAM, BUTTER_FOAM, milkiness());
    // Between the bubbles that are seen are finer ones, most at the foot.
    let froth = mix(FINE_COVER, 0.35, milkiness()) * smoothstep(0.85, 0.05, far / strip.end);
    seen = seen * (1.0 - froth) + vec4<f32>(foam, 1.0) * froth;
    // From afar the small ones are lost in the froth.
    var found = vec4<f32>(0.0);
    for (var size = 0; size < select(3, 2, quick); size++) {
        if (!fine && CELLS[size] < 2.2 * pixel) { continue; }
        found = bubble_at(place, strip, size, found);
    }
    if (found.w == 0.0) { return seen; }
    // Bubbles of few pixels are seen as froth, not as sparks.
    let sharp = smoothstep(0.7, 3.0, found.w / pixel);
    let over = mix(vec4<f32>(foam, 1.0) * mix(FOAM_COVER, 0.7, milkiness()), dome(in, found.xy), sharp);
    return seen * (1.0 - over.a) + over;
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

// How a sprite lies in the world, found from what changes from pixel to pixel.
struct Lie {
    // Where its corner's x and y lead [m].
    along: vec3<f32>,
    across: vec3<f32>,
};

fn lie_of(place_x: vec3<f32>, place_y: vec3<f32>, corner_x: vec2<f32>, corner_y: vec2<f32>) -> Lie {
    let area = corner_x.x * corner_y.y - corner_x.y * corner_y.x;
    let scale = select(1.0 / area, 0.0, abs(area) < 1e-12);
    return Lie((place_x * corner_y.y - place_y * corner_x.y) * scale, (place_y * corner_x.x - place_x * corner_y.x) * scale);
}

// A low cap of oil, round where it lies level; on a wall it has run down: a thin drop with the track that it left above it, and
// a soft shadow. `spread` is a pixel in its own measure.
fn spot(in: FryOut, spread: f32, lie: Lie) -> vec4<f32> {
    let size = max(length(lie.along), 1e-6);
    let fall = -vec2<f32>(lie.along.z, lie.across.z) / size;
    let steep = smoothstep(0.25, 0.6, length(fall));
    let down = select(vec2<f32>(0.0, -1.0), fall / max(length(fall), 1e-4), length(fall) > 0.05);
    var own = 0.5;
    if (!quick) {
        let centre = in.position - lie.along * in.corner.x - lie.across * in.corner.y;
        own = textureSampleLevel(solid_noise, tile_sampler, centre * 90.0, 0.0).a;
    }
    // Down it, and aside of a track that is not quite straight.
    let u = dot(in.corner, down);
    let bend = 0.16 * sin(4.0 * u + 9.0 * own) * steep;
    let v = down.x * in.corner.y - down.y * in.corner.x - bend * (0.5 - u);
    let middle = mix(0.0, 0.52, steep);
    let radius = mix(0.72, 0.30 + 0.16 * own, steep);
    let place = vec2<f32>(v, (u - middle) * mix(1.0, 0.8, steep)) / radius;
    let away = length(place);
    let soft = 0.12 + 0.8 * spread / radius;
    let head = smoothstep(1.0 + soft, 1.0 - soft, away);
    // The track is longest where much has run.
    let top = mix(-0.9, 0.1, own);
    let track = steep * smoothstep(top, middle, u) * step(u, middle) * smoothstep(0.20, 0.04, abs(v)) * 0.45;
    let shade = 0.30 * smoothstep(1.7, 0.6, length(place - vec2<f32>(0.0, 0.35 * steep))) * (1.0 - head) * smoothstep(1.0, 0.75, length(in.corner));
    let up = normalize(cross(lie.along, lie.across) + vec3<f32>(0.0, 0.0, 1e-12));
    let facing = select(-up, up, dot(up, frame.eye.xyz - in.position) > 0.0);
    // Thin: only its edge is steep.
    let edge = away * away * 0.45;
    let aside = (lie.along * in.corner.x + lie.across * (in.corner.y)) / size - (lie.along * down.x + lie.across * down.y) / size * middle;
    let normal = normalize(facing + aside / radius * edge);
    let fat = vec3<f32>(0.060, 0.042, 0.018);
    // A spot of few pixels shows no window: its glint would be a spark.
    let glint = 0.30 * clamp(1.0 / (2.0 * spread) - 0.25, 0.0, 1.0);
    let round = smoothstep(1.0, 0.95, length(in.corner));
    let alpha = round * head * mix(0.30, 0.46, min(away, 1.0)) + (1.0 - head) * track;
    let light = pixel_from_radiance(fat + glint * liquid(normal, in.position), in.clip.xy).rgb;
    // The shadow takes light away and sends none.
    return vec4<f32>(light * alpha, alpha + (1.0 - alpha) * shade);
}

// Colour of juice through which the board is seen, from flesh that is done and from raw flesh (chosen by eye).
const JUICE_BROWN = vec3<f32>(0.070, 0.026, 0.008);
const JUICE_RED = vec3<f32>(0.095, 0.006, 0.004);
// The same where it is thin (chosen by eye).
const JUICE_THIN = vec3<f32>(0.24, 0.090, 0.030);

// Weaker reflections than this are left out: they would lie on the board like milk (chosen).
const MILK = 0.025;

// Weakest and strongest reach of a pool over the width of its ring (chosen: the ring's own edge is never seen).
const POOL_REACH = vec2<f32>(0.26, 0.80);
// How far the damp wood round a pool reaches, over the pool (chosen).
const DAMP = 1.24;
const DAMP_WOOD = vec3<f32>(0.090, 0.036, 0.012);

// Where a place is in a pool: 0 at the meat, 1 at its edge. It runs where the board is low; its tension keeps its edge round.
fn in_pool(position: vec3<f32>, across: f32) -> f32 {
    let low = textureSampleLevel(solid_noise, tile_sampler, position * 4.3, 0.0).a - 0.5;
    let coarse = textureSampleLevel(solid_noise, tile_sampler, position * 13.0, 0.0).a - 0.5;
    let reach = 0.66 + 0.75 * low + 0.50 * coarse;
    return across / clamp(reach, POOL_REACH.x, POOL_REACH.y);
}

// A pool of juice on the board: clear and red to brown, darkest at the meat, amber where it is thin, with an edge that its tension
// rounds; round it the wood is damp.
fn pool(in: FryOut) -> vec4<f32> {
    let across = length(in.corner);
    let outward = in.corner / max(across, 1e-4);
    let edge = in_pool(in.position, across);
    // Where the ring is a few pixels wide its edge is no mirror: it would be a white thread.
    let wide = 1.0 - smoothstep(0.015, 0.05, fwidth(across));
    if (edge >= DAMP) { return vec4<f32>(0.0); }
    let body = smoothstep(1.0, 0.94, edge);
    let lit = shadow(in.position, vec3<f32>(0.0, 0.0, 1.0));
    let ripple = textureSampleLevel(solid_noise, tile_sampler, in.position * 21.0, 0.0);
    let rim = smoothstep(0.55, 0.97, edge);
    let normal = normalize(vec3<f32>(outward * 0.30 * rim * rim + (ripple.xy - 0.5) * 0.03, 1.0));
    // Deep at the meat, thin and pale at its edge.
    let thin = smoothstep(0.15, 1.0, edge);
    // What runs out first comes from the middle, which is redder than the mean.
    let red = sqrt(clamp(in.look.x, 0.0, 1.0));
    let deep = mix(JUICE_BROWN, JUICE_RED, red);
    let pale = JUICE_THIN * mix(vec3<f32>(1.0), vec3<f32>(1.1, 0.50, 0.45), red);
    let alpha = mix(0.24 * smoothstep(DAMP, 0.95, edge), mix(0.88, 0.62, thin), body);
    let s = Surface(mix(DAMP_WOOD, mix(deep, pale, 0.50 * thin), body), vec3<f32>(0.0), 1.0, normal, 0.8, vec3<f32>(0.0));
    // The edge mirrors the window here and there: an unbroken line of it would look drawn.
    let broken = mix(1.0, 0.6 * smoothstep(0.42, 0.70, ripple.a), rim);
    let mirrored = max(liquid(normal, in.position) - MILK, vec3<f32>(0.0)) * mix(0.45, 0.65, lit) * (body * broken * wide);
    return vec4<f32>(pixel_from_radiance(diffuse(s, lit) + mirrored, in.clip.xy).rgb * alpha, alpha);
}

// Each kind has an entry of its own: software graphics would run through every kind for each pixel of any.
@fragment
fn fs_pool(in: FryOut) -> @location(0) vec4<f32> {
    return pool(in);
}

@fragment
fn fs_spot(in: FryOut) -> @location(0) vec4<f32> {
    let corner_x = dpdx(in.corner);
    let corner_y = dpdy(in.corner);
    return spot(in, length(abs(corner_x) + abs(corner_y)), lie_of(dpdx(in.position), dpdy(in.position), corner_x, corner_y));
}

@fragment
fn fs_collar(in: FryOut) -> @location(0) vec4<f32> {
    let pixel = length(abs(dpdx(in.position.xy)) + abs(dpdy(in.position.xy)));
    if (in.look.y > 0.0) { return drop(in); }
    return collar(in, pixel);
}
