//! The highest core to expect of a piece.

/// Forecast for food that is taken out now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forecast {
    /// Expected core peak [°C].
    pub peak_c: f64,
    /// In how many seconds.
    pub in_s: f64,
}
