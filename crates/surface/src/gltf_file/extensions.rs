//! Extensions of glTF: which may be required of a reader that reads the shape alone.

use crate::ReadError;

/// Extension with which positions may be integers.
pub const QUANTIZATION: &str = "KHR_mesh_quantization";
/// Extensions that compress the shape.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];
/// Beginnings of names, behind the prefix of the vendor, of extensions that leave the shape as it is.
const BESIDE_THE_SHAPE: [&str; 16] = [
    "animation",
    "audio",
    "blend",
    "camera",
    "environment",
    "feature",
    "instance_features",
    "lights",
    "materials",
    "mesh_features",
    "ngon_encoding",
    "packing",
    "primitive_outline",
    "structural_metadata",
    "techniques",
    "texture",
];
/// Beginning of extensions with metadata.
const METADATA: &str = "xmp";

/// Checks that no extension that a file requires could change its shape.
///
/// # Errors
/// [`ReadError`] with the name of the extension, and how to do without it.
pub fn check(required: &[String]) -> Result<(), ReadError> {
    let mut refused = required.iter().filter(|name| !leaves_the_shape(name));
    let Some(name) = refused.next() else { return Ok(()) };
    if COMPRESSIONS.contains(&name.as_str()) {
        return Err(compressed(name));
    }
    let message = format!("requires the extension {name}, which is not read and may change the shape");
    Err(ReadError::new(message, format!("export it again without {name}, as plain triangles")))
}

fn leaves_the_shape(name: &str) -> bool {
    let own_name = name.split_once('_').map_or(name, |(_, own)| own);
    name == QUANTIZATION
        || own_name.starts_with(METADATA)
        || BESIDE_THE_SHAPE.iter().any(|begin| own_name.starts_with(begin))
}

/// Returns the error of data that are missing: they are compressed, or there are none.
pub fn without_data(used: &[String], what: &str) -> ReadError {
    match used.iter().find(|name| COMPRESSIONS.contains(&name.as_str())) {
        Some(name) => compressed(name),
        None => ReadError::new(format!("{what} has no data"), "export it again with the data, as a single .glb file"),
    }
}

fn compressed(name: &str) -> ReadError {
    let remedy = "export it again with compression switched off (in Blender: Data, Compression), or decompress it with: \
                  gltf-transform copy compressed.glb plain.glb";
    ReadError::new(format!("has a shape that is compressed with {name}, which is not read"), remedy)
}
