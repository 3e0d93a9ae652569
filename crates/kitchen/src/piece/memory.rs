//! The number and the memory of a kitchen's pieces, judged before a mesh is built.

use saute_food::{Body, BuildError, FoodDescription, FoodModel, PieceSpec};

/// Pieces of one kitchen at most [-] (chosen: what a machine still computes; a 26 cm pan takes some 40 shrimps).
pub const MOST_PIECES: usize = 100;
/// Memory of the pieces of one kitchen at most [bytes]. Chosen: a cook stays 512 MB at most above the program without food, with what
/// is drawn and written of it; a page has a kitchen in each of its up to three workers besides its own.
pub const MOST_BYTES: f64 = if cfg!(target_arch = "wasm32") { 128e6 } else { 352e6 };
/// Memory of a node of food that fries [bytes] (measured with `saute cook`, peaks: 735 in 100 shrimps, 675 in 14 steaks of 60 mm; half
/// as much before they are in the pan).
const PER_NODE: f64 = 700.0;
/// Memory of a piece without its nodes: collision shape, descriptions [bytes] (measured with `saute cook` on 200 small coins of carrot).
const PER_PIECE: f64 = 0.1e6;
/// Memory of a triangle of a food's own surface, of which each piece has a copy [bytes] (chosen: corners, indices, skin).
const PER_TRIANGLE: f64 = 200.0;

/// Pieces and their memory, as they are ordered one after another.
#[derive(Clone, Copy, Debug, Default)]
pub struct Load {
    pieces: usize,
    bytes: f64,
}

/// More pieces than fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooMuch {
    /// Number of pieces that were requested [-].
    pub asked: usize,
    /// Number of them that fit [-].
    pub fit: usize,
    /// Memory of those that were requested [bytes].
    pub bytes: f64,
    /// Number of pieces that are there or were ordered before [-].
    pub before: usize,
}

/// Why pieces have no room.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoRoom {
    /// They need more memory than there is for them.
    #[error("\"{food}\" does not fit: {excess}")]
    TooMuch {
        /// Name of the food.
        food: String,
        /// What it needs, and what fits.
        excess: TooMuch,
    },
    /// The food has no piece of that size.
    #[error(transparent)]
    Size(#[from] BuildError),
}

impl Load {
    /// Returns what pieces need.
    pub(crate) fn of<'m>(models: impl Iterator<Item = &'m FoodModel>) -> Self {
        let add = |load: Self, model| Self { pieces: load.pieces + 1, bytes: load.bytes + bytes_of(model) };
        models.fold(Self::default(), add)
    }

    /// Adds pieces of a name and a spec that are ordered, without building one.
    ///
    /// # Errors
    ///
    /// If they do not fit in addition to those before, or if the food has no piece of that size.
    pub fn add(&mut self, id: &str, spec: &PieceSpec, food: &FoodDescription, count: usize) -> Result<(), NoRoom> {
        let each = needed(Body::estimated_nodes(food, spec)?, food);
        let in_memory = (MOST_BYTES - self.bytes).max(0.0) / each;
        let fit = (in_memory as usize).min(MOST_PIECES.saturating_sub(self.pieces));
        let bytes = each * count as f64;
        if count > fit {
            let excess = TooMuch { asked: count, fit, bytes, before: self.pieces };
            return Err(NoRoom::TooMuch { food: id.to_owned(), excess });
        }
        self.pieces += count;
        self.bytes += bytes;
        Ok(())
    }
}

impl std::fmt::Display for TooMuch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { asked, fit, bytes, before } = *self;
        let what = if asked == 1 {
            "one piece of this size needs".into()
        } else {
            format!("{asked} pieces of this size need")
        };
        let most = if fit == 0 { "none fits".into() } else { format!("at most {fit} fit") };
        let beside = if before == 0 { String::new() } else { format!(" beside the {before} before") };
        let all = megabytes(MOST_BYTES);
        write!(
            f,
            "{what} about {}; {most}{beside}, as a kitchen holds {MOST_PIECES} pieces and {all}",
            megabytes(bytes)
        )
    }
}

impl std::error::Error for TooMuch {}

/// Memory in words.
fn megabytes(bytes: f64) -> String {
    if bytes < 1e9 { format!("{:.0} MB", bytes / 1e6) } else { format!("{:.1} GB", bytes / 1e9) }
}

/// Memory of a piece with a number of nodes [bytes].
fn needed(nodes: f64, food: &FoodDescription) -> f64 {
    let triangles = food.body.as_ref().map_or(0, |surface| surface.triangles.len());
    PER_PIECE + PER_NODE * nodes + PER_TRIANGLE * triangles as f64
}

/// Memory of a piece of a model [bytes].
pub(crate) fn bytes_of(model: &FoodModel) -> f64 {
    needed(model.mesh().node_count() as f64, model.description())
}
