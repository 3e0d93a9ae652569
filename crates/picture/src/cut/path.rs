//! The cut across the path of a body that is carried along stations: a shrimp, a carrot stick.

use glam::Vec3;
use saute_kitchen::Piece;
use saute_kitchen::heat::Layout;
use saute_scene::input::SliceLook;

use crate::colour::map::ColourMap;
use crate::cut::face::CutFace;
use crate::skin::surface::PresentShape;
use crate::view::View;

/// The cut at a distance from the middle of the path [m], its hidden side towards the path's end.
pub(crate) fn path_cut(piece: &Piece, at: f64, view: View, map: Option<&ColourMap>) -> Option<SliceLook> {
    let (model, state) = (&*piece.model, &piece.state);
    let Layout::Along(mesh, stations) = model.mesh().layout() else { return None };
    let (level, share) = mesh.bracket(at + 0.5 * mesh.thickness());
    let n = mesh.nodes_per_level();
    let place = |node: usize| Vec3::from_array(model.rest_position(node).map(|v| v as f32));
    let ends = |i: usize| [level * n + i, (level + 1) * n + i];
    let sides: Vec<[Vec3; 2]> = (0..n).map(|i| ends(i).map(place)).collect();
    let point = sides.iter().map(|[a, b]| a.lerp(*b, share as f32)).sum::<Vec3>() / n as f32;
    let normal = sides.iter().map(|[a, b]| *b - *a).sum::<Vec3>().try_normalize()?;
    // Stations of a bent path are not parallel: the plane meets each fibre at a different place.
    let meets = |[a, b]: [Vec3; 2]| {
        let way = (b - a).dot(normal);
        if way > 0.0 { (point - a).dot(normal) / way } else { share as f32 }
    };
    let points: Vec<Vec3> = sides.iter().map(|&[a, b]| a.lerp(b, meets([a, b]))).collect();
    let face = CutFace { model, mesh, state, view, map, normal, shape: PresentShape::new(model, state) };
    let seen = |i: usize| face.vertex(ends(i), share, points[i]);
    let facing = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        if (b - a).cross(c - a).dot(normal) < 0.0 { [t[0], t[2], t[1]] } else { *t }
    };
    Some(SliceLook {
        point,
        normal,
        vertices: (0..n).map(seen).collect(),
        triangles: stations[level].section.triangles.iter().map(facing).collect(),
        ghost: false,
    })
}

#[cfg(test)]
mod tests {
    use saute_kitchen::food::Rules;
    use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, kelvin};

    use super::*;
    use crate::stage::{Stage, StageOptions};

    fn halved(kind: &str, size: [f64; 3]) -> Kitchen {
        let library = Library::embedded().expect("data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("pan");
        let order = PieceOrder {
            id: "piece".into(),
            kind: kind.into(),
            size,
            temperature: kelvin(20.0),
            seed: 1,
            coarseness: 1.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &order).expect("food");
        let food = || "piece".to_owned();
        for command in [
            Command::Put { food: food(), at: [0.0, 0.0], heap: false },
            Command::Rest { food: food(), on: RestOn::Board },
        ] {
            kitchen.apply(&command).expect("accepted");
            (0..80).for_each(|_| kitchen.step());
        }
        kitchen.apply(&Command::Halve { food: food(), at: 0.0 }).expect("accepted");
        kitchen
    }

    /// Two looks, each with the cut face that belongs to it, as large as the section there, in the plane that parts
    /// them.
    #[test]
    fn a_halved_curved_body_is_drawn_as_two_halves_with_their_cut_faces() {
        for (kind, size) in [("shrimp", [0.075, 0.018, 0.016]), ("carrot-stick", [0.060, 0.012, 0.012])] {
            let kitchen = halved(kind, size);
            let scene = Stage::default().scene(&kitchen, &StageOptions::default(), &Default::default());
            assert_eq!(scene.foods.len(), 2, "{kind}");
            let [near, far] = [0, 1].map(|k| scene.foods[k].slice.clone().expect("a cut face"));
            assert!((near.normal + far.normal).length() < 1e-6 && !near.ghost && !far.ghost);
            for cut in [&near, &far] {
                let place = |i: u32| Vec3::from(cut.vertices[i as usize].rest);
                let twice = |t: &[u32; 3]| (place(t[1]) - place(t[0])).cross(place(t[2]) - place(t[0])).dot(cut.normal);
                assert!(cut.triangles.iter().all(|t| twice(t) > 0.0), "{kind}");
                let area = 0.5 * cut.triangles.iter().map(twice).sum::<f32>();
                let box_area = (size[1] * size[2]) as f32;
                assert!((0.4..1.15).contains(&(area / box_area)), "{kind} {}", area / box_area);
                assert!(cut.vertices.iter().all(|v| (Vec3::from(v.rest) - cut.point).dot(cut.normal).abs() < 1e-6));
            }
        }
    }
}
