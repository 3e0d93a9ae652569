//! Property tables of a food file: melting, sorption, crust, anisotropy, surface and colours.

use std::collections::BTreeMap;

use crate::description::lab_colour::{LabColour, LabShift};
use crate::sourced_table;

sourced_table! {
    /// Melting of the fat: a logistic transition.
    FatMelting {
        /// Temperature at which half of the fat is liquid [°C].
        #[schemars(range(min = -100.0, max = 200.0), example = 38.0)]
        middle_c: f64,
        /// Width of the logistic transition [K].
        #[schemars(range(min = 0.5, max = 50.0), example = 5.0)]
        width_k: f64,
        /// Latent heat of fusion [J/kg].
        #[schemars(range(min = 0.0, max = 4e5), example = 100.0e3)]
        latent_j_kg: f64,
    }
}

sourced_table! {
    /// Freezing of the water.
    Freezing {
        /// Temperature at which freezing begins [°C].
        #[schemars(range(min = -10.0, max = -0.1), example = -1.0)]
        begins_c: f64,
        /// Share of the water that is bound to the solids and never freezes [-].
        #[schemars(range(min = 0.0, max = 0.9), example = 0.08)]
        bound_share: f64,
    }
}

sourced_table! {
    /// GAB sorption isotherm.
    Sorption {
        /// Monolayer moisture X_m [kg/kg dry].
        #[schemars(range(min = 0.01, max = 0.3), example = 0.08)]
        monolayer: f64,
        /// GAB constant C [-].
        #[schemars(range(min = 1.1, max = 100.0), example = 12.0)]
        c: f64,
        /// GAB constant K [-].
        #[schemars(range(min = 0.5, max = 1.0), example = 0.96)]
        k: f64,
        /// Water activity of the fresh food [-].
        #[schemars(range(min = 0.8, max = 1.0), example = 0.99)]
        fresh_activity: f64,
    }
}

sourced_table! {
    /// Properties of the dry crust.
    Crust {
        /// Thermal conductivity of the dry, porous crust [W/(m·K)].
        #[schemars(range(min = 0.01, max = 1.0), example = 0.12)]
        conductivity_w_mk: f64,
    }
}

sourced_table! {
    /// Anisotropy of conduction.
    Anisotropy {
        /// Conductivity across the fibres or sheaths relative to that of the composition [-].
        #[schemars(range(min = 0.05, max = 5.0), example = 0.9)]
        across: f64,
        /// The same along the fibres [-]; 1 by default.
        #[serde(default = "unchanged")]
        #[schemars(range(min = 0.05, max = 5.0), example = 1.04)]
        along: f64,
    }
}

sourced_table! {
    /// Properties of the surface.
    SurfaceProperties {
        /// Thermal emissivity [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.95)]
        emissivity: f64,
        /// Share of the lower face that comes close to the pan: 1 for flat cuts, less for rounded pieces [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 1.0)]
        contact_share: f64,
    }
}

sourced_table! {
    /// Colours and their changes in CIE L*, a*, b* (D65).
    Colours {
        /// Colour of raw flesh.
        #[schemars(with = "LabColour", extend("examples" = [[37.0, 24.0, 12.0]]))]
        raw: [f64; 3],
        /// Shift by a complete change, by the name of the change.
        #[schemars(with = "BTreeMap<String, LabShift>", extend("examples" = [{ "myosin": [14.0, -9.0, 3.5] }]))]
        change: BTreeMap<String, [f64; 3]>,
        /// The same in the second tissue, such as a yolk; without it as in the first.
        #[schemars(with = "Option<BTreeMap<String, LabShift>>", extend("examples" = [{ "yolk_setting": [9.0, -7.0, -8.0] }]))]
        second_change: Option<BTreeMap<String, [f64; 3]>>,
        /// The same of a piece that follows the rules of 2013, which keeps the colours that this program had first; as
        /// `change` by default.
        #[schemars(with = "Option<BTreeMap<String, LabShift>>", extend("examples" = [{ "myosin": [14.0, -9.0, 3.5] }]))]
        change_2013: Option<BTreeMap<String, [f64; 3]>>,
        /// Colour of the golden stage of browning.
        #[schemars(with = "LabColour", extend("examples" = [[45.0, 13.0, 24.0]]))]
        golden: [f64; 3],
        /// Browning at which the golden stage is reached [-].
        #[schemars(range(min = 0.01, max = 0.99), example = 0.4)]
        golden_at: f64,
        /// Colour of the fully browned crust.
        #[schemars(with = "LabColour", extend("examples" = [[31.0, 5.0, 6.0]]))]
        crust: [f64; 3],
        /// Colour of charred flesh.
        #[schemars(with = "LabColour", extend("examples" = [[14.0, 1.0, 1.0]]))]
        char: [f64; 3],
        /// Colour of raw fat.
        #[schemars(with = "LabColour", extend("examples" = [[76.0, 4.0, 11.0]]))]
        fat_raw: [f64; 3],
        /// Colour of molten, cooked fat.
        #[schemars(with = "LabColour", extend("examples" = [[62.0, 5.0, 22.0]]))]
        fat_cooked: [f64; 3],
        /// Colour of browned fat.
        #[schemars(with = "LabColour", extend("examples" = [[48.0, 12.0, 32.0]]))]
        fat_brown: [f64; 3],
    }
}

/// Factor that changes nothing [-].
fn unchanged() -> f64 {
    1.0
}
