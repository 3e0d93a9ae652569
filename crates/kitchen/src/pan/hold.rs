//! What the hob's electronics do with what they measure: they hold a temperature and limit the power.

use saute_food::sourced_table;
use serde::{Deserialize, Serialize};

use crate::pan::heater::Control;
use crate::pan::hob::Electronics;
use crate::pan::observed_pan::{Known, ObservedPan};
use crate::pan::pan_class::PanClass;
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
        /// Steps in which it is read [K].
        #[schemars(range(min = 0.0, max = 20.0), example = 0.5)]
        sensor_step_k: f64,
        /// Time between two settings of the power [s].
        #[schemars(range(min = 0.1, max = 60.0), example = 1.0)]
        period_s: f64,
        /// By how much the coil reads the heated ring too hot at 200 K above the room, and evenly less below [K].
        #[schemars(range(min = -20.0, max = 20.0), example = 3.0)]
        coil_error_k: f64,
        /// Time constant with which what the coil measures corrects what is inferred [s].
        #[schemars(range(min = 0.2, max = 600.0), example = 2.0)]
        correction_s: f64,
        /// Heat capacity and conductance of the class of pan that is named to the hob, over those of the pan [-].
        #[schemars(range(min = 0.2, max = 5.0), example = 1.0)]
        class_share: f64,
        /// Loss of one face of the pan to the air that the electronics assume [W/(m²·K)].
        #[schemars(range(min = 0.0, max = 200.0), example = 12.0)]
        air_w_m2k: f64,
        /// Time in which they make up for what is missing [s].
        #[schemars(range(min = 1.0, max = 600.0), example = 8.0)]
        settle_s: f64,
        /// By how much the hottest place may be hotter than the temperature to hold [K].
        #[schemars(range(min = 5.0, max = 300.0), example = 45.0)]
        hottest_k: f64,
        /// Heat capacities of a load between which it counts more and more as a liquid, whose temperature is to be held [J/K].
        #[schemars(inner(range(min = 1.0, max = 1e6)), extend("examples" = [[800.0, 1500.0]]))]
        liquid_j_k: [f64; 2],
        /// Conductance from floor to a liquid that they assume [W/(m²·K)].
        #[schemars(range(min = 10.0, max = 1e5), example = 1200.0)]
        liquid_w_m2k: f64,
        /// By how much the floor is made hotter below water that is not to boil and below oil, over what they are hotter than the
        /// room [-].
        #[schemars(inner(range(min = 0.0, max = 1.0)), extend("examples" = [[0.05, 0.02]]))]
        liquid_over_share: [f64; 2],
    }
}

/// By how much the floor must warm until the load's heat capacity counts as learnt [K], and the time without warming after which
/// it begins again [s] (chosen: the floor below a steak that was put in or turned recovers by less).
const LEARNT_K: f64 = 20.0;
const STILL_S: f64 = 20.0;
/// By how much a floor may cool until it no longer counts as held [K] (chosen: a steak that is put in costs less).
const LOST_K: f64 = 50.0;
/// How near a floor is that counts as held [K] (chosen: what the dial promises).
const REACHED_K: f64 = 5.0;
/// Temperature to hold that water cannot have [K] (chosen: a hob does not distinguish 99 °C from boiling).
const BOILING_K: f64 = saute_food::ZERO_C + 98.0;
/// Floor above which water does not last [K], load that counts as none [W], and the time after which the pan then holds no liquid
/// [s] (chosen: what boils takes kilowatts, and hot oil gives off more).
const BOILED_K: f64 = saute_food::ZERO_C + 105.0;
const DRY_W: f64 = 25.0;
const DRY_S: f64 = 45.0;

/// The electronics that hold a pan at a temperature.
///
/// P = (what leaves the floor + load + C (target − floor)/settle) / efficiency, no more than takes the hottest ring to its
/// bound; all of it inferred by an observer, so that nothing is saved up while the power is at either end of its range.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct HoldControl {
    /// Temperature to hold [K]; none if the hob gives the power at which it is set.
    target: Option<f64>,
    /// Temperature of the sensor under the glass [K]; none before the first tick.
    sensor: Option<f64>,
    /// The pan as it is inferred; none while no pan is detected.
    pan: Option<ObservedPan>,
    /// What is learnt of the load.
    learnt: Learnt,
    /// Its state.
    holding: Holding,
    /// Time since the power was set [s].
    since_s: f64,
    /// Power now [W].
    power: f64,
    /// Part of the power that the temperature limit withholds [-].
    withheld: f64,
}

/// State of a hob that keeps a temperature.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
pub enum Holding {
    /// The pan is not as hot yet.
    #[default]
    Warms,
    /// The pan is as hot as it is held.
    Reached,
    /// Water boils in the pan, which gets hotter only without it.
    Boils,
}

/// Heat capacity of the load, learnt while the pan warms.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
struct Learnt {
    /// Floor at which it began to warm, and the hottest since then [K]; none before the first reading.
    warmed: Option<[f64; 2]>,
    /// Heat into the load since it began [J].
    heat: f64,
    /// Time for which it has not become hotter [s].
    still_s: f64,
    /// Heat capacity [J/K].
    capacity: f64,
    /// Time for which the load has taken and given nothing [s].
    idle_s: f64,
}

impl Learnt {
    /// Share to which the load counts as a liquid [-].
    fn liquid_share(&self, hold: &Hold) -> f64 {
        let [least, whole] = hold.liquid_j_k;
        ((self.capacity - least) / (whole - least).max(1.0)).clamp(0.0, 1.0)
    }

    /// Learns for `dt` [s] from the floor [K] and the load [W].
    fn follow(&mut self, floor: f64, load_w: f64, dt: f64) {
        let [from, top] = self.warmed.unwrap_or([floor; 2]);
        self.still_s = if floor > top { 0.0 } else { self.still_s + dt };
        self.heat += load_w * dt;
        self.warmed = Some([from, floor.max(top)]);
        if self.still_s > STILL_S {
            (self.warmed, self.heat, self.still_s) = (Some([floor; 2]), 0.0, 0.0);
        } else if top - from > LEARNT_K {
            self.capacity = (self.heat / (top - from)).max(0.0);
        }
        let is_idle = floor > BOILED_K && load_w.abs() < DRY_W;
        self.idle_s = if is_idle { self.idle_s + dt } else { 0.0 };
        if self.idle_s > DRY_S {
            self.capacity = 0.0;
        }
    }
}

/// What the electronics meet in one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HoldLoad<'a> {
    /// The electronics.
    pub hob: Electronics<'a>,
    /// Class of the pan on the hob.
    pub class: &'a PanClass,
    /// Largest power to use [W].
    pub largest: f64,
    /// Power that the hob gives now [W].
    pub given: f64,
    /// Temperature of the glass above the sensor [K].
    pub glass: f64,
    /// Mean temperature of the heated ring; none if the hob detects no pan [K].
    pub ring: Option<f64>,
    /// True if water boils in the pan: for what the hob reports, never for what it gives.
    pub boils: bool,
    /// Temperature of the room [K].
    pub room: f64,
}

impl HoldLoad<'_> {
    /// What is known with a load of which a `liquid` share counts as a liquid [-].
    fn known(&self, ring: f64, liquid: f64) -> Known<'_> {
        let hold = self.hob.hold;
        Known {
            class: self.class,
            glass: self.hob.glass,
            air_w_m2k: hold.air_w_m2k,
            room: self.room,
            ring: ring + hold.coil_error_k * (ring - self.room) / 200.0,
            heat_w: self.hob.coil.efficiency * self.given,
            liquid_w_m2k: liquid * hold.liquid_w_m2k,
            correction_s: hold.correction_s,
        }
    }
}

impl HoldControl {
    /// Temperature to hold [K]; none if the hob gives the power at which it is set.
    pub fn target(&self) -> Option<f64> {
        self.target
    }

    /// Sets the temperature to hold [K], or none. What is inferred of the pan stays.
    pub(crate) fn set(&mut self, target: Option<f64>) {
        let power = if self.target.is_some() && target.is_some() { self.power } else { 0.0 };
        let holding = if self.target == target { self.holding } else { Holding::Warms };
        *self = Self { target, power, holding, ..*self };
    }

    /// Its state; none if it keeps no temperature.
    pub(crate) fn holding(&self) -> Option<Holding> {
        self.target.map(|_| self.holding)
    }

    /// Share of the power that the temperature limit leaves [-].
    pub(crate) fn limit_share(&self) -> f64 {
        1.0 - self.withheld
    }

    /// Power of the hob, given the power at which it is set [W].
    pub(crate) fn power(&self, set: f64) -> f64 {
        if self.target.is_some() { self.power } else { set }
    }

    /// Advances what is measured and inferred by a tick of `dt` [s], and sets the power after each period. Without a pan
    /// there is no power.
    pub(crate) fn advance(&mut self, load: &HoldLoad, dt: f64) {
        let hold = load.hob.hold;
        let mut sensor = self.sensor.unwrap_or(load.glass);
        low_pass(&mut sensor, load.glass, hold.sensor_delay_s, dt);
        self.sensor = Some(sensor);
        let Some(ring) = load.ring else {
            (self.pan, self.learnt, self.power, self.withheld) = (None, Learnt::default(), 0.0, 0.0);
            return;
        };
        let known = load.known(ring, self.learnt.liquid_share(hold));
        let read = stepped(sensor, hold.sensor_step_k);
        let pan = self.pan.get_or_insert_with(|| ObservedPan::first_seen(known.ring, read));
        pan.advance(&known, dt);
        self.since_s += dt;
        if self.since_s >= hold.period_s - 0.5 * dt {
            self.set_power(load, &known);
            self.since_s = 0.0;
        }
    }

    fn set_power(&mut self, load: &HoldLoad, known: &Known) {
        let Some(pan) = self.pan else { return };
        let (hold, class) = (load.hob.hold, load.class);
        let floor = pan.floor(class);
        self.learnt.follow(floor, pan.load_w, self.since_s);
        self.withheld = load.hob.control.withheld(floor).max(withheld_for_the_rings(load, known, &pan));
        let Some(target) = self.target else { return };
        let missing = self.aim(load, target) - floor;
        self.holding = match self.holding {
            _ if load.boils && target > BOILING_K => Holding::Boils,
            Holding::Reached if missing < LOST_K => Holding::Reached,
            _ if missing < REACHED_K => Holding::Reached,
            _ => Holding::Warms,
        };
        let wanted = pan.kept_by(known) + class.floor_capacity * missing / hold.settle_s;
        let bound = pan.hottest_within(known, target + hold.hottest_k, 0.5 * hold.settle_s);
        self.power = (wanted.min(bound) / load.hob.coil.efficiency).clamp(0.0, load.largest);
    }

    /// Temperature that the floor is to have [K]: that of the dial, and below a liquid more, by which it makes up for what the
    /// liquid loses to the air.
    fn aim(&self, load: &HoldLoad, target: f64) -> f64 {
        let hold = load.hob.hold;
        let [water, oil] = hold.liquid_over_share;
        let over = if target < BOILING_K { water } else { oil } * (target - load.room).max(0.0);
        target + over * self.learnt.liquid_share(hold)
    }
}

/// Part of the set power that is withheld so that no ring gets so hot that oil would burn there [-].
fn withheld_for_the_rings(load: &HoldLoad, known: &Known, pan: &ObservedPan) -> f64 {
    let control = load.hob.control;
    let most = saute_food::ZERO_C + control.limit_c + control.hottest_k;
    let bound = pan.hottest_within(known, most, 0.5 * load.hob.hold.settle_s) / load.hob.coil.efficiency;
    if load.largest > 0.0 { 1.0 - (bound / load.largest).clamp(0.0, 1.0) } else { 0.0 }
}

/// A reading in steps [K].
fn stepped(value: f64, step: f64) -> f64 {
    if step > 0.0 { libm::round(value / step) * step } else { value }
}

impl Control {
    /// Part of the power that the temperature limit withholds from a floor at `floor` [K]; it grows evenly to all of it at
    /// the limit [-].
    fn withheld(&self, floor: f64) -> f64 {
        (1.0 - (self.limit_c - crate::celsius(floor)) / self.resume_k).clamp(0.0, 1.0)
    }
}
