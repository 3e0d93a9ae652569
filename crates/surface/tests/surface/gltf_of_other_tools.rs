//! Promise: glTF as other tools write it is read, what cannot be read is named with its remedy, and references stay inside
//! the folder.

use data_encoding::BASE64;
use saute_heat::Surface;
use saute_heat::mesh::surface::MOST_TRIANGLES;
use saute_surface::{Place, ReadError, Soup, read};
use serde_json::{Value, json};

/// A tetrahedron with legs of 10 mm.
const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [0.01, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]];
const FACES: [u16; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

fn file(positions: &[u8], indices: &[u8], accessor: Value) -> Value {
    let buffer = [positions, indices].concat();
    let uri = format!("data:application/octet-stream;base64,{}", BASE64.encode(&buffer));
    json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [accessor, {"bufferView": 1, "componentType": 5123, "count": indices.len() / 2, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": positions.len()},
                        {"buffer": 0, "byteOffset": positions.len(), "byteLength": indices.len()}],
        "buffers": [{"byteLength": buffer.len(), "uri": uri}]
    })
}

fn tetrahedron() -> Value {
    file(&positions(), &indices(), json!({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}))
}

fn positions() -> Vec<u8> {
    CORNERS.iter().flatten().flat_map(|v| v.to_le_bytes()).collect()
}

fn indices() -> Vec<u8> {
    FACES.iter().flat_map(|i| i.to_le_bytes()).collect()
}

fn gltf(file: &Value) -> Result<Soup, ReadError> {
    read("piece.gltf", file.to_string().as_bytes(), |_| None)
}

/// The GLB of a file whose buffer becomes its binary chunk.
fn glb(mut file: Value, buffer: &[u8]) -> Vec<u8> {
    file["buffers"] = json!([{"byteLength": buffer.len()}]);
    let mut json = file.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |kind: &[u8; 4], data: &[u8]| [&(data.len() as u32).to_le_bytes(), &kind[..], data].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", buffer)].concat();
    [b"glTF".as_slice(), &2u32.to_le_bytes(), &(12 + chunks.len() as u32).to_le_bytes(), &chunks].concat()
}

/// Reads the tetrahedron with its buffer in another file; returns the path that is requested.
fn asked(uri: &str) -> Result<String, ReadError> {
    let mut file = tetrahedron();
    file["buffers"][0]["uri"] = json!(uri);
    let path = std::cell::RefCell::new(String::new());
    let beside = |name: &str| {
        name.clone_into(&mut path.borrow_mut());
        Some([positions(), indices()].concat())
    };
    read("piece.gltf", file.to_string().as_bytes(), beside)?;
    Ok(path.into_inner())
}

#[test]
fn references_are_decoded_before_they_are_asked_for() {
    for (uri, path) in [
        ("my%20steak.bin", "my steak.bin"),
        ("my steak.bin", "my steak.bin"),
        ("./my%20steak.bin", "my steak.bin"),
        ("%E8%82%89.bin", "肉.bin"),
        ("buffers/./steak%2Bbone.bin", "buffers/steak+bone.bin"),
        ("100%.bin", "100%.bin"),
        ("..steak.bin", "..steak.bin"),
        ("%252e%252e%252fsteak.bin", "%2e%2e%2fsteak.bin"),
    ] {
        assert_eq!(asked(uri), Ok(path.to_owned()), "{uri}");
    }
}

#[test]
fn references_out_of_the_folder_are_refused_before_they_are_asked_for() {
    for uri in [
        "../steak.bin",
        "a/../../steak.bin",
        "a/..",
        "%2e%2e%2fsteak.bin",
        "%2E%2E/steak.bin",
        ".%2e/steak.bin",
        "..%5csteak.bin",
        "..\\steak.bin",
        ".. /steak.bin",
        "/etc/passwd",
        "%2fetc%2fpasswd",
        "//server/share/steak.bin",
        "\\\\server\\share\\steak.bin",
        "c:steak.bin",
        "C%3A%5Csteak.bin",
        "http://example.org/steak.bin",
        "https%3A//example.org/steak.bin",
        "file:///etc/passwd",
        "steak.bin%00.png",
        "%ff%fe.bin",
        ".",
        "",
    ] {
        let error = asked(uri).unwrap_err();
        assert!(error.message.contains("no file in the same folder: "), "{uri}: {error}");
        assert!(error.remedy.contains("into the same folder"), "{uri}: {error}");
    }
}

#[test]
fn a_data_uri_may_have_escapes() {
    let usual = gltf(&tetrahedron()).unwrap();
    let mut file = tetrahedron();
    let uri = file["buffers"][0]["uri"].as_str().unwrap().replacen("A", "%41", 3).replace('+', "%2B");
    file["buffers"][0]["uri"] = json!(uri);
    assert_eq!(gltf(&file), Ok(usual));
}

#[test]
fn quantized_positions_are_scaled_by_their_node() {
    let usual = gltf(&tetrahedron()).unwrap();
    // Each kind of integer, padded to four bytes an element, with its value for 10 mm and its scale.
    for (component, bytes, stride) in [(5120, 1, 4), (5121, 1, 4), (5122, 2, 8), (5123, 2, 8)] {
        for is_normalized in [false, true] {
            let most: u32 = if component % 2 == 0 { (1 << (8 * bytes - 1)) - 1 } else { (1 << (8 * bytes)) - 1 };
            let element = |corner: &[f32; 3]| {
                let numbers =
                    corner.iter().flat_map(|v| if *v > 0.0 { most } else { 0 }.to_le_bytes()[..bytes].to_vec());
                let mut element: Vec<u8> = numbers.collect();
                element.resize(stride, 0);
                element
            };
            let positions: Vec<u8> = CORNERS.iter().flat_map(element).collect();
            let accessor = json!({"bufferView": 0, "componentType": component, "normalized": is_normalized, "count": 4, "type": "VEC3"});
            let mut file = file(&positions, &indices(), accessor);
            file["bufferViews"][0]["byteStride"] = json!(stride);
            let scale = 0.01 / if is_normalized { 1.0 } else { f64::from(most) };
            file["nodes"][0]["scale"] = json!(vec![scale; 3]);
            assert!(gltf(&file).is_err(), "integers without the extension");
            file["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
            file["extensionsRequired"] = file["extensionsUsed"].clone();
            let soup = gltf(&file).unwrap();
            let pairs = soup.vertices.iter().flatten().zip(usual.vertices.iter().flatten());
            assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9), "{component} {is_normalized}: {soup:?}");
            assert_eq!(soup.triangles, usual.triangles);
        }
    }
}

#[test]
fn the_least_signed_integer_stands_for_minus_one() {
    let bytes = [-128i8, 0, 127, 0].map(|v| v as u8).repeat(4);
    let accessor = json!({"bufferView": 0, "componentType": 5120, "normalized": true, "count": 4, "type": "VEC3"});
    let mut file = file(&bytes, &indices(), accessor);
    file["bufferViews"][0]["byteStride"] = json!(4);
    file["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
    assert_eq!(gltf(&file).unwrap().vertices[0], [-1.0, -1.0, 0.0], "y up becomes z up");
}

#[test]
fn extensions_that_leave_the_shape_may_be_required() {
    let usual = gltf(&tetrahedron()).unwrap();
    for name in [
        "KHR_materials_pbrSpecularGlossiness",
        "KHR_materials_unlit",
        "KHR_materials_variants",
        "ADOBE_materials_thin_transparency",
        "KHR_texture_transform",
        "KHR_texture_basisu",
        "EXT_texture_webp",
        "MSFT_texture_dds",
        "MSFT_packing_occlusionRoughnessMetallic",
        "KHR_lights_punctual",
        "EXT_lights_image_based",
        "KHR_xmp_json_ld",
        "KHR_animation_pointer",
        "FB_ngon_encoding",
    ] {
        let mut file = tetrahedron();
        file["extensionsRequired"] = json!([name]);
        assert_eq!(gltf(&file).as_ref(), Ok(&usual), "{name}");
    }
}

#[test]
fn compression_is_named_with_its_remedy_in_one_line() {
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"] {
        let mut file = tetrahedron();
        file["extensionsUsed"] = json!(["KHR_mesh_quantization", name]);
        assert!(gltf(&file).is_ok(), "{name}: the data is there without it, too");
        let mut bare = file.clone();
        bare["accessors"] = json!([{"componentType": 5126, "count": 4, "type": "VEC3"}, {"componentType": 5123, "count": 12, "type": "SCALAR"}]);
        file["extensionsRequired"] = file["extensionsUsed"].clone();
        for file in [file, bare] {
            let error = gltf(&file).unwrap_err();
            assert!(error.message.contains(name) && error.message.len() < 120, "{error}");
            assert!(error.remedy.contains("gltf-transform copy") && !error.remedy.contains("damaged"), "{error}");
        }
    }
}

#[test]
fn other_required_extensions_are_named() {
    let mut file = tetrahedron();
    file["extensionsRequired"] = json!(["KHR_materials_unlit", "EXT_mesh_gpu_instancing"]);
    let error = gltf(&file).unwrap_err();
    assert!(error.message.contains("EXT_mesh_gpu_instancing") && error.remedy.contains("without"), "{error}");
}

#[test]
fn sparse_positions_are_read_with_and_without_a_view() {
    let usual = gltf(&tetrahedron()).unwrap();
    // Corners 1 to 3 are given one by one; the others are zero.
    let sparse = [positions()[12..].to_vec(), vec![1, 2, 3, 0], indices()].concat();
    let accessor = json!({"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 3,
        "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 0}}});
    let mut file = file(&sparse[..40], &sparse[40..], accessor);
    file["bufferViews"][0]["byteLength"] = json!(36);
    file["bufferViews"].as_array_mut().unwrap().push(json!({"buffer": 0, "byteOffset": 36, "byteLength": 3}));
    assert_eq!(gltf(&file).as_ref(), Ok(&usual));
    file["accessors"][0]["count"] = json!(3);
    assert!(gltf(&file).is_err(), "an index beyond the accessor");
    file["accessors"][0]["count"] = json!(u64::MAX / 64);
    assert!(gltf(&file).unwrap_err().message.contains("triangles"), "judged before memory is taken");
    file["accessors"][0]["count"] = json!(4);
    file["accessors"][0]["sparse"]["count"] = json!(5);
    assert!(gltf(&file).is_err(), "more sparse elements than elements");
}

#[test]
fn what_a_file_says_beside_the_shape_does_not_matter() {
    let usual = gltf(&tetrahedron()).unwrap();
    let mut file = tetrahedron();
    file["materials"] = json!([{"alphaMode": "NONE", "pbrMetallicRoughness": 7}]);
    file["images"] = json!([{"uri": "../photo.png"}]);
    file["extras"] = json!({"deep": [[[[]]]]});
    file["meshes"][0]["primitives"][0]["material"] = json!(99);
    file["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(98);
    let latin = file.to_string().replacen("NONE", "N?NE", 1).into_bytes();
    let latin: Vec<u8> = latin.iter().map(|b| if *b == b'?' { 0xe9 } else { *b }).collect();
    assert_eq!(read("piece.gltf", &latin, |_| None).as_ref(), Ok(&usual), "a name that is no UTF-8");
    assert_eq!(read("piece.gltf", format!("\u{feff}{file}").as_bytes(), |_| None), Ok(usual));
}

#[test]
fn errors_of_the_json_name_the_line_or_the_byte() {
    let text = "{\n\"asset\": {\"version\": \"2.0\"},\n\"nodes\": 7\n}";
    let error = read("piece.gltf", text.as_bytes(), |_| None).unwrap_err();
    assert_eq!(error.place, Place::Line(3), "{error}");
    assert!(error.message.contains("column 10"), "{error}");
    let mut file = tetrahedron();
    file["nodes"] = json!("none");
    let bytes = glb(file, b"");
    let place = bytes.windows(6).position(|part| part == b"\"none\"").unwrap();
    match read("piece.glb", &bytes, |_| None).unwrap_err().place {
        Place::Byte(byte) => assert!((place..place + 6).contains(&byte), "{byte} instead of {place}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_binary_file_that_is_cut_off_or_of_version_1_is_named() {
    let whole = glb(tetrahedron(), &[positions(), indices()].concat());
    assert!(read("piece.glb", &whole, |_| None).is_ok());
    for length in [11, 15, 25, whole.len() - 1] {
        let error = read("piece.glb", &whole[..length], |_| None).unwrap_err();
        assert_eq!(error.place, Place::Byte(length), "{error}");
        assert!(error.remedy.contains("its end is missing"), "{error}");
    }
    let mut first = whole.clone();
    first[4] = 1;
    let old = json!({"asset": {"version": "1.0"}, "meshes": {"a": {}}});
    for error in [read("piece.glb", &first, |_| None).unwrap_err(), gltf(&old).unwrap_err()] {
        assert!(error.message.contains("glTF 1.0") && error.remedy.contains("2.0"), "{error}");
    }
}

#[test]
fn as_many_triangles_as_a_file_of_cooked_foods_has_are_read_and_closed() {
    // A ball of rings of rectangles, 40 mm wide, with a pole at either end.
    const ROUND: u32 = 400;
    const RINGS: u32 = 500;
    let angle = |k: u32, n: u32| std::f32::consts::TAU * k as f32 / n as f32;
    let ring = |r: u32| {
        let (height, width) = (angle(r + 1, 2 * (RINGS + 1)).cos(), angle(r + 1, 2 * (RINGS + 1)).sin());
        (0..ROUND).map(move |k| [width * angle(k, ROUND).cos(), width * angle(k, ROUND).sin(), height])
    };
    let corners: Vec<[f32; 3]> =
        (0..RINGS).flat_map(ring).chain([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]).map(|p| p.map(|v| 0.02 * v)).collect();
    let at = |r: u32, k: u32| r * ROUND + k % ROUND;
    let between = (0..RINGS - 1).flat_map(|r| (0..ROUND).map(move |k| (r, k)));
    let sides = between
        .flat_map(|(r, k)| [[at(r, k), at(r + 1, k), at(r, k + 1)], [at(r, k + 1), at(r + 1, k), at(r + 1, k + 1)]]);
    let [top, bottom] = [ROUND * RINGS, ROUND * RINGS + 1];
    let ends =
        (0..ROUND).flat_map(|k| [[top, at(0, k), at(0, k + 1)], [bottom, at(RINGS - 1, k + 1), at(RINGS - 1, k)]]);
    let triangles: Vec<[u32; 3]> = sides.chain(ends).collect();
    let positions: Vec<u8> = corners.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    let indices: Vec<u8> = triangles.iter().flatten().flat_map(|i| i.to_le_bytes()).collect();
    let accessor = json!({"bufferView": 0, "componentType": 5126, "count": corners.len(), "type": "VEC3"});
    let mut file = file(&positions, &indices, accessor);
    file["accessors"][1] =
        json!({"bufferView": 1, "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR"});
    let soup = read("ball.glb", &glb(file, &[positions, indices].concat()), |_| None).unwrap();
    assert_eq!(soup.triangles.len(), 400_000);
    assert!(soup.triangles.len() < MOST_TRIANGLES);
    let volume = Surface::close(&soup, 1.0).unwrap().volume();
    let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.02f64.powi(3);
    assert!((volume / ball - 1.0).abs() < 1e-3, "{volume} m³ instead of {ball} m³");
}
