//! The triangles of the nodes of a scene.

use crate::gltf_file::document::{Document, Node, Primitive, at};
use crate::gltf_file::elements::Elements;
use crate::gltf_file::placement::{Matrix, UNIT, determinant, of, placed, product};
use crate::read_error::DAMAGED;
use crate::{Body, ReadError, Soup, enough_room};

/// Largest nesting depth of nodes [-] (chosen: valid files have far less).
const DEEPEST: usize = 64;
/// Codes of the kinds of primitives, by the specification: points and lines, triangles, strips and fans of triangles.
const POINTS_AND_LINES: std::ops::RangeInclusive<u32> = 0..=3;
const TRIANGLES: u32 = 4;
const STRIPS_AND_FANS: std::ops::RangeInclusive<u32> = 5..=6;

/// Returns the triangles of each node of the default scene that has a mesh; those of a file without scenes are one body.
pub fn bodies(document: &Document, buffers: &[Vec<u8>]) -> Result<Vec<Body>, ReadError> {
    let elements = Elements::of(document, buffers);
    let visited = vec![false; document.nodes.len()];
    let mut reader = Reader { elements, bodies: Vec::new(), triangles: 0, vertices: 0, visited };
    if document.scenes.is_empty() {
        reader.bodies.push(Body::default());
        let mut primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
        primitives.try_for_each(|primitive| reader.primitive(primitive, UNIT))?;
    } else {
        let scene = at(&document.scenes, document.scene.unwrap_or(0), "scene")?;
        scene.nodes.iter().try_for_each(|node| reader.node(*node, UNIT, 0))?;
    }
    Ok(reader.bodies)
}

/// The triangles read so far.
struct Reader<'a> {
    elements: Elements<'a>,
    bodies: Vec<Body>,
    /// Number of all triangles and corners so far [-].
    triangles: usize,
    vertices: usize,
    /// True for the nodes read so far.
    visited: Vec<bool>,
}

impl Reader<'_> {
    /// Adds the meshes of a node and of its children, transformed by `outer`.
    ///
    /// The nodes of a valid file form trees. A node with two parents would multiply its children from level to level.
    fn node(&mut self, index: usize, outer: Matrix, depth: usize) -> Result<(), ReadError> {
        let document = self.elements.document;
        let node: &Node = at(&document.nodes, index, "node")?;
        let is_again = core::mem::replace(&mut self.visited[index], true);
        if is_again || depth > DEEPEST {
            let message = format!("its node {index} has two parents, or is nested too deeply");
            return Err(ReadError::new(message, DAMAGED));
        }
        let matrix = product(outer, of(node));
        if let Some(mesh) = node.mesh {
            let mesh = at(&document.meshes, mesh, "mesh")?;
            self.bodies.push(Body { name: node.name.clone(), soup: Soup::default() });
            mesh.primitives.iter().try_for_each(|primitive| self.primitive(primitive, matrix))?;
        }
        node.children.iter().try_for_each(|child| self.node(*child, matrix, depth + 1))
    }

    /// Adds the triangles of a primitive, transformed by `matrix`; skips points and lines.
    fn primitive(&mut self, primitive: &Primitive, matrix: Matrix) -> Result<(), ReadError> {
        match primitive.mode {
            TRIANGLES => self.add(primitive, matrix),
            mode if POINTS_AND_LINES.contains(&mode) => Ok(()),
            mode if STRIPS_AND_FANS.contains(&mode) => {
                Err(ReadError::new("contains strips or fans of triangles", "export it as plain triangles"))
            }
            mode => Err(ReadError::new(format!("has a primitive of mode {mode}, which glTF does not know"), DAMAGED)),
        }
    }

    /// Adds triangles; their number is judged by what the accessors claim, before they are read.
    fn add(&mut self, primitive: &Primitive, matrix: Matrix) -> Result<(), ReadError> {
        let Some(positions) = primitive.attributes.position else {
            return Err(ReadError::new("a mesh has no positions", DAMAGED));
        };
        let positions = self.elements.positions(positions)?;
        let indices = primitive.indices.map(|index| self.elements.indices(index)).transpose()?;
        let count = positions.count();
        let corners = indices.as_ref().map_or(count, |indices| indices.count());
        enough_room(self.triangles + corners / 3, self.vertices.saturating_add(count))?;
        let corners = match indices {
            Some(indices) => self.elements.read_indices(&indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(missing) = corners.iter().find(|corner| **corner as usize >= count) {
            return Err(ReadError::new(format!("a triangle refers to corner {missing} of {count}"), DAMAGED));
        }
        let positions = self.elements.read_positions(&positions)?;
        self.push(&positions, &corners, matrix);
        Ok(())
    }

    fn push(&mut self, positions: &[[f64; 3]], corners: &[u32], matrix: Matrix) {
        let Some(Body { soup, .. }) = self.bodies.last_mut() else { return };
        let first = soup.vertices.len() as u32;
        let is_mirrored = determinant(matrix) < 0.0;
        self.triangles += corners.len() / 3;
        self.vertices += positions.len();
        soup.vertices.extend(positions.iter().map(|p| placed(matrix, *p)));
        let triangles = corners.as_chunks::<3>().0.iter();
        let triangles = triangles.map(|&[a, b, c]| if is_mirrored { [a, c, b] } else { [a, b, c] });
        soup.triangles.extend(triangles.map(|triangle| triangle.map(|corner| first + corner)));
    }
}
