//! Promise: bodies swept along any path have the volume, the surface and the conductance of the solid they represent,
//! have no negative weight, and obey the maximum principle.

use core::f64::consts::PI;

use saute_heat::{Conduction, Graph, Outline, Path, Rule, Section, Station, SweptMesh, graded_levels};

const ACROSS: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn disc(radius: f64, around: usize) -> Section {
    let rings = around / 4;
    let ring = |k: usize| (around, 1.0 - k as f64 / rings as f64);
    let rings: Vec<_> = (0..rings).map(ring).chain([(1, 0.0)]).collect();
    Section::concentric(&Outline::circle(radius), &rings).expect("meshes")
}

/// A cone of radii 12 mm and 4 mm over 40 mm.
fn cone(around: usize, levels: usize) -> SweptMesh {
    let section = disc(0.012, around);
    let station = |level: usize| {
        let share = level as f64 / (levels - 1) as f64;
        Station::scaled(&section, [0.0, 0.0, 0.04 * share], ACROSS, [1.0 - share * 2.0 / 3.0; 2]).expect("meshes")
    };
    let path = (0..levels).map(station).collect();
    SweptMesh::along(section, path, Rule::ShapeFunctions)
}

/// A quarter of a torus: a square of 10 mm on a bend of 20 mm.
fn bend(cells: usize, levels: usize, rule: Rule) -> SweptMesh {
    let spacing = 0.01 / cells as f64;
    let section = Section::mesh(&Outline::rectangle(0.01, 0.01), spacing, spacing).expect("meshes");
    let station = |level: usize| {
        let angle = 0.5 * PI * level as f64 / (levels - 1) as f64;
        let out = [angle.cos(), angle.sin(), 0.0];
        let up = [0.0, 0.0, -1.0];
        Station::scaled(&section, out.map(|v| 0.02 * v), [out, up], [1.0; 2]).expect("meshes")
    };
    let path = (0..levels).map(station).collect();
    SweptMesh::along(section, path, rule)
}

fn volume(mesh: &SweptMesh) -> f64 {
    mesh.graph.volume.iter().sum()
}

fn side(mesh: &SweptMesh) -> f64 {
    mesh.side_areas().iter().sum()
}

#[test]
fn a_truncated_cone_has_its_volume_and_its_side() {
    let exact = PI * 0.04 / 3.0 * (0.012 * 0.012 + 0.012 * 0.004 + 0.004 * 0.004);
    let slant = (0.008f64.powi(2) + 0.04f64.powi(2)).sqrt();
    let error = |around: usize| {
        let mesh = cone(around, 9);
        ((volume(&mesh) / exact - 1.0).abs(), (side(&mesh) / (PI * 0.016 * slant) - 1.0).abs())
    };
    let (coarse, fine) = (error(16), error(32));
    assert!(fine.0 < 0.01 && fine.1 < 0.005, "{fine:?}");
    // The remaining error is that of the polygon for the circle: it falls with the square of the number of corners.
    assert!((3.5..4.5).contains(&(coarse.0 / fine.0)), "{coarse:?} {fine:?}");
    let of_polygons = disc(0.012, 32).area() * 0.04 / 3.0 * (1.0 + 1.0 / 3.0 + 1.0 / 9.0);
    assert!((volume(&cone(32, 9)) / of_polygons - 1.0).abs() < 1e-9, "levels add no error");
}

#[test]
fn a_bend_has_its_volume_and_its_side() {
    let exact = 0.5 * PI * 0.02 * 1e-4;
    let error = |levels: usize| (volume(&bend(5, levels, Rule::ShapeFunctions)) / exact - 1.0).abs();
    assert!(error(13) < 2e-3 && (3.5..4.5).contains(&(error(7) / error(13))), "{} {}", error(7), error(13));
    let wall = 0.5 * PI * 0.02 * 0.04;
    assert!((side(&bend(5, 25, Rule::ShapeFunctions)) / wall - 1.0).abs() < 1e-3);
}

#[test]
fn weights_are_never_negative_under_both_rules() {
    let section = disc(0.012, 20);
    let squeezed = |level: usize| {
        let share = level as f64 / 8.0;
        Station::scaled(&section, [0.0, 0.0, 0.03 * share], ACROSS, [1.0, 1.0 - 0.85 * share]).expect("meshes")
    };
    let flat = SweptMesh::along(section.clone(), (0..9).map(squeezed).collect(), Rule::ShapeFunctions);
    for mesh in [cone(20, 9), bend(5, 9, Rule::ShapeFunctions), bend(5, 9, Rule::Segments), flat] {
        assert!(mesh.graph.shape.iter().all(|s| *s >= 0.0 && s.is_finite()));
        assert!(mesh.graph.volume.iter().all(|v| *v > 0.0));
    }
}

/// Heat flow between the two ends of a path, at a difference of 1 K, for k = 1, in the steady state [W].
fn flow_between_ends(mesh: &SweptMesh) -> f64 {
    let n = mesh.nodes_per_level();
    let last = mesh.levels.len() - 1;
    let mut t: Vec<f64> = (0..mesh.node_count()).map(|i| (i / n) as f64 / last as f64).collect();
    let inside = |node: usize| (1..last).contains(&(node / n));
    for _ in 0..40_000 {
        let (mut sum, mut weight) = (vec![0.0; t.len()], vec![0.0; t.len()]);
        for (&[a, b], &shape) in mesh.graph.ends.iter().zip(&mesh.graph.shape) {
            let (a, b) = (a as usize, b as usize);
            (sum[a], weight[a]) = (sum[a] + shape * t[b], weight[a] + shape);
            (sum[b], weight[b]) = (sum[b] + shape * t[a], weight[b] + shape);
        }
        let mut most = 0.0f64;
        for node in (0..t.len()).filter(|i| inside(*i)) {
            let next = sum[node] / weight[node];
            most = most.max((next - t[node]).abs());
            t[node] = next;
        }
        if most < 1e-10 {
            break;
        }
    }
    let across = |(&[a, b], &shape): (&[u32; 2], &f64)| {
        let (a, b) = (a as usize, b as usize);
        if a < n && b >= n { shape * (t[b] - t[a]) } else { 0.0 }
    };
    mesh.graph.ends.iter().zip(&mesh.graph.shape).map(across).sum()
}

/// A square bent about an axis: k h ln(r₂/r₁) / Θ.
#[test]
fn a_bend_conducts_between_its_ends_like_the_exact_solution() {
    let exact = 0.01 * (0.025f64 / 0.015).ln() / (0.5 * PI);
    let error = |cells: usize, levels: usize| {
        (flow_between_ends(&bend(cells, levels, Rule::ShapeFunctions)) / exact - 1.0).abs()
    };
    let (coarse, fine) = (error(3, 5), error(6, 9));
    assert!(fine < 5e-3 && coarse > 2.5 * fine, "{coarse} {fine}");
}

/// A slender cone between its ends: k π r₁ r₂ / L, within the 2 % by which isotherms deviate from planes.
#[test]
fn a_cone_conducts_between_its_ends_like_its_sections_in_series() {
    let section = disc(0.003, 16);
    let station = |level: usize| {
        let share = level as f64 / 12.0;
        Station::scaled(&section, [0.0, 0.0, 0.04 * share], ACROSS, [1.0 - 0.5 * share; 2]).expect("meshes")
    };
    let path = (0..13).map(station).collect();
    let mesh = SweptMesh::along(section, path, Rule::ShapeFunctions);
    let exact = PI * 0.003 * 0.0015 / 0.04;
    let flow = flow_between_ends(&mesh);
    assert!((flow / exact - 1.0).abs() < 0.03, "{flow} of {exact}");
}

/// A straight, unscaled path along stations gives the upright body.
#[test]
fn stations_on_a_straight_line_are_the_upright_body() {
    let section = disc(0.012, 20);
    let levels = graded_levels(0.03, 0.5e-3, 1.5, 3e-3);
    let at = |z: &f64| Station::scaled(&section, [0.0, 0.0, *z], ACROSS, [1.0; 2]).expect("meshes");
    let along = SweptMesh::along(section.clone(), levels.iter().map(at).collect(), Rule::ShapeFunctions);
    let upright = SweptMesh::new(section, levels);
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
    assert!(along.graph.volume.iter().zip(&upright.graph.volume).all(|(a, b)| close(*a, *b)));
    let total = |graph: &Graph| {
        let mut conduction = Conduction::default();
        conduction.refresh(graph, &vec![1.0; graph.volume.len()]);
        conduction.total
    };
    let pairs = total(&along.graph).into_iter().zip(total(&upright.graph));
    assert!(pairs.into_iter().all(|(a, b)| close(a, b)));
    let (a, b): (f64, f64) = (along.side_areas().iter().sum(), upright.side_areas().iter().sum());
    assert!(close(a, b));
}

/// Uneven columns conserve the mean height and the volume; without variation the body is the even one, bit for bit.
#[test]
fn uneven_columns_keep_the_volume() {
    let section = disc(0.03, 32);
    let levels = graded_levels(0.02, 0.5e-3, 1.5, 2e-3);
    let uneven = SweptMesh::uneven(section.clone(), levels.clone(), |p| 3.0 * p[0] + 0.02, Rule::ShapeFunctions);
    assert!((volume(&uneven) / (section.area() * 0.02) - 1.0).abs() < 1e-12);
    let Path::Uneven(columns) = &uneven.path else { panic!("uneven") };
    let mean: f64 = columns.iter().zip(&section.areas).map(|(c, a)| c * a).sum::<f64>() / section.area();
    assert!((mean - 1.0).abs() < 1e-12 && columns.iter().any(|c| *c > 1.05) && columns.iter().any(|c| *c < 0.95));
    let even = SweptMesh::uneven(section.clone(), levels.clone(), |_| 0.0, Rule::ShapeFunctions);
    let straight = SweptMesh::new(section, levels);
    assert_eq!(even.graph.volume, straight.graph.volume);
    assert_eq!(even.graph.shape, straight.graph.shape);
}

/// Explicit steps within the stability limit keep every node between its surroundings' temperatures.
#[test]
fn no_node_of_a_curved_tapered_body_leaves_the_range_of_the_data() {
    for mesh in [cone(20, 13), bend(5, 13, Rule::ShapeFunctions), bend(5, 13, Rule::Segments)] {
        let capacity: Vec<f64> = mesh.graph.volume.iter().map(|v| 3.7e6 * v).collect();
        let exchange: Vec<f64> = mesh.side_areas().iter().map(|a| 2000.0 * a).collect();
        let mut conduction = Conduction::default();
        conduction.refresh(&mesh.graph, &vec![0.5; capacity.len()]);
        let dt = 0.99 * conduction.stable_step_with(&capacity, &exchange);
        let mut t = vec![5.0; capacity.len()];
        let mut power = vec![0.0; t.len()];
        let mut taken = 0.0;
        for _ in 0..400 {
            power.iter_mut().zip(&exchange).zip(&t).for_each(|((p, e), t)| *p = e * (200.0 - t));
            taken += power.iter().sum::<f64>() * dt;
            conduction.add_power(&mesh.graph, &t, &mut power);
            t.iter_mut().zip(&power).zip(&capacity).for_each(|((t, p), c)| *t += p * dt / c);
            assert!(t.iter().all(|t| (5.0 - 1e-9..=200.0 + 1e-9).contains(t)));
        }
        let stored: f64 = t.iter().zip(&capacity).map(|(t, c)| (t - 5.0) * c).sum();
        assert!((taken / stored - 1.0).abs() < 1e-9);
    }
}
