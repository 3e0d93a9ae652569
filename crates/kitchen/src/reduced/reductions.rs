//! Pan and pieces of a kitchen on coarse meshes.

use std::sync::Arc;

use saute_food::{BuildError, FoodModel, FoodSolver, Reduction};

use crate::data::room::Room;
use crate::kitchen::Kitchen;
use crate::piece::piece_shape::PieceShape;
use crate::piece::piece_state::Piece;
use crate::piece::sear_lines::SearRecord;
use crate::reduced::coarse_pan::CoarsePan;

/// Coarse models of the pan and the pieces of a kitchen: built once for each piece, and again after it was cut.
#[derive(Clone, Debug, Default)]
pub struct Reductions {
    pan: Option<CoarsePan>,
    known: Vec<Known>,
}

/// A model and its coarse one; none if it keeps its mesh.
#[derive(Clone, Debug)]
struct Known {
    fine: Arc<FoodModel>,
    coarse: Option<Coarse>,
}

#[derive(Clone, Debug)]
struct Coarse {
    reduction: Reduction,
    uneven: Arc<Vec<f64>>,
}

impl Reductions {
    /// Builds what it does not have of a kitchen, and forgets the pieces that are gone; returns its pan.
    ///
    /// # Errors
    /// If a coarse mesh cannot be built.
    pub(super) fn learn(&mut self, kitchen: &Kitchen) -> Result<CoarsePan, BuildError> {
        self.known.retain(|known| kitchen.pieces.iter().any(|piece| Arc::ptr_eq(&piece.model, &known.fine)));
        for piece in kitchen.pieces.iter().filter(|piece| piece.is_out()) {
            if self.of(piece).is_none() {
                let reduction = Reduction::of(&piece.model)?;
                let room = &kitchen.fixed.room;
                let coarse = reduction.map(|reduction| Coarse { uneven: uneven(&reduction, piece, room), reduction });
                self.known.push(Known { fine: Arc::clone(&piece.model), coarse });
            }
        }
        let pan = match self.pan.take().filter(|pan| pan.is_of(&kitchen.fixed)) {
            Some(pan) => pan,
            None => CoarsePan::of(&kitchen.fixed)?,
        };
        self.pan = Some(pan.clone());
        Ok(pan)
    }

    fn of(&self, piece: &Piece) -> Option<&Known> {
        self.known.iter().find(|known| Arc::ptr_eq(&known.fine, &piece.model))
    }

    /// Returns a piece with its present state on its coarse mesh.
    pub(super) fn reduced(&self, piece: &Piece) -> Piece {
        let Some(coarse) = self.of(piece).and_then(|known| known.coarse.as_ref()) else {
            // Its mesh stays; that of the pan, on which its places were found, does not.
            let (on_pan, media) = (piece.on_pan.on_other_mesh(), piece.media.on_other_mesh());
            return Piece { on_pan, media, ..piece.clone() };
        };
        let model = Arc::clone(coarse.reduction.model());
        let state = coarse.reduction.restricted(&piece.model, &piece.state);
        Piece {
            id: piece.id.clone(),
            kind: piece.kind.clone(),
            shape: PieceShape::of(&model, &state),
            solver: FoodSolver::default(),
            sear: SearRecord::default(),
            uneven: Arc::clone(&coarse.uneven),
            on_pan: piece.on_pan.on_other_mesh(),
            media: piece.media.on_other_mesh(),
            contacts: piece.contacts.clone(),
            board: piece.board.clone(),
            running: None,
            basted: Vec::new(),
            touch: Vec::new(),
            model,
            state,
            ..*piece
        }
    }
}

/// Unevenness of the faces on the coarse mesh [m]: the gap of each patch conducts as the mean of the gaps that it represents.
fn uneven(reduction: &Reduction, piece: &Piece, room: &Room) -> Arc<Vec<f64>> {
    let [lies, least] = [room.contact.gap_mm, room.contact.least_gap_mm].map(|mm| 1e-3 * mm);
    let columns = piece.model.mesh().swept().map_or(0, saute_heat::SweptMesh::nodes_per_level);
    let conducts: Vec<f64> = piece.uneven.iter().map(|gap| 1.0 / (lies + gap).max(least)).collect();
    let faces = conducts[..2 * columns].chunks(columns).flat_map(|face| reduction.column_means(&piece.model, face));
    let mut uneven: Vec<f64> = faces.map(|conducts| 1.0 / conducts - lies).collect();
    // A slice that stands on its side does so evenly.
    uneven.resize(reduction.model().patches().len(), 0.0);
    Arc::new(uneven)
}
