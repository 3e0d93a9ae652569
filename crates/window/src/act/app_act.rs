//! Cards, files, pictures, devices and settings.

use super::card::Card;
use super::setting::Setting;
use super::traits::{Subject, Traits};
#[cfg(not(target_arch = "wasm32"))]
use crate::hand::Role;
use saute_session::export::Export;
use saute_session::permits::Permit;

/// Cards, files, pictures, devices and settings.
#[derive(Clone, Debug, PartialEq)]
pub enum AppAct {
    /// Opens a file dialog for a recipe.
    ChooseFile,
    /// Saves a file that is made of the cook.
    Export(saute_session::export::Export),
    /// Copies an address that holds the cook.
    CopyLink,
    /// Opens a recipe's file.
    #[cfg(not(target_arch = "wasm32"))]
    OpenFile(std::path::PathBuf),
    /// Shows a file in the system's file manager.
    #[cfg(not(target_arch = "wasm32"))]
    ShowFile(std::path::PathBuf),
    /// Emergency stop of all devices.
    StopHands,
    /// Devices that were stopped may make forces again.
    #[cfg(not(target_arch = "wasm32"))]
    ResumeHands,
    /// Connects a device.
    #[cfg(not(target_arch = "wasm32"))]
    Connect {
        /// What it holds.
        role: crate::hand::Role,
        /// NAME or NAME@PLACE.
        device: String,
        /// Pairing code; 0 where there is none.
        pairing: u32,
    },
    /// Disconnects what a hand holds.
    #[cfg(not(target_arch = "wasm32"))]
    Disconnect(crate::hand::Role),
    /// Saves a picture.
    Picture,
    /// The photo mode; in a page, which has none, a picture.
    Photo,
    /// Copies what a report of a problem needs.
    #[cfg(target_arch = "wasm32")]
    Report,
    /// Sets exposure, blur and size of a photo.
    #[cfg(not(target_arch = "wasm32"))]
    SetPhoto(crate::photo::PhotoChoice),
    /// Makes a time lapse of the cook.
    #[cfg(not(target_arch = "wasm32"))]
    TimeLapse,
    /// The half mirror's window on or off, with a word on how to use it.
    Mirror,
    /// Opens the half mirror's window or closes it.
    MirrorWindow(bool),
    /// Shows the half mirror's pattern, or its picture.
    Calibrate(bool),
    /// Reads the half mirror's rig again.
    ReadRig,
    /// Saves the result of the cook as a picture.
    ShareResult,
    /// Changes a remembered setting.
    Set(Setting),
    /// Says something over the scene.
    Say(String),
    /// Opens a card in place of the one that is open.
    Open(Card),
    /// Closes a card.
    Shut(Card),
    /// The card of the settings.
    Settings,
    /// This list.
    Help,
    /// What was said so far.
    Messages,
    /// Closes list and card; no probe is put in.
    Close,
}

impl AppAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::ChooseFile | Self::CopyLink | Self::Export(Export::Cook | Export::Recipe | Export::Readings) => {
                needing(&[Permit::Leaving])
            }
            #[cfg(not(target_arch = "wasm32"))]
            Self::OpenFile(_) => needing(&[Permit::Leaving]),
            #[cfg(not(target_arch = "wasm32"))]
            Self::ShowFile(_) => needing(&[Permit::Eye]),
            Self::StopHands => Traits { words: "key.stop_hands", over_cards: true, ..needing(&[Permit::Devices]) },
            #[cfg(not(target_arch = "wasm32"))]
            Self::ResumeHands
            | Self::Connect { role: Role::Pan | Role::Turner, device: _, pairing: _ }
            | Self::Disconnect(Role::Pan | Role::Turner) => needing(&[Permit::Devices]),
            Self::Picture => Traits { words: "key.picture", over_cards: true, ..needing(&[Permit::Eye]) },
            #[cfg(target_arch = "wasm32")]
            Self::Report => needing(&[Permit::Help]),
            Self::Photo => Traits { words: "key.photo", frames_photo: true, ..needing(&[Permit::Pictures]) },
            #[cfg(not(target_arch = "wasm32"))]
            Self::SetPhoto(_) => needing(&[Permit::Pictures]),
            #[cfg(not(target_arch = "wasm32"))]
            Self::TimeLapse => needing(&[Permit::Pictures, Permit::Leaving]),
            Self::Mirror => Traits { words: "key.mirror", over_cards: true, ..needing(&[Permit::Devices]) },
            Self::MirrorWindow(_) | Self::Calibrate(_) | Self::ReadRig => needing(&[Permit::Devices]),
            Self::ShareResult => needing(&[Permit::Pictures]),
            Self::Set(setting) => needing(setting.needs()),
            Self::Say(_) => needing(&[Permit::Eye]),
            Self::Open(card) => needing(card.needs()),
            // What is open can always be closed.
            Self::Shut(_) => needing(&[]),
            Self::Settings => Traits { words: "key.settings", over_cards: true, ..needing(Card::Settings.needs()) },
            Self::Help => Traits { words: "key.help", over_cards: true, ..needing(Card::Help.needs()) },
            Self::Messages => Traits { words: "key.messages", over_cards: true, ..needing(Card::Messages.needs()) },
            Self::Close => Traits { words: "key.close", over_cards: true, ..needing(&[]) },
        }
    }
}

fn needing(needs: &'static [Permit]) -> Traits {
    Traits::plain(Subject::Window, Traits::NO_WORDS, needs)
}
