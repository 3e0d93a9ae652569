//! Promise: STL, OBJ and glTF files give the triangles they contain, and damaged files give errors without a crash.

use data_encoding::BASE64;
use saute_heat::Surface;
use saute_surface::{Format, ReadError, Soup, read};

/// A tetrahedron with legs of 10 along the axes; its volume is 1000/6.
const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0]];
const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

fn plain(name: &str, bytes: &[u8]) -> Result<Soup, ReadError> {
    read(name, bytes, |_| None)
}

fn volume(soup: &Soup) -> f64 {
    1e9 * Surface::close(soup, 1e-3).unwrap().volume()
}

fn ascii_stl(name: &str) -> Vec<u8> {
    let facet = |f: &[u16; 3]| {
        let corner = |i: &u16| {
            format!("vertex {} {} {}\n", CORNERS[*i as usize][0], CORNERS[*i as usize][1], CORNERS[*i as usize][2])
        };
        format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", f.iter().map(corner).collect::<String>())
    };
    format!("solid{name}\n{}endsolid\n", FACES.iter().map(facet).collect::<String>()).into_bytes()
}

fn binary_stl(header: &[u8]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(4u32.to_le_bytes());
    for f in FACES {
        bytes.extend([0; 12]);
        f.iter().flat_map(|i| CORNERS[*i as usize]).for_each(|v| bytes.extend(v.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn buffer() -> Vec<u8> {
    let corners = CORNERS.iter().flatten().flat_map(|v| v.to_le_bytes());
    corners.chain(FACES.iter().flatten().flat_map(|i| i.to_le_bytes())).collect()
}

/// glTF of the tetrahedron; the outer node doubles it.
fn gltf(uri: &str) -> String {
    let uri = if uri.is_empty() { String::new() } else { format!(r#","uri":"{uri}""#) };
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"children":[1],"scale":[2,2,2]}},{{"mesh":0,"translation":[1,2,3]}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[10,10,10]}},
                     {{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":24}}],
        "buffers":[{{"byteLength":72{uri}}}]}}"#
    )
}

fn glb() -> Vec<u8> {
    let mut json = gltf("").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = buffer();
    let chunk = |kind: &[u8; 4], data: &[u8]| [&(data.len() as u32).to_le_bytes(), &kind[..], data].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &binary)].concat();
    [b"glTF".as_slice(), &2u32.to_le_bytes(), &(12 + chunks.len() as u32).to_le_bytes(), &chunks].concat()
}

#[test]
fn stl_is_read_as_text_and_binary_independent_of_its_header() {
    for bytes in [ascii_stl(" tetra"), ascii_stl(""), binary_stl(b"made by hand"), binary_stl(b"solid tetra")] {
        let soup = plain("A.STL", &bytes).unwrap();
        assert_eq!((soup.triangles.len(), soup.vertices.len()), (4, 12));
        assert!((volume(&soup) - 1000.0 / 6.0).abs() < 1e-6);
    }
}

#[test]
fn obj_is_read_with_polygons_triangulated_and_materials_ignored() {
    let cube = "mtllib none.mtl\no cube\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n\
        vn 0 0 1\nusemtl skin\nf 4 3 2 1\nf 5//1 6//1 7//1 8//1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf -8 -4 -1 -5\n";
    let soup = plain("cube.obj", cube.as_bytes()).unwrap();
    assert_eq!(soup.triangles.len(), 12);
    assert!((volume(&soup) - 1000.0).abs() < 1e-6);
}

#[test]
fn gltf_is_read_from_all_kinds_of_buffers_and_rotated_to_z_up() {
    let inline = data_uri(&BASE64.encode(&buffer()));
    let beside = |name: &str| (name == "piece.bin").then(buffer);
    let soups = [
        plain("a.glb", &glb()).unwrap(),
        plain("a.gltf", gltf(&inline).as_bytes()).unwrap(),
        read("a.gltf", gltf("piece.bin").as_bytes(), beside).unwrap(),
    ];
    for soup in &soups {
        assert!((volume(soup) - 8000.0 / 6.0).abs() < 1e-4, "{}", volume(soup));
        assert_eq!(soup.vertices[0], [2.0, -6.0, 4.0], "moved by (1, 2, 3), doubled, rotated from y up to z up");
    }
    assert!(soups.iter().all(|s| s.unit_mm == 1000.0), "glTF is in metres");
    assert_eq!((Format::of("x.GLB"), plain("x.stl", &binary_stl(b"")).unwrap().unit_mm), (Some(Format::Gltf), 1.0));
}

fn data_uri(base64: &str) -> String {
    format!("data:application/octet-stream;base64,{base64}")
}

#[test]
fn only_canonical_padded_base64_is_read() {
    let read = |base64: &str| plain("a.gltf", gltf(&data_uri(base64)).as_bytes());
    // The buffer has 72 bytes, a multiple of three; two more bytes make padding necessary.
    let padded = BASE64.encode(&[buffer(), vec![7, 7]].concat());
    assert!(padded.ends_with('=') && read(&padded).is_ok());
    let unpadded = padded.trim_end_matches('=');
    assert!(read(unpadded).is_err(), "padding is missing");
    assert!(read(&format!("{unpadded}==")).is_err(), "too much padding");
    assert!(read(&format!("{padded}====")).is_err(), "a block of padding");
    assert!(read(&format!("{padded}{padded}")).is_err(), "padding in the middle");
    let last = unpadded.len() - 1;
    assert!(read(&format!("{}d=", &unpadded[..last])).is_err(), "trailing bits are not zero");
    assert!(read(&format!(" {padded}")).is_err(), "white space");
    assert!(read(&padded.replacen('/', "_", 1).replacen('A', "-", 1)).is_err(), "the URL alphabet");
}

#[test]
fn a_missing_buffer_is_named() {
    let error = plain("a.gltf", gltf("piece.bin").as_bytes()).unwrap_err();
    assert!(error.message.contains("piece.bin") && error.remedy.contains(".glb"), "{error:?}");
}

#[test]
fn truncated_and_random_files_give_errors() {
    let whole: [(&str, Vec<u8>); 5] = [
        ("a.stl", binary_stl(b"x")),
        ("a.stl", ascii_stl(" t")),
        ("a.glb", glb()),
        ("a.gltf", gltf("").into_bytes()),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec()),
    ];
    for (name, bytes) in &whole {
        for cut in [0, 1, 20, 83, bytes.len() / 2, bytes.len() - 1] {
            // A truncated file may still be valid; it must not cause a crash.
            let _ = plain(name, &bytes[..cut.min(bytes.len())]);
        }
        assert!(plain(name, &bytes[..bytes.len() / 2]).is_err(), "{name}");
        assert!(plain(name, b"").is_err() && plain(name, &[0xff; 300]).is_err(), "{name}");
    }
    assert!(plain("a.obj", b"v 0 0 0\nf 1 2 7\n").unwrap_err().message.contains("refers to vertex 7, but contains 1"));
    assert!(plain("a.obj", b"v 0 0 0\n").unwrap_err().message.contains("no triangle"));
    assert!(plain("a.ply", b"ply").unwrap_err().remedy.contains(".stl"));
}

#[test]
fn indices_out_of_range_are_an_error() {
    let wild = gltf("piece.bin");
    let beside = |_: &str| {
        let mut bytes = buffer();
        bytes[48] = 200;
        Some(bytes)
    };
    let error = read("a.gltf", wild.as_bytes(), beside).unwrap_err();
    assert!(error.message.contains("corner 200 of 4"), "{error:?}");
}
