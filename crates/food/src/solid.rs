//! Simple solids that stand for a piece where bodies collide.

use saute_heat::{Path, Station};

use crate::form::Form;
use crate::hull::{self, HullCorner};
use crate::model::FoodModel;
use crate::state::FoodState;

/// A solid about the origin of [`FoodModel::positions`], in the body frame and the present shape.
#[derive(Clone, Debug, PartialEq)]
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
    /// Convex hulls of points [m].
    Hulls(Vec<Vec<[f64; 3]>>),
    /// A closed surface that need not be convex.
    Surface {
        /// Corners [m].
        points: Vec<[f64; 3]>,
        /// Triangles, counter-clockwise seen from outside.
        triangles: Vec<[u32; 3]>,
    },
}

/// How far the polygon about an outline may stray from it [m] (chosen: below what is seen or felt).
const STRAY: f64 = 0.25e-3;
/// Fewest and most corners of that polygon (chosen: 16 are enough for small pieces, 32 for any steak).
const CORNERS: [usize; 2] = [16, 32];
/// Hulls along a curved body (chosen: fewer leave the bow of a shrimp filled).
const HULLS: usize = 3;
/// Most corners of each (chosen for speed: with 16 a hull strays by up to 1.4 mm from the body, with 24 by 0.7, with 40 by 0.4).
const MOST_CORNERS: usize = 16;

impl FoodModel {
    /// The solid of the present shape.
    pub fn solid(&self, state: &FoodState) -> Solid {
        let lateral = state.stretch.lateral;
        let half_height = 0.5 * self.thickness(state);
        match (self.description.form, &self.mesh.path) {
            (_, Path::Cells(cells)) => self.cell_solid(cells, state),
            (Form::Shrimp, Path::Stations(_)) => Solid::Hulls(self.hulls_along(state)),
            (Form::Stick, Path::Stations(stations)) => {
                let length = self.present_length(state, stations);
                Solid::Cuboid { half: [0.5 * length, 0.5 * lateral * self.size[1], half_height] }
            }
            (Form::Steak, _) => Solid::Hulls(vec![self.prism(state)]),
            _ => Solid::Cylinder { radius: lateral * self.round_radius(), half_height },
        }
    }

    /// Radius midway between the least and the farthest reach of the outline [m].
    fn round_radius(&self) -> f64 {
        let reach = self.outline.points.iter().map(|p| libm::hypot(p[0], p[1]));
        let (low, high) = reach.fold((f64::INFINITY, 0.0f64), |(low, high), r| (low.min(r), high.max(r)));
        0.5 * (low + high)
    }

    fn present_length(&self, state: &FoodState, stations: &[Station]) -> f64 {
        let centres: Vec<[f64; 3]> = self.spine(state, stations).map(|s| s.centre).collect();
        let steps =
            centres.windows(2).map(|w| libm::sqrt((0..3).map(|k| (w[1][k] - w[0][k]) * (w[1][k] - w[0][k])).sum()));
        steps.sum()
    }

    /// A polygon about the outline, at the heights of both faces.
    fn prism(&self, state: &FoodState) -> Vec<[f64; 3]> {
        let positions = {
            let mut flat = Vec::new();
            self.flat_positions_into(state, &mut flat);
            flat
        };
        let rim = self.mesh.section.rim();
        let last = self.mesh.levels.len() - 1;
        let corners = self.outline.polygon(STRAY, CORNERS);
        let nearest = |p: [f64; 2]| {
            let distance = |i: &u32| {
                let q = self.mesh.section.points[*i as usize];
                libm::hypot(p[0] - q[0], p[1] - q[1])
            };
            rim.iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0) as usize
        };
        let mut points = Vec::with_capacity(2 * corners.len());
        for p in corners {
            let column = nearest(p);
            for level in [0, last] {
                let z = positions[self.mesh.node(level, column)][2];
                points.push([p[0] * state.stretch.lateral, p[1] * state.stretch.lateral, z]);
            }
        }
        points
    }

    /// Corners of the hulls of a curved body, each for an even part of its path; none of other forms.
    pub(crate) fn hull_corners(&self) -> Vec<Vec<HullCorner>> {
        if self.description.form != Form::Shrimp || self.is_slice() {
            return Vec::new();
        }
        let n = self.mesh.nodes_per_level();
        let mut normals = std::collections::BTreeMap::<u32, [f64; 3]>::new();
        for (patch, normal) in self.patches.iter().zip(&self.rest_normals) {
            let sum = normals.entry(patch.node).or_default();
            (0..3).for_each(|k| sum[k] += patch.area * normal[k]);
        }
        let cuts: Vec<usize> = (0..=HULLS).map(|i| self.level_near(i as f64 / HULLS as f64)).collect();
        let part = |pair: &[usize]| {
            let within = normals.iter().filter(|(node, _)| (pair[0]..=pair[1]).contains(&(**node as usize / n)));
            let nodes: Vec<_> = within.map(|(node, out)| (*node, self.rest_position(*node as usize), *out)).collect();
            hull::corners(&nodes, MOST_CORNERS)
        };
        cuts.windows(2).map(part).collect()
    }

    /// The hulls' corners in the present shape: they go with their nodes.
    fn hulls_along(&self, state: &FoodState) -> Vec<Vec<[f64; 3]>> {
        let positions = self.positions(state);
        let corner = |c: &HullCorner| {
            let p = positions[c.node as usize];
            [0, 1, 2].map(|k| p[k] + c.outset[k])
        };
        self.hulls.iter().map(|hull| hull.iter().map(corner).collect()).collect()
    }

    /// The level nearest to a share of the path's length.
    fn level_near(&self, share: f64) -> usize {
        let at = share * self.mesh.thickness();
        let distance = |l: &usize| libm::fabs(self.mesh.levels[*l] - at);
        (0..self.mesh.levels.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }
}
