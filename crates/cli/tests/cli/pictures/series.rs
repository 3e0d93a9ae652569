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
    assert_eq!((width, height), (320, 90));
    for (column, at) in ["4", "1"].into_iter().enumerate() {
        let (_, _, one) = pixels(&drawn(&["--at", at], "one.png"));
        let rows = sheet.chunks_exact(4 * 320).map(|row| &row[640 * column..640 * (column + 1)]);
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
