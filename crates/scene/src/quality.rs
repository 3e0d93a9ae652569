//! Rendering quality.

use crate::light::shadow::CONTACT_SIZE;

/// Rendering quality, lowest first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Quality {
    /// Keeps what does not move between frames; one sample a pixel while things move.
    #[default]
    Quick,
    /// Draws everything at four samples a pixel with a finer shadow map.
    Smooth,
    /// What a graphics card has time for: besides, shadows where food touches the ground, and finer maps and textures.
    Best,
}

impl Quality {
    /// All of them, the least first.
    pub const ALL: [Self; 3] = [Self::Quick, Self::Smooth, Self::Best];

    /// The next one below, if there is one.
    pub fn lower(self) -> Option<Self> {
        Self::ALL.into_iter().rev().find(|other| *other < self)
    }

    /// The next one above, if there is one.
    pub fn higher(self) -> Option<Self> {
        Self::ALL.into_iter().find(|other| *other > self)
    }

    /// Height of the shadow map, which is twice as wide, and side of the contact map [texels] (chosen: WebGL2 guarantees
    /// 2048).
    pub(crate) fn map_sizes(self) -> [u32; 2] {
        match self {
            Self::Quick => [512, CONTACT_SIZE],
            Self::Smooth => [1024, CONTACT_SIZE],
            Self::Best => [1024, 2 * CONTACT_SIZE],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_lead_from_quick_to_best_and_back() {
        assert_eq!(Quality::Quick.higher().and_then(Quality::higher), Some(Quality::Best));
        assert_eq!(Quality::Best.lower().and_then(Quality::lower), Some(Quality::Quick));
        assert_eq!((Quality::Quick.lower(), Quality::Best.higher()), (None, None));
    }
}
