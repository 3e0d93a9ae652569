//! Cards, files, pictures, devices and settings.

use super::card::Card;
use super::host_act::HostAct;
use super::setting::Setting;
use super::traits::Traits;
use saute_session::export::Export;
use saute_session::hearing::example::Example;
use saute_session::permits::Permit;

/// Cards, files, pictures, devices and settings.
#[derive(Clone, Debug, PartialEq)]
pub enum AppAct {
    /// Opens a file dialog for a recipe.
    ChooseFile,
    /// Saves a file that is made of the cook.
    Export(saute_session::export::Export),
    /// Copies an address that contains the cook.
    CopyLink,
    /// Emergency stop of all devices.
    StopHands,
    /// Saves a picture.
    Picture,
    /// The photo mode; in a page, which has none, a picture.
    Photo,
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
    /// What only a desktop, or only a page, has.
    Host(HostAct),
    /// Changes a remembered setting.
    Set(Setting),
    /// Plays what a cue means.
    Hear(Example),
    /// Shows a notice over the scene.
    Say(String),
    /// Opens a card in place of the one that is open.
    Open(Card),
    /// Closes a card.
    Shut(Card),
    /// The card of the settings.
    Settings,
    /// This list.
    Help,
    /// The notices so far.
    Messages,
    /// Closes list and card; no probe is put in.
    Close,
}

impl AppAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::ChooseFile | Self::CopyLink | Self::Export(Export::Cook | Export::Recipe | Export::Readings) => {
                Traits::needing(&[Permit::Leaving])
            }
            Self::StopHands => {
                Traits { words: "key.stop_hands", over_cards: true, ..Traits::needing(&[Permit::Devices]) }
            }
            Self::Picture => Traits { words: "key.picture", over_cards: true, ..Traits::needing(&[Permit::Eye]) },
            Self::Photo => Traits { words: "key.photo", frames_photo: true, ..Traits::needing(&[Permit::Pictures]) },
            Self::Mirror => Traits { words: "key.mirror", over_cards: true, ..Traits::needing(&[Permit::Devices]) },
            Self::MirrorWindow(_) | Self::Calibrate(_) | Self::ReadRig => Traits::needing(&[Permit::Devices]),
            Self::ShareResult => Traits::needing(&[Permit::Pictures]),
            Self::Host(act) => act.traits(),
            Self::Set(setting) => Traits::needing(setting.needs()),
            Self::Hear(_) => Traits::needing(&[Permit::Sound]),
            Self::Say(_) => Traits::needing(&[Permit::Eye]),
            Self::Open(card) => Traits::needing(card.needs()),
            // What is open can always be closed.
            Self::Shut(_) => Traits::needing(&[]),
            Self::Settings => {
                Traits { words: "key.settings", over_cards: true, ..Traits::needing(Card::Settings.needs()) }
            }
            Self::Help => Traits { words: "key.help", over_cards: true, ..Traits::needing(Card::Help.needs()) },
            Self::Messages => {
                Traits { words: "key.messages", over_cards: true, ..Traits::needing(Card::Messages.needs()) }
            }
            Self::Close => Traits { words: "key.close", over_cards: true, ..Traits::needing(&[]) },
        }
    }
}
