//! Promise: `saute sweep` cooks every row once, goes on after a kill, names mistakes with file and line, and reports what matters.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use saute_formats::{Table, Value};
use serde_json::Value as Json;

use crate::running::{Ran, SHORT, names_in, run, saute};

/// Longest wait for the first row [s] (chosen: a row takes a tenth of a second).
const PATIENCE_S: u64 = 60;

/// A folder with a recipe and a specification.
struct Bench(tempfile::TempDir);

impl Bench {
    fn new(spec: &str) -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        std::fs::write(bench.path("short.toml"), SHORT).unwrap();
        std::fs::write(bench.path("spec.toml"), format!("recipe = \"short.toml\"\ncoarseness = 4\n{spec}")).unwrap();
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn sweep(&self, out: &str, options: &[&str]) -> Ran {
        let [spec, out] = ["spec.toml", out].map(|name| self.path(name).display().to_string());
        let mut arguments = vec!["sweep", &spec, "--out", &out];
        arguments.extend(options);
        run(&arguments)
    }
}

const GRID: &str = "for_s = 1\nrows_per_part = 5\n[vary]\n\"food.steak.size_mm[2]\" = [12, 15]\n\
                    \"pan.initial_c\" = { from = 100, to = 200, n = 6 }\n[design]\nkind = \"grid\"\n";

/// The parts; their checksums are in the same folder.
fn files(rows: &Path) -> Vec<Vec<u8>> {
    names_in(rows)
        .iter()
        .filter(|name| name.ends_with(".parquet"))
        .map(|name| std::fs::read(rows.join(name)).unwrap())
        .collect()
}

#[test]
fn a_sweep_that_is_killed_goes_on_and_ends_as_one_that_was_not() {
    let bench = Bench::new(&GRID.replace("for_s = 1", "for_s = 4"));
    let arguments = [bench.path("spec.toml"), "--out".into(), bench.path("killed"), "--jobs".into(), "1".into()];
    let mut sweep = saute().arg("sweep").args(&arguments).spawn().unwrap();
    let journal = bench.path("killed/unfinished/part-00000.rows");
    let begun = Instant::now();
    while !journal.metadata().is_ok_and(|file| file.len() > 0) && begun.elapsed().as_secs() < PATIENCE_S {
        std::thread::sleep(Duration::from_millis(5));
    }
    // As kill -9 does it.
    sweep.kill().unwrap();
    sweep.wait().unwrap();
    let again = bench.sweep("killed", &["--json"]);
    assert_eq!(again.code, Some(0), "{}", again.err);
    let answer: Json = serde_json::from_str(&again.out).unwrap();
    assert!(answer["rows"] == 12 && answer["done"] == 12 && answer["failed"] == 0, "{answer}");
    assert!(answer["cooked"].as_u64().unwrap() < 12, "{answer}");
    let whole = bench.sweep("whole", &["--jobs", "2"]);
    assert!(whole.code == Some(0) && whole.out.contains("12 rows"), "{} {}", whole.out, whole.err);
    assert_eq!(files(&bench.path("killed/rows")), files(&bench.path("whole/rows")));
    assert_eq!(files(&bench.path("whole/rows")).len(), 3);
    let sums = |folder: &str| std::fs::read_to_string(bench.path(folder).join("rows/_checksums")).unwrap();
    assert_eq!((sums("killed").lines().count(), sums("killed")), (3, sums("whole")));
    assert!(!bench.path("killed/unfinished").exists());
}

#[test]
fn a_row_has_the_numbers_of_the_cook_of_its_recipe_and_what_it_comes_from() {
    let spec =
        "rows_per_part = 2\n[vary]\n\"food.steak.size_mm[2]\" = [14, 9000]\n[design]\nkind = \"grid\"\nseed = 5\n";
    let bench = Bench::new(&spec.replace("rows_per_part", "# the mesh of the recipe\nrows_per_part"));
    let text = std::fs::read_to_string(bench.path("spec.toml")).unwrap().replace("coarseness = 4\n", "");
    std::fs::write(bench.path("spec.toml"), text).unwrap();
    let ran = bench.sweep("out", &[]);
    assert!(ran.code == Some(1) && ran.err.contains("1 of 2 rows could not be cooked"), "{}", ran.err);
    assert!(ran.err.contains("warning: some rows will fail: ") && ran.err.contains("spec.toml:5"), "{}", ran.err);
    let table = Table::from_parquet(files(&bench.path("out/rows")).remove(0), |_| true).unwrap();
    std::fs::write(bench.path("thin.toml"), SHORT.replace("50, 15]", "50, 14]")).unwrap();
    let cook: Json =
        serde_json::from_str(&run(&["cook".into(), bench.path("thin.toml"), "--json".into()]).out).unwrap();
    let number = |name: &str| table.numbers(name).unwrap()[0].unwrap();
    assert_eq!(number("food.steak.core_c.peak"), cook["foods"][0]["core_c"]["peak"].as_f64().unwrap());
    assert_eq!(number("energy_j.hob"), cook["energy_j"]["hob"].as_f64().unwrap());
    assert_eq!((number("seed"), number("vary.food.steak.size_mm[2]")), (5.0, 14.0));
    let cell = |row: usize, name: &str| match &table.rows[row][table.column(name).unwrap()] {
        Some(Value::Text(text)) => text.clone(),
        other => format!("{other:?}"),
    };
    assert_eq!(
        ["status", "recipe", "version"].map(|name| cell(0, name)),
        ["done", "short.toml", env!("CARGO_PKG_VERSION")]
    );
    assert!(cell(1, "status") == "failed" && cell(1, "message").contains("9000"), "{}", cell(1, "message"));
    let unit = |name: &str| table.headings[table.column(name).unwrap()].unit.clone();
    assert_eq!(["vary.food.steak.size_mm[2]", "food.steak.core_c.peak"].map(unit), ["mm", "°C"]);
}

#[test]
fn mistakes_are_named_with_file_line_and_the_nearest_name() {
    for (wrong, line, says) in [
        ("[vary]\n\"food.stake.size_mm[2]\" = [12, 15]\n[design]\nkind = \"grid\"\n", 4, "write steak"),
        ("[vary]\n\"pan.initial_c\" = [20, 30]\n[design]\nkind = \"gird\"\n", 6, "grid"),
        ("forr_s = 3\n[vary]\n\"pan.initial_c\" = [20, 30]\n[design]\nkind = \"grid\"\n", 3, "write for_s"),
    ] {
        let bench = Bench::new(wrong);
        let ran = bench.sweep("out", &[]);
        assert_eq!(ran.code, Some(2), "{}", ran.err);
        assert!(ran.err.contains(&format!("spec.toml:{line}")) && ran.err.contains(says), "{wrong}{}", ran.err);
        assert!(!bench.path("out").exists());
    }
    let bench = Bench::new(GRID);
    std::fs::rename(bench.path("short.toml"), bench.path("other.toml")).unwrap();
    let ran = bench.sweep("out", &[]);
    assert!(ran.code == Some(2) && ran.err.contains("spec.toml:1: short.toml"), "{}", ran.err);
    std::fs::rename(bench.path("other.toml"), bench.path("short.toml")).unwrap();
    assert_eq!(bench.sweep("out", &[]).code, Some(0));
    std::fs::write(bench.path("short.toml"), SHORT.replace("1100", "1200")).unwrap();
    let ran = bench.sweep("out", &[]);
    assert!(ran.code == Some(2) && ran.err.contains("name another folder"), "{}", ran.err);
}

#[test]
fn a_report_says_which_value_matters_and_refuses_a_grid() {
    for (kind, says) in [("saltelli", "with others"), ("morris", "over its range")] {
        let spec = format!(
            "for_s = 0.5\n[vary]\n\"pan.initial_c\" = {{ from = 20, to = 200 }}\n\"food.steak.initial_c\" = {{ from = 5, to = 6 }}\n\
             [design]\nkind = \"{kind}\"\nn = 8\n"
        );
        let bench = Bench::new(&spec);
        assert_eq!(bench.sweep("out", &[]).code, Some(0));
        let [from, to] = ["out", "report"].map(|name| bench.path(name).display().to_string());
        let ran = run(&["sweep", "report", &from, "--out", &to, "--column", "pan_c.peak"]);
        assert!(
            ran.code == Some(0) && ran.out.contains("pan.initial_c") && ran.out.contains(says),
            "{} {}",
            ran.out,
            ran.err
        );
        let page = std::fs::read_to_string(bench.path("report/report.html")).unwrap();
        assert!(page.contains("<svg") && page.contains("pan_c.peak") && !page.contains("<script"), "{page}");
        let table = std::fs::read_to_string(bench.path("report/sensitivity.csv")).unwrap();
        let size = |value: &str| -> f64 {
            let start = format!("pan_c.peak,°C,{value},");
            let line = table.lines().find(|line| line.starts_with(&start)).unwrap();
            line.split(',').nth(if kind == "morris" { 4 } else { 6 }).unwrap().parse().unwrap()
        };
        assert!(size("pan.initial_c") > 10.0 * size("food.steak.initial_c"), "{table}");
    }
    let bench = Bench::new(GRID);
    assert_eq!(bench.sweep("out", &[]).code, Some(0));
    let [from, to] = ["out", "report"].map(|name| bench.path(name).display().to_string());
    let ran = run(&["sweep", "report", &from, "--out", &to]);
    assert!(ran.code == Some(2) && ran.err.contains("saltelli"), "{}", ran.err);
}
