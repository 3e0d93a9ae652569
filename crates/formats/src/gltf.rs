//! Coloured surfaces as a binary glTF 2.0 file.
//!
//! Format: <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>. Its y points up, the kitchen's z: a node above all
//! others turns them. Colours of vertices are linear there, as they are here.

use serde_json::{Value, json};

/// A surface with its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Name of the node.
    pub name: String,
    /// Place of its frame in the kitchen, z upwards [m].
    pub position: [f64; 3],
    /// Rotation of its frame, x, y, z, w.
    pub rotation: [f64; 4],
    /// Points in its frame [m].
    pub points: Vec<[f32; 3]>,
    /// Outward unit normals [-].
    pub normals: Vec<[f32; 3]>,
    /// Colours in linear sRGB, 0 to 1 [-].
    pub colours: Vec<[f32; 3]>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Roughness of the surface, 0 to 1 [-].
    pub roughness: f64,
    /// What else is to be known about it.
    pub extras: Value,
}

const GLB: u32 = 0x4654_6C67;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BINARY_CHUNK: u32 = 0x004E_4942;
const FLOAT: u32 = 5126;
const SHORT: u32 = 5123;
const INTEGER: u32 = 5125;
/// Target of buffers with attributes of vertices.
const ATTRIBUTES: u32 = 34962;
/// Target of buffers with indices.
const INDICES: u32 = 34963;

/// Returns surfaces as a GLB file, a node for each. The same surfaces give the same bytes; one without triangles is left out.
pub fn glb(surfaces: &[Surface]) -> Vec<u8> {
    let mut parts = Parts::default();
    surfaces.iter().filter(|s| !s.triangles.is_empty()).for_each(|s| parts.add(s));
    let Parts { nodes, meshes, materials, accessors, views, binary } = parts;
    let count = nodes.len();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let root = json!({ "name": "kitchen, z up", "rotation": [-half, 0.0, 0.0, half], "children": (1..=count).collect::<Vec<_>>() });
    let empty = json!({ "name": "kitchen, z up" });
    let nodes: Vec<Value> = std::iter::once(if count > 0 { root } else { empty }).chain(nodes).collect();
    let mut file = json!({
        "asset": { "version": "2.0", "generator": concat!("saute ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": nodes,
    });
    if count > 0 {
        file["meshes"] = json!(meshes);
        file["materials"] = json!(materials);
        file["accessors"] = json!(accessors);
        file["bufferViews"] = json!(views);
        file["buffers"] = json!([{ "byteLength": binary.len() }]);
    }
    packed(file.to_string().into_bytes(), binary)
}

/// Header, JSON and bytes, each padded to four bytes.
fn packed(mut json: Vec<u8>, binary: Vec<u8>) -> Vec<u8> {
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunks = [(JSON_CHUNK, json), (BINARY_CHUNK, binary)].into_iter().filter(|(_, bytes)| !bytes.is_empty());
    let body: Vec<u8> = chunks
        .flat_map(|(kind, bytes)| {
            [(bytes.len() as u32).to_le_bytes(), kind.to_le_bytes()].concat().into_iter().chain(bytes)
        })
        .collect();
    let header = [GLB, 2, body.len() as u32 + 12].map(u32::to_le_bytes).concat();
    header.into_iter().chain(body).collect()
}

/// The lists of a file that is being made.
#[derive(Default)]
struct Parts {
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    accessors: Vec<Value>,
    views: Vec<Value>,
    binary: Vec<u8>,
}

impl Parts {
    fn add(&mut self, surface: &Surface) {
        let index = self.meshes.len();
        let attributes = json!({
            "POSITION": self.points(&surface.points),
            "NORMAL": self.normals(&surface.normals),
            "COLOR_0": self.colours(&surface.colours),
        });
        let indices = self.triangles(&surface.triangles);
        let primitive = json!({ "attributes": attributes, "indices": indices, "material": index });
        self.meshes.push(json!({ "name": surface.name, "primitives": [primitive] }));
        let metal = json!({ "metallicFactor": 0.0, "roughnessFactor": surface.roughness });
        self.materials.push(json!({ "name": surface.name, "pbrMetallicRoughness": metal }));
        let [position, rotation] = [json!(surface.position), json!(unit(surface.rotation))];
        let mut node = json!({ "name": surface.name, "mesh": index, "translation": position, "rotation": rotation });
        if surface.extras.is_object() {
            node["extras"] = surface.extras.clone();
        }
        self.nodes.push(node);
    }

    fn points(&mut self, points: &[[f32; 3]]) -> usize {
        let bytes = points.as_flattened().iter().flat_map(|v| v.to_le_bytes()).collect();
        let bound = |of: fn(f32, f32) -> f32| [0, 1, 2].map(|k| points.iter().map(|p| p[k]).reduce(of).unwrap_or(0.0));
        let bounds = json!({ "min": bound(f32::min), "max": bound(f32::max) });
        self.accessor(bytes, ATTRIBUTES, points.len(), FLOAT, "VEC3", bounds)
    }

    fn normals(&mut self, normals: &[[f32; 3]]) -> usize {
        let bytes = normals.as_flattened().iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(bytes, ATTRIBUTES, normals.len(), FLOAT, "VEC3", json!({}))
    }

    /// Colours with 16 bits a channel: as linear light, dark crust has too few steps in 8. The fourth channel keeps vertices
    /// on multiples of four bytes.
    fn colours(&mut self, colours: &[[f32; 3]]) -> usize {
        let channel = |v: f32| (v.clamp(0.0, 1.0) * f32::from(u16::MAX)).round() as u16;
        let rgba = colours.iter().flat_map(|[r, g, b]| [channel(*r), channel(*g), channel(*b), u16::MAX]);
        let bytes = rgba.flat_map(u16::to_le_bytes).collect();
        self.accessor(bytes, ATTRIBUTES, colours.len(), SHORT, "VEC4", json!({ "normalized": true }))
    }

    fn triangles(&mut self, triangles: &[[u32; 3]]) -> usize {
        let bytes = triangles.as_flattened().iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(bytes, INDICES, 3 * triangles.len(), INTEGER, "SCALAR", json!({}))
    }

    /// Adds bytes with their view and accessor; returns the index of the accessor.
    fn accessor(&mut self, bytes: Vec<u8>, target: u32, count: usize, kind: u32, shape: &str, more: Value) -> usize {
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len(), "target": target });
        let mut accessor =
            json!({ "bufferView": self.views.len(), "componentType": kind, "count": count, "type": shape });
        for (key, value) in more.as_object().into_iter().flatten() {
            accessor[key.as_str()] = value.clone();
        }
        self.binary.extend(bytes);
        self.views.push(view);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

/// A quaternion of unit length.
fn unit(rotation: [f64; 4]) -> [f64; 4] {
    let length = rotation.iter().map(|v| v * v).sum::<f64>().sqrt();
    if length > 0.0 { rotation.map(|v| v / length) } else { [0.0, 0.0, 0.0, 1.0] }
}
