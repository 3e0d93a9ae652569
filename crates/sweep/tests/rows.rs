//! Promises of a sweep: rows are functions of their number, parts can be read, mistakes are named with file and line.

#![allow(clippy::unwrap_used)]

use saute_formats::{Table, Value};
use saute_sweep::{Base, Manifest, Status, Sweep};

const RECIPE: &str = "[pan]\nkind = \"carbon-steel-26\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 15]\nmesh = \"2013\"\n\
                      [[step]]\nput = \"steak\"\n[[step]]\nat_s = 5\nend = true\n";

fn sweep(text: &str) -> Result<Sweep, saute_kitchen::InputError> {
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
