//! A plain body filled with food.

use std::ops::Range;

use saute_food::{Body, BuildError, Face, FoodModel, Patch, Rules};
use saute_heat::conduction::axis::End;
use saute_heat::conduction::tensor::TensorBody;
use saute_heat::{Outline, Section, SweptMesh};

use crate::case::Shape;
use crate::case::{Case, CookingCase};
use crate::solve::body::{mesh, vertical};

/// A body filled with food.
pub struct FoodBody {
    /// The product mesh, for probes.
    pub tensor: TensorBody,
    /// The food model on that mesh.
    pub model: FoodModel,
    /// Patches of each end of each axis.
    pub ends: Vec<EndPatches>,
}

/// An axis, one of its ends, and the range of the patches on it.
pub type EndPatches = (usize, End, Range<usize>);

impl FoodBody {
    /// Builds the food model of a case.
    pub fn new(case: &Case, cooking: &CookingCase) -> Result<Self, BuildError> {
        let tensor = mesh(case);
        let (patches, ends) = patches(&tensor, vertical(case.shape));
        let body = Body {
            size: extent(case),
            outline: outline(case),
            mesh: swept(&tensor, case, &patches).into(),
            patches,
            contracts: case.shape != Shape::Sphere,
            natural: false,
            pool: None,
            waves: None,
        };
        let CookingCase { food, kinetics, components, .. } = cooking;
        let model = FoodModel::fill_body(food, kinetics, components, body, 1, Rules::Full)?;
        Ok(Self { tensor, model, ends })
    }
}

/// Returns the patches of every end of every axis, node by node, bottom and top first. Each end has its own air.
fn patches(tensor: &TensorBody, vertical: Option<usize>) -> (Vec<Patch>, Vec<EndPatches>) {
    let all = match vertical {
        Some(axis) => {
            let across = (0..tensor.axes.len()).filter(|a| *a != axis);
            let sides = across.flat_map(|a| [(a, End::Low, Face::Side), (a, End::High, Face::Side)]);
            [(axis, End::Low, Face::Bottom), (axis, End::High, Face::Top)].into_iter().chain(sides).collect()
        }
        // The surface of a sphere is the end of its only axis, along which the fibres run.
        None => vec![(0, End::High, Face::Top)],
    };
    let (mut patches, mut ends) = (Vec::new(), Vec::new());
    for (air, (axis, end, face)) in all.into_iter().enumerate() {
        let first = patches.len();
        let nodes = tensor.face(axis, end).into_iter();
        patches.extend(nodes.map(|(node, area)| Patch { node: node as u32, face, air, area }));
        ends.push((axis, end, first..patches.len()));
    }
    (patches, ends)
}

/// Returns the product mesh as a section swept along its vertical axis, or along the radius of a sphere.
fn swept(tensor: &TensorBody, case: &Case, patches: &[Patch]) -> SweptMesh {
    let levels = tensor.axes[vertical(case.shape).unwrap_or(0)].nodes.clone();
    let n = tensor.node_count() / levels.len();
    let across = |axis: usize, index: usize| {
        let nodes = &tensor.axes[axis].nodes;
        nodes[index] - if case.shape == Shape::Box { 0.5 * nodes[nodes.len() - 1] } else { 0.0 }
    };
    let point = |i: usize| match case.shape {
        Shape::Box => [across(0, i % tensor.axes[0].nodes.len()), across(1, i / tensor.axes[0].nodes.len())],
        Shape::Cylinder => [across(0, i), 0.0],
        Shape::Slab | Shape::Sphere => [0.0, 0.0],
    };
    let section = Section {
        points: (0..n).map(point).collect(),
        areas: patches[..n].iter().map(|p| p.area).collect(),
        triangles: Vec::new(),
        edges: Vec::new(),
        boundary: Vec::new(),
        clamped_edges: 0,
    };
    SweptMesh::with_graph(section, levels, tensor.layered_graph(case.rule).graph)
}

/// Returns length, width and thickness [m]; a slab has an area of one square metre.
fn extent(case: &Case) -> [f64; 3] {
    match (case.shape, case.bodies[0].size.as_slice()) {
        (Shape::Box, &[x, y, z]) => [x, y, z],
        (Shape::Cylinder, &[diameter, height]) => [diameter, diameter, height],
        (Shape::Sphere, &[diameter]) => [diameter; 3],
        (_, size) => [1.0, 1.0, size[0]],
    }
}

fn outline(case: &Case) -> Outline {
    let [length, width, _] = extent(case);
    if case.shape == Shape::Box { Outline::rectangle(length, width) } else { Outline::circle(0.5 * length) }
}
