//! Shapes of the lab as products of axes, with their faces by name.

use saute_heat::tensor::{Axis, End, Metric};

use crate::lab::case_file::{Face, Shape};

/// Steepness β of the grading x = L/2 (1 + tanh(β (2ξ − 1)) / tanh β) [-] (chosen: spacing at a face is 0.42 of the
/// largest; one smooth map for all resolutions keeps the order of convergence).
const STEEPNESS: f64 = 1.0;

/// Sizes a shape needs and what they are called.
pub fn sizes(shape: Shape) -> &'static [&'static str] {
    match shape {
        Shape::Box => &["x", "y", "z"],
        Shape::Cylinder => &["diameter", "height"],
        Shape::Sphere => &["diameter"],
        Shape::Slab => &["thickness"],
    }
}

/// Axes of a shape with spacing up to `resolution` [m].
pub fn axes(shape: Shape, size: &[f64], resolution: f64) -> Vec<Axis> {
    let levels = |length: f64| graded(length, resolution);
    let radius = |metric, diameter: f64| {
        let across = levels(diameter);
        let middle = across.len() / 2;
        Axis { metric, nodes: across[middle..].iter().map(|x| x - across[middle]).collect() }
    };
    match shape {
        Shape::Box => size.iter().map(|&s| Axis::straight(levels(s))).collect(),
        Shape::Cylinder => vec![radius(Metric::Cylindrical, size[0]), Axis::straight(levels(size[1]))],
        Shape::Sphere => vec![radius(Metric::Spherical, size[0])],
        Shape::Slab => vec![Axis::straight(levels(size[0]))],
    }
}

/// Nodes over a length, an even number of cells, finer towards both ends, at most `largest` apart [m].
fn graded(length: f64, largest: f64) -> Vec<f64> {
    let stretch = STEEPNESS / libm::tanh(STEEPNESS);
    let cells = (2.0 * libm::ceil(0.5 * stretch * length / largest - 1e-9)).max(2.0);
    let place = |i: f64| 0.5 * length * (1.0 + libm::tanh(STEEPNESS * (2.0 * i / cells - 1.0)) / libm::tanh(STEEPNESS));
    let mut nodes: Vec<f64> = (0..=cells as usize).map(|i| place(i as f64)).collect();
    let middle = nodes.len() / 2;
    let last = nodes.len() - 1;
    (nodes[0], nodes[middle], nodes[last]) = (0.0, 0.5 * length, length);
    nodes
}

/// Ends of axes that a face name means; none where the shape has no such face.
pub fn ends(shape: Shape, face: Face) -> Option<Vec<(usize, End)>> {
    let both = |axis: usize| vec![(axis, End::Low), (axis, End::High)];
    let bottom_and_top = |axis: usize| match face {
        Face::Bottom => Some(vec![(axis, End::Low)]),
        Face::Top => Some(vec![(axis, End::High)]),
        Face::Z => Some(both(axis)),
        _ => None,
    };
    match (shape, face) {
        (Shape::Box, Face::X) => Some(both(0)),
        (Shape::Box, Face::Y) => Some(both(1)),
        (Shape::Box, Face::Side) => Some([both(0), both(1)].concat()),
        (Shape::Box, Face::All) => Some([both(0), both(1), both(2)].concat()),
        (Shape::Box, _) => bottom_and_top(2),
        (Shape::Cylinder, Face::Side) => Some(vec![(0, End::High)]),
        (Shape::Cylinder, Face::All) => Some([vec![(0, End::High)], both(1)].concat()),
        (Shape::Cylinder, _) => bottom_and_top(1),
        (Shape::Sphere, Face::All | Face::Side) => Some(vec![(0, End::High)]),
        (Shape::Sphere, _) => None,
        (Shape::Slab, Face::All) => Some(both(0)),
        (Shape::Slab, _) => bottom_and_top(0),
    }
}

/// The vertical axis, along which a flip turns the body, if it has one.
pub fn vertical(shape: Shape) -> Option<usize> {
    match shape {
        Shape::Box => Some(2),
        Shape::Cylinder => Some(1),
        Shape::Sphere => None,
        Shape::Slab => Some(0),
    }
}

/// Where a point of the body's coordinates lies on its axes [m]; none outside the body.
pub fn on_axes(shape: Shape, size: &[f64], p: &[f64]) -> Option<Vec<f64>> {
    let within = |x: f64, low: f64, high: f64| (low - 1e-9..=high + 1e-9).contains(&x).then_some(x);
    match (shape, p) {
        (Shape::Box, [x, y, z]) => {
            Some(vec![within(*x, 0.0, size[0])?, within(*y, 0.0, size[1])?, within(*z, 0.0, size[2])?])
        }
        (Shape::Cylinder, [x, y, z]) => {
            Some(vec![within(libm::hypot(*x, *y), 0.0, 0.5 * size[0])?, within(*z, 0.0, size[1])?])
        }
        (Shape::Sphere, [x, y, z]) => Some(vec![within(libm::hypot(libm::hypot(*x, *y), *z), 0.0, 0.5 * size[0])?]),
        (Shape::Slab, [.., z]) => Some(vec![within(*z, 0.0, size[0])?]),
        _ => None,
    }
}

/// Nodes that a body would have.
pub fn node_count(axes: &[Axis]) -> usize {
    axes.iter().map(|a| a.nodes.len()).product()
}
