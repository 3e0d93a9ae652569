//! Paths of free juice through a body of cells: along the fibres to the nearer end, or straight to the skin.

use saute_heat::CellMesh;
use saute_heat::vector::{dot, scale, sub, unit};

/// Smallest cosine between the fibres and an edge that juice follows [-] (chosen: 60°).
const FOLLOWS: f64 = 0.5;

/// The next node of every node, and the distance to the skin along these steps [m].
struct Way {
    next: Vec<u32>,
    left: Vec<f64>,
}

/// Returns the steps of juice as (from, to, distance [m]), nodes nearest to the end of their path first.
pub(crate) fn juice_ways(cells: &CellMesh, fibres: Option<[f64; 3]>) -> Vec<(u32, u32, f64)> {
    let beside = neighbours(cells);
    let up = Way::new(cells, &beside, |_, _, rise| rise, |node| -cells.depth[node], 0.0);
    let along = fibres.map(unit).into_iter().flat_map(|f| [f, scale(f, -1.0)]);
    let ways: Vec<Way> = along
        .map(|f| {
            let place = |node: usize| dot(cells.positions[node], f);
            Way::new(
                cells,
                &beside,
                |from, to, _| dot(unit(sub(cells.positions[to], cells.positions[from])), f),
                place,
                FOLLOWS,
            )
        })
        .collect();
    let mut steps: Vec<(f64, u32, u32)> = Vec::new();
    for node in 0..cells.node_count() {
        let shorter = ways.iter().min_by(|a, b| a.left[node].total_cmp(&b.left[node]));
        let way = shorter.filter(|w| w.left[node].is_finite()).unwrap_or(&up);
        if way.next[node] != u32::MAX {
            steps.push((way.left[node], node as u32, way.next[node]));
        }
    }
    steps.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    steps.into_iter().map(|(_, from, to)| (from, to, length(cells, from as usize, to as usize))).collect()
}

fn length(cells: &CellMesh, a: usize, b: usize) -> f64 {
    saute_heat::vector::distance(cells.positions[a], cells.positions[b])
}

fn neighbours(cells: &CellMesh) -> Vec<Vec<u32>> {
    let mut beside = vec![Vec::new(); cells.node_count()];
    for &[a, b] in &cells.graph.ends {
        beside[a as usize].push(b);
        beside[b as usize].push(a);
    }
    beside
}

impl Way {
    /// Steps from every node below the skin to its neighbour of the highest `merit` above `least`; `place` grows along the
    /// path.
    ///
    /// The arguments of `merit` are both nodes and the decrease of the depth over their distance.
    fn new(
        cells: &CellMesh,
        beside: &[Vec<u32>],
        merit: impl Fn(usize, usize, f64) -> f64,
        place: impl Fn(usize) -> f64,
        least: f64,
    ) -> Self {
        let n = cells.node_count();
        let mut way = Self { next: vec![u32::MAX; n], left: vec![0.0; n] };
        let mut order: Vec<usize> = (0..n).filter(|node| cells.depth[*node] > 0.0).collect();
        order.sort_by(|a, b| place(*b).total_cmp(&place(*a)).then(a.cmp(b)));
        for node in order {
            let rise = |to: usize| (cells.depth[node] - cells.depth[to]) / length(cells, node, to);
            let merits = beside[node].iter().map(|&to| (merit(node, to as usize, rise(to as usize)), to));
            let best = merits.filter(|m| m.0 > least).max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            way.left[node] =
                best.map_or(f64::INFINITY, |(_, to)| way.left[to as usize] + length(cells, node, to as usize));
            way.next[node] = best.map_or(u32::MAX, |(_, to)| to);
        }
        way
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_heat::{Fineness, Soup, Surface};

    fn brick() -> CellMesh {
        let size = [0.03, 0.02, 0.012];
        let corner = |k: usize| [0, 1, 2].map(|a| if k >> a & 1 == 1 { size[a] } else { 0.0 });
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
        let soup = Soup { vertices: (0..8).map(corner).collect(), triangles, ..Soup::default() };
        let surface = Surface::close(&soup, 1.0).expect("closed").centred(1.0);
        let fineness = Fineness::of(&surface, 1.0);
        CellMesh::new(surface, fineness).expect("meshes")
    }

    /// The steps from every node end at the skin, and follow the fibres if these are given.
    #[test]
    fn every_way_ends_at_the_skin() {
        let cells = brick();
        for (fibres, straight) in [(None, 0.0), (Some([0.0, 0.0, 2.0]), 0.9)] {
            let steps = juice_ways(&cells, fibres);
            let next: std::collections::BTreeMap<u32, u32> = steps.iter().map(|s| (s.0, s.1)).collect();
            let (mut upright, mut all) = (0.0, 0.0);
            for node in 0..cells.node_count() as u32 {
                let (mut at, mut count) = (node, 0);
                while let Some(&to) = next.get(&at) {
                    let way = sub(cells.positions[to as usize], cells.positions[at as usize]);
                    upright += way[2].abs();
                    all += dot(way, way).sqrt();
                    (at, count) = (to, count + 1);
                    assert!(count < 100, "goes in circles from {node}");
                }
                assert_eq!(cells.depth[at as usize], 0.0, "ends inside");
            }
            assert!(upright / all > straight, "{}", upright / all);
        }
    }
}
