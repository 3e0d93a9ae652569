//! Butter: a lump melts, its water boils off with foam, its milk solids brown and then char.

use saute_food::ZERO_C;
use saute_food::sourced_table;
use serde::{Deserialize, Serialize};

use crate::kelvin;
use crate::liquids::oil::{Emulsion, Oil};
use crate::liquids::oil_film::OilFilm;
use crate::liquids::solids_rates::SolidsRates;
use crate::liquids::water_film::{WATER_SPECIFIC_HEAT, WaterFilm, WaterModel};
use crate::pan::bed::Bed;

sourced_table! {
    /// Foam of butter while steam passes through it.
    FoamData {
        /// Steam at which half of the most foam stands [g/s].
        #[schemars(range(min = 1e-9, max = 1e6), example = 0.015)]
        half_g_s: f64,
        /// How quickly foam rises and subsides [s].
        #[schemars(range(min = 1e-3, max = 1e5), example = 3.0)]
        time_constant_s: f64,
    }
}

/// Immutable model of butter.
#[derive(Clone, Debug)]
pub struct ButterModel {
    /// Index of its fat among the pan's oils; the fat carries the milk solids.
    pub kind: usize,
    emulsion: Emulsion,
    /// Specific heat of the whole [J/(kg·K)].
    specific_heat: f64,
    density: f64,
    rates: SolidsRates,
    foam: FoamData,
}

/// A lump of solid butter.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Lump {
    /// Mass [kg].
    pub mass: f64,
    /// Temperature [K].
    pub temperature: f64,
    /// Nodes below it, and the initially covered area of each [m²].
    pub footprint: Vec<(usize, f64)>,
    /// Initial mass on these areas [kg].
    pub whole: f64,
}

/// Butter in the pan, without its molten fat and water, which belong to the films of oil and water.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Butter {
    /// Lump that has not melted yet.
    pub lump: Option<Lump>,
    /// Water of the butter that has not boiled yet; it is part of the water in the pan [kg].
    pub water: f64,
    /// Foam, from 0 (none) to 1 (full pan) [-].
    pub foam: f64,
    /// Browning of the milk solids, from 0 to 1 [-].
    pub browning: f64,
    /// Charring of the milk solids, from 0 to 1 [-].
    pub charring: f64,
}

/// Melt of a lump at one node in one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Molten {
    /// Node.
    pub node: usize,
    /// Fat with milk solids [kg].
    pub fat: f64,
    /// Water [kg].
    pub water: f64,
    /// Temperature of both [K].
    pub temperature: f64,
    /// Heat taken from the node [J].
    pub heat: f64,
}

impl Butter {
    /// Takes all of it away; returns the mass of the lump that had not melted [kg]. What melted is oil and water of the pan.
    pub(crate) fn wipe(&mut self) -> f64 {
        core::mem::take(self).lump.map_or(0.0, |lump| lump.mass)
    }
}

impl ButterModel {
    /// Builds the model from the oil of an index; `None` if that oil is no emulsion.
    pub fn new(oils: &[Oil], kind: usize, foam: &FoamData) -> Option<Self> {
        let oil = oils.get(kind)?;
        let emulsion = oil.description.emulsion.clone()?;
        Some(Self {
            kind,
            specific_heat: (1.0 - emulsion.water) * oil.specific_heat + emulsion.water * WATER_SPECIFIC_HEAT,
            density: oil.density(kelvin(20.0)),
            rates: SolidsRates::new(&emulsion.browning, &emulsion.charring),
            foam: foam.clone(),
            emulsion,
        })
    }

    /// Mass share of milk solids in the molten fat [-].
    pub fn solids_share(&self) -> f64 {
        self.emulsion.solids / (1.0 - self.emulsion.water)
    }

    /// Enthalpy of a lump above molten butter at 0 °C [J].
    pub fn stored(&self, lump: &Lump) -> f64 {
        lump.mass * (self.specific_heat * (lump.temperature - ZERO_C) - self.emulsion.latent_j_kg)
    }
}

impl Butter {
    /// Puts a lump on the floor, on the uncovered nodes nearest to the centre; a lump in the pan merges with it.
    pub fn lay(&mut self, model: &ButterModel, bed: &Bed, covered: &[f64], mass: f64, temperature: f64) {
        let (old, warm) = self.lump.take().map_or((0.0, temperature), |l| (l.mass, l.temperature));
        let whole = old + mass;
        let wanted = whole / (model.density * 1e-3 * model.emulsion.lump_mm);
        let mut order: Vec<usize> = (0..covered.len()).filter(|&i| bed.places[i][2] <= 0.0).collect();
        let distance = |i: &usize| libm::hypot(bed.places[*i][0], bed.places[*i][1]);
        order.sort_by(|a, b| {
            (covered[*a] > 0.5, distance(a))
                .partial_cmp(&(covered[*b] > 0.5, distance(b)))
                .unwrap_or(core::cmp::Ordering::Equal)
        });
        let mut left = wanted;
        let mut footprint = Vec::new();
        for i in order {
            let area = bed.areas[i].min(left);
            if area > 0.0 {
                footprint.push((i, area));
            }
            left -= area;
        }
        self.lump =
            Some(Lump { mass: whole, temperature: (old * warm + mass * temperature) / whole, footprint, whole });
    }

    /// Warms and melts the lump for `dt` [s] on a pan of these temperatures [K]; calls `give` with the melt at each node
    /// and the node's temperature.
    pub fn melt(
        &mut self,
        model: &ButterModel,
        temperature: &mut [f64],
        dt: f64,
        mut give: impl FnMut(Molten, &mut f64),
    ) {
        let Some(lump) = &mut self.lump else { return };
        let melting = kelvin(model.emulsion.melting_c);
        // It becomes thinner as well as narrower.
        let left = libm::sqrt(lump.mass / lump.whole);
        let conductance = model.emulsion.conductance_w_m2k * left * dt;
        let cold = lump.temperature;
        let heat = |area: f64, t: f64| conductance * area * (t - cold);
        let (gained, lost) = lump
            .footprint
            .iter()
            .map(|&(i, area)| heat(area, temperature[i]))
            .fold((0.0, 0.0), |(g, l), q: f64| (g + q.max(0.0), l + q.min(0.0)));
        let warming = lump.mass * model.specific_heat * (melting - lump.temperature);
        let most = warming + lump.mass * model.emulsion.latent_j_kg;
        let net = (gained + lost).min(most);
        // The heat is limited to complete melting.
        let scale = if gained > 0.0 { (net - lost) / gained } else { 1.0 };
        let molten = ((net - warming) / model.emulsion.latent_j_kg).clamp(0.0, lump.mass);
        for &(node, area) in &lump.footprint {
            let q = heat(area, temperature[node]);
            let share = if gained > 0.0 { q.max(0.0) / gained } else { 0.0 };
            let water = model.emulsion.water * molten * share;
            let fat = molten * share - water;
            let heat = if q > 0.0 { q * scale } else { q };
            give(Molten { node, fat, water, temperature: melting, heat }, &mut temperature[node]);
        }
        let sensible = (net - molten * model.emulsion.latent_j_kg) / (lump.mass * model.specific_heat);
        lump.temperature = if molten > 0.0 { melting } else { lump.temperature + sensible };
        lump.mass -= molten;
        if lump.mass <= 1e-12 * lump.whole {
            self.lump = None;
        }
    }

    /// Relaxes the foam towards its equilibrium with the steam of the butter's own water: its share of `boiled` of the
    /// water in the pan, of which `left` is left [kg].
    pub fn froth(&mut self, model: &ButterModel, boiled: f64, left: f64, dt: f64) {
        let own = if boiled > 0.0 { self.water * boiled / (boiled + left) } else { 0.0 };
        self.water = (self.water - own).clamp(0.0, left);
        let steam = own / dt;
        let half = 1e-3 * model.foam.half_g_s;
        let change = 1.0 - libm::exp(-dt / model.foam.time_constant_s);
        self.foam += change * (steam / (steam + half) - self.foam);
    }

    /// Dilutes browning and charring with fresh fat [kg].
    pub fn freshen(&mut self, before: f64, fresh: f64) {
        let share = if before + fresh > 0.0 { before / (before + fresh) } else { 0.0 };
        self.browning *= share;
        self.charring *= share;
    }

    /// Browns the milk solids for `dt` [s]: dB/dt = k_B (1 − B), dC/dt = k_C B (1 − C), implicit Euler with the rates
    /// averaged by mass of fat.
    pub fn brown(
        &mut self,
        model: &ButterModel,
        oil: &OilFilm,
        (water, water_model): (&WaterFilm, &WaterModel),
        bed: &Bed,
        temperature: &[f64],
        dt: f64,
    ) {
        let Some(fat) = oil.fats.iter().find(|f| f.kind == model.kind) else { return };
        let (mut whole, mut brown, mut char) = (0.0, 0.0, 0.0);
        for (i, &mass) in fat.mass.iter().enumerate().filter(|(_, mass)| **mass > 0.0) {
            let wet = water_model.coverage(water.mass[i], bed.areas[i]);
            let rates = model.rates.at(temperature[i], wet);
            whole += mass;
            brown += mass * rates[0];
            char += mass * rates[1];
        }
        if whole > 0.0 {
            self.browning = 1.0 - (1.0 - self.browning) / (1.0 + brown / whole * dt);
            self.charring = 1.0 - (1.0 - self.charring) / (1.0 + char / whole * self.browning * dt);
        }
    }
}
