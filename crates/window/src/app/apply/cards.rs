//! Cards and panels: opened and closed by acts.

use crate::app::SauteApp;
use crate::host::Host;
use crate::panels::memory::Drawer;
use saute_controls::act::Card;

impl SauteApp {
    /// Opens a card in place of the one that is open.
    pub(super) fn open_card(&mut self, card: Card) {
        self.desk.card = Some(card);
    }

    /// Closes a card; the first steps are then known.
    pub(crate) fn shut_card(&mut self, card: Card) {
        self.settings.introduced |= card == Card::FirstSteps;
        self.desk.card.take_if(|open| *open == card);
    }

    /// Opens a card, or closes it.
    pub(super) fn toggle_card(&mut self, card: Card) {
        self.desk.card = (self.desk.card != Some(card)).then_some(card);
    }

    /// Closes the cards and ends the placing of probes; where nothing is open, food that is being set out is let go of, else ways side by
    /// side are one again.
    pub(super) fn close_all(&mut self) {
        let is_something_open = self.desk.card.is_some() || self.sights.scene.placing || self.photo_is_open();
        if !is_something_open && self.stops_building() {
            return;
        }
        self.sights.ways.on &= is_something_open;
        self.sights.scene.placing = false;
        if let Some(card) = self.desk.card {
            self.shut_card(card);
        }
        self.host.close_photo();
    }

    /// Opens one of the panels on the left, or none.
    pub(super) fn open_left(&mut self, pantry: bool, pieces: bool) {
        (self.settings.pantry_open, self.settings.pieces_open) = (pantry, pieces);
        match (pantry, pieces) {
            (true, _) => self.desk.memory.drawer = Drawer::Food,
            (_, true) => self.desk.memory.drawer = Drawer::Pieces,
            _ => {}
        }
    }

    /// Shows the calibration pattern of the half mirror, or its picture.
    pub(super) fn calibrate_mirror(&mut self, on: bool) {
        self.sights.mirror.calibrating = on;
        self.sights.mirror.open |= on;
    }
}
