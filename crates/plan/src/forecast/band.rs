//! Error band of forecasts.

/// Times ahead for which the band is stated [s].
pub const SPANS_S: [f64; 3] = [60.0, 120.0, 300.0];
