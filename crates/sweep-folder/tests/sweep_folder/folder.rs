//! Promises of a sweep's folder: no row is lost or comes twice, whoever ends when; its files do not depend on who cooked.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use saute_formats::{Table, Value};
use saute_sweep::{Base, Sweep};
use saute_sweep_folder::cooking::cook_all;
use saute_sweep_folder::{ROWS, SweepFolder};

const RECIPE: &str = "[pan]\nkind = \"carbon-steel-26\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 15]\n\
                      [[step]]\nput = \"steak\"\n[[step]]\nat_s = 5\nend = true\n";
const SPEC: &str = "recipe = \"thin.toml\"\nfor_s = 0.2\ncoarseness = 4\nrows_per_part = 4\n[vary]\n\
                    \"food.steak.size_mm[2]\" = [15, 20, 9000]\n\"pan.initial_c\" = { from = 20, to = 60, n = 3 }\n[design]\nkind = \"grid\"\n";

fn sweep() -> Arc<Sweep> {
    let base = Base { recipe: RECIPE.to_owned(), file: "thin.toml".to_owned(), ..Base::default() };
    Arc::new(Sweep::new(SPEC, "spec.toml", base).unwrap())
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder.join(ROWS)).unwrap().map(Result::unwrap);
    entries.map(|e| (e.file_name().into_string().unwrap(), std::fs::read(e.path()).unwrap())).collect()
}

fn rows(folder: &Path) -> Vec<i64> {
    let parts = files(folder).into_iter().filter(|(name, _)| name.ends_with(".parquet"));
    let tables = parts.map(|(_, bytes)| Table::from_parquet(bytes, |name| name == "row").unwrap());
    let row = |row: Vec<Option<Value>>| if let Some(Value::Integer(row)) = row[0] { row } else { -1 };
    tables.flat_map(|table| table.rows).map(row).collect()
}

#[test]
fn the_files_are_the_same_for_any_number_of_threads_and_the_folder_is_tidy() {
    let (one, three) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    for (dir, jobs) in [(&one, 1), (&three, 3)] {
        let folder = SweepFolder::open(dir.path(), sweep()).unwrap();
        let tally = cook_all(folder, jobs, &|_| (), &|| true).unwrap();
        assert_eq!((tally.done, tally.failed, tally.fresh, tally.is_complete()), (9, 3, 9, true));
        assert!(!dir.path().join("unfinished").exists());
    }
    assert_eq!(files(one.path()), files(three.path()));
    assert_eq!(files(one.path()).len(), 4, "three parts and their checksums");
    assert_eq!(rows(one.path()), (0..9).collect::<Vec<_>>());
}

#[test]
fn a_sweep_that_is_broken_off_again_and_again_ends_with_every_row_once() {
    let dir = tempfile::tempdir().unwrap();
    let mut fresh = 0;
    for _ in 0..40 {
        let folder = SweepFolder::open(dir.path(), sweep()).unwrap();
        assert_eq!(folder.tally().done, fresh);
        // Ticks, of which a row has two or three.
        let ticks = AtomicU64::new(7);
        let may_go_on = || ticks.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |t| t.checked_sub(1)).is_ok();
        let tally = cook_all(folder, 1, &|_| (), &may_go_on).unwrap();
        fresh += tally.fresh;
        assert_eq!(tally.done, fresh);
        if tally.is_complete() {
            break;
        }
    }
    let whole = tempfile::tempdir().unwrap();
    cook_all(SweepFolder::open(whole.path(), sweep()).unwrap(), 2, &|_| (), &|| true).unwrap();
    assert_eq!((fresh, files(dir.path())), (9, files(whole.path())));
    let again = SweepFolder::open(dir.path(), sweep()).unwrap();
    assert_eq!((again.tally().done, again.tally().failed), (9, 3));
    assert_eq!(cook_all(again, 1, &|_| (), &|| true).unwrap().fresh, 0);
}

#[test]
fn a_result_that_comes_twice_is_taken_once_and_a_row_that_comes_back_is_handed_out_again() {
    let dir = tempfile::tempdir().unwrap();
    let sweep = sweep();
    let mut folder = SweepFolder::open(dir.path(), Arc::clone(&sweep)).unwrap();
    let rows: Vec<u64> = (0..5).filter_map(|_| folder.next_row()).collect();
    assert_eq!(rows, [0, 1, 2, 3, 4]);
    let result = sweep.run_row(1);
    folder.take(&result).unwrap();
    folder.take(&result).unwrap();
    rows.into_iter().for_each(|row| folder.give_back(row));
    assert_eq!(folder.tally().done, 1);
    assert_eq!(std::iter::from_fn(|| folder.next_row()).collect::<Vec<_>>(), [0, 2, 3, 4, 5, 6, 7, 8]);
}

#[test]
fn a_folder_that_is_written_to_or_holds_something_else_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let held = SweepFolder::open(dir.path(), sweep()).unwrap();
    let error = SweepFolder::open(dir.path(), sweep()).unwrap_err();
    assert!(error.message.contains("another program is writing there"), "{error}");
    drop(held);
    let base = Base { recipe: RECIPE.to_owned(), file: "thin.toml".to_owned(), ..Base::default() };
    let other = Arc::new(Sweep::new(&SPEC.replace("60", "61"), "spec.toml", base).unwrap());
    let error = SweepFolder::open(dir.path(), other).unwrap_err();
    assert!(error.message.contains("another recipe, data or values"), "{error}");
    let foreign = tempfile::tempdir().unwrap();
    std::fs::create_dir(foreign.path().join(ROWS)).unwrap();
    std::fs::write(foreign.path().join("rows/theirs.parquet"), "x").unwrap();
    assert!(SweepFolder::open(foreign.path(), sweep()).unwrap_err().message.contains("something else"));
    let damaged = dir.path().join("rows/part-00000.parquet");
    std::fs::write(&damaged, "cut off").unwrap();
    assert!(SweepFolder::open(dir.path(), sweep()).unwrap_err().remedy.contains("remove this file"));
}

#[test]
fn a_part_in_which_one_bit_was_changed_is_not_taken_for_complete() {
    let dir = tempfile::tempdir().unwrap();
    cook_all(SweepFolder::open(dir.path(), sweep()).unwrap(), 1, &|_| (), &|| true).unwrap();
    let part = dir.path().join(ROWS).join("part-00001.parquet");
    let mut bytes = std::fs::read(&part).unwrap();
    let middle = bytes.len() / 3;
    bytes[middle] ^= 1;
    std::fs::write(&part, &bytes).unwrap();
    let error = SweepFolder::open(dir.path(), sweep()).unwrap_err();
    assert!(error.message.contains("checksum") && error.remedy.contains("cooked again"), "{error}");
    std::fs::remove_file(&part).unwrap();
    let tally = cook_all(SweepFolder::open(dir.path(), sweep()).unwrap(), 1, &|_| (), &|| true).unwrap();
    assert!(tally.is_complete() && tally.fresh == 4, "{tally:?}");
}

#[cfg(unix)]
#[test]
fn a_pipe_in_the_place_of_a_file_is_refused_by_name_and_nothing_waits_for_it() {
    for (name, is_complete) in [
        ("sweep.json", true),
        ("rows/part-00000.parquet", true),
        ("unfinished/lock", false),
        ("unfinished/part-00000.rows", false),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let folder = SweepFolder::open(dir.path(), sweep()).unwrap();
        if is_complete {
            cook_all(folder, 1, &|_| (), &|| true).unwrap();
        } else {
            drop(folder);
        }
        let pipe = dir.path().join(name);
        let _ = std::fs::remove_file(&pipe);
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let refused = SweepFolder::open(dir.path(), sweep()).unwrap_err();
        assert!(refused.message.contains("is a pipe or a device, not a file"), "{name}: {refused}");
        assert!(refused.place.starts_with(&dir.path().display().to_string()), "{name}: {refused}");
    }
}
