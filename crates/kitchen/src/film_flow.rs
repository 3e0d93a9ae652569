//! Flow of a thin liquid film over the pan under gravity and acceleration.
//!
//! Lubrication theory: a film of thickness h flows with the mean speed u = h²/(3ν) · |∇Π|, where Π = −g·x + g_n h is
//! the potential of its surface; no film outruns a body that falls through the same potential, u < √(2 ΔΠ).
//!
//! A tick is two sweeps over all faces, there and back. Each face is implicit in the two nodes that it joins, so it never
//! passes more than lets their surfaces meet, and never more than its donor has: whatever the step, masses are kept to
//! rounding, no thickness becomes negative, and no surface leaves the range of those around it by levelling.

use crate::bed::Bed;

/// Gravity that presses a film onto the pan is reckoned with at least this [m/s²] (chosen: keeps levelling defined on a
/// pan that is tossed or stands on edge).
const LEAST_PRESSING: f64 = 0.5;
/// Potential difference that drives nothing [m²/s²] (chosen: a tenth of a nanometre of height).
const LEAST_DROP: f64 = 1e-9;

/// How a liquid runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// Density [kg/m³].
    pub density: f64,
    /// Thickness to which a puddle spreads; 0 for a liquid that wets [m].
    pub puddle: f64,
    /// What stays behind, above 0: so no node runs dry by rounding [m].
    pub clinging: f64,
}

/// What came of a liquid's flow in one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    /// What ran over the rim [kg].
    pub spilled: f64,
    /// Its heat above 0 °C [J].
    pub spilled_heat: f64,
    /// Largest change of thickness [m].
    pub moved: f64,
}

/// Direction of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sweep {
    /// From the middle to the rim.
    #[default]
    There,
    /// From the rim to the middle.
    Back,
}

impl Sweep {
    /// Both sweeps of a tick.
    pub const BOTH: [Self; 2] = [Self::There, Self::Back];

    /// The numbers below `count` in the order of this sweep.
    fn order(self, count: usize) -> impl Iterator<Item = usize> {
        (0..count).map(move |k| if self == Self::There { k } else { count - 1 - k })
    }
}

/// Flow of one liquid.
#[derive(Clone, Debug, Default)]
pub struct FilmFlow {
    /// One over the kinematic viscosity at each node [s/m²]; set by the liquid before it runs.
    pub fluidity: Vec<f64>,
    /// Share of its donor's liquid that each edge passed in the last sweep, one after the other; positive from `a` to `b`.
    passed: Vec<f64>,
    /// Share of its node's liquid that each rim face passed after them.
    spilled: Vec<f64>,
    potential: Vec<f64>,
    pressing: Vec<f64>,
    thickness: Vec<f64>,
    lip: Vec<f64>,
}

impl FilmFlow {
    /// Brings the potentials of the pan's places up to date with a gravity in the pan's frame [m/s²].
    pub fn lean(&mut self, bed: &Bed, gravity: [f64; 3]) {
        let along = |p: &[f64; 3]| p[0] * gravity[0] + p[1] * gravity[1] + p[2] * gravity[2];
        self.potential.clear();
        self.potential.extend(bed.places.iter().map(|p| -along(p)));
        self.pressing.clear();
        self.pressing.extend(bed.normals.iter().map(|n| (-along(n)).max(LEAST_PRESSING)));
        self.lip.clear();
        self.lip.extend(bed.rim.iter().map(|rim| -along(&rim.lip)));
    }

    /// Sweeps a liquid of this `mass` at each node [kg] through `dt` [s]; returns the largest change of thickness [m]. The
    /// mass itself is moved by [`Self::carry`].
    pub fn sweep(&mut self, bed: &Bed, manner: &Manner, mass: &[f64], sweep: Sweep, dt: f64) -> f64 {
        self.thickness.clear();
        self.thickness.extend(mass.iter().zip(&bed.areas).map(|(m, a)| m / (manner.density * a)));
        self.passed.resize(bed.edges.len(), 0.0);
        self.spilled.resize(bed.rim.len(), 0.0);
        for e in sweep.order(bed.edges.len()) {
            self.pass(bed, manner, e, dt);
        }
        for r in 0..bed.rim.len() {
            self.spill(bed, manner, r, dt);
        }
        let before = mass.iter().zip(&bed.areas).map(|(m, a)| m / (manner.density * a));
        self.thickness.iter().zip(before).map(|(now, before)| libm::fabs(now - before)).fold(0.0, f64::max)
    }

    fn surface(&self, manner: &Manner, node: usize) -> f64 {
        self.potential[node] + self.pressing[node] * self.thickness[node].max(manner.puddle)
    }

    /// Passes liquid through an edge: with Q = K ΔΠ, backward Euler between the two nodes gives
    /// V = Δt K ΔΠ / (1 + Δt K (g_a/A_a + g_b/A_b)).
    #[inline]
    fn pass(&mut self, bed: &Bed, manner: &Manner, e: usize, dt: f64) {
        let edge = &bed.edges[e];
        let (a, b) = (edge.a as usize, edge.b as usize);
        let drop = self.surface(manner, a) - self.surface(manner, b);
        let (from, to) = if drop > 0.0 { (a, b) } else { (b, a) };
        let loose = dt * self.looseness(manner, from, libm::fabs(drop), edge.face, edge.length);
        if loose <= 0.0 {
            self.passed[e] = 0.0;
            return;
        }
        let meeting = loose * (self.pressing[a] / bed.areas[a] + self.pressing[b] / bed.areas[b]);
        let volume = loose * libm::fabs(drop) / (1.0 + meeting);
        let share = self.give(bed, manner, from, volume);
        self.thickness[to] += share.1 / bed.areas[to];
        self.passed[e] = if drop > 0.0 { share.0 } else { -share.0 };
    }

    /// Passes liquid over the rim, where it falls away.
    fn spill(&mut self, bed: &Bed, manner: &Manner, r: usize, dt: f64) {
        let (rim, lip) = (&bed.rim[r], self.lip[r]);
        let i = rim.node as usize;
        let drop = self.surface(manner, i) - lip - self.pressing[i] * manner.puddle;
        let loose = dt * self.looseness(manner, i, drop, rim.face, rim.length);
        let volume = loose * drop / (1.0 + loose * self.pressing[i] / bed.areas[i]);
        self.spilled[r] = if loose > 0.0 { self.give(bed, manner, i, volume).0 } else { 0.0 };
    }

    /// Takes a volume from a node, at most what does not cling; returns its share of what was there, and the volume.
    #[inline]
    fn give(&mut self, bed: &Bed, manner: &Manner, from: usize, volume: f64) -> (f64, f64) {
        let mobile = self.thickness[from] - manner.clinging;
        let given = (volume / bed.areas[from]).min(mobile);
        let share = given / self.thickness[from];
        self.thickness[from] -= given;
        (share, given * bed.areas[from])
    }

    /// Flow out of a donor through a face over the potential difference that drives it [m·s].
    #[inline]
    fn looseness(&self, manner: &Manner, donor: usize, drop: f64, face: f64, length: f64) -> f64 {
        let mobile = self.thickness[donor] - manner.clinging;
        if mobile <= 0.0 || drop < LEAST_DROP {
            return 0.0;
        }
        let depth = self.thickness[donor].max(manner.puddle);
        let viscous = depth * depth * self.fluidity[donor];
        // u = u_v u_f / (u_v + u_f) with the film's own speed u_v = viscous · drop / (3 length) and that of a fall.
        let falling = 3.0 * length * libm::sqrt(2.0 * drop);
        mobile * face * viscous * falling / (3.0 * length * (viscous * drop + falling))
    }

    /// Moves a quantity along with its liquid as in the last sweep. What runs over the rim is returned.
    pub fn carry(&self, bed: &Bed, sweep: Sweep, field: &mut [f64]) -> f64 {
        for e in sweep.order(bed.edges.len()) {
            let (a, b) = (bed.edges[e].a as usize, bed.edges[e].b as usize);
            // Without a branch: which way a face passes cannot be foreseen.
            let amount = self.passed[e].max(0.0) * field[a] + self.passed[e].min(0.0) * field[b];
            field[a] -= amount;
            field[b] += amount;
        }
        let mut spilled = 0.0;
        for (share, rim) in self.spilled.iter().zip(&bed.rim) {
            let amount = share * field[rim.node as usize];
            field[rim.node as usize] -= amount;
            spilled += amount;
        }
        spilled
    }

    /// Mixes temperatures [K] as the liquid of these heat capacities [J/K] runs over metal as in the last sweep; moves the
    /// capacities along. Returns the heat above `zero` [K] that ran over the rim [J].
    pub fn mix(
        &self,
        bed: &Bed,
        sweep: Sweep,
        capacity: &mut [f64],
        metal: &[f64],
        temperature: &mut [f64],
        zero: f64,
    ) -> f64 {
        for e in sweep.order(bed.edges.len()) {
            let (a, b) = (bed.edges[e].a as usize, bed.edges[e].b as usize);
            let share = self.passed[e];
            let (from, to) = if share > 0.0 { (a, b) } else { (b, a) };
            let moved = libm::fabs(share) * capacity[from];
            capacity[from] -= moved;
            capacity[to] += moved;
            temperature[to] += moved * (temperature[from] - temperature[to]) / (metal[to] + capacity[to]);
        }
        let mut spilled = 0.0;
        for (share, rim) in self.spilled.iter().zip(&bed.rim) {
            let i = rim.node as usize;
            let moved = share * capacity[i];
            capacity[i] -= moved;
            spilled += moved * (temperature[i] - zero);
        }
        spilled
    }
}
