//! Tiling textures generated once: solid gradient noise, and the bundles that muscle fibres form.

use glam::{IVec3, Vec2, Vec3};

/// Lattice cells along each side of the solid noise.
const NOISE_CELLS: i32 = 8;
/// Bundles along each side of the bundle texture.
const BUNDLE_CELLS: i32 = 16;
/// Texels a cell in the coarsest of the textures, of which the first texel's middle is the pattern's origin: finer ones
/// are on the same places.
const NOISE_ORIGIN: f32 = 4.0;
const BUNDLE_ORIGIN: f32 = 16.0;

/// Where the middle of a texel is in the pattern [cells].
fn place(index: u32, size: u32, cells: i32, origin: f32) -> f32 {
    (index as f32 + 0.5) * cells as f32 / size as f32 - 0.5 / origin
}

/// Tiling gradient noise, RGBA8: direction of the slope (128 = none) and value (mean 128); x fastest.
pub(crate) fn solid_noise(size: u32) -> Vec<u8> {
    let mut texels = Vec::with_capacity((size.pow(3) * 4) as usize);
    for index in 0..size.pow(3) {
        let at = [index, index / size, index / size.pow(2)];
        let (value, slope) = gradient_noise(Vec3::from(at.map(|i| place(i % size, size, NOISE_CELLS, NOISE_ORIGIN))));
        texels.extend([slope.x * 0.5, slope.y * 0.5, slope.z * 0.5, value].map(signed_byte));
    }
    texels
}

/// Halves a tiling RGBA8 volume.
pub(crate) fn halve_volume(texels: &[u8], size: u32) -> Vec<u8> {
    let half = size / 2;
    let mut out = Vec::with_capacity(texels.len() / 8);
    for index in 0..half.pow(3) {
        let corner = [index % half, index / half % half, index / half.pow(2)].map(|i| i * 2);
        for channel in 0..4 {
            let sum: u32 = (0..8)
                .map(|k| {
                    let [x, y, z] = [corner[0] + (k & 1), corner[1] + (k >> 1 & 1), corner[2] + (k >> 2)];
                    u32::from(texels[(((z * size + y) * size + x) * 4 + channel) as usize])
                })
                .sum();
            out.push((sum / 8) as u8);
        }
    }
    out
}

/// Bundles of fibres in cross-section, RG8: distance from the seam between bundles, and a random value a bundle.
pub(crate) fn bundles(size: u32) -> Vec<u8> {
    let mut texels = Vec::with_capacity((size.pow(2) * 2) as usize);
    for index in 0..size.pow(2) {
        let at = [index % size, index / size].map(|i| place(i, size, BUNDLE_CELLS, BUNDLE_ORIGIN));
        let (seam, id) = nearest_bundle(Vec2::from(at));
        texels.extend([(seam.min(1.0) * 255.0) as u8, id]);
    }
    texels
}

/// Halves a tiling RG8 picture.
pub(crate) fn halve_picture(texels: &[u8], size: u32) -> Vec<u8> {
    let half = size / 2;
    let at = |x: u32, y: u32, channel: u32| u32::from(texels[((y * size + x) * 2 + channel) as usize]);
    let mut out = Vec::with_capacity(texels.len() / 4);
    for index in 0..half.pow(2) {
        let (x, y) = (index % half * 2, index / half * 2);
        for channel in 0..2 {
            let sum = at(x, y, channel) + at(x + 1, y, channel) + at(x, y + 1, channel) + at(x + 1, y + 1, channel);
            out.push((sum / 4) as u8);
        }
    }
    out
}

fn signed_byte(value: f32) -> u8 {
    (value.clamp(-1.0, 1.0) * 127.0 + 128.0) as u8
}

fn hash(x: i32, y: i32, z: i32) -> u32 {
    let mut h = (x as u32).wrapping_mul(0x8da6_b343)
        ^ (y as u32).wrapping_mul(0xd816_3841)
        ^ (z as u32).wrapping_mul(0xcb1a_b31f);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    h ^ (h >> 15)
}

/// Value and analytic slope (per lattice cell) of gradient noise, stretched to fill about ±1.
pub(crate) fn gradient_noise(at: Vec3) -> (f32, Vec3) {
    let floor = at.floor();
    let (base, f) = (floor.as_ivec3(), at - floor);
    let fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let fade_slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let (mut value, mut slope) = (0.0, Vec3::ZERO);
    for corner in 0..8 {
        let offset = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
        let cell = (base + offset).rem_euclid(IVec3::splat(NOISE_CELLS));
        let gradient = lattice_gradient(hash(cell.x, cell.y, cell.z));
        let height = gradient.dot(f - offset.as_vec3());
        let pick = |axis: usize| {
            if offset[axis] == 1 { fade[axis] } else { 1.0 - fade[axis] }
        };
        let sign = |axis: usize| {
            if offset[axis] == 1 { fade_slope[axis] } else { -fade_slope[axis] }
        };
        let (wx, wy, wz) = (pick(0), pick(1), pick(2));
        value += wx * wy * wz * height;
        slope += wx * wy * wz * gradient + height * Vec3::new(sign(0) * wy * wz, wx * sign(1) * wz, wx * wy * sign(2));
    }
    (value * 1.5, slope)
}

fn lattice_gradient(bits: u32) -> Vec3 {
    let part = |shift: u32| (bits >> shift & 1023) as f32 / 511.5 - 1.0;
    Vec3::new(part(0), part(10), part(20)).normalize_or(Vec3::X)
}

/// Distance to the nearest seam of a tiling Voronoi pattern (in cells, doubled) and a random byte of the cell.
fn nearest_bundle(at: Vec2) -> (f32, u8) {
    let base = at.floor().as_ivec2();
    let (mut first, mut second, mut id) = (f32::MAX, f32::MAX, 0);
    for dy in -1..=1 {
        for dx in -1..=1 {
            let (x, y) = (base.x + dx, base.y + dy);
            let bits = hash(x.rem_euclid(BUNDLE_CELLS), y.rem_euclid(BUNDLE_CELLS), 7);
            let jitter = Vec2::new((bits & 255) as f32, (bits >> 8 & 255) as f32) / 255.0;
            let distance = at.distance(Vec2::new(x as f32, y as f32) + 0.1 + 0.8 * jitter);
            if distance < first {
                (second, first, id) = (first, distance, (bits >> 16 & 255) as u8);
            } else {
                second = second.min(distance);
            }
        }
    }
    ((second - first) * 1.6, id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finer_patterns_lie_where_the_coarse_ones_do() {
        let (coarse, fine) = (solid_noise(32), solid_noise(64));
        let halved = halve_volume(&fine, 64);
        let off = coarse.iter().zip(&halved).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>() as f64;
        assert!(off / (coarse.len() as f64) < 3.0, "noise: {}", off / coarse.len() as f64);
        let (coarse, fine) = (bundles(256), halve_picture(&halve_picture(&bundles(1024), 1024), 512));
        let off = coarse.iter().zip(&fine).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>() as f64;
        assert!(off / (coarse.len() as f64) < 3.0, "bundles: {}", off / coarse.len() as f64);
    }
}
