//! Simple solids that stand for a piece where bodies collide.

use saute_heat::{Path, Station};

use crate::form::Form;
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
/// Corners of the hexagon about a section over its half axes. Flat above and below, where it lies; its
/// corners stray as far outside as its sides inside.
const HEXAGON: [[f64; 2]; 6] = [[1.05, 0.0], [0.56, 1.0], [-0.56, 1.0], [-1.05, 0.0], [-0.56, -1.0], [0.56, -1.0]];

impl FoodModel {
    /// The solid of the present shape.
    pub fn solid(&self, state: &FoodState) -> Solid {
        let lateral = state.stretch.lateral;
        let half_height = 0.5 * self.thickness(state);
        match (self.description.form, &self.mesh.path) {
            (_, Path::Cells(cells)) => self.cell_solid(cells, state),
            (Form::Shrimp, Path::Stations(stations)) => Solid::Hulls(self.hulls_along(state, stations)),
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

    /// Hulls of a curved body: hexagons at both ends of each, and the back of the middle between them.
    fn hulls_along(&self, state: &FoodState, stations: &[Station]) -> Vec<Vec<[f64; 3]>> {
        let lateral = state.stretch.lateral;
        let standing: Vec<_> = self.spine(state, stations).collect();
        let origin = self.spine_origin(state);
        let corners = |level: usize, which: &[usize], points: &mut Vec<[f64; 3]>| {
            let station = &stations[level];
            let half = [0, 1].map(|k| station.section.points.iter().map(|p| p[k]).fold(0.0, f64::max));
            for [x, y] in which.iter().map(|i| HEXAGON[*i]) {
                let p = standing[level].place(station, [x * half[0], y * half[1]], lateral);
                points.push([0, 1, 2].map(|k| p[k] - origin[k]));
            }
        };
        let cuts: Vec<usize> = (0..=HULLS).map(|i| self.level_near(i as f64 / HULLS as f64)).collect();
        let hull = |pair: &[usize]| {
            let (from, to) = (pair[0], pair[1]);
            let middle = self.level_near(0.5 * (self.mesh.levels[from] + self.mesh.levels[to]) / self.mesh.thickness());
            let mut points = Vec::new();
            corners(from, &[0, 1, 2, 3, 4, 5], &mut points);
            corners(middle, &[0, 1, 2, 5], &mut points);
            corners(to, &[0, 1, 2, 3, 4, 5], &mut points);
            points
        };
        cuts.windows(2).map(hull).collect()
    }

    /// The level nearest to a share of the path's length.
    fn level_near(&self, share: f64) -> usize {
        let at = share * self.mesh.thickness();
        let distance = |l: &usize| libm::fabs(self.mesh.levels[*l] - at);
        (0..self.mesh.levels.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }

    /// What [`Self::positions`] takes off the places along the spine [m].
    fn spine_origin(&self, state: &FoodState) -> [f64; 3] {
        let (n, Path::Stations(stations)) = (self.mesh.nodes_per_level(), &self.mesh.path) else { return [0.0; 3] };
        let mut places = vec![[0.0; 3]; self.mesh.node_count()];
        for (level, standing) in self.spine(state, stations).enumerate() {
            for (i, p) in stations[level].section.points.iter().enumerate() {
                places[level * n + i] = standing.place(&stations[level], *p, state.stretch.lateral);
            }
        }
        self.centre_of(&places)
    }
}
