//! Contact of a patch of food: open to the air, closed, or in contact with a surface.

use serde::{Deserialize, Serialize};

/// Conductance of a contact with fixed surface temperature [W/(m²·K)] (chosen: a thousand times that of any node).
const FIXED_CONDUCTANCE: f64 = 1e7;

/// Contact of a patch during one tick.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub enum Touch {
    /// No contact: the patch exchanges heat and vapour with the air in front of it (Robin boundary).
    #[default]
    Air,
    /// Adiabatic and impermeable: no heat and no vapour; any heat flow through the patch is computed elsewhere.
    Closed,
    /// Contact with a surface, such as a pan or a board, that takes up no vapour.
    ///
    /// A contact without conductance has no effect: the patch exchanges with the air.
    Contact {
        /// Contact conductance [W/(m²·K)].
        conductance: f64,
        /// Temperature of the surface [K].
        temperature: f64,
    },
    /// Fixed surface temperature (Dirichlet boundary), approximated by a very large conductance; no vapour.
    Fixed {
        /// Temperature of the surface [K].
        temperature: f64,
    },
}

impl Touch {
    /// Returns true if the contact keeps the patch from the air.
    #[inline]
    pub fn covers(&self) -> bool {
        match *self {
            Self::Air => false,
            Self::Closed | Self::Fixed { .. } => true,
            Self::Contact { conductance, .. } => conductance > 0.0,
        }
    }

    /// Returns the conductance to the surface [W/(m²·K)]; 0 without a surface.
    #[inline]
    pub fn conductance(&self) -> f64 {
        match *self {
            Self::Air | Self::Closed => 0.0,
            Self::Contact { conductance, .. } => conductance,
            Self::Fixed { .. } => FIXED_CONDUCTANCE,
        }
    }

    /// Returns the temperature of the surface [K]; 0 without a surface, where it has no effect.
    #[inline]
    pub fn temperature(&self) -> f64 {
        match *self {
            Self::Air | Self::Closed => 0.0,
            Self::Contact { temperature, .. } | Self::Fixed { temperature } => temperature,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Touch;

    #[test]
    fn only_air_and_a_contact_without_conductance_leave_a_patch_open() {
        let contact = |conductance| Touch::Contact { conductance, temperature: 400.0 };
        assert!(!Touch::default().covers() && !contact(0.0).covers());
        assert!(Touch::Closed.covers() && contact(1e-12).covers() && Touch::Fixed { temperature: 400.0 }.covers());
    }

    #[test]
    fn a_closed_patch_conducts_nothing() {
        assert_eq!(Touch::Closed.conductance(), 0.0);
    }
}
