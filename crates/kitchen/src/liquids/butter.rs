//! Butter: a piece melts, its water boils off in foam, its milk solids brown and then char.

use saute_food::ZERO_C;
use saute_food::sourced_table;

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

/// What never changes about butter.
#[derive(Clone, Debug)]
pub struct ButterModel {
    /// Which oil its fat is, as the pan numbers them; the fat carries its milk solids with it.
    pub kind: usize,
    emulsion: Emulsion,
    /// Specific heat of the whole [J/(kg·K)].
    specific_heat: f64,
    density: f64,
    rates: SolidsRates,
    foam: FoamData,
}

/// A piece of butter that has not molten yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Lump {
    /// Mass [kg].
    pub mass: f64,
    /// Temperature [K].
    pub temperature: f64,
    /// Nodes on which it lies, and the area of each that it covered at first [m²].
    pub footprint: Vec<(usize, f64)>,
    /// Mass that covered those [kg].
    pub whole: f64,
}

/// Butter in the pan, but for its fat and its water, which lie with the oil and the water.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Butter {
    /// Piece that is left.
    pub lump: Option<Lump>,
    /// Foam, 0 none – 1 the pan full [-].
    pub foam: f64,
    /// Browning of the milk solids, 0–1 [-].
    pub browning: f64,
    /// Charring of the milk solids, 0–1 [-].
    pub charring: f64,
}

/// What a piece gives off at one node in one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Molten {
    /// Where.
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

impl ButterModel {
    /// From the oil that is butter; none where that has no water and milk solids.
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

    /// Share of milk solids in what lies with the oil [-].
    pub fn solids_share(&self) -> f64 {
        self.emulsion.solids / (1.0 - self.emulsion.water)
    }

    /// Enthalpy of a piece above molten butter at 0 °C [J].
    pub fn stored(&self, lump: &Lump) -> f64 {
        lump.mass * (self.specific_heat * (lump.temperature - ZERO_C) - self.emulsion.latent_j_kg)
    }
}

impl Butter {
    /// Lays a piece on the floor, as near to its middle as nothing `covers` it; a piece that lies there already joins it.
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

    /// Warms and melts the piece for `dt` [s] on a pan of these temperatures [K], and tells what each node gets and gives,
    /// with that node's temperature.
    pub fn melt(
        &mut self,
        model: &ButterModel,
        temperature: &mut [f64],
        dt: f64,
        mut give: impl FnMut(Molten, &mut f64),
    ) {
        let Some(lump) = &mut self.lump else { return };
        let melting = kelvin(model.emulsion.melting_c);
        // It grows thinner as well as narrower.
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
        // A piece takes no more than it needs to melt altogether.
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

    /// Foam rises with the steam that passes through butter [kg/s] and subsides without it.
    pub fn froth(&mut self, model: &ButterModel, steam: f64, dt: f64) {
        let half = 1e-3 * model.foam.half_g_s;
        let change = 1.0 - libm::exp(-dt / model.foam.time_constant_s);
        self.foam += change * (steam / (steam + half) - self.foam);
    }

    /// Fresh fat joins what is browned already [kg].
    pub fn freshen(&mut self, before: f64, fresh: f64) {
        let share = if before + fresh > 0.0 { before / (before + fresh) } else { 0.0 };
        self.browning *= share;
        self.charring *= share;
    }

    /// Browns the milk solids for `dt` [s]: dB/dt = k_B (1 − B), dC/dt = k_C B (1 − C), with the mean of the rates over
    /// where the fat lies.
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
