//! What was poured, as it is seen: raw white lets the pan show through, and a veil of white that has set lies over the yolk.

use std::collections::BTreeMap;

use glam::Vec3;
use saute_kitchen::food::{FoodModel, FoodState};

use crate::skin::fine::{Fine, normals};

/// Share of the light from below that raw white lets through [-], and the colour of a dark pan below, L*, a*, b* over 100 (chosen).
const CLEAR: f32 = 0.66;
const PAN: [f32; 3] = [0.30, 0.002, 0.012];
/// Share of the yolk's colour that a set veil covers [-] (chosen: it turns pink and pale under a lid).
const VEIL: f32 = 0.42;
/// Distances from the middle of the yolk over its radius between which its edge lies [-] (chosen).
const BESIDE: [f64; 2] = [0.85, 1.15];
/// Distance from the skin of the yolk over which its colour fades [m] (chosen: the veil is a third of a millimetre thick).
const FADES: f64 = 0.5e-3;

/// Share of the yolk's colour at a point of the rest mesh's frame [-]; none of food that is not poured.
pub(crate) fn yolk_seen(model: &FoodModel, p: [f64; 3]) -> Option<f64> {
    let depth = model.pool()?.dome.depth(p);
    Some(((depth + 2.0 * FADES) / FADES).clamp(0.0, 1.0))
}

/// Colour of the white at a node as it is seen from above, L*, a*, b* over 100, given its own.
pub(crate) fn seen(model: &FoodModel, state: &FoodState, node: usize, own: [f32; 3]) -> [f32; 3] {
    let (Some(pool), Some(mesh)) = (model.pool(), model.mesh().swept()) else { return own };
    let [x, y, _] = mesh.position(node);
    let sets = model.description().pour.as_ref().and_then(|pour| model.changed(state, &pour.sets_by));
    let cloudy = sets.map_or(1.0, |sets| sets[node]) as f32;
    let away = (x - pool.dome.at[0]).hypot(y - pool.dome.at[1]) / pool.dome.radius;
    let beside = ((away - BESIDE[0]) / (BESIDE[1] - BESIDE[0])).clamp(0.0, 1.0) as f32;
    let above = node >= (mesh.levels.len() - 1) * mesh.nodes_per_level();
    let veil = if above { VEIL * cloudy * (1.0 - beside) } else { 0.0 };
    let (clear, second) = (CLEAR * (1.0 - cloudy) * beside, model.palette().second_tissue());
    std::array::from_fn(|k| own[k] + clear * (PAN[k] - own[k]) - veil * 0.01 * second[k] as f32)
}

/// The surface of a poured piece, twice as fine as its nodes, with the round of its yolk; none of other food.
///
/// The vertices of the lower face come first, then those of the upper one in the same order.
pub(crate) fn fine(model: &FoodModel) -> Option<Fine> {
    let (pool, mesh) = (model.pool()?, model.mesh().swept()?);
    let section = &mesh.section;
    let mut columns: Vec<[u32; 2]> = (0..section.points.len() as u32).map(|i| [i, i]).collect();
    let mut middles = BTreeMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            columns.push([a, b]);
            columns.len() as u32 - 1
        })
    };
    let parts = |[a, b, c]: [u32; 3], [ab, bc, ca]: [u32; 3]| [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
    let split = |t: &[u32; 3]| parts(*t, [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])].map(|(a, b)| middle(a, b)));
    let face: Vec<[u32; 3]> = section.triangles.iter().flat_map(split).collect();
    let rim: Vec<[u32; 2]> = section
        .boundary
        .iter()
        .flat_map(|&[a, b]| {
            let ab = middles[&[a.min(b), a.max(b)]];
            [[a, ab], [ab, b]]
        })
        .collect();
    let (count, last) = (columns.len() as u32, mesh.levels.len() - 1);
    let scale = mesh.thickness() * mesh.path.column(0) / pool.height_at(section.points[0]);
    let half = 0.5 * mesh.thickness();
    let mut fine = Fine::default();
    for (level, above) in [(0, false), (last, true)] {
        for &[a, b] in &columns {
            let [p, q] = [a, b].map(|i| section.points[i as usize]);
            let at = [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
            let height = if above { scale * pool.height_at(at) } else { 0.0 };
            fine.positions.push(Vec3::new(at[0] as f32, at[1] as f32, (height - half) as f32));
            let [a, b] = [a, b].map(|i| (mesh.node(level, i as usize) as u32, 0.5));
            fine.reads.push([a, b, (a.0, 0.0), (b.0, 0.0)]);
        }
    }
    fine.triangles.extend(face.iter().map(|&[a, b, c]| [a, c, b]));
    fine.triangles.extend(face.iter().map(|t| t.map(|i| i + count)));
    fine.triangles.extend(rim.iter().flat_map(|&[a, b]| [[a, b, b + count], [a, b + count, a + count]]));
    fine.normals = normals(&fine.positions, &fine.triangles);
    Some(fine)
}

/// Normals of a poured piece that has sunk onto its upper face, which is flat then; its lower face bulges instead.
pub(crate) fn draped(normals: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let (below, above) = normals.split_at(normals.len() / 2);
    let bulged = above.iter().map(|[x, y, z]| [*x, *y, -z]);
    bulged.chain(below.iter().map(|[x, y, z]| [*x, *y, -z])).collect()
}
