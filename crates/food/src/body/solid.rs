//! Collision shapes of a piece.

use saute_heat::{Layout, Station, SweptMesh};
use serde::{Deserialize, Serialize};

use crate::body::form::Form;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Capsule: a rod with round ends.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Capsule {
    /// Centres of the round ends [m].
    pub ends: [[f64; 3]; 2],
    /// Radius [m].
    pub radius: f64,
}

/// Collision shape in the body frame and the present shape, about the origin of [`FoodModel::positions`].
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Solid {
    /// A cylinder whose axis is z.
    Cylinder {
        /// Radius [m].
        radius: f64,
        /// Half of its height [m].
        half_height: f64,
    },
    /// A box.
    Cuboid {
        /// Half of its length, width and height [m].
        half: [f64; 3],
    },
    /// Capsules along a bent body.
    Capsules(Vec<Capsule>),
    /// Convex hulls of points, whose faces have four corners [m].
    Hulls(Vec<Vec<[f64; 3]>>),
    /// A closed surface, convex or not.
    Surface {
        /// Corners [m].
        points: Vec<[f64; 3]>,
        /// Triangles, counter-clockwise seen from outside.
        triangles: Vec<[u32; 3]>,
    },
}

impl Solid {
    /// Returns true if no measure of another shape differs from this shape's by more than `tolerance` [m].
    pub fn is_near(&self, other: &Self, tolerance: f64) -> bool {
        let (mine, others) = (self.measures(), other.measures());
        core::mem::discriminant(self) == core::mem::discriminant(other)
            && mine.len() == others.len()
            && mine.iter().zip(others).all(|(a, b)| libm::fabs(a - b) <= tolerance)
    }

    /// All lengths and coordinates [m].
    fn measures(&self) -> Vec<f64> {
        match self {
            Self::Cylinder { radius, half_height } => vec![*radius, *half_height],
            Self::Cuboid { half } => half.to_vec(),
            Self::Capsules(rods) => rods.iter().flat_map(|r| r.ends.into_iter().flatten().chain([r.radius])).collect(),
            Self::Hulls(hulls) => hulls.iter().flatten().flatten().copied().collect(),
            Self::Surface { points, .. } => points.iter().flatten().copied().collect(),
        }
    }
}

/// Number of strips across the length of a slice [-] (chosen: their outline deviates by half a millimetre).
const STRIPS: usize = 8;
/// Number of capsules along a curved body [-] (chosen: fewer fill the inside of a shrimp's curve).
const RODS: usize = 4;

impl FoodModel {
    /// Returns the collision shape of the present shape.
    pub fn solid(&self, state: &FoodState) -> Solid {
        let lateral = state.stretch.lateral;
        let half_height = 0.5 * self.thickness(state);
        match (self.description.form, self.shape.mesh.layout()) {
            (_, Layout::Cells(cells)) => self.cell_solid(cells, state),
            (Form::Shrimp, Layout::Along(mesh, stations)) => Solid::Capsules(self.rods_along(mesh, stations, state)),
            (Form::Stick, Layout::Along(mesh, stations)) => {
                let length = self.present_length(mesh, stations, state);
                Solid::Cuboid { half: [0.5 * length, 0.5 * lateral * self.shape.size[1], half_height] }
            }
            (Form::Steak, Layout::Upright(mesh) | Layout::Along(mesh, _)) => Solid::Hulls(self.strips(mesh, state)),
            (Form::Poured, Layout::Upright(mesh)) => {
                let mut hulls = self.strips(mesh, state);
                hulls.extend(self.yolk_block(state));
                Solid::Hulls(hulls)
            }
            _ => Solid::Cylinder { radius: lateral * self.round_radius(), half_height },
        }
    }

    /// Mean of the smallest and the largest radius of the outline [m].
    fn round_radius(&self) -> f64 {
        let reach = self.shape.outline.points.iter().map(|p| libm::hypot(p[0], p[1]));
        let (low, high) = reach.fold((f64::INFINITY, 0.0f64), |(low, high), r| (low.min(r), high.max(r)));
        0.5 * (low + high)
    }

    fn present_length(&self, mesh: &SweptMesh, stations: &[Station], state: &FoodState) -> f64 {
        let centres: Vec<[f64; 3]> = self.spine(mesh, stations, state).map(|s| s.centre).collect();
        let steps =
            centres.windows(2).map(|w| libm::sqrt((0..3).map(|k| (w[1][k] - w[0][k]) * (w[1][k] - w[0][k])).sum()));
        steps.sum()
    }

    /// Strips across the length, each a prism of four corners above and below; the rigid-body solver allows four per face.
    fn strips(&self, mesh: &SweptMesh, state: &FoodState) -> Vec<Vec<[f64; 3]>> {
        let mut flat = Vec::new();
        self.flat_positions_into(state, &mut flat);
        let (low, high) = self
            .shape
            .outline
            .points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p[0]), high.max(p[0])));
        // Narrower towards the ends, where the outline turns.
        let cut = |i: usize| {
            let share = 0.5 - 0.5 * libm::cos(core::f64::consts::PI * (i as f64 + 0.25) / (STRIPS as f64 + 0.5));
            low + share * (high - low)
        };
        let rim = mesh.section.rim();
        let edges: Vec<Vec<[f64; 3]>> =
            (0..=STRIPS).map(|i| self.edge_at((mesh, &rim), cut(i), state, &flat)).collect();
        edges.windows(2).map(|pair| pair.concat()).collect()
    }

    /// A block in the yolk of a poured piece, from its lower face to the top of the yolk.
    fn yolk_block(&self, state: &FoodState) -> Option<Vec<[f64; 3]>> {
        let dome = &self.shape.pool.as_ref()?.dome;
        let (lateral, half) = (state.stretch.lateral, 0.5 * self.thickness(state));
        let height = dome.height.max(2.0 * half);
        let low = state.stretch.draped * (half - height) - (1.0 - state.stretch.draped) * half;
        let corner = |dx: f64, dy: f64, z: f64| {
            [lateral * (dome.at[0] + dx * dome.radius), lateral * (dome.at[1] + dy * dome.radius), z]
        };
        // Half the radius to each side: round shoulders stay free.
        let sides = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        Some(sides.into_iter().flat_map(|(dx, dy)| [low, low + height].map(|z| corner(dx, dy, z))).collect())
    }

    /// The four corners of the slice in a plane across its length [m].
    fn edge_at(
        &self,
        (mesh, rim): (&SweptMesh, &[u32]),
        x: f64,
        state: &FoodState,
        flat: &[[f64; 3]],
    ) -> Vec<[f64; 3]> {
        let last = mesh.levels.len() - 1;
        let points = &self.shape.outline.points;
        let sides = (0..points.len()).map(|i| (points[i], points[(i + 1) % points.len()]));
        let crossings = sides.filter(|(p, q)| (p[0] <= x) != (q[0] <= x)).map(|(p, q)| {
            let share = (x - p[0]) / (q[0] - p[0]);
            p[1] + share * (q[1] - p[1])
        });
        let (low, high) =
            crossings.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let lateral = state.stretch.lateral;
        let corners = |y: f64| {
            let column = rim_column(mesh, rim, [x, y]);
            let [below, above] = [0, last].map(|level| flat[mesh.node(level, column)][2]);
            // The face lies on what is beyond its shoulder.
            let face = below + (above - below) * (1.0 + self.rim_drop() / mesh.path.column(column));
            [below, face].map(|z| [x * lateral, y * lateral, z])
        };
        [low, high].into_iter().flat_map(corners).collect()
    }

    /// How much lower the rim is than the face beyond the shoulder, over the thickness [-].
    fn rim_drop(&self) -> f64 {
        self.natural().map_or(0.0, |form| form.rim_drop(self.shape.size[2]))
    }

    /// Capsules along a curved body, each as thick as the body is high there.
    fn rods_along(&self, mesh: &SweptMesh, stations: &[Station], state: &FoodState) -> Vec<Capsule> {
        let lateral = state.stretch.lateral;
        let standing: Vec<_> = self.spine(mesh, stations, state).collect();
        let mut places = vec![[0.0; 3]; mesh.node_count()];
        let origin = self.stand(state, stations, standing.iter().copied(), &mut places);
        let half_height =
            |level: usize| lateral * stations[level].section.points.iter().map(|p| p[1]).fold(0.0, f64::max);
        let centre = |level: usize| [0, 1, 2].map(|k| standing[level].centre[k] - origin[k]);
        let cuts: Vec<usize> = (0..=RODS).map(|i| level_near(mesh, i as f64 / RODS as f64)).collect();
        let rod = |pair: &[usize]| {
            let middle = level_near(mesh, 0.5 * (mesh.levels[pair[0]] + mesh.levels[pair[1]]) / mesh.thickness());
            let radius = half_height(middle);
            let (a, b) = (centre(pair[0]), centre(pair[1]));
            let length = libm::sqrt((0..3).map(|k| (b[k] - a[k]) * (b[k] - a[k])).sum::<f64>());
            // The outer ends reach the ends of the body; the inner ones meet.
            let inset =
                |level: usize| if level == cuts[0] || level == cuts[RODS] { (radius / length).min(0.4) } else { 0.0 };
            let (s, e) = (inset(pair[0]), 1.0 - inset(pair[1]));
            let at = |share: f64| [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]));
            Capsule { ends: [at(s), at(e)], radius }
        };
        cuts.windows(2).map(rod).collect()
    }
}

/// The column of the rim nearest to a point of the section.
fn rim_column(mesh: &SweptMesh, rim: &[u32], p: [f64; 2]) -> usize {
    let distance = |i: u32| {
        let q = mesh.section.points[i as usize];
        libm::hypot(p[0] - q[0], p[1] - q[1])
    };
    let apart = rim.iter().map(|i| (distance(*i), *i));
    apart.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(0, |(_, i)| i) as usize
}

/// The level nearest to a share of the path's length.
fn level_near(mesh: &SweptMesh, share: f64) -> usize {
    let at = share * mesh.thickness();
    let distance = |l: &usize| libm::fabs(mesh.levels[*l] - at);
    (0..mesh.levels.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}
