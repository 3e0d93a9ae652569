//! The data files behind a kitchen, as hashes: a kitchen is restored with the same ones only.

use serde::{Deserialize, Serialize};

use crate::bytes::bytes_error::BytesError;
use crate::data::library::Library;
use crate::kitchen::{Kitchen, SetupError};

/// Kinds of pan and foods in a kitchen, each with the hash of its data.
#[derive(Debug, Deserialize, PartialEq, Eq, Serialize)]
pub(super) struct Sources {
    pan: (String, u64),
    foods: Vec<(String, u64)>,
}

impl Sources {
    /// Returns those of a kitchen.
    pub(super) fn of(kitchen: &Kitchen) -> Self {
        let mut foods: Vec<_> = kitchen.pieces.iter().map(|piece| (piece.kind.clone(), piece.data_hash)).collect();
        foods.sort();
        foods.dedup();
        Self { pan: (kitchen.fixed.pan_kind.clone(), kitchen.fixed.data_hash), foods }
    }

    /// Checks that a library has the same data.
    pub(super) fn check(&self, library: &Library) -> Result<(), BytesError> {
        let (pan, hash) = &self.pan;
        if !library.pans.contains_key(pan) {
            return Err(SetupError::NoSuchPan(pan.clone(), Library::names(&library.pans)).into());
        }
        if library.pan_hash(pan) != *hash {
            return Err(BytesError::OtherData { what: format!("the data of the kitchen or of the pan \"{pan}\"") });
        }
        for (food, hash) in &self.foods {
            let Some(description) = library.foods.get(food) else {
                return Err(SetupError::NoSuchFood(food.clone(), Library::names(&library.foods)).into());
            };
            if library.food_hash(food, description) != *hash {
                return Err(BytesError::OtherData { what: format!("the data of the food \"{food}\"") });
            }
        }
        Ok(())
    }

    /// Hash of the data of a food in it.
    pub(super) fn food(&self, kind: &str) -> Option<u64> {
        self.foods.iter().find(|(known, _)| known == kind).map(|(_, hash)| *hash)
    }

    /// Kind of the pan, and the hash of its data and of the kitchen's.
    pub(super) fn pan(&self) -> &(String, u64) {
        &self.pan
    }
}
