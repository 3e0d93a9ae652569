//! What the hob infers of the pan from its sensor under the glass: it holds a temperature with it and limits the power.

use saute_food::sourced_table;
use serde::{Deserialize, Serialize};

use crate::pan::hob::HobDescription;
use crate::tick::low_pass::low_pass;

sourced_table! {
    /// How the hob holds a pan at a temperature.
    Hold {
        /// Lowest temperature that may be held [°C].
        #[schemars(range(min = 0.0, max = 500.0), example = 50.0)]
        lowest_c: f64,
        /// Highest temperature that may be held [°C].
        #[schemars(range(min = 0.0, max = 500.0), example = 230.0)]
        highest_c: f64,
        /// Temperatures that the panel offers [°C].
        #[schemars(inner(range(min = 0.0, max = 500.0)), extend("examples" = [[160.0, 180.0, 200.0]]))]
        settings_c: Vec<f64>,
        /// Largest power that it uses if it is set at the panel [W].
        #[schemars(range(min = 1.0, max = 1e5), example = 2000.0)]
        panel_w: f64,
        /// Delay of the sensor behind the glass, as a time constant [s].
        #[schemars(range(min = 0.0, max = 600.0), example = 4.0)]
        sensor_delay_s: f64,
        /// Time between two readings of the sensor, after each of which the power is set anew [s].
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
        /// Power per kelvin below the held temperature [W/K].
        #[schemars(range(min = 0.1, max = 1e4), example = 40.0)]
        gain_w_k: f64,
        /// Time after which a lasting difference has doubled that power [s].
        #[schemars(range(min = 1.0, max = 1e5), example = 60.0)]
        reset_s: f64,
    }
}

/// The electronics that hold a pan at a temperature: a proportional–integral controller of the floor's mean
/// temperature, which it infers from the sensor under the middle of the glass and from the power that it gave.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct HoldControl {
    /// Temperature to hold [K]; none if the hob gives the power at which it is set.
    target: Option<f64>,
    /// Temperature of the sensor now and at the last reading [K]; none before the first tick.
    sensor: Option<[f64; 2]>,
    /// Time since the last reading [s].
    since_s: f64,
    /// Power as the ring's heat shows it, a low-pass of the power [W].
    ring: f64,
    /// Power for a lasting difference [W].
    integral: f64,
    /// Power now [W].
    power: f64,
    /// Part of the power that the temperature limit withholds [-].
    withheld: f64,
}

/// What the electronics meet in one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HoldLoad<'a> {
    /// The hob.
    pub hob: &'a HobDescription,
    /// Largest power to use [W].
    pub largest: f64,
    /// Power that the hob gives now [W].
    pub given: f64,
    /// Temperature of the glass above the sensor [K].
    pub glass: f64,
    /// Temperature of the room [K].
    pub room: f64,
    /// True if the hob detects a pan.
    pub detected: bool,
}

impl HoldControl {
    /// Temperature to hold [K]; none if the hob gives the power at which it is set.
    pub fn target(&self) -> Option<f64> {
        self.target
    }

    /// Sets the temperature to hold [K], or none. A new temperature keeps what the control has learnt.
    pub(crate) fn set(&mut self, target: Option<f64>) {
        *self = match (self.target, target) {
            (Some(_), Some(_)) => Self { target, ..*self },
            _ => Self { target, integral: 0.0, power: 0.0, ..*self },
        };
    }

    /// Share of the power that the temperature limit leaves [-].
    pub(crate) fn limit_share(&self) -> f64 {
        1.0 - self.withheld
    }

    /// Power of the hob, given the power at which it is set [W].
    pub(crate) fn power(&self, set: f64) -> f64 {
        if self.target.is_some() { self.power } else { set }
    }

    /// Advances the sensor by a tick of `dt` [s] and sets the power after each reading. Without a pan there is no power and
    /// the integral waits.
    pub(crate) fn advance(&mut self, load: &HoldLoad, dt: f64) {
        let hold = &load.hob.hold;
        let [before, last] = self.sensor.unwrap_or([load.glass; 2]);
        let mut now = before;
        low_pass(&mut now, load.glass, hold.sensor_delay_s, dt);
        self.since_s += dt;
        low_pass(&mut self.ring, load.given, hold.ring_delay_s, dt);
        let reads = self.since_s >= hold.period_s - 0.5 * dt;
        if let Some(target) = self.target.filter(|_| reads) {
            self.read(load, target, [now, last]);
        }
        if reads {
            self.withheld = load.hob.withheld(self.floor(load, [now, last]));
            self.since_s = 0.0;
        }
        self.sensor = Some([now, if reads { now } else { last }]);
        if !load.detected {
            self.power = 0.0;
        }
    }

    /// Mean temperature of the floor, inferred from the power, the sensor and its last reading [K].
    fn floor(&self, load: &HoldLoad, [sensor, last]: [f64; 2]) -> f64 {
        let hold = &load.hob.hold;
        let rate = (sensor - last) / hold.period_s;
        let over_middle = (hold.ring_k_w * (self.ring - hold.even_w)).max(-hold.rim_k);
        load.hob.pan_above_sensor(sensor, rate, load.room) + over_middle
    }

    /// Sets the power after a reading of the sensor, given with the reading before [K].
    fn read(&mut self, load: &HoldLoad, target: f64, [sensor, last]: [f64; 2]) {
        let hold = &load.hob.hold;
        let missing = target - self.floor(load, [sensor, last]);
        let proportional = hold.gain_w_k * missing;
        let integral = self.integral + proportional * hold.period_s / hold.reset_s;
        let wanted = proportional + integral;
        // At either end of the range the integral rests, or the pan would overshoot.
        if load.detected && (0.0..=load.largest).contains(&wanted) {
            self.integral = integral;
        }
        self.power = (proportional + self.integral).clamp(0.0, load.largest);
    }
}

impl HobDescription {
    /// Temperature of the pan above the sensor, inferred from the sensor [K] and the rate at which it rises [K/s]. In
    /// steady state the glass is colder than the pan by what it loses downwards; while it warms, it and the sensor lag.
    pub(crate) fn pan_above_sensor(&self, sensor: f64, rate: f64, room: f64) -> f64 {
        let glass = &self.glass;
        let offset = glass.loss_w_m2k / glass.gap_conductance_w_m2k * (sensor - room);
        sensor + offset + self.lag() * rate
    }

    /// Part of the power that the temperature limit withholds from a floor at `floor` [K]; it grows evenly to all of it at
    /// the limit [-].
    fn withheld(&self, floor: f64) -> f64 {
        (1.0 - (self.control.limit_c - crate::celsius(floor)) / self.control.resume_k).clamp(0.0, 1.0)
    }

    /// Time by which the sensor lags behind the pan [s].
    fn lag(&self) -> f64 {
        self.glass.areal_capacity_j_m2k / self.glass.gap_conductance_w_m2k + self.hold.sensor_delay_s
    }
}
