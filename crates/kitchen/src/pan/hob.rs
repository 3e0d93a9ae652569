//! A hob as its file describes it: its heater, what is below the pan and, on an induction hob, its electronics.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::pan::heater::disc::disc_shares;
use crate::pan::heater::{Coil, Control, Element, Flame, Grate, Heater, Plate};
use crate::pan::hold::Hold;
use crate::pan::under::Under;

/// A hob as its file describes it: one of coil, flame, element and plate, with what belongs to it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute hob")]
pub struct HobDescription {
    /// Name for people.
    #[schemars(example = &"Induction hob")]
    pub name: String,
    /// Coil of an induction hob; needs control and hold.
    pub coil: Option<Coil>,
    /// Flame of a gas burner; needs a grate.
    pub flame: Option<Flame>,
    /// Grate over a flame.
    pub grate: Option<Grate>,
    /// Radiant element behind glass-ceramic.
    pub element: Option<Element>,
    /// Iron plate.
    pub plate: Option<Plate>,
    /// Electronics of an induction hob.
    pub control: Option<Control>,
    /// What is below the pan.
    pub under: Under,
    /// Holding a pan on an induction hob at a temperature.
    pub hold: Option<Hold>,
}

/// The electronics of an induction hob.
#[derive(Clone, Copy, Debug)]
pub struct Electronics<'a> {
    /// Coil.
    pub coil: &'a Coil,
    /// What they do.
    pub control: &'a Control,
    /// Holding a pan at a temperature.
    pub hold: &'a Hold,
    /// Glass between pan and sensor.
    pub glass: &'a Under,
}

/// Place of a pan over its ring.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct PanPose {
    /// Centre of the pan relative to the ring's [m].
    pub at: [f64; 2],
    /// Height above the glass [m].
    pub lift: f64,
}

impl HobDescription {
    /// What makes its heat. A file that was checked has exactly one; without any, nothing is heated.
    pub fn heater(&self) -> Option<Heater<'_>> {
        let coil = self.coil.as_ref().map(Heater::Coil);
        let flame = || self.flame.as_ref().map(Heater::Flame);
        let element = || self.element.as_ref().map(Heater::Element);
        coil.or_else(flame).or_else(element).or_else(|| self.plate.as_ref().map(Heater::Plate))
    }

    /// The electronics of an induction hob; none of any other stove, which has no sensor.
    pub fn electronics(&self) -> Option<Electronics<'_>> {
        Some(Electronics {
            coil: self.coil.as_ref()?,
            control: self.control.as_ref()?,
            hold: self.hold.as_ref()?,
            glass: &self.under,
        })
    }

    /// How it holds a pan at a temperature; none if it has no sensor.
    pub fn hold(&self) -> Option<&Hold> {
        self.electronics().map(|electronics| electronics.hold)
    }

    /// Largest power that may be set [W].
    pub fn largest_w(&self) -> f64 {
        self.heater().map_or(0.0, |heater| match heater {
            Heater::Coil(coil) => coil.largest_w,
            Heater::Flame(flame) => flame.largest_w,
            Heater::Element(element) => element.largest_w,
            Heater::Plate(plate) => plate.largest_w(),
        })
    }

    /// Settings on its dial [W].
    pub fn settings_w(&self) -> &[f64] {
        self.heater().map_or(&[], |heater| match heater {
            Heater::Coil(coil) => &coil.settings_w,
            Heater::Flame(flame) => &flame.settings_w,
            Heater::Element(element) => &element.settings_w,
            Heater::Plate(plate) => &plate.settings_w,
        })
    }

    /// Power that a dial set to `w` gives [W]: a plate has steps, and no flame is smaller than the smallest.
    pub fn nearest_w(&self, w: f64) -> f64 {
        match self.heater() {
            Some(Heater::Flame(flame)) => flame.nearest_w(w),
            Some(Heater::Plate(plate)) => plate.nearest_w(w),
            Some(Heater::Coil(_) | Heater::Element(_)) | None => w,
        }
    }

    /// Share of the power that reaches a cold pan or leaves upwards [-].
    pub fn efficiency(&self) -> f64 {
        self.heater().map_or(0.0, |heater| match heater {
            Heater::Coil(coil) => coil.efficiency,
            Heater::Flame(flame) => flame.floor_share + flame.wall_share,
            Heater::Element(element) => element.efficiency,
            Heater::Plate(plate) => plate.efficiency,
        })
    }

    /// Multiplies that share by a factor, up to 1.
    pub fn scale_efficiency(&mut self, factor: f64) {
        let scaled = |share: f64| (factor * share).min(1.0);
        if let Some(coil) = &mut self.coil {
            coil.efficiency = scaled(coil.efficiency);
        }
        if let Some(flame) = &mut self.flame {
            (flame.floor_share, flame.wall_share) = (scaled(flame.floor_share), scaled(flame.wall_share));
        }
        if let Some(element) = &mut self.element {
            element.efficiency = scaled(element.efficiency);
        }
        if let Some(plate) = &mut self.plate {
            plate.efficiency = scaled(plate.efficiency);
        }
    }

    /// Share of the set power in each node of a pan's floor [-]. The shares of a coil sum to 1 on the ring, to less off it,
    /// and to 0 if the pan is too far away to be detected; those of other heaters are what is over them.
    pub fn ring_shares(&self, points: &[[f64; 2]], areas: &[f64], pose: &PanPose) -> Vec<f64> {
        match self.heater() {
            Some(Heater::Coil(coil)) => self.coil_shares(coil, points, areas, pose),
            Some(Heater::Flame(flame)) => {
                let coupling = flame.coupling(pose.lift);
                flame.shares(points, areas, pose.at).into_iter().map(|share| coupling * share).collect()
            }
            Some(Heater::Element(element)) => disc_shares(1e-3 * element.radius_mm, points, areas, pose.at),
            Some(Heater::Plate(plate)) => disc_shares(1e-3 * plate.radius_mm, points, areas, pose.at),
            None => vec![0.0; points.len()],
        }
    }

    fn coil_shares(&self, coil: &Coil, points: &[[f64; 2]], areas: &[f64], pose: &PanPose) -> Vec<f64> {
        let weights = |at: [f64; 2]| -> Vec<f64> {
            points.iter().zip(areas).map(|(p, a)| coil.flux(libm::hypot(p[0] + at[0], p[1] + at[1])) * a).collect()
        };
        let whole: f64 = weights([0.0; 2]).iter().sum();
        let coupling = self.control.as_ref().map_or(0.0, |control| coil.coupling(control, pose));
        if whole == 0.0 {
            // A coil that is between two rings of nodes heats the node in the middle.
            return (0..points.len()).map(|i| if i == 0 { coupling } else { 0.0 }).collect();
        }
        weights(pose.at).iter().map(|w| coupling * w / whole).collect()
    }

    /// Returns true if the hob gives power to a pan at a place: one that detects pans does not where there is none.
    pub fn detects(&self, pose: &PanPose) -> bool {
        self.electronics().is_none_or(|electronics| electronics.coil.detects(electronics.control, pose))
    }

    /// Largest conductance from below to a place of a pan [W/(m²·K)]; limits the stable step.
    pub(crate) fn steepest_w_m2k(&self) -> f64 {
        let heater = match self.heater() {
            Some(Heater::Flame(flame)) => self.grate.as_ref().map_or(0.0, |grate| flame.steepest_w_m2k(grate)),
            Some(Heater::Element(element)) => element.steepest_w_m2k(),
            Some(Heater::Plate(plate)) => plate.gap_conductance_w_m2k,
            Some(Heater::Coil(_)) | None => 0.0,
        };
        heater + self.under.gap_conductance_w_m2k
    }

    /// Longest stable step of what is below the pan [s].
    pub(crate) fn under_step_s(&self) -> f64 {
        let under = &self.under;
        let glow = self.element.as_ref().map_or(0.0, Element::steepest_w_m2k);
        0.5 * under.areal_capacity_j_m2k / (under.gap_conductance_w_m2k + under.loss_w_m2k + glow)
    }

    /// Mean power over a tick from `time` to `time + dt` [W]; a coil's low settings and an element are switched on and off.
    pub fn switched(&self, power: f64, time: f64, dt: f64) -> f64 {
        let (full, period) = match (&self.control, &self.element) {
            (Some(control), _) => (control.duty_below_w, control.duty_period_s),
            (None, Some(element)) => (element.largest_w, element.period_s),
            (None, None) => return power,
        };
        if power <= 0.0 || power >= full {
            return power;
        }
        let on_until = |t: f64| {
            let periods = libm::floor(t / period);
            (periods * power / full + (t / period - periods).min(power / full)) * period
        };
        full * (on_until(time + dt) - on_until(time)) / dt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hob() -> HobDescription {
        crate::Library::embedded().expect("embedded data").hob
    }

    #[test]
    fn low_settings_are_switched_and_keep_their_mean() {
        let hob = hob();
        let ticks: Vec<f64> = (0..20).map(|i| hob.switched(200.0, f64::from(i) * 0.1, 0.1)).collect();
        assert!((ticks.iter().sum::<f64>() / 20.0 - 200.0).abs() < 1e-6, "{ticks:?}");
        assert!((ticks[0] - 500.0).abs() < 1e-6 && ticks[19].abs() < 1e-6);
        assert_eq!(hob.switched(800.0, 3.0, 0.1), 800.0);
    }

    #[test]
    fn a_pan_lifted_or_off_its_ring_gets_no_power() {
        let hob = hob();
        let (points, areas) = ([[0.05, 0.0], [-0.05, 0.0]], [1.0, 1.0]);
        let total = |pose: PanPose| hob.ring_shares(&points, &areas, &pose).iter().sum::<f64>();
        assert!((total(PanPose::default()) - 1.0).abs() < 1e-12);
        assert!((total(PanPose { lift: 0.0075, ..Default::default() }) - 0.7).abs() < 1e-12);
        assert_eq!(total(PanPose { lift: 0.016, ..Default::default() }), 0.0);
        assert_eq!(total(PanPose { at: [0.1, 0.0], lift: 0.0 }), 0.0);
        let beside = total(PanPose { at: [0.06, 0.0], lift: 0.0 });
        assert!(beside < 0.9, "{beside}");
    }

    #[test]
    fn a_coil_that_lies_between_two_rings_of_nodes_heats_the_middle() {
        let mut hob = hob();
        hob.coil.as_mut().expect("a coil").radius_mm = 10.0;
        let shares = hob.ring_shares(&[[0.0; 2], [0.02, 0.0]], &[1.0, 1.0], &PanPose::default());
        assert_eq!(shares, [1.0, 0.0]);
    }
}
