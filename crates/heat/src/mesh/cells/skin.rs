//! The refined surface of a cell mesh for drawing, with interpolation weights from the nodes on it.

use glam::DVec3;

use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::Sample;
use crate::mesh::surface::Surface;
use crate::mesh::surface::refine::halve_long_edges;

/// Longest edge of a drawn triangle ÷ spacing of the surface nodes [-] (chosen: smaller triangles show no more detail).
const LONGEST: f64 = 1.0;
/// Most bisections of an edge [-] (chosen: an edge of 300 mm is then shorter than the finest spacing).
const HALVINGS: usize = 10;

/// A closed surface for drawing, with vertices in [m], that interpolates fields of the surface nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Vertices [m].
    pub vertices: Vec<[f64; 3]>,
    /// Outward unit normals [-].
    pub normals: Vec<[f64; 3]>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Nodes from which each vertex is interpolated.
    pub nodes: Vec<[u32; 4]>,
    /// Weights of these nodes; they sum to 1 [-].
    pub weights: Vec<[f64; 4]>,
}

impl Skin {
    /// Returns the surface refined to the spacing of its nodes [m]; sample i is node i.
    pub(super) fn new(surface: &Surface, samples: &[Sample], spacing: f64) -> Self {
        let mut fine = Surface::clone(surface);
        let mut triangles = std::mem::take(&mut fine.triangles);
        for _ in 0..HALVINGS {
            if !halve_long_edges(&mut fine, &mut triangles, LONGEST * spacing) {
                break;
            }
        }
        fine.triangles = triangles;
        let (vertices, normals, triangles) = split_at_creases(&fine);
        let positions: Vec<DVec3> = samples.iter().map(|s| s.position).collect();
        let grid = PointGrid::of(&positions, spacing);
        let read = |(p, n): (&DVec3, &DVec3)| weights(&grid, samples, *p, *n, spacing);
        let (nodes, weights) = vertices.iter().zip(&normals).map(read).unzip();
        let arrays = |v: Vec<DVec3>| v.iter().map(DVec3::to_array).collect();
        Self { vertices: arrays(vertices), normals: arrays(normals), triangles, nodes, weights }
    }

    /// Returns the value of a node field at a vertex, in the unit of the field.
    #[inline]
    pub fn read(&self, vertex: usize, field: &[f64]) -> f64 {
        (0..4).map(|k| self.weights[vertex][k] * field[self.nodes[vertex][k] as usize]).sum()
    }
}

/// Cosine of the angle between faces below which they share one vertex normal [-] (chosen: 45°).
const SMOOTH: f64 = 0.707;

/// Returns vertices, vertex normals and triangles, with vertices duplicated at sharp edges so that each has one normal.
fn split_at_creases(surface: &Surface) -> (Vec<DVec3>, Vec<DVec3>, Vec<[u32; 3]>) {
    let mut sides: Vec<Vec<(DVec3, u32)>> = vec![Vec::new(); surface.vertices.len()];
    let (mut vertices, mut sums) = (Vec::new(), Vec::<DVec3>::new());
    let mut triangles = Vec::with_capacity(surface.triangles.len());
    for (t, ids) in surface.triangles.iter().enumerate() {
        let (doubled, normal) = (surface.doubled_area(t), surface.normal(t));
        triangles.push(ids.map(|v| {
            let known = sides[v as usize].iter().find(|(n, _)| n.dot(normal) > SMOOTH).map(|s| s.1);
            let at = known.unwrap_or_else(|| {
                vertices.push(surface.vertex(v));
                sums.push(DVec3::ZERO);
                sides[v as usize].push((normal, vertices.len() as u32 - 1));
                vertices.len() as u32 - 1
            });
            sums[at as usize] += doubled;
            at
        }));
    }
    (vertices, sums.into_iter().map(DVec3::normalize_or_zero).collect(), triangles)
}

/// Returns the four nearest nodes on the same side of the body with Franke–Little weights [-].
///
/// wₖ = ((R − dₖ) / (R dₖ))², normalised, with R the distance of the fifth node: the interpolated field is continuous.
/// Source: Franke & Nielson 1980, Int. J. Numer. Meth. Eng. 15:1691.
fn weights(grid: &PointGrid, samples: &[Sample], p: DVec3, normal: DVec3, spacing: f64) -> ([u32; 4], [f64; 4]) {
    let facing = |i: u32| samples[i as usize].normal.dot(normal) > 0.0;
    let mut near: Vec<(f64, u32)> = Vec::new();
    let mut reach = 1.5 * spacing;
    while near.len() < 5 && reach < 8.0 * spacing {
        near.clear();
        grid.within(p, reach, |i, d| {
            if facing(i) {
                near.push((d, i));
            }
        });
        reach *= 1.5;
    }
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let nearest = near.first().map(|n| n.1).or_else(|| grid.nearest(p, spacing, |_| true)).unwrap_or(0);
    let Some(&(limit, _)) = near.get(4) else { return ([nearest; 4], [1.0, 0.0, 0.0, 0.0]) };
    let floor = 1e-6 * spacing;
    let raw = [0, 1, 2, 3].map(|k| {
        let d = near[k].0.max(floor);
        let w = ((limit - d) / (limit * d)).max(0.0);
        w * w
    });
    let sum: f64 = raw.iter().sum();
    if sum > 0.0 {
        ([0, 1, 2, 3].map(|k| near[k].1), raw.map(|w| w / sum))
    } else {
        ([nearest; 4], [1.0, 0.0, 0.0, 0.0])
    }
}
