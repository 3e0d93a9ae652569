//! Plain bodies as loose triangles [mm].

use glam::DVec3;
use saute_heat::Soup;

/// A triangle by its corners [mm].
pub type Triangle = [[f64; 3]; 3];

/// Returns loose triangles whose corners are not shared, as in STL files.
pub fn soup(triangles: &[Triangle]) -> Soup {
    let vertices = triangles.concat();
    let triangles = (0..triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    Soup { vertices, triangles, ..Soup::default() }
}

/// Returns the triangles of a soup.
pub fn loose(soup: &Soup) -> Vec<Triangle> {
    soup.triangles.iter().map(|t| t.map(|i| soup.vertices[i as usize])).collect()
}

/// Returns a box with one corner at `low`.
pub fn brick(low: [f64; 3], size: [f64; 3]) -> Soup {
    let corner = |k: usize| [0, 1, 2].map(|a| low[a] + if k >> a & 1 == 1 { size[a] } else { 0.0 });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let halves = |q: [usize; 4]| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]];
    soup(&quads.into_iter().flat_map(halves).map(|t| t.map(corner)).collect::<Vec<_>>())
}

/// Returns a ball: an icosahedron divided `divisions` times, scaled to the ball's volume.
pub fn ball(radius: f64, divisions: usize) -> Soup {
    let g = 0.5 * (1.0 + 5f64.sqrt());
    let mut corners: Vec<DVec3> = Vec::new();
    for (a, b) in [(-1.0, g), (1.0, g), (-1.0, -g), (1.0, -g)] {
        corners.extend([[a, b, 0.0], [0.0, a, b], [b, 0.0, a]].map(DVec3::from));
    }
    let near = |p: DVec3, q: DVec3| (p.distance(q) - 2.0).abs() < 1e-9;
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
    for _ in 0..divisions {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [p, q, r] = [a + b, b + c, c + a].map(DVec3::normalize);
                let [a, b, c] = [a, b, c].map(DVec3::normalize);
                [[a, p, r], [p, b, q], [r, q, c], [p, q, r]]
            })
            .collect();
    }
    let volume: f64 = triangles.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum();
    let factor = radius * (4.0 / 3.0 * std::f64::consts::PI / volume).cbrt();
    soup(&triangles.iter().map(|t| t.map(|p| (p * factor).to_array())).collect::<Vec<_>>())
}

fn outward([a, b, c]: [DVec3; 3]) -> [DVec3; 3] {
    if a.dot(b.cross(c)) > 0.0 { [a, b, c] } else { [a, c, b] }
}

/// Returns a prism over a polygon (counter-clockwise, star-shaped about the origin), from z = 0 to its height.
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

/// Returns a polygonal cylinder with the volume of the round one.
pub fn cylinder(radius: f64, height: f64, sides: usize) -> Soup {
    let turn = std::f64::consts::TAU / sides as f64;
    let same_area = (turn / turn.sin()).sqrt();
    let corner = |i: usize| {
        [0.0, 1.0].map(|q: f64| radius * same_area * (turn * i as f64 - q * 0.25 * std::f64::consts::TAU).cos())
    };
    prism(&(0..sides).map(corner).collect::<Vec<_>>(), height)
}

/// Returns an L: a square prism without a quarter, so that one edge is re-entrant.
pub fn angle_piece(edge: f64, height: f64) -> Soup {
    let e = edge;
    // Star-shaped about the origin, which is inside the corner of the L.
    let polygon = [[-e, -e], [e, -e], [e, 0.3 * e], [0.3 * e, 0.3 * e], [0.3 * e, e], [-e, e]];
    prism(&polygon, height)
}
