//! Random numbers: one small generator, seeded, the same everywhere.

/// A stream of random numbers (xorshift32, Marsaglia 2003).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random(u32);

/// Half width of an even distribution with variance 1 [-]: √3.
const HALF_WIDTH: f32 = 1.732_050_8;
/// 2⁻³¹ [-].
const PER_HALF_RANGE: f32 = 4.656_613e-10;

impl Random {
    /// Returns the stream of a seed and a number; neighbours are unlike.
    pub(crate) fn new(seed: u64, stream: u64) -> Self {
        // SplitMix64 (Steele 2014) spreads the bits.
        let mut z = seed.wrapping_add((stream + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self(((z ^ (z >> 31)) as u32).max(1))
    }

    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// Evenly distributed between −1 and 1.
    pub(crate) fn even(&mut self) -> f32 {
        (self.next() as i32) as f32 * PER_HALF_RANGE
    }

    /// White noise with mean 0 and variance 1.
    pub(crate) fn white(&mut self) -> f32 {
        HALF_WIDTH * self.even()
    }

    /// Evenly distributed above 0, up to 1.
    pub(crate) fn share(&mut self) -> f32 {
        ((self.next() >> 8) + 1) as f32 / 16_777_216.0
    }

    /// Exponentially distributed with mean 1.
    pub(crate) fn exponential(&mut self) -> f32 {
        -libm::logf(self.share())
    }
}
