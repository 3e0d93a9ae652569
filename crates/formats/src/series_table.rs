//! The time series of a cook as a table, with the columns of `series.csv` in full precision.

use saute_recipe::Group;
use saute_recipe::recorder::{COLUMNS, FOOD_COLUMNS, Recorder};

use crate::summary_table::unit_of;
use crate::table::{ColumnKind, Heading, Table, Value};

/// Returns the time series: columns of hob and pan, of each food by its id, then of the means of each group.
pub fn table(recorder: &Recorder, ids: &[&str], groups: &[Group]) -> Table {
    let names = ids.iter().copied().chain(groups.iter().map(|g| g.id.as_str()));
    let of_foods = names.flat_map(|id| FOOD_COLUMNS.map(|column| format!("{id}.{column}")));
    let names = COLUMNS.map(str::to_owned).into_iter().chain(of_foods);
    let headings =
        names.map(|name| Heading { unit: unit_of(&name).to_owned(), name, kind: ColumnKind::Float }).collect();
    let row = |row: &saute_recipe::recorder::Row| {
        let means = groups.iter().map(|g| row.mean(&g.members));
        let foods = row.foods.iter().copied().chain(means).flatten();
        [row.time_s, row.hob_drawn_w, row.pan_c].into_iter().chain(foods).map(|v| Some(Value::Float(v))).collect()
    };
    Table { headings, rows: recorder.rows.iter().map(row).collect(), ..Table::default() }
}
