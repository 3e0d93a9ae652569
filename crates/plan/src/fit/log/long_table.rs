//! Tables that have a row for each value of each sensor, as home automation writes them.

use std::collections::BTreeSet;

use super::header_words::{has_any, words_of};
use super::stamp::Stamp;
use super::table::{Row, Table};
use super::values::Value;

/// Words of a column that names the sensor, and of the one with its value.
const SENSOR: [&str; 7] = ["entity", "sensor", "probe", "channel", "series", "metric", "topic"];
const VALUE: [&str; 5] = ["state", "value", "temperature", "temp", "reading"];
/// Most sensors of a log [-] (chosen).
const MOST_SENSORS: usize = 64;

impl Table {
    /// Returns the table with a column for each sensor, if it has a row for each value.
    pub(super) fn with_a_column_each(self) -> Self {
        let Some((sensor, value)) = self.sensor_and_value() else { return self };
        let known: Vec<String> = self.names(sensor).into_iter().map(str::to_owned).collect();
        let width = self.headers.len();
        let unit = self.headers[value].clone();
        let widened = |(line, mut fields): Row| {
            fields.resize(width + known.len(), String::new());
            let of = known.iter().position(|name| *name == fields[sensor]).unwrap_or(0);
            fields[width + of] = std::mem::take(&mut fields[value]);
            (line, fields)
        };
        let header = |name: &String| {
            if is_number(name) { format!("{} {name} {unit}", self.headers[sensor]) } else { name.clone() }
        };
        let mut headers = self.headers.clone();
        headers.extend(known.iter().map(header));
        Self { headers, rows: self.rows.into_iter().map(widened).collect(), is_long: true, ..self }
    }

    /// Places of the column of sensors and of the column of their values.
    fn sensor_and_value(&self) -> Option<(usize, usize)> {
        let words: Vec<Vec<String>> = self.headers.iter().map(|header| words_of(header)).collect();
        // Such headers are short: `entity_id`, `state`. A longer one names a quantity, as `VirtualCoreSensor` does.
        let is_named = |at: usize, wanted: &[&str]| words[at].len() < 3 && has_any(&words[at], wanted);
        let find =
            |wanted: &[&str], is: &dyn Fn(usize) -> bool| (0..words.len()).find(|at| is_named(*at, wanted) && is(*at));
        let sensor = find(&SENSOR, &|at| self.names_sensors(at))?;
        let value = find(&VALUE, &|at| at != sensor && self.holds_numbers(at))?;
        Some((sensor, value))
    }

    /// True if a column contains a few names, again and again.
    fn names_sensors(&self, at: usize) -> bool {
        let is_small = |field: &str| field.parse::<u32>().is_ok_and(|number| number < 17);
        let is_name = |field: &str| !field.is_empty() && (is_small(field) || Stamp::of(field).is_none());
        let known = self.names(at).len();
        known <= MOST_SENSORS && 2 * known <= self.rows.len() && self.column(at).all(is_name)
    }

    /// The different fields of a column, in the order in which they come.
    fn names(&self, at: usize) -> Vec<&str> {
        let mut seen = BTreeSet::new();
        self.column(at).filter(|name| seen.insert(*name)).collect()
    }

    fn holds_numbers(&self, at: usize) -> bool {
        2 * self.column(at).filter(|field| Value::of(field).number().is_some()).count() > self.rows.len()
    }
}

fn is_number(name: &str) -> bool {
    name.parse::<f64>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_for_each_value_becomes_a_column_for_each_sensor() {
        let text = "entity_id,state,last_changed\nsensor.meat,6,2025-04-05T18:00:00Z\nsensor.pan,200,2025-04-05T18:00:05Z\n\
                    sensor.meat,7,2025-04-05T18:00:30Z\nsensor.pan,unavailable,2025-04-05T18:00:35Z\n";
        let table = Table::of(text).expect("a table").with_a_column_each();
        assert_eq!(table.headers[3..], ["sensor.meat", "sensor.pan"]);
        assert!(table.column(3).eq(["6", "", "7", ""]));
        assert_eq!(table.column(4).nth(1), Some("200"));
    }

    #[test]
    fn a_column_of_a_probes_temperatures_stays_one() {
        let text = "time,probe,temperature of the room\n0,5,20\n30,6,20\n60,7,20\n";
        let table = Table::of(text).expect("a table");
        assert_eq!(table.clone().with_a_column_each(), table);
    }
}
