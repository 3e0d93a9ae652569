//! Spatter: steam that bursts through oil ejects drops, which fly and leave spots where they land.

use std::collections::VecDeque;

use saute_food::sourced_table;
use saute_food::tissue::noise::uniform;
use serde::{Deserialize, Serialize};

use crate::liquids::drop_flight::{DropFlight, Landing, OIL_DENSITY, Vessel};
use crate::liquids::oil_film::OilFilm;
use crate::pan::bed::Bed;
use crate::tick::event::EventKind;

sourced_table! {
    /// Spatter of oil by steam.
    SpatterData {
        /// Drops for each gram of steam that passes through a film of `film_mm` [1/g].
        #[schemars(range(min = 0.0, max = 1e6), example = 20.0)]
        events_per_g: f64,
        /// Mean mass of a drop [mg].
        #[schemars(range(min = 1e-6, max = 1e4), example = 0.1)]
        droplet_mg: f64,
        /// Share of the events that are pops [-].
        #[schemars(range(min = 0.0, max = 1.0), example = 0.1)]
        pop_share: f64,
        /// Mean mass that a pop throws out [mg].
        #[schemars(range(min = 1e-6, max = 1e4), example = 0.6)]
        pop_mg: f64,
        /// Film for which the rate is given; it goes with the film's thickness [mm].
        #[schemars(range(min = 1e-6, max = 100.0), example = 0.2)]
        film_mm: f64,
        /// Thickness over that beyond which the rate rises no more [-].
        #[schemars(range(min = 0.0, max = 1e6), example = 10.0)]
        deepest: f64,
    }
}

/// Largest number of events in one tick [-] (chosen: a hundred per second are a roar).
const MOST_AT_ONCE: u32 = 10;
/// Largest number of spots kept, the latest ones [-] (chosen: a hob that needs wiping).
const MOST_SPOTS: usize = 600;
/// Covered share of a node above which a drop emerges next to the food [-] (chosen).
const COVERED: f64 = 0.2;
/// Stream of random numbers for the flights, independent of the stream for the times [-] (chosen).
const FLIGHT_STREAM: u64 = 0xf1_1947;

/// A spot of oil left by a drop.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Spot {
    /// Surface: the pan's wall, or the plane below the pan.
    pub landing: Landing,
    /// Place [m]: on the wall in the pan's frame, else relative to the centre of the hob's ring.
    pub at: [f64; 3],
    /// Radius of the drop [m].
    pub radius: f64,
}

/// Surroundings of flying drops during one tick.
#[derive(Clone, Copy, Debug)]
pub struct DropSurroundings<'a> {
    /// Geometry of the pan.
    pub vessel: Vessel,
    /// Centre of the pan relative to that of the ring [m].
    pub middle: [f64; 2],
    /// Share of each node under food [-].
    pub covered: &'a [f64],
    /// Start and length of the tick [s].
    pub time: [f64; 2],
}

/// Spatter as a Poisson process whose rate follows the steam under oil.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Spatter {
    /// Oil lost as drops [kg].
    pub spattered: f64,
    /// Drops in flight.
    pub flights: Vec<DropFlight>,
    /// Spots on the wall and around the pan, the latest last.
    pub spots: VecDeque<Spot>,
    /// Number of drops that have landed [-].
    pub landed: u64,
    /// Stream of the random numbers.
    seed: u64,
    drawn: u64,
    /// Expected number of events until the next one [-].
    wait: f64,
}

impl Spatter {
    /// Initial state; equal seeds give equal drops.
    pub fn seeded(seed: u64) -> Self {
        Self { seed, ..Self::default() }
    }

    /// Ejects drops for the tick's `steam` at each node [kg] and calls `report` (kind, node, mass) for each; returns the
    /// removed heat above 0 °C [J].
    pub fn advance(
        &mut self,
        data: &SpatterData,
        (bed, around): (&Bed, &DropSurroundings),
        oil: &mut OilFilm,
        temperature: &[f64],
        steam: &[f64],
        mut report: impl FnMut(EventKind, usize, f64),
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
            self.throw(bed, around, node, gone);
            report(if pop { EventKind::Pop } else { EventKind::Spatter }, node, gone);
        }
        heat
    }

    /// Lands the drops whose flight has ended by the time `now` [s].
    pub fn land(&mut self, around: &DropSurroundings, now: f64) {
        let Self { flights, spots, landed, .. } = self;
        flights.retain(|flight| {
            if flight.thrown_s + flight.lasts_s > now {
                return true;
            }
            *landed += 1;
            let [x, y, z] = flight.end();
            let at = match flight.landing {
                Landing::Floor => return false,
                Landing::Wall => [x, y, z],
                Landing::Outside => [x + around.middle[0], y + around.middle[1], 0.0],
            };
            if spots.len() == MOST_SPOTS {
                spots.pop_front();
            }
            spots.push_back(Spot { landing: flight.landing, at, radius: flight.radius });
            false
        });
    }

    /// Launches a drop from a node, or from the nearest edge of the food that covers it.
    fn throw(&mut self, bed: &Bed, around: &DropSurroundings, node: usize, mass: f64) {
        let first = 4 * (self.landed + self.flights.len() as u64);
        let chance = |k: u64| uniform(self.seed ^ FLIGHT_STREAM, first + k);
        let [start, length] = around.time;
        let (from, out) = way_out(bed, around.covered, node);
        let when = start + length * chance(3);
        let flight = DropFlight::thrown((when, mass), from, out, [0, 1, 2].map(chance), &around.vessel);
        self.flights.push(flight);
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

/// Place where a drop from a node emerges, and the direction to it from under the food that covers the node.
fn way_out(bed: &Bed, covered: &[f64], node: usize) -> ([f64; 3], Option<[f64; 2]>) {
    let from = bed.places[node];
    let is_covered = |i: usize| covered.get(i).is_some_and(|share| *share > COVERED);
    if !is_covered(node) {
        return (from, None);
    }
    let away = |p: &[f64; 3]| libm::hypot(p[0] - from[0], p[1] - from[1]);
    let open = (0..bed.places.len()).filter(|i| !is_covered(*i)).map(|i| bed.places[i]);
    match open.min_by(|a, b| away(a).total_cmp(&away(b))) {
        Some(edge) => (edge, Some([edge[0] - from[0], edge[1] - from[1]])),
        None => (from, None),
    }
}

/// Steam at a node, weighted with the depth of the oil above [kg].
fn bursting(data: &SpatterData, bed: &Bed, oil: &OilFilm, steam: &[f64], node: usize) -> f64 {
    if steam[node] <= 0.0 {
        return 0.0;
    }
    let film = oil.mass[node] / (OIL_DENSITY * bed.areas[node]);
    steam[node] * (film / (1e-3 * data.film_mm)).min(data.deepest)
}

/// Returns the node at which the cumulative sum of `weight` exceeds `place`.
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
