//! Seeded value noise for marbling and unevenness; the same on every platform.

/// A 64-bit mix of integers (the finaliser of SplitMix64, Steele et al. 2014 `[@steele-2014]`).
pub fn mix(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Uniform random number in 0…1 at `index` of the stream `seed` [-].
///
/// ```
/// use saute_food::tissue::noise::uniform;
///
/// let value = uniform(7, 3);
/// assert!((0.0..1.0).contains(&value));
/// assert_eq!(value, uniform(7, 3)); // the same seed gives the same number
/// ```
pub fn uniform(seed: u64, index: u64) -> f64 {
    (mix(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(mix(index))) >> 11) as f64 / (1u64 << 53) as f64
}

/// Value noise on a unit lattice, from −1 to 1 and C¹ continuous [-].
pub fn smooth(seed: u64, p: [f64; 3]) -> f64 {
    let cell = p.map(libm::floor);
    let f = [p[0] - cell[0], p[1] - cell[1], p[2] - cell[2]].map(|v| v * v * (3.0 - 2.0 * v));
    let corner = |dx: i64, dy: i64, dz: i64| {
        let [x, y, z] = [cell[0] as i64 + dx, cell[1] as i64 + dy, cell[2] as i64 + dz].map(|v| v as u64);
        2.0 * uniform(seed, x.wrapping_mul(0x8da6_b343) ^ y.wrapping_mul(0xd816_3841) ^ z.wrapping_mul(0xcb1a_b31f))
            - 1.0
    };
    let lerp = |a: f64, b: f64, t: f64| a + t * (b - a);
    let plane = |dz: i64| {
        let near = lerp(corner(0, 0, dz), corner(1, 0, dz), f[0]);
        let far = lerp(corner(0, 1, dz), corner(1, 1, dz), f[0]);
        lerp(near, far, f[1])
    };
    lerp(plane(0), plane(1), f[2])
}

/// Two octaves of [`smooth`], from −1.2 to 1.2 [-].
pub fn fractal(seed: u64, p: [f64; 3]) -> f64 {
    (smooth(seed, p) + 0.5 * smooth(seed ^ 0x5bd1, p.map(|v| 2.0 * v + 17.3))) / 1.25
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_repeatable_bounded_continuous_and_centred() {
        let mut sum = 0.0;
        for i in 0..4000 {
            let p = [f64::from(i) * 0.37, f64::from(i) * 0.11, 3.0];
            let v = smooth(7, p);
            assert!(v.abs() <= 1.0 && v == smooth(7, p));
            assert!((v - smooth(7, [p[0] + 1e-6, p[1], p[2]])).abs() < 1e-4);
            sum += v;
        }
        assert!((sum / 4000.0).abs() < 0.05);
    }
}
