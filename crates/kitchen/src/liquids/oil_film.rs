//! The oil film on the pan: mass of each kind of fat at each node, at the temperature of the metal below.

use saute_food::ZERO_C;
use serde::{Deserialize, Serialize};

use crate::liquids::film_flow::{FilmFlow, Manner, Run, Sweep};
use crate::liquids::oil::Oil;
use crate::pan::bed::Bed;

/// One kind of fat in the film.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Fat {
    /// Index among the pan's oils.
    pub kind: usize,
    /// Mass at each node [kg].
    pub mass: Vec<f64>,
}

/// Oil and fat in the pan.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct OilFilm {
    /// Kinds of fat in the pan.
    pub fats: Vec<Fat>,
    /// Mass of all kinds at each node [kg].
    pub mass: Vec<f64>,
    /// Heat capacity of all kinds at each node [J/K].
    pub capacity: Vec<f64>,
}

/// An amount of fat to be added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dose {
    /// Index among the pan's oils.
    pub kind: usize,
    /// Mass [kg].
    pub mass: f64,
    /// Temperature [K].
    pub temperature: f64,
}

/// Surface below the oil.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'a> {
    /// The pan's surface.
    pub bed: &'a Bed,
    /// Kinds of oil.
    pub oils: &'a [Oil],
    /// Heat capacity of the metal at each node [J/K].
    pub metal: &'a [f64],
    /// Residual film on a drained pan [m].
    pub clinging: f64,
}

impl OilFilm {
    /// Keeps a share of the oil everywhere [-].
    pub(crate) fn keep(&mut self, share: f64) {
        let fats = self.fats.iter_mut().flat_map(|fat| fat.mass.iter_mut());
        fats.chain(&mut self.mass).chain(&mut self.capacity).for_each(|amount| *amount *= share);
    }

    /// An empty film on a number of nodes.
    pub fn none(nodes: usize) -> Self {
        Self { fats: Vec::new(), mass: vec![0.0; nodes], capacity: vec![0.0; nodes] }
    }

    /// Mass of all kinds [kg].
    pub fn total(&self) -> f64 {
        self.mass.iter().sum()
    }

    /// Mass of one kind [kg].
    pub fn total_of(&self, kind: usize) -> f64 {
        self.fats.iter().filter(|f| f.kind == kind).flat_map(|f| &f.mass).fold(0.0, |sum, mass| sum + mass)
    }

    /// Heat above 0 °C [J].
    pub fn stored(&self, temperature: &[f64]) -> f64 {
        self.capacity.iter().zip(temperature).map(|(c, t)| c * (t - ZERO_C)).sum()
    }

    /// Adds fat at a node of metal with heat capacity `metal` [J/K] and mixes it to one temperature `t` [K].
    pub fn add(&mut self, oils: &[Oil], node: usize, dose: Dose, metal: f64, t: &mut f64) {
        let added = dose.mass * oils[dose.kind].specific_heat;
        let at = self.fats.iter().position(|f| f.kind == dose.kind).unwrap_or_else(|| {
            self.fats.push(Fat { kind: dose.kind, mass: vec![0.0; self.mass.len()] });
            self.fats.len() - 1
        });
        self.fats[at].mass[node] += dose.mass;
        self.mass[node] += dose.mass;
        self.capacity[node] += added;
        *t += added * (dose.temperature - *t) / (metal + self.capacity[node]);
    }

    /// Removes oil from a node, all kinds in proportion; returns the removed mass [kg], limited to the film, and its heat
    /// above 0 °C [J].
    pub fn take(&mut self, node: usize, mass: f64, temperature: f64) -> (f64, f64) {
        let taken = mass.min(self.mass[node]);
        if taken <= 0.0 {
            return (0.0, 0.0);
        }
        let share = taken / self.mass[node];
        let capacity = share * self.capacity[node];
        self.fats.iter_mut().for_each(|f| f.mass[node] -= share * f.mass[node]);
        self.mass[node] -= taken;
        self.capacity[node] -= capacity;
        (taken, capacity * (temperature - ZERO_C))
    }

    /// Advances the flow of the film by `dt` [s] under gravity in the pan's frame [m/s²].
    pub fn run(
        &mut self,
        flow: &mut FilmFlow,
        on: &Ground,
        gravity: [f64; 3],
        temperature: &mut [f64],
        dt: f64,
    ) -> Run {
        let mut run = Run::default();
        let whole = self.total();
        if whole <= 0.0 {
            return run;
        }
        let density = self.set_fluidity(flow, on.oils, temperature, whole);
        let manner = Manner { density, puddle: 0.0, clinging: on.clinging };
        flow.lean(on.bed, gravity);
        for sweep in Sweep::BOTH {
            run.moved = run.moved.max(flow.sweep(on.bed, &manner, &self.mass, sweep, 0.5 * dt));
            run.spilled_heat += flow.mix(on.bed, &mut self.capacity, on.metal, temperature, ZERO_C);
            for fat in &mut self.fats {
                run.spilled += flow.carry(on.bed, &mut fat.mass);
            }
            self.add_up(on.oils);
        }
        run
    }

    /// Sums masses and heat capacities over all kinds.
    fn add_up(&mut self, oils: &[Oil]) {
        self.mass.fill(0.0);
        self.capacity.fill(0.0);
        for fat in &self.fats {
            let specific_heat = oils[fat.kind].specific_heat;
            for (i, own) in fat.mass.iter().enumerate() {
                self.mass[i] += own;
                self.capacity[i] += own * specific_heat;
            }
        }
    }

    /// Sets the inverse kinematic viscosity at each node; returns the film's density at its mean temperature [kg/m³].
    ///
    /// Fluidities of a blend add by mass (Bingham). The whole film has one density: on an unevenly hot pan hydrostatics
    /// level the mass per area, not the height.
    fn set_fluidity(&self, flow: &mut FilmFlow, oils: &[Oil], temperature: &[f64], whole: f64) -> f64 {
        let mean = self.mass.iter().zip(temperature).map(|(m, t)| m * t).sum::<f64>() / whole;
        flow.fluidity.clear();
        flow.fluidity.resize(temperature.len(), 0.0);
        let mut volume = 0.0;
        for fat in &self.fats {
            let (oil, mass) = (&oils[fat.kind], fat.mass.iter().sum::<f64>());
            volume += mass / oil.density(mean);
            let share = mass / whole;
            flow.fluidity.iter_mut().zip(temperature).for_each(|(f, t)| *f += share * oil.fluidity(*t));
        }
        let density = whole / volume;
        flow.fluidity.iter_mut().for_each(|f| *f *= density);
        density
    }
}
