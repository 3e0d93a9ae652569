//! Promise: a cook is drawn as a sheet of several times or as an animation, and a name that does not fit is refused
//! before anything is cooked.

use crate::running::run;

/// Runs `saute shot medium` with options and an output name; returns the bytes.
fn drawn(options: &[&str], name: &str) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join(name);
    let fixed = ["shot", "medium", "--size", "160x90", "--quality", "quick", "--out", out.to_str().unwrap()];
    let ran = run(&[&fixed, options].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    std::fs::read(out).unwrap()
}

fn pixels(png: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.height, bytes)
}

#[test]
fn a_contact_sheet_holds_the_pictures_of_its_times_in_their_order() {
    let (width, height, sheet) = pixels(&drawn(&["--contact-sheet", "4,1"], "sheet.png"));
    // Two pictures of 160 and a gap of 8.
    assert_eq!((width, height), (328, 90));
    for (column, at) in ["4", "1"].into_iter().enumerate() {
        let (_, _, one) = pixels(&drawn(&["--at", at], "one.png"));
        let rows = sheet.chunks_exact(4 * 328).map(|row| &row[672 * column..672 * column + 640]);
        assert!(rows.zip(one.chunks_exact(640)).all(|(a, b)| a == b), "column {column}");
    }
}

#[test]
fn a_time_lapse_has_a_frame_for_every_step_up_to_the_time() {
    let apng = drawn(&["--time-lapse", "2", "--at", "6"], "film.apng");
    let reader = png::Decoder::new(std::io::Cursor::new(apng)).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 4);
    assert!(drawn(&["--time-lapse", "3", "--at", "3"], "film.gif").starts_with(b"GIF89a"));
}

#[test]
fn a_name_that_does_not_fit_the_pictures_is_refused_with_the_names_that_do() {
    for (options, name, remedy) in [
        (["--at", "1"].as_slice(), "a.jpg", "FILE.png"),
        (&["--contact-sheet", "1,2"], "a", "FILE.png"),
        (&["--time-lapse", "2"], "a.png", "FILE.gif or FILE.apng"),
    ] {
        let ran = run(&[&["shot", "medium", "--out", name], options].concat());
        assert_eq!(ran.code, Some(2), "{name}");
        assert!(ran.err.contains(name) && ran.err.contains(remedy), "{}", ran.err);
    }
}

#[test]
fn too_many_frames_and_a_time_past_the_end_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("a.gif");
    let small = ["shot", "medium", "--size", "64x64", "--quality", "quick", "--out", out.to_str().unwrap()];
    for (options, word) in
        [(["--time-lapse", "0.1", "--at", "500"], "1000"), (["--time-lapse", "900", "--at", "4000"], "past the end")]
    {
        let ran = run(&[&small[..], &options].concat());
        assert!(ran.code == Some(2) && ran.err.contains(word) && ran.err.contains("remedy"), "{}", ran.err);
        assert!(!out.exists());
    }
}

#[test]
fn pictures_that_need_too_much_memory_are_refused_before_anything_is_cooked_with_what_fits() {
    let times: Vec<String> = (0..200).map(|s| s.to_string()).collect();
    let times = times.join(",");
    for (options, out, says) in [
        (["--size", "8192x8192", "--at", "1"].as_slice(), "a.png", ["64 to 4096", "--size"]),
        (&["--size", "4096x4096", "--at", "1"], "a.png", ["at most 3686400 pixels", "900 pixels of height"]),
        (&["--contact-sheet", &times], "a.png", ["at most 32000000", "name at most 3"]),
        (
            &["--time-lapse", "1", "--at", "400", "--size", "2560x1440"],
            "a.gif",
            ["at most 75 of this size", "smaller --size"],
        ),
    ] {
        let ran = run(&[&["shot", "medium", "--out", out], options].concat());
        assert_eq!(ran.code, Some(2), "{options:?}");
        says.iter().for_each(|part| assert!(ran.err.contains(part), "{part}: {}", ran.err));
        assert!(!std::path::Path::new(out).exists());
    }
}
