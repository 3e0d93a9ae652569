//! The film of oil on the pan: how much of which fat lies where. It has the temperature of the metal under it.

use saute_food::ZERO_C;

use crate::bed::Bed;
use crate::film_flow::{FilmFlow, Layer, carry};
use crate::oil::Oil;

/// One kind of fat in the film.
#[derive(Clone, Debug, PartialEq)]
pub struct Fat {
    /// Which oil, as the pan numbers them.
    pub kind: usize,
    /// Mass at each node [kg].
    pub mass: Vec<f64>,
}

/// Oil and fat in the pan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OilFilm {
    /// Kinds that are in the pan.
    pub fats: Vec<Fat>,
    /// Mass of all kinds at each node [kg].
    pub mass: Vec<f64>,
    /// Heat capacity of all kinds at each node [J/K].
    pub capacity: Vec<f64>,
}

/// Scratch space of the film's flow.
#[derive(Clone, Debug, Default)]
pub struct OilSolver {
    flow: FilmFlow,
    thickness: Vec<f64>,
    fluidity: Vec<f64>,
    before: Vec<f64>,
    heat: Vec<f64>,
}

impl OilFilm {
    /// No oil on so many nodes.
    pub fn none(nodes: usize) -> Self {
        Self { fats: Vec::new(), mass: vec![0.0; nodes], capacity: vec![0.0; nodes] }
    }

    /// Mass of all kinds [kg].
    pub fn total(&self) -> f64 {
        self.mass.iter().sum()
    }

    /// Mass of one kind [kg].
    pub fn total_of(&self, kind: usize) -> f64 {
        self.fats.iter().filter(|f| f.kind == kind).flat_map(|f| &f.mass).sum()
    }

    /// Share of a kind in the film at a node [-].
    pub fn share(&self, kind: usize, node: usize) -> f64 {
        let own: f64 = self.fats.iter().filter(|f| f.kind == kind).map(|f| f.mass[node]).sum();
        if own > 0.0 { own / self.mass[node] } else { 0.0 }
    }

    /// Heat above 0 °C [J].
    pub fn stored(&self, temperature: &[f64]) -> f64 {
        self.capacity.iter().zip(temperature).map(|(c, t)| c * (t - ZERO_C)).sum()
    }

    /// Adds fat of one temperature [K] at a node; node and film come to one temperature.
    pub fn add(&mut self, oils: &[Oil], kind: usize, node: usize, mass: f64, source: f64, metal: f64, t: &mut f64) {
        let added = mass * oils[kind].specific_heat;
        let at = self.fats.iter().position(|f| f.kind == kind).unwrap_or_else(|| {
            self.fats.push(Fat { kind, mass: vec![0.0; self.mass.len()] });
            self.fats.len() - 1
        });
        self.fats[at].mass[node] += mass;
        self.mass[node] += mass;
        self.capacity[node] += added;
        *t += added * (source - *t) / (metal + self.capacity[node]);
    }

    /// Takes oil from a node, all kinds alike, and with it its heat; returns what was there to take [kg] and that heat
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

    /// Moves the film through `dt` [s]; returns what ran over the rim [kg], its heat above 0 °C [J] and the largest
    /// change of thickness [m].
    pub fn flow(
        &mut self,
        solver: &mut OilSolver,
        bed: &Bed,
        oils: &[Oil],
        clinging: f64,
        gravity: [f64; 3],
        metal: &[f64],
        temperature: &mut [f64],
        dt: f64,
    ) -> (f64, f64, f64) {
        let mut total = (0.0, 0.0, 0.0_f64);
        let whole = self.total();
        if whole <= 0.0 {
            return total;
        }
        let density = self.set_fluidity(solver, oils, temperature, whole);
        solver.flow.lean(bed, gravity);
        let mut sweeps = 0;
        let mut done = 0;
        while done == 0 || done < sweeps {
            solver.thickness.clear();
            solver.thickness.extend(self.mass.iter().zip(&bed.areas).map(|(m, a)| m / (density * a)));
            let layer =
                Layer { thickness: &solver.thickness, fluidity: &solver.fluidity, puddle: 0.0, clinging };
            if done == 0 {
                sweeps = solver.flow.sweeps(bed, &layer, gravity, dt);
            }
            let moved = solver.flow.sweep(bed, &layer, gravity, dt / f64::from(sweeps));
            total.1 += self.carry_heat(solver, bed, metal, temperature);
            total.0 += carry(bed, &solver.flow, &mut self.mass, &mut solver.before);
            carry(bed, &solver.flow, &mut self.capacity, &mut solver.before);
            for fat in &mut self.fats {
                carry(bed, &solver.flow, &mut fat.mass, &mut solver.before);
            }
            total.2 = total.2.max(moved);
            done += 1;
        }
        total
    }

    /// One over the kinematic viscosity at each node, and the film's density at its mean temperature [kg/m³].
    ///
    /// Fluidities of a blend add by mass (Bingham). One density for the whole film: hydrostatics level the mass over each
    /// area, not the height, where the pan is hot in one place.
    fn set_fluidity(&self, solver: &mut OilSolver, oils: &[Oil], temperature: &[f64], whole: f64) -> f64 {
        let mean = self.mass.iter().zip(temperature).map(|(m, t)| m * t).sum::<f64>() / whole;
        solver.fluidity.clear();
        solver.fluidity.resize(temperature.len(), 0.0);
        let mut volume = 0.0;
        for fat in &self.fats {
            let (oil, mass) = (&oils[fat.kind], fat.mass.iter().sum::<f64>());
            volume += mass / oil.density(mean);
            let share = mass / whole;
            solver.fluidity.iter_mut().zip(temperature).for_each(|(f, t)| *f += share * oil.fluidity(*t));
        }
        let density = whole / volume;
        solver.fluidity.iter_mut().for_each(|f| *f *= density);
        density
    }

    /// Heat that the passing oil brings: it mixes with what it joins and with the metal there. Returns what the oil that
    /// ran over the rim took along, above 0 °C [J].
    fn carry_heat(&self, solver: &mut OilSolver, bed: &Bed, metal: &[f64], temperature: &mut [f64]) -> f64 {
        solver.heat.clear();
        solver.heat.resize(temperature.len(), 0.0);
        solver.before.clear();
        solver.before.extend_from_slice(&self.capacity);
        for (&passed, edge) in solver.flow.passed.iter().zip(&bed.edges).filter(|(passed, _)| **passed != 0.0) {
            let (from, to) = if passed > 0.0 { (edge.a, edge.b) } else { (edge.b, edge.a) };
            let (from, to) = (from as usize, to as usize);
            let capacity = libm::fabs(passed) * self.capacity[from];
            solver.heat[to] += capacity * (temperature[from] - temperature[to]);
            solver.before[to] += capacity;
            solver.before[from] -= capacity;
        }
        let mut spilled = 0.0;
        for (&share, rim) in solver.flow.spilled.iter().zip(&bed.rim) {
            let i = rim.node as usize;
            spilled += share * self.capacity[i] * (temperature[i] - ZERO_C);
            solver.before[i] -= share * self.capacity[i];
        }
        for (i, heat) in solver.heat.iter().enumerate().filter(|(_, heat)| **heat != 0.0) {
            temperature[i] += heat / (metal[i] + solver.before[i]);
        }
        spilled
    }
}
