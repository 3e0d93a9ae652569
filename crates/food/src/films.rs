//! Exchange of a piece's patches with what they touch or with the air, prepared between refreshes; patches whose nodes
//! follow each other are moved four at once.

use core::array::from_fn;

use crate::advance::{Exchange, Surroundings, Touch};
use crate::air_film::{AirFilm, HOTTEST_WET};
use crate::model::FoodModel;
use crate::patch::Patch;
use crate::state::FoodState;

/// Patches in a block (chosen: two vectors of the plainest 64-bit processor).
const TOGETHER: usize = 4;

/// One value for each patch of a block.
type Lanes = [f64; TOGETHER];

/// The films of all patches.
#[derive(Clone, Debug, Default)]
pub(crate) struct Films {
    blocks: Vec<Block>,
    /// Conductances [W/K] and mass transfer coefficients times areas [m³/s] of the blocks.
    rates: Vec<[Lanes; 2]>,
    /// How many patches there are.
    pub(crate) count: usize,
    /// Length of the steps for which they are prepared [s].
    step: f64,
}

/// Up to four patches, one after the other.
#[derive(Clone, Copy, Debug)]
struct Block {
    count: usize,
    nodes: [u32; TOGETHER],
    air: [u32; TOGETHER],
    /// Whether there are four, whose nodes follow each other, with one air before them.
    together: bool,
    /// Heat capacity of the nodes [J/K].
    capacity: Lanes,
    film: FilmLanes,
    step: StepLanes,
}

/// Fields of [`AirFilm`].
#[derive(Clone, Copy, Debug, Default)]
struct FilmLanes {
    area: Lanes,
    density: Lanes,
    slope: Lanes,
    temperature: Lanes,
    latent: Lanes,
    vapour_enthalpy: Lanes,
}

/// What holds for steps of one length.
#[derive(Clone, Copy, Debug, Default)]
struct StepLanes {
    /// Conductance times time, and that and the node's heat capacity together [J/K].
    conductance: Lanes,
    whole: Lanes,
    /// Volume of air that takes up vapour [m³].
    transfer: Lanes,
    /// By what evaporation is slowed down as it cools the node [-].
    damped: Lanes,
}

/// Fields of the nodes that change as they exchange heat and vapour.
struct Nodes<'a> {
    temperature: &'a mut [f64],
    enthalpy: &'a mut [f64],
    water: &'a mut [f64],
}

impl Films {
    /// Takes the films of all patches as they are now, whose nodes have these heat capacities [J/K].
    pub(crate) fn refresh(&mut self, model: &FoodModel, state: &FoodState, around: &Surroundings, capacity: &[f64]) {
        self.blocks.clear();
        self.rates.clear();
        for patches in model.patches.chunks(TOGETHER) {
            let (mut block, mut rates) = (Block::of(patches), [[0.0; TOGETHER]; 2]);
            for (k, patch) in patches.iter().enumerate() {
                let film = AirFilm::of(model, state, patch, &around.air[patch.air]);
                (rates[0][k], rates[1][k]) = (film.heat, film.transfer);
                block.capacity[k] = capacity[patch.node as usize];
                block.film.set(k, &film);
            }
            self.blocks.push(block);
            self.rates.push(rates);
        }
        (self.count, self.step) = (model.patches.len(), f64::NAN);
    }

    /// Prepares steps of `dt` [s].
    pub(crate) fn prepare(&mut self, dt: f64) {
        if self.step != dt {
            self.step = dt;
            self.blocks.iter_mut().zip(&self.rates).for_each(|(block, rates)| block.prepare(rates, dt));
        }
    }

    /// Heat and vapour through every patch in a step of `dt` [s]: from what it touches, or with the air.
    pub(crate) fn exchange(
        &self,
        state: &mut FoodState,
        around: &Surroundings,
        dt: f64,
        contact_heat: &mut [f64],
        total: &mut Exchange,
    ) {
        let FoodState { temperature, enthalpy, water, .. } = state;
        let mut nodes = Nodes { temperature, enthalpy, water };
        let mut sums = *total;
        let mut from = 0;
        for block in &self.blocks {
            let touch = around.touch.get(from..).unwrap_or_default();
            let touch = &touch[..touch.len().min(block.count)];
            let touched = touch.iter().filter(|t| t.conductance > 0.0).count();
            let heat = contact_heat.get_mut(from..).unwrap_or_default();
            if block.together && touched == 0 {
                block.breathe_together(&mut nodes, around, &mut sums);
            } else if block.together && touched == TOGETHER {
                block.touch_together(&mut nodes, touch, dt, heat);
            } else {
                block.exchange_one_by_one(&mut nodes, (touch, around), dt, heat, &mut sums);
            }
            from += block.count;
        }
        *total = sums;
    }
}

impl Block {
    fn of(patches: &[Patch]) -> Self {
        let mut block = Self {
            count: patches.len(),
            nodes: [0; TOGETHER],
            air: [0; TOGETHER],
            together: false,
            capacity: [1.0; TOGETHER],
            film: FilmLanes::default(),
            step: StepLanes::default(),
        };
        for (k, patch) in patches.iter().enumerate() {
            (block.nodes[k], block.air[k]) = (patch.node, patch.air as u32);
        }
        let follow = block.nodes.windows(2).all(|pair| pair[1] == pair[0] + 1);
        block.together = patches.len() == TOGETHER && follow && block.air.iter().all(|air| *air == block.air[0]);
        block
    }

    fn prepare(&mut self, [heat, volume]: &[Lanes; 2], dt: f64) {
        let film = &self.film;
        for k in 0..TOGETHER {
            let (conductance, transfer) = (heat[k] * dt, volume[k] * dt);
            self.step.conductance[k] = conductance;
            self.step.whole[k] = self.capacity[k] + conductance;
            self.step.transfer[k] = transfer;
            // Implicit in the temperature that falls as water leaves: no overshoot below the wet bulb.
            self.step.damped[k] = 1.0 + transfer * film.slope[k] * film.latent[k] / self.capacity[k];
        }
    }

    /// Four free patches exchange heat and vapour with the air.
    #[inline]
    fn breathe_together(&self, nodes: &mut Nodes, around: &Surroundings, total: &mut Exchange) {
        let (film, step, capacity, air) = (&self.film, &self.step, &self.capacity, &around.air[self.air[0] as usize]);
        let Some([mut t, mut h, mut w]) = nodes.from(self.nodes[0] as usize) else { return };
        let (mut given, mut mass, mut enthalpy) = ([0.0; TOGETHER], [0.0; TOGETHER], [0.0; TOGETHER]);
        for k in 0..TOGETHER {
            let change = step.conductance[k] * (air.temperature - t[k]) / step.whole[k];
            t[k] += change;
            given[k] = capacity[k] * change;
            h[k] += given[k];
            let surface = if t[k] < HOTTEST_WET { t[k] } else { HOTTEST_WET };
            let density = film.density[k] + film.slope[k] * (surface - film.temperature[k]);
            let gone = step.transfer[k] * (density - air.vapour_density) / step.damped[k];
            mass[k] = least_and_most(gone, 0.2 * w[k]);
            enthalpy[k] = mass[k] * film.vapour_enthalpy[k];
            w[k] -= mass[k];
            h[k] -= enthalpy[k];
            t[k] -= mass[k] * film.latent[k] / capacity[k];
        }
        nodes.put(self.nodes[0] as usize, [t, h, w]);
        for k in 0..TOGETHER {
            total.air -= given[k];
            total.evaporated += mass[k];
            total.evaporation += enthalpy[k];
        }
    }

    /// Four patches exchange heat with what they touch.
    #[inline]
    fn touch_together(&self, nodes: &mut Nodes, touch: &[Touch], dt: f64, heat: &mut [f64]) {
        let Some([mut t, mut h, w]) = nodes.from(self.nodes[0] as usize) else { return };
        let conductance: Lanes = from_fn(|k| touch[k].conductance * self.film.area[k] * dt);
        let outside: Lanes = from_fn(|k| touch[k].temperature);
        let mut gained = [0.0; TOGETHER];
        for k in 0..TOGETHER {
            let change = conductance[k] * (outside[k] - t[k]) / (self.capacity[k] + conductance[k]);
            t[k] += change;
            gained[k] = self.capacity[k] * change;
            h[k] += gained[k];
        }
        nodes.put(self.nodes[0] as usize, [t, h, w]);
        heat.iter_mut().zip(gained).for_each(|(heat, gained)| *heat += gained);
    }

    /// Patches that touch something and free ones, or that share nodes.
    fn exchange_one_by_one(
        &self,
        nodes: &mut Nodes,
        (touch, around): (&[Touch], &Surroundings),
        dt: f64,
        heat: &mut [f64],
        total: &mut Exchange,
    ) {
        (0..self.count).for_each(|k| match touch.get(k) {
            Some(touch) if touch.conductance > 0.0 => {
                let conductance = touch.conductance * self.film.area[k] * dt;
                heat[k] += self.gain(nodes, k, [conductance, self.capacity[k] + conductance], touch.temperature);
            }
            _ => self.breathe(nodes, k, around, total),
        });
    }

    /// Brings a patch's node towards `outside` [K] through a conductance times time, given alone and with the node's heat
    /// capacity [J/K], implicitly; returns the heat gained [J].
    fn gain(&self, nodes: &mut Nodes, k: usize, [conductance, whole]: [f64; 2], outside: f64) -> f64 {
        let node = self.nodes[k] as usize;
        let change = conductance * (outside - nodes.temperature[node]) / whole;
        nodes.temperature[node] += change;
        nodes.enthalpy[node] += self.capacity[k] * change;
        self.capacity[k] * change
    }

    /// A free patch exchanges heat and vapour with the air.
    fn breathe(&self, nodes: &mut Nodes, k: usize, around: &Surroundings, total: &mut Exchange) {
        let (film, step, air, node) =
            (&self.film, &self.step, &around.air[self.air[k] as usize], self.nodes[k] as usize);
        total.air -= self.gain(nodes, k, [step.conductance[k], step.whole[k]], air.temperature);
        let surface = nodes.temperature[node].min(HOTTEST_WET);
        let density = film.density[k] + film.slope[k] * (surface - film.temperature[k]);
        let gone = step.transfer[k] * (density - air.vapour_density) / step.damped[k];
        let mass = least_and_most(gone, 0.2 * nodes.water[node]);
        let enthalpy = mass * film.vapour_enthalpy[k];
        nodes.water[node] -= mass;
        nodes.enthalpy[node] -= enthalpy;
        nodes.temperature[node] -= mass * film.latent[k] / self.capacity[k];
        total.evaporated += mass;
        total.evaporation += enthalpy;
    }
}

/// A mass from none to `most` [kg]; without the checks of `clamp`, which keep patches from being moved together.
#[inline]
fn least_and_most(mass: f64, most: f64) -> f64 {
    let mass = if mass < 0.0 { 0.0 } else { mass };
    if mass > most { most } else { mass }
}

impl Nodes<'_> {
    /// Temperatures, enthalpies and water of four nodes from `first` on.
    #[inline]
    fn from(&self, first: usize) -> Option<[Lanes; 3]> {
        let of = |field: &[f64]| field.get(first..)?.first_chunk().copied();
        Some([of(self.temperature)?, of(self.enthalpy)?, of(self.water)?])
    }

    #[inline]
    fn put(&mut self, first: usize, fields: [Lanes; 3]) {
        for (field, lanes) in [&mut *self.temperature, self.enthalpy, self.water].into_iter().zip(fields) {
            field[first..first + TOGETHER].copy_from_slice(&lanes);
        }
    }
}

impl FilmLanes {
    fn set(&mut self, k: usize, film: &AirFilm) {
        self.area[k] = film.area;
        self.density[k] = film.density;
        self.slope[k] = film.slope;
        self.temperature[k] = film.temperature;
        self.latent[k] = film.latent;
        self.vapour_enthalpy[k] = film.vapour_enthalpy;
    }
}
