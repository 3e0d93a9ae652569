//! The limit of overheating: what the hob infers of a pan that it gives a set power, from the sensor under the glass alone.

use saute_food::sourced_table;
use serde::{Deserialize, Serialize};

use crate::pan::hob::Electronics;
use crate::tick::low_pass::low_pass;

sourced_table! {
    /// How the hob infers the floor's mean temperature from the sensor and the power.
    Overheat {
        /// Time between two readings of the sensor [s].
        #[schemars(range(min = 0.1, max = 60.0), example = 2.0)]
        period_s: f64,
        /// Power at which the floor is on average as hot as above the sensor [W]. With more power the ring, away from the
        /// sensor, is hotter; with less the rim is colder.
        #[schemars(range(min = 0.0, max = 1e4), example = 500.0)]
        even_w: f64,
        /// How much hotter the floor is on average than above the sensor, per watt above that power [K/W].
        #[schemars(range(min = 0.0, max = 10.0), example = 0.03)]
        ring_k_w: f64,
        /// How much colder it may be at most, with little power [K].
        #[schemars(range(min = 0.0, max = 200.0), example = 15.0)]
        rim_k: f64,
        /// Time constant with which that difference follows the power [s].
        #[schemars(range(min = 0.1, max = 600.0), example = 20.0)]
        ring_delay_s: f64,
    }
}

/// What the limit has read.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub(crate) struct OverheatLimit {
    /// Temperature of the sensor now and at the last reading [K]; none before the first tick.
    sensor: Option<[f64; 2]>,
    /// Time since the last reading [s].
    since_s: f64,
    /// Power as the ring's heat shows it, a low-pass of the power [W].
    ring: f64,
    /// Mean temperature of the floor at the last reading, inferred [K].
    pub(crate) floor: Option<f64>,
}

impl OverheatLimit {
    /// Advances the sensor by a tick of `dt` [s], below glass at `glass` [K] with a power of `given` [W].
    pub(crate) fn advance(&mut self, hob: &Electronics, (glass, given, room): (f64, f64, f64), dt: f64) {
        let limit = hob.overheat;
        let [before, last] = self.sensor.unwrap_or([glass; 2]);
        let mut now = before;
        low_pass(&mut now, glass, hob.hold.sensor_delay_s, dt);
        self.since_s += dt;
        low_pass(&mut self.ring, given, limit.ring_delay_s, dt);
        let reads = self.since_s >= limit.period_s - 0.5 * dt;
        if reads {
            let rate = (now - last) / limit.period_s;
            let over_middle = (limit.ring_k_w * (self.ring - limit.even_w)).max(-limit.rim_k);
            self.floor = Some(hob.pan_above_sensor(now, rate, room) + over_middle);
            self.since_s = 0.0;
        }
        self.sensor = Some([now, if reads { now } else { last }]);
    }

    /// Temperature of the sensor [K]; none before the first tick.
    pub(crate) fn sensor(&self) -> Option<f64> {
        self.sensor.map(|[now, _]| now)
    }
}

impl Electronics<'_> {
    /// Temperature of the pan above the sensor, inferred from the sensor [K] and the rate at which it rises [K/s]. In
    /// steady state the glass is colder than the pan by what it loses downwards; while it warms, it and the sensor lag.
    fn pan_above_sensor(&self, sensor: f64, rate: f64, room: f64) -> f64 {
        let glass = self.glass;
        let offset = glass.loss_w_m2k / glass.gap_conductance_w_m2k * (sensor - room);
        sensor + offset + self.lag() * rate
    }

    /// Time by which the sensor lags behind the pan [s].
    fn lag(&self) -> f64 {
        self.glass.areal_capacity_j_m2k / self.glass.gap_conductance_w_m2k + self.hold.sensor_delay_s
    }
}
