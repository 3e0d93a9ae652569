//! A kitchen as data, and the kitchen from it.

use std::borrow::Cow;
use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use crate::bytes::bytes_error::BytesError;
use crate::bytes::header::{append_sealed, opened};
use crate::bytes::models::Models;
use crate::bytes::saved_pan;
use crate::bytes::saved_piece::SavedPiece;
use crate::bytes::sources::Sources;
use crate::bytes::storing::{hash_of_value, length_of, store};
use crate::data::library::Library;
use crate::dynamics::saved_world::SavedWorld;
use crate::dynamics::{PanShape, World};
use crate::hands::pan_hold::PanHold;
use crate::hands::second_hand::SecondHand;
use crate::kitchen::{Kitchen, OtherVapour, SetupError};
use crate::pan::cloth::Cloth;
use crate::pan::food_load::FoodLoad;
use crate::pan::hold::HoldControl;
use crate::pan::pan_model::{PanSolver, PanState};
use crate::piece::food_contact::Touching;
use crate::piece::memory::Load;
use crate::piece::piece_state::Piece;
use crate::tick::clock::Clock;
use crate::tick::energy::EnergyAccount;
use crate::tick::event::EventLog;

/// What of a kitchen does not follow from its data files.
#[derive(Deserialize, Serialize)]
struct SavedKitchen<'a> {
    clock: Clock,
    hob_w: f64,
    hold: HoldControl,
    pan: Cow<'a, PanState>,
    cloth: Cow<'a, Option<Cloth>>,
    load: Cow<'a, FoodLoad>,
    vapour: OtherVapour,
    pieces: Vec<SavedPiece<'a>>,
    next_key: u32,
    touching: Cow<'a, [Touching]>,
    world: SavedWorld<'a>,
    pan_hold: PanHold,
    second_hand: Cow<'a, SecondHand>,
    account: EnergyAccount,
    events: Cow<'a, EventLog>,
}

impl Kitchen {
    /// Returns everything that its next step reads, as bytes ([`crate::bytes`]).
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.append_bytes(&mut bytes);
        bytes
    }

    /// Appends what [`Self::to_bytes`] returns; it is measured first, so that memory is taken once: a page's never shrinks.
    pub fn append_bytes(&self, bytes: &mut Vec<u8>) {
        let stored = (Sources::of(self), self.fixed.home.as_deref(), self.saved());
        append_sealed(bytes, length_of(&stored), |body| store(&stored, body));
    }

    /// Returns the kitchen that was stored as bytes; it goes on exactly as the one that was stored.
    ///
    /// # Errors
    ///
    /// If the bytes are damaged, or of another version, or if the library has other data.
    pub fn from_bytes(bytes: &[u8], library: &Library) -> Result<Self, BytesError> {
        Self::from_bytes_with(bytes, library, &mut Models::default())
    }

    /// Returns the kitchen that was stored as bytes, with known models, to which those that had to be built are added.
    ///
    /// # Errors
    ///
    /// As [`Self::from_bytes`].
    pub fn from_bytes_with(bytes: &[u8], library: &Library, models: &mut Models) -> Result<Self, BytesError> {
        let damaged = |_: postcard::Error| BytesError::Damaged;
        let (sources, rest) = postcard::take_from_bytes::<Sources>(opened(bytes)?).map_err(damaged)?;
        // A kitchen at home goes with the kitchen: it is restored in the one in which it was stored.
        let (home, rest) = postcard::take_from_bytes::<Option<Cow<str>>>(rest).map_err(damaged)?;
        let library = &*library.in_kitchen(home.as_deref()).map_err(SetupError::from)?;
        sources.check(library)?;
        let (saved, rest) = postcard::take_from_bytes::<SavedKitchen>(rest).map_err(damaged)?;
        if !rest.is_empty() {
            return Err(BytesError::Damaged);
        }
        saved.restored(&sources, library, models)
    }

    /// Hash of everything that its next step reads: two kitchens with the same one go on in the same way.
    pub fn state_hash(&self) -> u64 {
        hash_of_value(&(Sources::of(self), self.saved()))
    }

    fn saved(&self) -> SavedKitchen<'_> {
        SavedKitchen {
            clock: self.clock,
            hob_w: self.hob_w,
            hold: self.hold,
            pan: Cow::Borrowed(&self.pan),
            cloth: Cow::Borrowed(&self.cloth),
            load: Cow::Borrowed(&self.load),
            vapour: self.vapour,
            pieces: self.pieces.iter().map(SavedPiece::of).collect(),
            next_key: self.next_key,
            touching: Cow::Borrowed(&self.touching),
            world: self.world.saved(),
            pan_hold: self.pan_hold,
            second_hand: Cow::Borrowed(&self.second_hand),
            account: self.account,
            events: Cow::Borrowed(&self.events),
        }
    }

    /// Returns true if its parts name each other rightly.
    fn is_sound(&self) -> bool {
        let keys: BTreeSet<u32> = self.pieces.iter().map(|piece| piece.key).collect();
        let of = |key: u32| self.pieces.iter().find(|piece| piece.key == key);
        let has_patch = |key: u32, patch: u32| of(key).is_some_and(|p| (patch as usize) < p.model.patches().len());
        let linked = |t: &Touching| t.links.iter().all(|l| has_patch(t.pair[0], l.a) && has_patch(t.pair[1], l.b));
        keys.len() == self.pieces.len()
            && keys.iter().all(|key| *key < self.next_key)
            && self.world.keys().all(|key| keys.contains(&key))
            && self.touching.iter().all(linked)
            && self.clock.is_sound()
            && self.second_hand.hand.is_sound()
            && saved_pan::fits(&self.pan, &self.load, &self.fixed.pan)
    }
}

impl SavedKitchen<'_> {
    fn restored(self, sources: &Sources, library: &Library, models: &mut Models) -> Result<Kitchen, BytesError> {
        let fixed = models.kitchen(sources.pan(), library)?;
        let mut pieces: Vec<Piece> = Vec::new();
        let mut load = Load::default();
        for saved in self.pieces {
            let data_hash = sources.food(&saved.kind).ok_or(BytesError::Damaged)?;
            let key = saved.food_key(data_hash).ok_or(BytesError::Damaged)?;
            let food = library.foods.get(&*saved.kind).ok_or(BytesError::Damaged)?;
            load.add(&saved.id, &key.spec, food, 1).map_err(SetupError::from)?;
            let parts = models.food(&key, &fixed, library)?;
            pieces.push(saved.restored(data_hash, parts, &fixed.pan).ok_or(BytesError::Damaged)?);
        }
        let shape = PanShape::of(&fixed.pan.description);
        let kitchen = Kitchen {
            clock: self.clock,
            hob_w: self.hob_w,
            hold: self.hold,
            pan: self.pan.into_owned(),
            // Scratch memory only.
            pan_solver: PanSolver::default(),
            cloth: self.cloth.into_owned(),
            load: self.load.into_owned(),
            vapour: self.vapour,
            pieces,
            next_key: self.next_key,
            touching: self.touching.into_owned(),
            world: World::of_saved(self.world, shape).ok_or(BytesError::Damaged)?,
            pan_hold: self.pan_hold,
            second_hand: self.second_hand.into_owned(),
            account: self.account,
            events: self.events.into_owned(),
            carried_out: None,
            fixed,
        };
        if kitchen.is_sound() { Ok(kitchen) } else { Err(BytesError::Damaged) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::food::{MeshSize, OutlineKind, Rules};
    use crate::{Command, PieceOrder, kelvin};

    fn frying(library: &Library) -> Kitchen {
        let mut kitchen = Kitchen::new(library, "carbon-steel-26", kelvin(180.0)).expect("pan");
        let order = PieceOrder {
            id: "shrimp".into(),
            kind: "shrimp".into(),
            size: [0.08, 0.016, 0.014],
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 2.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Natural,
        };
        kitchen.add(library, &order).expect("builds");
        kitchen.apply(&Command::Put { food: order.id, at: [0.0; 2], heap: false }).expect("put");
        (0..7).for_each(|_| kitchen.step());
        kitchen
    }

    #[test]
    fn values_that_are_no_numbers_keep_their_bits() {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = frying(&library);
        let odd = [f64::from_bits(0x7ff8_0000_dead_beef), -0.0, f64::NEG_INFINITY, f64::MIN_POSITIVE / 3.0];
        kitchen.pieces[0].state.browning[..4].copy_from_slice(&odd);
        kitchen.pan.peak[0] = odd[0];
        let restored = Kitchen::from_bytes(&kitchen.to_bytes(), &library).expect("restores");
        let bits = |field: &[f64]| field.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&restored.pieces[0].state.browning[..4]), bits(&odd));
        assert_eq!(restored.pan.peak[0].to_bits(), odd[0].to_bits());
    }

    /// Such bytes are never written; their checksum matches all the same.
    #[test]
    fn parts_that_do_not_belong_together_are_refused() {
        let library = Library::embedded().expect("embedded data");
        let sound = frying(&library);
        let spoilt: [fn(&mut Kitchen); 9] = [
            |k| k.pieces[0].state.water.truncate(3),
            |k| _ = k.pieces[0].state.changed.pop(),
            |k| k.pieces[0].touch.truncate(1),
            |k| k.pieces[0].spec.coarseness = 1.5,
            |k| k.pieces[0].spec.coarseness = 1e-3,
            |k| k.pieces[0].on_pan.near.patches[0].patch = 1 << 30,
            |k| k.pieces[0].key += 1,
            |k| k.pan.temperature.truncate(9),
            |k| k.next_key = 0,
        ];
        for (at, spoil) in spoilt.iter().enumerate() {
            let mut kitchen = sound.clone();
            spoil(&mut kitchen);
            let refused = Kitchen::from_bytes(&kitchen.to_bytes(), &library).map(drop);
            assert_eq!(refused, Err(BytesError::Damaged), "{at}");
        }
    }
}
