//! Triangles of the surface to be drawn, fed by the nodes that lie on it.

use std::collections::BTreeMap;

use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::Sample;
use crate::mesh::surface::Surface;
use crate::vector::{Vec3, add, distance, dot, scale, unit};

/// Longest edge that is drawn over the spacing of the surface's nodes [-] (chosen: what is finer shows nothing new).
const LONGEST: f64 = 1.0;
/// Most halvings of an edge (chosen: an edge of 300 mm then ends below the finest spacing).
const HALVINGS: usize = 10;

/// A closed surface whose vertices read fields from nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Vertices [m].
    pub vertices: Vec<Vec3>,
    /// Outward unit normals.
    pub normals: Vec<Vec3>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The nodes that each vertex reads.
    pub nodes: Vec<[u32; 4]>,
    /// Their weights; they sum to 1 [-].
    pub weights: Vec<[f64; 4]>,
}

impl Skin {
    /// Refines a surface to the spacing of its nodes [m]; sample i is node i.
    pub(super) fn new(surface: &Surface, samples: &[Sample], spacing: f64) -> Self {
        let mut fine = Surface::clone(surface);
        for _ in 0..HALVINGS {
            if !halve_long_edges(&mut fine, LONGEST * spacing) {
                break;
            }
        }
        let (vertices, normals, triangles) = split_at_creases(&fine);
        let positions: Vec<Vec3> = samples.iter().map(|s| s.position).collect();
        let grid = PointGrid::of(&positions, spacing);
        let read = |(p, n): (&Vec3, &Vec3)| weights(&grid, samples, *p, *n, spacing);
        let (nodes, weights) = vertices.iter().zip(&normals).map(read).unzip();
        Self { vertices, normals, triangles, nodes, weights }
    }

    /// Value of a node field at a vertex.
    #[inline]
    pub fn read(&self, vertex: usize, field: &[f64]) -> f64 {
        (0..4).map(|k| self.weights[vertex][k] * field[self.nodes[vertex][k] as usize]).sum()
    }
}

/// Puts a vertex into the middle of every edge that is too long; tells whether there was one.
fn halve_long_edges(surface: &mut Surface, longest: f64) -> bool {
    let mut middles = BTreeMap::<[u32; 2], u32>::new();
    let mut triangles = Vec::with_capacity(surface.triangles.len());
    for t in std::mem::take(&mut surface.triangles) {
        let mids = [0, 1, 2].map(|k| {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            let [p, q] = [a, b].map(|v| surface.vertices[v as usize]);
            (distance(p, q) > longest).then(|| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    surface.vertices.push(scale(add(p, q), 0.5));
                    surface.vertices.len() as u32 - 1
                })
            })
        });
        split(&surface.vertices, t, mids, &mut triangles);
    }
    surface.triangles = triangles;
    !middles.is_empty()
}

/// Divides a triangle along the middles of its edges that have one.
fn split(vertices: &[Vec3], t: [u32; 3], mids: [Option<u32>; 3], triangles: &mut Vec<[u32; 3]>) {
    if let [Some(p), Some(q), Some(r)] = mids {
        triangles.extend([[t[0], p, r], [p, t[1], q], [r, q, t[2]], [p, q, r]]);
        return;
    }
    let Some(k) = (0..3).find(|&k| mids[k].is_some() && mids[(k + 2) % 3].is_none()) else {
        triangles.push(t);
        return;
    };
    let [a, b, c] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
    match (mids[k], mids[(k + 1) % 3]) {
        (Some(p), Some(q)) => {
            triangles.push([p, b, q]);
            let d = |u: u32, v: u32| distance(vertices[u as usize], vertices[v as usize]);
            // The shorter diagonal keeps the triangles fat.
            if d(a, q) < d(p, c) {
                triangles.extend([[a, p, q], [a, q, c]]);
            } else {
                triangles.extend([[a, p, c], [p, q, c]]);
            }
        }
        (Some(p), None) => triangles.extend([[a, p, c], [p, b, c]]),
        _ => triangles.push(t),
    }
}

/// Cosine between faces beyond which a vertex is drawn with one normal [-] (chosen: 45°).
const SMOOTH: f64 = 0.707;

/// Doubles the vertices at sharp edges, so that each has one normal.
fn split_at_creases(surface: &Surface) -> (Vec<Vec3>, Vec<Vec3>, Vec<[u32; 3]>) {
    let mut sides: Vec<Vec<(Vec3, u32)>> = vec![Vec::new(); surface.vertices.len()];
    let (mut vertices, mut sums) = (Vec::new(), Vec::<Vec3>::new());
    let mut triangles = Vec::with_capacity(surface.triangles.len());
    for (t, ids) in surface.triangles.iter().enumerate() {
        let (doubled, normal) = (surface.doubled_area(t), surface.normal(t));
        triangles.push(ids.map(|v| {
            let known = sides[v as usize].iter().find(|(n, _)| dot(*n, normal) > SMOOTH).map(|s| s.1);
            let at = known.unwrap_or_else(|| {
                vertices.push(surface.vertices[v as usize]);
                sums.push([0.0; 3]);
                sides[v as usize].push((normal, vertices.len() as u32 - 1));
                vertices.len() as u32 - 1
            });
            sums[at as usize] = add(sums[at as usize], doubled);
            at
        }));
    }
    (vertices, sums.into_iter().map(unit).collect(), triangles)
}

/// Nodes near a vertex on its side of the body, weighted so that the field is continuous (Franke & Little's weights: those
/// of the fifth and farther nodes are 0).
fn weights(grid: &PointGrid, samples: &[Sample], p: Vec3, normal: Vec3, spacing: f64) -> ([u32; 4], [f64; 4]) {
    let facing = |i: u32| dot(samples[i as usize].normal, normal) > 0.0;
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
