//! `saute fit`: what a kitchen at home has otherwise, from a log, and the kitchen that it gives.

use crate::running::run;

/// A thin steak that is fried by the clock.
const BY_THE_CLOCK: &str = r#"
[pan]
kind = "carbon-steel-26"
initial_c = 20
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
initial_c = 6
[[step]]
at_s = 0
hob_w = 1500
[[step]]
at_s = 60
put = "steak"
[[step]]
at_s = 62
hob_w = 700
[[step]]
at_s = 180
end = true
"#;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    fn write(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        std::fs::create_dir_all(std::path::Path::new(&path).parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        path
    }
}

/// A cook in a kitchen whose hob is weaker gives a log; fitted to it, that kitchen is found and can be cooked in.
#[test]
fn a_kitchen_with_a_weaker_hob_is_found_from_the_log_of_its_cook() {
    let folder = Folder::new();
    let recipe = folder.write("steak.toml", BY_THE_CLOCK);
    let weaker = "hob_factor = 0.9\ncontact_factor = 1.0\nsource = \"a test\"\nconfidence = \"low\"\n";
    folder.write("theirs/kitchen-at-home.toml", weaker);
    let cooked = run(&["--data", &folder.path("theirs"), "cook", &recipe, "--out", &folder.path("cook")]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
    let (log, found) = (folder.path("cook/series.csv"), folder.path("found"));
    let fitted =
        run(&["fit", &log, "--recipe", &recipe, "--core", "steak.core_c", "--pan", "pan_c", "--out", &found, "--json"]);
    assert_eq!(fitted.code, Some(0), "{}", fitted.err);
    let json: serde_json::Value = serde_json::from_str(&fitted.out).unwrap();
    let (low, high) =
        (json["hob_efficiency"]["low"].as_f64().unwrap(), json["hob_efficiency"]["high"].as_f64().unwrap());
    assert!((low..high).contains(&(0.9 * 0.87)) && high < 0.83, "{json}");
    assert!((json["thickness_mm"]["value"].as_f64().unwrap() - 15.0).abs() < 0.5, "{json}");
    let again = run(&["--data", &found, "cook", &recipe, "--json"]);
    let peak = |out: &str| serde_json::from_str::<serde_json::Value>(out).unwrap()["pan_c"]["peak"].as_f64();
    let theirs = std::fs::read_to_string(folder.path("cook/summary.json")).unwrap();
    let (here, there) = (peak(&again.out), peak(&theirs));
    assert!((here.unwrap() - there.unwrap()).abs() < 3.0, "{here:?} {there:?}");
}

#[test]
fn a_fit_without_times_columns_or_measurements_is_refused_with_the_remedy() {
    let folder = Folder::new();
    let recipe = folder.write("steak.toml", BY_THE_CLOCK);
    let log = folder.write("log.csv", "time_s,a,b\n0,5,6\n10,6,7\n");
    let says = |args: &[&str]| {
        let ran = run(args);
        assert_eq!(ran.code, Some(2), "{args:?}: {}", ran.err);
        ran.err
    };
    assert!(says(&["fit", "--recipe", &recipe]).contains("give a column of core or pan temperatures"));
    assert!(says(&["fit", &log, "--recipe", "medium", "--core", "a"]).contains("waits for a condition"));
    assert!(says(&["fit", &log, "--recipe", &recipe]).contains("--core COLUMN"));
    assert!(
        says(&["fit", &log, "--recipe", &recipe, "--core", "c"]).contains("use one of: 1 \"time_s\", 2 \"a\", 3 \"b\"")
    );
    assert!(
        says(&["fit", "--recipe", &recipe, "--class", "blue"]).contains("raw, rare, medium-rare, medium, well-done")
    );
    assert!(says(&["fit", "--recipe", &recipe, "--weight-g", "-5"]).contains("--weight-g"));
}

/// The log of a maker of the cook above: it begins a minute before it and ends after it, loses the probe for a while, and states °F
/// in a header without blanks.
fn a_makers_log(series: &str) -> String {
    let mut log = "Maker\nVersion: 2\n\nTimestamp,MeatTempF,SkilletTempF\n".to_owned();
    let fahrenheit = |celsius: f64| 1.8 * celsius + 32.0;
    let rows: Vec<Vec<f64>> = series
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|field| field.parse().unwrap_or(0.0)).collect())
        .collect();
    let header: Vec<&str> = series.lines().next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|header| *header == name).unwrap();
    let (core, pan) = (column("steak.core_c"), column("pan_c"));
    for second in (0..360).step_by(6) {
        let in_cook = f64::from(second) - 60.0;
        let row = rows.iter().find(|row| (row[0] - in_cook).abs() < 0.05);
        let [core, pan] = match row {
            Some(_) if (150..162).contains(&second) => [0.0, 150.0],
            Some(row) => [row[core], row[pan]],
            None => [21.0, 20.0],
        };
        log += &format!(
            "2025-04-05T18:{:02}:{:02}-07:00,{:.1},{:.1}\n",
            second / 60,
            second % 60,
            fahrenheit(core),
            fahrenheit(pan)
        );
    }
    log
}

#[test]
fn a_makers_log_is_read_compared_from_the_put_on_and_the_answer_says_how() {
    let folder = Folder::new();
    let recipe = folder.write("steak.toml", BY_THE_CLOCK);
    let cooked = run(&["cook", &recipe, "--out", &folder.path("cook")]);
    assert_eq!(cooked.code, Some(0), "{}", cooked.err);
    let series = std::fs::read_to_string(folder.path("cook/series.csv")).unwrap();
    let log = folder.write("maker.csv", &a_makers_log(&series));
    let out = folder.path("found");
    let fitted = run(&["fit", &log, "--recipe", &recipe, "--shift-s", "-60", "--out", &out, "--json"]);
    assert_eq!(fitted.code, Some(0), "{}\n{}", fitted.err, fitted.out);
    let json: serde_json::Value = serde_json::from_str(&fitted.out).unwrap();
    assert!((json["hob_efficiency"]["value"].as_f64().unwrap() - 0.87).abs() < 0.02, "{json}");
    assert_eq!(json["log"]["core"]["column"], "MeatTempF");
    assert_eq!(json["log"]["core"]["unit"], "°F");
    assert_eq!(json["log"]["core"]["unit_from"], "header");
    assert_eq!(json["log"]["pan"]["column"], "SkilletTempF");
    assert_eq!((json["log"]["time_form"].as_str(), json["log"]["span_s"].as_f64()), (Some("dated"), Some(354.0)));
    assert!(json["worst"].as_str().unwrap().contains("core read 0.0 °C"), "{json}");
    let file = std::fs::read_to_string(folder.path("found/kitchen-at-home.toml")).unwrap();
    assert!(file.contains("core from MeatTempF in °F, by its header"), "{file}");
}

#[test]
fn a_kitchen_that_does_not_describe_the_log_is_written_only_by_force_and_can_be_cooked_in() {
    let folder = Folder::new();
    let recipe = folder.write("steak.toml", BY_THE_CLOCK);
    let cold: String = (0..18).map(|row| format!("{},6.0,{:.1}\n", 10 * row, 20.0 + 0.2 * f64::from(row))).collect();
    let log = folder.write("cold.csv", &format!("time_s,core_c,pan_c\n{cold}"));
    let out = folder.path("found");
    let file = std::path::PathBuf::from(folder.path("found/kitchen-at-home.toml"));
    let fitted = run(&["fit", &log, "--recipe", &recipe, "--out", &out]);
    assert_eq!((fitted.code, file.exists()), (Some(1), false), "{}", fitted.err);
    assert!(
        fitted.err.contains("no kitchen was written; --force") && fitted.err.contains("it fits worst at "),
        "{}",
        fitted.err
    );
    let fitted = run(&["fit", &log, "--recipe", &recipe, "--out", &out, "--force"]);
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(fitted.code == Some(1) && text.contains("confidence = \"low\""), "{text}");
    let listed = run(&["--data", &out, "list", "foods"]);
    assert!(listed.code == Some(0) && listed.err.is_empty(), "{text}\n{}", listed.err);
}

#[test]
fn a_broken_kitchen_at_home_stops_cooking_and_nothing_else() {
    let folder = Folder::new();
    folder.write(
        "data/kitchen-at-home.toml",
        "hob_factor = 9.0\ncontact_factor = 1.0\nsource = \"x\"\nconfidence = \"low\"\n",
    );
    let data = folder.path("data");
    let listed = run(&["--data", &data, "list", "foods"]);
    assert_eq!(listed.code, Some(0), "{}", listed.err);
    assert!(listed.err.contains("kitchen-at-home.toml:1") && listed.err.contains("hob_factor"), "{}", listed.err);
    let cooked = run(&["--data", &data, "cook", "medium"]);
    assert_eq!(cooked.code, Some(2));
    assert!(cooked.err.contains("kitchen-at-home.toml in the --data folder is broken"), "{}", cooked.err);
}
