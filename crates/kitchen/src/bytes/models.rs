//! Models that are known, so that restored kitchens share them and need not build them again.

use std::sync::Arc;

use saute_food::body::halving::CutError;
use saute_food::{FoodModel, PieceSpec};

use crate::data::library::Library;
use crate::kitchen::{Fixed, Kitchen, PieceOrder, SetupError, built};
use crate::pan::near_pan::uneven_of;
use crate::piece::memory::{MOST_BYTES, bytes_of};
use crate::piece::piece_state::Piece;

/// Models of pans and foods by what they were built from.
#[derive(Clone, Debug, Default)]
pub struct Models {
    kitchens: Vec<Arc<Fixed>>,
    foods: Vec<KnownFood>,
}

/// Description from which the model of a piece follows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FoodKey {
    pub(super) kind: String,
    pub(crate) data_hash: u64,
    pub(super) spec: PieceSpec,
    /// Place of the cut that halved it [m].
    pub(super) cut: Option<f64>,
}

/// Model of a piece and the unevenness of its faces.
pub(crate) type FoodParts = (Arc<FoodModel>, Arc<Vec<f64>>);

#[derive(Clone, Debug)]
struct KnownFood {
    key: FoodKey,
    parts: FoodParts,
}

impl FoodKey {
    /// Returns the description of a whole piece that is ordered.
    pub(crate) fn ordered(order: &PieceOrder, library: &Library) -> Self {
        let food = library.foods.get(&order.kind);
        let data_hash = food.map_or(0, |food| library.food_hash(&order.kind, food));
        Self { kind: order.kind.clone(), data_hash, spec: order.spec(), cut: None }
    }

    /// Returns the description of a piece.
    pub(super) fn of(piece: &Piece) -> Self {
        Self {
            kind: piece.kind.clone(),
            data_hash: piece.data_hash,
            spec: piece.spec,
            cut: piece.halved().map(|cut| cut.at),
        }
    }
}

impl Models {
    /// Returns the models of a kitchen.
    pub fn of(kitchen: &Kitchen) -> Self {
        let mut models = Self::default();
        models.learn(kitchen);
        models
    }

    /// Adds the models of a kitchen.
    pub fn learn(&mut self, kitchen: &Kitchen) {
        if self.known_kitchen(&kitchen.fixed.pan_kind, kitchen.fixed.data_hash).is_none() {
            self.kitchens.push(Arc::clone(&kitchen.fixed));
        }
        for piece in &kitchen.pieces {
            let key = FoodKey::of(piece);
            if self.known_food(&key).is_none() {
                self.foods.push(KnownFood { key, parts: (Arc::clone(&piece.model), Arc::clone(&piece.uneven)) });
            }
        }
    }

    /// Returns true if the model of a piece that is ordered is known.
    pub fn knows(&self, order: &PieceOrder, library: &Library) -> bool {
        self.known_food(&FoodKey::ordered(order, library)).is_some()
    }

    /// Returns those models that pieces that are ordered need.
    #[must_use]
    pub fn needed_by(&self, orders: &[PieceOrder], library: &Library) -> Self {
        let keys: Vec<FoodKey> = orders.iter().map(|order| FoodKey::ordered(order, library)).collect();
        let foods = self.foods.iter().filter(|food| keys.contains(&food.key)).cloned().collect();
        Self { kitchens: Vec::new(), foods }
    }

    /// Adds other models that are known.
    pub fn adopt(&mut self, other: Self) {
        for food in other.foods {
            if self.known_food(&food.key).is_none() {
                self.foods.push(food);
            }
        }
    }

    fn known_kitchen(&self, pan_kind: &str, data_hash: u64) -> Option<&Arc<Fixed>> {
        self.kitchens.iter().find(|known| known.pan_kind == pan_kind && known.data_hash == data_hash)
    }

    fn known_food(&self, key: &FoodKey) -> Option<&FoodParts> {
        self.foods.iter().find(|known| known.key == *key).map(|known| &known.parts)
    }

    /// Forgets models that no kitchen has, once those that are known need more memory than a kitchen may: foods that are added and
    /// removed again and again must not fill it.
    fn make_room(&mut self) {
        let known: f64 = self.foods.iter().map(|food| bytes_of(&food.parts.0)).sum();
        if known > MOST_BYTES {
            self.foods.retain(|food| Arc::strong_count(&food.parts.0) > 1);
        }
    }

    /// Returns the immutable part of a kitchen, built if it is not known.
    pub(super) fn kitchen(&mut self, pan: &(String, u64), library: &Library) -> Result<Arc<Fixed>, SetupError> {
        if let Some(known) = self.known_kitchen(&pan.0, pan.1) {
            return Ok(Arc::clone(known));
        }
        let fixed = Arc::new(Fixed::build(library, &pan.0)?);
        self.kitchens.push(Arc::clone(&fixed));
        Ok(fixed)
    }

    /// Returns the model of a piece, built if it is not known.
    pub(crate) fn food(&mut self, key: &FoodKey, fixed: &Fixed, library: &Library) -> Result<FoodParts, SetupError> {
        if let Some(known) = self.known_food(key) {
            return Ok(known.clone());
        }
        let whole = FoodKey { cut: None, ..key.clone() };
        let (model, uneven) = match (key.cut, self.known_food(&whole)) {
            (None, _) | (_, None) => {
                let model = built(library, &key.kind, &key.spec)?;
                let uneven = uneven_of(&model, key.spec.seed, &fixed.room);
                (Arc::new(model), uneven)
            }
            (Some(_), Some((model, uneven))) => (Arc::clone(model), uneven.as_ref().clone()),
        };
        let (model, uneven) = cut(model, uneven, key.cut).map_err(SetupError::Cut)?;
        let parts = (model, Arc::new(uneven));
        self.make_room();
        self.foods.push(KnownFood { key: key.clone(), parts: parts.clone() });
        Ok(parts)
    }
}

/// Cuts a model; the fresh faces are even.
fn cut(model: Arc<FoodModel>, mut uneven: Vec<f64>, at: Option<f64>) -> Result<(Arc<FoodModel>, Vec<f64>), CutError> {
    let Some(at) = at else { return Ok((model, uneven)) };
    let halved = model.halved(at)?;
    uneven.resize(halved.patches().len(), 0.0);
    Ok((Arc::new(halved), uneven))
}
