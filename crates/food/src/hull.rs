//! Few points whose convex hull stands for many: corners of the solids of curved bodies.

/// A corner of a hull: a node of the surface, and how far out of it the corner lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HullCorner {
    /// The node.
    pub(crate) node: u32,
    /// From the node to the corner, in the rest shape [m].
    pub(crate) outset: [f64; 3],
}

/// Directions in which a hull is compared with what it stands for (chosen: 9° apart).
const DIRECTIONS: u32 = 500;
/// Share of the largest shortfall by which corners are set out [-] (chosen: as much outside as is left inside).
const SET_OUT: f64 = 0.5;

/// At most `most` corners for nodes at positions [m], with the outward normal of each: the farthest node downwards and
/// upwards, then again and again the farthest one in the direction in which the hull falls short most.
///
/// All corners are then set out by half of the shortfall that is left, but no deeper or higher than the body itself, so
/// that it neither floats nor sinks.
pub(crate) fn corners(nodes: &[(u32, [f64; 3], [f64; 3])], most: usize) -> Vec<HullCorner> {
    let directions: Vec<[f64; 3]> = [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]].into_iter().chain(spiral()).collect();
    let farthest: Vec<usize> = directions.iter().map(|d| extreme(nodes, *d)).collect();
    let reach: Vec<f64> = directions.iter().zip(&farthest).map(|(d, i)| dot(nodes[*i].1, *d)).collect();
    let mut chosen = vec![farthest[0], farthest[1]];
    let mut shortfall: Vec<f64> = directions.iter().zip(&reach).map(|(d, r)| r - support(nodes, &chosen, *d)).collect();
    while chosen.len() < most {
        let worst = (0..shortfall.len()).max_by(|a, b| shortfall[*a].total_cmp(&shortfall[*b])).unwrap_or(0);
        let next = farthest[worst];
        chosen.push(next);
        for ((short, d), r) in shortfall.iter_mut().zip(&directions).zip(&reach) {
            *short = short.min(r - dot(nodes[next].1, *d));
        }
    }
    let out = SET_OUT * shortfall.iter().copied().fold(0.0, f64::max);
    let corner = |i: usize| {
        let (node, p, normal) = nodes[i];
        let length = libm::sqrt(dot(normal, normal)).max(1e-12);
        let [x, y, z] = normal.map(|v| out * v / length);
        HullCorner { node, outset: [x, y, (p[2] + z).clamp(-reach[0], reach[1]) - p[2]] }
    };
    chosen.into_iter().map(corner).collect()
}

fn extreme(nodes: &[(u32, [f64; 3], [f64; 3])], d: [f64; 3]) -> usize {
    (0..nodes.len()).max_by(|a, b| dot(nodes[*a].1, d).total_cmp(&dot(nodes[*b].1, d))).unwrap_or(0)
}

fn support(nodes: &[(u32, [f64; 3], [f64; 3])], chosen: &[usize], d: [f64; 3]) -> f64 {
    chosen.iter().map(|i| dot(nodes[*i].1, d)).fold(f64::NEG_INFINITY, f64::max)
}

/// Directions spread evenly over the sphere along a golden spiral.
fn spiral() -> impl Iterator<Item = [f64; 3]> {
    let golden = core::f64::consts::PI * (3.0 - libm::sqrt(5.0));
    (0..DIRECTIONS).map(move |i| {
        let (z, angle) = (1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(DIRECTIONS), golden * f64::from(i));
        let r = libm::sqrt(1.0 - z * z);
        [r * libm::cos(angle), r * libm::sin(angle), z]
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
