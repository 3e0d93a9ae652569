//! What a stove gives a hot pan in the long run, so that a power on one stove can be converted to that of another.

use core::f64::consts::PI;

use crate::pan::heater::Heater;
use crate::pan::hob::HobDescription;

/// Temperature of the pan for which it is stated, over the room's [K] (chosen: a pan in which food browns).
const OVER_ROOM_K: f64 = 180.0;

/// A power on its way: P = (q̇ (1 + a) + b)/η.
#[derive(Clone, Copy, Debug)]
struct Way {
    /// Share of the power that leaves the heater towards the pan [-].
    efficiency: f64,
    /// Loss of what is between for each watt into the pan [-].
    on_the_way: f64,
    /// Loss of what is between at the pan's temperature [W].
    standing_w: f64,
}

impl HobDescription {
    /// Heat into a pan in which food browns, at a power, in the long run [W].
    pub fn heat_at(&self, power: f64) -> f64 {
        let Way { efficiency, on_the_way, standing_w } = self.way();
        ((efficiency * power - standing_w) / (1.0 + on_the_way)).max(0.0)
    }

    /// Power that gives a pan in which food browns a heat [W] in the long run; one that the dial has [W].
    pub fn power_for(&self, heat: f64) -> f64 {
        let Way { efficiency, on_the_way, standing_w } = self.way();
        if heat <= 0.0 || efficiency <= 0.0 {
            return 0.0;
        }
        self.nearest_w(((heat * (1.0 + on_the_way) + standing_w) / efficiency).min(self.largest_w()))
    }

    fn way(&self) -> Way {
        let direct = |efficiency| Way { efficiency, on_the_way: 0.0, standing_w: 0.0 };
        match self.heater() {
            None => direct(0.0),
            Some(Heater::Coil(coil)) => direct(coil.efficiency),
            Some(Heater::Flame(flame)) => {
                let cooler = (flame.plume_c - 20.0 - OVER_ROOM_K) / (flame.plume_c - 20.0);
                direct((flame.floor_share + flame.wall_share) * cooler)
            }
            Some(Heater::Element(element)) => {
                let (under, area) = (&self.under, PI * 1e-6 * element.radius_mm * element.radius_mm);
                let over_gap = under.loss_w_m2k / under.gap_conductance_w_m2k;
                Way {
                    efficiency: element.efficiency,
                    on_the_way: (1.0 - element.through_share) * over_gap,
                    standing_w: under.loss_w_m2k * area * OVER_ROOM_K,
                }
            }
            Some(Heater::Plate(plate)) => {
                let gap = plate.gap_conductance_w_m2k * PI * 1e-6 * plate.radius_mm * plate.radius_mm;
                Way {
                    efficiency: plate.efficiency,
                    on_the_way: plate.loss_w_k / gap,
                    standing_w: plate.loss_w_k * OVER_ROOM_K,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Library;

    #[test]
    fn a_heat_is_given_by_the_power_that_gives_it() {
        let library = Library::embedded().expect("embedded data");
        for (id, hob) in &library.hobs {
            for power in [0.3, 0.6, 0.9].map(|share| share * hob.largest_w()) {
                let (set, heat) = (hob.nearest_w(power), hob.heat_at(hob.nearest_w(power)));
                assert!((hob.power_for(heat) - set).abs() < 1e-6 * set, "{id}: {} for {set} W", hob.power_for(heat));
                assert!(heat > 0.3 * set && heat < set, "{id}: {heat} of {set} W");
            }
            assert_eq!(hob.power_for(0.0), 0.0);
        }
    }
}
