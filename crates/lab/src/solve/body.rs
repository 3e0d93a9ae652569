//! Product meshes of the shapes, and their named faces.

use saute_heat::conduction::axis::{Axis, End, Metric};
use saute_heat::conduction::column::{Between, Column};
use saute_heat::conduction::tensor::TensorBody;

use crate::case::{BodyCase, Case};
use crate::case::{Face, Shape};

/// Returns the names of the sizes of a shape, in order.
pub fn sizes(shape: Shape) -> &'static [&'static str] {
    match shape {
        Shape::Box => &["x", "y", "z"],
        Shape::Cylinder => &["diameter", "height"],
        Shape::Sphere => &["diameter"],
        Shape::Slab => &["thickness"],
    }
}

/// Returns the product mesh of a case.
pub fn mesh(case: &Case) -> TensorBody {
    let Some(first) = case.bodies.first() else {
        let plate = case.pan.map_or(0.0, |p| p.capacity);
        let column = Column { between: Vec::new(), plate };
        return TensorBody::stacked(vec![Axis::straight(vec![0.0])], Some(0), column);
    };
    let Some(vertical) = vertical(case.shape) else {
        return TensorBody::new(vec![radius(Metric::Spherical, first)]);
    };
    let mut axes = match case.shape {
        Shape::Box => vec![Axis::straight(levels(first, 0)), Axis::straight(levels(first, 1))],
        Shape::Cylinder => vec![radius(Metric::Cylindrical, first)],
        Shape::Sphere | Shape::Slab => Vec::new(),
    };
    let (axis, column) = stack(case, vertical);
    axes.push(axis);
    TensorBody::stacked(axes, Some(vertical), column)
}

/// Returns the vertical axis of a stack; the node of a pan with its own node comes first.
fn stack(case: &Case, vertical: usize) -> (Axis, Column) {
    let (mut nodes, mut column) = (vec![0.0], Column::default());
    column.plate = case.pan.map_or(0.0, |p| p.capacity);
    let mut base = 0.0;
    for (layer, body) in case.bodies.iter().enumerate() {
        if let Some(h) = body.contact {
            column.between.push(Between::Contact(h));
            nodes.push(base);
        }
        let levels = levels(body, vertical);
        column.between.extend(levels[1..].iter().map(|_| Between::Layer(layer)));
        nodes.extend(levels[1..].iter().map(|z| base + z));
        base += body.size[vertical];
    }
    (Axis::straight(nodes), column)
}

fn levels(body: &BodyCase, axis: usize) -> Vec<f64> {
    graded(body.size[axis], body.resolution[axis], body.grading)
}

fn radius(metric: Metric, body: &BodyCase) -> Axis {
    let across = levels(body, 0);
    let middle = across.len() / 2;
    Axis { metric, nodes: across[middle..].iter().map(|x| x - across[middle]).collect() }
}

/// Steepness below which a mesh is uniform [-] (chosen: the map then differs from the straight line by less than the
/// rounding error; at subnormal values tanh β ÷ β has no digits left, and nodes coincide).
const UNIFORM: f64 = 1e-6;

/// Returns the number of cells over a length: an even number, so that there is a node in the middle [-].
fn cells(length: f64, largest: f64, grading: f64) -> f64 {
    let stretch = if grading > UNIFORM { grading / libm::tanh(grading) } else { 1.0 };
    (2.0 * libm::ceil(0.5 * stretch * length / largest - 1e-9)).max(2.0)
}

/// Returns the nodes over a length, finer towards both ends, at most `largest` apart [m].
///
/// x = L/2 (1 + tanh(β (2ξ − 1)) / tanh β), with β the grading. One smooth map for all resolutions preserves the order of
/// convergence.
fn graded(length: f64, largest: f64, grading: f64) -> Vec<f64> {
    let cells = cells(length, largest, grading);
    let place = |i: f64| {
        let even = 2.0 * i / cells - 1.0;
        let bent = if grading > UNIFORM { libm::tanh(grading * even) / libm::tanh(grading) } else { even };
        0.5 * length * (1.0 + bent)
    };
    let mut nodes: Vec<f64> = (0..=cells as usize).map(|i| place(i as f64)).collect();
    let (middle, last) = (nodes.len() / 2, nodes.len() - 1);
    (nodes[0], nodes[middle], nodes[last]) = (0.0, 0.5 * length, length);
    nodes
}

/// Returns the number of nodes of the mesh of a stack, without building it [-].
pub fn node_count(shape: Shape, bodies: &[BodyCase]) -> f64 {
    let along = |body: &BodyCase, axis: usize| cells(body.size[axis], body.resolution[axis], body.grading) + 1.0;
    let Some(first) = bodies.first() else { return 1.0 };
    let across: f64 = match shape {
        Shape::Box => along(first, 0) * along(first, 1),
        Shape::Cylinder => 0.5 * along(first, 0),
        Shape::Sphere => return 0.5 * along(first, 0),
        Shape::Slab => 1.0,
    };
    across * bodies.iter().map(|b| along(b, b.size.len() - 1)).sum::<f64>()
}

/// Returns the ends of axes of a named face; `None` if the shape has no such face.
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

/// Returns the vertical axis, which a flip reverses; `None` for a sphere.
pub fn vertical(shape: Shape) -> Option<usize> {
    match shape {
        Shape::Box => Some(2),
        Shape::Cylinder => Some(1),
        Shape::Sphere => None,
        Shape::Slab => Some(0),
    }
}

/// Converts a point from the body's coordinates to its axes [m]; `None` outside the body.
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
        (Shape::Slab, [z] | [_, _, z]) => Some(vec![within(*z, 0.0, size[0])?]),
        _ => None,
    }
}
