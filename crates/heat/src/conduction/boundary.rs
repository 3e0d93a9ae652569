//! Boundary conditions of a face.

/// The boundary condition of a face: Robin and Neumann as a flux [W/m²], or Dirichlet as a temperature [K].
///
/// ```
/// use saute_heat::Boundary;
/// // Oven air of 473 K with 20 W/(m²·K), on a face of 300 K.
/// let Boundary::Exchange { h, source } = Boundary::convective(20.0, 473.0) else { unreachable!() };
/// let flux_w_m2 = source - h * 300.0;
/// assert_eq!(flux_w_m2, 3460.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Boundary {
    /// Robin boundary: flux into the body q = `source` − `h` · T [W/m²]; `h` = 0 is a Neumann boundary.
    Exchange {
        /// Heat transfer coefficient [W/(m²·K)].
        h: f64,
        /// `h` × ambient temperature, plus any prescribed flux [W/m²].
        source: f64,
    },
    /// Dirichlet boundary: prescribed surface temperature [K].
    Fixed(f64),
}

impl Boundary {
    /// Returns the Robin boundary of convection with coefficient `h` [W/(m²·K)] to an ambient temperature [K].
    pub fn convective(h: f64, ambient: f64) -> Self {
        Self::Exchange { h, source: h * ambient }
    }
}
