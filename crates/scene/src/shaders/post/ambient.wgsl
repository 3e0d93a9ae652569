// Share of the room's light that arrives, from the depth: horizons in a few slices round the eye's ray, integrated over the
// cosine lobe (Jimenez et al. 2016 `[@jimenez-2016]`: ground-truth ambient occlusion). Half size.

// How far occluders reach [m] (chosen: the height of a pan's wall and of a thick steak).
const REACH = 0.035;
const SLICES = 3;
const STEPS = 6;
// Wider than this on the picture nothing is searched [pixels] (chosen: the time of a still).
const WIDEST = 96.0;

// View space: x to the right, y up, z towards the eye [m].
fn place_at(pixel: vec2<i32>) -> vec3<f32> {
    let away = distance_at(pixel);
    let ndc = (vec2<f32>(pixel) + 0.5) / lens.part.xy * vec2<f32>(2.0, -2.0) + vec2<f32>(-1.0, 1.0);
    return vec3<f32>((ndc - lens.projection.zw) / lens.projection.xy * away, -away);
}

// The difference to the neighbour that is nearer in depth.
fn along(at: vec2<i32>, here: vec3<f32>, step: vec2<i32>) -> vec3<f32> {
    let ahead = place_at(at + step) - here;
    let back = here - place_at(at - step);
    return select(back, ahead, abs(ahead.z) < abs(back.z));
}

// Cosine of the horizon on one side; occluders fade with their distance.
fn horizon(at: vec2<f32>, here: vec3<f32>, view: vec3<f32>, direction: vec2<f32>, reach: f32, jitter: f32, lowest: f32) -> f32 {
    var cosine = lowest;
    for (var k = 0; k < STEPS; k++) {
        let share = (f32(k) + jitter) / f32(STEPS);
        let offset = direction * max(share * share * reach, f32(k) + 1.0);
        let towards = place_at(vec2<i32>(at + offset)) - here;
        let length = max(length(towards), 1e-6);
        let fading = clamp(1.0 - length / REACH, 0.0, 1.0);
        cosine = max(cosine, mix(lowest, dot(towards, view) / length, min(2.0 * fading, 1.0)));
    }
    return cosine;
}

fn arc(h: f32, n: f32) -> f32 {
    return 0.25 * (-cos(2.0 * h - n) + cos(n) + 2.0 * h * sin(n));
}

@fragment
fn fs_ambient(in: Covered) -> @location(0) vec4<f32> {
    let at = vec2<i32>(in.clip.xy) * 2;
    let here = place_at(at);
    let view = normalize(-here);
    let normal = normalize(cross(along(at, here, vec2<i32>(1, 0)), along(at, here, vec2<i32>(0, -1))));
    let reach = min(REACH * lens.projection.y * 0.5 * lens.part.y / -here.z, WIDEST);
    let noise = noise_at(in.clip.xy);
    var open = 0.0;
    for (var k = 0; k < SLICES; k++) {
        let angle = 3.14159265 * (f32(k) + noise) / f32(SLICES);
        let direction = vec2<f32>(cos(angle), -sin(angle));
        let across = vec3<f32>(direction.x, -direction.y, 0.0);
        let plane = across - view * dot(across, view);
        let axis = normalize(cross(plane, view));
        let projected = normal - axis * dot(normal, axis);
        let weight = length(projected);
        let n = sign(dot(plane, projected)) * acos(clamp(dot(projected, view) / max(weight, 1e-4), -1.0, 1.0));
        let jitter = fract(noise * 7.31 + 0.37 * f32(k));
        let behind = horizon(vec2<f32>(at), here, view, -direction, reach, jitter, cos(n - 1.5707963));
        let ahead = horizon(vec2<f32>(at), here, view, direction, reach, jitter, cos(n + 1.5707963));
        let h0 = n + max(-acos(clamp(behind, -1.0, 1.0)) - n, -1.5707963);
        let h1 = n + min(acos(clamp(ahead, -1.0, 1.0)) - n, 1.5707963);
        open += weight * (arc(h0, n) + arc(h1, n));
    }
    return vec4<f32>(clamp(open / f32(SLICES), 0.0, 1.0), 0.0, 0.0, 1.0);
}

// Evens out the noise over five by five texels of nearly the same depth.
@fragment
fn fs_even(in: Covered) -> @location(0) vec4<f32> {
    let at = vec2<i32>(in.clip.xy);
    let last = vec2<i32>(textureDimensions(first)) - 1;
    let here = distance_at(at * 2);
    var sum = vec2<f32>(0.0);
    for (var j = -2; j <= 2; j++) {
        for (var i = -2; i <= 2; i++) {
            let place = clamp(at + vec2<i32>(i, j), vec2<i32>(0), last);
            let apart = abs(distance_at(place * 2) - here) / here;
            let weight = exp(-apart * 120.0) * (1.0 - 0.12 * f32(i * i + j * j) / 2.0);
            sum += vec2<f32>(textureLoad(first, place, 0).r, 1.0) * max(weight, 1e-3);
        }
    }
    return vec4<f32>(sum.x / sum.y, 0.0, 0.0, 1.0);
}
