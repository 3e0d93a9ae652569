//! The empty pan as it heats up.

use saute_kitchen::{Command, Kitchen, Library, TICK_S, TICKS_PER_S, celsius, kelvin};

use crate::schedule::Order;
use crate::schedule::candidate::job::JobError;

/// Temperature of a pan from the cupboard [°C], as recipes have it.
const COLD_C: f64 = 20.0;
/// Longest preheating [s] (chosen: a weak hob's pan is in equilibrium by then).
const LONGEST_S: u32 = 900;
/// Temperature up to which it is heated [°C] (chosen: oil smokes there).
const HOTTEST_C: f64 = 240.0;

/// Mean temperature of the pan's floor at each second of preheating with the largest power [°C].
#[derive(Clone, Debug)]
pub(crate) struct Heating(Vec<f64>);

impl Heating {
    /// Heats the empty pan of an order.
    pub(crate) fn of(order: &Order, library: &Library) -> Result<Self, JobError> {
        let mut kitchen = Kitchen::new(library, &order.pan, kelvin(COLD_C))?;
        let power = order.hob_w.last().copied().unwrap_or_default();
        // Every hob can be set.
        let _ = kitchen.apply(&Command::Hob(power));
        let mut curve = vec![COLD_C];
        while curve.last().is_some_and(|c| *c < HOTTEST_C) && kitchen.time_s() < f64::from(LONGEST_S) - TICK_S {
            (0..TICKS_PER_S).for_each(|_| kitchen.step());
            curve.push(celsius(kitchen.pan_temperature()));
        }
        Ok(Self(curve))
    }

    /// Returns when the pan has a temperature [s], or when heating ended.
    pub(crate) fn put_s(&self, pan_c: u32) -> u32 {
        let reached = self.0.iter().position(|c| *c >= f64::from(pan_c));
        reached.unwrap_or(self.0.len().saturating_sub(1)) as u32
    }
}
