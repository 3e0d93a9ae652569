//! Exit codes, and the output of a stopped cook.

use crate::cook::cooked::cook;
use crate::running::{SHORT, run, saute};

#[test]
fn a_recipe_that_still_waits_at_max_s_stops_there_with_its_output_and_exit_code_1() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("long.toml");
    std::fs::write(&path, SHORT.replace("max_s = 100", "max_s = 15")).unwrap();
    let stopped = cook(path.to_str().unwrap());
    assert_eq!(stopped.ran.code, Some(1));
    assert_eq!(stopped.summary["stopped_by"], "max_s");
    assert_eq!(stopped.summary["waiting_step"], 4);
    assert!((stopped.number("/simulated_s") - 15.0).abs() < 1e-9);
    assert!(stopped.files.contains_key("report.html") && stopped.files.contains_key("series.csv"));
    assert!(
        stopped.ran.err.contains("long.toml:18: step 4") && stopped.ran.err.contains("remedy"),
        "{}",
        stopped.ran.err
    );
}

#[test]
fn wrong_usage_exits_with_2_and_speaks_on_stderr() {
    for args in [
        vec!["cook"],
        vec!["--nonsense"],
        vec!["list", "spoons"],
        vec!["shot", "medium", "--at", "-5", "--out", "x.png"],
    ] {
        let ran = run(&args);
        assert_eq!(ran.code, Some(2), "{args:?}");
        assert!(ran.out.is_empty() && !ran.err.is_empty(), "{args:?}: {ran:?}");
    }
}

#[test]
fn help_and_version_go_to_stdout() {
    for args in [["--help"], ["--version"]] {
        let ran = run(&args);
        assert_eq!(ran.code, Some(0), "{args:?}");
        assert!(ran.out.contains("saute") && ran.err.is_empty());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_display_the_program_says_so_and_names_cook_and_shot() {
    for args in [vec![], vec!["open", "medium"]] {
        let output = saute().args(&args).output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        for part in ["no display", "saute cook", "saute shot"] {
            assert!(err.contains(part), "{args:?}: {err}");
        }
    }
}
