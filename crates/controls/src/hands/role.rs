//! What a device holds.

/// What a device holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// The pan.
    #[default]
    Pan,
    /// The turner, without force.
    Turner,
}
