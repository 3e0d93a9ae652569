//! A piece as data: its order, and what changes.

use std::borrow::Cow;

use saute_food::advance::saved::SavedSolver;
use saute_food::{FoodSolver, FoodState, PieceSpec, Touch};
use saute_heat::Located;
use serde::{Deserialize, Serialize};

use crate::bytes::models::{FoodKey, FoodParts};
use crate::dynamics::{Contact, Pose};
use crate::hands::command::RestOn;
use crate::hands::ranges::FOR_S;
use crate::kitchen::PieceOrder;
use crate::pan::pan_model::PanModel;
use crate::piece::board::Board;
use crate::piece::medium::Media;
use crate::piece::pan_contact::PanContact;
use crate::piece::piece_shape::PieceShape;
use crate::piece::piece_state::{Piece, Place};
use crate::piece::running::Running;
use crate::piece::sear_lines::SearRecord;

/// What of a piece does not follow from its order.
#[derive(Deserialize, Serialize)]
pub(super) struct SavedPiece<'a> {
    pub(super) id: Cow<'a, str>,
    pub(super) kind: Cow<'a, str>,
    spec: PieceSpec,
    cut: Option<f64>,
    pub(super) key: u32,
    state: Cow<'a, FoodState>,
    place: Place,
    pose: Pose,
    core_peak: (f64, f64),
    vapour_flow: f64,
    heat_taken: f64,
    resting_on: RestOn,
    on_pan: Cow<'a, PanContact>,
    contacts: Cow<'a, [Contact]>,
    solver: SavedSolver,
    sear: Cow<'a, SearRecord>,
    shape: Cow<'a, PieceShape>,
    board: Cow<'a, Board>,
    touch: Cow<'a, [Touch]>,
    media: Cow<'a, Media>,
    running: Cow<'a, Option<Running>>,
    basted_s: f64,
}

impl<'a> SavedPiece<'a> {
    pub(super) fn of(piece: &'a Piece) -> Self {
        Self {
            id: Cow::Borrowed(&piece.id),
            kind: Cow::Borrowed(&piece.kind),
            spec: piece.spec,
            cut: piece.halved().map(|cut| cut.at),
            key: piece.key,
            state: Cow::Borrowed(&piece.state),
            place: piece.place,
            pose: piece.pose,
            core_peak: piece.core_peak,
            vapour_flow: piece.vapour_flow,
            heat_taken: piece.heat_taken,
            resting_on: piece.resting_on,
            on_pan: Cow::Borrowed(&piece.on_pan),
            contacts: Cow::Borrowed(&piece.contacts),
            solver: piece.solver.saved(&piece.state),
            sear: Cow::Borrowed(&piece.sear),
            shape: Cow::Borrowed(&piece.shape),
            board: Cow::Borrowed(&piece.board),
            touch: Cow::Borrowed(&piece.touch),
            media: Cow::Borrowed(&piece.media),
            running: Cow::Borrowed(&piece.running),
            basted_s: piece.basted_s,
        }
    }

    /// Returns what its model is built from, given the hash of its data; `None` if its mesh would be too fine, or its pool is not
    /// sound.
    pub(super) fn food_key(&self, data_hash: u64) -> Option<FoodKey> {
        let key = FoodKey { kind: self.kind.clone().into_owned(), data_hash, spec: self.spec, cut: self.cut };
        (self.spec.has_sound_pool() && PieceOrder::COARSENESS.contains(&self.spec.coarseness)).then_some(key)
    }

    /// Returns the piece again; `None` if its fields are not those of its model in this pan.
    pub(super) fn restored(self, data_hash: u64, (model, uneven): FoodParts, pan: &PanModel) -> Option<Piece> {
        if !self.state.fits(&model) {
            return None;
        }
        let piece = Piece {
            solver: FoodSolver::of_saved(self.solver, &model, &self.state)?,
            id: self.id.into_owned(),
            kind: self.kind.into_owned(),
            seed: self.spec.seed,
            spec: self.spec,
            data_hash,
            key: self.key,
            model,
            state: self.state.into_owned(),
            place: self.place,
            pose: self.pose,
            core_peak: self.core_peak,
            vapour_flow: self.vapour_flow,
            early_steam: 0.0,
            heat_taken: self.heat_taken,
            resting_on: self.resting_on,
            on_pan: self.on_pan.into_owned(),
            contacts: self.contacts.into_owned(),
            sear: self.sear.into_owned(),
            shape: self.shape.into_owned(),
            uneven,
            board: self.board.into_owned(),
            touch: self.touch.into_owned(),
            media: self.media.into_owned(),
            running: self.running.into_owned(),
            basted_s: self.basted_s,
            basted: Vec::new(),
        };
        is_sound(&piece, pan).then_some(piece)
    }
}

/// Returns true if its records name patches of its model and nodes of the pan, and what runs or is basted does so in bounds.
fn is_sound(piece: &Piece, pan: &PanModel) -> bool {
    let (patches, nodes) = (piece.model.patches().len(), pan.section.points.len());
    let located = |at: &Located| at.nodes.iter().all(|node| (*node as usize) < nodes);
    let near = piece.on_pan.near.patches.iter().all(|n| (n.patch as usize) < patches && located(&n.located));
    let lengths = [piece.touch.len(), piece.solver.contact_heat.len()];
    near && lengths.iter().all(|length| [0, patches].contains(length))
        && piece.shape.fits(&piece.model)
        && piece.sear.fits(patches)
        && piece.media.fits(patches, nodes)
        && (0.0..=FOR_S.high).contains(&piece.basted_s)
        && piece.running.as_ref().is_none_or(|running| piece.model.pool().is_some() && running.fits(nodes))
}
