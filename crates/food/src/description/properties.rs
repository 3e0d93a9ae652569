//! Property tables of a food file: melting, sorption, crust, anisotropy, surface and colours.

use std::collections::BTreeMap;

use crate::sourced_table;

sourced_table! {
    /// Melting of the fat: a logistic transition.
    FatMelting {
        /// Temperature at which half of the fat is liquid [°C].
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
    /// Properties of the dry crust.
    Crust {
        /// Thermal conductivity of the dry, porous crust [W/(m·K)].
        conductivity_w_mk: f64,
    }
}

sourced_table! {
    /// Anisotropy of conduction.
    Anisotropy {
        /// Conductivity across the fibres or sheaths relative to that of the composition [-].
        across: f64,
    }
}

sourced_table! {
    /// Properties of the surface.
    SurfaceProperties {
        /// Thermal emissivity [-].
        emissivity: f64,
        /// Share of the lower face that comes close to the pan: 1 for flat cuts, less for rounded pieces [-].
        contact_share: f64,
    }
}

sourced_table! {
    /// Colours and their changes in CIE L*, a*, b* (D65).
    Colours {
        /// Colour of raw flesh.
        raw: [f64; 3],
        /// Shift by a complete change, by the name of the change.
        change: BTreeMap<String, [f64; 3]>,
        /// Colour of the golden stage of browning.
        golden: [f64; 3],
        /// Browning at which the golden stage is reached [-].
        golden_at: f64,
        /// Colour of the fully browned crust.
        crust: [f64; 3],
        /// Colour of charred flesh.
        char: [f64; 3],
        /// Colour of raw fat.
        fat_raw: [f64; 3],
        /// Colour of molten, cooked fat.
        fat_cooked: [f64; 3],
        /// Colour of browned fat.
        fat_brown: [f64; 3],
    }
}
