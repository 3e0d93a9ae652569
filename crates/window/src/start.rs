//! What the window begins with.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_recipe::{Recipe, Recording};
use saute_words::language::Language;

use crate::guided::{LessonStart, StudyStart};

/// Start options of the window.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Library of foods, pans and recipes; the embedded one unless given.
    pub library: Option<Arc<Library>>,
    /// A recipe to play at once.
    pub recipe: Option<Recipe>,
    /// A recorded session to go on with.
    pub recorded: Option<Recording>,
    /// Language of the window; the remembered one unless given.
    pub language: Option<Language>,
    /// True draws panels a few times a second where the graphics are software.
    pub frugal: bool,
    /// True lets threads work beside the window; without them, and without a page, nobody does.
    #[cfg(not(target_arch = "wasm32"))]
    pub threads: bool,
    /// True plays the sound of the cook on the system's sound card.
    #[cfg(not(target_arch = "wasm32"))]
    pub speaker: bool,
    /// Folder of pictures; that of the user unless given.
    #[cfg(not(target_arch = "wasm32"))]
    pub pictures: Option<std::path::PathBuf>,
    /// A study that leads the window.
    pub study: Option<StudyStart>,
    /// A lesson to begin with.
    pub lesson: Option<LessonStart>,
    /// Devices that hands hold.
    #[cfg(not(target_arch = "wasm32"))]
    pub hands: crate::hand::HandsStart,
    /// What the page has for the window.
    #[cfg(target_arch = "wasm32")]
    pub page: crate::browser::host::PageStart,
}

/// Errors of starting the window.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// Embedded or user data is broken.
    #[error(transparent)]
    Library(#[from] saute_schema::LibraryError),
    /// The first kitchen cannot be set up.
    #[error(transparent)]
    Setup(#[from] saute_recipe::session::ReplayError),
}
