//! Promise: the layers of the house stay apart: `heat` and `food` reach no window, graphics, sound, rigid bodies,
//! command line or async runtime, and depend only on what lies below them.

use std::process::Command;

/// Crates that belong to the shells.
const SHELLS: [&str; 14] = [
    "wgpu",
    "egui",
    "eframe",
    "winit",
    "rapier3d",
    "parry3d",
    "cpal",
    "fundsp",
    "clap",
    "tokio",
    "rayon",
    "gilrs",
    "saute-app",
    "saute",
];

fn dependencies(package: &str) -> Vec<String> {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--prefix", "none", "--edges", "normal", "--format", "{p}", "--package", package])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo tree");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

fn reaches(package: &str, forbidden: &[&str]) {
    let found = dependencies(package);
    assert!(found.len() > 2, "cargo tree listed only {found:?}");
    for name in forbidden {
        assert!(!found.iter().any(|f| f == name), "{package} must not depend on {name}");
    }
}

#[test]
fn heat_knows_no_food_and_no_shell() {
    reaches("saute-heat", &SHELLS);
    reaches("saute-heat", &["saute-food", "saute-kitchen"]);
}

#[test]
fn food_knows_no_kitchen_and_no_shell() {
    reaches("saute-food", &SHELLS);
    reaches("saute-food", &["saute-kitchen"]);
}

#[test]
fn the_kitchen_knows_no_shell() {
    reaches("saute-kitchen", &["wgpu", "egui", "eframe", "winit", "clap", "tokio", "rayon", "saute-app", "saute"]);
}

#[test]
fn haptics_know_no_shell_and_the_simulator_shares_no_code_with_its_driver() {
    reaches("saute-haptics", &["wgpu", "egui", "eframe", "winit", "clap", "tokio", "rayon", "saute-app", "saute"]);
    reaches("saute-spidar-sim", &["saute-haptics", "saute-kitchen", "saute-food", "saute-heat"]);
}
