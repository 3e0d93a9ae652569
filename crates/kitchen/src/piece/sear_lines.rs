//! Sear lines from ridges: their place in the frame of the food, and the browning on them.
//!
//! The mesh of a piece is as coarse as the ridges, so a node browns as the mean of ridge and groove: the part of it on
//! tops browns, and the rest is kept off the metal ([`FoodState::open`](saute_food::FoodState)). Lines across earlier ones
//! open as much of what is left. Between the lines flesh tans as its surface dries, which opens it too. The browning that
//! a face gains on ridges is attributed to the lines, up to complete browning there. Its distribution along the lines
//! follows the strips on the ridges; the surface temperature of a strip is the balance between the ridge and the water
//! that boils below the crust: T_s = (h_top T_pan + g T_boil) / (h_top + g).

use glam::DVec3;
use saute_food::advance::REFRESH_TICKS;
use saute_food::{Face, FoodModel, Rules};
use serde::{Deserialize, Serialize};

use crate::TICK_S;
use crate::data::room::Room;
use crate::dynamics::Pose;
use crate::pan::near_pan::NearPatch;
use crate::pan::pan_model::{PanModel, PanState};
use crate::pan::ridges::Ridges;
use crate::piece::contact::{FaceContact, PatchGap};
use crate::piece::piece_state::Piece;

/// Largest number of sets of lines on a face [-] (chosen: crossed lines and one more; later browning counts as uniform).
const MOST_SETS: usize = 3;
/// Sine of the angle up to which two sets count as parallel [-] (chosen: 8°).
const ALIKE: f64 = 0.14;
/// Cosine of the tilt above which a piece does not lie on its lower or upper face [-] (chosen: 45°).
const FLAT: f64 = 0.7;
/// Browning below which a place counts as raw [-] (chosen: not seen).
const UNBROWNED: f64 = 0.02;
/// Temperature of boiling water below a strip's crust [K] (100 °C).
const BOILING: f64 = 373.15;
/// Thickness of a strip's crust [m] (chosen: a line that has just browned).
const STRIP: f64 = 0.3e-3;
/// Water activity of a strip's crust [-] (chosen: at the fastest browning).
const DRY: f64 = 0.65;

/// Parallel lines on a face, in the rest frame of the body as seen from +z.
///
/// A point (x, y) is on a line if x·d_y − y·d_x − phase is within half a width of a multiple of the pitch.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct SearLines {
    /// Unit vector along the lines, its x not negative [-].
    pub direction: [f64; 2],
    /// Offset of a line's centre from the origin, measured along (d_y, −d_x), 0 to pitch [m].
    pub phase: f64,
    /// Distance between the centres of neighbouring lines [m].
    pub pitch: f64,
    /// Width of a line [m].
    pub width: f64,
    /// Share of the face's mean browning gained on these ridges [-].
    pub share: f64,
    /// Browning gained on these ridges, on the lines and between them [-]. Their area mean is the gain of the face's
    /// mean.
    pub browning: [f64; 2],
    /// Charring, in the same way [-].
    pub charring: [f64; 2],
}

impl SearLines {
    const NONE: Self = Self {
        direction: [1.0, 0.0],
        phase: 0.0,
        pitch: 1.0,
        width: 0.0,
        share: 0.0,
        browning: [0.0; 2],
        charring: [0.0; 2],
    };

    /// Divides a face's mean between the lines and the rest [-]; the lines saturate at 1.
    fn divided(&self, mean: f64) -> [f64; 2] {
        let duty = self.width / self.pitch;
        let on = (mean / duty).min(1.0);
        [on, (mean - duty * on) / (1.0 - duty)]
    }

    /// Lines of ridges on a body at pose `seen` in the pan's frame; `lateral` is the lateral stretch of its rest shape [-].
    fn at(ridges: &Ridges, seen: &Pose, lateral: f64) -> Self {
        let back = seen.rotation.conjugate();
        let (along, across) = (back * DVec3::Y, back * DVec3::X);
        let length = libm::hypot(along.x, along.y);
        let turn = if along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) { -1.0 / length } else { 1.0 / length };
        let direction = [along.x * turn, along.y * turn];
        let sign = if across.x * direction[1] - across.y * direction[0] < 0.0 { -1.0 } else { 1.0 };
        let pitch = ridges.pitch / lateral;
        let phase = (-sign * seen.position.x / lateral).rem_euclid(pitch);
        Self { direction, phase, pitch, width: ridges.width / lateral, ..Self::NONE }
    }

    /// Returns true if other lines coincide with these.
    fn is_over(&self, other: &Self) -> bool {
        let sine = self.direction[0] * other.direction[1] - self.direction[1] * other.direction[0];
        let cosine = self.direction[0] * other.direction[0] + self.direction[1] * other.direction[1];
        // Lines along y have either direction.
        let phase = if cosine < 0.0 { -other.phase } else { other.phase };
        let off = (self.phase - phase).rem_euclid(self.pitch);
        sine.abs() < ALIKE && off.min(self.pitch - off) < 0.5 * self.width
    }
}

/// History of a piece on ridges.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct SearRecord {
    /// Lines of the lower and upper face of the rest shape; `share` contains the mean browning gained so far.
    faces: [Vec<SearLines>; 2],
    /// Lower face at the last update, and its mean browning.
    seen: Option<(usize, f64)>,
    /// Browning of the strip of each patch on a ridge, computed in isolation and dry [-].
    strips: Vec<f64>,
}

impl SearRecord {
    /// Returns true if it has no strips, or one for each of so many patches, and names a face that it has.
    pub(crate) fn fits(&self, patches: usize) -> bool {
        [0, patches].contains(&self.strips.len()) && self.seen.is_none_or(|(face, _)| face < self.faces.len())
    }

    /// Returns the face that is below, given the upward direction in the body's frame.
    fn face_below(up: [f64; 3]) -> Option<Face> {
        if up[2] > FLAT {
            Some(Face::Bottom)
        } else if up[2] < -FLAT {
            Some(Face::Top)
        } else {
            None
        }
    }

    /// Attributes the browning gained since the last update to the lines; `seen` is the piece's pose in the pan's frame.
    fn look(&mut self, ridges: &Ridges, (face, browning): (Face, f64), seen: &Pose, lateral: f64) {
        let index = index(face);
        let gained = match self.seen {
            Some((before, browned)) if before == index => (browning - browned).max(0.0),
            _ => 0.0,
        };
        self.seen = Some((index, browning));
        if gained <= 0.0 {
            return;
        }
        let lines = SearLines { share: gained, ..SearLines::at(ridges, seen, lateral) };
        let sets = &mut self.faces[index];
        match sets.iter().position(|set| set.is_over(&lines)) {
            Some(at) => sets[at].share += gained,
            None if sets.len() < MOST_SETS => sets.push(lines),
            None => {}
        }
    }

    /// Number of sets of lines of a face, with those at pose `seen` where it lies now [-].
    fn sets_with(&self, ridges: &Ridges, face: Face, seen: &Pose, lateral: f64) -> usize {
        let (sets, here) = (&self.faces[index(face)], SearLines::at(ridges, seen, lateral));
        sets.len() + usize::from(!sets.iter().any(|set| set.is_over(&here)))
    }

    /// Ends the contact with ridges.
    pub(crate) fn leave(&mut self) {
        self.seen = None;
    }

    /// Adds browning to the strip of a patch [-].
    pub(crate) fn brown_strip(&mut self, patch: usize, gained: f64) {
        if self.strips.len() <= patch {
            self.strips.resize(patch + 1, 0.0);
        }
        self.strips[patch] += gained;
    }

    /// All sets of lines of a face, the strongest first, given the face's present mean browning and charring [-].
    fn lines(&self, face: Face, browning: f64, charring: f64) -> Vec<SearLines> {
        let of = |set: &SearLines| {
            let share = (set.share / browning).min(1.0);
            let [browning, charring] = [browning, charring].map(|mean| set.divided(share * mean));
            SearLines { share, browning, charring, ..*set }
        };
        let mut lines: Vec<SearLines> = self.faces[index(face)].iter().map(of).collect();
        lines.sort_by(|a, b| b.share.total_cmp(&a.share));
        lines
    }
}

impl Piece {
    /// Updates the record of sear lines while the piece lies on ridges.
    pub(crate) fn note_ridges(&mut self, ridges: &Ridges, seen: &Pose) {
        match SearRecord::face_below(seen.up()) {
            Some(face) if !self.near_patches().is_empty() => {
                if self.state.ticks.is_multiple_of(REFRESH_TICKS) {
                    self.open_on_tops(ridges, face, seen);
                    let browning = self.face_mean(face, &self.state.browning);
                    self.sear.look(ridges, (face, browning), seen, self.state.stretch.lateral);
                }
            }
            _ => self.sear.leave(),
        }
    }

    /// Opens the share of a face that tops reach: s by the first lines, and the same share of the rest by each further set.
    /// What browned before, elsewhere, stays open.
    fn open_on_tops(&mut self, ridges: &Ridges, face: Face, seen: &Pose) {
        if !self.state.healthy || self.model.rules() != Rules::Full {
            return;
        }
        let sets = self.sear.sets_with(ridges, face, seen, self.state.stretch.lateral);
        let reached = 1.0 - libm::pow(1.0 - ridges.share(), sets as f64);
        for patch in on_face(&self.model, face) {
            let node = self.model.patches()[patch].node as usize;
            let (open, browning) = (self.state.open[node], self.state.browning[node]);
            if open < 1.0 {
                self.state.open[node] = open.max(reached);
            } else if browning < UNBROWNED {
                self.state.open[node] = reached;
            }
        }
    }

    /// Tans the part of a patch over a groove for the time between two updates: like a strip, by the groove's conductance.
    pub(crate) fn tan_between(
        &mut self,
        near: &NearPatch,
        face: &FaceContact,
        mean: f64,
        (pan, ridges, state): (&PanModel, &Ridges, &PanState),
        room: &Room,
    ) {
        let (node, metal) = (self.node_of(near.patch), state.metal_at(&near.located));
        if !self.state.healthy || self.state.open[node] >= 1.0 {
            return;
        }
        let gap = PatchGap { thickness: self.gap_below(near, mean), pan: metal, wetness: 0.0 };
        let groove = ridges.over_groove(&room.contact, face, &gap, &self.across_groove(pan, metal, node));
        let tanned = (1.0 - self.wetness(node)) * self.browned_dry(groove, metal);
        self.state.open[node] += (1.0 - self.state.open[node]) * tanned;
    }

    /// Temperature of a crust that boils below, given the conductance from the metal [K].
    fn crust_between(&self, conductance: f64, metal: f64) -> f64 {
        let below = self.model.description().crust.conductivity_w_mk / STRIP;
        (conductance * metal + below * BOILING) / (conductance + below)
    }

    /// Browning between two updates of a dry crust that boils below, given the conductance from the metal [-].
    fn browned_dry(&self, conductance: f64, metal: f64) -> f64 {
        let surface = self.crust_between(conductance, metal);
        if surface > BOILING { self.browned_at((0.0, 0.0), surface).0 } else { 0.0 }
    }

    /// Browning and charring of a dry crust at a temperature [K] after the time between two updates [-].
    fn browned_at(&self, before: (f64, f64), surface: f64) -> (f64, f64) {
        let look = REFRESH_TICKS as f64 * TICK_S;
        self.model.browning().advance(before, surface, DRY, 1.0, look)
    }

    /// Browns a bar by as much as its ridge makes it hotter than the mean of ridge and groove, by which the node browns.
    fn brown_bar(&mut self, node: usize, top: f64, metal: f64) {
        let (open, bar) = (self.state.open[node], self.crust_between(top, metal));
        let mean = self.state.temperature[node];
        if !self.state.healthy || open >= 1.0 || bar <= mean || mean <= BOILING {
            return;
        }
        let before = self.state.crust(node);
        let (on_bar, on_mean) = (self.browned_at(before, bar), self.browned_at(before, mean));
        let dry = open * (1.0 - self.wetness(node));
        self.state.browning[node] += dry * (on_bar.0 - on_mean.0).max(0.0);
        self.state.charring[node] += dry * (on_bar.1 - on_mean.1).max(0.0);
    }

    /// Area mean of a field of the nodes over the lower or the upper face of the rest shape.
    fn face_mean(&self, face: Face, field: &[f64]) -> f64 {
        let (mut sum, mut area) = (0.0, 0.0);
        for patch in on_face(&self.model, face).map(|i| &self.model.patches()[i]) {
            sum += patch.area * field[patch.node as usize];
            area += patch.area;
        }
        sum / area
    }

    /// Browns the strip of a patch on a ridge for the time between two updates.
    ///
    /// Ridges press into the flesh, which reduces the gap beyond the face's mean.
    pub(crate) fn sear_strip(
        &mut self,
        near: &NearPatch,
        face: &FaceContact,
        mean: f64,
        (ridges, pan): (&Ridges, &PanState),
        room: &Room,
    ) {
        let (patch, located) = (near.patch as usize, &near.located);
        let off = self.uneven[patch] + near.gap + self.dome_gap(patch);
        let given = ridges.pressed_in(face.pressure, 1e3 * self.model.kinetics().texture.raw_kpa);
        let film = FaceContact { film: pan.oil_film(located), ..*face };
        let share = self.model.description().surface.contact_share;
        let metal = pan.metal_at(located);
        let gap = PatchGap { thickness: mean + (off - given).max(0.0), pan: metal, wetness: 0.0 };
        let top = film.conductance(&room.contact, &gap) * share;
        self.sear.brown_strip(patch, self.browned_dry(top, metal));
        // Bars are on faces that lie.
        if SearRecord::face_below(self.up()).is_some() {
            self.brown_bar(self.node_of(near.patch), top, metal);
        }
    }

    /// Darkness of the lines at each node relative to their mean on its face [-]; empty without sear lines.
    pub fn sear_strength(&self) -> Vec<f64> {
        let strips = &self.sear.strips;
        if strips.is_empty() {
            return Vec::new();
        }
        let mut strength = vec![0.0; self.model.mesh().node_count()];
        for face in [Face::Bottom, Face::Top] {
            let strip = |patch: usize| strips.get(patch).copied().unwrap_or(0.0);
            let area = |patch: usize| self.model.patches()[patch].area;
            let (sum, whole) = on_face(&self.model, face)
                .fold((0.0, 0.0), |(sum, whole), i| (sum + strip(i) * area(i), whole + area(i)));
            for patch in on_face(&self.model, face).filter(|_| sum > 0.0) {
                strength[self.node_of(patch as u32)] = strip(patch) * whole / sum;
            }
        }
        strength
    }

    /// Strongest set of sear lines on the lower ([`Face::Bottom`]) or upper face of the rest shape.
    pub fn sear_lines(&self, face: Face) -> Option<SearLines> {
        self.all_sear_lines(face).into_iter().next()
    }

    /// All sets of sear lines of a face, the strongest first; empty for [`Face::Side`].
    pub fn all_sear_lines(&self, face: Face) -> Vec<SearLines> {
        if face == Face::Side {
            return Vec::new();
        }
        let [browning, charring] = [&self.state.browning, &self.state.charring].map(|f| self.face_mean(face, f));
        self.sear.lines(face, browning, charring)
    }
}

/// Patches of the lower or the upper face of the rest shape.
fn on_face(model: &FoodModel, face: Face) -> impl Iterator<Item = usize> {
    model.patches_below([0.0, 0.0, if face == Face::Top { -1.0 } else { 1.0 }])
}

/// Index of a face in [`SearRecord`]; a side has no separate lines and shares the index of the lower face.
fn index(face: Face) -> usize {
    usize::from(face == Face::Top)
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;

    const RIDGES: Ridges = Ridges { pitch: 0.012, width: 0.005, height: 0.005 };

    fn seen(x: f64, turned_deg: f64, upside_down: bool) -> Pose {
        let mut pose = Pose::at(x, 0.0, 0.0);
        pose.rotation = DQuat::from_rotation_z(turned_deg.to_radians());
        if upside_down {
            pose.rotation *= DQuat::from_rotation_x(core::f64::consts::PI);
        }
        pose
    }

    /// Returns true if a point of the rest shape is on a line, by the rule of [`SearLines`].
    fn on_line(lines: &SearLines, [x, y]: [f64; 2]) -> bool {
        let [dx, dy] = lines.direction;
        let off = (x * dy - y * dx - lines.phase).rem_euclid(lines.pitch);
        off.min(lines.pitch - off) < 0.5 * lines.width
    }

    /// A point is on a line exactly where a ridge is under it, however the piece lies.
    #[test]
    fn lines_are_where_the_ridges_were() {
        for (x, turned, upside_down) in
            [(0.0, 0.0, false), (0.004, 90.0, false), (-0.007, 33.0, true), (0.02, 200.0, true)]
        {
            let (pose, lateral) = (seen(x, turned, upside_down), 0.9);
            let lines = SearLines::at(&RIDGES, &pose, lateral);
            for i in 0..400 {
                let p = [0.0013 * f64::from(i % 20) - 0.0127, 0.0017 * f64::from(i / 20) - 0.0163];
                let over = pose.to_world(DVec3::new(lateral * p[0], lateral * p[1], 0.0)).x.rem_euclid(RIDGES.pitch);
                let off = over.min(RIDGES.pitch - over) - 0.5 * RIDGES.width;
                assert!(off.abs() < 1e-9 || on_line(&lines, p) == (off < 0.0), "{x} {turned} {p:?} {lines:?}");
            }
        }
    }

    /// Turned by 90° between, a face has two sets of lines across each other, each with what it gained.
    #[test]
    fn lines_turn_with_the_piece() {
        let mut record = SearRecord::default();
        for (turned, from, to) in [(0.0, 0.0, 0.3), (90.0, 0.3, 0.4)] {
            record.look(&RIDGES, (Face::Bottom, from), &seen(0.001, turned, false), 1.0);
            record.look(&RIDGES, (Face::Bottom, to), &seen(0.001, turned, false), 1.0);
            record.leave();
        }
        let lines = record.lines(Face::Bottom, 0.5, 0.0);
        assert_eq!(lines.len(), 2);
        let cosine = lines[0].direction[0] * lines[1].direction[0] + lines[0].direction[1] * lines[1].direction[1];
        assert!(cosine.abs() < 1e-12 && (lines[0].share - 0.6).abs() < 1e-12 && (lines[1].share - 0.2).abs() < 1e-12);
        assert!(record.lines(Face::Top, 0.5, 0.0).is_empty());
    }

    #[test]
    fn what_browned_elsewhere_belongs_to_no_line() {
        let mut record = SearRecord::default();
        record.look(&RIDGES, (Face::Top, 0.0), &seen(0.0, 0.0, true), 1.0);
        record.leave();
        record.look(&RIDGES, (Face::Top, 0.6), &seen(0.0, 0.0, true), 1.0);
        assert!(record.lines(Face::Top, 0.6, 0.0).is_empty());
    }

    /// Dividing the browning between lines and rest keeps the face's mean.
    #[test]
    fn lines_and_what_lies_between_them_hold_the_face_s_mean_browning() {
        let mut record = SearRecord::default();
        for browned in [0.0, 0.2, 0.8] {
            record.look(&RIDGES, (Face::Bottom, browned), &seen(0.001, 0.0, false), 1.0);
            if browned > 0.0 {
                let line = record.lines(Face::Bottom, browned, 0.1 * browned)[0];
                let duty = line.width / line.pitch;
                for ([on, between], mean) in [(line.browning, browned), (line.charring, 0.1 * browned)] {
                    assert!((duty * on + (1.0 - duty) * between - mean).abs() < 1e-12, "{line:?}");
                    assert!(on > between && on <= 1.0, "{line:?}");
                }
            }
        }
    }
}
