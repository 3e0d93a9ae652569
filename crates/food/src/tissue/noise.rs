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
    between(p, cell, &corners(seed, cell))
}

/// Values at the corners of a cell of the lattice, x fastest [-].
fn corners(seed: u64, cell: [f64; 3]) -> [f64; 8] {
    let corner = |k: usize| {
        let at = |axis: usize| (cell[axis] as i64 + (k >> axis & 1) as i64) as u64;
        let [x, y, z] = [at(0), at(1), at(2)];
        2.0 * uniform(seed, x.wrapping_mul(0x8da6_b343) ^ y.wrapping_mul(0xd816_3841) ^ z.wrapping_mul(0xcb1a_b31f))
            - 1.0
    };
    core::array::from_fn(corner)
}

/// Value at a point of a cell [-].
fn between(p: [f64; 3], cell: [f64; 3], corners: &[f64; 8]) -> f64 {
    let f = [p[0] - cell[0], p[1] - cell[1], p[2] - cell[2]].map(|v| v * v * (3.0 - 2.0 * v));
    let lerp = |a: f64, b: f64, t: f64| a + t * (b - a);
    let plane = |at: usize| {
        let near = lerp(corners[at], corners[at + 1], f[0]);
        let far = lerp(corners[at + 2], corners[at + 3], f[0]);
        lerp(near, far, f[1])
    };
    lerp(plane(0), plane(4), f[2])
}

/// [`smooth`] of one seed at many points: it keeps the corners of the last cell, so that a row of near points costs little.
#[derive(Clone, Debug)]
pub struct Smooth {
    seed: u64,
    cell: [f64; 3],
    corners: [f64; 8],
}

impl Smooth {
    /// The noise of a seed.
    pub fn new(seed: u64) -> Self {
        Self { seed, cell: [f64::NAN; 3], corners: [0.0; 8] }
    }

    /// The value of [`smooth`] [-].
    pub fn at(&mut self, p: [f64; 3]) -> f64 {
        let cell = p.map(libm::floor);
        if cell != self.cell {
            (self.cell, self.corners) = (cell, corners(self.seed, cell));
        }
        between(p, cell, &self.corners)
    }
}

/// [`fractal`] of one seed at many points.
#[derive(Clone, Debug)]
pub struct Fractal([Smooth; 2]);

impl Fractal {
    /// The noise of a seed.
    pub fn new(seed: u64) -> Self {
        Self([Smooth::new(seed), Smooth::new(seed ^ FINER)])
    }

    /// The value of [`fractal`] [-].
    pub fn at(&mut self, p: [f64; 3]) -> f64 {
        let [coarse, fine] = &mut self.0;
        octaves(coarse.at(p), fine.at(finer(p)))
    }
}

/// What the seed of the finer octave differs by.
const FINER: u64 = 0x5bd1;

/// A point of the finer octave.
fn finer(p: [f64; 3]) -> [f64; 3] {
    p.map(|v| 2.0 * v + 17.3)
}

/// Sum of two octaves [-].
fn octaves(coarse: f64, fine: f64) -> f64 {
    (coarse + 0.5 * fine) / 1.25
}

/// Two octaves of [`smooth`], from −1.2 to 1.2 [-].
pub fn fractal(seed: u64, p: [f64; 3]) -> f64 {
    octaves(smooth(seed, p), smooth(seed ^ FINER, finer(p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_that_keeps_its_cell_has_the_same_bits() {
        let mut kept = Fractal::new(7);
        for i in 0..4000 {
            let p = [f64::from(i) * 0.013 - 20.0, f64::from(i % 7) * 0.3, f64::from(i / 50) * 0.21];
            assert_eq!(kept.at(p).to_bits(), fractal(7, p).to_bits());
        }
    }

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
