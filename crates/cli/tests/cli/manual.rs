//! Promise: shells complete the command, the manual describes it, and the window never opens with a mistyped device.

use crate::running::run;

#[test]
fn every_shell_gets_completions_that_know_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = run(&["completions", shell]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert!(["cook", "shot", "haptics", "contact-sheet"].iter().all(|word| ran.out.contains(word)), "{shell}");
    }
    assert_eq!(run(&["completions", "cmd"]).code, Some(2));
}

#[test]
fn the_manual_has_a_page_for_the_command_and_for_those_below_it() {
    let page = run(&["man"]).out;
    assert!(page.contains(".TH SAUTE") && page.contains("Cooks a recipe without a window"), "{page}");
    let page = run(&["man", "bench", "frame"]).out;
    assert!(page.contains(".TH SAUTE-BENCH-FRAME"), "{page}");
    let ran = run(&["man", "bake"]);
    assert!(
        ran.code == Some(2) && ran.err.contains("there is no such command") && ran.err.contains("cook"),
        "{}",
        ran.err
    );
}

#[test]
fn a_mistyped_device_is_refused_before_the_window_opens() {
    for args in [["--device", "spidar-pot"], ["--turner", "spidar-pot"]] {
        let ran = run(&args);
        assert_eq!(ran.code, Some(2));
        assert!(ran.err.contains("there is no such device") && ran.err.contains("spidar-pan"), "{}", ran.err);
        assert!(!ran.err.contains("display"), "{}", ran.err);
    }
}
