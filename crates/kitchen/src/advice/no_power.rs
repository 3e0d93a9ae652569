//! The reason why a hob that is on gives no power, or less than it is set to.

use crate::Kitchen;

/// Why a hob that is on gives no power, or less than it is set to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPower {
    /// The pan stands on the wet cloth.
    Cloth,
    /// The pan is at the hob's limit of temperature.
    Limit,
    /// The pan is near that limit: some power is left.
    NearLimit,
    /// The pan is lifted.
    Lifted,
    /// The pan stands off the ring.
    OffRing,
}

impl NoPower {
    /// Returns why a hob that is on gives no power or less, or `None` if it is off or gives all of it.
    pub fn of(kitchen: &Kitchen) -> Option<Self> {
        let (pan, on) = (kitchen.pan_state(), kitchen.hob_w() > 0.0);
        match () {
            () if !on => None,
            () if kitchen.hob_drawn_w() > 0.0 => pan.limited.then_some(Self::NearLimit),
            () if kitchen.cloth().is_some() => Some(Self::Cloth),
            () if pan.limited => Some(Self::Limit),
            // The pan is as hot as the hob keeps it.
            () if kitchen.hob_holds().is_some() && kitchen.hob().detects(&pan.pose) => None,
            () if pan.pose.lift > 0.0 => Some(Self::Lifted),
            () => Some(Self::OffRing),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Command, Library};

    #[test]
    fn a_hob_that_is_on_gives_no_power_to_a_pan_on_the_cloth() {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", 293.15).expect("sets up");
        assert_eq!(NoPower::of(&kitchen), None, "off");
        kitchen.apply(&Command::Hob(1000.0)).expect("hob");
        kitchen.step();
        assert_eq!(NoPower::of(&kitchen), None, "on");
        kitchen.apply(&Command::Cool { for_s: 10.0 }).expect("cloth");
        assert_eq!(NoPower::of(&kitchen), Some(NoPower::Cloth));
    }
}
