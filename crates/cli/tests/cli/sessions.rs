//! Sessions: `cook --record`, `replay`, and `shot` of a session; refusals, damage and kills.

use std::path::{Path, PathBuf};
use std::process::{Command as Process, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use saute_kitchen::{Command, Library};
use saute_recipe::session::{Deed, Entry, MOST_ACTS};
use saute_recipe::{Recipe, Recording};
use serde_json::Value;

use crate::running::{Ran, SHORT, run, saute};

/// Longest wall time that a killed cook may lose.
const LOST: Duration = Duration::from_secs(1);
/// Kills of a run of ./test.sh: a tenth of those of the campaign.
const SHARE_KILLS: u64 = 20;
/// Cooks that run at once (chosen: they wait most of the time).
const LANES: usize = 3;

struct Recorded {
    dir: tempfile::TempDir,
    session: PathBuf,
    recipe: PathBuf,
    ran: Ran,
}

/// Cooks a recipe and records it.
fn record(text: &str) -> Recorded {
    let dir = tempfile::tempdir().unwrap();
    let (recipe, session) = (dir.path().join("short.toml"), dir.path().join("short.saute"));
    std::fs::write(&recipe, text).unwrap();
    let ran = run(&["cook", name(&recipe), "--json", "--record", name(&session)]);
    Recorded { dir, session, recipe, ran }
}

fn name(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// Numbers without the wall time.
fn numbers(ran: &Ran) -> Value {
    let mut summary: Value = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}\n{}", ran.err));
    summary.as_object_mut().unwrap().remove("wall_s").expect("a wall time");
    summary
}

#[test]
fn a_replay_gives_the_numbers_of_the_cook() {
    let tossed = SHORT.replace("[[step]]\nafter_s = 10\nend", "[[step]]\ntoss = true\n[[step]]\nafter_s = 10\nend");
    for text in [SHORT.to_owned(), tossed, SHORT.replace("max_s = 100", "max_s = 15")] {
        let recorded = record(&text);
        let replayed = run(&["replay", name(&recorded.session), "--json"]);
        assert_eq!(replayed.code, recorded.ran.code, "{}", replayed.err);
        assert_eq!(numbers(&replayed), numbers(&recorded.ran));
        assert_eq!(crate::running::names_in(recorded.dir.path()), ["short.saute", "short.toml"]);
    }
}

#[test]
fn a_session_of_a_recipe_is_written_as_that_recipe() {
    let recorded = record(SHORT);
    let made = recorded.dir.path().join("made.toml");
    let ran = run(&["replay", name(&recorded.session), "--to-recipe", name(&made)]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("Short"), "{}", ran.out);
    assert_eq!(std::fs::read_to_string(made).unwrap(), SHORT);
}

#[test]
fn an_earlier_session_is_replaced() {
    let recorded = record(SHORT);
    let ran = run(&["cook", name(&recorded.recipe), "--record", name(&recorded.session)]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let opened = Recording::from_file(&std::fs::read(&recorded.session).unwrap()).unwrap();
    assert_eq!(opened.damage, None);
    assert!((opened.recording.moment().time_s() - 20.0).abs() < 1e-9);
}

#[test]
fn a_damaged_end_is_said_and_the_rest_opens() {
    let recorded = record(SHORT);
    let mut bytes = std::fs::read(&recorded.session).unwrap();
    bytes.extend_from_slice(b"half a record");
    std::fs::write(&recorded.session, &bytes).unwrap();
    let ran = run(&["replay", name(&recorded.session), "--json"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.err.contains("last 13 bytes are damaged") && ran.err.contains("up to 20.0 s"), "{}", ran.err);
    assert_eq!(numbers(&ran), numbers(&recorded.ran));
}

/// What no hand can do may be in a session from elsewhere: it is refused with its reason, and the cook goes on without it.
#[test]
fn a_session_that_asks_for_what_no_hand_can_is_refused_with_the_reason() {
    for (case, why) in [
        ("food-at-0-k", "food begins with -25 to 60 °C"),
        ("shake-nan", "shake.amplitude_mm may be 0 to 100"),
        ("toss-minus-1-m", "toss.height_mm may be 0 to 500"),
    ] {
        let path = format!("{}/tests/cli/cases/{case}.saute", env!("CARGO_MANIFEST_DIR"));
        let ran = run(&["replay", &path, "--json"]);
        assert_eq!(ran.code, Some(1), "{case}: {}", ran.err);
        assert!(ran.err.contains(why) && ran.err.contains("remedy"), "{case}: {}", ran.err);
        assert!(!ran.err.contains("frozen"), "{case}: {}", ran.err);
        assert!(numbers(&ran)["energy_j"]["imbalance"].is_number(), "{case}: {}", ran.out);
    }
}

#[test]
fn other_data_are_said_and_a_departure_has_exit_code_1() {
    let recorded = record(SHORT);
    let food = saute_kitchen::Library::embedded_files()["foods/beef-lean.toml"].clone();
    let data = recorded.dir.path().join("data");
    std::fs::create_dir_all(data.join("foods")).unwrap();
    let replayed = |text: &str| {
        std::fs::write(data.join("foods/beef-lean.toml"), text).unwrap();
        run(&["replay", name(&recorded.session), "--data", name(&data), "--json"])
    };
    let same = replayed(&food);
    assert_eq!((same.code, same.err.as_str()), (Some(0), ""));
    let commented = replayed(&format!("{food}\n# More words.\n"));
    assert!(commented.err.contains("is not what it was"), "{}", commented.err);
    let wetter = food.lines().map(|line| if line.starts_with("emissivity") { "emissivity = 0.5" } else { line });
    let other = replayed(&wetter.collect::<Vec<_>>().join("\n"));
    assert_eq!(other.code, Some(1), "{}", other.err);
    assert!(other.err.contains("the replay departs at ") && other.err.contains("remedy"), "{}", other.err);
}

#[test]
fn what_cannot_be_recorded_or_replayed_is_refused_with_a_remedy() {
    let recorded = record(SHORT);
    let (recipe, session) = (name(&recorded.recipe), name(&recorded.session));
    let folder = recorded.dir.path().join("folder.saute");
    std::fs::create_dir(&folder).unwrap();
    let missing = recorded.dir.path().join("none/a.saute");
    for (args, part) in [
        (vec!["replay", recipe], "no session of saute"),
        (vec!["replay", name(&folder)], "is a folder"),
        (vec!["replay", "none.saute"], "cannot be read"),
        (vec!["cook", session], "saute replay"),
        (vec!["cook", recipe, "--record", "session.txt"], "FILE.saute"),
        (vec!["cook", recipe, "--record", name(&folder)], "is not a file"),
        (vec!["cook", recipe, "--record", name(&missing)], "cannot be written"),
        (vec!["replay", session, "--to-recipe", name(recorded.dir.path())], "is not a file"),
    ] {
        let ran = run(&args);
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{args:?}");
        assert!(ran.err.contains(part) && ran.err.contains("remedy: "), "{args:?}: {}", ran.err);
    }
}

#[test]
fn a_picture_of_a_session_is_that_of_its_recipe() {
    let recorded = record(SHORT);
    let picture = |source: &Path, at: &[&str]| {
        let out = recorded.dir.path().join("shot.png");
        let args = ["shot", name(source), "--size", "96x64", "--view", "temperature", "--out", name(&out)];
        let ran = run(&[&args, at].concat());
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        std::fs::read(out).unwrap()
    };
    for at in ["5", "20"].map(|at| ["--at", at]) {
        assert!(picture(&recorded.recipe, &at) == picture(&recorded.session, &at), "{at:?} s");
    }
    let end = picture(&recorded.recipe, &[]);
    assert!(end == picture(&recorded.session, &[]) && end == picture(&recorded.session, &["--at", "20"]));
    let late = run(&["shot", name(&recorded.session), "--at", "30", "--out", "late.png"]);
    assert_eq!(late.code, Some(2));
    assert!(late.err.contains("past the end"), "{}", late.err);
}

/// Writes a session of a recipe to which a number of entries were added, the last one at a frame.
fn long_session(dir: &Path, entries: usize, frame: u64) -> PathBuf {
    let library = Library::embedded().unwrap();
    let recipe = Recipe::parse(SHORT, "short.toml", &library).unwrap();
    let begun = || Recording::begin(&recipe, false, &library);
    let mut file = begun().unsaved();
    // In two halves: a program ends a session at its limits.
    for half in [1..=entries / 2, entries / 2 + 1..=entries] {
        let mut recording = begun();
        drop(recording.unsaved());
        for entry in half {
            let frame = frame * entry as u64 / entries as u64;
            recording.restore(Entry { frame, after_steps: false, deed: Deed::Command(Command::Hob(0.0)) });
        }
        file.extend(recording.unsaved());
    }
    let path = dir.join("long.saute");
    std::fs::write(&path, file).unwrap();
    path
}

/// Frames of six days.
const SIX_DAYS: u64 = 6 * 24 * 3600 * 60;

#[cfg(target_os = "linux")]
#[test]
fn a_replay_of_days_ends_with_130_when_it_is_stopped_and_so_does_a_cook_without_files() {
    let dir = tempfile::tempdir().unwrap();
    let (session, recipe) = (long_session(dir.path(), 1, SIX_DAYS), dir.path().join("long.toml"));
    std::fs::write(&recipe, SHORT.replace("max_s = 100", "max_s = 80000").replace("after_s = 10", "after_s = 30000"))
        .unwrap();
    for args in [["replay", name(&session)], ["cook", name(&recipe)]] {
        let child = saute().args(args).stderr(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let pid = child.id().to_string();
        while !catches_interrupts(&pid) {
            std::thread::sleep(Duration::from_millis(5));
        }
        assert!(Process::new("kill").args(["-INT", &pid]).status().unwrap().success());
        let ended: Ran = child.wait_with_output().unwrap().into();
        assert_eq!(ended.code, Some(130), "{args:?}: {}", ended.err);
        assert!(ended.err.contains("interrupted at") && ended.err.contains("nothing was written"), "{}", ended.err);
    }
}

/// Returns true once a process has its own handler for SIGINT.
#[cfg(target_os = "linux")]
fn catches_interrupts(pid: &str) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
    u64::from_str_radix(caught.trim(), 16).unwrap() >> 1 & 1 == 1
}

#[test]
fn a_session_of_too_many_entries_is_played_up_to_its_limit_and_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let session = long_session(dir.path(), MOST_ACTS + 1000, 600);
    let ran = run(&["replay", name(&session)]);
    assert!(ran.err.contains("at most 500000 entries, 50000 of them no poses"), "{}", ran.err);
    assert!(ran.err.contains("the session opens up to 9."), "{}", ran.err);
}

/// Number of kills: SAUTE_RANDOM_KILLS, or the share of the campaign that ./test.sh makes.
fn kills() -> u64 {
    std::env::var("SAUTE_RANDOM_KILLS").map_or(SHARE_KILLS, |count| count.parse().expect("a number"))
}

/// Kills a recorded cook after its start, or after its first write, and returns the simulated time in its session [s]; nothing if the kill came
/// before the first write was over.
fn killed_after(after_first_write: bool, wait: Duration, recipe: &Path, session: &Path) -> Option<f64> {
    let _ = std::fs::remove_file(session);
    let mut child = saute()
        .args(["cook", name(recipe), "--record", name(session)])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    if after_first_write {
        // However slow the machine is, there is something to lose then.
        let is_written = || std::fs::metadata(session).is_ok_and(|file| file.len() > 0);
        while !is_written() && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
    }
    std::thread::sleep(wait);
    let killed = SystemTime::now();
    child.kill().unwrap();
    child.wait().unwrap();
    let bytes = std::fs::read(session).ok()?;
    let lost = killed.duration_since(std::fs::metadata(session).unwrap().modified().unwrap()).unwrap_or_default();
    assert!(lost <= LOST, "after {wait:?}: {lost:?} lost");
    let opened = Recording::from_file(&bytes);
    // A kill within the very first write leaves an empty file; nothing was cooked then.
    assert!(opened.is_ok() || bytes.len() < 4096, "after {wait:?}: {} bytes", bytes.len());
    Some(opened.ok()?.recording.moment().time_s())
}

#[test]
fn a_killed_cook_loses_at_most_a_second() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = dir.path().join("long.toml");
    std::fs::write(&recipe, SHORT.replace("max_s = 100", "max_s = 80000").replace("after_s = 10", "after_s = 30000"))
        .unwrap();
    // Every fourth is spread over the start and the first write, the others over some later ones; golden ratio steps fall everywhere.
    let wait = |kill: u64| Duration::from_millis(20 + (1400.0 * (kill as f64 * 0.618_033_988_749_895).fract()) as u64);
    let next = AtomicU64::new(0);
    let lane = &|lane: usize| {
        let session = dir.path().join(format!("long-{lane}.saute"));
        let turns = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed)).take_while(|kill| *kill < kills());
        turns.filter_map(|kill| killed_after(kill % 4 > 0, wait(kill), &recipe, &session)).collect::<Vec<f64>>()
    };
    let reached: Vec<f64> = std::thread::scope(|scope| {
        let lanes: Vec<_> = (0..LANES).map(|i| scope.spawn(move || lane(i))).collect();
        lanes.into_iter().flat_map(|lane| lane.join().unwrap()).collect()
    });
    let longest = reached.iter().copied().fold(0.0, f64::max);
    println!("{} of {} killed sessions open; the longest reached {longest:.1} s", reached.len(), kills());
    assert!(reached.len() as u64 > kills() / 2);
}
