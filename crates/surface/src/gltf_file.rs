//! glTF 2.0 files.

use data_encoding::BASE64;
use gltf::accessor::Accessor;
use gltf::buffer::Source;
use gltf::mesh::Mode;
use gltf::{Gltf, Node, Primitive, Semantic};

use crate::{DAMAGED, ReadError, Soup};

/// A transformation in column-major order, as in glTF.
type Matrix = [[f32; 4]; 4];

const UNIT: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Largest nesting depth of nodes [-] (chosen: valid files have far less; a damaged file may contain a cycle).
const DEEPEST: usize = 64;

/// Returns the triangles of a file's default scene, rotated so that z points up.
///
/// # Errors
/// [`ReadError`] if the file is not valid, a buffer is missing or too short, or the geometry uses an unsupported feature.
pub fn read(bytes: &[u8], sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Soup, ReadError> {
    let Gltf { document, blob } =
        Gltf::from_slice(bytes).map_err(|e| ReadError::new(format!("is not a valid glTF file: {e}"), DAMAGED))?;
    let buffers = buffers(&document, blob, sibling)?;
    let mut reader = Reader { buffers, soup: Soup::default() };
    let scene = document.default_scene().or_else(|| document.scenes().next());
    match scene {
        Some(scene) => scene.nodes().try_for_each(|n| reader.node(&n, UNIT, 0))?,
        None => document.meshes().flat_map(|m| m.primitives()).try_for_each(|p| reader.primitive(&p, UNIT))?,
    }
    Ok(reader.soup)
}

/// Returns the bytes of all buffers: the binary chunk, a data URI, or a file in the same folder.
fn buffers(
    document: &gltf::Document,
    mut blob: Option<Vec<u8>>,
    sibling: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Vec<u8>>, ReadError> {
    let bytes = |buffer: gltf::Buffer| {
        let bytes = match buffer.source() {
            Source::Bin => blob.take(),
            Source::Uri(uri) if uri.starts_with("data:") => {
                uri.split_once(";base64,").and_then(|(_, data)| from_base64(data))
            }
            Source::Uri(uri) => {
                let missing = format!("refers to \"{uri}\" in the same folder, which cannot be read");
                Some(sibling(uri).ok_or_else(|| {
                    ReadError::new(missing, "put that file into the same folder, or export a single .glb file")
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

/// Returns the bytes of padded standard base64 text (RFC 4648, section 4), or `None` if the text is not canonical.
///
/// `BASE64` alone also decodes a concatenation of padded texts; RFC 4648 permits padding only at the end.
fn from_base64(text: &str) -> Option<Vec<u8>> {
    let is_padded_inside = text.trim_end_matches('=').contains('=');
    if is_padded_inside { None } else { BASE64.decode(text.as_bytes()).ok() }
}

/// The buffers of a file and the triangles read so far.
struct Reader {
    buffers: Vec<Vec<u8>>,
    soup: Soup,
}

impl Reader {
    /// Adds the meshes of a node and of its children, transformed by `outer`.
    fn node(&mut self, node: &Node, outer: Matrix, depth: usize) -> Result<(), ReadError> {
        if depth > DEEPEST {
            return Err(ReadError::new("has nodes that contain each other", DAMAGED));
        }
        let matrix = product(outer, node.transform().matrix());
        if let Some(mesh) = node.mesh() {
            mesh.primitives().try_for_each(|p| self.primitive(&p, matrix))?;
        }
        node.children().try_for_each(|child| self.node(&child, matrix, depth + 1))
    }

    /// Adds the triangles of a primitive, transformed by `matrix`; skips points and lines.
    fn primitive(&mut self, primitive: &Primitive, matrix: Matrix) -> Result<(), ReadError> {
        match primitive.mode() {
            Mode::Triangles => {}
            Mode::TriangleStrip | Mode::TriangleFan => {
                return Err(ReadError::new("contains strips or fans of triangles", "export it as plain triangles"));
            }
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => return Ok(()),
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

    /// Checks that an accessor is dense and lies within its buffer.
    fn readable(&self, accessor: &Accessor) -> Result<(), ReadError> {
        let Some(view) = accessor.view().filter(|_| accessor.sparse().is_none()) else {
            return Err(ReadError::new("contains sparse accessors", "export it without sparse accessors"));
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

/// Returns the matrix product a b.
fn product(a: Matrix, b: Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// Returns a transformed point, computed in double precision.
fn apply(m: Matrix, p: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = p.map(f64::from);
    [0, 1, 2].map(|r| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| f64::from(m[k][r]));
        a * x + b * y + c * z + d
    })
}

/// Returns the determinant of the linear part; it is negative for a reflection.
fn determinant(m: Matrix) -> f32 {
    let [a, b, c] = [m[0], m[1], m[2]];
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Returns a point rotated from y up to z up.
fn upright([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, -z, y]
}
