//! `saute food check`, and cooking a food of the user.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::running::{Ran, SHORT, run};

/// A `--data` folder with a folder `foods`.
struct DataFolder {
    dir: tempfile::TempDir,
}

impl DataFolder {
    fn new() -> Self {
        let dir = tempfile::tempdir().unwrap();
        std::fs::create_dir(dir.path().join("foods")).unwrap();
        Self { dir }
    }

    fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.dir.path().join("foods").join(name);
        std::fs::write(&path, text).unwrap();
        path
    }

    fn data(&self) -> &str {
        self.dir.path().to_str().unwrap()
    }
}

fn check(path: &Path) -> Ran {
    run(&["food", "check", path.to_str().unwrap()])
}

/// Returns the TOML blocks of the page for users.
fn documented() -> Vec<String> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/your-own-food.md");
    let page = std::fs::read_to_string(page).unwrap();
    page.split("```toml\n").skip(1).map(|rest| rest.split("```").next().unwrap().to_owned()).collect()
}

/// A wedge of 50 × 30 × 18 mm.
const WEDGE: &str = "v 0 0 0\nv 50 0 0\nv 50 30 0\nv 0 30 0\nv 0 0 18\nv 50 0 12\nv 50 30 12\nv 0 30 18\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Returns the documented food file with the documented surface instead of sizes and outline.
fn meshed_food() -> String {
    let blocks = documented();
    let shape = blocks.iter().find(|block| block.contains("form = \"mesh\"")).unwrap();
    let whole = &blocks[0];
    let (before, rest) = whole.split_once("form = ").unwrap();
    let rest = &rest[rest.find("[lean]").unwrap()..];
    format!("{before}{shape}\n{rest}")
}

#[test]
fn the_documented_example_is_sound_and_cooks() {
    let folder = DataFolder::new();
    let path = folder.put("salmon.toml", &documented()[0]);
    let ran = check(&path);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    for part in
        ["Salmon fillet: sound", "form steak, length 110.0 mm", "kg/m³", "W/(m·K) at 20 °C", "nodes", "55 °C after"]
    {
        assert!(ran.out.contains(part), "{part}: {}", ran.out);
    }
    let recipe = folder.dir.path().join("recipe.toml");
    std::fs::write(&recipe, SHORT.replace("beef-lean", "salmon")).unwrap();
    let cooked = run(&["cook", recipe.to_str().unwrap(), "--data", folder.data()]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
}

#[test]
fn a_surface_of_the_user_is_sound_and_cooks() {
    let folder = DataFolder::new();
    folder.put("my-piece.obj", WEDGE);
    let path = folder.put("wedge.toml", &meshed_food());
    let ran = run(&["food", "check", path.to_str().unwrap(), "--json"]);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    let verdict: Value = serde_json::from_str(&ran.out).unwrap();
    let food = &verdict["food"];
    assert_eq!((food["form"].as_str(), food["size_mm"][0].as_f64().map(f64::round)), (Some("mesh"), Some(50.0)));
    assert!((2000..10_000).contains(&food["nodes"].as_u64().unwrap()), "{food}");
    let (volume, density) = (food["surface"]["volume_cm3"].as_f64().unwrap(), food["density_kg_m3"].as_f64().unwrap());
    assert!((volume - 22.5).abs() < 1e-6 && (1000.0..1100.0).contains(&density));
    assert!((food["mass_g"].as_f64().unwrap() / (1e-3 * volume * density) - 1.0).abs() < 1e-3);
    let recipe = folder.dir.path().join("recipe.toml");
    std::fs::write(&recipe, SHORT.replace("beef-lean", "wedge").replace("[60, 50, 15]", "[60]")).unwrap();
    let cooked = run(&["cook", recipe.to_str().unwrap(), "--data", folder.data(), "--json"]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
    let summary: Value = serde_json::from_str(&cooked.out).unwrap();
    let piece = &summary["foods"][0];
    assert!(summary.to_string().contains("wedge"), "{piece}");
}

#[test]
fn mistakes_are_reported_with_line_meaning_and_remedy() {
    let folder = DataFolder::new();
    let sound = documented()[0].clone();
    for (from, to, parts) in [
        ("emissivity = 0.95", "emissivty = 0.95", ["emissivty is no key", "write emissivity"]),
        ("ripple = 0.02\n", "", ["outline.ripple is missing: amplitude", "write ripple = 0.02"]),
        ("water = 0.685", "water = 0.785", ["add up to 1.1", "mend"]),
        ("kinetics = \"shrimp\" ", "kinetics = \"squid\" ", ["kinetics = \"squid\" is unknown", "shrimp"]),
        ("myosin =", "myosine =", ["\"myosine\"", "myosin"]),
        ("raw = [58.0", "raw = [158.0", ["raw = [158.0, 32.0, 30.0] is no colour", "L* 0 to 100"]),
        ("min_mm = [40.0, 30.0", "min_mm = [140.0, 30.0", ["default_mm = 110 is out of range", "use 140"]),
        ("form = \"steak\" ", "form = \"stake\" ", ["stake", "steak"]),
        ("name = \"Salmon fillet\"", "name = Salmon", ["food.toml:1", "quote"]),
    ] {
        assert!(sound.contains(from), "{from}");
        let ran = check(&folder.put("food.toml", &sound.replacen(from, to, 1)));
        assert_eq!(ran.code, Some(2), "{to}: {}", ran.out);
        assert!(parts.iter().all(|p| ran.out.contains(p)) && ran.out.contains("remedy"), "{to}: {}", ran.out);
    }
}

#[test]
fn an_open_surface_is_reported_alone_and_with_its_food() {
    let folder = DataFolder::new();
    let open: String = WEDGE.lines().take(12).map(|l| format!("{l}\n")).collect();
    let surface = folder.put("my-piece.obj", &open);
    let food = folder.put("wedge.toml", &meshed_food());
    for path in [&surface, &food] {
        let ran = check(path);
        assert_eq!(ran.code, Some(2), "{}", ran.out);
        assert!(ran.out.contains("not closed") && ran.out.contains("fill the holes"), "{}", ran.out);
    }
    let listed = run(&["list", "foods", "--data", folder.data()]);
    assert!(listed.code == Some(0) && listed.err.contains("not closed"), "{}", listed.err);
    std::fs::remove_file(&surface).unwrap();
    let ran = check(&food);
    assert!(ran.code == Some(2) && ran.out.contains("my-piece.obj cannot be read"), "{}", ran.out);
    folder.put("my-piece.obj", WEDGE);
    assert!(check(&surface).out.contains("22.50 cm³"));
}

#[test]
fn the_unit_of_a_surface_on_its_own_is_an_option() {
    let folder = DataFolder::new();
    let metres = folder.put(
        "piece.obj",
        &WEDGE.replace("50", "0.05").replace("30", "0.03").replace("18", "0.018").replace("12", "0.012"),
    );
    let ran = check(&metres);
    assert!(ran.code == Some(2) && ran.out.contains("--scale-mm 1000 for metres"), "{}", ran.out);
    let with = |scale: &str, path: &Path| run(&["food", "check", path.to_str().unwrap(), "--scale-mm", scale]);
    let ran = with("1000", &metres);
    assert!(ran.code == Some(0) && ran.out.contains("22.50 cm³"), "{}{}", ran.out, ran.err);
    for wrong in ["0", "-1", "nan", "inf", "1e308", "wide"] {
        let ran = with(wrong, &metres);
        assert!(ran.code == Some(2) && ran.err.contains("--scale-mm"), "{wrong}: {}", ran.err);
    }
    let food = folder.put("salmon.toml", &documented()[0]);
    assert!(with("10", &food).err.contains("write scale_mm under [mesh]"), "{}", with("10", &food).err);
}

#[test]
fn an_error_of_a_surface_names_its_line_or_its_byte_alone_and_with_its_food() {
    let folder = DataFolder::new();
    let surface = folder.put("my-piece.obj", &WEDGE.replace("v 50 30 0", "v 50,0 30 0"));
    let ran = check(&surface);
    assert!(ran.code == Some(2) && ran.out.contains("my-piece.obj:3: \"50,0\" has a comma"), "{}", ran.out);
    let ran = check(&folder.put("wedge.toml", &meshed_food()));
    assert!(ran.code == Some(2) && ran.out.contains("my-piece.obj:3 \"50,0\" has a comma"), "{}", ran.out);
    let binary = folder.put("piece.stl", "");
    std::fs::write(&binary, [&[0; 80][..], &9u32.to_le_bytes(), &[0; 100]].concat()).unwrap();
    assert!(check(&binary).out.contains("byte 184: ends before"), "{}", check(&binary).out);
}

#[test]
fn a_missing_file_is_reported() {
    let ran = check(Path::new("nowhere.toml"));
    assert!(ran.code == Some(2) && ran.err.contains("nowhere.toml"), "{}", ran.err);
}
