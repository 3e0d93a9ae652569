//! glTF 2.0 files.

use data_encoding::BASE64;
use gltf::accessor::{Accessor, DataType, Dimensions};
use gltf::buffer::Source;
use gltf::mesh::Mode;
use gltf::{Gltf, Node, Primitive, Semantic};

use crate::{DAMAGED, ReadError, Soup, TOO_LARGE, enough_room};

/// Length of the JSON text [bytes] (chosen: 100,000 triangles take 5 MB as base64).
const MOST_JSON_BYTES: usize = 32 << 20;
/// JSON objects in a file [-] (chosen: a file with one body has some dozens; each takes a few hundred bytes of memory).
const MOST_OBJECTS: usize = 100_000;
/// Total length of all buffers [bytes] (chosen: buffers also hold what is not read, such as pictures).
const MOST_BUFFER_BYTES: usize = 128 << 20;

/// Types of an accessor that contains positions, by the specification.
const POSITIONS: (Dimensions, &[DataType]) = (Dimensions::Vec3, &[DataType::F32]);
/// Types of an accessor that contains indices, by the specification.
const INDICES: (Dimensions, &[DataType]) = (Dimensions::Scalar, &[DataType::U8, DataType::U16, DataType::U32]);

/// A transformation in column-major order, as in glTF.
type Matrix = [[f32; 4]; 4];

const UNIT: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Length of the header of a binary file [bytes], which its stated length includes.
const BINARY_HEADER: u32 = 12;
/// Largest nesting depth of nodes [-] (chosen: valid files have far less).
const DEEPEST: usize = 64;

/// Returns the triangles of a file's default scene, rotated so that z points up.
///
/// # Errors
/// [`ReadError`] if the file is not valid, a buffer is missing or too short, the geometry uses an unsupported feature, or
/// the file or its body is too large.
pub fn read(bytes: &[u8], sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Soup, ReadError> {
    bounded(bytes)?;
    if let Some(length) = binary_length(bytes).filter(|length| *length < BINARY_HEADER) {
        return Err(ReadError::new(format!("states a length of {length} bytes, less than its header"), DAMAGED));
    }
    let Gltf { document, blob } = valid(bytes)?;
    let buffers = buffers(&document, blob, sibling)?;
    let mut reader = Reader { buffers, soup: Soup::default(), visited: vec![false; document.nodes().len()] };
    let scene = document.default_scene().or_else(|| document.scenes().next());
    match scene {
        Some(scene) => scene.nodes().try_for_each(|n| reader.node(&n, UNIT, 0))?,
        None => document.meshes().flat_map(|m| m.primitives()).try_for_each(|p| reader.primitive(&p, UNIT))?,
    }
    Ok(reader.soup)
}

/// Length [bytes] that the header of a binary file states, by the specification its third number.
fn binary_length(bytes: &[u8]) -> Option<u32> {
    let (magic, rest) = bytes.split_first_chunk::<4>()?;
    let length = rest.get(4..)?.first_chunk::<4>()?;
    (magic == b"glTF").then(|| u32::from_le_bytes(*length))
}

/// Returns the parsed and validated file.
///
/// The crate's validation indexes the accessors of positions without a check, so these indices are checked before it.
fn valid(bytes: &[u8]) -> Result<Gltf, ReadError> {
    let invalid = |e: gltf::Error| ReadError::new(format!("is not a valid glTF file: {e}"), DAMAGED);
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(invalid)?;
    let root = document.into_json();
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut indices = primitives.flat_map(|p| p.attributes.values()).map(|index| index.value());
    if let Some(missing) = indices.find(|index| *index >= root.accessors.len()) {
        return Err(ReadError::new(format!("refers to accessor {missing}, which does not exist"), DAMAGED));
    }
    let document = gltf::Document::from_json(root).map_err(invalid)?;
    Ok(Gltf { document, blob })
}

/// Returns the bytes of all buffers: the binary chunk, a data URI, or a file in the same folder.
fn buffers(
    document: &gltf::Document,
    mut blob: Option<Vec<u8>>,
    sibling: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<Vec<u8>>, ReadError> {
    let declared = document.buffers().fold(0, |sum: usize, b| sum.saturating_add(b.length()));
    if declared > MOST_BUFFER_BYTES {
        return Err(ReadError::new(format!("declares buffers of {declared} bytes"), TOO_LARGE));
    }
    let bytes = |buffer: gltf::Buffer| {
        let bytes = match buffer.source() {
            Source::Bin => blob.take(),
            Source::Uri(uri) if uri.starts_with("data:") => {
                uri.split_once(";base64,").and_then(|(_, data)| from_base64(data))
            }
            Source::Uri(uri) => {
                let missing = format!("refers to \"{uri}\", which is no file in the same folder that can be read");
                Some(sibling(uri).ok_or_else(|| {
                    ReadError::new(missing, "put that file into the same folder, or export a single .glb file")
                })?)
            }
        };
        let Some(mut bytes) = bytes.filter(|b| b.len() >= buffer.length()) else {
            let message = format!("its buffer {} has fewer than {} bytes", buffer.index(), buffer.length());
            return Err(ReadError::new(message, DAMAGED));
        };
        // Views lie within the declared length; the sum of all lengths bounds the memory.
        bytes.truncate(buffer.length());
        bytes.shrink_to_fit();
        Ok(bytes)
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
    /// True for the nodes read so far.
    visited: Vec<bool>,
}

impl Reader {
    /// Adds the meshes of a node and of its children, transformed by `outer`.
    ///
    /// The nodes of a valid file form trees. A node with two parents would multiply its children from level to level.
    fn node(&mut self, node: &Node, outer: Matrix, depth: usize) -> Result<(), ReadError> {
        let is_again = self.visited.get_mut(node.index()).is_none_or(|seen| core::mem::replace(seen, true));
        if is_again || depth > DEEPEST {
            let message = format!("its node {} has two parents, or is nested too deeply", node.index());
            return Err(ReadError::new(message, DAMAGED));
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
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            return Err(ReadError::new("a mesh has no positions", DAMAGED));
        };
        self.readable(&positions, POSITIONS)?;
        primitive.indices().map_or(Ok(()), |indices| self.readable(&indices, INDICES))?;
        let corners = primitive.indices().map_or(positions.count(), |indices| indices.count());
        enough_room(self.soup.triangles.len() + corners / 3, self.soup.vertices.len() + positions.count())?;
        self.add(primitive, matrix)
    }

    /// Adds the triangles of a primitive whose accessors have been checked.
    fn add(&mut self, primitive: &Primitive, matrix: Matrix) -> Result<(), ReadError> {
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let Some(positions) = reader.read_positions() else {
            return Err(ReadError::new("a mesh has no positions", DAMAGED));
        };
        let first = self.soup.vertices.len() as u32;
        let placed: Vec<[f64; 3]> = positions.map(|p| upright(apply(matrix, p))).collect();
        let count = placed.len() as u32;
        let corners: Vec<u32> = reader.read_indices().map_or_else(|| (0..count).collect(), |i| i.into_u32().collect());
        if let Some(missing) = corners.iter().find(|i| **i >= count) {
            return Err(ReadError::new(format!("a triangle refers to corner {missing} of {count}"), DAMAGED));
        }
        let mirrored = determinant(matrix) < 0.0;
        self.soup.vertices.extend(placed);
        let triangles =
            corners.as_chunks::<3>().0.iter().map(|&[a, b, c]| if mirrored { [a, c, b] } else { [a, b, c] });
        self.soup.triangles.extend(triangles.map(|t| t.map(|i| first + i)));
        Ok(())
    }

    /// Checks that an accessor is dense, has one of the types that its use permits, and lies within its buffer.
    fn readable(&self, accessor: &Accessor, (dimensions, types): (Dimensions, &[DataType])) -> Result<(), ReadError> {
        let Some(view) = accessor.view().filter(|_| accessor.sparse().is_none()) else {
            return Err(ReadError::new("contains sparse accessors", "export it without sparse accessors"));
        };
        if accessor.dimensions() != dimensions || !types.contains(&accessor.data_type()) {
            let message = format!("accessor {} has a type that glTF does not permit there", accessor.index());
            return Err(ReadError::new(message, DAMAGED));
        }
        let held = self.buffers.get(view.buffer().index()).map_or(0, Vec::len);
        if !lies_within(accessor, &view, held) {
            let message = format!("accessor {} reaches beyond its buffer, or its elements overlap", accessor.index());
            return Err(ReadError::new(message, DAMAGED));
        }
        Ok(())
    }
}

/// Returns true if the elements of an accessor do not overlap and lie within its view, and the view within `held` bytes.
fn lies_within(accessor: &Accessor, view: &gltf::buffer::View, held: usize) -> bool {
    let stride = view.stride().unwrap_or(accessor.size());
    let last = stride.checked_mul(accessor.count().saturating_sub(1));
    let end = last.and_then(|at| at.checked_add(accessor.offset())?.checked_add(accessor.size()));
    let view_end = view.offset().checked_add(view.length());
    stride >= accessor.size() && end.is_some_and(|end| end <= view.length()) && view_end.is_some_and(|end| end <= held)
}

/// Checks the length of the JSON text and the number of its objects, which bound the memory that parsing takes.
fn bounded(bytes: &[u8]) -> Result<(), ReadError> {
    let length = bytes.get(12..16).and_then(|b| b.try_into().ok()).map_or(0, u32::from_le_bytes) as usize;
    let json = match bytes.strip_prefix(b"glTF") {
        Some(_) => bytes.get(20..).map_or(&[][..], |rest| &rest[..length.min(rest.len())]),
        None => bytes,
    };
    if json.len() > MOST_JSON_BYTES {
        return Err(ReadError::new(format!("contains {} bytes of JSON", json.len()), TOO_LARGE));
    }
    match json.iter().filter(|b| **b == b'{').count() {
        0..=MOST_OBJECTS => Ok(()),
        count => Err(ReadError::new(format!("contains {count} objects"), TOO_LARGE)),
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
