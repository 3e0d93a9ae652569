//! A solver without what follows from model and state, to be stored.
//!
//! Conductances follow from the conductivities, the films' capacities from the nodes', and the sound state differs from
//! the state in little more than the oil on its surface. What is left restores the solver bit by bit.

use serde::{Deserialize, Serialize};

use super::FoodSolver;
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::films::{Films, SavedBlock};

/// What of a [`FoodSolver`] does not follow from its model and its state.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct SavedSolver {
    /// Conductivity across and along the fibres, times the stretch ratios [W/(m·K)].
    conductivity: [Vec<f64>; 2],
    /// Heat capacity of each node [J/K].
    capacity: Vec<f64>,
    films: Vec<SavedBlock>,
    sound: Option<SavedSound>,
    contact_heat: Vec<f64>,
    substeps: u32,
}

/// The sound state as its differences from the state.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct SavedSound {
    /// Node fields that differ.
    fields: Vec<Option<Vec<f64>>>,
    /// What belongs to no node.
    scalars: [f64; 8],
    ticks: u64,
    healthy: bool,
}

/// Returns true if two fields are the same bit by bit.
fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

impl SavedSound {
    fn of(sound: &FoodState, state: &FoodState) -> Self {
        let differing = |(sound, state): (&Vec<f64>, &Vec<f64>)| (!same_bits(sound, state)).then(|| sound.clone());
        Self {
            fields: sound.fields().into_iter().zip(state.fields()).map(differing).collect(),
            scalars: sound.scalars(),
            ticks: sound.ticks,
            healthy: sound.healthy,
        }
    }

    fn restored(self, state: &FoodState) -> Option<FoodState> {
        let mut sound = state.clone();
        let mut fields = sound.fields_mut();
        if fields.len() != self.fields.len() {
            return None;
        }
        for (field, saved) in fields.iter_mut().zip(self.fields) {
            **field = saved.unwrap_or_else(|| std::mem::take(*field));
        }
        sound.set_scalars(self.scalars);
        (sound.ticks, sound.healthy) = (self.ticks, self.healthy);
        Some(sound)
    }
}

impl FoodSolver {
    /// Returns what does not follow from the model and the state of its piece.
    pub fn saved(&self, state: &FoodState) -> SavedSolver {
        SavedSolver {
            conductivity: self.conductivity.clone(),
            capacity: self.capacity.clone(),
            films: self.films.saved(),
            sound: self.sound.as_ref().map(|sound| SavedSound::of(sound, state)),
            contact_heat: self.contact_heat.clone(),
            substeps: self.substeps,
        }
    }

    /// Returns a solver again that goes on exactly as the saved one; `None` if it was not of this model and state.
    pub fn of_saved(saved: SavedSolver, model: &FoodModel, state: &FoodState) -> Option<Self> {
        let n = model.shape.mesh.node_count();
        let begun = !saved.capacity.is_empty();
        let length = if begun { n } else { 0 };
        let fields = saved.conductivity.iter().chain([&saved.capacity]);
        if fields.into_iter().any(|field| field.len() != length) || (begun && saved.substeps == 0) {
            return None;
        }
        let sound = match saved.sound {
            Some(sound) => Some(sound.restored(state).filter(|sound| sound.fits(model))?),
            None => None,
        };
        let mut solver = Self {
            films: Films::of_saved(&saved.films, model, &saved.capacity)?,
            conductivity: saved.conductivity,
            per_capacity: saved.capacity.iter().map(|capacity| 1.0 / capacity).collect(),
            capacity: saved.capacity,
            power: vec![0.0; length],
            hot: Vec::with_capacity(length),
            sound,
            contact_heat: saved.contact_heat,
            substeps: saved.substeps,
            ..Self::default()
        };
        if begun {
            solver.set_conductances(model);
        }
        Some(solver)
    }
}
