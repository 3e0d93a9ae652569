//! What the window begins with.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_recipe::{Recipe, Recording};
use saute_words::language::Language;

use crate::host::HostStart;
use saute_session::guided::{LessonStart, StudyStart};

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
    /// What only a desktop has.
    pub desktop: DesktopOptions,
    /// A study that leads the window.
    pub study: Option<StudyStart>,
    /// A lesson to begin with.
    pub lesson: Option<LessonStart>,
    /// Devices that hands hold, or what the page has for the window.
    pub host: HostStart,
}

impl Start {
    /// Returns true if it names nothing: then the cook before may go on.
    pub(crate) fn names_nothing(&self) -> bool {
        let is_led = self.study.is_some() || self.lesson.is_some();
        self.recipe.is_none() && self.recorded.is_none() && !is_led
    }
}

/// What a desktop lets the window use; a page ignores it.
#[derive(Clone, Debug, Default)]
pub struct DesktopOptions {
    /// True lets worker threads run in the background; without them nothing does.
    pub threads: bool,
    /// True plays the sound of the cook on the system's sound card.
    pub speaker: bool,
    /// Folder of pictures; that of the user unless given.
    pub pictures: Option<std::path::PathBuf>,
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
