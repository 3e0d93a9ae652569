//! Spatter: steam that bursts through oil throws drops out of the pan.

use saute_food::noise::uniform;
use saute_food::sourced_table;

use crate::bed::Bed;
use crate::event::EventKind;
use crate::oil_film::OilFilm;

sourced_table! {
    /// Spatter of oil by steam.
    SpatterData {
        /// Drops for each gram of steam that passes through a film of `film_mm` [1/g].
        events_per_g: f64,
        /// Mean mass of a drop [mg].
        droplet_mg: f64,
        /// Share of the events that are pops [-].
        pop_share: f64,
        /// Mean mass that a pop throws out [mg].
        pop_mg: f64,
        /// Film for which the rate is given; it goes with the film's thickness [mm].
        film_mm: f64,
        /// Thickness over that beyond which the rate rises no more [-].
        deepest: f64,
    }
}

/// Density of hot oil with which its depth is reckoned here [kg/m³] (standard tables, 120 °C).
const OIL_DENSITY: f64 = 855.0;
/// Most events in one tick (chosen: hundred a second are a roar).
const MOST_AT_ONCE: u32 = 10;

/// Drops that fly: a Poisson process whose clock is the steam under oil.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spatter {
    /// Oil that has flown out [kg].
    pub spattered: f64,
    /// Stream of the random numbers.
    seed: u64,
    drawn: u64,
    /// Expected events until the next one [-].
    wait: f64,
}

impl Spatter {
    /// Nothing has flown yet; the same seed throws the same drops.
    pub fn seeded(seed: u64) -> Self {
        Self { seed, ..Self::default() }
    }

    /// Throws out what the tick's `steam` [kg at each node] throws out, and tells it (kind, node, mass); returns the heat
    /// that left above 0 °C [J].
    pub fn advance(
        &mut self,
        data: &SpatterData,
        bed: &Bed,
        oil: &mut OilFilm,
        temperature: &[f64],
        steam: &[f64],
        mut tell: impl FnMut(EventKind, usize, f64),
    ) -> f64 {
        let whole: f64 = (0..steam.len()).map(|i| bursting(data, bed, oil, steam, i)).sum();
        if whole <= 0.0 {
            return 0.0;
        }
        if self.drawn == 0 {
            self.wait = self.exponential();
        }
        self.wait -= 1e3 * data.events_per_g * whole;
        let mut heat = 0.0;
        let mut thrown = 0;
        while self.wait < 0.0 {
            self.wait += self.exponential();
            thrown += 1;
            if thrown > MOST_AT_ONCE {
                continue;
            }
            let pop = self.draw() < data.pop_share;
            let mean = 1e-6 * if pop { data.pop_mg } else { data.droplet_mg };
            let place = self.draw() * whole;
            let mass = mean * self.exponential();
            let node = place_of(place, steam.len(), |i| bursting(data, bed, oil, steam, i));
            let (gone, with_it) = oil.take(node, mass, temperature[node]);
            self.spattered += gone;
            heat += with_it;
            tell(if pop { EventKind::Pop } else { EventKind::Spatter }, node, gone);
        }
        heat
    }

    fn draw(&mut self) -> f64 {
        self.drawn += 1;
        uniform(self.seed, self.drawn)
    }

    /// Exponentially distributed with mean 1.
    fn exponential(&mut self) -> f64 {
        -libm::log(1.0 - self.draw())
    }
}

/// Steam at a node, weighted with the depth of the oil that it bursts through [kg].
fn bursting(data: &SpatterData, bed: &Bed, oil: &OilFilm, steam: &[f64], node: usize) -> f64 {
    if steam[node] <= 0.0 {
        return 0.0;
    }
    let film = oil.mass[node] / (OIL_DENSITY * bed.areas[node]);
    steam[node] * (film / (1e-3 * data.film_mm)).min(data.deepest)
}

/// The node at which the running sum of `weight` passes `place`.
fn place_of(place: f64, nodes: usize, weight: impl Fn(usize) -> f64) -> usize {
    let mut sum = 0.0;
    let mut last = 0;
    for (i, w) in (0..nodes).map(|i| (i, weight(i))).filter(|(_, w)| *w > 0.0) {
        sum += w;
        last = i;
        if sum > place {
            break;
        }
    }
    last
}
