//! Promise: white balance and quality of a picture are chosen on the command line.

use crate::running::run;

/// Bytes of a small picture with some options.
fn shot(options: &[&str]) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.png");
    let fixed = ["shot", "medium", "--at", "1", "--size", "160x90", "--out", out.to_str().unwrap()];
    let said = run(&[&fixed, options].concat());
    assert_eq!(said.code, Some(0), "{}", said.err);
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
fn an_unknown_white_balance_is_refused_and_the_choices_are_named() {
    let said = run(&["shot", "medium", "--at", "1", "--out", "never.png", "--white-balance", "tungsten"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("as-shot, neutral, cool, warm"), "{}", said.err);
}
