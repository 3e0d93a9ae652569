//! Dark or light panels.

use serde::{Deserialize, Serialize};

/// Dark or light panels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Theme {
    /// Light text on a dark ground.
    #[default]
    Dark,
    /// Dark text on paper.
    Light,
    /// As the system states; dark where it states nothing.
    System,
}

impl Theme {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Dark, Self::Light, Self::System];
}
