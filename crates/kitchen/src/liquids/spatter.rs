//! Spatter: steam that bursts through oil throws drops off, which fly and leave spots where they land.

use std::collections::VecDeque;

use saute_food::noise::uniform;
use saute_food::sourced_table;

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

/// Most events in one tick (chosen: hundred a second are a roar).
const MOST_AT_ONCE: u32 = 10;
/// Spots that are remembered, the latest ones (chosen: a hob that wants wiping).
const MOST_SPOTS: usize = 600;
/// Share of a node under food from which on a drop comes out beside the food [-] (chosen).
const COVERED: f64 = 0.2;
/// Stream of the numbers that say how drops fly, apart from those that say when (chosen).
const FLIGHT_STREAM: u64 = 0xf1_1947;

/// A spot of oil where a drop has landed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// On the pan's wall, or on what the pan stands on.
    pub landing: Landing,
    /// Where: on the wall in the pan's frame, its origin the middle of the floor, else from the middle of the hob's ring [m].
    pub at: [f64; 3],
    /// Radius of the drop [m].
    pub radius: f64,
}

/// What drops fly in and out of during one tick.
#[derive(Clone, Copy, Debug)]
pub struct Around<'a> {
    /// The pan.
    pub vessel: Vessel,
    /// Its middle from that of the ring [m].
    pub middle: [f64; 2],
    /// Share of each node under food [-].
    pub covered: &'a [f64],
    /// Time at the start of the tick, and its length [s].
    pub time: [f64; 2],
}

/// Drops that fly: a Poisson process whose clock is the steam under oil.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spatter {
    /// Oil that has flown off [kg].
    pub spattered: f64,
    /// Drops on their way.
    pub flights: Vec<DropFlight>,
    /// Spots on the wall and round the pan, the latest last.
    pub spots: VecDeque<Spot>,
    /// Drops that have landed, wherever.
    pub landed: u64,
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
        (bed, around): (&Bed, &Around),
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
            self.throw(bed, around, node, gone);
            tell(if pop { EventKind::Pop } else { EventKind::Spatter }, node, gone);
        }
        heat
    }

    /// Lets what has flown long enough land by a moment [s].
    pub fn land(&mut self, around: &Around, now: f64) {
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

    /// Sends a drop on its way from a node, or from the food's edge nearest to it.
    fn throw(&mut self, bed: &Bed, around: &Around, node: usize, mass: f64) {
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

/// Where a drop that bursts at a node comes into the open, and the way there from under the food that covers the node.
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
