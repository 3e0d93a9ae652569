//! The lid: it keeps hot, moist air over the food. Vapour condenses on it and drips back; steam escapes only when the
//! space under the lid is full at atmospheric pressure.
//!
//! The air under the lid is one well-mixed control volume with heat capacity, vapour and one temperature, which also
//! approximates the lid's radiation. Exchanges are added during a tick; [`Lid::settle`] then condenses vapour and
//! releases steam.

use saute_food::water::air_film::radiation_coefficient;
use saute_food::water::{ATMOSPHERE, VAPOUR_GAS_CONSTANT, latent_heat, saturation_density, saturation_pressure};
use saute_food::{FreeAir, ZERO_C, sourced_table};
use serde::{Deserialize, Serialize};

use crate::data::room::Room;
use crate::kelvin;
use crate::liquids::water_film::{Vapour, WATER_SPECIFIC_HEAT, vapour_enthalpy};
use crate::pan::pan_description::PanDescription;

sourced_table! {
    /// A lid.
    LidData {
        /// Heat capacity [J/(m²·K)].
        #[schemars(range(min = 1.0, max = 1e7), example = 8400.0)]
        areal_capacity_j_m2k: f64,
        /// Convection of the air under it [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e4), example = 7.0)]
        convection_w_m2k: f64,
        /// Thermal emissivity of its outside [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.9)]
        emissivity: f64,
        /// Most that condensation adds at a cold face [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 1e6), example = 500.0)]
        condensing_limit_w_m2k: f64,
    }
}

/// Largest share of vapour pressure in the total pressure for film condensation [-] (chosen: Stefan's logarithm diverges
/// for pure steam).
const PUREST: f64 = 0.98;
/// Largest share of the vapour under the lid that condenses in one tick [-] (chosen: keeps the vapour positive).
const MOST_AT_ONCE: f64 = 0.3;
/// Radiation coefficient between food and lid [W/(m²·K)] (4 ε σ T³ at 80 °C).
const RADIATION: f64 = 9.0;

/// A lid on the pan and the air under it.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Lid {
    /// Temperature of the lid [K].
    pub temperature: f64,
    /// Mass of vapour under it [kg].
    pub vapour: f64,
    /// Enthalpy of air and vapour under it, above air and liquid water at 0 °C [J].
    pub enthalpy: f64,
    /// Area [m²].
    area: f64,
    /// Volume under it [m³].
    volume: f64,
    /// Heat capacity of the dry air [J/K].
    air_capacity: f64,
    /// Heat capacity of the lid [J/K].
    capacity: f64,
    /// Flow of vapour from the pan's own water under it in the last tick [kg/s]; not stored.
    #[serde(skip)]
    pub boiled: f64,
}

/// Output of a lid in one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// Water that drips back.
    pub condensate: Vapour,
    /// Steam that escapes.
    pub escaped: Vapour,
    /// Heat to the room [J].
    pub to_room: f64,
}

impl Lid {
    /// A lid at the room's temperature, with the room's air under it.
    pub fn put_on(pan: &PanDescription, room: &Room) -> Self {
        let [floor, rim, height] = [pan.floor.radius_mm, pan.wall.rim_radius_mm, pan.wall.height_mm].map(|v| 1e-3 * v);
        let volume = core::f64::consts::PI / 3.0 * height * (floor * floor + floor * rim + rim * rim);
        let temperature = room.temperature();
        let air = room.still_air();
        let vapour = volume * air.vapour_density;
        let air_capacity = volume * room.free_face.air_density_kg_m3 * room.free_face.air_specific_heat_j_kgk;
        Self {
            temperature,
            vapour,
            enthalpy: air_capacity * (temperature - ZERO_C) + vapour * vapour_enthalpy(temperature),
            area: core::f64::consts::PI * rim * rim,
            capacity: room.lid.areal_capacity_j_m2k * core::f64::consts::PI * rim * rim,
            volume,
            air_capacity,
            boiled: 0.0,
        }
    }

    /// Heat of lid, air and vapour above 0 °C and liquid water [J].
    pub fn stored(&self) -> f64 {
        self.enthalpy + self.capacity * (self.temperature - ZERO_C)
    }

    /// Temperature of the air under the lid [K].
    pub fn air_temperature(&self) -> f64 {
        let (base, slope) = (vapour_enthalpy(ZERO_C), vapour_enthalpy(ZERO_C + 1.0) - vapour_enthalpy(ZERO_C));
        ZERO_C + (self.enthalpy - self.vapour * base) / (self.air_capacity + self.vapour * slope)
    }

    /// Steam released when the lid is taken off.
    pub fn released(&self) -> Vapour {
        Vapour { mass: self.vapour, enthalpy: self.vapour * vapour_enthalpy(self.air_temperature()) }
    }

    /// Density of the vapour under the lid [kg/m³].
    pub fn vapour_density(&self) -> f64 {
        self.vapour / self.volume
    }

    /// Air over a face at `surface` [K], and the share of the heat transfer due to condensation [-].
    ///
    /// A face below the dew point receives the latent heat: h = h_c + h_m L (ρ_v − ρ_sat(T_s)) / (T − T_s).
    pub fn air_over(&self, room: &Room, surface: f64) -> (FreeAir, f64) {
        let still = room.air_moving(room.lid.convection_w_m2k);
        let temperature = self.air_temperature();
        let air = FreeAir { temperature, walls: temperature, vapour_density: self.vapour_density(), ..still };
        let excess = air.vapour_density - saturation_density(surface.min(kelvin(100.0)));
        let warmer = air.temperature - surface;
        if excess <= 0.0 || warmer <= 0.0 {
            return (air, 0.0);
        }
        let condensing = air.mass_transfer * latent_heat(surface) * excess / warmer.max(1.0);
        let condensing = condensing.min(room.lid.condensing_limit_w_m2k);
        let convection = air.convection + condensing;
        (FreeAir { convection, mass_transfer: 0.0, ..air }, condensing / (convection + RADIATION))
    }

    /// Adds vapour to the air under the lid.
    pub fn take_vapour(&mut self, vapour: Vapour) {
        self.vapour += vapour.mass;
        self.enthalpy += vapour.enthalpy;
    }

    /// Adds heat to the air under the lid; negative heat is given to a face, with the share `condensing` from vapour that
    /// condenses on it. Returns the condensed water.
    pub fn take_heat(&mut self, heat: f64, condensing: f64) -> Vapour {
        self.enthalpy += heat;
        let t = self.air_temperature();
        let mass = (condensing * (-heat).max(0.0) / latent_heat(t)).min(MOST_AT_ONCE * self.vapour);
        let water = Vapour { mass, enthalpy: mass * WATER_SPECIFIC_HEAT * (t - ZERO_C) };
        self.vapour -= water.mass;
        self.enthalpy -= water.enthalpy;
        water
    }

    /// Condenses vapour, releases steam and cools for `dt` [s].
    pub fn settle(&mut self, room: &Room, dt: f64) -> Settled {
        let on_lid = self.condense_on_lid(room, dt);
        let fog = self.condense_fog();
        let escaped = self.let_off();
        let warmer = self.air_temperature() - self.temperature;
        let given = room.lid.convection_w_m2k * self.area * warmer * dt;
        self.enthalpy -= given;
        self.temperature += given / self.capacity;
        let outside = room.temperature();
        let excess = self.temperature - outside;
        let convection = room.pan_air.convection_coefficient * libm::sqrt(libm::sqrt(libm::fabs(excess)));
        let radiation = radiation_coefficient(room.lid.emissivity, self.temperature, outside);
        let to_room = (convection + radiation) * self.area * excess * dt;
        self.temperature -= to_room / self.capacity;
        let condensate = Vapour { mass: on_lid.mass + fog.mass, enthalpy: on_lid.enthalpy + fog.enthalpy };
        Settled { condensate, escaped, to_room }
    }

    /// Condensation on the lid by Stefan diffusion: ṁ = h_m ρ ln((p − p_lid)/(p − p_v)).
    fn condense_on_lid(&mut self, room: &Room, dt: f64) -> Vapour {
        let t = self.air_temperature();
        let pressure = |density: f64| (density * VAPOUR_GAS_CONSTANT * t / ATMOSPHERE).min(PUREST);
        let at_lid = (saturation_pressure(self.temperature) / ATMOSPHERE).min(PUREST);
        let vapour = pressure(self.vapour_density());
        if vapour <= at_lid {
            return Vapour::default();
        }
        let transfer = room.air_moving(room.lid.convection_w_m2k).mass_transfer;
        let density = ATMOSPHERE / (VAPOUR_GAS_CONSTANT * t);
        let flow = transfer * self.area * density * libm::log((1.0 - at_lid) / (1.0 - vapour));
        // Condensation does not heat the lid above the air.
        let room_left = self.capacity * (t - self.temperature).max(0.0) / latent_heat(t);
        let mass = (flow * dt).min(MOST_AT_ONCE * self.vapour).min(room_left);
        let enthalpy = mass * WATER_SPECIFIC_HEAT * (self.temperature - ZERO_C);
        let brought = mass * vapour_enthalpy(t);
        self.vapour -= mass;
        self.enthalpy -= brought;
        self.temperature += (brought - enthalpy) / self.capacity;
        Vapour { mass, enthalpy }
    }

    /// Vapour above saturation condenses to fog, which drips, and its latent heat warms the air; Newton iteration.
    fn condense_fog(&mut self) -> Vapour {
        let mut fog = Vapour::default();
        for _ in 0..3 {
            let t = self.air_temperature();
            let saturated = self.volume * saturation_density(t);
            if t >= kelvin(100.0) || self.vapour <= saturated {
                break;
            }
            let steeper = self.volume * (saturation_density(t + 0.5) - saturation_density(t - 0.5));
            let capacity = self.air_capacity + self.vapour * 1.0e3;
            let mass = (self.vapour - saturated) / (1.0 + steeper * latent_heat(t) / capacity);
            let enthalpy = mass * WATER_SPECIFIC_HEAT * (t - ZERO_C);
            self.vapour -= mass;
            self.enthalpy -= enthalpy;
            fog = Vapour { mass: fog.mass + mass, enthalpy: fog.enthalpy + enthalpy };
        }
        fog
    }

    /// Releases the vapour that exceeds the volume under the lid at atmospheric pressure.
    fn let_off(&mut self) -> Vapour {
        let t = self.air_temperature();
        let held = self.volume * ATMOSPHERE / (VAPOUR_GAS_CONSTANT * t.max(kelvin(100.0)));
        let mass = (self.vapour - held).max(0.0);
        let enthalpy = mass * vapour_enthalpy(t);
        self.vapour -= mass;
        self.enthalpy -= enthalpy;
        Vapour { mass, enthalpy }
    }
}
