//! The steam of a tick by where it rises, from what a kitchen shows.

use std::collections::BTreeMap;

use saute_kitchen::food::water::latent_heat;
use saute_kitchen::{Kitchen, TICK_S, celsius, kelvin};
use saute_sound::Steam;

/// Depth of water at which half of the steam below a food rises through it [m] (chosen: a bubble's size).
const DROWNS_M: f64 = 2e-3;
/// Depth of oil at which half of the steam below a food rises through oil in which it stands [m] (chosen: as the pool in which oil
/// turns over fully).
const DEEP_OIL_M: f64 = 5e-3;
/// Density of water, and of oil at 180 °C [kg/m³].
const WATER_KG_M3: f64 = 1000.0;
const OIL_KG_M3: f64 = 850.0;
/// Temperatures of a pool between which its surface's steam becomes bubbles [°C] (chosen: below it evaporates without a sound).
const BUBBLES_C: [f64; 2] = [92.0, 99.5];
/// Temperature of the floor above which a film of water on it boils [°C].
const BOILS_C: f64 = 100.0;

/// Memory between two ticks.
#[derive(Clone, Debug)]
pub(super) struct SteamHeard {
    /// Heat that each piece had taken from the pan [J], by its key.
    heat_taken: BTreeMap<u32, f64>,
    /// Share of butter's water in the water of the pan [-].
    butter: f64,
}

impl SteamHeard {
    pub(super) fn new(kitchen: &Kitchen) -> Self {
        let heat_taken = kitchen.pieces().iter().map(|piece| (piece.key, piece.heat_taken)).collect();
        Self { heat_taken, butter: butter_share(kitchen).unwrap_or(0.0) }
    }

    /// Returns the flows of the tick that has just ended [kg/s], in the order of [`Steam::ALL`], at a look a number of ticks after the
    /// last one.
    pub(super) fn flows(&mut self, kitchen: &Kitchen, ticks: u64) -> [f64; Steam::ALL.len()] {
        let mut flows = [0.0; Steam::ALL.len()];
        let food = self.below_foods(kitchen, ticks as f64 * TICK_S);
        let ([water, oil], (puddle, cloth)) = (depths(kitchen), kitchen.other_vapour());
        let drowned = water / (water + DROWNS_M);
        let in_oil = oil / (oil + DEEP_OIL_M) * (1.0 - drowned);
        flows[Steam::Water as usize] = drowned * food;
        flows[Steam::Oil as usize] = in_oil * food;
        flows[Steam::Floor as usize] = (1.0 - drowned - in_oil) * food;
        // Under a lid all that boils is heard, also what condenses on it.
        let boiled = kitchen.pan_state().lid.map_or(puddle, |lid| lid.boiled.max(0.0));
        self.add_puddle(kitchen, boiled, &mut flows);
        flows[Steam::Cloth as usize] = cloth;
        flows
    }

    /// Steam that boils off below the foods in the pan [kg/s]: what leaves a food, as far as the heat that it took from below goes.
    /// What dries off its upper face is not heard.
    fn below_foods(&mut self, kitchen: &Kitchen, since_s: f64) -> f64 {
        let latent = latent_heat(kelvin(100.0));
        let mut sum = 0.0;
        for piece in kitchen.pieces() {
            let before = self.heat_taken.insert(piece.key, piece.heat_taken).unwrap_or(piece.heat_taken);
            if piece.in_pan() {
                let most = (piece.heat_taken - before).max(0.0) / latent / since_s;
                sum += piece.vapour_flow.max(piece.early_steam).clamp(0.0, most);
            }
        }
        sum
    }

    /// Shares out the steam of water in the pan [kg/s]: butter's own, a pool's, and that of drops and films.
    fn add_puddle(&mut self, kitchen: &Kitchen, puddle: f64, flows: &mut [f64; Steam::ALL.len()]) {
        self.butter = butter_share(kitchen).unwrap_or(self.butter);
        let pool = kitchen.pan_state().liquids.pool;
        let boils = |from: f64, to: f64, c: f64| ((c - from) / (to - from)).clamp(0.0, 1.0);
        let rest = (1.0 - self.butter) * puddle;
        if pool.mass > 0.0 {
            flows[Steam::Water as usize] += boils(BUBBLES_C[0], BUBBLES_C[1], celsius(pool.temperature)) * rest;
        } else if celsius(kitchen.hottest_temperature()) > BOILS_C {
            flows[Steam::Drip as usize] = rest;
        }
        flows[Steam::Butter as usize] = self.butter * puddle;
    }
}

/// Share of butter's water in the water of the pan [-]; none in a dry pan, where the last share is still valid.
fn butter_share(kitchen: &Kitchen) -> Option<f64> {
    let pan = kitchen.pan_state();
    let water = pan.water_mass();
    (water > 0.0).then(|| (pan.liquids.butter.water / water).clamp(0.0, 1.0))
}

/// Mean depths of the pool of water and of the oil over the floor [m].
fn depths(kitchen: &Kitchen) -> [f64; 2] {
    let (pan, area) = (kitchen.pan_state(), kitchen.pan_model().floor_area);
    [pan.liquids.pool.mass / WATER_KG_M3, pan.oil_mass() / OIL_KG_M3].map(|volume| volume / area)
}

/// Share of the floor that food or liquid damps [-].
pub(super) fn covered(kitchen: &Kitchen) -> f64 {
    let liquid: f64 = depths(kitchen).iter().sum::<f64>() / DROWNS_M;
    kitchen.pan_state().covered.max(liquid).min(1.0)
}
