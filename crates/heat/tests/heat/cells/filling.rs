//! Promise: cells fill the surface, conduct linear fields exactly inside, and have no negative conductance.

use std::time::Instant;

use glam::DVec3;
use saute_heat::{CellMesh, Fineness, Soup, Surface};

use super::bodies::{angle_piece, ball, brick, cylinder};

pub fn meshed(soup: &Soup, coarseness: f64) -> CellMesh {
    let surface = Surface::close(soup, 1e-3).unwrap().centred(1.0);
    let fineness = Fineness::of(&surface, coarseness);
    CellMesh::new(surface, fineness).unwrap()
}

fn all() -> [(&'static str, Soup); 6] {
    [
        ("steak", brick([0.0; 3], [60.0, 40.0, 20.0])),
        ("ball", ball(12.0, 4)),
        ("coin", cylinder(12.0, 6.0, 96)),
        ("angle", angle_piece(15.0, 20.0)),
        ("plate", brick([0.0; 3], [60.0, 40.0, 3.0])),
        ("small ball", ball(4.0, 3)),
    ]
}

#[test]
fn volumes_and_areas_sum_to_those_of_the_surface() {
    for (name, soup) in all() {
        let start = Instant::now();
        let mesh = meshed(&soup, 1.0);
        let took = start.elapsed().as_secs_f64();
        let volume: f64 = mesh.graph.volume.iter().sum();
        let area: f64 = mesh.patches.iter().map(|p| p.area).sum();
        let substeps = stable_step(&mesh);
        println!(
            "{name}: {} nodes, {} edges, {} patches, fit {:.4?}, skin {} triangles, stable {substeps:.3} s, {took:.2} s",
            mesh.node_count(),
            mesh.graph.ends.len(),
            mesh.patches.len(),
            mesh.fit,
            mesh.skin.triangles.len()
        );
        assert!((volume / mesh.surface.volume() - 1.0).abs() < 1e-9);
        assert!((area / mesh.surface.area() - 1.0).abs() < 1e-9);
        assert!(mesh.fit.iter().all(|f| (f - 1.0).abs() < 0.05), "{name}: {:?}", mesh.fit);
        assert!(mesh.graph.shape.iter().all(|s| *s > 0.0));
        assert!(mesh.graph.volume.iter().all(|v| *v > 0.0), "{name}");
    }
}

fn stable_step(mesh: &CellMesh) -> f64 {
    let mut total = vec![0.0; mesh.node_count()];
    for (&[a, b], s) in mesh.graph.ends.iter().zip(&mesh.graph.shape) {
        total[a as usize] += s;
        total[b as usize] += s;
    }
    mesh.graph.volume.iter().zip(&total).map(|(v, t)| v / (1.3e-7 * t)).fold(f64::INFINITY, f64::min)
}

/// The area vectors of a closed surface sum to zero. The planes next to a re-entrant edge fit less well.
#[test]
fn patches_close_the_body() {
    for (name, soup) in all() {
        let mesh = meshed(&soup, 1.0);
        let share = if name == "angle" { 0.03 } else { 0.01 };
        for axis in 0..3 {
            let net: f64 = mesh.patches.iter().map(|p| p.area * p.normal[axis]).sum();
            assert!(net.abs() < share * mesh.surface.area(), "{name}, axis {axis}: {net:e} m²");
        }
    }
}

/// A linear field has no divergence.
#[test]
fn a_linear_field_carries_no_net_flux_to_nodes_inside() {
    let mesh = meshed(&brick([0.0; 3], [60.0, 40.0, 20.0]), 1.0);
    for axis in 0..3 {
        let mut net = vec![0.0; mesh.node_count()];
        for (&[a, b], s) in mesh.graph.ends.iter().zip(&mesh.graph.shape) {
            let flux = s * (mesh.positions[a as usize][axis] - mesh.positions[b as usize][axis]);
            net[a as usize] += flux;
            net[b as usize] -= flux;
        }
        let face = mesh.fineness.spacing.powi(2);
        for (i, value) in net.iter().enumerate().filter(|(i, _)| mesh.depth[*i] > 0.0) {
            // Cells near an edge of the box may reach the surface, where heat enters at other nodes.
            let limit = if next_face(mesh.positions[i]) > mesh.fineness.spacing { 1e-5 } else { 0.03 };
            assert!(value.abs() < limit * face, "node {i} at {:?}: {value:e}", mesh.positions[i]);
        }
        let mut entering = vec![0.0; mesh.node_count()];
        mesh.patches.iter().for_each(|p| entering[p.node as usize] += p.area * p.normal[axis]);
        for (i, (out, into)) in net.iter().zip(&entering).enumerate().filter(|(i, _)| mesh.depth[*i] == 0.0) {
            assert!((out - into).abs() < 0.02 * face, "node {i} at {:?}: {out:e}, {into:e}", mesh.positions[i]);
        }
    }
}

/// Distance from the second nearest face of the box [m].
fn next_face(p: [f64; 3]) -> f64 {
    let mut to = [0.030 - p[0].abs(), 0.020 - p[1].abs(), 0.010 - p[2].abs()];
    to.sort_by(f64::total_cmp);
    to[1]
}

#[test]
fn linear_fields_are_interpolated_exactly_inside() {
    let mesh = meshed(&brick([0.0; 3], [60.0, 40.0, 20.0]), 1.0);
    let field = |p: [f64; 3]| 20.0 + 1000.0 * p[0] - 700.0 * p[1] + 300.0 * p[2];
    let values: Vec<f64> = mesh.positions.iter().map(|p| field(*p)).collect();
    for i in 0..300 {
        let turn = |k: f64| (f64::from(i) * k).fract() - 0.5;
        let p = [0.045 * turn(0.6180), 0.028 * turn(0.7549), 0.012 * turn(0.5698)];
        assert!((mesh.at(&values, p) - field(p)).abs() < 1e-6, "{p:?}");
        assert!(mesh.contains(p) && !mesh.contains([p[0], p[1], 0.011]) && !mesh.contains([-0.031, p[1], p[2]]));
    }
}

#[test]
fn every_vertex_of_the_skin_is_interpolated_from_nodes_near_it() {
    for (name, soup) in all() {
        let mesh = meshed(&soup, 1.0);
        let skin = &mesh.skin;
        for v in 0..skin.vertices.len() {
            let sum: f64 = skin.weights[v].iter().sum();
            assert!((sum - 1.0).abs() < 1e-9 && skin.weights[v].iter().all(|w| *w >= 0.0));
            for (node, w) in skin.nodes[v].iter().zip(skin.weights[v]).filter(|(_, w)| *w > 0.01) {
                let d = DVec3::from(skin.vertices[v]).distance(mesh.positions[*node as usize].into());
                assert!(d < 3.5 * mesh.fineness.spacing, "{name}: {w} of a node {} mm away", 1e3 * d);
            }
            assert!((DVec3::from(skin.normals[v]).length_squared() - 1.0).abs() < 1e-9);
        }
        let area: f64 = skin_area(&mesh);
        assert!((area / mesh.surface.area() - 1.0).abs() < 1e-9);
    }
}

fn skin_area(mesh: &CellMesh) -> f64 {
    let surface = Surface { vertices: mesh.skin.vertices.clone(), triangles: mesh.skin.triangles.clone() };
    surface.area()
}

#[test]
fn a_cut_through_a_ball_is_a_disc_and_interpolates_linear_fields_exactly() {
    let mesh = meshed(&ball(12.0, 4), 1.0);
    for (axis, at) in [(0, 0.0), (2, 0.005)] {
        let cut = mesh.slice(axis, at).unwrap();
        let area: f64 = cut.areas.iter().sum();
        let expected = std::f64::consts::PI * (0.012f64.powi(2) - at * at);
        assert!((area / expected - 1.0).abs() < 0.02, "{area} {expected}");
        for (i, p) in cut.points.iter().enumerate().filter(|(_, p)| DVec3::from(**p).length() < 0.008) {
            let read = cut.read(i, |node| mesh.positions[node][1]);
            assert!((read - p[1]).abs() < 1e-8, "{p:?} {read}");
        }
    }
    assert!(mesh.slice(0, 0.013).is_err());
}

#[test]
fn the_same_surface_gives_the_same_mesh_to_the_last_bit() {
    let [a, b] = [0, 1].map(|_| meshed(&ball(12.0, 4), 1.0));
    assert_eq!(a.positions, b.positions);
    assert_eq!(a.graph.shape, b.graph.shape);
}
