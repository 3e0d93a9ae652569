//! Promise: every validation case passes, and the lab prints and documents its numbers.

use std::path::Path;

use crate::running::{Ran, run, saute};

/// Cases of each kind of evidence that take little time. What all of them give: tests/validation.
const QUICK: [&str; 9] = [
    "brick-20-cells",
    "convection-slab-bi-1",
    "step-coin",
    "step-slab",
    "stefan-200",
    "contact-at-180-c",
    "sous-vide-10-mm",
    "shrimp-cylinder-cooked-to-63-c",
    "shrimp-in-boiling-water",
];

/// One run for all promises: verdicts in groups, progress, pages and pictures in an empty folder.
#[test]
fn a_folder_of_cases_is_judged_in_groups_and_its_page_is_written_with_pictures() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("cases")).unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    for id in QUICK {
        let file = format!("{id}.toml");
        std::fs::copy(shipped.join(&file), dir.path().join("cases").join(&file)).unwrap();
    }
    let arguments = ["validate", "--json", "--write", "--folder", "cases"];
    let ran: Ran = saute().args(arguments).current_dir(dir.path()).output().unwrap().into();
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    assert!(ran.err.contains("1 of 9"), "{}", ran.err);
    let verdicts: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert!(verdicts["removed"].as_array().unwrap().is_empty(), "{}", ran.err);
    check_groups(&verdicts);
    check_pages(dir.path(), [5, 8]);
}

/// The pages in the project are those of all cases.
#[test]
fn the_pages_of_the_project_lead_to_every_picture() {
    check_pages(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."), [20, 30]);
}

/// Exact, measured and kitchen-band values are apart, and in each group the largest error over tolerance comes first.
fn check_groups(verdicts: &serde_json::Value) {
    let cases = verdicts["cases"].as_array().unwrap();
    let mut first = 0;
    for (kind, group) in ["exact", "measured", "kitchen-band"].iter().zip(verdicts["groups"].as_array().unwrap()) {
        let values = group["values"].as_u64().unwrap() as usize;
        let [held, known] = ["hold", "known_misses"].map(|key| group[key].as_u64().unwrap() as usize);
        assert!(
            group["evidence"] == *kind && values > 1 && held + known == values && 20 * known <= 3 * values,
            "{group}"
        );
        let rows = &cases[first..first + values];
        assert!(rows.iter().all(|row| row["evidence"] == *kind), "{kind}");
        let share = |row: &serde_json::Value| row["error"].as_f64().unwrap().abs() / row["tolerance"].as_f64().unwrap();
        assert!(rows.windows(2).all(|pair| share(&pair[0]) >= share(&pair[1])), "{kind}");
        assert!((group["worst"]["error_over_tolerance"].as_f64().unwrap() - share(&rows[0])).abs() < 1e-9, "{group}");
        first += values;
    }
}

/// Every link of the pages in a folder leads to a file; there are more links and rows of segments than this.
fn check_pages(dir: &Path, [links, rows]: [usize; 2]) {
    let page = std::fs::read_to_string(dir.join("VALIDATION.md")).unwrap();
    for heading in ["Exact solutions", "Measurements and published computations", "Kitchen bands"] {
        assert!(page.contains(&format!("\n## {heading}\n")) && page.contains(&format!("\n- {heading}: ")), "{heading}");
    }
    let linked: Vec<&str> =
        page.split(['(', ')']).filter(|p| p.starts_with("docs/") && !p.contains(char::is_whitespace)).collect();
    assert!(linked.len() > links, "{linked:?}");
    for link in linked {
        assert!(dir.join(link).is_file(), "{link}");
    }
    let segments = std::fs::read_to_string(dir.join("docs/segments.md")).unwrap();
    assert!(segments.lines().filter(|l| l.starts_with("| ")).count() > rows);
}

/// Of the values of each kind, of all cases, at most three in twenty are known to miss, as the page states.
#[test]
fn few_values_of_the_page_are_known_misses() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../VALIDATION.md")).unwrap();
    let mut all = 0;
    for heading in ["Exact solutions", "Measurements and published computations", "Kitchen bands"] {
        let line = page.lines().find_map(|line| line.strip_prefix(&format!("- {heading}: "))).unwrap();
        let numbers: Vec<u32> = line.split([' ', ';']).filter_map(|word| word.parse().ok()).collect();
        let (held, values) = (numbers[0], numbers[1]);
        assert!(values > 5 && 20 * (values - held) <= 3 * values, "{line}");
        all += values;
    }
    assert!(all > 140, "only {all} values");
}

#[test]
fn an_unknown_case_is_refused_with_the_known_ones() {
    let ran = run(&["validate", "--case", "nothing"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("remedy:") && ran.err.contains("burger-flipped-once"), "{}", ran.err);
}

#[test]
fn the_lab_prints_every_key_and_refuses_bad_cases() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    let good = "duration_s = 60\noutput_every_s = 30\n[body]\nshape = \"sphere\"\nsize_mm = [30]\ninitial_c = 5\n\
        [material]\nfood = \"beef-lean\"\n[[boundary]]\nface = \"all\"\nh_w_m2k = 50\nambient_c = 90\n\
        [[probe]]\nname = \"centre\"\nat_mm = [0, 0, 0]\n[report]\nvolume_above_c = [40]\n";
    std::fs::write(&path, good).unwrap();
    let ran = run(&["lab", path.to_str().unwrap(), "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let report: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    for key in
        ["nodes", "steps", "wall_s", "stopped_at_s", "probes", "volume_pct_above", "absorbed_j", "max_c", "min_c"]
    {
        assert!(report.get(key).is_some(), "{key}");
    }
    assert_eq!(report["probes"]["centre"].as_array().unwrap().len(), 3);
    std::fs::write(&path, good.replace("sphere", "cone")).unwrap();
    let ran = run(&["lab", path.to_str().unwrap()]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("case.toml:4:") && ran.err.contains("remedy:"), "{}", ran.err);
}

#[test]
fn the_heat_bench_prints_every_number_and_its_brick_is_exact() {
    let ran = run(&["bench", "heat", "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let bench: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let number = |pointer: &str| bench.pointer(pointer).and_then(serde_json::Value::as_f64).expect(pointer);
    assert!(number("/brick/max_error_k") <= 0.1 && number("/brick/half_step_error_k") <= 0.1, "{bench}");
    for pointer in [
        "/brick/loop_s",
        "/brick/nodes",
        "/brick/steps",
        "/updates_per_s",
        "/bandwidth_fraction",
        "/scaling/nodes/0",
        "/scaling/seconds/0",
        "/scaling/exponent",
        "/steak/nodes",
        "/steak/real_time_factor",
    ] {
        assert!(number(pointer) > 0.0, "{pointer}: {bench}");
    }
}

#[test]
fn the_lab_prints_fluxes_phases_and_vapour_and_its_schema_names_their_keys() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("stack.toml");
    let stack = "duration_s = 60\n[pan]\nkind = \"cast-iron-26\"\ninitial_c = 200\nq_w_m2 = 5000\n\
        [[body]]\nshape = \"slab\"\nsize_mm = [10]\ninitial_c = 20\ncontact_h_w_m2k = 900\n\
        [[body]]\nshape = \"slab\"\nsize_mm = [5]\ninitial_c = 5\n\
        [material]\nconductivity_w_mk = 0.48\ndensity_kg_m3 = 1050\nspecific_heat_j_kgk = 3500\nwater_kg_m3 = 700\n\
        [[phase]]\nuntil = { at_s = 20 }\n[[phase]]\n[[phase.boundary]]\nface = \"top\"\nh_w_m2k = 15\nambient_c = 25\n\
        [[probe]]\nname = \"border\"\nat_mm = [10]\nflux = true\n[report]\npeak_of = \"border\"\n";
    std::fs::write(&path, stack).unwrap();
    let ran = run(&["lab", path.to_str().unwrap(), "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let report: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(report["phases_ended_s"][0], 20.0, "{report}");
    assert!(
        report["evaporated_kg_m2"].as_f64().unwrap() > 0.0 && report["core_peak_c"].as_f64().unwrap() > 5.0,
        "{report}"
    );
    assert_eq!(report["flux"]["border"].as_array().unwrap().len(), report["probes"]["pan"].as_array().unwrap().len());
    let schema = run(&["schema", "lab"]).out;
    for key in ["contact_h_w_m2k", "juice", "rule", "phase", "until", "peak_of", "q_w_m2", "step_factor", "grading"] {
        assert!(schema.contains(&format!("\"{key}\"")), "{key}");
    }
    for (from, to, line) in [("cast-iron-26", "wok", 3), ("at_mm = [10]", "at_mm = [16]", 29), ("0.48", "nan", 16)] {
        std::fs::write(&path, stack.replace(from, to)).unwrap();
        let ran = run(&["lab", path.to_str().unwrap()]);
        assert_eq!(ran.code, Some(2), "{}", ran.out);
        assert!(ran.err.contains(&format!("stack.toml:{line}:")) && ran.err.contains("remedy:"), "{}", ran.err);
    }
}
