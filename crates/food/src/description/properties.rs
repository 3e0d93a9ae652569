//! Property tables of a food file: melting, sorption, crust, anisotropy, surface and colours.

use std::collections::BTreeMap;

use crate::sourced_table;

sourced_table! {
    /// Melting of the fat.
    FatMelting {
        /// Half of the fat is liquid here [°C].
        middle_c: f64,
        /// Width of the logistic transition [K].
        width_k: f64,
        /// Latent heat of fusion [J/kg].
        latent_j_kg: f64,
    }
}

sourced_table! {
    /// GAB sorption isotherm.
    Sorption {
        /// Monolayer moisture X_m [kg/kg dry].
        monolayer: f64,
        /// GAB constant C [-].
        c: f64,
        /// GAB constant K [-].
        k: f64,
        /// Water activity of the fresh food [-].
        fresh_activity: f64,
    }
}

sourced_table! {
    /// Dry crust.
    Crust {
        /// Thermal conductivity of the dry, porous crust [W/(m·K)].
        conductivity_w_mk: f64,
    }
}

sourced_table! {
    /// Conduction that differs with direction.
    Anisotropy {
        /// Conductivity across the fibres or sheaths over that of the composition [-].
        across: f64,
    }
}

sourced_table! {
    /// Surface properties.
    SurfaceProperties {
        /// Thermal emissivity [-].
        emissivity: f64,
        /// Share of the lower face that comes near to the pan: 1 for flat cuts, less for rounded pieces [-].
        contact_share: f64,
    }
}

sourced_table! {
    /// Colours and their changes, L*, a*, b* under D65.
    Colours {
        /// Raw flesh.
        raw: [f64; 3],
        /// Added when a change is complete, by its name.
        change: BTreeMap<String, [f64; 3]>,
        /// Golden stage of browning.
        golden: [f64; 3],
        /// Browning at which the golden stage is reached [-].
        golden_at: f64,
        /// Fully browned crust.
        crust: [f64; 3],
        /// Charred.
        char: [f64; 3],
        /// Raw fat.
        fat_raw: [f64; 3],
        /// Molten, cooked fat.
        fat_cooked: [f64; 3],
        /// Browned fat.
        fat_brown: [f64; 3],
    }
}
