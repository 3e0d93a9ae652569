//! Random numbers as a function of a seed and of what they are for: no state, the same on every machine.

/// Returns a number with the bits of another one mixed: the finaliser of SplitMix64 `[@steele-2014]`.
pub fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Returns random bits for a seed and the numbers that state their purpose.
pub fn bits(seed: u64, purpose: &[u64]) -> u64 {
    purpose.iter().fold(mixed(seed), |hash, part| mixed(hash ^ *part))
}

/// Returns a random number of 0 to 1, less than 1 [-].
pub fn unit(seed: u64, purpose: &[u64]) -> f64 {
    // 53 bits are the mantissa of a double.
    (bits(seed, purpose) >> 11) as f64 / (1_u64 << 53) as f64
}

/// Returns a random whole number below `end`, which is at least 1.
pub fn below(end: u64, seed: u64, purpose: &[u64]) -> u64 {
    ((u128::from(bits(seed, purpose)) * u128::from(end)) >> 64) as u64
}
