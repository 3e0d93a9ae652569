//! Carries out what is done about the kitchen at home.

/// Scale in whose classes what was seen on the cut is stated.
pub const SCALE: &str = "chefs";
