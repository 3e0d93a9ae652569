//! What only a desktop lets a person do: files by their paths, devices, photos.

use std::path::PathBuf;

use saute_session::permits::Permit;

use super::photo_choice::PhotoChoice;
use super::traits::Traits;
use crate::hands::role::Role;

/// What only a desktop lets a person do.
#[derive(Clone, Debug, PartialEq)]
pub enum HostAct {
    /// Opens a recipe's file.
    OpenFile(PathBuf),
    /// Shows a file in the system's file manager.
    ShowFile(PathBuf),
    /// Devices that were stopped may make forces again.
    ResumeHands,
    /// Connects a device.
    Connect {
        /// What it holds.
        role: Role,
        /// NAME or NAME@PLACE.
        device: String,
        /// Pairing code; 0 where there is none.
        pairing: u32,
    },
    /// Disconnects what a hand holds.
    Disconnect(Role),
    /// Sets exposure, blur and size of a photo.
    SetPhoto(PhotoChoice),
    /// Makes a time lapse of the cook.
    TimeLapse,
}

impl HostAct {
    /// What else is true of it.
    pub fn traits(&self) -> Traits {
        match self {
            Self::OpenFile(_) => Traits::needing(&[Permit::Leaving]),
            Self::ShowFile(_) => Traits::needing(&[Permit::Eye]),
            Self::ResumeHands
            | Self::Connect { role: Role::Pan | Role::Turner, device: _, pairing: _ }
            | Self::Disconnect(Role::Pan | Role::Turner) => Traits::needing(&[Permit::Devices]),
            Self::SetPhoto(_) => Traits::needing(&[Permit::Pictures]),
            Self::TimeLapse => Traits::needing(&[Permit::Pictures, Permit::Leaving]),
        }
    }
}
