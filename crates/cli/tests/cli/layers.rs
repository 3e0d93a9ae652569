//! Promise: dependencies point one way. Every arrow between the crates of the workspace, and from them to the notable crates
//! outside, is stated here; an arrow that is not stated fails, and so does a stated one that does not exist.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

/// Each crate with the crates that it needs directly, of the workspace and of [`NOTABLE`]. A crate that does not exist yet is
/// skipped.
const ARROWS: [(&str, &[&str]); 34] = [
    ("saute-heat", &[]),
    ("saute-files", &[]),
    ("saute-schema", &[]),
    ("saute-food", &["saute-heat", "saute-schema"]),
    ("saute-kitchen", &["saute-schema", "saute-heat", "saute-food", "rapier3d"]),
    ("saute-recipe", &["saute-schema", "saute-food", "saute-kitchen"]),
    ("saute-lab", &["saute-schema", "saute-heat", "saute-food", "saute-kitchen", "saute-recipe"]),
    ("saute-plan", &["saute-schema", "saute-kitchen", "saute-recipe"]),
    ("saute-study", &["saute-schema", "saute-kitchen", "saute-plan", "saute-recipe"]),
    ("saute-formats", &["saute-kitchen", "saute-recipe"]),
    ("saute-sweep", &["saute-schema", "saute-formats", "saute-kitchen", "saute-recipe"]),
    ("saute-sweep-folder", &["saute-files", "saute-formats", "saute-sweep"]),
    ("saute-surface", &["saute-heat"]),
    ("saute-scene", &["wgpu"]),
    ("saute-mirror", &["saute-schema"]),
    ("saute-sound", &[]),
    // What plays: a sound card of this machine, a page's worklet. Neither depends on a kitchen.
    ("saute-speaker", &["saute-sound"]),
    ("saute-sound-page", &["saute-sound"]),
    (
        "saute-session",
        &["saute-schema", "saute-kitchen", "saute-plan", "saute-recipe", "saute-sound", "saute-study", "saute-words"],
    ),
    ("saute-words", &["saute-kitchen", "saute-plan", "saute-recipe", "saute-study"]),
    ("saute-picture", &["saute-schema", "saute-kitchen", "saute-mirror", "saute-recipe", "saute-scene", "wgpu"]),
    (
        "saute-haptics",
        &[
            "saute-files",
            "saute-schema",
            "saute-kitchen",
            "httparse",
            "rcgen",
            "ring",
            "rosc",
            "rustls",
            "serialport",
            "thread-priority",
            "tungstenite",
        ],
    ),
    ("saute-counts", &["saute-kitchen", "saute-recipe", "saute-lab", "saute-picture"]),
    ("saute-soak", &["saute-files", "saute-kitchen", "saute-recipe"]),
    (
        "saute-attack",
        &[
            "saute-schema",
            "saute-haptics",
            "saute-kitchen",
            "saute-lab",
            "saute-mirror",
            "saute-plan",
            "saute-recipe",
            "saute-session",
            "saute-spidar-sim",
            "saute-study",
            "saute-surface",
            "saute-sweep",
            "saute-controls",
            "saute-words",
        ],
    ),
    ("saute-spidar-sim", &["clap", "thread-priority"]),
    // For Python: kitchens on all cores, pictures and sound without a window.
    (
        "saute-python",
        &[
            "saute-files",
            "saute-schema",
            "saute-kitchen",
            "saute-recipe",
            "saute-plan",
            "saute-scene",
            "saute-session",
            "saute-sound",
            "saute-picture",
            "saute-surface",
            "saute-sweep",
            "saute-sweep-folder",
            "rayon",
        ],
    ),
    // For tests alone, and for `./test.sh`.
    ("saute-fixtures", &[]),
    ("saute-xtask", &["clap"]),
    // Makes and serves files; has nothing of the simulator in it.
    ("saute-site", &["axum", "clap", "tokio", "tower-http"]),
    // Empty on this machine's platform; for browsers see WEB.
    ("saute-web", &[]),
    (
        "saute-controls",
        &[
            "saute-files",
            "saute-schema",
            "saute-haptics",
            "saute-kitchen",
            "saute-mirror",
            "saute-picture",
            "saute-plan",
            "saute-recipe",
            "saute-scene",
            "saute-session",
            "saute-study",
            "saute-words",
            "gilrs",
        ],
    ),
    (
        "saute-window",
        &[
            "saute-files",
            "saute-schema",
            "saute-controls",
            "saute-kitchen",
            "saute-recipe",
            "saute-plan",
            "saute-study",
            "saute-words",
            "saute-session",
            "saute-sound",
            "saute-speaker",
            "saute-mirror",
            "saute-scene",
            "saute-picture",
            "saute-haptics",
            "eframe",
            "egui",
            "egui-wgpu",
            "rfd",
            "wgpu",
        ],
    ),
    (
        "saute",
        &[
            "saute-files",
            "saute-schema",
            "saute-formats",
            "saute-kitchen",
            "saute-recipe",
            "saute-lab",
            "saute-plan",
            "saute-sweep",
            "saute-sweep-folder",
            "saute-surface",
            "saute-scene",
            "saute-picture",
            "saute-mirror",
            "saute-study",
            "saute-words",
            "saute-session",
            "saute-sound",
            "saute-haptics",
            "saute-controls",
            "saute-window",
            "clap",
        ],
    ),
];

/// What the page needs in a browser.
const WEB: &[&str] = &[
    "saute-controls",
    "saute-kitchen",
    "saute-recipe",
    "saute-scene",
    "saute-session",
    "saute-study",
    "saute-window",
    "saute-words",
    "eframe",
    "egui",
    "egui-wgpu",
    "wgpu",
];

/// Crates outside the workspace whose arrows are stated, by kind.
const NOTABLE: [&[&str]; 6] = [RIGID_BODIES, GRAPHICS, WINDOW, SOUND, COMMAND_LINE, OUTSIDE_WORLD];
const RIGID_BODIES: &[&str] = &["rapier3d", "parry3d"];
const GRAPHICS: &[&str] = &["wgpu"];
const WINDOW: &[&str] = &["egui", "eframe", "egui-wgpu", "winit", "gilrs", "rfd"];
const SOUND: &[&str] = &["cpal", "rodio", "kira", "fundsp"];
const COMMAND_LINE: &[&str] = &["clap"];
/// Networks, ports, threads and asynchronous runtimes.
const OUTSIDE_WORLD: &[&str] = &[
    "axum",
    "httparse",
    "hyper",
    "mio",
    "rayon",
    "rcgen",
    "reqwest",
    "ring",
    "rosc",
    "rustls",
    "serialport",
    "socket2",
    "thread-priority",
    "tokio",
    "tower-http",
    "tungstenite",
    "ureq",
];

/// The core: a pure function of model, state, commands and time step.
const CORE: [&str; 9] = [
    "saute-heat",
    "saute-food",
    "saute-kitchen",
    "saute-recipe",
    "saute-lab",
    "saute-plan",
    "saute-study",
    "saute-formats",
    "saute-sweep",
];

/// The normal dependencies of every crate, on the platform of this machine.
struct Graph {
    needs: BTreeMap<String, BTreeSet<String>>,
    members: BTreeSet<String>,
}

impl Graph {
    fn read() -> &'static Self {
        static GRAPH: OnceLock<Graph> = OnceLock::new();
        GRAPH.get_or_init(|| Self::new(&metadata()))
    }

    fn new(metadata: &Value) -> Self {
        let list = |value: &Value| value.as_array().unwrap().clone();
        let packages = list(&metadata["packages"]);
        let name_of: BTreeMap<&str, &str> =
            packages.iter().map(|p| (p["id"].as_str().unwrap(), p["name"].as_str().unwrap())).collect();
        let name = |id: &Value| name_of[id.as_str().unwrap()].to_owned();
        let is_normal = |dep: &Value| list(&dep["dep_kinds"]).iter().any(|kind| kind["kind"].is_null());
        let mut needs: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for node in list(&metadata["resolve"]["nodes"]) {
            let deps = list(&node["deps"]).into_iter().filter(is_normal).map(|dep| name(&dep["pkg"]));
            // Versions of one crate are not distinguished.
            needs.entry(name(&node["id"])).or_default().extend(deps);
        }
        Self { needs, members: list(&metadata["workspace_members"]).iter().map(name).collect() }
    }

    /// Returns everything that a crate needs, directly or not.
    fn reached<'a>(&'a self, from: &'a str) -> BTreeSet<&'a str> {
        let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(next) = open.pop() {
            open.extend(self.needs[next].iter().map(String::as_str).filter(|need| reached.insert(*need)));
        }
        reached
    }

    fn assert_reaches_none(&self, from: &[&str], forbidden: &[&[&str]]) {
        for from in from.iter().filter(|name| self.members.contains(**name)) {
            let reached = self.reached(from);
            assert!(reached.len() > 2, "{from} needs only {reached:?}");
            for name in forbidden.concat() {
                assert!(!reached.contains(name), "{from} must not depend on {name}");
            }
        }
    }
}

fn cargo(args: &[&str]) -> String {
    let output = Command::new(env!("CARGO")).args(args).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Reads the dependency graph for the platform of this machine, whose crates are on the disk.
pub fn metadata() -> Value {
    let version = cargo(&["--version", "--verbose"]);
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
    let text = cargo(&["metadata", "--offline", "--format-version", "1", "--filter-platform", host]);
    serde_json::from_str(&text).unwrap()
}

#[test]
fn every_arrow_between_crates_is_stated_and_every_stated_arrow_exists() {
    let graph = Graph::read();
    let stated: BTreeMap<&str, BTreeSet<&str>> =
        ARROWS.iter().map(|(name, needs)| (*name, needs.iter().copied().collect())).collect();
    let is_stated = |name: &&str| graph.members.contains(*name) || NOTABLE.concat().contains(name);
    for member in &graph.members {
        let stated = stated.get(member.as_str()).unwrap_or_else(|| panic!("the arrows of {member} are not stated"));
        let found: BTreeSet<&str> = graph.needs[member].iter().map(String::as_str).filter(is_stated).collect();
        let (new, gone) = (found.difference(stated), stated.difference(&found));
        let (new, gone): (Vec<_>, Vec<_>) = (new.collect(), gone.collect());
        assert!(new.is_empty() && gone.is_empty(), "{member}: not stated {new:?}, stated but absent {gone:?}");
    }
}

/// The crates for browsers need not be on the disk, so the arrows of the page are read from its manifest.
#[test]
fn every_arrow_of_the_page_is_stated_and_every_stated_arrow_exists() {
    let text = cargo(&["metadata", "--offline", "--no-deps", "--format-version", "1"]);
    let packages: Value = serde_json::from_str(&text).unwrap();
    let packages = packages["packages"].as_array().unwrap();
    let web = packages.iter().find(|package| package["name"] == "saute-web").unwrap();
    let needs = web["dependencies"].as_array().unwrap().iter().map(|need| need["name"].as_str().unwrap());
    let is_stated = |name: &&str| name.starts_with("saute-") || NOTABLE.concat().contains(name);
    let found: BTreeSet<&str> = needs.filter(is_stated).collect();
    assert_eq!(found, WEB.iter().copied().collect());
}

#[test]
fn the_core_reaches_no_graphics_no_window_no_sound_no_command_line_and_no_network() {
    Graph::read().assert_reaches_none(&CORE, &[GRAPHICS, WINDOW, SOUND, COMMAND_LINE, OUTSIDE_WORLD]);
    Graph::read().assert_reaches_none(&["saute-heat", "saute-food"], &[RIGID_BODIES]);
}

#[test]
fn pictures_are_rendered_without_a_window() {
    let forbidden = [WINDOW, SOUND, COMMAND_LINE, OUTSIDE_WORLD];
    Graph::read().assert_reaches_none(&["saute-scene", "saute-picture"], &forbidden);
    let above_scene = ["saute-food", "saute-kitchen", "saute-recipe", "saute-lab", "saute-picture", "saute-haptics"];
    Graph::read().assert_reaches_none(&["saute-scene"], &[&above_scene]);
}

#[test]
fn only_the_window_and_its_programs_know_how_panels_are_drawn() {
    let drawing: &[&str] = &["egui", "eframe", "egui-wgpu", "winit", "rfd"];
    let without = [
        "saute-attack",
        "saute-controls",
        "saute-mirror",
        "saute-session",
        "saute-study",
        "saute-words",
        "saute-python",
    ];
    Graph::read().assert_reaches_none(&without, &[drawing]);
}

#[test]
fn haptics_reach_no_shell_and_the_simulator_shares_no_code_with_its_driver() {
    let shells = ["saute-recipe", "saute-lab", "saute-scene", "saute-picture", "saute-window", "saute"];
    Graph::read().assert_reaches_none(&["saute-haptics"], &[GRAPHICS, WINDOW, SOUND, COMMAND_LINE, &shells]);
    Graph::read().assert_reaches_none(&["saute-haptics"], &[&["tokio", "rayon"]]);
    let reached = Graph::read().reached("saute-spidar-sim");
    assert!(!reached.iter().any(|name| name.starts_with("saute")), "{reached:?}");
}

#[test]
fn what_makes_the_page_is_no_part_of_the_simulator() {
    let reached = Graph::read().reached("saute-site");
    assert!(!reached.iter().any(|name| name.starts_with("saute")), "{reached:?}");
}
