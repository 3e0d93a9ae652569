//! `--fields` of `saute cook` and `saute lab`, and the files for other tools.

use std::path::Path;

use serde_json::Value;

use crate::running::{SHORT, names_in, run};

/// A thin steak on the mesh of 2013, fried for 5 s.
fn recipe(dir: &Path) -> String {
    let path = dir.join("thin.toml");
    let text = SHORT.replace("initial_c = 5\n", "initial_c = 5\nmesh = \"2013\"\n");
    std::fs::write(&path, text.replacen("after_s = 10", "after_s = 3", 1).replacen("after_s = 10", "after_s = 2", 1))
        .unwrap();
    path.to_str().unwrap().to_owned()
}

/// Times and files of a series.
fn series(out: &Path) -> Vec<(f64, String)> {
    let text = std::fs::read_to_string(out.join("fields.pvd")).unwrap();
    let attribute = |line: &str, name: &str| {
        let from = line.split(&format!(" {name}=\"")).nth(1).unwrap();
        from.split('"').next().unwrap().to_owned()
    };
    let entries = text.lines().filter(|line| line.starts_with("<DataSet"));
    entries.map(|line| (attribute(line, "timestep").parse().unwrap(), attribute(line, "file"))).collect()
}

fn without_wall(text: &str) -> Value {
    let mut numbers: Value = serde_json::from_str(text).unwrap();
    numbers["wall_s"] = Value::Null;
    numbers
}

#[test]
fn fields_are_written_at_every_interval_and_at_the_end_and_change_no_number() {
    let dir = tempfile::tempdir().unwrap();
    let (recipe, out) = (recipe(dir.path()), dir.path().join("out"));
    let plain = run(&["cook", &recipe, "--json"]);
    let ran = run(&["cook", &recipe, "--json", "--out", out.to_str().unwrap(), "--fields", "2"]);
    assert_eq!((plain.code, ran.code), (Some(0), Some(0)), "{}", ran.err);
    assert_eq!(without_wall(&plain.out), without_wall(&ran.out));
    let series = series(&out);
    let mut times: Vec<f64> = series.iter().map(|(time, _)| *time).collect();
    times.dedup();
    assert_eq!(times, [0.0, 2.0, 4.0, 5.0]);
    assert_eq!(series.len(), 3 * times.len(), "inside, surface and pan");
    let names = names_in(&out);
    assert!(series.iter().all(|(_, file)| names.contains(file)), "{names:?}");
    assert_eq!(names.iter().filter(|name| name.ends_with(".vtu")).count(), series.len());
    // A shorter series takes the place of this one, and a cook without fields removes it.
    assert_eq!(run(&["cook", &recipe, "--out", out.to_str().unwrap(), "--fields", "60"]).code, Some(0));
    assert_eq!(names_in(&out).iter().filter(|name| name.ends_with(".vtu")).count(), 6);
    assert_eq!(run(&["cook", &recipe, "--out", out.to_str().unwrap()]).code, Some(0));
    assert!(names_in(&out).iter().all(|name| !name.starts_with("fields")), "{:?}", names_in(&out));
}

/// Names of the arrays of a file.
fn arrays(file: &Path) -> Vec<String> {
    let bytes = std::fs::read(file).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let xml = text.split("<AppendedData").next().unwrap();
    let names = xml.split(" Name=\"").skip(1).map(|rest| rest.split('"').next().unwrap().to_owned());
    names.filter(|name| !["points_m", "connectivity", "offsets", "types"].contains(&name.as_str())).collect()
}

#[test]
fn the_guide_names_every_field() {
    let dir = tempfile::tempdir().unwrap();
    let (recipe, out) = (recipe(dir.path()), dir.path().join("out"));
    assert_eq!(run(&["cook", &recipe, "--out", out.to_str().unwrap(), "--fields", "60"]).code, Some(0));
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/fields.md");
    let guide = std::fs::read_to_string(guide).unwrap();
    let notes = ["food", "kind", "place", "pan", "lid", "program"];
    for file in ["fields_0000_inside.steak.vtu", "fields_0000_surface.steak.vtu", "fields_0000_pan.vtu"] {
        let names = arrays(&out.join(file));
        assert!(names.len() > 10, "{file}: {names:?}");
        for name in names.iter().filter(|name| !notes.contains(&name.as_str()) && !name.starts_with("changed.")) {
            assert!(guide.contains(&format!("`{name}`")), "{file}: docs/fields.md does not name {name}");
        }
    }
}

#[test]
fn an_output_folder_has_tables_as_parquet_and_the_cooked_food_as_gltf() {
    let dir = tempfile::tempdir().unwrap();
    let (recipe, out) = (recipe(dir.path()), dir.path().join("out"));
    assert_eq!(run(&["cook", &recipe, "--out", out.to_str().unwrap()]).code, Some(0));
    let read = |name: &str| std::fs::read(out.join(name)).unwrap();
    let table = |name: &str| saute_formats::Table::from_parquet(read(name), |_| true).unwrap();
    let summary: Value = serde_json::from_slice(&read("summary.json")).unwrap();
    let core = summary.pointer("/foods/0/core_c/end").unwrap().as_f64();
    assert_eq!(table("summary.parquet").numbers("food.steak.core_c.end"), Some(vec![core]));
    let csv = String::from_utf8(read("series.csv")).unwrap();
    assert_eq!(table("series.parquet").rows.len(), csv.lines().count() - 1);
    let soup = saute_surface::read("cooked.glb", &read("cooked.glb"), |_| None).unwrap();
    let surface = extent(&soup.vertices);
    let expected = [0.060, 0.050, 0.015];
    assert!((0..3).all(|k| (surface[k] / expected[k] - 1.0).abs() < 0.12), "{surface:?} m");
    let checked = run(&["food", "check", out.join("cooked.glb").to_str().unwrap()]);
    assert!(checked.code == Some(0) && checked.out.contains("closed surface: "), "{}{}", checked.out, checked.err);
}

#[test]
fn each_cooked_food_of_a_dish_is_checked_by_its_name() {
    let dir = tempfile::tempdir().unwrap();
    let one = std::fs::read_to_string(recipe(dir.path())).unwrap();
    let other = "[[food]]\nid = \"other\"\nkind = \"beef-lean\"\nsize_mm = [50, 40, 15]\nmesh = \"2013\"\n[[step]]";
    let two = one.replacen("[[step]]", other, 1);
    std::fs::write(dir.path().join("two.toml"), two).unwrap();
    let out = dir.path().join("out");
    let cooked = run(&["cook", dir.path().join("two.toml").to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
    let checked = run(&["food", "check", out.join("cooked.glb").to_str().unwrap(), "--json"]);
    let verdict: Value = serde_json::from_str(&checked.out).unwrap();
    let names: Vec<_> = verdict["surfaces"].as_array().unwrap().iter().map(|body| &body["name"]).collect();
    assert!(checked.code == Some(0) && names == ["steak", "other"], "{}{}", checked.out, checked.err);
}

/// Length, width and height of points.
fn extent(points: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        let bound = |of: fn(f64, f64) -> f64| points.iter().map(|p| p[k]).reduce(of).unwrap();
        bound(f64::max) - bound(f64::min)
    })
}

#[test]
fn fields_need_a_folder_and_a_whole_tick() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = recipe(dir.path());
    let ran = run(&["cook", &recipe, "--fields", "2"]);
    assert!(ran.code == Some(2) && ran.err.contains("--out"), "{}", ran.err);
    let out = dir.path().join("out");
    for wrong in ["0", "-1", "0.01", "nan", "soon"] {
        let ran = run(&["cook", &recipe, "--out", out.to_str().unwrap(), &format!("--fields={wrong}")]);
        assert!(ran.code == Some(2) && ran.err.contains("0.1 or more"), "{wrong}: {}", ran.err);
    }
    assert!(!out.exists());
}

#[test]
fn a_lab_case_has_fields_too_and_gives_the_same_numbers() {
    let dir = tempfile::tempdir().unwrap();
    for (case, body) in
        [("step-cube", "Hexahedron"), ("stefan-200", "lines"), ("shrimp-cylinder-cooked-to-63-c", "a cooked cylinder")]
    {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../validation/{case}.toml"));
        let (path, out) = (path.to_str().unwrap().to_owned(), dir.path().join(case));
        let plain = run(&["lab", &path, "--json"]);
        let ran = run(&["lab", &path, "--json", "--out", out.to_str().unwrap(), "--fields", "60"]);
        assert_eq!(plain.code, ran.code, "{body}: {}", ran.err);
        assert_eq!(without_wall(&plain.out), without_wall(&ran.out), "{case}");
        let series = series(&out);
        assert!(series.len() > 2 && series[0].0 == 0.0, "{case}: {series:?}");
        assert!(series.windows(2).all(|pair| pair[0].0 < pair[1].0), "{case}: {series:?}");
        assert!(series.iter().all(|(_, file)| out.join(file).is_file()));
        let report = std::fs::read_to_string(out.join("report.json")).unwrap();
        assert_eq!(without_wall(&report), without_wall(&ran.out));
    }
}
