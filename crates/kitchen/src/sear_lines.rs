//! Lines that ridges sear into food: where they touched it, in its own frame, and how much of its browning came there.

use glam::DVec3;
use saute_food::Face;
use saute_food::advance::REFRESH_TICKS;

use crate::dynamics::Pose;
use crate::piece::Piece;
use crate::ridges::Ridges;

/// Sets of lines that a face keeps (chosen: crossed lines and one more; what is browned beyond counts as even).
const MOST_SETS: usize = 3;
/// Sine of the angle up to which lines run alike [-] (chosen: 8°).
const ALIKE: f64 = 0.14;
/// Cosine of the lean from which on a piece does not lie on a big face [-] (chosen: 45°).
const FLAT: f64 = 0.7;

/// Parallel lines on a face, in the rest frame of the body as seen from +z.
///
/// A point (x, y) lies on a line where x·d_y − y·d_x − phase is within half a width of a multiple of the pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearLines {
    /// Unit vector along the lines, its x not negative [-].
    pub direction: [f64; 2],
    /// Distance across the lines, towards (d_y, −d_x), of the middle of one of them from the origin, 0 to pitch [m].
    pub phase: f64,
    /// From the middle of one line to that of the next [m].
    pub pitch: f64,
    /// Width of a line [m].
    pub width: f64,
    /// Share of the face's mean browning that came while it lay on these ridges [-].
    pub share: f64,
}

impl SearLines {
    /// The lines that ridges leave on a body whose rest shape has shrunk to `lateral`, seen at a pose in the pan's frame.
    fn at(ridges: &Ridges, seen: &Pose, lateral: f64) -> Self {
        let back = seen.rotation.conjugate();
        let (along, across) = (back * DVec3::Y, back * DVec3::X);
        let length = libm::hypot(along.x, along.y);
        let turn = if along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) { -1.0 / length } else { 1.0 / length };
        let direction = [along.x * turn, along.y * turn];
        let sign = if across.x * direction[1] - across.y * direction[0] < 0.0 { -1.0 } else { 1.0 };
        let pitch = ridges.pitch / lateral;
        let phase = (-sign * seen.position.x / lateral).rem_euclid(pitch);
        Self { direction, phase, pitch, width: ridges.width / lateral, share: 0.0 }
    }

    /// Whether other lines lie over these.
    fn is_over(&self, other: &Self) -> bool {
        let sine = self.direction[0] * other.direction[1] - self.direction[1] * other.direction[0];
        let cosine = self.direction[0] * other.direction[0] + self.direction[1] * other.direction[1];
        // Upright lines may look either way.
        let phase = if cosine < 0.0 { -other.phase } else { other.phase };
        let off = (self.phase - phase).rem_euclid(self.pitch);
        sine.abs() < ALIKE && off.min(self.pitch - off) < 0.5 * self.width
    }
}

/// What a piece remembers of the ridges on which it lay.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SearRecord {
    /// Lines of the lower and the upper face of the rest shape; their share is mean browning gained so far.
    faces: [Vec<SearLines>; 2],
    /// The face that lay below at the last look, and its mean browning.
    seen: Option<(usize, f64)>,
}

impl SearRecord {
    /// Which big face lies below where `up` points up, a direction of the body frame.
    fn face_below(up: [f64; 3]) -> Option<Face> {
        if up[2] > FLAT {
            Some(Face::Bottom)
        } else if up[2] < -FLAT {
            Some(Face::Top)
        } else {
            None
        }
    }

    /// Looks at a face with a mean browning that lies on ridges; the piece is seen at a pose in the pan's frame.
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

    /// The piece no longer lies on ridges.
    pub(crate) fn leave(&mut self) {
        self.seen = None;
    }

    /// All sets of lines of a face whose mean browning is now so much, the strongest first.
    fn lines(&self, face: Face, browning: f64) -> Vec<SearLines> {
        let of = |set: &SearLines| SearLines { share: (set.share / browning).min(1.0), ..*set };
        let mut lines: Vec<SearLines> = self.faces[index(face)].iter().map(of).collect();
        lines.sort_by(|a, b| b.share.total_cmp(&a.share));
        lines
    }
}

impl Piece {
    /// Remembers where ridges touch it.
    pub(crate) fn note_ridges(&mut self, ridges: &Ridges, seen: &Pose) {
        match SearRecord::face_below(seen.up()) {
            Some(face) if !self.near.patches.is_empty() => {
                if self.state.ticks.is_multiple_of(REFRESH_TICKS) {
                    let browning = self.face_browning(face);
                    self.sear.look(ridges, (face, browning), seen, self.state.stretch.lateral);
                }
            }
            _ => self.sear.leave(),
        }
    }

    /// Mean browning of the lower or the upper face of the rest shape [-].
    fn face_browning(&self, face: Face) -> f64 {
        let up = [0.0, 0.0, if face == Face::Top { -1.0 } else { 1.0 }];
        let (mut sum, mut area) = (0.0, 0.0);
        for patch in self.model.patches_below(up).map(|i| &self.model.patches[i]) {
            sum += patch.area * self.state.browning[patch.node as usize];
            area += patch.area;
        }
        sum / area
    }

    /// The strongest lines that ridges seared into the lower ([`Face::Bottom`]) or the upper face of the rest shape.
    pub fn sear_lines(&self, face: Face) -> Option<SearLines> {
        self.all_sear_lines(face).into_iter().next()
    }

    /// All sets of such lines, crossed ones too, the strongest first; none on a side.
    pub fn all_sear_lines(&self, face: Face) -> Vec<SearLines> {
        if face == Face::Side { Vec::new() } else { self.sear.lines(face, self.face_browning(face)) }
    }
}

/// The upper face of the rest shape comes second; a side has no lines of its own and counts to the lower face.
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

    /// Whether a point of the rest shape lies on a line, by the rule that the type documents.
    fn on_line(lines: &SearLines, [x, y]: [f64; 2]) -> bool {
        let [dx, dy] = lines.direction;
        let off = (x * dy - y * dx - lines.phase).rem_euclid(lines.pitch);
        off.min(lines.pitch - off) < 0.5 * lines.width
    }

    /// A point is on a line exactly where a ridge lies under it, however the piece lies.
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
        let lines = record.lines(Face::Bottom, 0.5);
        assert_eq!(lines.len(), 2);
        let cosine = lines[0].direction[0] * lines[1].direction[0] + lines[0].direction[1] * lines[1].direction[1];
        assert!(cosine.abs() < 1e-12 && (lines[0].share - 0.6).abs() < 1e-12 && (lines[1].share - 0.2).abs() < 1e-12);
        assert!(record.lines(Face::Top, 0.5).is_empty());
    }

    #[test]
    fn what_browned_elsewhere_belongs_to_no_line() {
        let mut record = SearRecord::default();
        record.look(&RIDGES, (Face::Top, 0.0), &seen(0.0, 0.0, true), 1.0);
        record.leave();
        record.look(&RIDGES, (Face::Top, 0.6), &seen(0.0, 0.0, true), 1.0);
        assert!(record.lines(Face::Top, 0.6).is_empty());
    }
}
