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

@fragment
fn fs_solid(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    if (fine) { s.roughness = widened(s.roughness, fwidth(in.normal)); }
    let kind = in.surface.z;
    var coarse = 0.5;
    if (!quick) { coarse = textureSampleLevel(solid_noise, tile_sampler, in.position * select(15.0, 5.3, kind > 5.5), 0.0).a; }
    // Stone has faint flecks, cloth a weave.
    var speckle = 0.5;
    if (!quick && kind > 5.5) { speckle = textureSampleLevel(solid_noise, tile_sampler, in.position * 150.0, 0.0).a; }
    let stone = 0.90 + 0.20 * coarse + 0.10 * smoothstep(0.62, 0.80, speckle) - 0.09 * smoothstep(0.36, 0.22, speckle);
    let weave = 0.92 + 0.05 * sin(in.position.x * 2600.0) * sin(in.position.y * 2600.0) + 0.12 * (coarse - 0.5);
    s.albedo *= select(1.0, select(weave, stone, kind > 5.5), kind > 4.5);
    s.visibility *= pan_foot(in.position) * nearby(in.clip.xy);
    let lit = shadow_on_ground(in.position, n);
    let radiance = diffuse(s, lit) + specular(s, in.position, view, lit);
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Tones of the staves of the board, from the left; a hash by the sine would differ from device to device.
const FIRST_STAVE = 4.0;
var<private> STAVES: array<f32, 8> = array<f32, 8>(0.66, 0.51, 0.24, 0.08, 0.73, 0.77, 0.97, 0.02);

// Planed staves, glued edge to edge: each with its own tone and grain, oiled, worn paler where knives pass.
@fragment
fn fs_wood(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let across = in.position.x / 0.0425;
    let stave = floor(across);
    let tone = STAVES[u32(clamp(stave - FIRST_STAVE, 0.0, 7.0))];
    let shifted = in.position + vec3<f32>(stave * 0.37, stave * 0.173, 0.0);
    let along = textureSampleLevel(solid_noise, tile_sampler, shifted * vec3<f32>(26.0, 1.9, 22.0), 0.0).a;
    var pores = 0.5;
    var worn = 0.5;
    if (!quick) {
        pores = textureSampleLevel(solid_noise, tile_sampler, shifted * vec3<f32>(210.0, 9.0, 150.0), 0.0).a;
        worn = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(5.0, 4.0, 5.0), 0.0).a;
    }
    let rings = sin((along * 4.2 + shifted.x * 48.0) * 3.6) * 0.5 + 0.5;
    let joint = smoothstep(0.0, 0.012, min(fract(across), 1.0 - fract(across)));
    let light = (0.76 + 0.20 * rings + 0.34 * (pores - 0.5)) * (0.84 + 0.34 * tone) * mix(0.62, 1.0, joint);
    s.albedo *= light * mix(vec3<f32>(1.0, 0.97, 0.93), vec3<f32>(1.0, 1.02, 1.06), rings);
    s.albedo *= mix(vec3<f32>(0.95), vec3<f32>(1.10, 1.10, 1.11), smoothstep(0.4, 0.7, worn));
    s.roughness += 0.25 * (pores - 0.5);
    let lit = shadow_on_ground(in.position, n);
    s.visibility *= min(openness(in.position), nearby(in.clip.xy));
    let radiance = diffuse(s, lit) + specular(s, in.position, view, lit);
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Radiance of the ring printed on the glass: a thin pale line that glows faintly with power.
fn printed_ring(position: vec3<f32>) -> vec3<f32> {
    let radius = length(position.xy);
    let line = smoothstep(0.0009, 0.0004, abs(radius - 0.142)) + 0.5 * smoothstep(0.0006, 0.0002, abs(radius - 0.1455));
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

// A flame of gas: blue where much of it is looked through, paler along the edge of its inner cone, nothing at the tip.
@fragment
fn fs_flame(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let edge = 1.0 - abs(dot(normalize(in.normal), view));
    let along = in.surface.x;
    let body = smoothstep(1.0, 0.25, along);
    let inner = smoothstep(0.55, 0.1, along) * smoothstep(0.25, 0.9, edge);
    let light = vec3<f32>(0.02, 0.09, 0.55) * body * 0.5 + vec3<f32>(0.10, 0.42, 0.85) * inner;
    let black = pixel_from_radiance(vec3<f32>(0.0), in.clip.xy).rgb;
    return vec4<f32>(max(pixel_from_radiance(light, in.clip.xy).rgb - black, vec3<f32>(0.0)), 0.0);
}

@fragment
fn fs_glass(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let lit = shadow_on_ground(in.position, n);
    s.visibility *= pan_foot(in.position);
    var radiance = diffuse(s, lit) + specular(s, in.position, view, lit) * mix(0.2, 0.7, s.visibility);
    let kind = in.surface.z;
    if (kind > 6.5) {
        radiance += glowing_zone(in.position) * max(s.visibility, 0.5);
    } else if (kind > 2.5) {
        radiance += printed_ring(in.position) * s.visibility;
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

@fragment
fn fs_metal(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    var n = facing(in.normal, view);
    var turn = vec3<f32>(0.0);
    if (fine) { turn = fwidth(in.normal); }
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
    s.roughness = widened(clamp(s.roughness + 0.14 * patchy + 0.10 * (fine - 0.5), 0.05, 1.0), turn);
    let lit = shadow_on_ground(in.position, n);
    let open = min(openness(in.position), nearby(in.clip.xy));
    let depth = clamp((frame.pan_place.w + frame.pan_shape.z - local.z) / frame.pan_shape.z, 0.0, 1.0);
    let corner = smoothstep(0.035, 0.0, abs(radius - frame.pan_shape.x)) * depth;
    s.visibility *= open * (1.0 - inside * (0.22 * depth + 0.25 * corner));
    let towards = reflect(-view, n);
    let leaves = mix(1.0, mix(0.30, 1.0, escapes_pan(local, (frame.pan_from_world * vec4<f32>(towards, 0.0)).xyz)), inside);
    // Under oil the metal's own highlight fades: the film takes its place.
    if (!is_floor) {
        let bare = diffuse(s, lit) + specular(s, in.position, view, lit) * leaves * 0.62;
        return pixel_from_radiance(bare, in.clip.xy);
    }
    let film = film_on(local);
    // A thin film beads: droplets and streaks, then a sheet. In a tilted pan it drains by runnels.
    let beads = coarse.a - 0.5 + 0.5 * (fine - 0.5);
    let ran = runnels(local);
    let cover = smoothstep(0.004, 0.030, film.oil + 0.030 * beads + 0.100 * ran.z) * smoothstep(0.0, 0.004, film.oil);
    s.albedo = mix(s.albedo, vec3<f32>(0.042, 0.020, 0.009), film.fond);
    s.f0 *= 1.0 - 0.8 * film.fond;
    var radiance = diffuse(s, lit) + unblown(specular(s, in.position, view, lit) * leaves * (0.62 - 0.38 * cover));
    // In a half mirror the real metal is seen: only what the liquids themselves send is added, without dither on black.
    let added = frame.oil.w > 0.5;
    if (added) { radiance = vec3<f32>(0.0); }
    radiance = under_oil(radiance, in, n, view, lit, open, cover, film.oil, (coarse.xy - 0.5) * (1.0 - cover) * 0.12 + ran.xy);
    radiance = under_water(radiance, in, n, view, lit, open, film.water, beads);
    radiance = under_foam(radiance, local, lit, open, film.foam);
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
const BLOWN = 20.0;

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

// Depth of oil that has the colour of the bottle [mm] (chosen: a bottle seen through its middle is a few times as deep).
const OIL_DEPTH = 15.0;
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
    let film = normalize(n + vec3<f32>(wave.xy * 0.05 + slope, 0.0));
    // A used pan is smeared: the film is smooth here and dull there.
    let smeared = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(local.xy * 23.0, 0.71), 0.0).a;
    let mirror = liquid_mirror(in, film, mix(0.32, mix(0.06, 0.20, smoothstep(0.35, 0.70, smeared)), cover), view, lit, open) * (1.0 - hidden_by_food(in.position, reflect(-view, film), 0.2 + 0.8 * gradient_noise(in.clip.xy + frame.origin.xy)));
    // Light passes the film twice; a deep pool also sends some back itself.
    let passed = pow(frame.oil.rgb, vec3<f32>(2.0 * thickness / OIL_DEPTH));
    let deep = 1.0 - exp(-thickness * mix(1.0 / OIL_DEPTH, TURBID, frame.white.w));
    let glow = frame.oil.rgb * vec3<f32>(0.34, 0.28, 0.16) * deep * (0.35 + 0.65 * lit) * open;
    return mix(below, below * passed + glow + mirror, cover);
}

// Juice and water: puddles with a round edge, a little cloudy, trembling while they boil.
fn under_water(below: vec3<f32>, in: SolidOut, n: vec3<f32>, view: vec3<f32>, lit: f32, open: f32, thickness: f32, beads: f32) -> vec3<f32> {
    let depth = thickness + 0.35 * beads * smoothstep(0.0, 0.05, thickness);
    let cover = smoothstep(0.06, 0.22, depth);
    if (cover <= 0.0) { return below; }
    let local = in_pan(in.position);
    let at = vec3<f32>(local.xy * 34.0, frame.eye.w * 0.9);
    let tremble = textureSampleLevel(solid_noise, tile_sampler, at, 0.0).rgb - 0.5;
    let surface = normalize(n + vec3<f32>(tremble.xy * (0.25 + 0.6 * (1.0 - cover)), 0.0));
    let juice = vec3<f32>(0.105, 0.070, 0.040) * (0.4 + 0.6 * lit) * open;
    let cloudy = 1.0 - exp(-0.9 * max(depth, 0.0));
    return mix(below, mix(below, juice, 0.75 * cloudy) + liquid_mirror(in, surface, 0.08, view, lit, open), cover);
}

// Foam of butter: fine white bubbles in patches that drift, single bubbles where a patch ends.
fn under_foam(below: vec3<f32>, local: vec3<f32>, lit: f32, open: f32, foam: f32) -> vec3<f32> {
    if (foam <= 0.02) { return below; }
    let drift = vec2<f32>(sin(frame.eye.w * 0.7), cos(frame.eye.w * 0.5)) * 0.004;
    let patchy = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(local.xy * 7.0 + drift * 3.0, frame.eye.w * 0.05), 0.0).a;
    let large = textureSampleLevel(bundle_picture, tile_sampler, local.xy * 26.0 + drift, 0.0);
    let small = textureSampleLevel(bundle_picture, tile_sampler, local.yx * 67.0 - drift, 0.0);
    let dense = clamp((1.5 * foam - 1.0 + patchy) * 1.6, 0.0, 1.0);
    // A bubble is there or not; it is brightest at its rim and on its crown.
    let big = smoothstep(0.0, 0.12, 1.15 * dense - large.g - 0.10) * smoothstep(0.02, 0.12, large.r);
    let fine = smoothstep(0.0, 0.20, 1.5 * dense - small.g - 0.20) * smoothstep(0.0, 0.20, small.r);
    let crown = smoothstep(0.10, 0.60, select(small.r, large.r, big > fine));
    let cover = max(fine * 0.85, big * mix(0.75, 0.40, crown));
    let colour = mix(frame.oil.rgb, vec3<f32>(1.0, 0.96, 0.84), 0.80) * (0.70 + 0.24 * crown);
    let light = frame.key_light.rgb * (0.25 + 0.75 * lit) * 0.42 + frame.other_light.rgb * 0.5 + frame.fill_sky.rgb;
    return mix(below, colour * light * open, cover);
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
