//! Properties of water vapour.

use libm::{exp, pow, sqrt};

use crate::ZERO_C;

/// Standard atmosphere [Pa] (CGPM 1954).
pub const ATMOSPHERE: f64 = 101_325.0;
/// Specific gas constant of water vapour, 8.31446 / 0.0180153 [J/(kg·K)].
pub const VAPOUR_GAS_CONSTANT: f64 = 461.52;

const CRITICAL_TEMPERATURE: f64 = 647.096;
const CRITICAL_PRESSURE: f64 = 22.064e6;

/// Saturation vapour pressure of water at `temperature` [K] [Pa].
///
/// ```
/// use saute_food::ZERO_C;
/// use saute_food::water::saturation_pressure;
///
/// // Water boils under one atmosphere at 100 °C: 101.4 kPa.
/// assert!((saturation_pressure(ZERO_C + 100.0) - 101_418.0).abs() < 50.0);
/// ```
///
/// ln(p/p_c) = T_c/T · Σ aᵢ τ^bᵢ with τ = 1 − T/T_c; 273–647 K, error below 0.1 %.
/// Source: Wagner & Pruß 2002 `[@wagner-pruss-2002]`, J. Phys. Chem. Ref. Data 31:387, eq. 2.5.
pub fn saturation_pressure(temperature: f64) -> f64 {
    let t = temperature.clamp(230.0, 640.0);
    let tau = 1.0 - t / CRITICAL_TEMPERATURE;
    let sum = -7.859_517_83 * tau + 1.844_082_59 * tau * sqrt(tau) - 11.786_649_7 * tau * tau * tau
        + 22.680_741_1 * pow(tau, 3.5)
        - 15.961_871_9 * tau * tau * tau * tau
        + 1.801_225_02 * pow(tau, 7.5);
    CRITICAL_PRESSURE * exp(CRITICAL_TEMPERATURE / t * sum)
}

/// Density of saturated vapour at `temperature` [K] as an ideal gas [kg/m³]; within 2 % up to 100 °C.
pub fn saturation_density(temperature: f64) -> f64 {
    saturation_pressure(temperature) / (VAPOUR_GAS_CONSTANT * temperature)
}

/// Latent heat of evaporation of water at `temperature` [K] [J/kg].
///
/// 2501 − 2.36 T kJ/kg with T in °C; within 0.3 % of the steam tables from 0 to 100 °C, 3 % high at 180 °C.
pub fn latent_heat(temperature: f64) -> f64 {
    2.501e6 - 2360.0 * (temperature - ZERO_C)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vapour_pressure_and_latent_heat_match_steam_tables() {
        for (c, pa) in [(20.0, 2339.3), (60.0, 19_947.0), (100.0, 101_418.0), (150.0, 476_160.0)] {
            let got = saturation_pressure(c + ZERO_C);
            assert!((got / pa - 1.0).abs() < 2e-3, "{c} °C: {got}");
        }
        assert!((latent_heat(373.15) / 2.2564e6 - 1.0).abs() < 5e-3);
    }
}
