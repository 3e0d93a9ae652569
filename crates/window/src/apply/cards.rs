//! Cards and panels: opened and closed by acts.

use crate::act::Card;
use crate::app::SauteApp;
use crate::panels::Drawer;

impl SauteApp {
    pub(super) fn open_card(&mut self, card: Card) {
        (self.help, self.settings_open) = (card == Card::Help, card == Card::Settings);
        self.messages = card == Card::Messages;
        self.mirror.card |= card == Card::Mirror;
        self.first_steps |= card == Card::FirstSteps;
    }

    pub(super) fn shut_card(&mut self, card: Card) {
        match card {
            Card::Help => self.help = false,
            Card::Settings => self.settings_open = false,
            Card::Messages => self.messages = false,
            Card::Mirror => self.mirror.card = false,
            Card::FirstSteps => self.close_first_steps(),
        }
    }

    pub(super) fn toggle_help(&mut self) {
        (self.help, self.settings_open, self.messages) = (!self.help, false, false);
    }

    pub(super) fn toggle_messages(&mut self) {
        (self.help, self.settings_open, self.messages) = (false, false, !self.messages);
    }

    pub(super) fn toggle_settings(&mut self) {
        (self.settings_open, self.help, self.messages) = (!self.settings_open, false, false);
        self.mirror.card &= !self.settings_open;
    }

    /// Closes the cards and ends the placing of probes.
    pub(super) fn close_all(&mut self) {
        (self.help, self.settings_open, self.messages, self.scene.placing) = (false, false, false, false);
        #[cfg(not(target_arch = "wasm32"))]
        {
            self.photo.open = false;
        }
    }

    /// Opens one of the panels on the left, or none.
    pub(super) fn open_left(&mut self, pantry: bool, pieces: bool) {
        (self.settings.pantry_open, self.settings.pieces_open) = (pantry, pieces);
        match (pantry, pieces) {
            (true, _) => self.memory.drawer = Drawer::Food,
            (_, true) => self.memory.drawer = Drawer::Pieces,
            _ => {}
        }
    }

    /// Shows the calibration pattern of the half mirror, or its picture.
    pub(super) fn calibrate_mirror(&mut self, on: bool) {
        self.mirror.calibrating = on;
        self.mirror.open |= on;
    }
}
