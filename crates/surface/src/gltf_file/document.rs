//! What the JSON of a glTF file states of its shape; the rest is skipped.

use serde::Deserialize;

use crate::ReadError;
use crate::gltf_file::container::Container;
use crate::read_error::{DAMAGED, TOO_LARGE};

/// Length of the JSON text [bytes] (chosen: the largest surface takes 20 MB as base64).
const MOST_JSON_BYTES: usize = 32 << 20;
/// JSON objects in a file [-] (chosen: a file with one body has some dozens; each takes a few hundred bytes of memory).
const MOST_OBJECTS: usize = 100_000;

/// The file.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Document {
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<View>,
    pub buffers: Vec<Buffer>,
    pub extensions_used: Vec<String>,
    pub extensions_required: Vec<String>,
}

/// Nodes that are shown together.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Scene {
    pub nodes: Vec<usize>,
}

/// A place with a mesh or with other nodes.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Node {
    pub name: Option<String>,
    pub children: Vec<usize>,
    pub mesh: Option<usize>,
    pub matrix: Option<[f32; 16]>,
    pub translation: Option<[f32; 3]>,
    pub rotation: Option<[f32; 4]>,
    pub scale: Option<[f32; 3]>,
}

/// A mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Mesh {
    pub primitives: Vec<Primitive>,
}

/// Triangles, lines or points.
#[derive(Debug, Deserialize)]
pub struct Primitive {
    #[serde(default)]
    pub attributes: Attributes,
    pub indices: Option<usize>,
    /// Kind of its elements; triangles if it is left out.
    #[serde(default = "triangles")]
    pub mode: u32,
}

fn triangles() -> u32 {
    4
}

/// Data of corners.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Attributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
}

/// Elements in a view of a buffer.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub dimensions: Dimensions,
    pub sparse: Option<Sparse>,
}

/// Numbers of an element.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub enum Dimensions {
    #[serde(rename = "SCALAR")]
    Scalar,
    #[serde(rename = "VEC3")]
    Vec3,
    #[serde(other)]
    Other,
}

/// Elements that differ from those of the view.
#[derive(Debug, Deserialize)]
pub struct Sparse {
    pub count: usize,
    pub indices: SparseIndices,
    pub values: SparseValues,
}

/// Which elements differ.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct SparseIndices {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
}

/// What they are.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct SparseValues {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
}

/// A part of a buffer.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
}

/// Bytes in the file, in another file, or in a text.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Buffer {
    pub byte_length: usize,
    pub uri: Option<String>,
}

/// Returns the content of the JSON.
pub fn parse(container: &Container) -> Result<Document, ReadError> {
    bounded(container.json)?;
    let invalid = |error: serde_json::Error| ReadError {
        place: container.place(&error),
        ..ReadError::new(explained(&error), DAMAGED)
    };
    let versioned: Versioned = serde_json::from_slice(container.json).map_err(invalid)?;
    let version = versioned.asset.map(|asset| asset.version).unwrap_or_default();
    if !version.starts_with("2.") {
        let stated = if version.is_empty() { "states no version of glTF".into() } else { format!("is glTF {version}") };
        return Err(ReadError::new(format!("{stated}, and only 2.0 is read"), "export it as glTF 2.0"));
    }
    serde_json::from_slice(container.json).map_err(invalid)
}

/// A file of any version.
#[derive(Deserialize)]
struct Versioned {
    asset: Option<Asset>,
}

#[derive(Deserialize)]
struct Asset {
    version: String,
}

/// Returns the cause of an error, with the column in place of the line, which the place of the error states.
fn explained(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let cause = text.rsplit_once(" at line ").map_or(text.as_str(), |(cause, _)| cause);
    format!("is not valid glTF at column {}: {cause}", error.column())
}

/// Checks the length of the JSON text and the number of its objects, which bound the memory that parsing takes.
fn bounded(json: &[u8]) -> Result<(), ReadError> {
    if json.len() > MOST_JSON_BYTES {
        return Err(ReadError::new(format!("contains {} bytes of JSON", json.len()), TOO_LARGE));
    }
    match json.iter().filter(|byte| **byte == b'{').count() {
        0..=MOST_OBJECTS => Ok(()),
        count => Err(ReadError::new(format!("contains {count} objects"), TOO_LARGE)),
    }
}

/// Returns the element of a list that an index of the file names.
///
/// # Errors
/// [`ReadError`] if there is none.
pub fn at<'a, T>(list: &'a [T], index: usize, what: &str) -> Result<&'a T, ReadError> {
    list.get(index).ok_or_else(|| ReadError::new(format!("refers to {what} {index}, which does not exist"), DAMAGED))
}
