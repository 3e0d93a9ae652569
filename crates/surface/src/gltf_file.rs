//! glTF 2.0 files.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::accessor::Accessor;
use gltf::buffer::Source;
use gltf::mesh::Mode;
use gltf::{Gltf, Node, Primitive, Semantic};

use crate::{DAMAGED, ReadError, Soup};

/// A transformation in columns, as glTF writes them.
type Matrix = [[f32; 4]; 4];

const UNIT: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Nodes within nodes are followed to this depth (chosen: a sound file has far less; a damaged one may go in circles).
const DEEPEST: usize = 64;

/// Reads the triangles of a file's scene, turned so that z points up.
pub fn read(bytes: &[u8], beside: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Soup, ReadError> {
    let Gltf { document, blob } =
        Gltf::from_slice(bytes).map_err(|e| ReadError::new(format!("is no sound glTF file: {e}"), DAMAGED))?;
    let buffers = buffers(&document, blob, beside)?;
    let mut reader = Reader { buffers, soup: Soup::default() };
    let scene = document.default_scene().or_else(|| document.scenes().next());
    match scene {
        Some(scene) => scene.nodes().try_for_each(|n| reader.node(&n, UNIT, 0))?,
        None => document.meshes().flat_map(|m| m.primitives()).try_for_each(|p| reader.primitive(&p, UNIT))?,
    }
    Ok(reader.soup)
}

fn buffers(
    document: &gltf::Document,
    mut blob: Option<Vec<u8>>,
    beside: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Vec<u8>>, ReadError> {
    let bytes = |buffer: gltf::Buffer| {
        let bytes = match buffer.source() {
            Source::Bin => blob.take(),
            Source::Uri(uri) if uri.starts_with("data:") => {
                uri.split_once(";base64,").and_then(|(_, data)| STANDARD.decode(data).ok())
            }
            Source::Uri(uri) => {
                let missing = format!("needs \"{uri}\" beside it, which cannot be read");
                Some(beside(uri).ok_or_else(|| {
                    ReadError::new(missing, "put that file beside it, or export everything into one .glb file")
                })?)
            }
        };
        bytes.filter(|b| b.len() >= buffer.length()).ok_or_else(|| {
            let message = format!("its buffer {} has fewer than {} bytes", buffer.index(), buffer.length());
            ReadError::new(message, DAMAGED)
        })
    };
    document.buffers().map(bytes).collect()
}

struct Reader {
    buffers: Vec<Vec<u8>>,
    soup: Soup,
}

impl Reader {
    fn node(&mut self, node: &Node, outer: Matrix, depth: usize) -> Result<(), ReadError> {
        if depth > DEEPEST {
            return Err(ReadError::new("its nodes hold each other", DAMAGED));
        }
        let matrix = product(outer, node.transform().matrix());
        if let Some(mesh) = node.mesh() {
            mesh.primitives().try_for_each(|p| self.primitive(&p, matrix))?;
        }
        node.children().try_for_each(|child| self.node(&child, matrix, depth + 1))
    }

    fn primitive(&mut self, primitive: &Primitive, matrix: Matrix) -> Result<(), ReadError> {
        if primitive.mode() != Mode::Triangles {
            return match primitive.mode() {
                Mode::TriangleStrip | Mode::TriangleFan => {
                    Err(ReadError::new("holds strips or fans of triangles", "export it as plain triangles"))
                }
                // Points and lines are no part of a surface.
                _ => Ok(()),
            };
        }
        let accessors = primitive.get(&Semantic::Positions).into_iter().chain(primitive.indices());
        accessors.clone().try_for_each(|a| self.readable(&a))?;
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let Some(positions) = reader.read_positions() else {
            return Err(ReadError::new("a mesh has no positions", DAMAGED));
        };
        let first = self.soup.vertices.len() as u32;
        let placed: Vec<[f64; 3]> = positions.map(|p| upright(apply(matrix, p))).collect();
        let count = placed.len() as u32;
        let corners: Vec<u32> = reader.read_indices().map_or_else(|| (0..count).collect(), |i| i.into_u32().collect());
        let mirrored = determinant(matrix) < 0.0;
        self.soup.vertices.extend(placed);
        let triangles =
            corners.as_chunks::<3>().0.iter().map(|&[a, b, c]| if mirrored { [a, c, b] } else { [a, b, c] });
        self.soup.triangles.extend(triangles.map(|t| t.map(|i| first + i)));
        Ok(())
    }

    /// Whether all that an accessor names lies in its buffer.
    fn readable(&self, accessor: &Accessor) -> Result<(), ReadError> {
        let Some(view) = accessor.view().filter(|_| accessor.sparse().is_none()) else {
            return Err(ReadError::new("holds sparse accessors", "export it without them"));
        };
        let stride = view.stride().unwrap_or(accessor.size());
        let end = accessor.offset() + stride * accessor.count().saturating_sub(1) + accessor.size();
        let held = self.buffers.get(view.buffer().index()).map_or(0, Vec::len);
        if end > view.length() || view.offset() + view.length() > held {
            return Err(ReadError::new(format!("accessor {} reaches beyond its buffer", accessor.index()), DAMAGED));
        }
        Ok(())
    }
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

fn apply(m: Matrix, p: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = p.map(f64::from);
    [0, 1, 2].map(|r| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| f64::from(m[k][r]));
        a * x + b * y + c * z + d
    })
}

fn determinant(m: Matrix) -> f32 {
    let [a, b, c] = [m[0], m[1], m[2]];
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Turns y up to z up.
fn upright([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -z, y]
}
