// Juice that has come out of flesh is on its upper face in beads: some of each size, more and larger ones the more
// juice lies there, until they run together.

struct Beads {
    // Share of the place that they cover (0-1).
    cover: f32,
    // Colour that light takes on in them.
    tint: vec3<f32>,
    // Slope of their surface in the rest frame.
    bend: vec3<f32>,
};

// Distances of beads of each size [m], their largest radii over these, and the films at which each size begins (chosen:
// small ones sweat out first and run together into large ones).
const BEAD_SPACING = vec3<f32>(0.0021, 0.0042, 0.0088);
const BEAD_RADIUS = vec3<f32>(0.30, 0.36, 0.44);
const BEAD_FROM = vec3<f32>(0.02, 0.25, 0.60);

fn free(cell: vec2<f32>, seed: f32) -> vec3<f32> {
    let at = vec3<f32>(dot(cell, vec2<f32>(12.9898, 78.233)), dot(cell, vec2<f32>(39.346, 11.135)), dot(cell, vec2<f32>(73.156, 52.235)));
    return fract(sin(at + seed) * 43758.5453);
}

// Cover in x, slope along both axes in yz of the beads of one size.
fn beads_of(at: vec2<f32>, spacing: f32, radius: f32, juice: f32, seed: f32) -> vec3<f32> {
    // Each size is askew to the others and its rows are shifted, so that no grid is seen.
    let turned = vec2<f32>(dot(at, vec2<f32>(cos(seed), sin(seed))), dot(at, vec2<f32>(-sin(seed), cos(seed)))) / spacing;
    let place = turned + vec2<f32>(free(vec2<f32>(floor(turned.y), 3.0), seed).x, 0.0);
    let cell = floor(place);
    let chance = free(cell, seed);
    if (juice <= 0.0 || chance.z > 0.10 + 0.45 * juice) { return vec3<f32>(0.0); }
    let reach = radius * (0.45 + 0.55 * fract(chance.z * 7.31)) * sqrt(clamp(juice * 1.6, 0.0, 1.0));
    let room = 1.0 - 2.0 * radius;
    let off = (place - cell - 0.5 - (chance.xy - 0.5) * room) / max(reach, 1e-3);
    let far = dot(off, off);
    if (far >= 1.0) { return vec3<f32>(0.0); }
    let away = vec2<f32>(dot(off, vec2<f32>(cos(seed), -sin(seed))), dot(off, vec2<f32>(sin(seed), cos(seed))));
    return vec3<f32>(smoothstep(1.0, 0.72, far), away);
}

fn juice_on(in: FoodOut, rest_normal: vec3<f32>, world_normal: vec3<f32>, ripple: vec3<f32>) -> Beads {
    let lies = smoothstep(0.35, 0.75, world_normal.z) * in.juice;
    if (lies <= 0.004) { return Beads(0.0, vec3<f32>(1.0), vec3<f32>(0.0)); }
    // The face's plane: that across which its normal is longest.
    let away = abs(rest_normal);
    let flat = away.z >= max(away.x, away.y);
    let side = away.y > away.x;
    let at = select(select(in.rest.yz, in.rest.xz, side), in.rest.xy, flat);
    let wave = select(select(ripple.yz, ripple.xz, side), ripple.xy, flat);
    var most = vec3<f32>(0.0);
    for (var k = 0u; k < 3u; k++) {
        let juice = (lies - BEAD_FROM[k]) / (1.0 - BEAD_FROM[k]);
        let here = beads_of(at + wave * 0.0010, BEAD_SPACING[k], BEAD_RADIUS[k], juice, 0.4 + f32(k) * 1.7);
        if (here.x > most.x) { most = here; }
    }
    let slope = most.yz * 0.95;
    let bend = select(select(vec3<f32>(0.0, slope), vec3<f32>(slope.x, 0.0, slope.y), side), vec3<f32>(slope, 0.0), flat);
    // Clear and red; where the flesh under it is done, paler and browner. The edge of a bead is darker than its middle.
    let edge = dot(most.yz, most.yz);
    let tint = mix(vec3<f32>(0.90, 0.60, 0.52), vec3<f32>(0.92, 0.78, 0.64), 0.6 * in.state.w) * mix(1.0, 0.80, edge * edge);
    return Beads(most.x, tint, bend);
}
