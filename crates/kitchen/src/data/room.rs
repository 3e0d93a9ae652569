//! The room's air and all content of `data/kitchen.toml`.

use saute_food::water::saturation_density;
use saute_food::{FreeAir, sourced_table};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::kelvin;
use crate::liquids::bath::BathData;
use crate::liquids::butter::FoamData;
use crate::liquids::smoke::SmokeData;
use crate::liquids::spatter::SpatterData;
use crate::liquids::water_film::PuddleData;
use crate::pan::lid::LidData;
use crate::piece::contact_gap::ContactGap;

sourced_table! {
    /// Air of the room.
    Air {
        /// Temperature [°C].
        #[schemars(range(min = -50.0, max = 100.0), example = 23.0)]
        temperature_c: f64,
        /// Relative humidity [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.5)]
        relative_humidity: f64,
    }
}

sourced_table! {
    /// Heat and vapour transfer at a free face of food.
    FreeFace {
        /// Convection [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e4), example = 7.0)]
        convection_w_m2k: f64,
        /// Lewis number of vapour in air [-].
        #[schemars(range(min = 0.1, max = 10.0), example = 0.87)]
        lewis_number: f64,
        /// Density of the air [kg/m³].
        #[schemars(range(min = 0.01, max = 10.0), example = 1.1)]
        air_density_kg_m3: f64,
        /// Specific heat of the air [J/(kg·K)].
        #[schemars(range(min = 100.0, max = 10_000.0), example = 1007.0)]
        air_specific_heat_j_kgk: f64,
        /// Air that rises through an open pan and carries its steam away [L/s].
        #[schemars(range(min = 0.01, max = 1e3), example = 3.0)]
        draught_l_s: f64,
        /// Share of the floor under food above which the pan is crowded [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.7)]
        crowded_from: f64,
        /// Draught through a crowded pan over that through an open one [-].
        #[schemars(range(min = 0.01, max = 1.0), example = 0.5)]
        crowded_draught: f64,
        /// Air that rises close along the sides of the foods with the steam from below them [L/s].
        #[schemars(range(min = 0.01, max = 1e3), example = 0.4)]
        side_draught_l_s: f64,
        /// Convection at the sides, in that air [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e4), example = 8.0)]
        side_convection_w_m2k: f64,
        /// View factor from an upper face to the pan's wall [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.25)]
        wall_view: f64,
        /// View factor from the side of food to the pan's floor and wall [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.5)]
        side_view: f64,
        /// Excess of the air over food in the pan, over the pan's own excess [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.22)]
        plume_warmth: f64,
        /// The same for air and walls around its side [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.4)]
        side_warmth: f64,
    }
}

sourced_table! {
    /// Convection at the pan.
    PanAir {
        /// h over (T − T_air)^¼ [W/(m²·K^1.25)].
        #[schemars(range(min = 0.0, max = 1e3), example = 2.5)]
        convection_coefficient: f64,
    }
}

sourced_table! {
    /// Food on food.
    FoodContact {
        /// Conductance between wet foods that touch [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e6), example = 300.0)]
        conductance_w_m2k: f64,
    }
}

sourced_table! {
    /// Friction of food in the pan.
    Friction {
        /// Raw, wet flesh on dry metal [-].
        #[schemars(range(min = 0.0, max = 10.0), example = 0.6)]
        raw: f64,
        /// A crust on dry metal [-].
        #[schemars(range(min = 0.0, max = 10.0), example = 0.35)]
        crust: f64,
        /// Factor that a film of oil leaves [-].
        #[schemars(range(min = 0.0, max = 10.0), example = 0.4)]
        oiled_factor: f64,
        /// Film at which it is halfway there [mm].
        #[schemars(range(min = 1e-6, max = 100.0), example = 0.05)]
        film_mm: f64,
    }
}

sourced_table! {
    /// Oil and fat by kind, and what stays of them on a drained pan.
    OilUse {
        /// Oil in the pan at the start, and unless told otherwise.
        #[schemars(example = &"canola")]
        default: String,
        /// Fat that foods render.
        #[schemars(example = &"beef-fat")]
        rendered: String,
        /// Butter.
        #[schemars(example = &"butter")]
        butter: String,
        /// Film that stays on a drained pan [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.01)]
        clinging_mm: f64,
    }
}

sourced_table! {
    /// A wet cloth to set the pan on.
    ClothData {
        /// Water in the cloth [g].
        #[schemars(range(min = 0.0, max = 1e5), example = 100.0)]
        water_g: f64,
        /// How long the pan stands on it unless told otherwise [s].
        #[schemars(range(min = 0.0, max = 3600.0), example = 3.0)]
        default_s: f64,
        /// Share of the floor that touches [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.85)]
        contact_share: f64,
        /// Base temperatures of the boiling curve [°C].
        #[schemars(inner(range(min = -100.0, max = 1000.0)), extend("examples" = [[20.0, 140.0, 400.0]]))]
        base_c: Vec<f64>,
        /// Heat flux at those [kW/m²].
        #[schemars(inner(range(min = 0.0, max = 1e5)), extend("examples" = [[0.0, 400.0, 220.0]]))]
        flux_kw_m2: Vec<f64>,
    }
}

sourced_table! {
    /// The wooden board.
    BoardData {
        /// Contact conductance [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e6), example = 150.0)]
        conductance_w_m2k: f64,
        /// Thermal conductivity [W/(m·K)].
        #[schemars(range(min = 1e-3, max = 1000.0), example = 0.16)]
        conductivity_w_mk: f64,
        /// Heat capacity of one layer [J/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e7), example = 4000.0)]
        areal_capacity_j_m2k: f64,
        /// Thickness of one layer [mm].
        #[schemars(range(min = 0.01, max = 1000.0), example = 4.0)]
        layer_mm: f64,
    }
}

sourced_table! {
    /// Loose foil over resting food.
    FoilData {
        /// Convection through the air gap [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e4), example = 3.0)]
        convection_w_m2k: f64,
        /// Radiation that passes [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.1)]
        radiation_share: f64,
        /// Evaporation that goes on [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.1)]
        evaporation_share: f64,
    }
}

sourced_table! {
    /// What the rules of 2013 put in place of contact, and of the cloth.
    Rules2013 {
        /// Nodes whose gap is below this take heat [mm].
        #[schemars(range(min = 0.0, max = 1000.0), example = 1.0)]
        contact_distance_mm: f64,
        /// Conductance of those [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e6), example = 400.0)]
        conductance_w_m2k: f64,
        /// What the mean gap is wider when the food has just been laid down [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.05)]
        settling_gap_mm: f64,
        /// Time constant of settling [s].
        #[schemars(range(min = 1e-3, max = 1e5), example = 2.0)]
        settling_s: f64,
        /// Mean gap when the food has settled [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.19)]
        initial_gap_mm: f64,
        /// Mean gap after steam and crust have lifted it [mm].
        #[schemars(range(min = 0.0, max = 100.0), example = 0.244)]
        final_gap_mm: f64,
        /// Time constant of that [s].
        #[schemars(range(min = 1e-3, max = 1e5), example = 40.0)]
        time_constant_s: f64,
        /// Pressure at which the mean gap is as given [Pa].
        #[schemars(range(min = 0.0, max = 1e7), example = 260.0)]
        pressure_pa: f64,
        /// Pressure on top of that which halves the mean gap [Pa].
        #[schemars(range(min = 1e-3, max = 1e9), example = 22.0e3)]
        halving_pressure_pa: f64,
        /// Convection at a free face [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e4), example = 7.0)]
        convection_w_m2k: f64,
        /// Mass transfer to the air over a pan, over that to still air; of water in the pan only [-].
        #[schemars(range(min = 0.0, max = 10.0), example = 0.6)]
        plume_factor: f64,
        /// Temperature of the glass in the middle of the coil at which the power goes off [°C].
        #[schemars(range(min = 0.0, max = 1000.0), example = 250.0)]
        limit_c: f64,
        /// How far the glass must cool below that until the power comes back [K].
        #[schemars(range(min = 0.0, max = 500.0), example = 15.0)]
        resume_k: f64,
        /// Temperature of the pan as soon as it touches the cloth [°C].
        #[schemars(range(min = 0.0, max = 1000.0), example = 120.0)]
        cloth_c: f64,
    }
}

/// An open pan as the air over it sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverPan {
    /// Mean temperature of the floor [K].
    pub floor: f64,
    /// Mean temperature of the wall [K].
    pub wall: f64,
    /// Steam that rises from foods and liquids [kg/s].
    pub steam: f64,
    /// Share of the floor under food [-].
    pub covered: f64,
}

/// Temperature of surroundings of which the share `view` is at `near` [K] and the rest at `far` [K] [K].
fn seen(far: f64, near: f64, view: f64) -> f64 {
    let fourth = |t: f64| t * t * t * t;
    libm::sqrt(libm::sqrt((1.0 - view) * fourth(far) + view * fourth(near)))
}

/// Radius of the floor of a 26 cm pan [m] (as the pans of `data/pans`).
const FLOOR_RADIUS: f64 = 0.1;

/// `data/kitchen.toml`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute kitchen")]
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
    /// Food in a liquid.
    pub bath: BathData,
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
            walls: self.temperature(),
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

    /// Air above and around food in an open pan.
    ///
    /// ρ∞ = ρ_room + ṁ/V̇ up to saturation at the air's temperature; the walls' temperature is the mean of T⁴ over pan and
    /// room, weighted by the view factor.
    pub fn plume(&self, pan: &OverPan) -> (FreeAir, FreeAir) {
        let face = &self.free_face;
        let excess = (pan.floor - self.temperature()).max(0.0);
        let over = |moving: FreeAir, warmth: f64, draught_l_s: f64, radiating: f64, view: f64| {
            let temperature = moving.temperature + warmth * excess;
            let wet = moving.vapour_density + pan.steam / (1e-3 * draught_l_s);
            FreeAir {
                temperature,
                walls: seen(moving.temperature, radiating, view),
                vapour_density: wet.min(saturation_density(temperature.min(kelvin(100.0)))),
                ..moving
            }
        };
        let draught = face.draught_l_s * if pan.covered > face.crowded_from { face.crowded_draught } else { 1.0 };
        let beside = 0.5 * (pan.floor + pan.wall);
        (
            over(self.still_air(), face.plume_warmth, draught, pan.wall, face.wall_view),
            over(
                self.air_moving(face.side_convection_w_m2k),
                face.side_warmth,
                face.side_draught_l_s,
                beside,
                face.side_view,
            ),
        )
    }

    /// Air above and around food in a pan at `pan` [K] by the rules of 2013.
    pub(crate) fn plume_2013(&self, pan: f64) -> (FreeAir, FreeAir) {
        let still = self.still_air_2013();
        let excess = (pan - still.temperature).max(0.0);
        let warmed = |share: f64| {
            let temperature = still.temperature + share * excess;
            let mass_transfer = still.mass_transfer * self.rules_2013.plume_factor;
            FreeAir { temperature, walls: temperature, mass_transfer, ..still }
        };
        (warmed(self.free_face.plume_warmth), warmed(self.free_face.side_warmth))
    }

    /// Still air around food by the rules of 2013.
    pub(crate) fn still_air_2013(&self) -> FreeAir {
        self.air_moving(self.rules_2013.convection_w_m2k)
    }

    /// The same air, which takes up no vapour.
    pub(crate) fn without_evaporation(air: FreeAir) -> FreeAir {
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
