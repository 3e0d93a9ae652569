//! The numbers of the gap between food and pan, as `data/kitchen.toml` states them.

use saute_food::sourced_table;

sourced_table! {
    /// The gap between food and pan.
    ContactGap {
        /// Oil in the pan at the start [g].
        #[schemars(range(min = 0.0, max = 1e4), example = 5.0)]
        oil_g: f64,
        /// Density of hot oil [kg/m³].
        #[schemars(range(min = 100.0, max = 2000.0), example = 900.0)]
        oil_density_kg_m3: f64,
        /// Thermal conductivity of oil [W/(m·K)].
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.16)]
        oil_conductivity_w_mk: f64,
        /// Thermal conductivity of steam and air in the gap [W/(m·K)].
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.033)]
        vapour_conductivity_w_mk: f64,
        /// Dynamic viscosity of steam in the gap [Pa·s].
        #[schemars(range(min = 1e-6, max = 1e-3), example = 1.5e-5)]
        vapour_viscosity_pa_s: f64,
        /// Density of steam in the gap [kg/m³].
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.52)]
        vapour_density_kg_m3: f64,
        /// Distance between the places where steam escapes from below a large face [mm].
        #[schemars(range(min = 0.1, max = 1e3), example = 10.0)]
        vent_spacing_mm: f64,
        /// Least pressure that holds the steam down [Pa].
        #[schemars(range(min = 1.0, max = 1e6), example = 60.0)]
        least_pressure_pa: f64,
        /// Thermal conductivity of juice in the gap [W/(m·K)].
        #[schemars(range(min = 1e-3, max = 10.0), example = 0.65)]
        juice_conductivity_w_mk: f64,
        /// Conductance of the asperities on which a face lies with its own weight [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 110.0)]
        asperity_w_m2k: f64,
        /// Conductance of a crust's asperities over that of a wet face's [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.6)]
        crust_asperities: f64,
        /// Mean gap of a settled face [mm].
        #[schemars(range(min = 1e-3, max = 100.0), example = 0.28)]
        gap_mm: f64,
        /// What the mean gap is wider when the food has just been laid down [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.05)]
        settling_gap_mm: f64,
        /// Time constant of settling [s].
        #[schemars(range(min = 1e-3, max = 1e5), example = 2.0)]
        settling_s: f64,
        /// Conductance between steam at 100 °C and a face that is lifted off the pan, while steam rises below it
        /// [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e5), example = 300.0)]
        steam_w_m2k: f64,
        /// Thickness of the fat that gathers below a slice that waves over that of the film around it [-].
        #[schemars(range(min = 1.0, max = 20.0), example = 4.0)]
        wave_film: f64,
        /// Standard deviation of the gap along the face [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.045)]
        unevenness_mm: f64,
        /// Wavelength of the unevenness [mm].
        #[schemars(range(min = 0.01, max = 1e4), example = 9.0)]
        unevenness_scale_mm: f64,
        /// Smallest gap [mm].
        #[schemars(range(min = 1e-6, max = 100.0), example = 0.05)]
        least_gap_mm: f64,
        /// Pressure at which the mean gap is as given [Pa].
        #[schemars(range(min = 0.0, max = 1e7), example = 260.0)]
        pressure_pa: f64,
        /// Pressure on top of that which halves the mean gap [Pa].
        #[schemars(range(min = 1e-3, max = 1e9), example = 22.0e3)]
        halving_pressure_pa: f64,
    }
}
