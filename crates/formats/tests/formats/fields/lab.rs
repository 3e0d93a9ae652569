//! Bodies of the lab.

use saute_formats::fields::product::product;
use saute_formats::vtk::Array;
use saute_kitchen::heat::conduction::axis::{Axis, Metric};
use saute_kitchen::heat::conduction::column::{Between, Column};
use saute_kitchen::heat::conduction::tensor::TensorBody;

use super::vtu::Vtu;

fn even(length: f64, cells: usize) -> Vec<f64> {
    (0..=cells).map(|i| length * i as f64 / cells as f64).collect()
}

fn file(body: &TensorBody) -> Vtu {
    let field = (0..body.node_count()).map(|n| n as f64).collect();
    Vtu::read(&product(body, vec![Array::reals("temperature_c", "°C", field)], 3.0).vtu())
}

#[test]
fn axes_become_hexahedra_quadrilaterals_and_lines() {
    let (x, y, z) = (even(0.03, 3), even(0.02, 2), even(0.01, 4));
    let radius = |metric| Axis { metric, nodes: even(0.02, 5) };
    let brick = TensorBody::new(vec![Axis::straight(x), Axis::straight(y), Axis::straight(z.clone())]);
    let can = TensorBody::new(vec![radius(Metric::Cylindrical), Axis::straight(z.clone())]);
    let ball = TensorBody::new(vec![radius(Metric::Spherical)]);
    let slab = TensorBody::new(vec![Axis::straight(z)]);
    for (body, kind, cells) in [(&brick, 12, 24), (&can, 9, 20), (&ball, 3, 5), (&slab, 3, 4)] {
        let file = file(body);
        assert_eq!(file.counts(), [body.node_count(), cells]);
        assert!(file.flags("types").iter().all(|k| *k == kind));
        assert_eq!(file.reals("temperature_c").len(), body.node_count());
        assert!(file.integers("connectivity").iter().all(|i| (*i as usize) < body.node_count()));
    }
    let places = file(&brick).points();
    let corners: Vec<_> = file(&brick).integers("connectivity")[..8].iter().map(|i| places[*i as usize]).collect();
    let [h, k, l] = [0.01, 0.01, 0.0025];
    let lower = [[0.0, 0.0, 0.0], [h, 0.0, 0.0], [h, k, 0.0], [0.0, k, 0.0]];
    let expected: Vec<[f64; 3]> = lower.into_iter().chain(lower.map(|[x, y, _]| [x, y, l])).collect();
    assert!(corners.iter().zip(&expected).all(|(p, q)| (0..3).all(|a| (p[a] - q[a]).abs() < 1e-12)), "{corners:?}");
    assert_eq!(file(&can).points()[7], [0.004, 0.0, 0.0025], "radius is x, height is z");
}

#[test]
fn across_a_contact_lies_no_cell() {
    let axis = Axis::straight(vec![0.0, 0.005, 0.005, 0.010]);
    let between = vec![Between::Layer(0), Between::Contact(400.0), Between::Layer(1)];
    let file = file(&TensorBody::stacked(vec![axis], Some(0), Column { between, plate: 0.0 }));
    assert_eq!(file.integers("connectivity"), [0, 1, 2, 3]);
    assert_eq!(file.integers("body"), [0, 1]);
}
