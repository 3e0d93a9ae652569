//! The lab's bodies as grids: products of axes.

use saute_kitchen::heat::conduction::axis::Metric;
use saute_kitchen::heat::conduction::column::Between;
use saute_kitchen::heat::conduction::tensor::TensorBody;

use crate::vtk::{Array, CellKind, Cells, Grid, Numbers};

/// Returns a body at a time [s] with fields of its nodes, in the coordinates of its case: a box as hexahedra, a cylinder as
/// quadrilaterals over radius (x) and height (z), a slab and a sphere as lines (along z and x).
///
/// There is no cell between the two sides of a contact. The cells have the number of their body in a stack, from 0.
pub fn product(body: &TensorBody, of_points: Vec<Array>, time_s: f64) -> Grid {
    let mut grid = Grid { of_points, time_s, ..Grid::default() };
    grid.points = (0..body.node_count()).map(|node| point(body, node)).collect();
    let mut layers = Vec::new();
    for node in 0..body.node_count() {
        let inner = (0..body.axes.len()).all(|axis| body.place(node, axis) + 1 < body.axes[axis].nodes.len());
        if let Some(layer) = layer(body, node).filter(|_| inner) {
            push(&mut grid.cells, body, node);
            layers.push(layer);
        }
    }
    grid.of_cells.push(Array { name: "body".to_owned(), unit: "", components: 1, numbers: Numbers::Integers(layers) });
    grid.notes.push(("program", concat!("saute ", env!("CARGO_PKG_VERSION")).to_owned()));
    grid
}

/// A node in space [m].
fn point(body: &TensorBody, node: usize) -> [f64; 3] {
    let at = |axis: usize| body.axes[axis].nodes[body.place(node, axis)];
    match body.axes.len() {
        3 => [at(0), at(1), at(2)],
        2 => [at(0), 0.0, at(1)],
        _ if body.axes[0].metric == Metric::Straight => [0.0, 0.0, at(0)],
        _ => [at(0), 0.0, 0.0],
    }
}

/// The body between a node and the next above it; none across a contact or past the end.
fn layer(body: &TensorBody, node: usize) -> Option<i32> {
    let Some(vertical) = body.vertical else { return Some(0) };
    match body.column.between.get(body.place(node, vertical))? {
        Between::Layer(layer) => Some(*layer as i32),
        Between::Contact(_) => None,
    }
}

/// Adds the cell of which a node is the lowest corner.
fn push(cells: &mut Cells, body: &TensorBody, node: usize) {
    let mut stride = 1;
    let strides: Vec<usize> = body
        .axes
        .iter()
        .map(|axis| {
            let here = stride;
            stride *= axis.nodes.len();
            here
        })
        .collect();
    // Around each square in turn, as VTK orders the corners.
    let square = |first: usize, x: usize, y: usize| [first, first + x, first + x + y, first + y];
    match *strides.as_slice() {
        [x, y, z] => cells.push(CellKind::Hexahedron, [square(node, x, y), square(node + z, x, y)].concat()),
        [x, z] => cells.push(CellKind::Quad, square(node, x, z)),
        _ => cells.push(CellKind::Line, [node, node + 1]),
    }
}
