//! Doneness on every scale: all of them in JSON, the chosen one with its label in text.

use std::path::Path;

use serde_json::Value;

use crate::cook::cooked::{cook, cooked};
use crate::running::{SHORT, run};

const SCALES: [(&str, &str, usize); 3] =
    [("paper-2013", "Kato & Hasegawa 2013", 4), ("chefs", "Chefs", 5), ("academic", "AMSA / USDA", 5)];

fn short(dir: &Path, kind: &str) -> String {
    let path = dir.join("short.toml");
    let size = if kind == "beef-lean" { "size_mm = [60, 50, 15]\n" } else { "" };
    std::fs::write(&path, SHORT.replace("beef-lean", kind).replace("size_mm = [60, 50, 15]\n", size)).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn the_json_has_the_doneness_on_every_scale() {
    let doneness = cooked("medium").summary["foods"][0]["doneness"].as_object().unwrap();
    assert_eq!(doneness.len(), SCALES.len());
    for (id, label, classes) in SCALES {
        let reading = &doneness[id];
        assert_eq!(reading["label"], label);
        for shares in [&reading["section_pct"], &reading["volume_pct"]] {
            let shares = shares.as_object().unwrap();
            assert!(shares.len() == classes && shares.contains_key(reading["class"].as_str().unwrap()), "{shares:?}");
            let sum: f64 = shares.values().filter_map(Value::as_f64).sum();
            assert!((sum - 100.0).abs() < 1e-6, "{id}: {sum}");
        }
    }
}

#[test]
fn the_shares_of_2013_equal_the_plain_ones_and_its_class_is_that_of_the_cores_peak() {
    let medium = cooked("medium");
    for (plain, scale) in [("raw", "raw"), ("rare", "rare"), ("medium", "medium"), ("well_done", "well-done")] {
        for shares in ["section_pct", "volume_pct"] {
            let by_scale = medium.number(&format!("/foods/0/doneness/paper-2013/{shares}/{scale}"));
            assert_eq!(medium.number(&format!("/foods/0/{shares}/{plain}")), by_scale, "{shares} {plain}");
        }
    }
    let peak = medium.number("/foods/0/core_c/peak");
    let class = if peak < 60.0 { "rare" } else { "medium" };
    assert_eq!(medium.summary["foods"][0]["doneness"]["paper-2013"]["class"], class);
}

/// Promise: a class is hatched in the report as in the window, where medium has lines that rise to the right.
#[test]
fn the_report_hatches_a_class_as_the_window_does() {
    let report = cooked("medium").text("report.html");
    for (class, pattern) in [
        ("raw", "none"),
        ("rare", "radial-gradient(circle at 2px 3px, rgb(0 0 0 / 0.42) 1.5px"),
        ("medium", "repeating-linear-gradient(135deg, rgb(0 0 0 / 0.42) 0 1.3px"),
        ("well-done", "repeating-linear-gradient(135deg"),
    ] {
        assert!(report.contains(&format!(".pattern.{class} {{ background-image: {pattern}")), "{class}: {pattern}");
    }
    assert!(report.contains("time, min:s"));
}

#[test]
fn a_vegetable_is_spoken_of_as_crisp_tender_or_soft_and_not_as_meat() {
    let dir = tempfile::tempdir().unwrap();
    let path = short(dir.path(), "carrot-coin");
    let carrot = cook(&path);
    let doneness = carrot.summary["foods"][0]["doneness"].as_object().unwrap();
    assert_eq!(doneness.keys().collect::<Vec<_>>(), ["vegetables"]);
    assert_eq!(doneness["vegetables"]["class"], "crisp");
    let report = carrot.text("report.html");
    assert!(report.contains("how far the pectin") && report.contains("scale: Tenderness"));
    assert!(!report.contains("</b> rare") && report.contains("</b> tender"));
    for chosen in ["paper-2013", "chefs"] {
        let ran = run(&["cook", &path, "--doneness", chosen]);
        assert!(ran.out.contains("core crisp; scale: Tenderness"), "{}", ran.out);
        assert!(["crisp", "tender", "soft"].iter().all(|word| ran.out.contains(word)) && !ran.out.contains("rare"));
    }
}

#[test]
fn a_shrimp_and_a_patty_have_words_of_their_own() {
    let dir = tempfile::tempdir().unwrap();
    for (kind, scale, words) in [
        ("shrimp", "Shrimp", ["glassy", "opaque", "overcooked"]),
        ("beef-patty", "Ground beef", ["pink", "safe", "dry"]),
    ] {
        let ran = run(&["cook", &short(dir.path(), kind)]);
        assert!(ran.out.contains(&format!("scale: {scale}")), "{}", ran.out);
        assert!(words.iter().all(|word| ran.out.contains(word)) && !ran.out.contains("rare"), "{}", ran.out);
    }
}

#[test]
fn the_text_has_the_chosen_scale_with_its_label() {
    let dir = tempfile::tempdir().unwrap();
    let path = short(dir.path(), "beef-lean");
    let out = dir.path().join("out");
    for (id, label, _) in SCALES {
        let ran = run(&["cook", &path, "--doneness", id, "--out", out.to_str().unwrap()]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert!(ran.out.contains(&format!("scale: {label}")), "{}", ran.out);
        assert_eq!(ran.out.contains("medium-rare"), id != "paper-2013");
        let report = std::fs::read_to_string(out.join("report.html")).unwrap();
        assert!(report.contains(&format!("scale: {}", label.replace('&', "&amp;"))), "{id}");
    }
    assert!(run(&["cook", &path]).out.contains("scale: Kato & Hasegawa 2013"), "the default");
}

#[test]
fn an_unknown_scale_is_refused_and_the_choices_are_named() {
    for command in [
        vec!["cook", "medium", "--doneness", "grandma"],
        vec!["shot", "medium", "--at", "1", "--out", "never.png", "--doneness", "grandma"],
    ] {
        let ran = run(&command);
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
        for part in ["grandma", "remedy", "paper-2013, chefs, academic"] {
            assert!(ran.err.contains(part), "{part}: {}", ran.err);
        }
    }
}

fn shipped() -> String {
    std::fs::read_to_string(format!("{}/../../data/doneness.toml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

#[test]
fn scales_of_the_user_replace_the_shipped_ones() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().to_str().unwrap();
    std::fs::write(dir.path().join("doneness.toml"), shipped().replace("\"chefs\"", "\"grandma\"")).unwrap();
    assert!(run(&["list", "scales", "--data", data]).out.contains("grandma"));
    assert_eq!(run(&["cook", "rare", "--doneness", "chefs", "--data", data]).code, Some(2));
}

#[test]
fn a_mistake_in_the_scales_is_named_with_file_line_and_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let (data, file) = (dir.path().to_str().unwrap(), dir.path().join("doneness.toml"));
    let wrong = [
        ("id = \"chefs\"", "id = \"academic\"", "another id"),
        ("id = \"chefs\"", "id = \"the chefs\"", "letters, digits"),
        ("id = \"paper-2013\"", "id = \"mine\"", "paper-2013"),
        ("name = \"Chefs\"", "name = \" \"", "label"),
        ("\"medium-rare\", from_c = 55.0", "\"medium-rare\", from_c = 65.0", "ascend"),
        ("\"medium-rare\", from_c = 55.0", "\"rare\", from_c = 55.0", "name each class"),
        ("from_c = 77.0", "from_c = 770.0", "0 to 120"),
        ("from_c = 77.0", "from = 77.0", "from"),
        ("source = \"Baldwin", "cource = \"Baldwin", "source"),
    ];
    for (from, to, part) in wrong {
        let text = shipped();
        assert!(text.contains(from), "{from}");
        std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let ran = run(&["list", "scales", "--data", data]);
        assert_eq!(ran.code, Some(2), "{to}");
        let place = format!("{}:", file.display());
        let line = ran.err.split(&place).nth(1).and_then(|rest| rest.split(':').next()).unwrap().parse::<usize>();
        assert!(line.is_ok() && ran.err.contains(part) && ran.err.contains("remedy"), "{to}: {}", ran.err);
    }
    std::fs::write(&file, shipped().replace("name = \"Chefs\"", "name = \"\"")).unwrap();
    let line = 1 + shipped().lines().position(|l| l == "name = \"Chefs\"").unwrap();
    let ran = run(&["list", "scales", "--data", data]);
    assert!(ran.err.contains(&format!("doneness.toml:{line}:")), "{}", ran.err);
}
