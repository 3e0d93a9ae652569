//! The state of a piece in few words.

use saute_kitchen::{Piece, Place, RestOn};

use crate::app::SauteApp;
use crate::stage::fitting_piece;

/// How done it is: the class of its core's peak, or how far the last of its changes has come.
pub fn doneness(app: &SauteApp, piece: &Piece) -> String {
    let scale = app.chosen_scale().and_then(|scale| fitting_piece(Some(piece), scale));
    if let Some(scale) = scale {
        return scale.name_of(piece.core_peak.0).to_owned();
    }
    let (names, fields) = (piece.model.kinetics.names(), &piece.state.changed);
    match (names.last(), fields.last()) {
        (Some(name), Some(field)) => format!("{name} {:.0} %", 100.0 * piece.model.volume_mean(field)),
        _ => String::new(),
    }
}

/// Where it is.
pub fn place(piece: &Piece) -> &'static str {
    match piece.place {
        Place::Waiting => "waiting",
        Place::Pan(_) => "in the pan",
        Place::Held => "held",
        Place::Rest(RestOn::Board) => "on the board",
        Place::Rest(RestOn::Rack) => "on the rack",
        Place::Rest(RestOn::Foil) => "under foil",
        Place::Glass => "on the hob",
        Place::Table => "on the table",
    }
}

/// Its mass, with as many places as it takes to see it change.
pub fn grams(piece: &Piece) -> String {
    let mass = 1e3 * piece.mass();
    if mass < 50.0 { format!("{mass:.1} g") } else { format!("{mass:.0} g") }
}
