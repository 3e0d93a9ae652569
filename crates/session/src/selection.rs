//! The piece that the panels show, and the groups of pieces.

use saute_kitchen::{Piece, Place};

use super::Session;
use super::choice::{FIRST_FOOD, base_name, noun};
use crate::hands::Hands;
use saute_words::language::Language;
use saute_words::piece_words::{self, group_of};

impl<H: Hands> Session<H> {
    /// Returns the piece that the panels show: the selected one, else the first.
    pub fn shown_piece(&self) -> Option<&Piece> {
        self.selected().or_else(|| self.kitchen.pieces().first())
    }

    /// Returns the selected piece, if it still exists.
    pub fn selected(&self) -> Option<&Piece> {
        self.kitchen.piece(self.selected.as_deref()?)
    }

    /// Selects a piece, or none.
    pub fn select(&mut self, id: Option<String>) {
        self.selected = id;
    }

    /// Returns the index of the piece that the panels show.
    pub fn shown_index(&self) -> usize {
        let id = self.shown_piece().map(|p| &p.id);
        self.kitchen.pieces().iter().position(|p| Some(&p.id) == id).unwrap_or(0)
    }

    /// Returns the id of the piece that the panels show; that of the first food if there is none.
    pub fn shown_id(&self) -> String {
        self.shown_piece().map_or_else(|| base_name(&self.library, FIRST_FOOD), |p| p.id.clone())
    }

    /// Returns the noun for that piece in a language: "steak", "carrot coin".
    pub fn noun(&self, l: Language) -> String {
        noun(&self.library, self.shown_piece().map_or(FIRST_FOOD, |p| p.kind.as_str()), l)
    }

    /// Returns the name of a piece or a group in a language, given its id.
    pub fn name_of(&self, id: &str, l: Language) -> String {
        piece_words::name(id, &self.library, l)
    }

    /// Returns the mass of that piece when it was set out [g].
    pub fn start_mass_g(&self) -> f64 {
        self.shown_piece().and_then(|p| self.start_mass_g.get(&p.id)).copied().unwrap_or(0.0)
    }

    /// Returns the ids of the pieces of a group, in order.
    pub fn members(&self, group: &str) -> Vec<String> {
        let ids = self.kitchen.pieces().iter().map(|p| &p.id);
        ids.filter(|id| group_of(id) == group).cloned().collect()
    }

    /// Returns the ids of the group of the piece that the panels show.
    pub fn its_group(&self) -> Vec<String> {
        self.members(group_of(&self.shown_id()))
    }

    /// Returns the ids of all pieces that wait to be put into the pan.
    pub fn waiting(&self) -> Vec<String> {
        self.kitchen.pieces().iter().filter(|p| p.place == Place::Waiting).map(|p| p.id.clone()).collect()
    }
}
