//! The room's air and everything `data/kitchen.toml` says.

use saute_food::water::saturation_density;
use saute_food::{FreeAir, sourced_table};
use serde::Deserialize;

use crate::kelvin;
use crate::liquids::butter::FoamData;
use crate::liquids::smoke::SmokeData;
use crate::liquids::spatter::SpatterData;
use crate::liquids::water_film::PuddleData;
use crate::pan::lid::LidData;

sourced_table! {
    /// Air of the room.
    Air {
        /// Temperature [°C].
        temperature_c: f64,
        /// Relative humidity [-].
        relative_humidity: f64,
    }
}

sourced_table! {
    /// Heat and vapour transfer at a free face of food.
    FreeFace {
        /// Convection [W/(m²·K)].
        convection_w_m2k: f64,
        /// Lewis number of vapour in air [-].
        lewis_number: f64,
        /// Density of the air [kg/m³].
        air_density_kg_m3: f64,
        /// Specific heat of the air [J/(kg·K)].
        air_specific_heat_j_kgk: f64,
        /// Evaporation above a hot pan over that in still air [-].
        plume_factor: f64,
        /// Excess of the air over food in the pan, over the pan's own excess [-].
        plume_warmth: f64,
        /// The same for air and walls around its side [-].
        side_warmth: f64,
    }
}

sourced_table! {
    /// Convection at the pan.
    PanAir {
        /// h over (T − T_air)^¼ [W/(m²·K^1.25)].
        convection_coefficient: f64,
    }
}

sourced_table! {
    /// The gap between food and pan.
    ContactGap {
        /// Oil in the pan at the start [g].
        oil_g: f64,
        /// Density of hot oil [kg/m³].
        oil_density_kg_m3: f64,
        /// Thermal conductivity of oil [W/(m·K)].
        oil_conductivity_w_mk: f64,
        /// Thermal conductivity of steam and air in the gap [W/(m·K)].
        vapour_conductivity_w_mk: f64,
        /// What the mean gap is wider when the food has just been laid down [mm].
        settling_gap_mm: f64,
        /// Time constant of settling [s].
        settling_s: f64,
        /// Mean gap when the food has settled [mm].
        initial_gap_mm: f64,
        /// Mean gap after steam and crust have lifted it [mm].
        final_gap_mm: f64,
        /// Time constant of that [s].
        time_constant_s: f64,
        /// Standard deviation of the gap along the face [mm].
        unevenness_mm: f64,
        /// Wavelength of the unevenness [mm].
        unevenness_scale_mm: f64,
        /// Smallest gap [mm].
        least_gap_mm: f64,
        /// Pressure at which the mean gap is as given [Pa].
        pressure_pa: f64,
        /// Pressure on top of that which halves the mean gap [Pa].
        halving_pressure_pa: f64,
        /// A wet face begins to ride on steam where the pan is hotter than the first, and does so fully at the second [°C].
        steam_c: [f64; 2],
        /// Conductance of a face that rides on steam over that of one that does not [-].
        steam_factor: f64,
    }
}

sourced_table! {
    /// Food on food.
    FoodContact {
        /// Conductance between wet foods that touch [W/(m²·K)].
        conductance_w_m2k: f64,
    }
}

sourced_table! {
    /// Friction of food in the pan.
    Friction {
        /// Raw, wet flesh on dry metal [-].
        raw: f64,
        /// A crust on dry metal [-].
        crust: f64,
        /// Factor that a film of oil leaves [-].
        oiled_factor: f64,
        /// Film at which it is halfway there [mm].
        film_mm: f64,
    }
}

sourced_table! {
    /// Oil and fat by kind, and what stays of them on a drained pan.
    OilUse {
        /// Oil in the pan at the start, and unless told otherwise.
        default: String,
        /// Fat that foods render.
        rendered: String,
        /// Butter.
        butter: String,
        /// Film that stays on a drained pan [mm].
        clinging_mm: f64,
    }
}

sourced_table! {
    /// A wet cloth to set the pan on.
    ClothData {
        /// Water in the cloth [g].
        water_g: f64,
        /// How long the pan stands on it unless told otherwise [s].
        default_s: f64,
        /// Share of the floor that touches [-].
        contact_share: f64,
        /// Base temperatures of the boiling curve [°C].
        base_c: Vec<f64>,
        /// Heat flux at those [kW/m²].
        flux_kw_m2: Vec<f64>,
    }
}

sourced_table! {
    /// The wooden board.
    BoardData {
        /// Contact conductance [W/(m²·K)].
        conductance_w_m2k: f64,
        /// Thermal conductivity [W/(m·K)].
        conductivity_w_mk: f64,
        /// Heat capacity of one layer [J/(m²·K)].
        areal_capacity_j_m2k: f64,
        /// Thickness of one layer [mm].
        layer_mm: f64,
    }
}

sourced_table! {
    /// Loose foil over resting food.
    FoilData {
        /// Convection through the air gap [W/(m²·K)].
        convection_w_m2k: f64,
        /// Radiation that passes [-].
        radiation_share: f64,
        /// Evaporation that goes on [-].
        evaporation_share: f64,
    }
}

sourced_table! {
    /// What the rules of 2013 put in place of contact, and of the cloth.
    Rules2013 {
        /// Nodes whose gap is below this take heat [mm].
        contact_distance_mm: f64,
        /// Conductance of those [W/(m²·K)].
        conductance_w_m2k: f64,
        /// Temperature of the pan as soon as it touches the cloth [°C].
        cloth_c: f64,
    }
}

/// Radius of the floor of a 26 cm pan [m] (as the pans of `data/pans`).
const FLOOR_RADIUS: f64 = 0.1;

/// `data/kitchen.toml`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Room {
    /// Air.
    pub air: Air,
    /// Free faces of food.
    pub free_face: FreeFace,
    /// Pan in air.
    pub pan_air: PanAir,
    /// Food on pan.
    pub contact: ContactGap,
    /// Food on food.
    pub food_contact: FoodContact,
    /// Friction.
    pub friction: Friction,
    /// Water in the pan.
    pub puddle: PuddleData,
    /// Oil in the pan.
    pub oil: OilUse,
    /// Smoke and fire.
    pub smoke: SmokeData,
    /// Spatter.
    pub spatter: SpatterData,
    /// Foam of butter.
    pub foam: FoamData,
    /// Lid.
    pub lid: LidData,
    /// Wet cloth.
    pub cloth: ClothData,
    /// Board.
    pub board: BoardData,
    /// Foil.
    pub foil: FoilData,
    /// The rules of 2013.
    pub rules_2013: Rules2013,
}

impl Room {
    /// Air temperature [K].
    pub fn temperature(&self) -> f64 {
        kelvin(self.air.temperature_c)
    }

    /// Still air around resting food.
    pub fn still_air(&self) -> FreeAir {
        self.air_moving(self.free_face.convection_w_m2k)
    }

    /// Air of the room that moves so that its coefficient is `convection` [W/(m²·K)]; it takes up vapour by the Lewis
    /// analogy.
    pub fn air_moving(&self, convection: f64) -> FreeAir {
        let face = &self.free_face;
        let lewis = libm::pow(face.lewis_number, 2.0 / 3.0);
        FreeAir {
            temperature: self.temperature(),
            convection,
            radiation: 1.0,
            vapour_density: self.air.relative_humidity * saturation_density(self.temperature()),
            mass_transfer: convection / (face.air_density_kg_m3 * face.air_specific_heat_j_kgk * lewis),
        }
    }

    /// Film of the oil that a pan starts with, on the floor of a 26 cm pan [m].
    pub fn default_film(&self) -> f64 {
        let floor = core::f64::consts::PI * FLOOR_RADIUS * FLOOR_RADIUS;
        1e-3 * self.contact.oil_g / (self.contact.oil_density_kg_m3 * floor)
    }

    /// Air above and beside food in a pan at `pan` [K].
    pub fn plume(&self, pan: f64) -> (FreeAir, FreeAir) {
        let still = self.still_air();
        let excess = (pan - still.temperature).max(0.0);
        let warmed = |share: f64| FreeAir {
            temperature: still.temperature + share * excess,
            mass_transfer: still.mass_transfer * self.free_face.plume_factor,
            ..still
        };
        (warmed(self.free_face.plume_warmth), warmed(self.free_face.side_warmth))
    }

    /// The same air, which takes up no vapour.
    pub fn without_evaporation(air: FreeAir) -> FreeAir {
        FreeAir { mass_transfer: 0.0, ..air }
    }

    /// Air under loose foil.
    pub fn under_foil(&self) -> FreeAir {
        let still = self.still_air();
        FreeAir {
            convection: self.foil.convection_w_m2k,
            radiation: self.foil.radiation_share,
            mass_transfer: still.mass_transfer * self.foil.evaporation_share,
            ..still
        }
    }
}
