//! Pieces and the pan.

use saute_formats::fields::{Inside, pan, surface};
use saute_formats::vtk::Collection;
use saute_kitchen::Kitchen;
use saute_kitchen::dynamics::Pose;

use super::brick::frying;
use super::vtu::Vtu;

const STEAK: [f64; 3] = [0.08, 0.06, 0.02];

fn inside(kitchen: &Kitchen) -> Vtu {
    let piece = &kitchen.pieces()[0];
    let grid = Inside::of(&piece.model).grid(piece, &piece.pose, kitchen.time_s());
    let file = grid.vtu();
    assert_eq!(file, grid.vtu(), "the same grid gives the same bytes");
    Vtu::read(&file)
}

/// Every amount of the nodes comes back to the last bit, so that sums are the kitchen's.
fn holds_the_state(file: &Vtu, kitchen: &Kitchen, section: &str) {
    let piece = &kitchen.pieces()[0];
    let state = &piece.state;
    assert_eq!(file.reals("temperature_k"), state.temperature);
    let celsius = file.reals("temperature_c");
    assert!(celsius.iter().zip(&state.temperature).all(|(c, k)| (c + 273.15 - k).abs() < 1e-9));
    let sum = |name: &str| file.reals(name).iter().sum::<f64>();
    assert_eq!(sum("water_kg"), state.water.iter().sum::<f64>());
    assert_eq!(sum("enthalpy_j"), state.total_enthalpy());
    let mass = sum("water_kg") + sum("lean_solids_kg") + sum("fat_kg");
    assert!((mass / piece.mass() - 1.0).abs() < 1e-12, "{mass} kg");
    assert_eq!(file.reals("browning"), state.browning);
    for (name, share) in piece.model.kinetics().names().into_iter().zip(&state.changed) {
        assert_eq!(&file.reals(&format!("changed.{name}")), share);
    }
    let units = ["temperature_c", "temperature_k", "water_kg", "enthalpy_j", "volume_m3", "browning"];
    assert_eq!(units.map(|name| file.unit(name)), ["°C", "K", "kg", "J", "m³", ""]);
    assert_eq!(file.section("temperature_c"), section);
    let nodes = state.temperature.len();
    assert_eq!(file.flags("colour_srgb").len(), 3 * nodes);
    assert!((file.reals("TimeValue")[0] - kitchen.time_s()).abs() < 1e-12);
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Signed volume that polygons enclose, counter-clockwise seen from outside [m³].
fn enclosed(points: &[[f64; 3]], faces: &[Vec<usize>]) -> f64 {
    let at = |i: usize| [0, 1, 2].map(|k| points[i][k] - points[faces[0][0]][k]);
    let fan = |face: &Vec<usize>| {
        let tetra = |k: usize| {
            let (a, n) = (at(face[0]), cross(at(face[k - 1]), at(face[k])));
            (0..3).map(|k| a[k] * n[k]).sum::<f64>() / 6.0
        };
        (2..face.len()).map(tetra).sum::<f64>()
    };
    faces.iter().map(fan).sum()
}

#[test]
fn a_steak_is_wedges_that_fill_it_with_its_state_at_their_corners() {
    let kitchen = frying("beef-lean", STEAK, 30);
    let file = inside(&kitchen);
    holds_the_state(&file, &kitchen, "PointData");
    let [points, cells] = file.counts();
    assert_eq!(points, kitchen.pieces()[0].state.temperature.len());
    assert!(file.flags("types").iter().all(|kind| *kind == 13));
    let (corners, places) = (file.integers("connectivity"), file.points());
    assert_eq!(corners.len(), 6 * cells);
    assert_eq!(*file.integers("offsets").last().unwrap() as usize, corners.len());
    let volumes: Vec<f64> = corners
        .chunks(6)
        .map(|c| {
            let [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map(|k| c[k] as usize);
            // Faces of a wedge, each looking outwards.
            let faces = [vec![a, c, b], vec![d, e, f], vec![a, b, e, d], vec![b, c, f, e], vec![c, a, d, f]];
            enclosed(&places, &faces)
        })
        .collect();
    assert!(volumes.iter().all(|volume| *volume > 0.0), "no wedge is turned inside out");
    // Cooked for seconds only, it has hardly shrunk.
    let whole: f64 = volumes.iter().sum();
    let rest: f64 = file.reals("volume_m3").iter().sum();
    assert!((whole / rest - 1.0).abs() < 0.02, "{whole} m³ of {rest} m³");
}

#[test]
fn a_body_from_a_surface_is_polyhedra_each_with_the_state_of_its_node() {
    let kitchen = frying("brick", [0.06; 3], 20);
    let file = inside(&kitchen);
    holds_the_state(&file, &kitchen, "CellData");
    let [points, cells] = file.counts();
    assert_eq!(cells, kitchen.pieces()[0].state.temperature.len());
    assert!(file.flags("types").iter().all(|kind| *kind == 42));
    let (faces, ends, places) = (file.integers("faces"), file.integers("faceoffsets"), file.points());
    assert!(faces.iter().all(|i| (*i as usize) < points.max(faces.len())));
    let (mut from, mut whole) = (0, 0.0);
    for end in &ends {
        let (mut polygons, mut at) = (Vec::new(), from + 1);
        for _ in 0..faces[from] {
            let count = faces[at] as usize;
            polygons.push(faces[at + 1..=at + count].iter().map(|i| *i as usize).collect::<Vec<_>>());
            at += 1 + count;
        }
        assert_eq!(at, *end as usize);
        let volume = enclosed(&places, &polygons);
        assert!(volume > 0.0);
        whole += volume;
        from = at;
    }
    let rest: f64 = file.reals("volume_m3").iter().sum();
    assert!((whole / rest - 1.0).abs() < 0.06, "{whole} m³ of {rest} m³");
}

#[test]
fn a_surface_is_closed_and_tells_what_it_touches() {
    for (kind, size) in [("beef-lean", STEAK), ("brick", [0.06; 3])] {
        let kitchen = frying(kind, size, 20);
        let piece = &kitchen.pieces()[0];
        let file = Vtu::read(&surface::surface(piece, &piece.pose, kitchen.time_s()).vtu());
        let places = file.points();
        let triangles: Vec<Vec<usize>> =
            file.integers("connectivity").chunks(3).map(|t| t.iter().map(|i| *i as usize).collect()).collect();
        let volume: f64 = piece.model.mesh().volumes().iter().sum();
        let inside = enclosed(&places, &triangles);
        assert!((inside / volume - 1.0).abs() < 0.02, "{kind}: {inside} m³ of {volume} m³");
        let low = places.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
        assert!(low > -1e-3, "{kind} lies on the floor of the pan: {low} m");
        assert!(file.reals("normal").chunks(3).all(|n| (n.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-6));
        if kind == "beef-lean" {
            let (h, t) = (file.reals("contact_w_m2k"), file.reals("contact_temperature_c"));
            assert!(h.iter().zip(&t).any(|(h, t)| *h > 100.0 && *t > 150.0), "it touches the hot pan");
            assert!(h.iter().zip(&t).all(|(h, t)| (*h > 0.0) == t.is_finite()));
        }
    }
}

#[test]
fn the_pan_has_its_temperatures_and_what_lies_on_it() {
    let kitchen = frying("beef-lean", STEAK, 20);
    let file = Vtu::read(&pan::pan(&kitchen, &Pose::at(0.0, 0.0, 0.01)).vtu());
    assert_eq!(file.reals("temperature_k"), kitchen.pan_state().temperature);
    let oil: f64 = file.reals("oil_kg").iter().sum();
    assert!((oil - kitchen.pan_state().oil_mass()).abs() < 1e-12, "{oil} kg");
    let places = file.points();
    let shape = kitchen.world().pan_shape();
    let high = places.iter().map(|p| p[2]).fold(0.0, f64::max);
    assert!((high - 0.01 - shape.height).abs() < 0.01, "the wall rises to {high} m");
    assert!(file.reals("glass_c").iter().any(|t| t.is_nan()), "there is no glass under the wall");
}

#[test]
fn a_series_names_every_file_with_its_time() {
    let mut series = Collection::default();
    series.push(0.5, 1, "steak & <bacon>", "fields_0000_inside.steak.vtu");
    let text = series.pvd();
    assert!(text.contains("timestep=\"0.5\" group=\"\" part=\"1\" name=\"steak &amp; &lt;bacon&gt;\""), "{text}");
    assert!(text.contains("file=\"fields_0000_inside.steak.vtu\"/>"));
}
