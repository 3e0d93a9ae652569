//! Promises of a sweep: rows are functions of their number, parts can be read, mistakes are named with file and line.

#![allow(clippy::unwrap_used)]

use saute_formats::{Table, Value};
use saute_sweep::{Base, Manifest, Status, Sweep};

const RECIPE: &str = "[pan]\nkind = \"carbon-steel-26\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 15]\nmesh = \"2013\"\n\
                      [[step]]\nput = \"steak\"\n[[step]]\nat_s = 5\nend = true\n";

fn sweep(text: &str) -> Result<Sweep, saute_schema::InputError> {
    let base = Base { recipe: RECIPE.to_owned(), file: "thin.toml".to_owned(), ..Base::default() };
    Sweep::new(text, "spec.toml", base)
}

fn with_vary(lines: &str) -> String {
    format!("recipe = \"thin.toml\"\nfor_s = 1\n[vary]\n{lines}\n[design]\nkind = \"grid\"\n")
}

#[test]
fn rows_in_any_order_are_the_same_and_come_back_from_a_part() {
    let text =
        with_vary("\"food.steak.size_mm[2]\" = [15, 20, 9000]\n\"pan.initial_c\" = { from = 20, to = 200, n = 2 }");
    let sweep = sweep(&text).unwrap();
    assert_eq!(sweep.manifest().rows, 6);
    let rows: Vec<_> = sweep.part_rows(0).map(|row| sweep.run_row(row)).collect();
    assert!(sweep.part_rows(0).rev().zip(rows.iter().rev()).all(|(row, known)| sweep.run_row(row) == *known));
    let table = Table::from_parquet(sweep.part_file(&rows).unwrap(), |_| true).unwrap();
    assert_eq!(table.headings, sweep.headings());
    assert_eq!(table.numbers("vary.food.steak.size_mm[2]").unwrap()[3], Some(20.0));
    assert_eq!(table.numbers("vary.pan.initial_c").unwrap()[3], Some(200.0));
    let status = table.column("status").unwrap();
    let failed = |row: &Vec<_>| row[status] == Some(Value::Text("failed".into()));
    assert_eq!(table.rows.iter().map(failed).collect::<Vec<_>>(), [false, false, false, false, true, true]);
    assert!(rows[4].status == Status::Failed && rows[4].message.as_ref().unwrap().contains("9000"));
    let masses = table.numbers("food.steak.mass_g.start").unwrap();
    assert!(masses[2] > masses[0] && masses[4].is_none());
}

#[test]
fn a_data_value_varies() {
    let text =
        with_vary("\"hobs.induction.coil.efficiency\" = [0.5, 0.8]\n\"kinetics.beef.browning.anchor_c\" = [140, 150]");
    let sweep = sweep(&text).unwrap();
    let row = sweep.run_row(3);
    assert_eq!((row.status, row.message), (Status::ForS, None));
}

#[test]
fn mistakes_are_named_with_their_line_and_the_nearest_name() {
    for (lines, remedy) in [
        ("\"food.steak.size_m[2]\" = [15, 20]", "write size_mm"),
        ("\"food.stake.size_mm[2]\" = [15, 20]", "write steak"),
        ("\"kinetics.beef.browning.anchor\" = [1, 2]", "write anchor_c"),
        ("\"pan.initial_c\" = { from = 20, too = 60 }", "write to"),
        ("\"pan.initial_c\" = { from = 20, to = 60 }", "add n"),
        ("\"pan.initial_c\" = [9000, 9001]", "0 to 300"),
    ] {
        let error = sweep(&with_vary(lines)).unwrap_err();
        assert_eq!((error.file.as_str(), error.line), ("spec.toml", 4), "{error}");
        assert!(error.remedy.contains(remedy), "{lines}: {error}");
    }
    let error = sweep("recipe = \"x\"\nfor_a = 1\n").unwrap_err();
    assert!(error.line == 2 && error.remedy.contains("write for_s"), "{error}");
}

#[test]
fn numbers_and_lists_that_cannot_be_used_are_refused_with_line_and_remedy() {
    const GRID: &str = "kind = \"grid\"";
    for (part, vary, design, line, remedy) in [
        ("8", "\"pan.initial_c\" = [20]\n\"pan.initial_c\" = [30]", GRID, 5, "leave one of the lines out"),
        ("8", "\"food[0].seed\" = [1]\n\"food.steak.seed\" = [2]", GRID, 5, "leave one of the lines out"),
        ("0", "\"pan.initial_c\" = [20]", GRID, 2, "1 to 100000"),
        ("2.5", "\"pan.initial_c\" = [20]", GRID, 2, "rows_per_part"),
        ("8", "\"pan.initial_c\" = []", GRID, 4, "[20, 40]"),
        ("8", "\"pan.initial_c\" = [20, nan]", GRID, 4, "write a number"),
        ("8", "\"pan.initial_c\" = [20, \"x\"]", GRID, 4, "all of one type"),
        ("8", "\"pan.initial_c\" = { from = 20, to = inf, n = 2 }", GRID, 4, "a finite number"),
        ("8", "\"pan.initial_c\" = { from = -1e308, to = 1e308, n = 2 }", GRID, 4, "closer"),
        ("8", "\"pan.initial_c\" = { from = 20, to = 30, n = 0 }", GRID, 4, "2 to 1000000"),
        ("8", "\"pan.initial_c\" = [301, 302]", GRID, 4, "0 to 300"),
        ("8", "pan.initial_c = [20, 30]", GRID, 4, "in quotes, as "),
        ("8", "\"food.steak.strength[0]\" = [1]", GRID, 4, "there are"),
        ("8", "\"pan.initial_c\" = [20]", "kind = \"sobol\"\nn = 0", 7, "1 or more"),
        ("8", "\"pan.initial_c\" = [20]", "kind = \"sobol\"\nn = 10000001", 7, "smaller n"),
        ("8", "\"pan.initial_c\" = [20]", "kind = \"grid\"\nseed = -1", 7, "0 to 4294967295"),
    ] {
        let text = format!("recipe = \"thin.toml\"\nrows_per_part = {part}\n[vary]\n{vary}\n[design]\n{design}\n");
        let error = sweep(&text).unwrap_err();
        assert_eq!((error.file.as_str(), error.line), ("spec.toml", line), "{text}{error}");
        assert!(error.remedy.contains(remedy), "{text}{error}");
    }
}

#[test]
fn a_value_that_cannot_be_cooked_is_named_before_the_others_are_cooked() {
    let sound = sweep(&with_vary("\"pan.initial_c\" = [20, 25, 30]")).unwrap();
    assert!(sound.doubts().is_empty());
    let text = with_vary("\"pan.initial_c\" = [20, 9000, 30]\n\"food.steak.size_mm[2]\" = [15, 20]");
    let doubts = sweep(&text).unwrap().doubts().to_vec();
    assert_eq!(doubts.len(), 1);
    assert!(doubts[0].line == 4 && doubts[0].message.contains("9000") && doubts[0].remedy.contains("0 to 300"));
}

#[test]
fn a_sweep_goes_as_bytes_to_a_machine_without_its_files() {
    let one = sweep(&with_vary("\"pan.initial_c\" = [20, 30]")).unwrap();
    let other = Sweep::from_bytes(&one.to_bytes()).unwrap().unwrap();
    assert_eq!(other.manifest(), one.manifest());
    assert_eq!(other.run_row(1), one.run_row(1));
    assert!(Sweep::from_bytes(b"nothing").is_none());
}

#[test]
fn a_manifest_whose_numbers_do_not_fit_together_is_refused() {
    let manifest = sweep(&with_vary("\"pan.initial_c\" = [20, 30]")).unwrap().manifest().clone();
    let of = |change: &dyn Fn(&mut Manifest)| {
        let mut changed = manifest.clone();
        change(&mut changed);
        Manifest::parse(&changed.text())
    };
    assert!(of(&|_| ()).is_ok());
    let damages: [&dyn Fn(&mut Manifest); 4] =
        [&|m| m.rows_per_part = 0, &|m| m.rows = 3, &|m| m.varied.clear(), &|m| (m.design.levels[0], m.rows) = (0, 0)];
    damages.into_iter().for_each(|damage| assert!(of(damage).unwrap_err().contains("contradicts itself")));
}

#[test]
fn another_sweep_in_the_same_folder_is_refused_and_the_same_goes_on() {
    let [one, same, other] = ["[20, 30]", "[20, 30] # again", "[20, 31]"]
        .map(|levels| sweep(&with_vary(&format!("\"pan.initial_c\" = {levels}"))).unwrap());
    let found = Manifest::parse(&one.manifest().text()).unwrap();
    assert_eq!(same.manifest().conflict(&found), None);
    assert!(other.manifest().conflict(&found).is_some());
    assert_eq!(
        (Manifest::part_name(7), Manifest::part_of("part-00007.parquet")),
        ("part-00007.parquet".into(), Some(7))
    );
}
