//! What is done as soon as its foods are built.

use saute_session::FoodChoice;

/// What waits for its foods.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Later {
    /// So many of a choice are set out.
    SetOut(FoodChoice, usize),
    /// So many of a choice are added.
    Add(FoodChoice, usize),
    /// The cook is begun again.
    Restart,
    /// The cook of the last time goes on.
    Offer,
    /// A recipe's name and its text.
    Recipe(String, String),
    /// A session's name and its bytes.
    Session(String, Vec<u8>),
    /// The fragment of an address.
    Link(String),
}
