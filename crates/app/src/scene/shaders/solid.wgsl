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
    let kind = in.surface.z;
    var coarse = 0.5;
    if (!quick) { coarse = textureSampleLevel(solid_noise, tile_sampler, in.position * select(15.0, 5.3, kind > 5.5), 0.0).a; }
    // Stone has faint flecks, cloth a weave.
    let stone = 0.93 + 0.14 * coarse;
    let weave = 0.92 + 0.05 * sin(in.position.x * 2600.0) * sin(in.position.y * 2600.0) + 0.12 * (coarse - 0.5);
    s.albedo *= select(1.0, select(weave, stone, kind > 5.5), kind > 4.5);
    s.visibility *= pan_foot(in.position);
    let lit = shadow(in.position, n);
    let radiance = diffuse(s, lit) + specular(s, in.position, view, lit);
    return pixel_from_radiance(radiance, in.clip.xy);
}

// Planed wood: long grain along the board, worn paler in places.
@fragment
fn fs_wood(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let along = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(26.0, 1.9, 22.0), 0.0).a;
    var pores = 0.5;
    var worn = 0.5;
    if (!quick) {
        pores = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(120.0, 6.0, 90.0), 0.0).a;
        worn = textureSampleLevel(solid_noise, tile_sampler, in.position * vec3<f32>(4.0, 3.0, 4.0), 0.0).a;
    }
    let rings = sin((along * 5.0 + in.position.x * 55.0) * 3.0) * 0.5 + 0.5;
    let tone = 0.82 + 0.14 * rings + 0.22 * (pores - 0.5);
    s.albedo *= tone * mix(vec3<f32>(0.96, 0.95, 0.94), vec3<f32>(1.10, 1.11, 1.13), smoothstep(0.4, 0.7, worn));
    s.roughness += 0.2 * (pores - 0.5);
    let lit = shadow(in.position, n);
    s.visibility *= openness(in.position);
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

@fragment
fn fs_glass(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    let n = facing(in.normal, view);
    var s = plain_surface(in, n);
    let lit = shadow(in.position, n);
    s.visibility *= pan_foot(in.position);
    var radiance = diffuse(s, lit) + specular(s, in.position, view, lit) * mix(0.2, 0.7, s.visibility);
    radiance += printed_ring(in.position) * s.visibility;
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
    return smoothstep(top - 0.012, top + 0.012, height);
}

// How much oil covers a place of the floor: droplets and streaks at first, a pool at last.
fn oil_cover(local: vec3<f32>, noise: f32) -> f32 {
    let oil = frame.pan_shape.w;
    let edge = length(local.xy) / frame.pan_shape.x;
    let level = oil * 2.4 - 0.9 * edge * edge * (1.0 - oil) + (noise - 0.5) * 1.5 * (1.0 - oil) - 0.10;
    return smoothstep(0.0, 0.55, level) * smoothstep(0.0, 0.02, oil);
}

@fragment
fn fs_metal(in: SolidOut) -> @location(0) vec4<f32> {
    let view = normalize(frame.eye.xyz - in.position);
    var n = facing(in.normal, view);
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
    var s = plain_surface(in, n);
    // Seasoning is patchy; turning marks are circular.
    let patchy = coarse.a - 0.5;
    s.f0 *= 1.0 + 0.35 * patchy + 0.16 * (fine - 0.5);
    // The patina over the metal scatters a little.
    s.albedo = in.colour * (1.0 - 0.84 * in.surface.y) * (1.0 + 0.35 * patchy);
    s.roughness = clamp(s.roughness + 0.14 * patchy + 0.10 * (fine - 0.5), 0.05, 1.0);
    let inside = step(radius, frame.pan_shape.y - 0.001) * step(frame.pan_place.w - 0.001, local.z);
    let lit = shadow(in.position, n);
    let open = openness(in.position);
    let depth = clamp((frame.pan_place.w + frame.pan_shape.z - local.z) / frame.pan_shape.z, 0.0, 1.0);
    let corner = smoothstep(0.035, 0.0, abs(radius - frame.pan_shape.x)) * depth;
    s.visibility *= open * (1.0 - inside * (0.22 * depth + 0.25 * corner));
    let towards = reflect(-view, n);
    let leaves = mix(1.0, mix(0.30, 1.0, escapes_pan(local, (frame.pan_from_world * vec4<f32>(towards, 0.0)).xyz)), inside);
    // Under oil the metal's own highlight fades: the film takes its place.
    let cover = select(0.0, oil_cover(local, coarse.a), is_floor);
    var radiance = diffuse(s, lit) + specular(s, in.position, view, lit) * leaves * (0.62 - 0.38 * cover);
    if (is_floor) {
        radiance = under_oil(radiance, in, n, view, lit, open, cover, coarse.rgb);
    }
    return pixel_from_radiance(radiance, in.clip.xy);
}

// A clear film: golden where light passes it, mirror-smooth on top, with slow waves.
fn under_oil(below: vec3<f32>, in: SolidOut, n: vec3<f32>, view: vec3<f32>, lit: f32, open: f32, cover: f32, slope: vec3<f32>) -> vec3<f32> {
    let local = in_pan(in.position);
    let wave = textureSampleLevel(solid_noise, tile_sampler, vec3<f32>(local.xy * 9.0, frame.eye.w * 0.05), 0.0).rgb - 0.5;
    let rim = (slope.xy - 0.5) * (1.0 - cover) * 0.12;
    let film = normalize(n + vec3<f32>(wave.xy * 0.05 + rim, 0.0));
    let s = Surface(vec3<f32>(0.0), vec3<f32>(0.036), mix(0.30, 0.06, cover), film, open, vec3<f32>(0.0));
    let towards = reflect(-view, film);
    let leaves = mix(0.15, 1.0, escapes_pan(local, (frame.pan_from_world * vec4<f32>(towards, 0.0)).xyz));
    let mirror = specular(s, in.position, view, lit) * leaves * 0.7;
    return mix(below, below * vec3<f32>(0.80, 0.73, 0.55) + mirror, cover);
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
