//! Overheated oil: smoke, flash point and fire.

use saute_food::sourced_table;
use serde::{Deserialize, Serialize};

use crate::kelvin;
use crate::liquids::oil::Oil;
use crate::liquids::oil_film::OilFilm;
use crate::pan::bed::Bed;
use crate::tick::event::EventKind;

sourced_table! {
    /// Smoke and fire of oil.
    SmokeData {
        /// Flux at the smoke point [mg/(m²·s)].
        #[schemars(range(min = 0.0, max = 1e9), example = 1.0)]
        flux_mg_m2s: f64,
        /// Kelvins that double it [K].
        #[schemars(range(min = 1e-3, max = 1000.0), example = 12.0)]
        doubling_k: f64,
        /// Oil that burns once it is on fire [g/(m²·s)].
        #[schemars(range(min = 0.0, max = 1e6), example = 5.0)]
        burning_g_m2s: f64,
    }
}

/// Hysteresis: cooling below a point after which passing it is reported again [K] (chosen).
const HYSTERESIS: f64 = 10.0;
/// Share in the film below which a kind of fat neither smokes nor burns by itself [-] (chosen: a trace).
const TRACE: f64 = 0.02;

/// Smoke and fire of the oil in the pan.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Smoke {
    /// Present flow of smoke [kg/s].
    pub rate: f64,
    /// Oil lost as smoke [kg].
    pub smoked: f64,
    /// Oil burnt [kg].
    pub burnt: f64,
    /// True while the oil burns.
    pub burning: bool,
    smoking: bool,
    flashed: bool,
}

/// Conditions for smoke and fire.
#[derive(Clone, Copy, Debug)]
pub struct OilFire<'a> {
    /// Smoke and fire of oil.
    pub data: &'a SmokeData,
    /// Kinds of oil.
    pub oils: &'a [Oil],
    /// The pan's surface.
    pub bed: &'a Bed,
    /// Temperature of each node [K].
    pub temperature: &'a [f64],
    /// Share of each node under food, where oil neither smokes nor burns; empty by the rules of 2013 [-].
    pub covered: &'a [f64],
    /// True if a lid is on.
    pub lidded: bool,
}

/// Hottest oil relative to the points of its kind: node and excess over each point [K].
#[derive(Clone, Copy)]
struct Hottest {
    node: usize,
    smoke: f64,
    flash: f64,
    fire: f64,
}

impl Smoke {
    /// Removes oil by smoke and fire for `dt` [s] and calls `report` (kind, node) for each onset; returns the removed heat
    /// above 0 °C [J]. A lid extinguishes a fire.
    pub fn advance(
        &mut self,
        over: &OilFire,
        oil: &mut OilFilm,
        dt: f64,
        mut report: impl FnMut(EventKind, usize),
    ) -> f64 {
        self.rate = 0.0;
        let Some(hottest) = hottest(over, oil) else {
            self.burning = false;
            return 0.0;
        };
        let mut begins = |state: &mut bool, excess: f64, kind: EventKind| {
            if excess >= 0.0 && !*state {
                report(kind, hottest.node);
            }
            *state = excess >= if *state { -HYSTERESIS } else { 0.0 };
        };
        begins(&mut self.smoking, hottest.smoke, EventKind::SmokeBegins);
        begins(&mut self.flashed, hottest.flash, EventKind::FlashPoint);
        if over.lidded || hottest.flash < 0.0 {
            self.burning = false;
        } else if hottest.fire >= 0.0 && !self.burning {
            self.burning = true;
            report(EventKind::Fire, hottest.node);
        }
        if hottest.smoke < 0.0 { 0.0 } else { self.consume(over, oil, dt) }
    }

    fn consume(&mut self, over: &OilFire, oil: &mut OilFilm, dt: f64) -> f64 {
        let OilFire { data, oils, bed, .. } = *over;
        let mut heat = 0.0;
        for (i, &t) in over.temperature.iter().enumerate() {
            let flux = smoke_flux(data, oils, oil, i, t);
            if flux <= 0.0 {
                continue;
            }
            let area = (1.0 - over.covered.get(i).copied().unwrap_or(0.0)) * bed.areas[i];
            let (smoked, with_it) = oil.take(i, flux * area * dt, t);
            self.smoked += smoked;
            self.rate += smoked / dt;
            heat += with_it;
            if self.burning && passes(oils, oil, i, t) {
                let (burnt, with_it) = oil.take(i, 1e-3 * data.burning_g_m2s * area * dt, t);
                self.burnt += burnt;
                heat += with_it;
            }
        }
        heat
    }
}

/// Smoke flux at a node [kg/(m²·s)]: each kind by its share, doubling every `doubling_k` above its smoke point.
fn smoke_flux(data: &SmokeData, oils: &[Oil], oil: &OilFilm, node: usize, t: f64) -> f64 {
    if oil.mass[node] <= 0.0 {
        return 0.0;
    }
    let of = |f: &crate::liquids::oil_film::Fat| {
        let excess = t - kelvin(oils[f.kind].description.heat.smoke_c);
        let share = f.mass[node] / oil.mass[node];
        if excess > 0.0 { share * libm::exp2(excess / data.doubling_k) } else { 0.0 }
    };
    1e-6 * data.flux_mg_m2s * oil.fats.iter().map(of).sum::<f64>()
}

/// Returns true if the oil at a node is above the flash point of a kind in it.
fn passes(oils: &[Oil], oil: &OilFilm, node: usize, t: f64) -> bool {
    oil.fats.iter().any(|f| f.mass[node] > TRACE * oil.mass[node] && t > kelvin(oils[f.kind].description.heat.flash_c))
}

fn hottest(over: &OilFire, oil: &OilFilm) -> Option<Hottest> {
    let OilFire { oils, temperature, .. } = *over;
    let mut found: Option<Hottest> = None;
    for fat in &oil.fats {
        let open = |i: &usize| over.covered.get(*i).is_none_or(|covered| *covered < 1.0);
        let there = |i: &usize| fat.mass[*i] > TRACE * oil.mass[*i] && fat.mass[*i] > 0.0 && open(i);
        let at = (0..temperature.len()).filter(there).max_by(|a, b| temperature[*a].total_cmp(&temperature[*b]));
        let Some(node) = at else { continue };
        let heat = &oils[fat.kind].description.heat;
        let [smoke, flash, fire] = [heat.smoke_c, heat.flash_c, heat.fire_c].map(|c| temperature[node] - kelvin(c));
        let so_far = found.unwrap_or(Hottest { node, smoke, flash, fire });
        let node = if smoke > so_far.smoke { node } else { so_far.node };
        found = Some(Hottest {
            node,
            smoke: smoke.max(so_far.smoke),
            flash: flash.max(so_far.flash),
            fire: fire.max(so_far.fire),
        });
    }
    found
}
