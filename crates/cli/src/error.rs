//! Everything that can go wrong, each with what to do about it.

use saute_kitchen::InputError;
use saute_kitchen::kitchen::SetupError;
use saute_picture::still::png_file::PngError;
use saute_picture::still::shot::ShotError;
use saute_window::offscreen::OffscreenError;

/// Why the command failed.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A recipe or a lab case that cannot be used, or a step that went wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A recipe whose pan or food cannot be built.
    #[error(
        "{file}: {source}\n  remedy: choose another size or kind of food or pan: saute list foods, saute list pans"
    )]
    Setup {
        /// Which recipe.
        file: String,
        /// What could not be built.
        source: SetupError,
    },
    /// A data file that cannot be used.
    #[error(
        "{file}:{line}: {message}\n  remedy: mend this line, or take the file out of the --data folder to use the shipped one"
    )]
    Data {
        /// Which file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is wrong.
        message: String,
    },
    /// A file, folder or stream that cannot be used.
    #[error("{place}: {message}\n  remedy: {remedy}")]
    Place {
        /// Which one, with the line where there is one.
        place: String,
        /// What is wrong.
        message: String,
        /// What to do instead.
        remedy: String,
    },
    /// A device that cannot be opened.
    #[error(transparent)]
    Device(#[from] saute_haptics::OpenError),
    /// There is no screen to open a window on.
    #[error("{0}")]
    NoDisplay(String),
    /// A picture that could not be made.
    #[error(transparent)]
    Shot(#[from] ShotError),
    /// A rig of the half mirror that cannot be used.
    #[error(transparent)]
    Rig(#[from] saute_window::mirror::rig_file::RigFileError),
    /// Frames that could not be drawn.
    #[error(transparent)]
    Offscreen(#[from] OffscreenError),
    /// A picture that could not be encoded.
    #[error("{0}\n  remedy: leave --out away and report this as a bug")]
    Png(#[from] PngError),
    /// A control loop that could not be run.
    #[error("{0}\n  remedy: close other programs and try again")]
    Loop(#[from] saute_haptics::control_loop::LoopError),
    /// Numbers that could not be written as JSON.
    #[error(
        "the numbers could not be written as JSON: {0}\n  remedy: leave --json and --out away and report this as a bug"
    )]
    Json(#[from] serde_json::Error),
}

impl CliError {
    /// A file, folder or stream that cannot be used.
    pub fn place(place: impl std::fmt::Display, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Place { place: place.to_string(), message: message.into(), remedy: remedy.into() }
    }
}
