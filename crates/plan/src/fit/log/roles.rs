//! Which column is which: by headers, and by what its values can be.

use super::header_words::{has_any, words_of};
use super::stamp::Stamp;
use super::table::Table;
use super::values::Value;

/// Words of columns of times.
const TIME: [&str; 18] = [
    "time",
    "timestamp",
    "datetime",
    "date",
    "elapsed",
    "clock",
    "seconds",
    "minutes",
    "millis",
    "changed",
    "zeit",
    "uhrzeit",
    "datum",
    "heure",
    "hora",
    "時刻",
    "日時",
    "時間",
];
/// Words of the core, the surest first.
const CORE: [&[&str]; 4] = [
    &["core", "kern", "coeur", "cœur", "núcleo", "nucleo", "芯", "中心"],
    &["internal", "inside", "innen", "内部"],
    &["meat", "food", "steak", "beef", "burger", "patty", "fleisch", "viande", "carne", "肉"],
    &[
        "probe",
        "thermocouple",
        "tc",
        "bt",
        "temp",
        "temperature",
        "sensor",
        "channel",
        "fühler",
        "sonde",
        "温度",
        "プローブ",
    ],
];
/// Words of the pan.
const PAN: [&str; 12] = [
    "pan",
    "skillet",
    "griddle",
    "frypan",
    "plancha",
    "pfanne",
    "poêle",
    "sartén",
    "padella",
    "フライパン",
    "鍋",
    "鉄板",
];
/// Words of columns that are neither the core's nor the pan's temperatures.
const OTHER: [&str; 38] = [
    "target",
    "set",
    "setpoint",
    "goal",
    "alarm",
    "alert",
    "high",
    "low",
    "min",
    "max",
    "limit",
    "estimated",
    "predicted",
    "prediction",
    "peak",
    "rate",
    "battery",
    "rssi",
    "humidity",
    "ambient",
    "pit",
    "grill",
    "oven",
    "smoker",
    "chamber",
    "air",
    "surface",
    "room",
    "fan",
    "id",
    "number",
    "sequence",
    "session",
    "serial",
    "error",
    "fault",
    "junction",
    "et",
];

/// What is known of a table's columns.
pub(super) struct Roles<'t> {
    table: &'t Table,
    words: Vec<Vec<String>>,
}

impl<'t> Roles<'t> {
    /// Looks at a table.
    pub fn of(table: &'t Table) -> Self {
        Self { table, words: table.headers.iter().map(|header| words_of(header)).collect() }
    }

    /// Returns the column of times, and that of the clock where date and clock have a column each.
    pub fn time(&self) -> (usize, Option<usize>) {
        let all = || 0..self.words.len();
        let named = |at: &usize| self.is_time_header(*at) && self.holds_times(*at);
        let clocked = |at: &usize| self.share(*at, |stamp| !stamp.date.is_empty() || stamp.clock.len() > 1) > 0.5;
        let time = all().find(named).or_else(|| all().find(clocked)).unwrap_or(0);
        (time, self.other_half(time))
    }

    /// The column that completes a date with a clock, or a clock with a date.
    pub fn other_half(&self, time: usize) -> Option<usize> {
        let has_date = |at: usize| self.share(at, |stamp| !stamp.date.is_empty()) > 0.5;
        let has_clock = |at: usize| self.share(at, |stamp| stamp.clock.len() > 1) > 0.5;
        let (date, clock) = (has_date(time), has_clock(time));
        let completes = |at: &usize| {
            *at != time
                && ((date && !clock && has_clock(*at) && !has_date(*at))
                    || (clock && !date && has_date(*at) && !has_clock(*at)))
        };
        (0..self.words.len()).find(completes)
    }

    fn is_time_header(&self, at: usize) -> bool {
        let words = &self.words[at];
        let is_short = words.first().is_some_and(|word| word == "t") && words.len() < 3;
        let counts_down = has_any(words, &["remaining", "left", "eta", "target", "alarm", "prediction"]);
        (is_short || has_any(words, &TIME)) && !counts_down
    }

    fn holds_times(&self, at: usize) -> bool {
        self.share(at, |_| true) > 0.5
    }

    /// Share of a column's fields that are times of a kind [-].
    fn share(&self, at: usize, is: impl Fn(&Stamp) -> bool) -> f64 {
        let (mut given, mut times) = (0_u32, 0_u32);
        for field in self.table.column(at).filter(|field| !field.is_empty()) {
            given += 1;
            times += u32::from(Stamp::of(field).is_some_and(|stamp| is(&stamp)));
        }
        f64::from(times) / f64::from(given.max(1))
    }

    /// Returns the columns of temperatures whose headers name the pan.
    pub fn pans(&self, times: &[usize]) -> Vec<usize> {
        self.temperatures(times).filter(|at| self.is_pan(*at)).collect()
    }

    /// Returns the columns that the surest of the core's words name; without any, all that hold temperatures, unless one is the pan's.
    pub fn cores(&self, times: &[usize], has_pan: bool) -> Vec<usize> {
        let is_other = |at: &usize| self.is_pan(*at) || has_any(&self.words[*at], &OTHER) || self.is_cold_junction(*at);
        let own: Vec<usize> = self.temperatures(times).filter(|at| !is_other(at)).collect();
        let named = |words: &&[&str]| -> Vec<usize> {
            own.iter().copied().filter(|at| has_any(&self.words[*at], words)).collect()
        };
        CORE.iter().map(named).find(|found| !found.is_empty()).unwrap_or(if has_pan { Vec::new() } else { own })
    }

    fn is_pan(&self, at: usize) -> bool {
        has_any(&self.words[at], &PAN)
    }

    /// True for the inner temperature of a thermocouple's amplifier, which loggers call internal.
    fn is_cold_junction(&self, at: usize) -> bool {
        let is_thermocouple = |words: &Vec<String>| has_any(words, &["thermocouple", "tc", "external"]);
        has_any(&self.words[at], &["internal"])
            && self.words.iter().any(is_thermocouple)
            && !is_thermocouple(&self.words[at])
    }

    /// Columns of numbers that change, except those of the times.
    fn temperatures(&self, times: &[usize]) -> impl Iterator<Item = usize> {
        let not_time = |at: &usize| !(times.contains(at) || self.is_time_header(*at) && self.table.is_named);
        (0..self.words.len()).filter(move |at| not_time(at) && self.changes(*at))
    }

    fn changes(&self, at: usize) -> bool {
        let values: Vec<f64> = self.table.column(at).filter_map(|field| Value::of(field).number()).collect();
        let first = values.first().copied();
        10 * values.len() > 3 * self.table.rows.len() && values.iter().any(|value| Some(*value) != first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roles(text: &str) -> ((usize, Option<usize>), Vec<usize>, Vec<usize>) {
        let table = Table::of(text).expect("a table");
        let roles = Roles::of(&table);
        let time = roles.time();
        let times: Vec<usize> = std::iter::once(time.0).chain(time.1).collect();
        (time, roles.cores(&times, false), roles.pans(&times))
    }

    #[test]
    fn the_foods_surface_is_no_pan_and_an_estimate_no_core() {
        let head = "Timestamp,VirtualCoreTemperature,VirtualSurfaceTemperature,VirtualAmbientTemperature,EstimatedCoreTemperature,VirtualCoreSensor,PredictionValueSeconds";
        let found = roles(&format!("{head}\n0,6,14,50,6,T1,10\n30,7,15,51,7,T1,20\n"));
        assert_eq!(found, ((0, None), vec![1], vec![]));
    }

    #[test]
    fn a_probe_is_the_core_and_a_pan_is_only_what_is_called_so() {
        assert_eq!(
            roles("Probe1 -°F,Skillet -°F,Time\n43,70,4/5/25 18:03\n44,80,4/5/25 18:04\n"),
            ((2, None), vec![0], vec![1])
        );
        assert_eq!(roles("時刻,芯温,フライパン\n18:03:00,6,200\n18:03:30,7,210\n"), ((0, None), vec![1], vec![2]));
        assert_eq!(roles("Time,Internal,Ambient,Target\n0,6,20,57\n1,7,21,57\n"), ((0, None), vec![1], vec![]));
        assert_eq!(roles("t,Thermocouple C,Internal C\n0,6,24\n1,7,25\n"), ((0, None), vec![1], vec![]));
    }

    #[test]
    fn date_and_clock_may_have_a_column_each() {
        assert_eq!(roles("Date,Time,Probe\n4/5/2025,18:03:00,6\n4/5/2025,18:03:30,7\n").0, (0, Some(1)));
        assert_eq!(roles("Time,Date,Probe\n18:03:00,4/5/2025,6\n18:03:30,4/5/2025,7\n").0, (0, Some(1)));
    }
}
