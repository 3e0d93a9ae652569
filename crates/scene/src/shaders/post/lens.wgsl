// Data for every pass over a finished picture: where it is in the whole one, how far a depth is, and what is sharp.

struct Lens {
    // This picture [pixels]: width, height, and its left and upper edge in the whole picture.
    part: vec4<f32>,
    // The whole picture [pixels]: width, height; share of bloom; how much the corners are darkened.
    whole: vec4<f32>,
    // Normalised device coordinates of this picture over view x / distance: scale x, y, then shift x, y.
    projection: vec4<f32>,
    // Nearest and farthest distance of the depth; distance up to which all is sharp [m]; width of the aperture [m].
    depth: vec4<f32>,
};

@group(0) @binding(0) var<uniform> lens: Lens;
// Distance along the axis of the eye at a depth [m].
fn distance_of(depth: f32) -> f32 {
    return lens.depth.x * lens.depth.y / (lens.depth.y - depth * (lens.depth.y - lens.depth.x));
}

// Interleaved gradient noise of a pixel of the whole picture, 0 to 1 (Jimenez 2014 `[@jimenez-2014]`).
fn noise_at(pixel: vec2<f32>) -> f32 {
    return fract(52.9829189 * fract(dot(pixel + lens.part.zw, vec2<f32>(0.06711056, 0.00583715))));
}

// Diameter of the circle of confusion [pixels]; 0 up to the far end of what is sharp.
fn confusion(distance: f32) -> f32 {
    let far = max(1.0 / lens.depth.z - 1.0 / max(distance, lens.depth.z), 0.0);
    return lens.depth.w * far * lens.projection.y * 0.5 * lens.part.y;
}
