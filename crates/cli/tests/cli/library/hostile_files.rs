//! Promise: no file makes the command hang, write commands to the terminal, or read outside the folder of a surface.

use std::time::Duration;

use saute_fixtures::processor;

use crate::running::{Ran, SHORT, run};

/// Longest time of the processor for a small file (chosen: a slow machine).
const LONGEST: Duration = Duration::from_secs(20);

fn fixture(name: &str) -> String {
    format!("{}/../../fuzz/found/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Returns true if a text contains a character that a terminal obeys.
fn commands_terminal(text: &str) -> bool {
    text.chars().any(|c| c.is_control() && c != '\n' && c != '\t')
}

fn cook(text: &str) -> Ran {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("recipe.toml");
    std::fs::write(&path, text).unwrap();
    run(&["cook", path.to_str().unwrap()])
}

#[test]
fn a_lab_case_with_a_subnormal_grading_does_not_hang() {
    let (ran, took) = processor::of_programs(|| run(&["lab", &fixture("lab/grading-subnormal.toml")]));
    assert!(took < LONGEST, "{took:?}");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn a_lab_case_that_would_run_for_years_is_refused_before_it_begins() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("years.toml");
    let text = std::fs::read_to_string(fixture("lab/grading-subnormal.toml")).unwrap();
    let text = text.replace("duration_s = 1\n", "duration_s = 1e7\n");
    let text =
        text.replace("output_every_s = 1", "output_every_s = 1e6").replace("resolution_mm = 2", "resolution_mm = 1e-3");
    std::fs::write(&path, text).unwrap();
    let ran = run(&["lab", path.to_str().unwrap()]);
    assert!(ran.code == Some(2) && ran.err.contains("node steps") && ran.err.contains("remedy"), "{}", ran.err);
}

#[test]
fn the_steps_of_thin_layers_of_food_are_counted_before_they_are_done() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("thin.toml");
    let text = "duration_s = 1e5\n[body]\nshape = \"slab\"\nsize_mm = [10]\nresolution_mm = 1e-3\ngrading = 3\ninitial_c = 5\n\
        [material]\nfood = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n\
        [[boundary]]\nface = \"all\"\nh_w_m2k = 500\nambient_c = 90\n";
    std::fs::write(&path, text).unwrap();
    let (ran, took) = processor::of_programs(|| run(&["lab", path.to_str().unwrap()]));
    assert!(ran.code == Some(2) && ran.err.contains("node steps") && ran.err.contains("remedy"), "{}", ran.err);
    assert!(took < LONGEST, "{took:?}");
}

#[test]
fn control_characters_of_a_file_are_shown_as_escapes() {
    let refused = run(&["cook", &fixture("recipe/terminal-commands.toml")]);
    assert_eq!(refused.code, Some(2));
    assert!(!commands_terminal(&refused.err) && refused.err.contains("\\u001b[31mX"), "{:?}", refused.err);
    let cooked = cook(&SHORT.replace("\"Short\"", r#""\u001b]0;pwned\u0007\u202eShort""#));
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
    assert!(
        !commands_terminal(&cooked.out) && cooked.out.contains("\\u001b]0;pwned\\u0007\\u202eShort"),
        "{}",
        cooked.out
    );
}

#[test]
fn a_long_echo_is_shortened() {
    let long = "x".repeat(1_000_000);
    for text in [
        SHORT.replace("carbon-steel-26", &long),
        SHORT.replace("beef-lean", &long),
        SHORT.replace("hob_w", &long),
        format!("{long} = 1\n{SHORT}"),
    ] {
        let ran = cook(&text);
        assert_eq!(ran.code, Some(2));
        assert!(ran.err.len() < 3000 && ran.err.contains('…'), "{} bytes", ran.err.len());
    }
}

#[test]
fn a_gltf_reads_no_buffer_from_outside_its_folder_and_none_that_is_no_file() {
    let dir = tempfile::tempdir().unwrap();
    let inner = dir.path().join("inner");
    std::fs::create_dir_all(inner.join("folder.bin")).unwrap();
    let buffer = [0; 72];
    std::fs::write(dir.path().join("outside.bin"), buffer).unwrap();
    std::fs::write(inner.join("inside.bin"), buffer).unwrap();
    let check = |uri: &str| {
        let text = GLTF.replace("URI", uri);
        std::fs::write(inner.join("piece.gltf"), text).unwrap();
        run(&["food", "check", inner.join("piece.gltf").to_str().unwrap()]).out
    };
    assert!(check("inside.bin").contains("without area"), "it is read: {}", check("inside.bin"));
    let absolute = dir.path().join("outside.bin");
    let mut outside =
        vec!["../outside.bin", absolute.to_str().unwrap(), "folder.bin", "/dev/zero", "../inner/../outside.bin"];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&absolute, inner.join("link.bin")).unwrap();
        assert!(std::process::Command::new("mkfifo").arg(inner.join("pipe.bin")).status().unwrap().success());
        outside.extend(["link.bin", "pipe.bin"]);
    }
    for uri in outside {
        let out = check(uri);
        assert!(out.contains("no file in the same folder"), "{uri}: {out}");
    }
}

/// glTF of four triangles whose corners are all zero.
const GLTF: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[0,0,0]},
                 {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
    "buffers":[{"byteLength":72,"uri":"URI"}]}"#;
