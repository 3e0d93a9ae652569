//! A shrimp tail: a tapering body of six segments on a curved spine with a tail fan, lying on its side.

use core::f64::consts::PI;

use saute_heat::{Outline, Section, Station, SweptMesh};

use crate::body::natural::Variation;
use crate::body::rounded::{node_count, ring_shares, ringed};
use crate::body::{Body, even_levels, paper_mesh, rule};
use crate::build_error::BuildError;
use crate::description::{FoodDescription, Spine};
use crate::piece_spec::PieceSpec;
use crate::table::interpolate;
use crate::tissue::noise::uniform;

/// Nodes around the section and rings below its skin (chosen: 2 mm apart on a shrimp of 15 mm).
const AROUND: usize = 20;
const RINGS: usize = 5;
/// First layer below the skin and at both ends [m] (chosen: a seared skin is half a millimetre).
const FIRST_LAYER: f64 = 0.4e-3;
/// Growth of the layers from the ends inwards [-] (chosen), and layers in each segment and in the fan (chosen: one at
/// each groove and two between).
const GROWTH: f64 = 1.7;
const LAYERS: [f64; 2] = [3.0, 4.0];
/// Segments of the abdomen (anatomy), and where along the length they end and the tail fan begins [-] (chosen).
const SEGMENTS: f64 = 6.0;
const FAN_FROM: f64 = 0.83;
/// Depth (back to belly) over the thickest at shares of the length [-] (chosen by eye from peeled shrimp).
const DEPTH_AT: [f64; 11] = [0.0, 0.12, 0.28, 0.45, 0.60, 0.72, 0.80, 0.85, 0.90, 0.96, 1.0];
const DEPTH: [f64; 11] = [0.97, 1.0, 0.98, 0.90, 0.78, 0.66, 0.53, 0.42, 0.66, 0.97, 0.90];
/// Breadth (left to right) over the broadest at shares of the length [-] (chosen in the same way: the fan is a thin blade).
const BREADTH: [f64; 11] = [0.97, 1.0, 0.98, 0.91, 0.81, 0.70, 0.57, 0.43, 0.28, 0.18, 0.16];
/// Depth of the rounding at the head end [-] and its length [m] (chosen: where the head was twisted off).
const ROUNDING: [f64; 2] = [0.16, 1.2e-3];
/// Largest turn over length per thickness [rad] (chosen: the belly of a short, thick shrimp keeps half the spine's distance
/// from the centre of curvature, so that it does not fold).
const MOST_TURN: f64 = 0.9;
/// Depth of the grooves between segments over the radius [-] (chosen: gently visible without the shell).
const GROOVE: f64 = 0.11;

impl Body {
    /// Meshes a shrimp in the x–y plane with its back towards +y and its head end towards −x.
    pub(crate) fn shrimp(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let spine = spine_of(description)?;
        let plain = Shape::new(description, spine, piece);
        let (shape, mut mesh) = match piece.natural(description) {
            None => (plain, plain.mesh(description, piece)?),
            Some(form) => {
                let variation = Variation { form, size: piece.size, seed: piece.seed };
                let grown = plain.grown(&variation, spine);
                // The mesh of a curled shrimp is a little smaller than its shape: both are measured on their meshes.
                let volume = |shape: &Shape| -> Result<f64, BuildError> {
                    Ok(shape.mesh(description, piece)?.graph.volume.iter().sum())
                };
                let thicker = libm::sqrt(volume(&plain)? / volume(&grown)?);
                let grown = Shape { half: grown.half.map(|half| thicker * half), ..grown };
                (grown, grown.mesh(description, piece)?)
            }
        };
        centre(&mut mesh);
        let outline = silhouette(&mesh);
        let size = [piece.size[0], piece.size[1], 2.0 * shape.half[1]];
        Ok(Self::swept(size, mesh, outline))
    }
}

/// Estimated number of nodes of a shrimp, before it is meshed; a natural one has a few more or less [-].
pub(super) fn nodes(description: &FoodDescription, piece: &PieceSpec) -> Result<f64, BuildError> {
    let shape = Shape::new(description, spine_of(description)?, piece);
    let first = FIRST_LAYER * piece.coarseness;
    let levels = shape.levels(first, piece.coarseness).len();
    Ok((node_count(&shape.rings(first, piece.coarseness)) * levels) as f64)
}

fn spine_of(description: &FoodDescription) -> Result<&Spine, BuildError> {
    description.spine.as_ref().ok_or(BuildError::Missing { form: "shrimp", table: "spine" })
}

/// Rounding of a natural head end: its length over the thickest diameter [-], and the least scale of the section there [-]
/// (chosen: where the head was cut off, the flesh is nearly plane with a rounded rim).
const HEAD: [f64; 2] = [0.16, 0.72];
/// How much more slender than the plain one a natural body is where the fan begins, over its thickness at the head [-] (chosen
/// by eye from peeled shrimp).
const TAPER: f64 = 0.12;
/// Height of the rear edge of a natural segment over the front of the next [-] (chosen: the edges of peeled segments overlap by
/// a third of a millimetre).
const STEP: f64 = 0.04;
/// Depth of a natural tail fan over the plain one [-] (chosen: the blades spread).
const FAN_SPREAD: [f64; 2] = [1.0, 1.3];

/// Seeded shape of one shrimp.
#[derive(Clone, Copy)]
struct Shape {
    /// True with the natural form: a rounded head end, a spread fan.
    natural: bool,
    /// Spread of the fan [-].
    spread: f64,
    length: f64,
    /// Half of the largest depth and breadth [m].
    half: [f64; 2],
    /// Angle of the spine's turn [rad].
    turn: f64,
    /// Swelling of the fore and the rear body [-].
    swelling: [f64; 2],
}

impl Shape {
    /// The mesh of the shape, its centre anywhere.
    fn mesh(&self, description: &FoodDescription, piece: &PieceSpec) -> Result<SweptMesh, BuildError> {
        let edge = Outline::superellipse(2.0 * self.half[0], 2.0 * self.half[1], description.outline.exponent, &[]);
        let first = FIRST_LAYER * piece.coarseness;
        let rings = match paper_mesh(description, piece) {
            Some((rings, _)) => rings.to_vec(),
            None => self.rings(first, piece.coarseness),
        };
        let levels = match paper_mesh(description, piece) {
            Some((_, levels)) => even_levels(self.length, levels),
            None => self.levels(first, piece.coarseness),
        };
        let section = Section::concentric(&edge, &rings)?;
        let graded = piece.mesh == crate::paper_2013::MeshSize::Default;
        let path = self.stations(&section, &rings, &levels, graded.then_some(first))?;
        Ok(SweptMesh::along(section, path, rule(piece)))
    }

    /// The natural shape of this plain one: longer and thinner or the reverse, with its own curl, head end and fan.
    fn grown(self, variation: &Variation, spine: &Spine) -> Self {
        let form = variation.form;
        let longer = 1.0 + form.slender * (2.0 * variation.share(560) - 1.0);
        let pick = (variation.share(561) * form.turns_deg.len() as f64) as usize;
        let varied = 0.5 * spine.turn_varies_deg * (2.0 * variation.share(302) - 1.0);
        let turn = form.turns_deg.get(pick).map_or(self.turn, |deg| turned(deg + varied, variation.size));
        let spread = FAN_SPREAD[0] + (FAN_SPREAD[1] - FAN_SPREAD[0]) * variation.share(562);
        let half = self.half.map(|half| half / libm::sqrt(longer));
        Self { natural: true, spread, length: longer * self.length, turn, half, ..self }
    }

    fn new(description: &FoodDescription, spine: &Spine, piece: &PieceSpec) -> Self {
        let ripple = description.outline.ripple;
        let varied = |index: u64| 2.0 * uniform(piece.seed, index) - 1.0;
        Self {
            natural: false,
            spread: 1.0,
            length: piece.size[0],
            half: [0.5 * piece.size[1], 0.5 * piece.size[1] * spine.flattening * (1.0 + 0.5 * ripple * varied(301))],
            turn: turned(spine.turn_deg + spine.turn_varies_deg * varied(302), piece.size),
            swelling: [ripple * varied(303), ripple * varied(304)],
        }
    }

    fn rings(&self, first: f64, coarseness: f64) -> Vec<(usize, f64)> {
        let around = ((AROUND as f64 / coarseness) as usize).max(10);
        ringed(around, &ring_shares(self.half[1], first, RINGS))
    }

    /// Levels along the spine: graded at both ends, aligned with the segments, even in the fan [m].
    fn levels(&self, first: f64, coarseness: f64) -> Vec<f64> {
        let [in_segment, in_fan] = LAYERS.map(|count| libm::ceil(count / coarseness));
        let (body, fan) = (FAN_FROM * self.length, (1.0 - FAN_FROM) * self.length);
        let (step, fan_step) = (body / (SEGMENTS * in_segment), fan / in_fan);
        let (mut ends, mut layer) = (vec![0.0], first);
        while layer < 0.7 * step.min(fan_step) {
            ends.push(ends[ends.len() - 1] + layer);
            layer *= GROWTH;
        }
        let deepest = ends[ends.len() - 1] + 0.5 * layer;
        let segments = (0..(SEGMENTS * in_segment) as usize).map(|k| k as f64 * step);
        let marks = segments.chain((0..in_fan as usize).map(|k| body + k as f64 * fan_step));
        let inside = marks.filter(|m| (deepest..self.length - deepest).contains(m));
        ends.iter().copied().chain(inside).chain(ends.iter().rev().map(|e| self.length - e)).collect()
    }

    /// Depth and breadth relative to the largest, at a share of the length [-].
    fn scale(&self, share: f64) -> [f64; 2] {
        let rounded = if self.natural {
            self.head(share)
        } else {
            1.0 - ROUNDING[0] * libm::exp(-share * self.length / ROUNDING[1])
        };
        let bump = libm::sin(PI * (share / FAN_FROM).min(1.0));
        let along = (share / FAN_FROM * SEGMENTS).min(SEGMENTS);
        // Each segment swells towards its rear edge, which overlaps the next.
        let within = along - libm::floor(along);
        let groove = match share < FAN_FROM {
            true if self.natural => STEP * (1.0 - libm::sqrt(within)) + TAPER * share / FAN_FROM,
            true => GROOVE * (1.0 - libm::sin(PI * libm::pow(within, 1.4))),
            false => 0.0,
        };
        let swollen = 1.0 + bump * (self.swelling[0] * (0.6 - share) + self.swelling[1] * (share - 0.4))
            - 0.2 * bump * bump * libm::fabs(self.swelling[0]);
        let [depth, breadth] = [DEPTH, BREADTH]
            .map(|table| interpolate(&DEPTH_AT, &table, share) * rounded * (1.0 - groove) * swollen.min(1.0));
        [depth * (1.0 + (self.spread - 1.0) * self.in_fan(share)), breadth]
    }

    /// Scale of the section at the head end: an ellipse's quarter, with a blunt tip [-].
    fn head(&self, share: f64) -> f64 {
        let from = (1.0 - share * self.length / (HEAD[0] * 2.0 * self.half[0])).max(0.0);
        HEAD[1] + (1.0 - HEAD[1]) * libm::sqrt(1.0 - from * from)
    }

    /// Share of the way through the tail fan [-].
    fn in_fan(&self, share: f64) -> f64 {
        ((share - FAN_FROM) / (1.0 - FAN_FROM)).clamp(0.0, 1.0)
    }

    /// Direction of the spine at a share of the length [rad]. The body bends more towards the tail; the fan is straight.
    fn heading(&self, share: f64) -> f64 {
        let bent = (share / FAN_FROM).min(1.0);
        self.turn * (0.5 - bent * (0.62 + 0.38 * bent))
    }

    fn stations(
        &self,
        section: &Section,
        rings: &[(usize, f64)],
        levels: &[f64],
        first: Option<f64>,
    ) -> Result<Vec<Station>, BuildError> {
        let mut centre = [0.0; 3];
        let mut stations = Vec::with_capacity(levels.len());
        for (level, &at) in levels.iter().enumerate() {
            let heading = self.heading(at / self.length);
            if level > 0 {
                let run = at - levels[level - 1];
                let mean = self.heading((at - 0.5 * run) / self.length);
                centre[0] += run * libm::cos(mean);
                centre[1] += run * libm::sin(mean);
            }
            let across = [[-libm::sin(heading), libm::cos(heading), 0.0], [0.0, 0.0, 1.0]];
            let points = self.points(section, rings, self.scale(at / self.length), first);
            stations.push(Station::new(section, centre, across, points)?);
        }
        Ok(stations)
    }

    /// Nodes of the section at a scale [m]. In a graded mesh the first layer keeps its thickness at every scale.
    fn points(&self, section: &Section, rings: &[(usize, f64)], scale: [f64; 2], first: Option<f64>) -> Vec<[f64; 2]> {
        let half = (self.half[0] * scale[0]).min(self.half[1] * scale[1]);
        let shares = first.map(|first| ring_shares(half, first, rings.len() - 1));
        let mut points = Vec::with_capacity(section.points.len());
        for (ring, &(count, share)) in rings.iter().enumerate() {
            let now = shares.as_ref().and_then(|s| s.get(ring)).copied().unwrap_or(share);
            let factor = if share > 0.0 { now / share } else { 0.0 };
            for p in &section.points[points.len()..points.len() + count] {
                points.push([factor * scale[0] * p[0], factor * scale[1] * p[1]]);
            }
        }
        points
    }
}

/// Angle of the spine's turn [rad], at most what a body of that size can turn without folding.
fn turned(turn_deg: f64, [length, diameter, _]: [f64; 3]) -> f64 {
    turn_deg.to_radians().min(MOST_TURN * length / diameter)
}

/// Moves the stations so that the centre of volume is the origin.
fn centre(mesh: &mut SweptMesh) {
    let middle = volume_centre(mesh.graph.volume.iter().copied(), |node| mesh.position(node));
    if let saute_heat::Path::Stations(stations) = &mut mesh.path {
        stations.iter_mut().for_each(|s| (0..3).for_each(|k| s.centre[k] -= middle[k]));
    }
}

/// Weighted mean of positions [m].
pub(crate) fn volume_centre(weights: impl Iterator<Item = f64>, place: impl Fn(usize) -> [f64; 3]) -> [f64; 3] {
    let (mut sum, mut whole) = ([0.0; 3], 0.0);
    for (node, weight) in weights.enumerate() {
        let p = place(node);
        (0..3).for_each(|k| sum[k] += weight * p[k]);
        whole += weight;
    }
    sum.map(|s| s / whole)
}

/// Outline seen from above of a body with upright stations: along the belly, then back along the back.
fn silhouette(mesh: &SweptMesh) -> Outline {
    let extreme = |level: usize, sign: f64| {
        let n = mesh.nodes_per_level();
        let along = |i: &usize| sign * mesh.section_at(level).points[*i][0];
        let i = (0..n).max_by(|a, b| along(a).total_cmp(&along(b))).unwrap_or(0);
        let [x, y, _] = mesh.position(mesh.node(level, i));
        [x, y]
    };
    let levels = 0..mesh.levels.len();
    let belly = levels.clone().map(|level| extreme(level, -1.0));
    Outline { points: belly.chain(levels.rev().map(|level| extreme(level, 1.0))).collect() }
}
