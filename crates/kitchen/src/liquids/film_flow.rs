//! Flow of a thin liquid film over the pan under gravity and acceleration.
//!
//! Lubrication theory: a film of thickness h flows with the mean speed u = h²/(3ν) · |∇Π|, where Π = −g·x + g_n h is
//! the potential of its surface. The speed is limited to that of free fall through the same potential, u < √(2 ΔΠ).
//!
//! Each tick makes one forward and one backward Gauss–Seidel sweep over the faces; each face is solved implicitly for its
//! two nodes. A face never passes more than equalises the two surfaces or more than the donor contains. For any step mass is
//! conserved to rounding, no thickness becomes negative, and levelling creates no new extremum of the surface.

use crate::pan::bed::{Bed, BedEdge, Mouth};

/// Lower bound of the gravity normal to the pan [m/s²] (chosen: keeps levelling defined on a tossed or upright pan).
const LEAST_PRESSING: f64 = 0.5;
/// Potential difference below which nothing flows [m²/s²] (chosen: a tenth of a nanometre of height).
const LEAST_DROP: f64 = 1e-9;

/// Properties of a flowing liquid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// Density [kg/m³].
    pub density: f64,
    /// Equilibrium thickness of a puddle; 0 for a wetting liquid [m].
    pub puddle: f64,
    /// Residual film, above 0 so that no node runs dry by rounding [m].
    pub clinging: f64,
}

/// Result of a liquid's flow in one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    /// Mass spilled over the rim [kg].
    pub spilled: f64,
    /// Spilled heat above 0 °C [J].
    pub spilled_heat: f64,
    /// Largest change of thickness [m].
    pub moved: f64,
}

/// Direction of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sweep {
    /// Forward: from the centre to the rim.
    #[default]
    There,
    /// Backward: from the rim to the centre.
    Back,
}

impl Sweep {
    /// Both sweeps of a tick.
    pub const BOTH: [Self; 2] = [Self::There, Self::Back];

    /// Indices below `count` in the order of this sweep.
    fn order(self, count: usize) -> impl Iterator<Item = usize> {
        (0..count).map(move |k| if self == Self::There { k } else { count - 1 - k })
    }
}

/// Driving potential of a face.
#[derive(Clone, Copy)]
struct Driven {
    /// Difference of the potentials [m²/s²].
    drop: f64,
    /// Decrease of the difference per volume passed [1/(m·s²)].
    stiffness: f64,
    /// Time step [s].
    dt: f64,
}

/// Flow through an edge in the last sweep.
#[derive(Clone, Copy, Debug)]
struct Passed {
    a: u32,
    b: u32,
    /// Share of the donor's liquid; positive from `a` to `b` [-].
    share: f64,
}

/// Flow of one liquid.
#[derive(Clone, Debug, Default)]
pub struct FilmFlow {
    /// One over the kinematic viscosity at each node [s/m²]; set by the liquid before it runs.
    pub fluidity: Vec<f64>,
    /// Equilibrium thickness of a puddle at each node [m]; that of the liquid unless it differs from node to node.
    pub puddle: Vec<f64>,
    /// Flows in the last sweep in order; edges without flow are left out.
    passed: Vec<Passed>,
    /// Share of its node's liquid that each rim face spilled after them [-].
    spilled: Vec<f64>,
    potential: Vec<f64>,
    pressing: Vec<f64>,
    /// Increase of a node's potential per volume [1/(m·s²)].
    stiffness: Vec<f64>,
    thickness: Vec<f64>,
    lip: Vec<f64>,
}

impl FilmFlow {
    /// Updates the potentials for a gravity in the pan's frame [m/s²].
    pub fn lean(&mut self, bed: &Bed, gravity: [f64; 3]) {
        let along = |p: &[f64; 3]| p[0] * gravity[0] + p[1] * gravity[1] + p[2] * gravity[2];
        self.potential.clear();
        self.potential.extend(bed.places.iter().map(|p| -along(p)));
        self.pressing.clear();
        self.pressing.extend(bed.normals.iter().map(|n| (-along(n)).max(LEAST_PRESSING)));
        self.stiffness.clear();
        self.stiffness.extend(self.pressing.iter().zip(&bed.per_area).map(|(g, per_area)| g * per_area));
        self.lip.clear();
        self.lip.extend(bed.rim.iter().map(|rim| -along(&rim.lip)));
    }

    /// Raises the bed at a node by what stands on it [m].
    pub fn raise(&mut self, node: usize, by: f64) {
        self.potential[node] += self.pressing[node] * by;
    }

    /// Sweeps a liquid of this `mass` at each node [kg] through `dt` [s]; returns the largest change of thickness [m]. The
    /// mass itself is moved by [`Self::carry`].
    pub fn sweep(&mut self, bed: &Bed, manner: &Manner, mass: &[f64], sweep: Sweep, dt: f64) -> f64 {
        self.thickness.clear();
        self.thickness.extend(mass.iter().zip(&bed.areas).map(|(m, a)| m / (manner.density * a)));
        self.puddle.resize(mass.len(), manner.puddle);
        self.passed.clear();
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

    fn surface(&self, node: usize) -> f64 {
        self.potential[node] + self.pressing[node] * self.thickness[node].max(self.puddle[node])
    }

    /// Passes liquid through an edge.
    #[inline]
    fn pass(&mut self, bed: &Bed, manner: &Manner, e: usize, dt: f64) {
        let edge = &bed.edges[e];
        let (a, b) = (edge.a as usize, edge.b as usize);
        if self.thickness[a] <= manner.clinging && self.thickness[b] <= manner.clinging {
            return;
        }
        let drop = self.surface(a) - self.surface(b);
        let (from, to) = if drop > 0.0 { (a, b) } else { (b, a) };
        let stiffness = self.stiffness[a] + self.stiffness[b];
        let drive = Driven { drop: libm::fabs(drop), stiffness, dt };
        let (share, volume) = self.give(bed, manner, from, drive, self.mouth(bed, edge, from));
        self.thickness[to] += volume * bed.per_area[to];
        if share != 0.0 {
            self.passed.push(Passed { a: edge.a, b: edge.b, share: if drop > 0.0 { share } else { -share } });
        }
    }

    /// Cross-section between two nodes; on a ridged floor widened for flow in the grooves.
    #[inline]
    fn mouth(&self, bed: &Bed, edge: &BedEdge, from: usize) -> Mouth {
        let (Some(across), Some(ridges)) = (edge.across, &bed.ridges) else { return edge.mouth };
        let lean = libm::fabs(self.potential[edge.a as usize] - self.potential[edge.b as usize]);
        let slope = lean / (self.pressing[from] * edge.mouth.length);
        Mouth { face: edge.mouth.face * ridges.widening(across, self.thickness[from], slope), ..edge.mouth }
    }

    /// Spills liquid over the rim.
    fn spill(&mut self, bed: &Bed, manner: &Manner, r: usize, dt: f64) {
        let (rim, lip) = (&bed.rim[r], self.lip[r]);
        let i = rim.node as usize;
        let drop = self.surface(i) - lip - self.pressing[i] * self.puddle[i];
        self.spilled[r] = self.give(bed, manner, i, Driven { drop, stiffness: self.stiffness[i], dt }, rim.mouth).0;
    }

    /// Removes the flow through a cross-section from a node; returns its share of the node's liquid and the volume [m³].
    ///
    /// u = u_v u_f / (u_v + u_f) with the viscous speed u_v = h² ΔΠ/(3 ν L) and the speed of free fall u_f = √(2 ΔΠ). With
    /// Q = K ΔΠ, backward Euler between the two nodes gives V = Δt K ΔΠ / (1 + Δt K Σ g/A), limited to the mobile volume.
    #[inline]
    fn give(&mut self, bed: &Bed, manner: &Manner, from: usize, by: Driven, mouth: Mouth) -> (f64, f64) {
        let thickness = self.thickness[from];
        let mobile = thickness - manner.clinging;
        if mobile <= 0.0 || by.drop < LEAST_DROP {
            return (0.0, 0.0);
        }
        let depth = thickness.max(self.puddle[from]);
        let viscous = depth * depth * self.fluidity[from];
        let length = 3.0 * mouth.length;
        let falling = length * libm::sqrt(2.0 * by.drop);
        let loose = by.dt * mobile * mouth.face * viscous * falling;
        let volume = loose * by.drop / (length * (viscous * by.drop + falling) + loose * by.stiffness);
        let given = (volume * bed.per_area[from]).min(mobile);
        self.thickness[from] -= given;
        (given / thickness, given * bed.areas[from])
    }

    /// Advects a quantity with the flow of the last sweep; returns the amount spilled over the rim.
    pub fn carry(&self, bed: &Bed, field: &mut [f64]) -> f64 {
        for &Passed { a, b, share } in &self.passed {
            let (a, b) = (a as usize, b as usize);
            // Branch-free: the direction of flow is unpredictable.
            let amount = share.max(0.0) * field[a] + share.min(0.0) * field[b];
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

    /// Advects heat capacities [J/K] with the flow of the last sweep and mixes the temperatures [K] of liquid and metal.
    /// Returns the heat above `zero` [K] spilled over the rim [J].
    pub fn mix(&self, bed: &Bed, capacity: &mut [f64], metal: &[f64], temperature: &mut [f64], zero: f64) -> f64 {
        for &Passed { a, b, share } in &self.passed {
            let (a, b) = (a as usize, b as usize);
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
