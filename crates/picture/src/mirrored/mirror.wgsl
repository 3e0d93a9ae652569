// The last pass: for every pixel of the device the place of the eye's picture that it shows.

struct Warp {
    // Columns of the keystone's inverse: from shares of the device's sides to shares of the picture's.
    column_x: vec4<f32>,
    column_y: vec4<f32>,
    column_z: vec4<f32>,
    // Centre of the lens in shares of the device's sides; k1, k2.
    lens: vec4<f32>,
    // Width and height of the device over the lens's unit of length; 0 one picture, 1 anaglyph, 2 side by side.
    scale: vec4<f32>,
    // Rows of the anaglyph's matrices: red of the left, green and blue of the right eye's colours.
    red: vec4<f32>,
    green: vec4<f32>,
    blue: vec4<f32>,
};

@group(0) @binding(0) var<uniform> warp: Warp;
@group(0) @binding(1) var left_picture: texture_2d<f32>;
@group(0) @binding(2) var right_picture: texture_2d<f32>;
@group(0) @binding(3) var picture_sampler: sampler;

// Newton's rule on the distance from the lens's centre, as in lens.rs.
fn undistorted(share: vec2<f32>) -> vec2<f32> {
    let moved = (share - warp.lens.xy) * warp.scale.xy;
    let distance = length(moved);
    if (distance < 1e-6) { return share; }
    var r = distance;
    for (var step = 0; step < 6; step++) {
        let r2 = r * r;
        let slope = 1.0 + r2 * (3.0 * warp.lens.z + 5.0 * warp.lens.w * r2);
        r -= (r * (1.0 + r2 * (warp.lens.z + r2 * warp.lens.w)) - distance) / max(slope, 0.1);
    }
    return warp.lens.xy + moved * (r / distance) / warp.scale.xy;
}

fn place(share: vec2<f32>) -> vec2<f32> {
    let ideal = undistorted(share);
    let at = warp.column_x.xyz * ideal.x + warp.column_y.xyz * ideal.y + warp.column_z.xyz;
    return at.xy / at.z;
}

// Nothing is shown beyond the picture.
fn within(at: vec2<f32>) -> f32 {
    return step(0.0, min(min(at.x, at.y), min(1.0 - at.x, 1.0 - at.y)));
}

fn srgb_from_linear(linear: vec3<f32>) -> vec3<f32> {
    let c = clamp(linear, vec3<f32>(0.0), vec3<f32>(1.0));
    return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c < vec3<f32>(0.0031308));
}

fn shown(share: vec2<f32>) -> vec3<f32> {
    let halves = warp.scale.z > 1.5;
    let right_half = halves && share.x >= 0.5;
    let whole = vec2<f32>(select(share.x, fract(2.0 * share.x), halves), share.y);
    let at = place(whole);
    let left = textureSampleLevel(left_picture, picture_sampler, at, 0.0).rgb * within(at);
    let right = textureSampleLevel(right_picture, picture_sampler, at, 0.0).rgb * within(at);
    if (warp.scale.z > 0.5 && !halves) {
        let seen = linear_from_srgb(right);
        let red = dot(warp.red.rgb, linear_from_srgb(left));
        return srgb_from_linear(vec3<f32>(red, dot(warp.green.rgb, seen), dot(warp.blue.rgb, seen)));
    }
    return select(left, right, right_half);
}

// The picture holds sRGB-encoded values; a target that stores them as they are takes them as they are.
@fragment
fn fs_mirror_encoded(in: Covered) -> @location(0) vec4<f32> {
    return vec4<f32>(shown(in.uv), 1.0);
}

// An sRGB target encodes what it is given, so the values are decoded first.
@fragment
fn fs_mirror_linear(in: Covered) -> @location(0) vec4<f32> {
    return vec4<f32>(linear_from_srgb(shown(in.uv)), 1.0);
}
