//! Promise: OBJ as other tools write it is read whole, and each error names the line.

use saute_surface::{Place, ReadError, Soup, read};

fn obj(bytes: &[u8]) -> Result<Soup, ReadError> {
    read("piece.obj", bytes, |_| None)
}

const TETRAHEDRON: &str = "v 0 0 0\nv 7 0 0\nv 0 7 0\nv 0 0 7\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn a_mark_of_utf_8_loses_no_vertex() {
    assert_eq!(obj(format!("\u{feff}{TETRAHEDRON}").as_bytes()), obj(TETRAHEDRON.as_bytes()));
}

#[test]
fn names_may_have_any_bytes_even_a_backslash_at_the_end() {
    let usual = obj(TETRAHEDRON.as_bytes()).unwrap();
    // The second letter of the first name ends with the byte of a backslash in Shift-JIS.
    for name in [&b"\x93\xf7\x95\x5c"[..], b"caf\xe9", b"\xff\xfe"] {
        for word in [&b"o "[..], b"g ", b"usemtl ", b"mtllib ", b"# "] {
            let bytes = [word, name, b"\n", TETRAHEDRON.as_bytes()].concat();
            assert_eq!(obj(&bytes).as_ref(), Ok(&usual), "{name:?}");
        }
    }
}

#[test]
fn continued_lines_comments_and_line_ends_of_all_systems_are_read() {
    let usual = obj(TETRAHEDRON.as_bytes()).unwrap();
    for other in [
        TETRAHEDRON.replace("v 7 0 0", "v 7 \\\n  0 \\\n 0").replace("f 1 3 2", "f 1\\\n 3 2"),
        TETRAHEDRON.replace("f 1 3 2", "f 1 \\\r\n3 \\\r\n2"),
        TETRAHEDRON.replace('\n', "\r\n"),
        TETRAHEDRON.replace('\n', "\r"),
        TETRAHEDRON.replace("v 7 0 0", " \t v\t7.0   0e0 +0 # a corner"),
        format!("# made by hand\n\n{TETRAHEDRON}\n\n"),
        TETRAHEDRON.replace("v 0 7 0", "v 0 14 0 2"),
        TETRAHEDRON.replace("v 0 7 0", "v 0 7 0 0.5 0.5 0.5"),
        format!("vp 0.1\ncstype bezier\nvn 0 0 1\n{TETRAHEDRON}l 1 2\np 1\n"),
    ] {
        assert_eq!(obj(other.as_bytes()).as_ref(), Ok(&usual), "{other}");
    }
}

#[test]
fn corners_are_read_in_all_forms_and_polygons_as_fans() {
    let corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 3 0\nv 0 2 0\nvt 0 0\nvn 0 0 1\n";
    for face in
        ["1 2 3 4 5", "1/1 2/1 3/1 4/1 5/1", "1//1 2//1 3//-1 4//1 5//1", "-5/-1/-1 -4/1/1 -3/1/1 -2/1/1 -1/1/1"]
    {
        let soup = obj(format!("{corners}f {face}\n").as_bytes()).unwrap();
        assert_eq!(soup.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]], "{face}");
    }
}

#[test]
fn several_objects_are_read_with_their_own_corners() {
    let two = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n";
    let soup = obj(two.as_bytes()).unwrap();
    assert_eq!((soup.triangles.len(), soup.vertices.len(), soup.vertices[3][0]), (2, 6, 5.0));
}

#[test]
fn each_error_names_its_line() {
    for (from, to, line, says) in [
        ("v 0 7 0", "v 0 7,5 0", 3, "\"7,5\" has a comma"),
        ("v 0 7 0", "v 0 7", 3, "2 of its 3 coordinates"),
        ("v 0 7 0", "v 0 high 0", 3, "\"high\" is no number"),
        ("v 0 7 0", "v 0 \\\n 1e999 0", 4, "is no finite number"),
        ("v 0 7 0", "v 0 7 0 0", 3, "no weight"),
        ("f 1 4 3", "f 1 4 9", 7, "refers to vertex 9, but contains 4"),
        ("f 1 4 3", "f 1 4 0", 7, "refers to vertex 0, but contains 4"),
        ("f 1 4 3", "f 1 4 -5", 7, "refers to vertex -5, but contains 4"),
        ("f 1 4 3", "f 1/2 4 3", 7, "refers to texture coordinate 2, but contains 0"),
        ("f 1 4 3", "f 1 4 9223372036854775807", 7, "refers to vertex 9223372036854775807"),
        ("f 1 4 3", "f 1 4 three", 7, "\"three\" is no corner"),
        ("f 1 4 3", "f 1 4 \\\n/1", 8, "\"/1\" is no corner"),
    ] {
        assert!(TETRAHEDRON.contains(from), "{from}");
        let error = obj(TETRAHEDRON.replace(from, to).as_bytes()).unwrap_err();
        assert_eq!(error.place, Place::Line(line), "{to}: {error}");
        assert!(error.message.contains(says) && !error.remedy.is_empty(), "{to}: {error}");
    }
}
