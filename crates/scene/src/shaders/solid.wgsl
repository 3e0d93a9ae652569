// Everything that does not deform: pan, hob, board, cloth and the corner around them.

struct SolidIn {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec3<f32>,
    // Roughness, metalness, material, ambient visibility.
    @location(3) surface: vec4<f32>,
};

// Read within the triangle: at an anti-aliased edge a thin triangle would else be continued far beyond its ends.
struct SolidOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) position: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(2) colour: vec3<f32>,
    @location(3) surface: vec4<f32>,
};

@vertex
fn vs_solid(in: SolidIn) -> SolidOut {
    return SolidOut(frame.clip_from_world * vec4<f32>(in.position, 1.0), in.position, in.normal, in.colour, in.surface);
}

fn facing(normal: vec3<f32>, view: vec3<f32>) -> vec3<f32> {
    let n = normalize(normal);
    return select(-n, n, dot(n, view) > -0.15);
}

fn plain_surface(in: SolidOut, n: vec3<f32>) -> Surface {
    let f0 = mix(vec3<f32>(0.04), in.colour, in.surface.y);
    return Surface(in.colour * (1.0 - in.surface.y), f0, in.surface.x, n, in.surface.w, vec3<f32>(0.0));
}

// Soft darkening of counter and hob around the pan's foot, where the shadow map is too hard and too thin.
fn pan_foot(position: vec3<f32>) -> f32 {
    let away = length(position.xy - frame.pan_place.xy);
    let above = max(frame.pan_place.z + 0.004 - position.z, 0.0);
    let rim = frame.pan_shape.y;
    return mix(1.0, smoothstep(frame.pan_shape.x - 0.01, rim + 0.05, away), step(position.z, frame.pan_place.z + 0.004) * exp(-above * 20.0) * 0.75);
}

// Width of what a pixel shows of a surface [m].
fn footprint(position: vec3<f32>) -> f32 {
    return 0.7 * length(fwidth(position));
}

// Solid noise, averaged over what a pixel shows: `spread` is the pixel's width on the scale of `at`.
fn pattern(at: vec3<f32>, spread: f32) -> vec4<f32> {
    return textureSampleLevel(solid_noise, tile_sampler, at, log2(max(spread * f32(textureDimensions(solid_noise).x), 1.0)));
}

// The same of the cells of `bundle_picture`: way from the seam, and a value of each cell.
fn chips(at: vec2<f32>, spread: f32) -> vec2<f32> {
    return textureSampleLevel(bundle_picture, tile_sampler, at, log2(max(spread * f32(textureDimensions(bundle_picture).x), 1.0))).rg;
}

// Three values from 0 to 1 of a cell; whole numbers, for they are the same on every device.
fn random_of(cell: vec2<i32>, seed: u32) -> vec3<f32> {
    var h = (bitcast<u32>(cell.x) * 0x8da6b343u) ^ (bitcast<u32>(cell.y) * 0xd8163841u) ^ (seed * 0xcb1ab31fu);
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    h = h ^ (h >> 15u);
    return vec3<f32>(vec3<u32>(h & 1023u, (h >> 10u) & 1023u, (h >> 20u) & 1023u)) / 1023.0;
}

// How much of a pixel a thin line covers, from the way to its middle and half its width.
fn line_cover(away: f32, thin: f32, pixel: f32) -> f32 {
    let wide = max(thin, 0.5 * pixel);
    return smoothstep(wide + 0.5 * pixel, wide - 0.5 * pixel, abs(away)) * thin / wide;
}

// Short marks along y, one to a cell at most: pores and flecks of wood.
fn dashes(at: vec2<f32>, cell: vec2<f32>, thin: f32, pixel: f32, seed: u32) -> f32 {
    let column = floor(at.x / cell.x);
    let along = at.y / cell.y + random_of(vec2<i32>(i32(column), 7), seed).x;
    let own = random_of(vec2<i32>(i32(column), i32(floor(along))), seed + 1u);
    let off = (vec2<f32>(at.x / cell.x - column, fract(along)) - mix(vec2<f32>(0.3, 0.35), vec2<f32>(0.7, 0.65), own.xy)) * cell;
    let end = abs(off.y) / (cell.y * mix(0.12, 0.34, own.z));
    return line_cover(off.x, thin * max(1.0 - end * end, 0.01), pixel) * step(end, 1.0) * (0.4 + 0.6 * own.x) * step(0.25, fract(own.z * 7.0));
}

// Scratches of a blade, one to a cell at most, about along x: the way to the side in x, how much is covered in y.
fn scratch(at: vec2<f32>, cell: vec2<f32>, thin: f32, pixel: f32, seed: u32) -> vec2<f32> {
    let place = at / cell;
    let own = random_of(vec2<i32>(floor(place)), seed);
    let off = (fract(place) - vec2<f32>(0.5, mix(0.3, 0.7, own.x))) * cell;
    let aside = off.y - off.x * (own.y - 0.5) * 0.5 * cell.y / cell.x - off.x * off.x * (own.z - 0.5) * 1.5;
    let end = abs(off.x) / (cell.x * mix(0.15, 0.48, own.z));
    let cover = line_cover(aside, thin, pixel) * smoothstep(1.0, 0.6, end) * step(0.45, fract(own.x * 13.0)) * (0.3 + 0.7 * own.y);
    return vec2<f32>(aside, cover);
}

// Shade of a counter of quartz and resin: clouds, chips of two sizes, few of them dark or white.
fn stone_shade(position: vec3<f32>, coarse: f32, pixel: f32) -> f32 {
    let cloud = pattern(position * 1.7, pixel * 1.7).a;
    // The chips lie as they fell: cells that are pulled about show no rows.
    let pulled = position.xy + (pattern(position * 23.0, pixel * 23.0).xy - 0.5) * 0.004;
    let large = chips(pulled * 19.0, pixel * 19.0);
    let small = chips(pulled.yx * 47.0 + 0.37, pixel * 47.0);
    let grain = 0.06 * (large.y - 0.5) + 0.09 * (small.y - 0.5);
    let dark = smoothstep(0.88, 0.94, large.y) * smoothstep(0.10, 0.30, large.x) + 0.7 * smoothstep(0.90, 0.96, small.y);
    let white = smoothstep(0.10, 0.05, large.y) * smoothstep(0.15, 0.35, large.x) + 0.6 * smoothstep(0.08, 0.03, small.y);
    return 1.01 + 0.16 * (coarse - 0.5) + 0.20 * (cloud - 0.5) + grain - 0.20 * min(dark, 1.0) + 0.17 * min(white, 1.0);
}

// Yarn of the cloth and gaps between its stripes [m] (chosen: a coarse kitchen cloth).
const YARN = 0.0011;
const STRIPES = 0.036;

// Shade of linen: yarns that go over and under each other, thick and thin ones, and a pale check.
fn linen_shade(position: vec3<f32>, coarse: f32, pixel: f32) -> f32 {
    let slubs = pattern(position * vec3<f32>(3.0, 90.0, 1.0), pixel * 60.0).a + pattern(position * vec3<f32>(90.0, 3.0, 1.0) + 0.3, pixel * 60.0).a - 1.0;
    let at = position.xy * (3.14159265 / YARN) + 0.8 * slubs;
    let woven = sin(at.x) * sin(at.y) * clamp(1.4 - 1.6 * pixel / YARN, 0.0, 1.0);
    let away = abs(fract(position.xy / STRIPES) - 0.5) * STRIPES;
    let check = 0.5 * (line_cover(away.x, 0.0013, pixel) + line_cover(away.y, 0.0013, pixel));
    return 0.912 + 0.10 * woven + 0.16 * slubs + 0.14 * (coarse - 0.5) + 0.20 * check;
}

// Marks of the grinding along a steel blade, and what fingers left on it. The one in the hand has less metalness: it is in
// motion, and these marks are not.
fn ground_steel(s: Surface, position: vec3<f32>, pixel: f32) -> Surface {
    let along = vec2<f32>(0.995, -0.0998);
    let at = vec2<f32>(dot(position.xy, along), dot(position.xy, vec2<f32>(-along.y, along.x)));
    let marks = pattern(vec3<f32>(at.x * 2.0, at.y * 140.0, 0.2), pixel * 100.0).a - 0.5;
    let smear = pattern(position * 9.0, pixel * 9.0).a - 0.5;
    var out = s;
    out.f0 *= 1.0 + 0.26 * marks + 0.08 * smear;
    out.roughness = clamp(s.roughness + 0.14 * marks + 0.08 * smear, 0.2, 1.0);
    return out;
}

// Plaster smoothed by hand: low waves of the trowel and sand.
fn plastered(s: Surface, position: vec3<f32>, pixel: f32) -> Surface {
    let waves = pattern(position * vec3<f32>(1.1, 1.0, 2.3), pixel * 2.0);
    let sand = pattern(position * 70.0, pixel * 70.0);
    var out = s;
    out.normal = normalize(s.normal + (waves.xyz - 0.5) * 0.10 + (sand.xyz - 0.5) * 0.12);
    out.albedo *= 1.0 + 0.10 * (waves.a - 0.5) + 0.10 * (sand.a - 0.5);
    return out;
}

@fragment
fn fs_solid(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    if (fine) { s.roughness = widened(s.roughness, fwidth(in.normal)); }
    let kind = in.surface.z;
    var shade = select(1.0, select(0.92, 1.0, kind > 5.5), kind > 4.5);
    if (!quick) {
        let pixel = footprint(in.position);
        let coarse = pattern(in.position * select(15.0, 5.3, kind > 5.5), pixel * 15.0).a;
        if (kind > 5.5) {
            shade = stone_shade(in.position, coarse, pixel);
            // Where resin is at the surface it is duller than the stone.
            s.roughness += 0.16 * (coarse - 0.5);
        } else if (kind > 4.5) {
            shade = linen_shade(in.position, coarse, pixel);
        } else if (in.surface.y > 0.95) {
            s = ground_steel(s, in.position, pixel);
        } else if (in.surface.x > 0.85) {
            s = plastered(s, in.position, pixel);
        }
    }
    s.albedo *= shade;
    s.visibility *= pan_foot(in.position) * nearby(in.clip.xy);
    let lit = shadow_on_ground(in.position, n);
    let radiance = diffuse(s, lit) + specular(s, in.position, view, lit);
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Joints between the staves of the board, over its width (chosen: staves of about 5 cm, none like the next).
const JOINTS = vec4<f32>(0.19, 0.40, 0.585, 0.80);
// Of each stave: tone; from the middle of the tree, how far it was cut to the side and above it [m]; lean of the trunk
// (chosen: near the middle of the trunk rings make arcs on the face, aside of it lines).
var<private> STAVES: array<vec4<f32>, 5> = array<vec4<f32>, 5>(
    vec4<f32>(0.98, -0.075, 0.026, 0.02), vec4<f32>(1.07, 0.004, 0.036, 0.10), vec4<f32>(0.90, 0.052, 0.040, -0.04),
    vec4<f32>(1.02, -0.010, 0.044, -0.085), vec4<f32>(1.09, 0.090, 0.018, 0.03));
// Width of a year's ring [m] (chosen: a maple grows two to three millimetres a year).
const YEAR = 0.0024;

// Wood at a place: shade, how late in the year it grew (0-1), and the place, pulled about as its fibres are.
struct Wood {
    shade: vec3<f32>,
    late: f32,
    place: vec3<f32>,
};

// Rings of the tree as a stave cuts them: each pale in spring, darker towards its end, which is sharp.
fn wood_at(position: vec3<f32>, stave: f32, pixel: f32) -> Wood {
    let own = STAVES[u32(stave)];
    let middle = mix(frame.board.x, frame.board.z, 0.1 + 0.2 * stave);
    let shifted = position + vec3<f32>(0.0, stave * 0.173, stave * 0.37);
    let warp = textureSampleLevel(solid_noise, tile_sampler, shifted * vec3<f32>(3.2, 1.1, 3.2), 0.0);
    let from_pith = vec2<f32>(position.x - middle - own.y, position.z - frame.mode.w + own.z + own.w * position.y);
    let years = (length(from_pith) + 0.008 * (warp.a - 0.5)) / YEAR;
    // Wet years and dry ones.
    let grown = years + 2.0 * abs(fract(years * 0.132) - 0.5) + 0.9 * abs(fract(years * 0.334 + 0.2) - 0.5);
    let blur = fwidth(years) * 1.3;
    let year = floor(grown);
    let part = grown - year;
    let end = 1.0 - clamp(blur, 0.10, 0.5);
    let late = smoothstep(0.15, end, part) * smoothstep(1.0, end, part);
    let strong = (0.35 + 0.65 * fract(year * 0.618 + stave * 0.37)) * clamp(1.35 - 1.5 * blur, 0.0, 1.0);
    let place = shifted + vec3<f32>(0.0035 * (warp.a - 0.5), 0.0, 0.0);
    // Darker staves are redder.
    let tone = own.x + (own.x - 1.0) * vec3<f32>(0.0, 0.25, 0.6);
    return Wood(tone * ((1.0 - 0.27 * strong * (late - 0.36)) * (1.0 + 0.16 * (warp.r - 0.5))), late * strong, place);
}

// Oiled hardwood, staves glued side by side: growth rings, pores, scratches of knives, worn paler where they pass.
@fragment
fn fs_wood(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let pixel = footprint(in.position);
    let width = frame.board.z - frame.board.x;
    let across = (in.position.x - frame.board.x) / width;
    let stave = dot(step(JOINTS, vec4<f32>(across)), vec4<f32>(1.0));
    let near = abs(JOINTS - across) * width;
    let joint = line_cover(min(min(near.x, near.y), min(near.z, near.w)), 0.00016, pixel);
    let wood = wood_at(in.position, stave, pixel);
    var light = 0.885 * wood.shade * (1.0 - 0.55 * joint);
    if (!quick) {
        // Fibres, seen as a sheen more than as streaks.
        let fibres = pattern(wood.place * vec3<f32>(130.0, 11.0, 130.0), pixel * 100.0);
        let worn = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(5.0, 4.0, 5.0), 0.0).a;
        light *= 1.0 + 0.16 * (fibres.a - 0.5);
        light *= mix(0.96, 1.08, smoothstep(0.4, 0.7, worn)) - 0.10 * smoothstep(0.33, 0.20, worn);
        s.roughness += 0.20 * (fibres.a - 0.5) - 0.08 * wood.late + 0.14 * (worn - 0.5);
        s.normal = normalize(n + vec3<f32>((fibres.x - 0.5) * 0.10, 0.0, 0.0));
        if (fine && n.z > 0.7) { light *= worked_face(wood.place, in.position, pixel); }
    }
    // Late wood is redder.
    s.albedo *= light * mix(vec3<f32>(1.0, 1.01, 1.03), vec3<f32>(1.0, 0.96, 0.90), wood.late);
    let lit = shadow_on_ground(in.position, n);
    s.visibility *= min(openness(in.position), nearby(in.clip.xy));
    let radiance = diffuse(s, lit) + specular(s, in.position, view, lit);
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Shade of what is on the face of the board only: flecks of the rays, pores, scratches of knives.
fn worked_face(place: vec3<f32>, position: vec3<f32>, pixel: f32) -> f32 {
    let flecks = dashes(place.xy, vec2<f32>(0.0013, 0.0052), 0.00016, pixel, 11u);
    let pores = dashes(place.xy, vec2<f32>(0.00055, 0.0061), 0.00008, pixel, 23u);
    // Blades pass across the grain, a little askew.
    let askew = mat2x2<f32>(0.94, 0.34, -0.34, 0.94) * position.xy;
    let other = mat2x2<f32>(0.88, -0.47, 0.47, 0.88) * position.xy;
    let first = scratch(askew, vec2<f32>(0.075, 0.019), 0.00009, pixel, 5u);
    let second = scratch(other, vec2<f32>(0.052, 0.027), 0.00007, pixel, 9u);
    // A cut throws up an edge that catches light beside the dark of its groove.
    let cut_edge = 0.10 * (step(0.0, first.x) * exp(-first.x * 4000.0) * smoothstep(0.0, 0.1, first.y));
    let hairs = pattern(place * vec3<f32>(430.0, 21.0, 60.0), pixel * 430.0).a - 0.5;
    return (1.0 + 0.15 * hairs + cut_edge) * (1.0 - 0.20 * flecks - 0.26 * pores) * (1.0 - 0.45 * first.y) * (1.0 - 0.36 * second.y);
}

// Radiance of the ring printed on the glass: a thin pale line that glows faintly with power.
fn printed_ring(position: vec3<f32>, pixel: f32) -> vec3<f32> {
    let radius = length(position.xy);
    let line = line_cover(radius - 0.142, 0.00065, pixel) + 0.5 * line_cover(radius - 0.1455, 0.0004, pixel);
    let corner = abs(position.xy);
    let cross = step(max(corner.x, corner.y), 0.158) * step(0.150, max(corner.x, corner.y)) * step(min(corner.x, corner.y), 0.0007);
    let glow = exp(-abs(radius - 0.143) * 190.0) * frame.mode.x;
    let print = max(line, cross);
    return print * vec3<f32>(0.20) + vec3<f32>(0.9, 0.17, 0.04) * (glow * 0.13 + print * frame.mode.x * 0.55);
}

// Height below which a surface belongs to the well of a burner [m].
const WELL_TOP = -0.0085;

// Radiance of a zone over a radiant element: two thin printed lines, and ribbons that glow through the glass.
fn glowing_zone(position: vec3<f32>) -> vec3<f32> {
    let radius = length(position.xy);
    let line = smoothstep(0.0009, 0.0004, abs(radius - 0.092)) + 0.5 * smoothstep(0.0006, 0.0002, abs(radius - 0.0955));
    let turns = radius / 0.011 + atan2(position.y, position.x) / 6.2831853;
    let ribbon = smoothstep(0.42, 0.16, abs(fract(turns) - 0.5));
    let inside = smoothstep(0.089, 0.086, radius) * smoothstep(0.008, 0.012, radius);
    // Of a coil that is half seen the insulation round it is lit too.
    let light = inside * (0.28 + ribbon) + 0.35 * exp(-max(radius - 0.088, 0.0) * 60.0) * step(0.088, radius);
    return line * vec3<f32>(0.20) + vec3<f32>(1.6, 0.24, 0.03) * light * frame.mode.x;
}

// A flame of gas: a mantle of weak blue, as bright as it is thick, so that its edge is soft; in it a bright small cone with a pale
// tip, above it only a breath of light. It trembles.
@fragment
fn fs_flame(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let thick = abs(dot(normalize(in.normal), view));
    var along = in.surface.x;
    if (!quick) {
        let tremble = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(in.position.xy * 3.0, frame.eye.w * 0.9), 0.0).a - 0.5;
        along += 0.35 * tremble * along;
    }
    // Squared, so that no side of the drawn cone is seen as a face.
    let soft = smoothstep(0.10, 1.0, thick) * thick;
    let root = smoothstep(0.0, 0.16, along);
    let mantle = soft * smoothstep(1.0, 0.15, along) * root;
    // The cone is narrower than the mantle, and brightest where it ends.
    let inside = smoothstep(0.45 + 0.7 * along, 1.0 + 0.3 * along, thick);
    let cone = inside * root * smoothstep(0.55, 0.28, along) * mix(0.6, 1.0, smoothstep(0.1, 0.35, along));
    let tip = soft * exp(-pow((along - 0.60) * 4.5, 2.0));
    let light = vec3<f32>(0.012, 0.060, 0.34) * mantle * 0.55 + vec3<f32>(0.10, 0.40, 0.80) * cone * 0.6 + vec3<f32>(0.09, 0.11, 0.20) * tip * 0.35;
    let black = pixel_from_radiance(vec3<f32>(0.0), in.clip.xy).rgb;
    return vec4<f32>(max(pixel_from_radiance(light, in.clip.xy).rgb - black, vec3<f32>(0.0)), 0.0);
}

// Steps up the pan's wall at which a mirrored ray is looked at (chosen: their discs overlap).
const WALL_STEPS = 6;

// Share of what a level mirror sees that is the outside of the pan, whose wall leans outwards evenly; softer higher up.
fn pan_mirrored(position: vec3<f32>, towards: vec3<f32>) -> f32 {
    if (towards.z < 0.05) { return 0.0; }
    var most = 0.0;
    for (var k = 0; k < WALL_STEPS; k++) {
        let up = f32(k) / f32(WALL_STEPS - 1);
        let height = up * (frame.pan_place.w + frame.pan_shape.z);
        let at = position.xy + towards.xy * (max(frame.pan_place.z + height - position.z, 0.0) / towards.z);
        let radius = mix(frame.pan_shape.x, frame.pan_shape.y, sqrt(up));
        let soft = 0.003 + 0.25 * height;
        most = max(most, smoothstep(-soft, soft, radius - length(at - frame.pan_place.xy)));
    }
    return most;
}

// Glass that is in use: a thin veil where a cloth has wiped in arcs, dull there, with dust.
fn wiped(s: Surface, position: vec3<f32>, pixel: f32) -> Surface {
    // The wiping arm turns about a point in front of the hob.
    let from_elbow = position.xy - vec2<f32>(0.12, -0.62);
    let arc = vec3<f32>(length(from_elbow) * 11.0, atan2(from_elbow.y, from_elbow.x) * 0.5, 0.3);
    let wipe = pattern(arc, pixel * 11.0).a;
    let film = pattern(position * 3.1, pixel * 3.1).a;
    let veil = smoothstep(0.42, 0.75, wipe) * smoothstep(0.35, 0.65, film);
    let dust = smoothstep(0.74, 0.84, pattern(position * 170.0, pixel * 170.0).a) * (0.3 + 0.7 * film);
    var out = s;
    out.albedo += vec3<f32>(0.0045, 0.0044, 0.0042) * veil + vec3<f32>(0.020) * dust;
    out.roughness += 0.14 * veil + 0.05 * (film - 0.5);
    return out;
}

@fragment
fn fs_glass(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let lit = shadow_on_ground(in.position, n);
    let pixel = footprint(in.position);
    if (fine) { s.roughness = widened(s.roughness, fwidth(in.normal)); }
    s.visibility *= pan_foot(in.position);
    var seen = mix(0.2, 0.7, s.visibility);
    if (!quick) {
        s = wiped(s, in.position, pixel);
        // The pan is seen in the glass, so that what else is seen need not be dimmed for it.
        seen = mix(0.5, 0.7, s.visibility) * (1.0 - 0.85 * pan_mirrored(in.position, reflect(-view, n)));
    }
    // What a mirror shows does not depend on the light that falls on it.
    var radiance = diffuse(s, lit) + specular(s, in.position, view, mix(1.0, lit, select(0.15, 1.0, quick))) * seen;
    let kind = in.surface.z;
    if (kind > 6.5) {
        radiance += glowing_zone(in.position) * max(s.visibility, 0.5);
    } else if (kind > 2.5) {
        radiance += printed_ring(in.position, pixel) * s.visibility;
    } else if (in.position.z < WELL_TOP) {
        // Flames light the well in which they burn.
        let away = max(length(in.position.xy) - 0.045, 0.0);
        let flames = vec3<f32>(0.09, 0.30, 1.0) * frame.mode.x * exp(-away * 17.0) * (0.35 + 0.65 * max(n.z, 0.0));
        radiance += (s.albedo + 0.02) * flames * 2.2;
    }
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Part of the reflected ray that leaves the pan above its rim.
fn escapes_pan(local: vec3<f32>, towards: vec3<f32>) -> f32 {
    let rim = frame.pan_shape.y;
    let flat_length = max(length(towards.xy), 1e-3);
    let d = towards.xy / flat_length;
    let b = dot(local.xy, d);
    let reach = -b + sqrt(max(b * b + rim * rim - dot(local.xy, local.xy), 1e-6));
    let height = local.z + reach * towards.z / flat_length;
    let top = frame.pan_place.w + frame.pan_shape.z;
    return smoothstep(top - 0.030, top + 0.030, height);
}

// What is on a place of the floor.
struct Film {
    // Thickness of oil and of water [mm].
    oil: f32,
    water: f32,
    fond: f32,
    foam: f32,
};

// OIL_MM and WATER_MM, the thickness that the ends of the bytes represent, and TINT_RANGE are those of `pan.rs`.

fn film_on(local: vec3<f32>) -> Film {
    let uv = local.xy / frame.pan_shape.x * 0.5 + 0.5;
    let film = textureSampleLevel(pan_film, clamp_sampler, uv, 0.0);
    return Film(film.r * film.r * OIL_MM, film.g * film.g * WATER_MM, film.b, film.a);
}

// What heat has done to the colour of the pan at a place of its inside.
fn heat_tint(local: vec3<f32>) -> vec3<f32> {
    let radius = length(local.xy);
    let floor = frame.pan_shape.x;
    let rise = length(vec2<f32>(frame.pan_shape.y - floor, frame.pan_shape.z));
    let up = length(vec2<f32>(max(radius - floor, 0.0), max(local.z - frame.pan_place.w, 0.0)));
    let unrolled = select(radius, floor + min(up, rise), radius > floor);
    let at = local.xy / max(radius, 1e-5) * unrolled / (floor + rise);
    return textureSampleLevel(pan_tint, clamp_sampler, at * 0.5 + 0.5, 0.0).rgb * TINT_RANGE;
}

// Runnels by which a film drains from a tilted pan: long along the slope, narrow across it. Slope of their sides, pan frame, and
// how much fuller (above 0) or emptier they are; 0 in a level pan.
fn runnels(local: vec3<f32>) -> vec3<f32> {
    let downhill = (frame.pan_from_world * vec4<f32>(0.0, 0.0, -1.0, 0.0)).xy;
    let steep = length(downhill);
    if (steep < 0.03) { return vec3<f32>(0.0); }
    let along = downhill / steep;
    let across = vec2<f32>(-along.y, along.x);
    let at = vec3<f32>(dot(local.xy, across) * 42.0, dot(local.xy, along) * 4.0 - frame.eye.w * 0.4 * steep, 0.37);
    let here = textureSampleLevel(solid_noise, tile_sampler, at, 0.0);
    let shown = smoothstep(0.03, 0.10, steep);
    return vec3<f32>(across * (here.r - 0.5) * 0.22, here.a - 0.5) * shown;
}

// Surface of a pan by its kind: cast iron is grained and seasoned in patches, carbon steel has a patina, bare metal is brushed in
// circles. `patchy` and `turned` are the noise that every level has.
fn pan_skin(s: Surface, local: vec3<f32>, metalness: f32, patchy: f32, turned: f32, pixel: f32) -> Surface {
    var out = s;
    let bare = smoothstep(0.85, 1.0, metalness);
    let iron = smoothstep(0.6, 0.4, metalness) * step(0.1, metalness);
    let radius = length(local.xy);
    let clouds = pattern(local * 2.3 + 0.4, pixel * 2.3).a - 0.5;
    let spots = pattern(local * 19.0, pixel * 19.0);
    let grain = pattern(local * 120.0, pixel * 120.0);
    // The sand of the mould.
    var bump = (grain.xyz - 0.5) * 0.22 * iron + (spots.xyz - 0.5) * 0.10 * iron;
    // Marks of the brush run round: they spread the light across themselves.
    let lines = pattern(vec3<f32>(radius * 260.0, local.z * 200.0, 0.1), pixel * 260.0).a - 0.5;
    let outward = vec3<f32>(local.xy / max(radius, 1e-4), 0.0);
    bump += outward * ((lines + 0.6 * turned) * (0.10 + 0.12 * clouds) * bare);
    // The rolled rim is thin: a bumpy one would glitter.
    let rim = frame.pan_place.w + frame.pan_shape.z - local.z;
    let on_rim = smoothstep(0.0060, 0.0030, rim) * step(abs(radius - frame.pan_shape.y), 0.006);
    out.normal = normalize(s.normal + bump * (1.0 - on_rim));
    // Seasoning: brown to blue where oil has burnt on, blotched.
    let season = (1.0 - bare) * step(0.1, metalness);
    let hue = clamp(1.3 * clouds + 0.8 * (spots.a - 0.5) + 0.7 * patchy, -0.5, 0.5);
    let strong = mix(0.12, 0.05, iron);
    let tone = vec3<f32>(1.0) + vec3<f32>(strong, 0.0, -1.1 * strong) * (2.0 * hue);
    out.f0 *= mix(vec3<f32>(1.0), tone, season) * (1.0 + season * (0.35 * hue + 0.40 * (spots.a - 0.5)));
    out.albedo *= mix(vec3<f32>(1.0), tone, season);
    out.roughness += season * (0.16 * (spots.a - 0.5) - 0.20 * clouds) + bare * (0.12 * clouds + 0.10 * lines);
    // The rim is rubbed bright by lids, tools and hands.
    let rubbed = on_rim * smoothstep(0.0042, 0.0010, rim) * smoothstep(-0.30, 0.20, spots.a - 0.5 + clouds);
    out.f0 += vec3<f32>(0.075, 0.073, 0.070) * rubbed * season;
    out.roughness = clamp(out.roughness * (1.0 - 0.20 * rubbed), 0.05, 1.0);
    return out;
}

// Scratches that the turner has left on the floor.
fn turner_marks(at: vec2<f32>, pixel: f32) -> f32 {
    let askew = mat2x2<f32>(0.82, 0.57, -0.57, 0.82) * at;
    let first = scratch(askew, vec2<f32>(0.047, 0.011), 0.00010, pixel, 31u).y;
    let second = scratch(vec2<f32>(askew.y, -askew.x) + 0.3, vec2<f32>(0.061, 0.017), 0.00010, pixel, 37u).y;
    return max(first, second);
}

// Fond as it burns on: blots and specks in a thin brown veil, a darker line where the food ended. Its colour, and the share covered.
fn burnt_on(local: vec3<f32>, fond: f32, pixel: f32) -> vec4<f32> {
    if (quick) { return vec4<f32>(0.042, 0.020, 0.009, fond); }
    let blots = pattern(local * 16.0, pixel * 16.0);
    // Its outline is ragged: the texture is coarser than that.
    let ragged = film_on(local + vec3<f32>((blots.xy - 0.5) * 0.016, 0.0)).fond;
    if (ragged <= 0.0) { return vec4<f32>(0.0); }
    let large = pattern(local * 6.1 + 0.2, pixel * 6.1).a - 0.5;
    let specks = pattern(local * 88.0, pixel * 88.0).a - 0.5;
    let line = smoothstep(0.04, 0.30, ragged) * smoothstep(0.85, 0.45, ragged);
    let thick = ragged * (0.50 + 0.9 * large + 1.0 * (blots.a - 0.5) + 0.7 * specks) + 0.22 * line;
    let covered = 1.0 - exp(-2.6 * max(thick, 0.05 * ragged));
    return vec4<f32>(mix(vec3<f32>(0.052, 0.026, 0.011), vec3<f32>(0.017, 0.009, 0.005), smoothstep(0.1, 0.8, thick)), covered);
}

@fragment
fn fs_metal(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    var n = facing(in.normal, view);
    var turn = vec3<f32>(0.0);
    if (fine) { turn = fwidth(in.normal); }
    let pixel = footprint(in.position);
    let local = in_pan(in.position);
    let radius = length(local.xy);
    let is_floor = in.surface.z > 1.5;
    let field = floor_field(radius);
    if (is_floor && frame.mode.y > 0.5 && field >= 0.0) {
        return vec4<f32>(lightly_lit(table_colour(field), n, openness(in.position)), 1.0);
    }
    var coarse = vec4<f32>(0.5);
    var fine = 0.5;
    if (!quick) {
        coarse = textureSampleLevel(solid_noise, tile_sampler, local * 6.5, 0.0);
        fine = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(radius * 110.0, local.z * 60.0, atan2(local.y, local.x) * 0.32), 0.0).a;
    }
    let inside = step(radius, frame.pan_shape.y - 0.001) * step(frame.pan_place.w - 0.001, local.z);
    var tint = vec3<f32>(1.0);
    if (is_floor || inside > 0.0) { tint = heat_tint(local); }
    var s = plain_surface(in, n);
    s.f0 *= tint;
    // Seasoning is patchy; turning marks are circular.
    let patchy = coarse.a - 0.5;
    s.f0 *= 1.0 + 0.35 * patchy + 0.16 * (fine - 0.5);
    // The patina over the metal scatters a little.
    s.albedo = in.colour * tint * (1.0 - 0.84 * in.surface.y) * (1.0 + 0.35 * patchy);
    s.roughness = clamp(s.roughness + 0.14 * patchy + 0.10 * (fine - 0.5), 0.05, 1.0);
    if (!quick) {
        s = pan_skin(s, local, in.surface.y, patchy, fine - 0.5, pixel);
        if (is_floor) { s.f0 *= 1.0 + 0.45 * turner_marks(local.xy, pixel); }
    }
    s.roughness = widened(s.roughness, turn);
    let lit = shadow_on_ground(in.position, n);
    let open = min(openness(in.position), nearby(in.clip.xy));
    let depth = clamp((frame.pan_place.w + frame.pan_shape.z - local.z) / frame.pan_shape.z, 0.0, 1.0);
    let corner = smoothstep(0.035, 0.0, abs(radius - frame.pan_shape.x)) * depth;
    s.visibility *= open * (1.0 - inside * (0.22 * depth + 0.25 * corner));
    let towards = reflect(-view, n);
    let leaves = mix(1.0, mix(0.30, 1.0, escapes_pan(local, (frame.pan_from_world * vec4<f32>(towards, 0.0)).xyz)), inside);
    // Under oil the metal's own highlight fades: the film takes its place.
    if (!is_floor) {
        let bare = diffuse(s, lit) + specular(s, in.position, view, lit) * leaves * 0.66;
        return pixel_from_radiance(bare, in.clip.xy);
    }
    let film = film_on(local);
    // A thin film beads: droplets and streaks, then a sheet. In a tilted pan it drains by runnels.
    let beads = coarse.a - 0.5 + 0.5 * (fine - 0.5);
    let ran = runnels(local);
    let cover = smoothstep(0.004, 0.030, film.oil + 0.030 * beads + 0.100 * ran.z) * smoothstep(0.0, 0.004, film.oil);
    let fond = burnt_on(local, film.fond, pixel);
    s.albedo = mix(s.albedo, fond.rgb, fond.a);
    s.f0 *= 1.0 - 0.8 * fond.a;
    let metal = leaves * (0.66 - 0.38 * cover - 0.12 * smoothstep(0.1, 0.6, film.oil));
    var radiance = diffuse(s, lit) + unblown(specular(s, in.position, view, lit) * metal);
    // In a half mirror the real metal is seen: only what the liquids themselves send is added, without dither on black.
    let added = frame.oil.w > 0.5;
    if (added) { radiance = vec3<f32>(0.0); }
    radiance = under_oil(radiance, in, n, view, lit, open, cover, film.oil, (coarse.xy - 0.5) * (1.0 - cover) * 0.12 + ran.xy);
    radiance = under_water(radiance, in, n, view, lit, open, film.water, beads);
    // Where water boils in butter there is foam.
    let boiling = frame.white.w * 0.8 * smoothstep(0.02, 0.25, film.water);
    radiance = under_foam(radiance, in, n, view, lit, open, max(film.foam, boiling), smoothstep(0.02, 0.10, film.oil), pixel);
    if (added) { return vec4<f32>(srgb_from_linear(filmic(radiance)), 1.0); }
    return pixel_from_radiance(radiance, in.clip.xy);
}

// The real thing is seen through the mirror: nothing is added to it, and it hides what is behind it.
@fragment
fn fs_occluder() -> @location(0) vec4<f32> {
    return vec4<f32>(0.0, 0.0, 0.0, 1.0);
}

// Brightness up to which the window is seen as it is in the pan's floor, and by how much it is brighter at most (chosen: its glints
// are white, its image as a whole is not).
const PLAIN = 1.0;
const BLOWN = 8.0;

// A highlight that nears a brightness slowly instead of burning out.
fn unblown(light: vec3<f32>) -> vec3<f32> {
    let most = max(max(light.r, light.g), light.b);
    let over = max(most - PLAIN, 0.0);
    return light * ((most - over + over / (1.0 + over / BLOWN)) / max(most, 1e-4));
}

// A mirror over the floor: what leaves the pan above its rim is seen in it, and the wall elsewhere.
fn liquid_mirror(in: SolidOut, surface: vec3<f32>, roughness: f32, view: vec3<f32>, lit: f32, open: f32) -> vec3<f32> {
    let s = Surface(vec3<f32>(0.0), vec3<f32>(0.036), roughness, surface, open, vec3<f32>(0.0));
    let towards = reflect(-view, surface);
    let leaves = mix(0.15, 1.0, escapes_pan(in_pan(in.position), (frame.pan_from_world * vec4<f32>(towards, 0.0)).xyz));
    return unblown(specular(s, in.position, view, lit) * leaves * 0.7);
}

// Depth of oil that has the colour of the bottle [mm] (chosen: a bottle is a few times as deep, but lit from all sides; so a pool
// of 2 mm is pale gold).
const OIL_DEPTH = 9.0;
// How quickly molten butter with its milk solids turns opaque [1/mm] (chosen: a film of half a millimetre is cloudy).
const TURBID = 2.2;

// Steps of a mirrored ray, and how far up it may meet food [m] (chosen: most of a steak; higher up its edge is soft).
const MIRROR_STEPS = 14;
const MIRROR_HEIGHT = 0.020;

// Share of what a film mirrors that food next to it hides: the film mirrors the window, and a food in front of it is dark.
// `jitter`, 0 to 1, differs from pixel to pixel, so that the steps of the ray show no teeth.
fn hidden_by_food(position: vec3<f32>, towards: vec3<f32>, jitter: f32) -> f32 {
    if (!fine || towards.z <= 0.05) { return 0.0; }
    var hidden = 0.0;
    for (var k = 0; k < MIRROR_STEPS; k++) {
        let share = (f32(k) + jitter) / f32(MIRROR_STEPS);
        let at = position + towards * (MIRROR_HEIGHT * share / towards.z);
        let uv = (at.xy - frame.contact_rect.xy) * frame.contact_rect.zw;
        let height = (at.z - frame.contact_height.x) * frame.contact_height.y;
        let over = 1.0 - textureSampleCompareLevel(contact_map, depth_sampler, uv, height);
        hidden = max(hidden, over * (1.0 - smoothstep(0.75, 1.05, share)));
    }
    return 0.85 * hidden;
}

// A clear film: hardly coloured where it is thin, mirror-smooth on top, with slow waves.
fn under_oil(below: vec3<f32>, in: SolidOut, n: vec3<f32>, view: vec3<f32>, lit: f32, open: f32, cover: f32, thickness: f32, slope: vec2<f32>) -> vec3<f32> {
    let local = in_pan(in.position);
    let wave = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(local.xy * 9.0, frame.eye.w * 0.05), 0.0).rgb - 0.5;
    let film = normalize(n + vec3<f32>(wave.xy * 0.06 + slope, 0.0));
    // A used pan is smeared: a thin film is smooth here and dull there; a deep one is a mirror.
    let smeared = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(local.xy * 23.0, 0.71), 0.0).a;
    let mirror = liquid_mirror(in, film, mix(0.32, mix(0.045, mix(0.20, 0.07, smoothstep(0.05, 0.30, thickness)), smoothstep(0.35, 0.70, smeared)), cover), view, lit, open) * (1.0 - hidden_by_food(in.position, reflect(-view, film), 0.2 + 0.8 * gradient_noise(in.clip.xy + frame.origin.xy + frame.origin.w)));
    // Light passes the film twice; a deep pool also sends some back itself.
    let passed = pow(frame.oil.rgb, vec3<f32>(2.0 * thickness / OIL_DEPTH));
    let deep = 1.0 - exp(-thickness * mix(1.0 / OIL_DEPTH, TURBID, frame.white.w));
    // Butter sends back more light than clear oil, and yellower.
    let sent = mix(vec3<f32>(0.40, 0.31, 0.14), vec3<f32>(0.54, 0.38, 0.10), frame.white.w);
    let glow = frame.oil.rgb * sent * deep * (0.35 + 0.65 * lit) * open;
    return mix(below, below * passed + glow + mirror, cover);
}

// Juice and water: puddles with a round edge, a little cloudy, trembling while they boil.
fn under_water(below: vec3<f32>, in: SolidOut, n: vec3<f32>, view: vec3<f32>, lit: f32, open: f32, thickness: f32, beads: f32) -> vec3<f32> {
    let depth = thickness + 0.35 * beads * smoothstep(0.0, 0.05, thickness);
    // In butter it is fine drops, not a puddle.
    let cover = smoothstep(0.06, 0.22, depth) * (1.0 - 0.9 * frame.white.w);
    if (cover <= 0.0) { return below; }
    let local = in_pan(in.position);
    let at = vec3<f32>(local.xy * 34.0, frame.eye.w * 0.9);
    let tremble = textureSampleLevel(solid_noise, tile_sampler, at, 0.0).rgb - 0.5;
    let surface = normalize(n + vec3<f32>(tremble.xy * (0.25 + 0.6 * (1.0 - cover)), 0.0));
    let juice = vec3<f32>(0.105, 0.070, 0.040) * (0.4 + 0.6 * lit) * open;
    let cloudy = 1.0 - exp(-0.9 * max(depth, 0.0));
    return mix(below, mix(below, juice, 0.75 * cloudy) + liquid_mirror(in, surface, 0.08, view, lit, open), cover);
}

// Sides of the cells in which foam has a bubble each [m], from the largest, and the share of the cells that have one where it is
// dense (chosen: few of 3 to 6 mm, many of 1 to 2 mm, froth between them).
const FOAM_CELLS = vec3<f32>(0.0054, 0.0027, 0.0014);
const FOAM_SHARES = vec3<f32>(0.20, 0.62, 0.95);
// Changes of a bubble a second (chosen: large ones stay for seconds).
const FOAM_TURNS = vec3<f32>(0.35, 0.60, 0.90);

// The highest of the bubbles at a place: the way from its middle over its radius, how high its dome is there [m], its radius [m]; no
// radius where there is none. Where domes meet the higher one is seen, so that they press against each other.
fn foam_bubbles(place: vec2<f32>, size: i32, share: f32, found: vec4<f32>) -> vec4<f32> {
    var best = found;
    let side = FOAM_CELLS[size];
    // The sizes lie askew to each other, so that no rows are seen.
    let askew = 0.45 + 1.1 * f32(size);
    let at = vec2<f32>(cos(askew) * place.x - sin(askew) * place.y, sin(askew) * place.x + cos(askew) * place.y) / side;
    let first = floor(at - 0.5);
    for (var k = 0; k < 4; k++) {
        let cell = first + vec2<f32>(f32(k & 1), f32(k >> 1));
        let own = random3(vec3<f32>(cell, 3.0 + f32(size)));
        // Whole turns in the time after which the clock begins anew.
        let turn = frame.eye.w * 0.001 * floor(1000.0 * FOAM_TURNS[size] * (0.6 + 0.8 * own.x)) + own.y * 7.0;
        let now = random3(vec3<f32>(cell + 0.5, 17.0 * f32(size) + floor(turn)));
        if (now.z > share) { continue; }
        let age = fract(turn);
        let radius = mix(0.30, 0.66, own.z * own.z) * min(0.5 + 1.6 * age, 1.0) * min((1.0 - age) * 14.0, 1.0);
        let off = (at - cell - 0.5 - (now.xy - 0.5) * 0.6) / max(radius, 0.01);
        let away = dot(off, off);
        if (away >= 1.0) { continue; }
        let height = (sqrt(1.0 - away) - 0.35) * radius * side;
        if (height > best.z || best.w == 0.0) {
            let back = vec2<f32>(cos(askew) * off.x + sin(askew) * off.y, cos(askew) * off.y - sin(askew) * off.x);
            best = vec4<f32>(back, height, radius * side);
        }
    }
    return best;
}

// How thick foam lies at a place: below 0 there is none. It gathers round food, and its patches drift.
fn foam_depth(patchy: f32, foam: f32, open: f32) -> f32 {
    return foam * (1.45 + 2.4 * (1.0 - open)) + 2.4 * (patchy - 0.5) - 0.72;
}

// Side of the cells that have a speck of milk each, at most [m] (chosen: curds are a few tenths of a millimetre).
const SPECK_CELL = 0.0021;

// Milk solids in open butter: specks in clouds. Share that they hide.
fn milk_specks(place: vec2<f32>, pixel: f32) -> f32 {
    let cloud = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(place * 8.0, 0.83), 0.0);
    // Askew and bent, so that no rows are seen.
    let at = (mat2x2<f32>(0.8, 0.6, -0.6, 0.8) * place + 0.004 * cloud.rg) / SPECK_CELL;
    let cell = floor(at);
    let own = random3(vec3<f32>(cell, 1.0));
    let radius = mix(0.06, 0.22, own.z * own.z * own.z);
    let soft = pixel / SPECK_CELL;
    let off = length(fract(at) - mix(vec2<f32>(radius), vec2<f32>(1.0 - radius), own.xy));
    let there = step(fract(own.x * 7.31 + own.z * 3.7), smoothstep(0.25, 0.70, cloud.a));
    return smoothstep(radius + soft, max(radius - soft, 0.0), off) * min(radius / max(soft, 0.02), 1.0) * there;
}

// Foam of butter: heaped bubbles of mixed sizes in patches that drift, single ones in the open butter between. `thin` is 1 where
// there is enough butter for its solids to show.
fn under_foam(below: vec3<f32>, in: SolidOut, n: vec3<f32>, view: vec3<f32>, lit: f32, open: f32, foam: f32, thin: f32, pixel: f32) -> vec3<f32> {
    let local = in_pan(in.position);
    var ground = below;
    if (!quick && frame.white.w > 0.2) {
        let speck = frame.oil.rgb * frame.oil.rgb * mix(0.10, 0.55, smoothstep(0.2, 0.6, frame.oil.g));
        ground = mix(ground, speck * (0.4 + 0.6 * lit) * open, 0.5 * thin * frame.white.w * milk_specks(local.xy, pixel));
    }
    if (foam <= 0.02) { return ground; }
    let drift = vec2<f32>(sin(frame.eye.w * 0.6911504), cos(frame.eye.w * 0.5026548)) * 0.0016;
    let at = vec3<f32>((local.xy + drift) * 6.0, frame.eye.w * 0.02);
    let broad = textureSampleLevel(solid_noise, tile_sampler, at, 0.0);
    var patchy = broad.a;
    var slope = broad.rg - 0.5;
    if (!quick) {
        let small = textureSampleLevel(solid_noise, tile_sampler, at * vec3<f32>(2.9, 2.9, 1.0) + 0.4, 0.0);
        patchy += 0.45 * (small.a - 0.5);
        slope += 0.6 * (small.rg - 0.5);
    }
    let depth = foam_depth(patchy, foam, open);
    if (fine) {
        // The heap shades the butter beside it.
        let towards = (frame.pan_from_world * vec4<f32>(frame.key.xyz, 0.0)).xy * 0.004;
        let beside = textureSampleLevel(solid_noise, tile_sampler, at + vec3<f32>(towards * 6.0, 0.0), 0.0).a;
        ground *= 1.0 - 0.35 * smoothstep(0.0, 0.45, foam_depth(beside, foam, open));
    }
    let dense = smoothstep(0.0, 0.55, depth);
    // A few single bubbles swim in the open butter.
    let single = 0.10 * foam;
    var found = vec4<f32>(0.0);
    for (var size = select(0, 1, quick); size < select(3, 2, quick); size++) {
        // Bubbles of a pixel are froth.
        if (!fine && FOAM_CELLS[size] < 1.6 * pixel) { continue; }
        found = foam_bubbles(local.xy + drift, size, max(FOAM_SHARES[size] * dense, single), found);
    }
    // Froth too fine to be seen fills what is between.
    let froth = smoothstep(0.15, 0.75, depth);
    if (froth <= 0.0 && found.w == 0.0) { return ground; }
    // Bubbles of a few pixels lose their shape.
    let clear = smoothstep(0.4, 1.6, found.w / pixel);
    let away = dot(found.xy, found.xy);
    let rim = away * away;
    let bulge = found.xy * clear;
    let normal = normalize(n + vec3<f32>(0.85 * bulge - 1.2 * slope * dense, 0.0));
    // Large bubbles and single ones are thin skins: what is under them shows through their crowns.
    let skin = mix(0.95, mix(0.42, 0.90, rim), smoothstep(0.0008, 0.0022, found.w) * clear);
    let alone = mix(0.30, mix(0.12, 0.50, rim), clear);
    let bubble = select(0.0, mix(alone, skin, dense), found.w > 0.0);
    let cover = max(bubble, froth * 0.93 * select(1.0, mix(1.0, skin, 0.6), found.w > 0.0));
    // Between the bubbles it is deep and yellow.
    let low = mix(0.62, 1.0 - rim * rim, select(0.0, clear, found.w > 0.0));
    let tone = mix(vec3<f32>(0.60, 0.47, 0.28), vec3<f32>(0.94), low);
    let white = mix(frame.oil.rgb, vec3<f32>(1.0, 0.95, 0.83), 0.75) * tone;
    let key = max((dot(normal, frame.key.xyz) + 0.35) / 1.35, 0.0);
    let light = frame.key_light.rgb * key * (0.2 + 0.8 * lit) * 0.66 + frame.other_light.rgb * (0.25 + 0.45 * max(dot(normal, frame.other.xyz), 0.0)) + frame.fill_sky.rgb * mix(0.7, 1.0, low);
    var foamed = mix(ground, white * light * mix(0.55, 1.0, open), cover);
    if (!quick && found.w > 0.0) {
        // The window lies in every crown, and through a clear one its light gathers at the far side.
        let skinned = normalize(n + vec3<f32>(1.3 * bulge - 0.4 * slope * dense, 0.0));
        foamed += liquid_mirror(in, skinned, mix(0.5, 0.10, clear), view, lit, open) * mix(0.25, 1.0, clear);
        let far = max(-dot(found.xy, normalize(frame.key.xy)), 0.0) * smoothstep(1.0, 0.75, away);
        foamed += frame.oil.rgb * frame.key_light.rgb * (0.16 * far * far * clear * (1.0 - 0.7 * dense) * lit);
    }
    return foamed;
}

// Glass: mirrors the window, fogs with the vapour under it; drops gather where it fogs.
@fragment
fn fs_lid(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    let s = Surface(vec3<f32>(0.0), vec3<f32>(0.04), 0.05, n, 1.0, vec3<f32>(0.0));
    let mirror = specular(s, in.position, view, 1.0);
    let local = in_pan(in.position);
    let drops = textureSampleLevel(bundle_picture, tile_sampler, local.xy * 24.0, 0.0);
    let beaded = 0.55 + 0.45 * smoothstep(0.1, 0.5, drops.r) * step(0.35, drops.g);
    let fog = frame.pan_shape.w * beaded * 0.72;
    let veil = vec3<f32>(0.62, 0.64, 0.65) * (0.5 + 0.5 * n.z);
    let alpha = clamp(0.06 + fog, 0.0, 0.9);
    return vec4<f32>(pixel_from_radiance(veil * 1.4, in.clip.xy).rgb * alpha + srgb_from_linear(filmic(mirror)) * 0.75, alpha);
}

// Flat: the bare table or base colour, nothing else.
@fragment
fn fs_flat_solid(in: SolidOut) -> @location(0) vec4<f32> {
    let is_floor = in.surface.z > 1.5 && in.surface.z < 2.5;
    let field = floor_field(length(in_pan(in.position).xy));
    if (is_floor && frame.mode.y > 0.5 && field >= 0.0) {
        return vec4<f32>(table_colour(field), 1.0);
    }
    // With field colours the rest of the pan only hides what is behind it.
    let plain = srgb_from_linear(in.colour);
    return vec4<f32>(select(plain, vec3<f32>(24.0 / 255.0), frame.mode.y > 0.5), 1.0);
}
