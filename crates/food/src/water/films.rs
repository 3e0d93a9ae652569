//! Exchange of the patches with their contacts or with the air, in blocks of four for SIMD.

use core::array::from_fn;

use serde::{Deserialize, Serialize};

use crate::advance::{Exchange, Surroundings};
use crate::body::patch::Patch;
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::touch::Touch;
use crate::water::air_film::{AirFilm, FreeAir, HOTTEST_WET};

/// Number of patches in a block [-] (chosen: two SIMD vectors of every 64-bit processor).
const TOGETHER: usize = 4;

/// One value for each patch of a block.
type Lanes = [f64; TOGETHER];

/// Films of all patches.
#[derive(Clone, Debug, Default)]
pub(crate) struct Films {
    blocks: Vec<Block>,
    /// Conductances [W/K] and mass transfer coefficients × areas [m³/s] of the blocks.
    rates: Vec<[Lanes; 2]>,
    /// Number of patches [-].
    pub(crate) count: usize,
    /// Length of the steps that the films are prepared for [s].
    step: f64,
}

/// What of a block does not follow from the model: the films about the state at which they were linearised.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct SavedBlock {
    film: FilmLanes,
    rates: [Lanes; 2],
}

/// Up to four consecutive patches.
#[derive(Clone, Copy, Debug)]
struct Block {
    count: usize,
    nodes: [u32; TOGETHER],
    air: [u32; TOGETHER],
    /// True for four patches with consecutive nodes and one air zone: they are computed together.
    together: bool,
    /// Number of patches with a contact that covers them in this tick [-].
    touched: usize,
    /// Heat capacity of the nodes [J/K].
    capacity: Lanes,
    film: FilmLanes,
    step: StepLanes,
}

/// Fields of [`AirFilm`].
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
struct FilmLanes {
    area: Lanes,
    radiant: Lanes,
    density: Lanes,
    slope: Lanes,
    temperature: Lanes,
    latent: Lanes,
    vapour_enthalpy: Lanes,
}

/// Quantities of a step of one length.
#[derive(Clone, Copy, Debug, Default)]
struct StepLanes {
    /// Conductance × time, and its sum with the node's heat capacity [J/K].
    conductance: Lanes,
    whole: Lanes,
    /// Mass transfer coefficient × area × time [m³].
    transfer: Lanes,
    /// Factor by which evaporative cooling reduces the evaporation [-].
    damped: Lanes,
}

/// Node fields that the exchange changes.
struct Nodes<'a> {
    temperature: &'a mut [f64],
    enthalpy: &'a mut [f64],
    water: &'a mut [f64],
}

impl Films {
    /// Linearises the films of all patches about the present state; `capacity` contains the nodes' heat capacities [J/K].
    pub(crate) fn refresh(&mut self, model: &FoodModel, state: &FoodState, around: &Surroundings, capacity: &[f64]) {
        self.blocks.clear();
        self.rates.clear();
        for patches in model.shape.patches.chunks(TOGETHER) {
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
        (self.count, self.step) = (model.shape.patches.len(), f64::NAN);
    }

    /// Returns what does not follow from the model and the nodes' heat capacities.
    pub(crate) fn saved(&self) -> Vec<SavedBlock> {
        self.blocks
            .iter()
            .zip(&self.rates)
            .map(|(block, rates)| SavedBlock { film: block.film, rates: *rates })
            .collect()
    }

    /// Returns the films again; `None` if they are not of this model. The next step prepares its length again.
    pub(crate) fn of_saved(saved: &[SavedBlock], model: &FoodModel, capacity: &[f64]) -> Option<Self> {
        let patches = &model.shape.patches;
        if saved.is_empty() {
            return Some(Self::default());
        }
        if saved.len() != patches.len().div_ceil(TOGETHER) {
            return None;
        }
        let restored = |(patches, saved): (&[Patch], &SavedBlock)| {
            let mut block = Block { film: saved.film, ..Block::of(patches) };
            for (k, patch) in patches.iter().enumerate() {
                block.capacity[k] = *capacity.get(patch.node as usize)?;
            }
            Some(block)
        };
        Some(Self {
            blocks: patches.chunks(TOGETHER).zip(saved).map(restored).collect::<Option<_>>()?,
            rates: saved.iter().map(|block| block.rates).collect(),
            count: patches.len(),
            step: f64::NAN,
        })
    }

    /// Prepares steps of `dt` [s] with the contacts of this tick.
    pub(crate) fn prepare(&mut self, touch: &[Touch], dt: f64) {
        for (block, patches) in self.blocks.iter_mut().zip((0..).step_by(TOGETHER)) {
            let touch = touch.get(patches..).unwrap_or_default().iter().take(block.count);
            block.touched = touch.filter(|t| t.covers()).count();
        }
        if self.step != dt {
            self.step = dt;
            self.blocks.iter_mut().zip(&self.rates).for_each(|(block, rates)| block.prepare(rates, dt));
        }
    }

    /// Exchanges heat with the contacts, or heat and vapour with the air, in a step of `dt` [s].
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
            let heat = contact_heat.get_mut(from..).unwrap_or_default();
            if block.together && block.touched == 0 {
                block.air_together(&mut nodes, around, &mut sums);
            } else if block.together && block.touched == TOGETHER {
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
            touched: 0,
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
            // Implicit in the temperature, which falls as water evaporates: no overshoot below the wet-bulb temperature.
            self.step.damped[k] = 1.0 + transfer * film.slope[k] * film.latent[k] / self.capacity[k];
        }
    }

    /// Exchanges heat and vapour of four patches with the air (Robin boundary).
    #[inline]
    fn air_together(&self, nodes: &mut Nodes, around: &Surroundings, total: &mut Exchange) {
        let (film, step, capacity, air) = (&self.film, &self.step, &self.capacity, &around.air[self.air[0] as usize]);
        let Some([mut t, mut h, mut w]) = nodes.from(self.nodes[0] as usize) else { return };
        let (mut given, mut mass, mut enthalpy) = ([0.0; TOGETHER], [0.0; TOGETHER], [0.0; TOGETHER]);
        for k in 0..TOGETHER {
            let change = step.conductance[k] * (seen(air, film.radiant[k]) - t[k]) / step.whole[k];
            t[k] += change;
            given[k] = capacity[k] * change;
            h[k] += given[k];
            let surface = if t[k] < HOTTEST_WET { t[k] } else { HOTTEST_WET };
            let density = film.density[k] + film.slope[k] * (surface - film.temperature[k]);
            let gone = step.transfer[k] * (density - air.vapour_density) / step.damped[k];
            mass[k] = clamped(gone, 0.2 * w[k]);
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

    /// Exchanges heat of four patches with their contacts.
    #[inline]
    fn touch_together(&self, nodes: &mut Nodes, touch: &[Touch], dt: f64, heat: &mut [f64]) {
        let Some([mut t, mut h, w]) = nodes.from(self.nodes[0] as usize) else { return };
        let conductance: Lanes = from_fn(|k| touch[k].conductance() * self.film.area[k] * dt);
        let outside: Lanes = from_fn(|k| touch[k].temperature());
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

    /// Exchanges each patch on its own: for blocks with and without contact, or with shared nodes.
    fn exchange_one_by_one(
        &self,
        nodes: &mut Nodes,
        (touch, around): (&[Touch], &Surroundings),
        dt: f64,
        heat: &mut [f64],
        total: &mut Exchange,
    ) {
        (0..self.count).for_each(|k| match touch.get(k) {
            Some(touch) if touch.covers() => {
                let conductance = touch.conductance() * self.film.area[k] * dt;
                heat[k] += self.gain(nodes, k, [conductance, self.capacity[k] + conductance], touch.temperature());
            }
            _ => self.exchange_air(nodes, k, around, total),
        });
    }

    /// Exchanges heat of a patch with `outside` [K] implicitly; returns the heat gained [J].
    ///
    /// The conductance × time is given alone and as its sum with the node's heat capacity [J/K].
    fn gain(&self, nodes: &mut Nodes, k: usize, [conductance, whole]: [f64; 2], outside: f64) -> f64 {
        let node = self.nodes[k] as usize;
        let change = conductance * (outside - nodes.temperature[node]) / whole;
        nodes.temperature[node] += change;
        nodes.enthalpy[node] += self.capacity[k] * change;
        self.capacity[k] * change
    }

    /// Exchanges heat and vapour of a patch with the air (Robin boundary).
    fn exchange_air(&self, nodes: &mut Nodes, k: usize, around: &Surroundings, total: &mut Exchange) {
        let (film, step, air, node) =
            (&self.film, &self.step, &around.air[self.air[k] as usize], self.nodes[k] as usize);
        total.air -= self.gain(nodes, k, [step.conductance[k], step.whole[k]], seen(air, film.radiant[k]));
        let surface = nodes.temperature[node].min(HOTTEST_WET);
        let density = film.density[k] + film.slope[k] * (surface - film.temperature[k]);
        let gone = step.transfer[k] * (density - air.vapour_density) / step.damped[k];
        let mass = clamped(gone, 0.2 * nodes.water[node]);
        let enthalpy = mass * film.vapour_enthalpy[k];
        nodes.water[node] -= mass;
        nodes.enthalpy[node] -= enthalpy;
        nodes.temperature[node] -= mass * film.latent[k] / self.capacity[k];
        total.evaporated += mass;
        total.evaporation += enthalpy;
    }
}

/// Mean temperature of air and walls, given the share of radiation [K]; exactly the air's where the walls have it.
#[inline]
fn seen(air: &FreeAir, radiant: f64) -> f64 {
    air.temperature + radiant * (air.walls - air.temperature)
}

/// Clamps a mass to ±`most` [kg]; without the checks of `clamp`, which prevent vectorisation. A negative mass condenses.
#[inline]
fn clamped(mass: f64, most: f64) -> f64 {
    let mass = if mass < -most { -most } else { mass };
    if mass > most { most } else { mass }
}

impl Nodes<'_> {
    /// Returns temperatures, enthalpies and water of four nodes from `first` on.
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
        self.radiant[k] = film.radiant;
        self.density[k] = film.density;
        self.slope[k] = film.slope;
        self.temperature[k] = film.temperature;
        self.latent[k] = film.latent;
        self.vapour_enthalpy[k] = film.vapour_enthalpy;
    }
}
