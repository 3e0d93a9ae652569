//! Promise: a cook's summary and series come back from Parquet as they were, with their types and units.

use saute_formats::{ColumnKind, Heading, Table, Value, series_table, summary_table};
use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};

const THIN: &str = "[pan]\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 15]\nmesh = \"2013\"\n\
                    [[step]]\nput = \"steak\"\n[[step]]\nat_s = 2\nend = true\n";

fn cooked() -> Cook {
    let library = Library::embedded().unwrap();
    let mut cook = Cook::new(Recipe::parse(THIN, "thin.toml", &library).unwrap(), &library).unwrap();
    while cook.stopped().is_none() {
        cook.advance().unwrap();
    }
    cook
}

#[test]
fn every_type_and_every_gap_comes_back() {
    let headings = [
        ("a", "°C", ColumnKind::Float),
        ("b", "", ColumnKind::Integer),
        ("c", "", ColumnKind::Flag),
        ("d", "", ColumnKind::Text),
    ];
    let headings = headings.map(|(name, unit, kind)| Heading::new(name, unit, kind)).into();
    let full = vec![
        Some(Value::Float(0.1)),
        Some(Value::Integer(-3)),
        Some(Value::Flag(true)),
        Some(Value::Text("肉".into())),
    ];
    let notes = [("saute.recipe".to_owned(), "medium".to_owned())].into();
    let table = Table { headings, rows: vec![full.clone(), vec![None; 4], full], notes };
    let bytes = table.parquet().unwrap();
    assert_eq!(Table::from_parquet(bytes.clone(), |_| true).unwrap(), table);
    assert_eq!(Table::rows_in_parquet(bytes.clone()).unwrap(), 3);
    assert_eq!(table.parquet().unwrap(), bytes);
    assert!(Table::rows_in_parquet(bytes[..bytes.len() - 9].to_vec()).is_err());
}

#[test]
fn summary_and_series_of_a_cook_come_back_with_units() {
    let cook = cooked();
    let summary = cook.summary(1.0);
    let table = summary_table::table(&summary);
    let back = Table::from_parquet(table.parquet().unwrap(), |_| true).unwrap();
    assert_eq!(back, table);
    assert_eq!(back.numbers("food.steak.core_c.end"), Some(vec![Some(summary.foods[0].core_c.end)]));
    let unit = |name: &str| back.headings[back.column(name).unwrap()].unit.clone();
    let units = ["food.steak.core_c.end", "pan_c.peak", "food.steak.core_c.peak_at_s", "liquids_g.oil", "energy_j.hob"];
    assert_eq!(units.map(unit), ["°C", "°C", "s", "g", "J"]);
    assert_eq!(back.column("wall_s"), None);
    let series = series_table::table(&cook.recorder, &["steak"], &[]);
    let back = Table::from_parquet(series.parquet().unwrap(), |name| name == "steak.mass_g").unwrap();
    let masses: Vec<_> = cook.recorder.rows.iter().map(|row| Some(row.foods[0][3])).collect();
    assert_eq!(back.numbers("steak.mass_g"), Some(masses));
}
