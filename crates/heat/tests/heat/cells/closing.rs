//! Promise: what is wrong with a surface is reported with its number, place and remedy, and no defective surface is meshed.

use saute_heat::{Defect, Soup, Surface};

use super::bodies::{ball, brick, loose, prism, soup};

const MM: f64 = 1e-3;

fn close(soup: &Soup) -> Result<Surface, Defect> {
    Surface::close(soup, MM)
}

fn cube() -> Soup {
    brick([0.0; 3], [20.0; 3])
}

fn joined(parts: &[Soup]) -> Soup {
    soup(&parts.iter().flat_map(loose).collect::<Vec<_>>())
}

#[test]
fn loose_corners_are_joined_and_measured() {
    let surface = close(&cube()).unwrap();
    assert_eq!((surface.vertices.len(), surface.triangles.len()), (8, 12));
    assert!((surface.volume() / 8e-6 - 1.0).abs() < 1e-12 && (surface.area() / 24e-4 - 1.0).abs() < 1e-12);
    for (c, expected) in surface.centroid().iter().zip([0.01; 3]) {
        assert!((c - expected).abs() < 1e-12);
    }
    assert_eq!(close(&ball(10.0, 3)).unwrap().vertices.len(), 642);
}

#[test]
fn a_body_inside_out_is_inverted() {
    let mut inverted = cube();
    inverted.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    assert!(close(&inverted).unwrap().volume() > 0.0);
}

#[test]
fn a_hole_is_reported_with_its_edges() {
    let mut open = cube();
    open.triangles.remove(3);
    let defect = close(&open).unwrap_err();
    assert!(matches!(defect, Defect::Open(t) if t.count == 3), "{defect}");
    assert!(defect.to_string().contains("not closed: edges with one triangle alone: 3, the first at ("), "{defect}");
    assert!(defect.remedy().contains("fill the holes"));
}

#[test]
fn an_inverted_triangle_is_reported() {
    let mut turned = cube();
    turned.triangles[5].swap(0, 1);
    assert!(matches!(close(&turned), Err(Defect::Orientation(t)) if t.count == 3));
}

#[test]
fn bodies_that_share_an_edge_or_a_corner_are_reported() {
    let edge = joined(&[cube(), brick([20.0, 20.0, 0.0], [20.0; 3])]);
    assert!(matches!(close(&edge), Err(Defect::NonManifold(t)) if t.count == 1), "{:?}", close(&edge));
    let corner = joined(&[cube(), brick([20.0, 20.0, 20.0], [20.0; 3])]);
    assert!(matches!(close(&corner), Err(Defect::Bodies(t)) if t.count == 2), "{:?}", close(&corner));
}

#[test]
fn separate_bodies_and_hollows_are_reported() {
    let apart = joined(&[cube(), brick([50.0, 0.0, 0.0], [10.0; 3])]);
    assert!(matches!(close(&apart), Err(Defect::Bodies(t)) if t.count == 2));
    let mut hollow = brick([5.0; 3], [5.0; 3]);
    hollow.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    assert!(matches!(close(&joined(&[cube(), hollow])), Err(Defect::Bodies(_))));
}

#[test]
fn triangles_without_area_are_reported() {
    let mut sliver = loose(&cube());
    // The first triangle's first edge gets a corner in its middle that leaves a triangle without height.
    let [a, b, c] = sliver[0];
    let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
    sliver[0] = [a, b, middle];
    sliver.extend([[a, middle, c], [middle, b, c]]);
    assert!(matches!(close(&soup(&sliver)), Err(Defect::Degenerate(t)) if t.count == 1));
}

#[test]
fn sizes_out_of_range_are_reported_with_the_remedy() {
    let thin = close(&brick([0.0; 3], [20.0, 20.0, 1.0])).unwrap_err();
    assert!(matches!(thin, Defect::TooSmall(_)) && thin.remedy().contains("scale_mm"), "{thin}");
    let metres = Surface::close(&cube(), 1.0).unwrap_err();
    assert!(metres.to_string().contains("20000 mm long"), "{metres}");
}

#[test]
fn a_body_that_crosses_itself_is_reported() {
    // A long prism bent back through itself: its top is pushed down through its bottom.
    let square = [[-10.0, -10.0], [10.0, -10.0], [10.0, 10.0], [-10.0, 10.0]];
    let mut pushed = prism(&square, 20.0);
    pushed.vertices.iter_mut().filter(|p| p[0] == 0.0 && p[2] == 20.0).for_each(|p| p[2] = -7.0);
    let defect = close(&pushed).unwrap_err();
    assert!(matches!(defect, Defect::Crossing(t) if t.count >= 4), "{defect}");
    let mut sound = prism(&square, 20.0);
    sound.vertices.iter_mut().filter(|p| p[0] == 0.0 && p[2] == 20.0).for_each(|p| p[2] = 7.0);
    assert!(close(&sound).is_ok(), "a dent that ends inside crosses nothing");
}

#[test]
fn a_small_fold_is_smoothed_and_a_large_one_is_reported() {
    let plain = ball(10.0, 5);
    let usual = close(&plain).unwrap();
    // Two corners change places.
    let exchanged = |at_least_mm: f64| {
        let far = |p: &[f64; 3]| p.iter().zip(plain.vertices[0]).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let others = plain.vertices.iter().filter(|p| far(p) >= at_least_mm);
        let (one, other) = (plain.vertices[0], *others.min_by(|p, q| far(p).total_cmp(&far(q))).unwrap());
        let mut soup = plain.clone();
        soup.vertices.iter_mut().for_each(|p| {
            *p = if *p == one {
                other
            } else if *p == other {
                one
            } else {
                *p
            }
        });
        soup
    };
    let surface = close(&exchanged(0.1)).unwrap();
    assert_eq!(surface.triangles.len(), usual.triangles.len());
    assert!((surface.volume() / usual.volume() - 1.0).abs() < 1e-3);
    let moved = surface.vertices.iter().filter(|p| !usual.vertices.contains(p)).count();
    assert!((1..100).contains(&moved), "{moved} corners of {}", usual.vertices.len());
    assert!(matches!(close(&exchanged(3.0)), Err(Defect::Crossing(_))), "{:?}", close(&exchanged(3.0)));
}

#[test]
fn folded_faces_that_lie_on_each_other_are_reported() {
    // A flat fold: the top's middle pulled sideways in the top's plane beyond an edge.
    let square = [[-10.0, -10.0], [10.0, -10.0], [10.0, 10.0], [-10.0, 10.0]];
    let mut folded = prism(&square, 20.0);
    folded.vertices.iter_mut().filter(|p| p[0] == 0.0 && p[2] == 20.0).for_each(|p| p[0] = 14.0);
    assert!(matches!(close(&folded), Err(Defect::Crossing(_))), "{:?}", close(&folded));
}

#[test]
fn input_that_is_no_surface_is_reported() {
    assert_eq!(close(&Soup::default()), Err(Defect::Empty));
    let mut broken = cube();
    broken.vertices[4][1] = f64::NAN;
    assert_eq!(close(&broken), Err(Defect::NotFinite(1)));
    broken = cube();
    broken.triangles[0][0] = 99;
    assert_eq!(close(&broken), Err(Defect::NoSuchVertex(99)));
}

/// A double cone: `n` triangles around each of its two tips.
fn double_cone(n: u32) -> Soup {
    let at = |i: u32| f64::from(i) / f64::from(n) * std::f64::consts::TAU;
    let rim = (0..n).map(|i| [20.0 * at(i).cos(), 20.0 * at(i).sin(), 0.0]);
    let vertices: Vec<[f64; 3]> = [[0.0, 0.0, 9.0], [0.0, 0.0, -9.0]].into_iter().chain(rim).collect();
    let sides = (0..n).flat_map(|i| {
        let (a, b) = (2 + i, 2 + (i + 1) % n);
        [[0, a, b], [1, b, a]]
    });
    Soup { vertices, triangles: sides.collect(), unit_mm: 1.0 }
}

/// The look for crossings counts the pairs that it has to try and gives up, instead of trying billions of them.
#[test]
fn a_fan_of_fifty_thousand_triangles_is_refused_and_one_of_a_thousand_is_sound() {
    let defect = close(&double_cone(50_000)).unwrap_err();
    assert!(matches!(defect, Defect::Dense(_)) && defect.remedy().contains("even size"), "{defect}");
    assert_eq!(close(&double_cone(1000)).unwrap().triangles.len(), 2000);
    assert!(close(&ball(20.0, 6)).is_ok(), "a fine sound body");
}
