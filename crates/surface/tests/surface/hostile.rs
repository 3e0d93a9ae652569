//! Promise: no surface file makes the reader panic, hang or take much memory; each found case (fuzz/found) gives an error that states why.

use std::time::Duration;

use saute_fixtures::processor;
use saute_heat::Surface;
use saute_heat::mesh::surface::MOST_TRIANGLES;
use saute_surface::{ReadError, Soup, read};

/// Longest time of the processor that a small file may take [s].
const LONGEST: Duration = Duration::from_secs(1);

fn fixture(name: &str) -> Vec<u8> {
    let format = if name.ends_with(".obj") { "obj" } else { "gltf" };
    std::fs::read(format!("{}/../../fuzz/found/{format}/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn plain(name: &str, bytes: &[u8]) -> Result<Soup, ReadError> {
    read(name, bytes, |_| None)
}

/// Reads a file and closes its surface, within the time limit.
fn outcome(name: &str, bytes: &[u8]) -> Result<Surface, String> {
    let (surface, took) = processor::of_thread(|| {
        let soup = plain(name, bytes).map_err(|e| e.message)?;
        Surface::close(&soup, 1e-3 * soup.unit_mm).map_err(|e| e.to_string())
    });
    assert!(took < LONGEST, "{name} took {took:?}");
    surface
}

#[test]
fn every_found_case_is_refused_with_its_reason() {
    let cases = [
        ("one-point.obj", "triangles without area: 1"),
        ("index-before-the-first.obj", "refers to texture coordinate -11, but contains 1"),
        ("length-below-its-header.glb", "states a length of 0 bytes, less than its header"),
        ("doubled-nodes.gltf", "has two parents"),
        ("doubled-nodes-without-mesh.gltf", "has two parents"),
        ("signed-indices.gltf", "accessor 1 has a type that glTF does not permit there"),
        ("overlapping-positions.gltf", "accessor 0 reaches beyond its buffer, or its elements overlap"),
    ];
    for (name, reason) in cases {
        let refused = outcome(name, &fixture(name));
        assert!(refused.as_ref().is_err_and(|e| e.contains(reason)), "{name}: {refused:?}");
    }
}

#[test]
fn triangles_that_all_weld_away_are_without_area_in_every_format() {
    let all_in_one = "v 5 5 5\nv 5 5 5.0000000001\nv 5 5 5\nv 5 5 5\nf 1 2 3\nf 2 3 4\n";
    assert!(outcome("a.obj", all_in_one.as_bytes()).unwrap_err().contains("without area: 2"));
    let mut stl = vec![0; 80];
    stl.extend(1u32.to_le_bytes());
    stl.extend([0; 50]);
    assert!(outcome("a.stl", &stl).unwrap_err().contains("without area"));
}

/// glTF of one triangle of 30 mm, with each of its parts replaceable.
fn gltf(from: &str, to: &str) -> Vec<u8> {
    let text = String::from_utf8(fixture("signed-indices.gltf")).unwrap().replace("5120", "5123");
    assert!(plain("a.gltf", text.as_bytes()).is_ok() && text.contains(from), "{from}");
    text.replace(from, to).into_bytes()
}

#[test]
fn positions_and_indices_have_the_types_that_gltf_permits() {
    let not_permitted = [
        ("5123", "5120"),
        ("5123", "5122"),
        ("5123", "5126"),
        (r#""count": 12, "type": "SCALAR""#, r#""count": 6, "type": "VEC2""#),
        (r#""type": "VEC3""#, r#""type": "VEC2""#),
        ("5126", "5121"),
    ];
    for (from, to) in not_permitted {
        assert!(outcome("a.gltf", &gltf(from, to)).is_err(), "{to}");
    }
}

#[test]
fn numbers_that_overflow_or_reach_outside_are_refused() {
    let most = u64::MAX.to_string();
    let changes = [
        (r#""count": 4"#, format!(r#""count": {most}"#)),
        (r#""count": 4"#, r#""count": 5"#.to_owned()),
        (r#""byteOffset": 48"#, format!(r#""byteOffset": {most}"#)),
        (r#""byteLength": 48"#, format!(r#""byteLength": {most}"#)),
        (r#""byteLength": 72"#, format!(r#""byteLength": {most}"#)),
        (r#""byteLength": 48"#, r#""byteLength": 48, "byteStride": 4"#.to_owned()),
        (r#""byteLength": 48"#, r#""byteLength": 48, "byteStride": 255"#.to_owned()),
    ];
    for (from, to) in changes {
        assert!(outcome("a.gltf", &gltf(from, &to)).is_err(), "{to}");
    }
}

#[test]
fn nodes_that_contain_themselves_or_nest_without_end_are_refused() {
    let chain: Vec<String> = (1..5000).map(|i| format!(r#"{{"children": [{i}]}}"#)).collect();
    for nodes in [
        r#"{"children": [0]}"#.to_owned(),
        r#"{"children": [1]}, {"children": [0]}"#.to_owned(),
        format!(r#"{}, {{"mesh": 0}}"#, chain.join(", ")),
    ] {
        assert!(outcome("a.gltf", &gltf(r#"{"mesh": 0}"#, &nodes)).is_err());
    }
}

#[test]
fn a_body_with_too_many_triangles_is_refused_before_it_is_stored() {
    // One mesh of twice four triangles in many nodes.
    let nodes = vec![r#"{"mesh": 0}"#; 90_000].join(",");
    let all: Vec<String> = (0..90_000).map(|i| i.to_string()).collect();
    let text = String::from_utf8(gltf(r#"{"mesh": 0}"#, &nodes)).unwrap();
    let text =
        text.replace(r#""scenes": [{"nodes": [0]}]"#, &format!(r#""scenes": [{{"nodes": [{}]}}]"#, all.join(",")));
    let primitive = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;
    let text = text.replace(primitive, &[primitive; 2].join(","));
    let too_many = format!("more than {MOST_TRIANGLES} triangles");
    assert!(outcome("a.gltf", text.as_bytes()).unwrap_err().contains(&too_many));
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned() + &"f 1 2 3\n".repeat(MOST_TRIANGLES + 1);
    assert!(outcome("a.obj", obj.as_bytes()).unwrap_err().contains(&too_many));
    let polygon = "v 0 0 0\nf ".to_owned() + &"1 ".repeat(MOST_TRIANGLES + 3);
    assert!(outcome("a.obj", polygon.as_bytes()).unwrap_err().contains(&too_many));
}

#[test]
fn a_gltf_of_many_empty_objects_is_refused_before_it_is_parsed() {
    let many = format!(r#"{{"asset":{{"version":"2.0"}},"nodes":[{}]}}"#, vec!["{}"; 200_000].join(","));
    assert!(plain("a.gltf", many.as_bytes()).unwrap_err().message.contains("objects"));
    let long = format!(r#"{{"asset":{{"version":"2.0"}}}}{}"#, " ".repeat(40 << 20));
    assert!(plain("a.gltf", long.as_bytes()).unwrap_err().message.contains("bytes of JSON"));
}
