// Light that travels in flesh before it leaves: a blur along rows, then along columns, wider for red, only within food
// (separable subsurface scattering in screen space, Jimenez et al. 2015 `[@jimenez-2015]`).

// How far light of each colour travels [m] (chosen: soft edges of fat in raw meat, half a millimetre wide).
const TRAVELS = vec3<f32>(0.00060, 0.00028, 0.00018);
// Brighter than this it is a reflection from the surface, which stays sharp (chosen: white flesh in full light).
const REFLECTED = 0.55;
// Depth over which light does not cross from one thing to another [m] (chosen).
const APART = 0.003;
const SIDE = 7;

// Share of the light that scatters under the surface at a pixel.
fn scattering(alpha: f32) -> f32 {
    return clamp(2.0 * (1.0 - alpha), 0.0, 1.0);
}

fn scattered(at: vec2<i32>, direction: vec2<f32>) -> vec4<f32> {
    let own = textureLoad(first, at, 0);
    let share = scattering(own.a);
    let away = distance_at(at);
    let width = TRAVELS * share * lens.projection.y * 0.5 * lens.part.y / away;
    if (width.r < 0.6) { return own; }
    // Between two texels a reading takes both, so that none is left out.
    let spacing = clamp(0.36 * width.r, 1.0, 2.0);
    let size = vec2<f32>(textureDimensions(first));
    var sum = vec3<f32>(0.0);
    var weights = vec3<f32>(0.0);
    for (var k = -SIDE; k <= SIDE; k++) {
        let offset = f32(k) * spacing - 0.5 * f32(sign(k)) * (spacing - 1.0);
        let place = vec2<f32>(at) + 0.5 + direction * offset;
        let there = textureSampleLevel(first, linear_sampler, place / size, 0.0);
        let beside = exp(-abs(distance_at(vec2<i32>(place)) - away) / APART) * scattering(there.a);
        let weight = exp(-0.5 * offset * offset / (width * width)) * max(beside, select(0.0, 1.0, k == 0));
        sum += weight * min(radiance_from_target(there.rgb), vec3<f32>(REFLECTED));
        weights += weight;
    }
    let sharp = max(radiance_from_target(own.rgb) - REFLECTED, vec3<f32>(0.0));
    return vec4<f32>(target_from_radiance(sum / weights + sharp), own.a);
}

@fragment
fn fs_along_rows(in: Covered) -> @location(0) vec4<f32> {
    return scattered(vec2<i32>(in.clip.xy), vec2<f32>(1.0, 0.0));
}

@fragment
fn fs_along_columns(in: Covered) -> @location(0) vec4<f32> {
    return scattered(vec2<i32>(in.clip.xy), vec2<f32>(0.0, 1.0));
}
