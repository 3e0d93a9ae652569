//! What is below a pan apart from the heater: the glass of a hob, the tray of a burner, the rim of a plate.

use saute_food::sourced_table;

/// Thermal conductivity of warm air under a lifted pan [W/(m·K)] (standard tables, 100 °C).
const AIR_CONDUCTIVITY: f64 = 0.031;

sourced_table! {
    /// What is below a pan: the glass of a hob, the tray of a burner, the rim around a plate.
    Under {
        /// Conductance between pan and glass [W/(m²·K)].
        #[schemars(range(min = 0.1, max = 1e6), example = 200.0)]
        gap_conductance_w_m2k: f64,
        /// Heat capacity [J/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e6), example = 8000.0)]
        areal_capacity_j_m2k: f64,
        /// Loss to the inside of the hob [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 10.0)]
        loss_w_m2k: f64,
    }
}

/// Conductance `gap` [W/(m²·K)] in series with the air under a pan that is lifted by `lift` [m] [W/(m²·K)].
pub(crate) fn lifted(gap: f64, lift: f64) -> f64 {
    1.0 / (1.0 / gap + lift / AIR_CONDUCTIVITY)
}
