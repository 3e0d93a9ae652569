//! Flow of a thin liquid film over the pan under gravity and acceleration.
//!
//! Lubrication theory: a film of thickness h flows with the mean speed u = h²/(3ν) · |∇Π|, where Π = −g·x + g_n h is
//! the potential of its surface; no film outruns a body that falls through the same potential, u < √(2 ΔΠ).

use crate::bed::Bed;

/// Gravity that presses a film onto the pan is reckoned with at least this [m/s²] (chosen: keeps levelling defined on a
/// pan that is tossed or stands on edge).
const LEAST_PRESSING: f64 = 0.5;
/// Most sweeps in one tick (chosen: a sweep carries liquid to the next node, some 9 mm; four make 0.35 m/s).
const MOST_SWEEPS: f64 = 4.0;

/// How far a sweep may level a node towards its neighbours [-] (chosen: 1 would let them swap heights).
const MEETING: f64 = 0.75;

/// A liquid as it lies now.
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a> {
    /// Volume over area at each node [m].
    pub thickness: &'a [f64],
    /// One over the kinematic viscosity at each node [s/m²].
    pub fluidity: &'a [f64],
    /// Thickness to which a puddle spreads; 0 for a liquid that wets [m].
    pub puddle: f64,
    /// What stays behind, above 0: so no node runs dry by rounding [m].
    pub clinging: f64,
}

/// Flow of one liquid: what each face passes in one sweep.
#[derive(Clone, Debug, Default)]
pub struct FilmFlow {
    /// Share of its donor's liquid that each edge passes; positive from `a` to `b`.
    pub passed: Vec<f64>,
    /// Share of its node's liquid that each rim face passes.
    pub spilled: Vec<f64>,
    potential: Vec<f64>,
    pressing: Vec<f64>,
    /// Flow over potential difference summed at each node [m·s].
    loosening: Vec<f64>,
    outflow: Vec<f64>,
}

impl FilmFlow {
    /// Brings the potentials of the pan's places up to date with a gravity in the pan's frame [m/s²].
    pub fn lean(&mut self, bed: &Bed, gravity: [f64; 3]) {
        let along = |p: &[f64; 3]| p[0] * gravity[0] + p[1] * gravity[1] + p[2] * gravity[2];
        self.potential.clear();
        self.potential.extend(bed.places.iter().map(|p| -along(p)));
        self.pressing.clear();
        self.pressing.extend(bed.normals.iter().map(|n| (-along(n)).max(LEAST_PRESSING)));
    }

    /// Sweeps into which a tick of `dt` [s] should be divided: one where little moves.
    pub fn sweeps(&mut self, bed: &Bed, layer: &Layer, gravity: [f64; 3], dt: f64) -> u32 {
        self.loosen(bed, layer, gravity);
        let hastiest = (0..bed.areas.len())
            .map(|i| dt * self.loosening[i] * self.pressing[i] / bed.areas[i])
            .fold(0.0, f64::max);
        libm::ceil(hastiest).clamp(1.0, MOST_SWEEPS) as u32
    }

    /// Fills in `passed` and `spilled` for a sweep of `dt` [s]; returns the largest change of thickness [m].
    ///
    /// A face passes Q Δt, but where that would swing no more than lets its ends meet: with S the sum of Q/ΔΠ at a node,
    /// s = Δt S g/A, it passes Q Δt · min(1, ¾ / max(s_a, s_b)). So no surface rises above its highest neighbour or falls
    /// below its lowest by levelling, however long the sweep, and what one node loses another gains.
    pub fn sweep(&mut self, bed: &Bed, layer: &Layer, gravity: [f64; 3], dt: f64) -> f64 {
        self.loosen(bed, layer, gravity);
        self.outflow.clear();
        self.outflow.resize(bed.areas.len(), 0.0);
        self.damp(bed, dt);
        for (passed, edge) in self.passed.iter_mut().zip(&bed.edges) {
            if *passed != 0.0 {
                let (a, b) = (edge.a as usize, edge.b as usize);
                *passed *= dt * self.loosening[a].min(self.loosening[b]);
                self.outflow[if *passed > 0.0 { a } else { b }] += libm::fabs(*passed);
            }
        }
        for (spilled, rim) in self.spilled.iter_mut().zip(&bed.rim) {
            let i = rim.node as usize;
            *spilled *= dt * self.loosening[i];
            self.outflow[i] += *spilled;
        }
        self.share_out(bed, layer)
    }

    /// Turns Q/ΔΠ summed at each node into the share of its flow that a sweep of `dt` [s] may pass.
    fn damp(&mut self, bed: &Bed, dt: f64) {
        for (i, loose) in self.loosening.iter_mut().enumerate().filter(|(_, loose)| **loose > 0.0) {
            *loose = (MEETING * bed.areas[i] / (dt * *loose * self.pressing[i])).min(1.0);
        }
        self.loosening.iter_mut().filter(|loose| **loose == 0.0).for_each(|loose| *loose = 1.0);
    }

    /// Turns volumes into shares of what their donors have above what clings; returns the largest change of thickness [m].
    fn share_out(&mut self, bed: &Bed, layer: &Layer) -> f64 {
        let mut largest = 0.0_f64;
        for (i, out) in self.outflow.iter_mut().enumerate().filter(|(_, out)| **out > 0.0) {
            let volume = layer.thickness[i] * bed.areas[i];
            let mobile = (layer.thickness[i] - layer.clinging).max(0.0) * bed.areas[i];
            let limited = (mobile / *out).min(1.0);
            largest = largest.max(*out * limited / bed.areas[i]);
            *out = limited / volume;
        }
        for (passed, edge) in self.passed.iter_mut().zip(&bed.edges).filter(|(passed, _)| **passed != 0.0) {
            *passed *= self.outflow[if *passed > 0.0 { edge.a } else { edge.b } as usize];
        }
        for (spilled, rim) in self.spilled.iter_mut().zip(&bed.rim).filter(|(spilled, _)| **spilled > 0.0) {
            *spilled *= self.outflow[rim.node as usize];
        }
        largest
    }

    /// Flow through every face as if nothing changed by it [m³/s], and Q/ΔΠ summed at the nodes.
    fn loosen(&mut self, bed: &Bed, layer: &Layer, gravity: [f64; 3]) {
        let nodes = bed.areas.len();
        self.loosening.clear();
        self.loosening.resize(nodes, 0.0);
        self.passed.clear();
        self.passed.resize(bed.edges.len(), 0.0);
        self.spilled.clear();
        self.spilled.resize(bed.rim.len(), 0.0);
        let surface = |i: usize| self.potential[i] + self.pressing[i] * layer.thickness[i].max(layer.puddle);
        for (passed, edge) in self.passed.iter_mut().zip(&bed.edges) {
            let (a, b) = (edge.a as usize, edge.b as usize);
            if layer.thickness[a] <= layer.clinging && layer.thickness[b] <= layer.clinging {
                continue;
            }
            let drop = surface(a) - surface(b);
            let donor = if drop > 0.0 { a } else { b };
            let loose = looseness(layer, donor, libm::fabs(drop), edge.face, edge.length);
            self.loosening[a] += loose;
            self.loosening[b] += loose;
            *passed = loose * drop;
        }
        for (spilled, rim) in self.spilled.iter_mut().zip(&bed.rim) {
            let lip = -(rim.lip[0] * gravity[0] + rim.lip[1] * gravity[1] + rim.lip[2] * gravity[2]);
            let drop = surface(rim.node as usize) - lip - self.pressing[rim.node as usize] * layer.puddle;
            if drop > 0.0 {
                let loose = looseness(layer, rim.node as usize, drop, rim.face, rim.length);
                self.loosening[rim.node as usize] += loose;
                *spilled = loose * drop;
            }
        }
    }
}

/// Flow out of a donor through a face over the potential difference that drives it [m·s].
#[inline]
fn looseness(layer: &Layer, donor: usize, drop: f64, face: f64, length: f64) -> f64 {
    let mobile = layer.thickness[donor] - layer.clinging;
    if mobile <= 0.0 || drop <= 0.0 {
        return 0.0;
    }
    let depth = layer.thickness[donor].max(layer.puddle);
    let viscous = depth * depth * layer.fluidity[donor] * drop / (3.0 * length);
    let falling = libm::sqrt(2.0 * drop);
    mobile * face * (viscous / drop) * falling / (viscous + falling)
}

/// Moves a quantity along with its liquid; `before` is scratch. What runs over the rim is returned.
pub fn carry(bed: &Bed, flow: &FilmFlow, field: &mut [f64], before: &mut Vec<f64>) -> f64 {
    before.clear();
    before.extend_from_slice(field);
    for (&passed, edge) in flow.passed.iter().zip(&bed.edges).filter(|(passed, _)| **passed != 0.0) {
        let (from, to) = if passed > 0.0 { (edge.a, edge.b) } else { (edge.b, edge.a) };
        let amount = libm::fabs(passed) * before[from as usize];
        field[from as usize] -= amount;
        field[to as usize] += amount;
    }
    let mut spilled = 0.0;
    for (&share, rim) in flow.spilled.iter().zip(&bed.rim).filter(|(share, _)| **share > 0.0) {
        let amount = share * before[rim.node as usize];
        field[rim.node as usize] -= amount;
        spilled += amount;
    }
    spilled
}
