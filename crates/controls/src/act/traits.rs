//! What is true of each act in addition to what it does.

use saute_session::permits::Permit;

/// What an act is about, when it is done and what it needs. It has no default: a new act states what it is about and what it needs, and
/// what else is true of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Traits {
    /// Key of the words for it.
    pub words: &'static str,
    /// What it is about.
    pub subject: Subject,
    /// It changes the kitchen, or another cook begins with it.
    pub changes_cook: bool,
    /// While time is turned it waits until the instant is reached.
    pub waits: bool,
    /// What a study or a lesson must allow for it: all of these.
    pub needs: &'static [Permit],
    /// It shows more than can be perceived in a kitchen: skill mode hides it.
    pub reads: bool,
    /// Its key works while a card is open.
    pub over_cards: bool,
    /// Its key works in the photo mode.
    pub frames_photo: bool,
}

impl Traits {
    /// Key of the words for acts without their own.
    pub const NO_WORDS: &str = "waiting.act";

    /// Those of an act without a key that is about the window.
    pub fn needing(needs: &'static [Permit]) -> Self {
        Self::plain(Subject::Window, Self::NO_WORDS, needs)
    }

    /// Those of an act of which nothing else is true.
    pub fn plain(subject: Subject, words: &'static str, needs: &'static [Permit]) -> Self {
        Self {
            words,
            subject,
            changes_cook: false,
            waits: false,
            needs,
            reads: false,
            over_cards: false,
            frames_photo: false,
        }
    }
}

/// What an act is about: the help lists keys by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Food, oil, lid.
    Food,
    /// Turner and tongs.
    Tool,
    /// Hob and time.
    Hob,
    /// What is seen of the food.
    Views,
    /// The eye.
    Eye,
    /// Panels, pictures, devices.
    Window,
}

impl Subject {
    /// All of them, in the order of the help.
    pub const ALL: [Self; 6] = [Self::Food, Self::Hob, Self::Views, Self::Eye, Self::Tool, Self::Window];
}
