//! The size of the interface: for the desk, for arm's length, for a projector.

/// How large the interface is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum InterfaceSize {
    /// 100 %: a screen on a desk.
    #[default]
    Usual,
    /// 125 %: at arm's length.
    Large,
    /// 150 %: a projector.
    Largest,
}

impl InterfaceSize {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Usual, Self::Large, Self::Largest];

    /// Size over the usual one [-].
    pub fn factor(self) -> f32 {
        match self {
            Self::Usual => 1.0,
            Self::Large => 1.25,
            Self::Largest => 1.5,
        }
    }

    /// The next larger size, or the largest.
    #[must_use]
    pub fn larger(self) -> Self {
        match self {
            Self::Usual => Self::Large,
            Self::Large | Self::Largest => Self::Largest,
        }
    }

    /// The next smaller size, or the usual one.
    #[must_use]
    pub fn smaller(self) -> Self {
        match self {
            Self::Usual | Self::Large => Self::Usual,
            Self::Largest => Self::Large,
        }
    }
}
