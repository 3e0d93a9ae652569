//! What lies outside a face.

/// Heat flow into a face as a straight line in the face's temperature, or the temperature itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Boundary {
    /// Flux into the body = `source` − `h` · T [W/m²].
    Exchange {
        /// Heat transfer coefficient [W/(m²·K)].
        h: f64,
        /// h times the temperature outside, and any flux of its own [W/m²].
        source: f64,
    },
    /// A given surface temperature [K].
    Fixed(f64),
}

impl Boundary {
    /// Convection [W/(m²·K)] towards a temperature [K].
    pub fn convective(h: f64, outside: f64) -> Self {
        Self::Exchange { h, source: h * outside }
    }
}
