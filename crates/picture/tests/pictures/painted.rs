//! Promise: painted surfaces are closed, look outwards and have the colours of the core, whole or halved.

#![allow(clippy::unwrap_used)]

use glam::Vec3;
use saute_kitchen::food::Lab;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, kelvin};
use saute_picture::painted::{Painted, painted};

/// A kitchen in which a food has fried for some seconds.
fn fried(kind: &str, size: [f64; 3], seconds: u32) -> Kitchen {
    let library = Library::embedded().unwrap();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(220.0)).unwrap();
    let order = PieceOrder {
        id: "food".to_owned(),
        kind: kind.to_owned(),
        size,
        temperature: kelvin(15.0),
        seed: 1,
        coarseness: 2.0,
        rules: saute_kitchen::food::Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    };
    kitchen.add(&library, &order).unwrap();
    kitchen.apply(&Command::Hob(1500.0)).unwrap();
    kitchen.apply(&Command::Put { food: "food".to_owned(), at: [0.0; 2], heap: false }).unwrap();
    (0..10 * seconds).for_each(|_| kitchen.step());
    kitchen
}

/// Puts the food on the board and halves it.
fn halved(mut kitchen: Kitchen) -> Kitchen {
    kitchen.apply(&Command::Rest { food: "food".to_owned(), on: RestOn::Board }).unwrap();
    (0..100).for_each(|_| kitchen.step());
    kitchen.apply(&Command::Halve { food: "food".to_owned(), at: 0.0 }).unwrap();
    kitchen
}

fn corners<'a>(surface: &'a Painted, t: &'a [u32; 3]) -> [Vec3; 3] {
    t.map(|i| Vec3::from(surface.points[i as usize]))
}

/// Volume that a surface encloses [m³].
fn volume(surface: &Painted) -> f64 {
    let tetrahedron = |t: &[u32; 3]| {
        let [a, b, c] = corners(surface, t);
        f64::from(a.dot(b.cross(c))) / 6.0
    };
    surface.triangles.iter().map(tetrahedron).sum()
}

/// Share of the area whose normals look inwards [-].
fn against(surface: &Painted) -> f32 {
    let (mut wrong, mut all) = (0.0, 0.0);
    for t in &surface.triangles {
        let [a, b, c] = corners(surface, t);
        let doubled = (b - a).cross(c - a);
        let normal: Vec3 = t.iter().map(|i| Vec3::from(surface.normals[*i as usize])).sum();
        all += doubled.length();
        wrong += if normal.dot(doubled) < 0.0 { doubled.length() } else { 0.0 };
    }
    wrong / all
}

#[test]
fn every_kind_of_skin_encloses_its_food_and_looks_outwards() {
    let kinds = [
        ("beef-lean", [0.08, 0.06, 0.02]),
        ("shrimp", [0.09, 0.016, 0.016]),
        ("leek-ring", [0.03, 0.03, 0.012]),
        ("carrot-stick", [0.05, 0.01, 0.01]),
    ];
    for (kind, size) in kinds {
        let kitchen = fried(kind, size, 2);
        let [surface]: [Painted; 1] = painted(&kitchen).try_into().unwrap();
        let body: f64 = kitchen.pieces()[0].model.mesh().volumes().iter().sum();
        let found = volume(&surface);
        assert!((found / body - 1.0).abs() < 0.2, "{kind}: {found} m³ of {body} m³");
        assert!(against(&surface) < 0.02, "{kind}: {}", against(&surface));
        assert!(surface.normals.iter().all(|n| (Vec3::from(*n).length() - 1.0).abs() < 1e-4), "{kind}");
        let count = surface.points.len();
        assert!(count == surface.colours.len() && count == surface.normals.len() && count < 250_000);
        assert!(surface.colours.iter().flatten().all(|c| (0.0..=1.0).contains(c)));
    }
}

/// The lower face of lean beef, of which the core gives a mean colour: the mean of what is painted there is that.
#[test]
fn the_colour_of_a_browned_face_is_that_of_the_core() {
    let kitchen = fried("beef-lean", [0.08, 0.06, 0.02], 120);
    let piece = &kitchen.pieces()[0];
    let reading = piece.model.face_reading(&piece.state, piece.up());
    assert!(reading.browning > 0.3, "{}", reading.browning);
    let [surface]: [Painted; 1] = painted(&kitchen).try_into().unwrap();
    let (mut sum, mut whole) = ([0.0f64; 3], 0.0);
    for t in surface.triangles.iter().filter(|t| t.iter().all(|i| surface.normals[*i as usize][2] < -0.9)) {
        let [a, b, c] = corners(&surface, t);
        let area = f64::from((b - a).cross(c - a).length());
        for corner in t {
            (0..3).for_each(|k| sum[k] += area / 3.0 * f64::from(surface.colours[*corner as usize][k]));
        }
        whole += area;
    }
    // Both are means, one of light and one of L*a*b*: they differ a little where a face is mottled.
    let encoded = |v: f64| if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    let seen = Lab::from_srgb8(sum.map(|v| (255.0 * encoded(v / whole)).round() as u8));
    assert!(seen.difference(reading.lab) < 6.0, "{seen:?} and {:?}", reading.lab);
}

#[test]
fn a_halved_steak_is_two_closed_halves_with_their_cut_faces() {
    let whole = fried("beef-lean", [0.08, 0.06, 0.02], 5);
    let [before]: [Painted; 1] = painted(&whole).try_into().unwrap();
    let [first, second]: [Painted; 2] = painted(&halved(whole)).try_into().unwrap();
    assert_eq!((first.piece, second.piece), (0, 0));
    assert_ne!(first.pose, second.pose);
    let (parts, all) = ([volume(&first), volume(&second)], volume(&before));
    assert!((parts.iter().sum::<f64>() / all - 1.0).abs() < 0.03, "{parts:?} m³ of {all} m³");
    assert!(parts.iter().all(|part| (0.35..0.65).contains(&(part / all))), "{parts:?} m³ of {all} m³");
    assert!([&first, &second].into_iter().all(|half| against(half) < 0.02));
}
