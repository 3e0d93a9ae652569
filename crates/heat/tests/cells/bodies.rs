//! Plain bodies as loose triangles [mm].

use saute_heat::Soup;
use saute_heat::vector::{Vec3, add, length, scale};

/// Adds triangles whose corners are not shared, as STL files hold them.
pub fn soup(triangles: &[[Vec3; 3]]) -> Soup {
    let vertices = triangles.concat();
    let triangles = (0..triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    Soup { vertices, triangles, ..Soup::default() }
}

/// Triangles of a soup.
pub fn loose(soup: &Soup) -> Vec<[Vec3; 3]> {
    soup.triangles.iter().map(|t| t.map(|i| soup.vertices[i as usize])).collect()
}

/// A box with one corner at `low`.
pub fn brick(low: Vec3, size: Vec3) -> Soup {
    let corner = |k: usize| [0, 1, 2].map(|a| low[a] + if k >> a & 1 == 1 { size[a] } else { 0.0 });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let halves = |q: [usize; 4]| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]];
    soup(&quads.into_iter().flat_map(halves).map(|t| t.map(corner)).collect::<Vec<_>>())
}

/// A ball: an icosahedron divided `divisions` times, scaled to the ball's volume.
pub fn ball(radius: f64, divisions: usize) -> Soup {
    let g = 0.5 * (1.0 + 5f64.sqrt());
    let mut corners: Vec<Vec3> = Vec::new();
    for (a, b) in [(-1.0, g), (1.0, g), (-1.0, -g), (1.0, -g)] {
        corners.extend([[a, b, 0.0], [0.0, a, b], [b, 0.0, a]]);
    }
    let near = |p: Vec3, q: Vec3| (length([p[0] - q[0], p[1] - q[1], p[2] - q[2]]) - 2.0).abs() < 1e-9;
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [p, q, r] = [corners[i], corners[j], corners[k]];
                if near(p, q) && near(q, r) && near(r, p) {
                    triangles.push(outward([p, q, r]));
                }
            }
        }
    }
    let onto = |p: Vec3| scale(p, 1.0 / length(p));
    for _ in 0..divisions {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [p, q, r] = [onto(add(a, b)), onto(add(b, c)), onto(add(c, a))];
                [[onto(a), p, r], [p, onto(b), q], [r, q, onto(c)], [p, q, r]]
            })
            .collect();
    }
    let volume: f64 = triangles.iter().map(|[a, b, c]| determinant(*a, *b, *c) / 6.0).sum();
    let factor = radius * (4.0 / 3.0 * std::f64::consts::PI / volume).cbrt();
    soup(&triangles.iter().map(|t| t.map(|p| scale(p, factor))).collect::<Vec<_>>())
}

fn determinant(a: Vec3, b: Vec3, c: Vec3) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

fn outward([a, b, c]: [Vec3; 3]) -> [Vec3; 3] {
    if determinant(a, b, c) > 0.0 { [a, b, c] } else { [a, c, b] }
}

/// A prism over a polygon (counter-clockwise, star-shaped about the origin), from z = 0 to its height.
pub fn prism(polygon: &[[f64; 2]], height: f64) -> Soup {
    let at = |i: usize, z: f64| [polygon[i % polygon.len()][0], polygon[i % polygon.len()][1], z];
    let mut triangles = Vec::new();
    for i in 0..polygon.len() {
        triangles.push([[0.0, 0.0, 0.0], at(i + 1, 0.0), at(i, 0.0)]);
        triangles.push([[0.0, 0.0, height], at(i, height), at(i + 1, height)]);
        triangles.push([at(i, 0.0), at(i + 1, 0.0), at(i + 1, height)]);
        triangles.push([at(i, 0.0), at(i + 1, height), at(i, height)]);
    }
    soup(&triangles)
}

/// A cylinder of a radius and height with the round one's volume.
pub fn cylinder(radius: f64, height: f64, sides: usize) -> Soup {
    let turn = std::f64::consts::TAU / sides as f64;
    let same_area = (turn / turn.sin()).sqrt();
    let corner = |i: usize| {
        [0.0, 1.0].map(|q: f64| radius * same_area * (turn * i as f64 - q * 0.25 * std::f64::consts::TAU).cos())
    };
    prism(&(0..sides).map(corner).collect::<Vec<_>>(), height)
}

/// An L: a square prism with a quarter cut away, so that one edge is re-entrant.
pub fn angle_piece(edge: f64, height: f64) -> Soup {
    let e = edge;
    // Star-shaped about the origin, which lies in the corner of the L.
    let polygon = [[-e, -e], [e, -e], [e, 0.3 * e], [0.3 * e, 0.3 * e], [0.3 * e, e], [-e, e]];
    prism(&polygon, height)
}
