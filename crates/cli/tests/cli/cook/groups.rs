//! Groups of foods: what a cook with many pieces prints and writes.

use serde_json::Value;

use crate::cook::cooked::{Cooked, cook};
use crate::running::{SHORT, names_in, run};

/// A steak and thirty-four pieces in two groups, fried for 20 s.
fn crowd() -> String {
    let foods = "[[food]]\nid = \"carrots\"\nkind = \"carrot-coin\"\nsize_mm = [18, 6]\ncount = 20\n\
                 [[food]]\nid = \"leeks\"\nkind = \"leek-ring\"\nsize_mm = [18, 8]\ncount = 14\n[[step]]\n";
    let steps = "put = \"steak\"\n[[step]]\nput = { food = \"carrots\", at_mm = [-60, 0] }\n\
                 [[step]]\nput = { food = \"leeks\", at_mm = [60, 0] }";
    SHORT.replacen("[[step]]\n", foods, 1).replace("put = \"steak\"", steps)
}

fn crowded(lines: &[&str]) -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("crowd.toml");
    let text = lines.chunks(2).fold(crowd(), |text, pair| text.replace(pair[0], pair[1]));
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (dir, path)
}

fn cooked_crowd() -> Cooked {
    let (_dir, path) = crowded(&["flip = \"steak\"", "rest = \"leeks\""]);
    cook(&path)
}

#[test]
fn the_json_has_every_piece_with_its_group_and_the_means_of_each_group() {
    let crowd = cooked_crowd();
    let foods = crowd.summary["foods"].as_array().unwrap();
    assert_eq!(foods.len(), 35);
    assert_eq!((&foods[0]["group"], &foods[1]["group"]), (&Value::Null, &Value::from("carrots")));
    assert_eq!((&foods[34]["id"], &foods[34]["group"]), (&Value::from("leeks.14"), &Value::from("leeks")));
    assert_eq!((&foods[20]["place"], &foods[34]["place"]), (&Value::from("pan"), &Value::from("board")));
    let groups = crowd.summary["groups"].as_array().unwrap();
    let words: Vec<[&Value; 5]> =
        groups.iter().map(|g| ["id", "kind", "count", "in_pan", "place"].map(|k| &g[k])).collect();
    let expected = [
        [&"carrots".into(), &"carrot-coin".into(), &20.into(), &20.into(), &"pan".into()],
        [&"leeks".into(), &"leek-ring".into(), &14.into(), &0.into(), &Value::from("board")],
    ];
    assert_eq!(words, expected);
    for pointer in [
        "/mass_g/start",
        "/mass_g/end",
        "/lost_pct",
        "/core_c/end",
        "/core_c/peak",
        "/denatured/pectin",
        "/surfaces/bottom/browned_pct",
    ] {
        let of = |value: &Value| value.pointer(pointer).and_then(Value::as_f64).unwrap();
        let mean = foods[1..21].iter().map(of).sum::<f64>() / 20.0;
        assert!((of(&groups[0]) - mean).abs() < 1e-9, "{pointer}");
    }
    assert_eq!(crowd.summary["steps"][2]["foods"].as_array().unwrap().len(), 20);
}

#[test]
fn thirty_five_pieces_have_one_picture_a_group_and_a_readable_report() {
    let crowd = cooked_crowd();
    let pictures: Vec<&String> = crowd.files.keys().filter(|name| name.starts_with("section_06_")).collect();
    let foods = [".carrots.1.png", ".leeks.1.png", ".steak.png"];
    assert_eq!(pictures.len(), 6, "{pictures:?}");
    assert!(foods.iter().all(|food| pictures.iter().filter(|name| name.ends_with(food)).count() == 2), "{pictures:?}");
    let report = crowd.text("report.html");
    assert_eq!(report.matches("<figure class=\"plot\">").count(), 3);
    assert!(report.contains("carrots: 20 × carrot-coin, 18 × 18 × 6 mm") && report.contains("carrots, piece by piece"));
    assert!(report.contains("<th scope=\"row\">carrots.20</th>"));
    assert!(report.contains("carrots, means of 20"));
}

#[test]
fn every_piece_has_its_pictures_on_request() {
    let (dir, path) = crowded(&["count = 20", "count = 3", "count = 14", "count = 2"]);
    let out = dir.path().join("out");
    let ran = run(&["cook", &path, "--every-piece", "--out", out.to_str().unwrap()]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let names = names_in(&out);
    for food in ["steak", "carrots.1", "carrots.2", "carrots.3", "leeks.1", "leeks.2"] {
        assert!(names.contains(&format!("section_06_end.{food}.png")), "{food}: {names:?}");
    }
    let alone = run(&["cook", &path, "--every-piece"]);
    assert!(alone.code == Some(2) && alone.err.contains("--out"), "{}", alone.err);
}

#[test]
fn the_text_has_a_line_for_each_group_and_none_for_its_pieces() {
    let (_dir, path) = crowded(&[]);
    let ran = run(&["cook", &path]);
    let line = |start: &str| ran.out.lines().find(|l| l.trim_start().starts_with(start)).map(str::to_owned);
    let carrots = line("carrots ").unwrap();
    for part in ["20 × carrot-coin", "core ", "at the end", "browned", "20 pan"] {
        assert!(carrots.contains(part), "{part}: {carrots}");
    }
    assert!(line("leeks ").is_some() && line("carrots.1").is_none() && line("leeks.14").is_none());
    assert!(ran.out.lines().count() < 40, "{}", ran.out);
}

/// The pan takes a limited number of pieces; the error names the number, the line and the remedy.
#[test]
fn too_many_pieces_for_the_pan_are_refused_before_anything_is_cooked() {
    let (_dir, path) = crowded(&["count = 20", "count = 70", "size_mm = [18, 6]", "size_mm = [40, 6]"]);
    let ran = run(&["cook", &path, "--json"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    for part in ["crowd.toml:25:", "of 70 fit", "remedy:", "heap = true"] {
        assert!(ran.err.contains(part), "{part}: {}", ran.err);
    }
}
