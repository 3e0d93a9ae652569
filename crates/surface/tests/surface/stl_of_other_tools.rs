//! Promise: STL as other tools write it is read whole, and each error names the line or the byte.

use saute_surface::{Place, ReadError, Soup, read};

fn stl(bytes: &[u8]) -> Result<Soup, ReadError> {
    read("piece.stl", bytes, |_| None)
}

/// A facet whose corners are shifted along x.
fn facet(x: i32) -> String {
    format!(
        "  facet normal 0 0 0\n    outer loop\n      vertex {x} 0 0\n      vertex {x} 4 0\n      vertex {x} 0 3\n    endloop\n  endfacet\n"
    )
}

fn solid(name: &str, x: i32) -> String {
    format!("solid{name}\n{}endsolid{name}\n", facet(x))
}

fn binary(header: &[u8], count: u32) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    bytes.extend([0, 0, 128, 63].repeat(12).into_iter().chain([0, 0]).cycle().take(50 * count as usize));
    bytes
}

#[test]
fn a_second_solid_is_read_too() {
    let soup = stl((solid(" a", 1) + &solid("", 2) + &solid(" c", 3)).as_bytes()).unwrap();
    let first: Vec<f64> = soup.triangles.iter().map(|t| soup.vertices[t[0] as usize][0]).collect();
    assert_eq!(first, [1.0, 2.0, 3.0]);
}

#[test]
fn words_are_read_in_any_case_and_with_any_white_space() {
    let usual = stl(solid(" a", 1).as_bytes()).unwrap();
    let text = solid(" a", 1);
    for other in [
        text.to_uppercase(),
        text.replace("facet", "Facet").replace("vertex", "VerteX"),
        format!("\u{feff}{text}"),
        format!("\n\n  \t{}\n\n ", text.replace('\n', " \n\n\t")),
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        text.replace("endsolid a\n", "endsolid"),
        text.replace("vertex 1 0 0", "vertex 1E+00 -0.0e+01 .0"),
        text.replace("normal 0 0 0", "normal nan nan nan"),
        text.replace("\n    outer", " outer").replace("\n    endloop\n", " endloop "),
    ] {
        assert_eq!(stl(other.as_bytes()).as_ref(), Ok(&usual), "{other}");
    }
}

#[test]
fn a_name_may_have_any_bytes() {
    let usual = stl(solid("", 1).as_bytes()).unwrap();
    let named = |name: &[u8]| [b"solid ", name, b"\n", facet(1).as_bytes(), b"endsolid ", name, b"\n"].concat();
    for name in [&b"\x93\xf7\x95\x5c"[..], b"caf\xe9", b"facet of endsolid", b"with \0 zero", b"\xff\xfe\xfd"] {
        assert_eq!(stl(&named(name)).as_ref(), Ok(&usual), "{name:?}");
    }
}

#[test]
fn each_error_of_a_text_names_its_line() {
    let text = solid(" a", 1);
    for (from, to, line, says) in [
        ("vertex 1 4 0", "vertex 1,5 4 0", 5, "\"1,5\" has a comma"),
        ("vertex 1 4 0", "vertex 1 4 wide", 5, "\"wide\" is no number"),
        ("vertex 1 4 0", "vertex 1 4 inf", 5, "is no finite number"),
        ("vertex 1 4 0", "vertex 1 1e99 0", 5, "is no finite number"),
        ("vertex 1 4 0", "vertx 1 4 0", 5, "\"vertx\" stands where \"vertex\" is expected"),
        ("vertex 1 4 0", "vertex 1 4", 6, "\"vertex\" is no number"),
        ("    endloop\n", "      vertex 1 1 1\n    endloop\n", 7, "\"vertex\" stands where \"endloop\""),
        ("  endfacet\n", "", 8, "\"endsolid\" stands where \"endfacet\""),
        ("endsolid a\n", "", 9, "the text ends before \"endsolid\""),
        ("endsolid a\n", "endsolid a\nsolid b\n  facet normal 0 0", 11, "the text ends before \"outer\""),
    ] {
        assert!(text.contains(from), "{from}");
        let error = stl(text.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert_eq!(error.place, Place::Line(line), "{to}: {error}");
        assert!(error.message.contains(says) && !error.remedy.is_empty(), "{to}: {error}");
    }
}

#[test]
fn a_binary_file_may_begin_with_solid() {
    assert_eq!(stl(&binary(b"solid made by a scanner", 3)).unwrap().triangles.len(), 3);
}

#[test]
fn each_error_of_a_binary_file_names_its_byte() {
    for header in [&b"made by hand"[..], b"solid made by a scanner"] {
        let whole = binary(header, 3);
        let cut = stl(&whole[..200]).unwrap_err();
        assert_eq!(cut.place, Place::Byte(200), "{cut}");
        assert!(
            cut.message.contains("ends before the 234 bytes") && cut.remedy.contains("its end is missing"),
            "{cut}"
        );
        let long = stl(&[&whole[..], b"more"].concat()).unwrap_err();
        assert_eq!(long.place, Place::Byte(234), "{long}");
        let mut infinite = whole.clone();
        infinite[84 + 50 + 12 + 8..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
        assert_eq!(stl(&infinite).unwrap_err().place, Place::Byte(84 + 50 + 12 + 8));
    }
}

#[test]
fn text_in_utf_16_is_named() {
    let bytes: Vec<u8> = format!("\u{feff}{}", solid(" a", 1)).encode_utf16().flat_map(u16::to_le_bytes).collect();
    let error = stl(&bytes).unwrap_err();
    assert!(error.message.contains("UTF-16") && error.remedy.contains("UTF-8"), "{error}");
}
