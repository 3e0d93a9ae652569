//! Means of a field over the control volumes of the nodes.

use saute_heat::{BodyMesh, SweptMesh};

/// Samples that are computed together [-] (chosen: two vectors of four single numbers).
pub(crate) const LANES: usize = 8;
/// Single numbers of samples that are computed together.
pub(crate) type Lanes = [f32; LANES];
/// Places in a prism: shares of the three corners of its triangle, and of its height [-].
pub(crate) type Places = [Lanes; 4];

/// A share from 0 to 1 at every point of the rest mesh's frame, such as the share of a tissue [-].
pub(crate) trait Grown {
    /// Share at a point [-].
    fn at(&self, p: [f64; 3]) -> f64;

    /// Returns the share in a box between two corners if it is known to be uniform there [-].
    fn even(&self, low: [f64; 3], high: [f64; 3]) -> Option<f64>;

    /// Mean share in a prism between two triangles [m].
    fn mean(&self, ends: [[[f64; 3]; 3]; 2], places: &[Places]) -> f64 {
        let lane = |places: &Places, lane: usize| {
            let [a, b, c, w] = places.map(|lanes| f64::from(lanes[lane]));
            self.at(between(&ends, [a, b, c], w))
        };
        let sum: f64 = places.iter().map(|group| (0..LANES).map(|i| lane(group, i)).sum::<f64>()).sum();
        sum / (places.len() * LANES) as f64
    }
}

/// Samples of a field.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Samples {
    /// So many in each part of a node's control volume.
    Each(usize),
    /// So many groups of [`LANES`], in single precision, and only where the field is not uniform in the very part.
    Single(usize),
}

/// Mean of a field over the control volume of each node [-]; zeros without a field.
///
/// In a swept mesh the control volume consists of the nearest third of each adjacent triangle, half way to the levels above
/// and below. Each of these parts is sampled `samples` times.
pub(crate) fn node_means(mesh: &BodyMesh, field: Option<&impl Grown>, samples: Samples) -> Vec<f64> {
    match (mesh, field) {
        (_, None) => vec![0.0; mesh.node_count()],
        (BodyMesh::Cells(cells), Some(field)) => {
            let size = cells.graph.volume.iter().map(|v| [libm::cbrt(*v); 3]);
            cells.positions.iter().zip(size).map(|(p, size)| box_mean(*p, size, field)).collect()
        }
        (BodyMesh::Swept(mesh), Some(field)) => swept_means(mesh, field, samples),
    }
}

fn swept_means(mesh: &SweptMesh, field: &impl Grown, samples: Samples) -> Vec<f64> {
    let mut sums = vec![[0.0; 2]; mesh.node_count()];
    let mut sampler = Sampler::new(samples);
    for level in 0..mesh.levels.len() - 1 {
        for triangle in &mesh.section.triangles {
            let nodes = [level, level + 1].map(|l| triangle.map(|i| mesh.node(l, i as usize)));
            let corners = nodes.map(|nodes| nodes.map(|node| mesh.position(node)));
            for half in 0..2 {
                // Columns of marbled slices weigh by what they cover, however their faces slope. (What was poured, and is sampled
                // otherwise, keeps the areas of its slopes.)
                let upright = mesh.is_upright() && matches!(samples, Samples::Single(_));
                let covered = if upright { corners[half].map(|[x, y, _]| [x, y, 0.0]) } else { corners[half] };
                let weight = area(covered) * (mesh.levels[level + 1] - mesh.levels[level]);
                let even = even(field, corners.as_flattened());
                for (k, node) in nodes[half].into_iter().enumerate() {
                    let near = corners.map(|corners| [0, 1, 2].map(|i| corners[(k + i) % 3]));
                    let mean = even.unwrap_or_else(|| sampler.mean(field, &near, 0.5 * half as f64));
                    sums[node][0] += weight * mean;
                    sums[node][1] += weight;
                }
            }
        }
    }
    sums.into_iter().map(|[sum, weight]| if weight > 0.0 { sum / weight } else { 0.0 }).collect()
}

/// Places of samples in the parts of control volumes, spread by a low-discrepancy sequence.
struct Sampler {
    samples: Samples,
    spread: Spread,
    /// Places that the parts take in turn.
    table: Vec<Places>,
    next: usize,
}

/// Groups of places in the table of a sampler [-] (chosen: neighbouring parts take others).
const TABLE: usize = 1024;

impl Sampler {
    fn new(samples: Samples) -> Self {
        let mut spread = Spread(0);
        let mut group = || {
            let mut places = Places::default();
            for lane in 0..LANES {
                let [u, v, w] = spread.next();
                let [a, b, c] = third(u, v);
                [a, b, c, w].into_iter().zip(&mut places).for_each(|(share, lanes)| lanes[lane] = share as f32);
            }
            places
        };
        let table = match samples {
            Samples::Each(_) => Vec::new(),
            Samples::Single(_) => (0..TABLE).map(|_| group()).collect(),
        };
        Self { samples, spread: Spread(0), table, next: 0 }
    }

    /// Mean of a field over a part of a control volume [-]: the half of a prism that starts at the share `from` of its
    /// height, in the third of its triangle nearest to its first corner.
    fn mean(&mut self, field: &impl Grown, corners: &[[[f64; 3]; 3]; 2], from: f64) -> f64 {
        match self.samples {
            Samples::Each(count) => {
                let mut at = || field.at(place(corners, from, self.spread.next()));
                (0..count).map(|_| at()).sum::<f64>() / count as f64
            }
            Samples::Single(count) => {
                let ends = ends_of(corners, from);
                if let Some(even) = even(field, &ends) {
                    return even;
                }
                if self.next + count > TABLE {
                    self.next = 0;
                }
                self.next += count;
                let level = |up: f64| {
                    let corner = |i: usize| {
                        let mut share = [0.0; 3];
                        share[i] = 1.0;
                        between(corners, share, up)
                    };
                    [corner(0), corner(1), corner(2)]
                };
                field.mean([level(from), level(from + 0.5)], &self.table[self.next - count..self.next])
            }
        }
    }
}

/// Corners of the half of a prism that starts at the share `from` of its height, in the third of its triangle nearest to its
/// first corner [m].
fn ends_of(corners: &[[[f64; 3]; 3]; 2], from: f64) -> [[f64; 3]; 8] {
    let third = 1.0 / 3.0;
    let shares = [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [third; 3]];
    core::array::from_fn(|i| between(corners, shares[i % 4], from + 0.5 * (i / 4) as f64))
}

/// Returns the value of a field in the bounding box of some points if it is uniform there [-].
fn even(field: &impl Grown, points: &[[f64; 3]]) -> Option<f64> {
    let corner =
        |start: f64, pick: fn(f64, f64) -> f64| [0, 1, 2].map(|k| points.iter().map(|p| p[k]).fold(start, pick));
    field.even(corner(f64::INFINITY, f64::min), corner(f64::NEG_INFINITY, f64::max))
}

/// Low-discrepancy sequence in the unit cube: multiples of the powers of 1/g, g⁴ = g + 1 (Roberts 2018
/// `[@roberts-2018]`).
struct Spread(u32);

impl Spread {
    fn next(&mut self) -> [f64; 3] {
        self.0 = self.0.wrapping_add(1);
        [0.819_172_513_396_164_5, 0.671_043_606_703_789_3, 0.549_700_477_901_970_2].map(|step| {
            let v = f64::from(self.0) * step;
            v - f64::from(v as u32)
        })
    }
}

/// Maps a point of the unit cube into half of a prism [m]: the half that starts at the share `from` of its height, in the
/// third of its triangle nearest to its first corner.
fn place(corners: &[[[f64; 3]; 3]; 2], from: f64, [u, v, w]: [f64; 3]) -> [f64; 3] {
    between(corners, third(u, v), from + 0.5 * w)
}

/// A point of a prism at shares of its triangle's corners and of its height [m].
fn between(corners: &[[[f64; 3]; 3]; 2], share: [f64; 3], upwards: f64) -> [f64; 3] {
    let on = |level: usize, axis: usize| -> f64 { (0..3).map(|i| share[i] * corners[level][i][axis]).sum() };
    [0, 1, 2].map(|axis| (1.0 - upwards) * on(0, axis) + upwards * on(1, axis))
}

/// Maps a point of the unit square into the third of a triangle nearest to its first corner, as barycentric coordinates [-].
/// The third consists of two triangles: corner, middle of a side, centroid.
fn third(u: f64, v: f64) -> [f64; 3] {
    let (second, u) = if u < 0.5 { (false, 2.0 * u) } else { (true, 2.0 * u - 1.0) };
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    let shares = [1.0 - 0.5 * u - 2.0 / 3.0 * v, 0.5 * u + v / 3.0, v / 3.0];
    if second { [shares[0], shares[2], shares[1]] } else { shares }
}

fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    libm::sqrt((0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum())
}

/// Area of a triangle in space [m²].
fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let side = |p: [f64; 3]| [0, 1, 2].map(|k| p[k] - a[k]);
    let (u, v) = (side(b), side(c));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    0.5 * distance(cross, [0.0; 3])
}

/// Mean of a field over a box about a point, from 3 × 3 × 3 samples.
fn box_mean([x, y, z]: [f64; 3], size: [f64; 3], field: &impl Grown) -> f64 {
    let half = size.map(|s| 0.5 * s);
    let offset = |v: i32| f64::from(v - 1) * 2.0 / 3.0;
    let at = |k: i32| [x + half[0] * offset(k % 3), y + half[1] * offset(k / 3 % 3), z + half[2] * offset(k / 9)];
    (0..27).map(|k| field.at(at(k))).sum::<f64>() / 27.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_spread_over_the_cube_without_gaps() {
        let mut spread = Spread(0);
        let mut held = [[[0u32; 8]; 8]; 8];
        for _ in 0..8 * 512 {
            let [x, y, z] = spread.next().map(|v| (8.0 * v) as usize);
            held[x][y][z] += 1;
        }
        let counts = || held.iter().flatten().flatten();
        assert!(counts().all(|n| (2..=16).contains(n)), "{:?} to {:?}", counts().min(), counts().max());
    }

    #[test]
    fn samples_of_a_third_lie_nearest_to_its_corner_and_fill_it_evenly() {
        let at = |i: u32| (f64::from(i) + 0.5) / 100.0;
        let shares: Vec<[f64; 3]> = (0..100).flat_map(|i| (0..100).map(move |j| third(at(i), at(j)))).collect();
        for share in &shares {
            assert!((share.iter().sum::<f64>() - 1.0).abs() < 1e-12 && share.iter().all(|s| *s >= 0.0));
            assert!(share[0] >= share[1] && share[0] >= share[2], "{share:?}");
        }
        // The third's own centroid: 11/18, 7/36, 7/36.
        let mean = |k: usize| shares.iter().map(|s| s[k]).sum::<f64>() / shares.len() as f64;
        assert!((mean(0) - 11.0 / 18.0).abs() < 1e-3 && (mean(1) - 7.0 / 36.0).abs() < 1e-3, "{}", mean(0));
    }
}
