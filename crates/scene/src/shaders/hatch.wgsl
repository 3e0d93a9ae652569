// Ink over the colours of classes, on the grid of the picture: the same patterns as `hatch.rs` draws in the panels.

const HATCH_PERIOD = 8.0;
const HATCH_LINE = 1.3;
const HATCH_DOT = 1.5;
const HATCH_INK = 0.42;

fn hatch_line(along: f32, spacing: f32) -> f32 {
    let away = abs(along / spacing - round(along / spacing)) * spacing;
    return clamp(0.5 + 0.5 * HATCH_LINE - away, 0.0, 1.0);
}

// A field's colour with its class's pattern; the table's alpha numbers the patterns, 0 is none.
fn hatched_colour(coordinate: f32, pixel: vec2<f32>) -> vec3<f32> {
    let u = (clamp(coordinate, 0.0, 1.0) * 255.0 + 0.5) / 256.0;
    let entry = textureSampleLevel(colour_table, table_sampler, vec2<f32>(u, 0.5), 0.0);
    let pattern = u32(round(entry.a * 255.0));
    let slant = HATCH_PERIOD * 0.70710678;
    let rising = hatch_line((pixel.x + pixel.y) * 0.70710678, slant);
    let falling = hatch_line((pixel.x - pixel.y) * 0.70710678, slant);
    var ink = 0.0;
    if (pattern == 1u) {
        let row = round(pixel.y / (0.75 * HATCH_PERIOD));
        let x = pixel.x / HATCH_PERIOD - select(0.0, 0.5, fract(0.5 * row) > 0.25);
        let away = vec2<f32>((x - round(x)) * HATCH_PERIOD, pixel.y - row * 0.75 * HATCH_PERIOD);
        ink = clamp(0.5 + HATCH_DOT - length(away), 0.0, 1.0);
    } else if (pattern == 2u) {
        ink = hatch_line(pixel.y, 0.625 * HATCH_PERIOD);
    } else if (pattern == 3u) {
        ink = rising;
    } else if (pattern == 4u) {
        ink = max(rising, falling);
    }
    return entry.rgb * (1.0 - HATCH_INK * ink);
}
