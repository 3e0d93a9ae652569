//! The errors of the command, each with a remedy.

use saute_formats::parquet_file::TableError;
use saute_kitchen::kitchen::SetupError;
use saute_picture::still::animation::AnimationError;
use saute_picture::still::png_file::PngError;
use saute_picture::still::shot::ShotError;
use saute_schema::InputError;
use saute_schema::echo::shortened;
use saute_window::desktop::offscreen::OffscreenError;

/// Why the command failed.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A recipe or a lab case that cannot be used, or a step that failed.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A recipe whose pan or food cannot be built.
    #[error(
        "{file}: {source}\n  remedy: choose another size or kind of food or pan: saute list foods, saute list pans"
    )]
    Setup {
        /// File of the recipe.
        file: String,
        /// Why it cannot be built.
        source: SetupError,
    },
    /// A data file that cannot be used.
    #[error(
        "{file}:{line}: {message}\n  remedy: correct this line, or remove the file from the --data folder to use the shipped one"
    )]
    Data {
        /// The file.
        file: String,
        /// Line number, from 1.
        line: usize,
        /// What is wrong.
        message: String,
    },
    /// A file, folder or stream that cannot be used.
    #[error("{place}: {message}\n  remedy: {remedy}")]
    Place {
        /// The place, with the line if there is one.
        place: String,
        /// What is wrong.
        message: String,
        /// How to correct it.
        remedy: String,
    },
    /// A haptic device that was found and then did not work.
    #[error("the device {message}\n  remedy: {remedy}")]
    Trouble {
        /// What it did.
        message: &'static str,
        /// How to correct it.
        remedy: &'static str,
    },
    /// A cook that was interrupted by a signal.
    #[error("interrupted at {at_s:.1} s of the cook; {left}\n  remedy: start it again; it gives the same results")]
    Interrupted {
        /// Simulated time [s].
        at_s: f64,
        /// What is in the output folder now.
        left: String,
    },
    /// A search for a plan that was interrupted before a candidate was cooked.
    #[error("interrupted before a candidate was cooked\n  remedy: start it again; it gives the same plan")]
    PlanInterrupted,
    /// A sweep that was interrupted by a signal.
    #[error("interrupted: {done} of {rows} rows are there\n  remedy: start it again; it goes on with the others")]
    SweepInterrupted {
        /// Rows whose results are in the folder.
        done: u64,
        /// Rows of the sweep.
        rows: u64,
    },
    /// A device that cannot be opened.
    #[error(transparent)]
    Device(#[from] saute_haptics::OpenError),
    /// The window cannot be opened.
    #[error("{0}")]
    NoDisplay(String),
    /// A picture that cannot be rendered.
    #[error(transparent)]
    Shot(#[from] ShotError),
    /// A rig of the half mirror that cannot be used.
    #[error(transparent)]
    Rig(#[from] saute_mirror::rig_file::RigFileError),
    /// Frames that cannot be rendered.
    #[error(transparent)]
    Offscreen(#[from] OffscreenError),
    /// A picture that cannot be encoded.
    #[error("{0}\n  remedy: run it without --out and report this as a bug")]
    Png(#[from] PngError),
    /// An animation that cannot be encoded.
    #[error("{0}\n  remedy: write a picture with --at instead and report this as a bug")]
    Animation(#[from] AnimationError),
    /// A control loop that cannot run.
    #[error("{0}\n  remedy: close other programs and try again")]
    Loop(#[from] saute_haptics::control::control_loop::LoopError),
    /// Series that cannot be written as CSV.
    #[error("the series cannot be written as CSV: {0}\n  remedy: run it without --out and report this as a bug")]
    Csv(#[from] csv::Error),
    /// Numbers that cannot be written as Parquet.
    #[error("{0}\n  remedy: run it without --out and report this as a bug")]
    Table(#[from] TableError),
    /// Numbers that cannot be written as JSON.
    #[error(
        "the numbers cannot be written as JSON: {0}\n  remedy: run it without --json and --out and report this as a bug"
    )]
    Json(#[from] serde_json::Error),
}

impl CliError {
    /// Returns the error of a file, folder or stream.
    pub fn place(place: impl std::fmt::Display, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        let message: String = message.into();
        let message = shortened(&message).into_owned();
        Self::Place { place: place.to_string(), message, remedy: remedy.into() }
    }
}
