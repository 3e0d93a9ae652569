//! What the hob's electronics infer of the pan: a model of its class that follows what they measure.

use serde::{Deserialize, Serialize};

use crate::pan::pan_class::{FLOOR, PanClass, RINGS};
use crate::pan::under::Under;

/// The pan as the electronics estimate it: an observer of the assumed class.
///
/// Each ring of the class takes its share of the power, conducts to its neighbours, loses heat to glass and air, and a
/// load takes heat evenly from the floor, a liquid by how hot each place is. What the coil measures, the mean of the heated ring, corrects the rings and the
/// load: Ṫ += e/τ, q̇ = −C e/(4τ²), with e measured minus inferred; critically damped.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct ObservedPan {
    /// Temperature of each ring [K].
    rings: [f64; RINGS],
    /// Temperature of the glass below each ring of the floor [K].
    glass: [f64; FLOOR],
    /// Heat flow from the floor into what is in the pan [W].
    pub(crate) load_w: f64,
}

/// Known quantities of the electronics in one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<'a> {
    /// Class of the pan.
    pub(crate) class: &'a PanClass,
    /// Their own glass.
    pub(crate) glass: &'a Under,
    /// Loss of one face of the pan to the air that they assume [W/(m²·K)].
    pub(crate) air_w_m2k: f64,
    /// Temperature of the room [K].
    pub(crate) room: f64,
    /// Mean of the heated ring, as the coil measures it [K].
    pub(crate) ring: f64,
    /// Heat that they make in the pan [W].
    pub(crate) heat_w: f64,
    /// Conductance from the floor to a liquid, which takes more heat where the floor is hotter; 0 for any other load
    /// [W/(m²·K)].
    pub(crate) liquid_w_m2k: f64,
    /// Time constant with which the measured corrects the inferred [s].
    pub(crate) correction_s: f64,
}

impl ObservedPan {
    /// A pan of which only the ring's temperature is known, on a glass at `glass` [K].
    pub(crate) fn first_seen(ring: f64, glass: f64) -> Self {
        Self { rings: [ring; RINGS], glass: [glass; FLOOR], load_w: 0.0 }
    }

    /// Area mean of the floor [K].
    pub(crate) fn floor(&self, class: &PanClass) -> f64 {
        class.floor_mean(&self.rings)
    }

    /// Advances by `dt` [s], then corrects what is inferred by what is measured.
    pub(crate) fn advance(&mut self, known: &Known, dt: f64) {
        self.conduct(known, dt);
        self.warm_glass(known, dt);
        let error = known.ring - known.class.heated_mean(&self.rings);
        let rate = 1.0 / known.correction_s;
        let share = 1.0 - libm::exp(-rate * dt);
        self.rings.iter_mut().for_each(|t| *t += share * error);
        self.load_w -= known.class.floor_capacity * error * 0.25 * rate * share;
    }

    /// One implicit step of the rings: a tridiagonal system, solved by elimination.
    fn conduct(&mut self, known: &Known, dt: f64) {
        let class = known.class;
        let (mut factor, mut value) = ([0.0; RINGS], [0.0; RINGS]);
        let mean = self.floor(class);
        for i in 0..RINGS {
            let before = if i > 0 { class.links[i - 1] } else { 0.0 };
            let [to_glass, to_air] = known.losses(i);
            let stored = class.capacity[i] / dt;
            let below = if i < FLOOR { self.glass[i] } else { 0.0 };
            let to_liquid = if i < FLOOR { class.areas[i] * known.liquid_w_m2k } else { 0.0 };
            let whole = stored + before + class.links[i] + to_glass + to_air + to_liquid;
            let around = to_glass * below + to_air * known.room + to_liquid * mean;
            let taken = stored * self.rings[i] + around + self.heating(known, i);
            let (last, factor_before) = if i > 0 { (value[i - 1], factor[i - 1]) } else { (0.0, 0.0) };
            let pivot = whole - before * factor_before;
            factor[i] = class.links[i] / pivot;
            value[i] = (taken + before * last) / pivot;
        }
        let mut next = 0.0;
        for i in (0..RINGS).rev() {
            next = value[i] + factor[i] * next;
            self.rings[i] = next;
        }
    }

    /// Heat made in a ring less what the load takes from it [W].
    fn heating(&self, known: &Known, i: usize) -> f64 {
        let class = known.class;
        let share = if i < FLOOR { class.areas[i] / class.floor_area } else { 0.0 };
        known.heat_w * class.shares[i] - self.load_w * share
    }

    fn warm_glass(&mut self, known: &Known, dt: f64) {
        let glass = known.glass;
        for (t, ring) in self.glass.iter_mut().zip(&self.rings) {
            let (stored, gap, loss) = (glass.areal_capacity_j_m2k / dt, glass.gap_conductance_w_m2k, glass.loss_w_m2k);
            *t = (stored * *t + gap * ring + loss * known.room) / (stored + gap + loss);
        }
    }

    /// Heat flow from a ring to glass, air and the rings next to it [W].
    fn leaving(&self, known: &Known, i: usize) -> f64 {
        let (class, t) = (known.class, self.rings[i]);
        let [to_glass, to_air] = known.losses(i);
        let below = if i < FLOOR { to_glass * (t - self.glass[i]) } else { 0.0 };
        let inwards = if i > 0 { class.links[i - 1] * (t - self.rings[i - 1]) } else { 0.0 };
        let outwards = if i + 1 < RINGS { class.links[i] * (t - self.rings[i + 1]) } else { 0.0 };
        below + to_air * (t - known.room) + inwards + outwards
    }

    /// Heat that keeps the floor's mean as it is: what leaves it to glass, air and wall, and the load [W].
    pub(crate) fn kept_by(&self, known: &Known) -> f64 {
        (0..FLOOR).map(|i| self.leaving(known, i)).sum::<f64>() + self.load_w
    }

    /// Heat that takes the ring that would be hottest to `most` [K] within `time` [s] [W].
    pub(crate) fn hottest_within(&self, known: &Known, most: f64, time: f64) -> f64 {
        let (class, mean) = (known.class, self.floor(known.class));
        let heat = |i: usize| {
            let load = self.load_w * class.areas[i] / class.floor_area;
            let more = class.areas[i] * known.liquid_w_m2k * (self.rings[i] - mean);
            let kept = self.leaving(known, i) + load + more;
            (class.capacity[i] * (most - self.rings[i]) / time + kept) / class.shares[i]
        };
        (0..FLOOR).filter(|i| class.shares[*i] > 0.01).map(heat).fold(f64::INFINITY, f64::min)
    }
}

impl Known<'_> {
    /// Conductances of a ring to the glass and to the air [W/K]; a wall has two faces.
    fn losses(&self, i: usize) -> [f64; 2] {
        let area = self.class.areas[i];
        if i < FLOOR {
            [area * self.glass.gap_conductance_w_m2k, area * self.air_w_m2k]
        } else {
            [0.0, 2.0 * area * self.air_w_m2k]
        }
    }
}
