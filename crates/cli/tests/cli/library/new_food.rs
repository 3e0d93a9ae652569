//! Promise: a food is added by files of data alone: it cooks, is drawn, is planned, has a goal, and feels as its own words say.

use std::path::Path;

use serde_json::Value;

use crate::running::{Ran, run};

const RECIPE: &str = r#"title = "Halibut"
max_s = 300
[pan]
kind = "carbon-steel-26"
initial_c = 180
[[food]]
id = "fish"
kind = "halibut"
size_mm = [50, 40, 10]
[[step]]
hob_w = 600
[[step]]
put = "fish"
[[step]]
when = { food = "fish", core_c = 50 }
end = true
"#;

/// Its own words of doneness.
const DONENESS: &str = r#"
[doneness]
id = "halibut"
name = "Halibut"
names = { ja = "おひょう" }
class = [
  { name = "limp", names = { ja = "生" }, from_c = 0.0 },
  { name = "pearly", names = { ja = "つや" }, from_c = 46.0 },
  { name = "chalky", names = { ja = "ぱさぱさ" }, from_c = 60.0 },
]
for_change = "myosin"
goal = 52.0
source = "chosen: for this test"
confidence = "low"
"#;

const GOAL: &str = r#"
[[goal]]
id = "halibut"
name = "Halibut, pearly"
names = { ja = "つやのあるおひょう" }
kinetics = ["halibut"]
counts = "section"
scale = "halibut"
class = "pearly"
core_counts = true
least_share_pct = 1.0
crust_pct = 0.0
most_charred_pct = 50.0
source = "chosen: for this test"
confidence = "low"
"#;

/// Files of a food that the program does not know: flesh and kinetics of cod under other names, words and doneness of its own.
fn folder() -> tempfile::TempDir {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let text = |name: &str| std::fs::read_to_string(data.join(name)).unwrap();
    let dir = tempfile::tempdir().unwrap();
    ["foods", "kinetics"].iter().for_each(|name| std::fs::create_dir(dir.path().join(name)).unwrap());
    let cod = text("foods/cod-fillet.toml");
    let flesh = &cod[cod.find("[served]").unwrap()..];
    let words = "[words.en]\nnoun = \"halibut\"\nfeel = [{ from_c = 0.0, says = \"Soft.\" }]\n\
        [words.ja]\nname = \"おひょう\"\nnoun = \"おひょう\"\n";
    let head = format!("name = \"Halibut\"\nkinetics = \"halibut\"\nform = \"steak\"\nflesh = \"flakes\"\n{words}");
    std::fs::write(dir.path().join("foods/halibut.toml"), format!("{head}{DONENESS}\n{flesh}")).unwrap();
    std::fs::write(dir.path().join("kinetics/halibut.toml"), text("kinetics/cod.toml")).unwrap();
    std::fs::write(dir.path().join("goals.toml"), text("goals.toml") + GOAL).unwrap();
    std::fs::write(dir.path().join("halibut-recipe.toml"), RECIPE).unwrap();
    dir
}

/// Runs a command with that folder; nothing is warned of.
fn with_it(folder: &Path, args: &[&str]) -> Ran {
    let ran = run(&[args, &["--data", folder.to_str().unwrap()]].concat());
    assert!(!ran.err.contains("warning") && !ran.err.contains("error"), "{args:?}: {}", ran.err);
    ran
}

#[test]
fn a_food_of_files_alone_cooks_is_drawn_is_planned_and_speaks() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let recipe = path("halibut-recipe.toml");
    let cooked = with_it(folder.path(), &["cook", &recipe]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.out);
    for part in ["core pearly; scale: Halibut", "not pasteurised (6.5 asked)"] {
        assert!(cooked.out.contains(part), "{part}: {}", cooked.out);
    }
    let shot = path("halibut.png");
    let drawn = with_it(folder.path(), &["shot", &recipe, "--at", "2", "--size", "96x64", "--out", &shot]);
    assert_eq!(drawn.code, Some(0), "{}", drawn.err);
    assert!(std::fs::metadata(&shot).unwrap().len() > 1000);
    let listed = with_it(folder.path(), &["list", "goals"]);
    assert!(listed.out.contains("Halibut, pearly"), "{}", listed.out);
    let card = path("card.html");
    let asked = [
        "plan",
        "--food",
        "halibut",
        "--size-mm",
        "50,40,10",
        "--target",
        "pearly",
        "--max-flips",
        "1",
        "--hob",
        "600",
        "--json",
        "--card",
        &card,
    ];
    let planned = with_it(folder.path(), &asked);
    let plan: Value = serde_json::from_str(&planned.out).unwrap();
    assert!(plan["promised"]["core_peak_c"].as_f64().unwrap() > 46.0, "{}", planned.out);
    let card = std::fs::read_to_string(card).unwrap();
    assert!(card.contains("Soft."), "it feels like its own words say: {card}");
}
