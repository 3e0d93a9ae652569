//! `saute study` and `saute class`.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::running::run;

fn included() -> String {
    format!("{}/../../studies/simulated", env!("CARGO_MANIFEST_DIR"))
}

fn text(path: &Path) -> String {
    path.to_str().expect("text").to_owned()
}

/// The shipped protocol with one trial on each side of the stove.
fn short_protocol(folder: &Path) -> String {
    let shipped = format!("{}/../../studies/2013.toml", env!("CARGO_MANIFEST_DIR"));
    let protocol = fs::read_to_string(shipped).unwrap();
    let path = folder.join("short.toml");
    fs::write(&path, protocol.replace("trials = 4", "trials = 1").replace("trials = 2", "trials = 1")).unwrap();
    text(&path)
}

#[test]
fn simulated_participants_write_logs_with_a_dictionary_and_their_report_says_that_they_are_simulated() {
    let folder = tempfile::tempdir().unwrap();
    let (protocol, logs, out) = (short_protocol(folder.path()), folder.path().join("logs"), folder.path().join("out"));
    let ran = run(&["study", "simulate", &protocol, "--participants", "2", "--seed", "3", "--out", &text(&logs)]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    for name in ["study-S01.csv", "study-S02.csv", "data-dictionary.csv", "data-dictionary.md"] {
        assert!(logs.join(name).exists(), "{name}");
    }
    let ran = run(&["study", "analyse", &text(&logs), "--out", &text(&out), "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let json: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((json["simulated"].as_bool(), json["participants"].as_array().unwrap().len()), (Some(true), 2));
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("<title>Study 2013: simulated participants</title>") && page.contains("<svg"));
    assert!(page.contains("n = 2 simulated participants (A: 1, B: 1); missing trials: 0"), "{page}");
    for name in ["curves.csv", "before-after.csv", "participants.csv"] {
        assert!(fs::read_to_string(out.join(name)).unwrap().lines().count() > 2, "{name}");
    }
}

#[test]
fn logs_of_different_studies_are_refused_with_reason_and_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let log = fs::read_to_string(Path::new(&included()).join("study-S01.csv")).unwrap();
    let other = folder.path().join("study-X1.csv");
    fs::write(&other, log.replace("\n2013,", "\nother,").replace(",S01,", ",X1,")).unwrap();
    let ran = run(&["study", "analyse", &included(), &text(&other)]);
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.err.contains("several studies: 2013, other") && ran.err.contains("remedy: analyse each"),
        "{}",
        ran.err
    );
    fs::write(&other, "time,core\n1,2\n").unwrap();
    let ran = run(&["study", "analyse", &text(&other)]);
    assert!(ran.code == Some(2) && ran.err.contains("is no row of a study's log"), "{}", ran.err);
    let ran = run(&["study", "analyse", &text(folder.path().join("none").as_path())]);
    assert_eq!(ran.code, Some(2));
}

#[test]
fn a_wrong_protocol_or_code_is_named_before_the_window_opens() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let protocol = fs::read_to_string(short_protocol(folder.path())).unwrap();
    fs::write(&path, protocol.replace("speed = 5", "speed = 50")).unwrap();
    let out = text(&folder.path().join("logs"));
    let ran = run(&["study", &text(&path), "--participant", "P01", "--out", &out]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("speed = 50 is out of range") && ran.err.contains("1 to 20"), "{}", ran.err);
    let ran = run(&["study", "2013", "--participant", "Anna Lee", "--out", &out]);
    assert!(ran.code == Some(2) && ran.err.contains("no names"), "{}", ran.err);
    let ran = run(&["study", "2014", "--participant", "P01", "--out", &out]);
    assert!(ran.code == Some(2) && ran.err.contains("shipped protocol: 2013"), "{}", ran.err);
    let ran = run(&["open", "--scenario", "soup"]);
    assert!(ran.code == Some(2) && ran.err.contains("first-steak, when-to-flip, carry-over"), "{}", ran.err);
}

/// A result as a lesson gives it.
fn result(student: &str, score: f64) -> String {
    let head = "scenario,checksum,student,goal,is_met,score,target_share_pct,beyond_pct,grey_band_mm,core_peak_c,crust_pct,\
                charred_pct,lost_pct,energy_kj,flips,put_s,out_s,end_s,q1_answer,q1_truth,q2_answer,q2_truth,q3_answer,q3_truth,\
                q4_answer,q4_truth";
    format!(
        "{head}\nfirst-steak,0a,{student},study-2013,true,{score},45,20,4,62,70,0,15,300,2,60,400,700,30,34,,,,,,\n"
    )
}

#[test]
fn the_results_of_a_class_become_one_file_with_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    let files: Vec<String> = [("S02", 40.0), ("S01", 50.0), ("S03", 60.0)]
        .iter()
        .map(|(student, score)| {
            let path = folder.path().join(format!("{student}.csv"));
            fs::write(&path, result(student, *score)).unwrap();
            text(&path)
        })
        .collect();
    let out = text(&folder.path().join("class.csv"));
    let named: Vec<&str> = files.iter().chain([&files[0]]).map(String::as_str).collect();
    let ran = run(&[&["class", "collect"], named.as_slice(), &["--out", &out]].concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("first-steak (0a): 3 results of 3 students, 0 without a code"), "{}", ran.out);
    assert!(
        ran.out.contains("score 50.0") && ran.out.contains("question 1: 3 answers, 3 compared, median error 4.0"),
        "{}",
        ran.out
    );
    assert!(ran.out.contains("1 result was there twice"), "{}", ran.out);
    collects_what_teachers_name(folder.path());
    let merged = fs::read_to_string(&out).unwrap();
    let students: Vec<&str> = merged.lines().skip(1).filter_map(|line| line.split(',').nth(2)).collect();
    assert_eq!(students, ["S01", "S02", "S03"]);
    let again = run(&["class", "collect", &out, "--json"]);
    let json: Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!(json["scenarios"][0]["results"], 3);
    let bar = |answers, truths| format!("30 to 40 |{}{} {answers} answers", "#".repeat(answers), "o".repeat(truths));
    assert!(ran.out.replace("      ", "").contains(&bar(3, 3)), "{}", ran.out);
}

/// A folder, a pattern that no shell has resolved, and a file that is no result: it is named and left out.
fn collects_what_teachers_name(folder: &Path) {
    for named in [text(folder), text(&folder.join("*.csv")), text(&folder.join("S0*.csv"))] {
        let ran = run(&["class", "collect", &named]);
        assert!(ran.code == Some(0) && ran.out.contains("3 results of 3 students"), "{named}: {} {}", ran.out, ran.err);
    }
    fs::write(folder.join("notes.csv"), "a,b\n1,2\n").unwrap();
    fs::write(folder.join("empty.csv"), "").unwrap();
    let ran = run(&["class", "collect", &text(folder)]);
    assert!(ran.code == Some(1) && ran.out.contains("3 results of 3 students"), "{} {}", ran.out, ran.err);
    assert!(ran.err.contains("notes.csv") && ran.err.contains("empty.csv"), "{}", ran.err);
    let nothing = tempfile::tempdir().unwrap();
    let ran = run(&["class", "collect", &text(&nothing.path().join("*.csv"))]);
    assert!(ran.code == Some(2) && ran.err.contains("no result is there"), "{}", ran.err);
}

/// Results that are there may be those of students.
#[test]
fn simulated_students_write_over_no_result() {
    let folder = tempfile::tempdir().unwrap();
    let there = folder.path().join("first-steak-SIM-02.csv");
    fs::write(&there, "kept").unwrap();
    let ran = run(&["class", "simulate", "first-steak", "--students", "2", "--out", &text(folder.path())]);
    assert!(ran.code == Some(2) && ran.err.contains("first-steak-SIM-02.csv: is there already"), "{}", ran.err);
    assert_eq!(fs::read_to_string(&there).unwrap(), "kept");
}

/// The peak that a file of before noted may be that of the instant at which the lesson was ended.
#[test]
fn a_truth_that_was_noted_before_the_food_had_rested_is_said_to_be_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let (path, out) = (text(&folder.path().join("S01.csv")), text(&folder.path().join("class.csv")));
    fs::write(&path, result("S01", 40.0).replace(",30,34,,", ",30,62,,")).unwrap();
    let ran = run(&["class", "collect", &path, "--out", &out]);
    assert!(ran.out.contains("question 1: 1 answer, not compared\n    1 truths left out"), "{}", ran.out);
    let merged = fs::read_to_string(&out).unwrap();
    assert!(merged.lines().nth(1).unwrap().contains(",30.0,,"), "{merged}");
}

#[test]
fn shipped_studies_and_scenarios_are_listed() {
    let studies = run(&["list", "studies"]);
    assert!(studies.code == Some(0) && studies.out.contains("2013"), "{}", studies.err);
    let scenarios = run(&["list", "scenarios"]);
    assert!(["first-steak", "when-to-flip", "carry-over"].iter().all(|id| scenarios.out.contains(id)));
}
