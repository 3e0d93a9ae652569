//! Promise: a coloured surface is a GLB file whose parts fit together, and the program's own reader finds it as it was.

use saute_formats::gltf::{Surface, glb};
use serde_json::{Value, json};

/// A tetrahedron that is in a kitchen, turned a quarter about the vertical.
fn tetrahedron() -> Surface {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    Surface {
        name: "food".to_owned(),
        position: [0.1, 0.2, 0.3],
        rotation: [0.0, 0.0, half, half],
        points: vec![[0.0, 0.0, 0.0], [0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.02]],
        normals: vec![[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        colours: vec![[0.0, 0.0, 0.0], [0.5, 0.25, 1.0], [0.001, 1.5, -0.5], [1.0, 1.0, 1.0]],
        triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        roughness: 0.6,
        extras: json!({ "core_c": 54.0 }),
    }
}

fn chunks(file: &[u8]) -> (Value, Vec<u8>) {
    let number = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&file[..4], number(4), number(8)), (b"glTF".as_slice(), 2, file.len()));
    let json = number(12);
    assert_eq!((number(16), json % 4), (0x4E4F_534A, 0));
    let binary = 20 + json;
    assert_eq!((number(binary + 4), number(binary) % 4), (0x004E_4942, 0));
    assert_eq!(binary + 8 + number(binary), file.len());
    (serde_json::from_slice(&file[20..binary]).unwrap(), file[binary + 8..].to_vec())
}

#[test]
fn accessors_lie_within_their_views_and_state_their_bounds() {
    let file = glb(&[tetrahedron(), tetrahedron()]);
    assert_eq!(file, glb(&[tetrahedron(), tetrahedron()]));
    let (json, binary) = chunks(&file);
    assert_eq!(json["buffers"][0]["byteLength"], binary.len());
    let views = json["bufferViews"].as_array().unwrap();
    let mut end = 0;
    for view in views {
        assert_eq!(view["byteOffset"], end, "views follow each other");
        end += view["byteLength"].as_u64().unwrap() as usize;
        assert_eq!(end % 4, 0);
    }
    assert_eq!(end, binary.len());
    for accessor in json["accessors"].as_array().unwrap() {
        let view = &views[accessor["bufferView"].as_u64().unwrap() as usize];
        let size = match (accessor["type"].as_str().unwrap(), accessor["componentType"].as_u64().unwrap()) {
            ("VEC3", 5126) => 12,
            ("VEC4", 5123) => 8,
            ("SCALAR", 5125) => 4,
            other => panic!("{other:?}"),
        };
        assert_eq!(accessor["count"].as_u64().unwrap() * size, view["byteLength"].as_u64().unwrap());
    }
    assert_eq!(json["accessors"][0]["min"], json!([0.0, 0.0, 0.0]));
    assert_eq!(json["accessors"][0]["max"], json!([0.02f32, 0.02f32, 0.02f32]));
    assert_eq!((json["nodes"].as_array().unwrap().len(), &json["nodes"][1]["extras"]["core_c"]), (3, &json!(54.0)));
}

#[test]
fn colours_are_linear_with_16_bits_and_within_0_to_1() {
    let (json, binary) = chunks(&glb(&[tetrahedron()]));
    let primitive = &json["meshes"][0]["primitives"][0];
    let accessor = &json["accessors"][primitive["attributes"]["COLOR_0"].as_u64().unwrap() as usize];
    assert_eq!(accessor["normalized"], true);
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let from = view["byteOffset"].as_u64().unwrap() as usize;
    let channel = |k: usize| u16::from_le_bytes(binary[from + 2 * k..from + 2 * k + 2].try_into().unwrap());
    let [red, green, blue, alpha] = [4, 5, 6, 7].map(channel);
    assert_eq!([red, green, blue, alpha], [32768, 16384, 65535, 65535]);
    assert_eq!([8, 9, 10].map(channel), [66, 65535, 0]);
}

#[test]
fn the_program_reads_its_own_file_where_the_food_lay() {
    let soup = saute_surface::read("cooked.glb", &glb(&[tetrahedron()]), |_| None).unwrap();
    assert_eq!(soup.triangles.len(), 4);
    // Its reader turns y up to z up; a quarter turn brings x to y. In metres.
    let found = |p: [f64; 3]| soup.vertices.iter().any(|v| (0..3).all(|k| (v[k] - p[k]).abs() < 1e-6));
    for p in [[0.1, 0.2, 0.3], [0.1, 0.22, 0.3], [0.08, 0.2, 0.3], [0.1, 0.2, 0.32]] {
        assert!(found(p), "{p:?} in {:?}", soup.vertices);
    }
}

#[test]
fn a_kitchen_without_food_gives_a_file_without_meshes() {
    let file = glb(&[]);
    let json: Value = serde_json::from_slice(&file[20..]).unwrap();
    assert!(json.get("meshes").is_none() && json["nodes"].as_array().unwrap().len() == 1);
}

#[test]
fn the_program_reads_each_food_of_its_own_file_by_its_name() {
    let (first, second) = (tetrahedron(), Surface { name: "carrot.2".to_owned(), ..tetrahedron() });
    let bodies = saute_surface::bodies("cooked.glb", &glb(&[first.clone(), second]), |_| None).unwrap();
    let names: Vec<_> = bodies.iter().map(|body| body.name.as_deref()).collect();
    assert_eq!(names, [Some(first.name.as_str()), Some("carrot.2")]);
    assert!(bodies.iter().all(|body| body.soup.triangles.len() == 4));
}
