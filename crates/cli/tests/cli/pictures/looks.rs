//! Promise: white balance and quality of a picture are chosen on the command line, and the half mirror with its rig.

use crate::running::run;

/// Bytes of a small picture with some options.
fn shot(options: &[&str]) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.png");
    let fixed = ["shot", "medium", "--at", "1", "--size", "160x90", "--out", out.to_str().unwrap()];
    let ran = run(&[&fixed, options].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    std::fs::read(out).unwrap()
}

#[test]
fn another_white_balance_or_quality_draws_another_picture() {
    let usual = shot(&[]);
    assert!(usual == shot(&["--white-balance", "as-shot", "--quality", "smooth"]));
    let others =
        [["--white-balance", "neutral"], ["--white-balance", "warm"], ["--quality", "quick"], ["--quality", "best"]];
    for other in others {
        assert!(shot(&other) != usual, "{other:?}");
    }
}

#[test]
fn exposure_brightens_a_picture_and_blur_softens_what_lies_behind() {
    let [usual, brighter] = ["0", "1"].map(|ev| shot(&["--exposure", ev]));
    assert!(usual == shot(&[]) && brighter != usual);
    let grey = |png: &[u8]| {
        let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
        let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut rgba).unwrap();
        rgba.iter().map(|value| f64::from(*value)).sum::<f64>() / rgba.len() as f64
    };
    assert!(grey(&brighter) > grey(&usual) + 10.0);
    let best = |blur: &str| shot(&["--quality", "best", "--blur", blur]);
    assert!(best("0") != best("4"));
    for (option, value, remedy) in [("--exposure", "9", "-2 to 2"), ("--blur", "nan", "0 (all is sharp) to 4")] {
        let ran = run(&["shot", "medium", "--at", "1", "--out", "never.png", option, value]);
        assert!(ran.code == Some(2) && ran.err.contains(remedy), "{}", ran.err);
    }
}

#[test]
fn samples_of_light_give_a_picture_of_their_own_and_need_the_best_look() {
    let best = ["--quality", "best"];
    let gathered = shot(&[&best[..], &["--samples", "4"]].concat());
    assert!(gathered != shot(&best) && shot(&[&best[..], &["--samples", "1"]].concat()) == shot(&best));
    for (options, remedy) in [
        (&["--samples", "0"][..], "1..=256"),
        (&["--samples", "8"], "add --quality best"),
        (&["--samples", "8", "--quality", "best", "--view", "doneness"], "leave --view or --samples out"),
    ] {
        let ran = run(&[&["shot", "medium", "--at", "1", "--out", "never.png"], options].concat());
        assert!(ran.code == Some(2) && ran.err.contains(remedy), "{}", ran.err);
    }
}

#[test]
fn an_unknown_white_balance_is_refused_and_the_choices_are_named() {
    let ran = run(&["shot", "medium", "--at", "1", "--out", "never.png", "--white-balance", "tungsten"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("as-shot, neutral, cool, warm"), "{}", ran.err);
}

#[test]
fn the_half_mirror_has_pictures_of_its_own_for_every_rig_and_way_of_stereo() {
    let mirror = shot(&["--mirror"]);
    assert!(mirror == shot(&["--mirror", "flat-screen"]), "the rig unless another is named");
    let others = [
        vec![],
        vec!["--mirror", "projector"],
        vec!["--mirror", "--show-pan"],
        vec!["--mirror", "--stereo", "anaglyph"],
        vec!["--mirror", "--stereo", "side-by-side"],
    ];
    for other in others {
        assert!(shot(&other) != mirror, "{other:?}");
    }
}

#[test]
fn a_rig_file_with_a_bad_number_is_refused_with_file_key_and_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("rig.toml");
    let rig = include_str!("../../../../../data/rigs/flat-screen.toml");
    let arguments = ["shot", "medium", "--at", "1", "--out", "never.png", "--mirror", file.to_str().unwrap()];
    std::fs::write(&file, rig.replace("distance_mm = 63.0", "distance_mm = 630.0")).unwrap();
    let ran = run(&arguments);
    assert_eq!(ran.code, Some(2));
    for word in ["rig.toml", "eye.distance_mm", "630", "remedy", "120"] {
        assert!(ran.err.contains(word), "{word}: {}", ran.err);
    }
    std::fs::write(&file, rig.replace("[mirror]", "[miror]")).unwrap();
    let ran = run(&arguments);
    assert!(ran.code == Some(2) && ran.err.contains("rig.toml:") && ran.err.contains("miror"), "{}", ran.err);
}
