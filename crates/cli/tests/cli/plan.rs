//! Promise: `saute plan` writes a recipe that gives what it promises, and a card; a target that cannot be met exits with 1, the best
//! found and why; wrong options exit with 2 and name option and remedy.

use serde_json::Value;

use crate::running::run;

/// A shrimp that is planned in a few seconds.
const SHRIMP: [&str; 12] = [
    "plan",
    "--food",
    "shrimp",
    "--size-mm",
    "50,10",
    "--target",
    "opaque",
    "--max-flips",
    "1",
    "--hob",
    "900",
    "--json",
];

#[test]
fn the_recipe_gives_what_the_plan_promises() {
    let dir = tempfile::tempdir().unwrap();
    let [recipe, card] = ["plan.toml", "card.html"].map(|name| dir.path().join(name).to_str().unwrap().to_owned());
    let ran = run(&[&SHRIMP[..], &["--out", &recipe, "--card", &card]].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let plan: Value = serde_json::from_str(&ran.out).unwrap();
    for key in ["schedule", "promised", "sensitivity", "wall_s"] {
        assert!(!plan[key].is_null(), "{key}: {}", ran.out);
    }
    assert_eq!(plan["sensitivity"].as_array().unwrap().len(), 6);

    let cooked: Value = serde_json::from_str(&run(&["cook", &recipe, "--json"]).out).unwrap();
    let food = &cooked["foods"][0];
    let differs = |a: &Value, b: &Value| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs();
    assert!(differs(&food["core_c"]["peak"], &plan["promised"]["core_peak_c"]) < 1.0, "{food}");
    let share = &food["doneness"]["shrimp"]["section_pct"]["opaque"];
    assert!(differs(share, &plan["promised"]["target_share_pct"]) < 3.0, "{share}");
    assert_eq!(cooked["simulated_s"].as_f64().unwrap(), {
        let schedule = &plan["schedule"];
        schedule["pull_s"].as_f64().unwrap() + schedule["rest_s"].as_f64().unwrap()
    });

    let card = std::fs::read_to_string(&card).unwrap();
    for part in ["@page", "into the pan", "out of the pan", "shimmers", "thickness +3 mm"] {
        assert!(card.contains(part), "{part}: {card}");
    }
}

#[test]
fn a_target_that_cannot_be_met_exits_with_1_the_best_found_and_why() {
    let args = [
        "plan",
        "--food",
        "beef-lean",
        "--size-mm",
        "40,30,10",
        "--target",
        "rare",
        "--max-flips",
        "1",
        "--hob",
        "1100",
    ];
    let ran = run(&args);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    assert!(ran.err.contains("target rare is not met") && ran.err.contains("remedy: a thicker piece"), "{}", ran.err);
    assert!(ran.out.contains("into the pan") && ran.out.contains("promised"), "{}", ran.out);
}

#[test]
fn wrong_options_are_named_with_a_remedy() {
    let cases: [(&[&str], &[&str]); 12] = [
        (&["--food", "beef", "--target", "rare"], &["--food beef", "beef-lean"]),
        (&["--food", "shrimp", "--target", "opaque", "--pan", "wok"], &["--pan wok", "carbon-steel-26"]),
        (&["--food", "beef-lean", "--target", "rare", "--size-mm", "120,80"], &["--size-mm 120,80", "three numbers"]),
        (
            &["--food", "beef-lean", "--target", "rare", "--size-mm", "120,80,8"],
            &["--size-mm", "thickness", "10 to 60 mm"],
        ),
        (&["--food", "beef-lean", "--target", "rare", "--initial-c", "90"], &["--initial-c 90", "-25 to 60"]),
        (&["--food", "beef-lean", "--target", "pink"], &["--target pink", "medium-rare"]),
        (&["--food", "beef-lean", "--target", "core=hot"], &["--target core=hot", "core=54"]),
        (
            &["--food", "shrimp", "--target", "rare", "--scale", "chefs"],
            &["--scale chefs", "does not fit shrimp", "shrimp"],
        ),
        (&["--food", "shrimp", "--target", "rare", "--scale", "mine"], &["--scale mine", "use one of: shrimp"]),
        (&["--food", "beef-lean", "--target", "rare", "--hob", "400,9000"], &["--hob 9000", "3500"]),
        (&["--food", "beef-lean", "--target", "rare", "--crust-pct", "200"], &["--crust-pct 200", "0 to 100"]),
        (&["--food", "beef-lean", "--target", "rare", "--count", "30"], &["--count 30", "room"]),
    ];
    for (args, says) in cases {
        let ran = run(&[&["plan"], args].concat());
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{args:?}: {}", ran.err);
        assert!(ran.err.contains("remedy:"), "{args:?}: {}", ran.err);
        for part in says {
            assert!(ran.err.contains(part), "{args:?}: {part}: {}", ran.err);
        }
    }
}
