//! The times of a log: how its whole column reads.

use serde::{Deserialize, Serialize};

use super::header_words::{has_any, words_of};
use super::moment::{DateOrder, since_midnight};
use super::stamp::Stamp;

/// What the times of a log are.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TimeForm {
    /// Milliseconds since a beginning.
    Milliseconds,
    /// Seconds since a beginning.
    Seconds,
    /// Minutes since a beginning.
    Minutes,
    /// Hours since a beginning.
    Hours,
    /// Days since a beginning, as spreadsheets count.
    Days,
    /// Minutes and seconds since a beginning: `1:30`.
    MinSec,
    /// Hours and minutes: `18:03`.
    HourMin,
    /// Hours, minutes and seconds: `18:03:20`.
    Clock,
    /// A date with a clock.
    Dated,
    /// Seconds, or parts of them, since 1970.
    Epoch,
    /// Times with their units: `5m 30s`.
    WithUnits,
}

impl TimeForm {
    /// Forms of plain numbers.
    const NUMBERS: [Self; 5] = [Self::Seconds, Self::Minutes, Self::Milliseconds, Self::Hours, Self::Days];

    /// Returns its name in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Milliseconds => "milliseconds",
            Self::Seconds => "seconds",
            Self::Minutes => "minutes",
            Self::Hours => "hours",
            Self::Days => "days",
            Self::MinSec => "minutes and seconds",
            Self::HourMin => "hours and minutes",
            Self::Clock => "hours, minutes and seconds",
            Self::Dated => "date and clock",
            Self::Epoch => "time since 1970",
            Self::WithUnits => "times with units",
        }
    }

    /// Seconds in one of it, of a plain number.
    fn factor(self) -> f64 {
        match self {
            Self::Milliseconds => 1e-3,
            Self::Minutes => 60.0,
            Self::Hours => 3600.0,
            Self::Days => 86_400.0,
            _ => 1.0,
        }
    }

    /// The form that a header's words name for plain numbers.
    fn of_header(words: &[String]) -> Option<Self> {
        let names: [(Self, &[&str]); 5] = [
            (Self::Milliseconds, &["ms", "msec", "millis", "milliseconds"]),
            (Self::Seconds, &["s", "sec", "secs", "seconds", "sekunden", "秒"]),
            (Self::Minutes, &["min", "mins", "minutes", "minuten", "分"]),
            (Self::Hours, &["h", "hr", "hrs", "hours", "stunden"]),
            (Self::Days, &["days", "tage"]),
        ];
        names.into_iter().find(|(_, words_of_it)| has_any(words, words_of_it)).map(|(form, _)| form)
    }
}

/// Shortest and longest log of a cook [s] (chosen: nothing is cooked within a minute, and none of these foods for six hours).
const COOK_S: [f64; 2] = [60.0, 6.0 * 3600.0];
/// Numbers above it count from 1970 [s] (chosen: thirty years of seconds; no log counts so far from its own beginning).
const EPOCH_S: f64 = 1e9;
/// A time that goes back by more than this share of the log's span begins another recording [-] (chosen).
const OTHER_RECORDING: f64 = 0.2;

/// Half a day [s].
const HALF_DAY_S: f64 = 43_200.0;

/// Times of a log's rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Times {
    /// How they were read.
    pub form: TimeForm,
    /// Time of each row [s] since the log's beginning; none where a row has none.
    pub at_s: Vec<Option<f64>>,
    /// True if the newest row came first.
    pub is_newest_first: bool,
}

/// Why times cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NoTimes {
    /// The row's field is no time.
    Row(usize),
    /// Another recording begins at the row.
    Back(usize),
    /// Several forms make sense.
    Several(Vec<TimeForm>),
}

/// Reads the times of a column by its header and all of its fields; `asked` is the form that was requested.
pub(super) fn times_of(header: &str, fields: &[String], asked: Option<TimeForm>) -> Result<Times, NoTimes> {
    let stamps: Vec<Option<Stamp>> = fields.iter().map(|field| Stamp::of(field)).collect();
    few_missing(fields, &stamps)?;
    let words = words_of(header);
    let given: Vec<&Stamp> = stamps.iter().flatten().collect();
    let form = match asked {
        Some(form) => form,
        None => form_of(&words, &given)?,
    };
    let order = order_of(&given);
    let raw: Vec<Option<f64>> =
        stamps.iter().map(|stamp| stamp.as_ref().and_then(|stamp| raw_s(stamp, form, order))).collect();
    if let Some(row) = (0..raw.len()).find(|row| stamps[*row].is_some() && raw[*row].is_none()) {
        return Err(NoTimes::Row(row));
    }
    let counts_from_first = match form {
        TimeForm::Dated | TimeForm::Epoch => true,
        TimeForm::Clock => !has_any(&words, &ELAPSED) && given.iter().all(|stamp| stamp.clock.len() != 2),
        TimeForm::HourMin => !has_any(&words, &ELAPSED),
        TimeForm::Days => raw.iter().flatten().next().is_some_and(|first| *first > 366.0 * 86_400.0),
        _ => false,
    };
    ordered(raw, form, counts_from_first)
}

/// Words of a time since a beginning.
const ELAPSED: [&str; 6] = ["elapsed", "since", "duration", "timer", "経過", "dauer"];

/// Rows may have no time where they are few: at most a tenth.
fn few_missing(fields: &[String], stamps: &[Option<Stamp>]) -> Result<(), NoTimes> {
    let missing: Vec<usize> =
        (0..stamps.len()).filter(|row| stamps[*row].is_none() && !fields[*row].is_empty()).collect();
    match missing.first() {
        Some(row) if 10 * missing.len() > stamps.len() => Err(NoTimes::Row(*row)),
        _ => Ok(()),
    }
}

fn form_of(words: &[String], stamps: &[&Stamp]) -> Result<TimeForm, NoTimes> {
    let all = |is: fn(&Stamp) -> bool| stamps.iter().all(|stamp| is(stamp));
    if stamps.iter().any(|stamp| !stamp.date.is_empty()) {
        return Ok(TimeForm::Dated);
    }
    if stamps.iter().any(|stamp| stamp.span_s.is_some()) {
        return Ok(TimeForm::WithUnits);
    }
    if all(|stamp| stamp.number.is_some()) {
        return form_of_numbers(words, stamps);
    }
    if stamps.iter().any(|stamp| stamp.clock.len() > 2) {
        return Ok(TimeForm::Clock);
    }
    form_of_two_parts(words, stamps)
}

/// Plain numbers: as the header states, since 1970, or in the unit in which they span a cook.
fn form_of_numbers(words: &[String], stamps: &[&Stamp]) -> Result<TimeForm, NoTimes> {
    let numbers = || stamps.iter().filter_map(|stamp| stamp.number);
    if numbers().next().is_some_and(|first| first > EPOCH_S) {
        return Ok(TimeForm::Epoch);
    }
    if let Some(form) = TimeForm::of_header(words) {
        return Ok(form);
    }
    let span = numbers().fold(f64::MIN, f64::max) - numbers().fold(f64::MAX, f64::min);
    let makes_sense = |form: &TimeForm| (COOK_S[0]..=COOK_S[1]).contains(&(span * form.factor()));
    let forms: Vec<TimeForm> = TimeForm::NUMBERS.into_iter().filter(makes_sense).collect();
    match forms[..] {
        // A few rows of a test, or a log of a day: seconds, as most loggers count.
        [] | [TimeForm::Seconds, ..] => Ok(TimeForm::Seconds),
        [form] => Ok(form),
        _ => Err(NoTimes::Several(forms)),
    }
}

/// Two numbers with a colon are minutes and seconds, or hours and minutes: the one that spans a cook.
fn form_of_two_parts(words: &[String], stamps: &[&Stamp]) -> Result<TimeForm, NoTimes> {
    if stamps.iter().any(|stamp| stamp.afternoon.is_some()) {
        return Ok(TimeForm::HourMin);
    }
    let is_hour = |stamp: &&&Stamp| stamp.clock.first().is_none_or(|hour| *hour < 24.0);
    if stamps.iter().filter(is_hour).count() < stamps.len() {
        return Ok(TimeForm::MinSec);
    }
    let span = span_of_two_parts(stamps);
    let begins_at_zero = stamps.first().is_some_and(|stamp| stamp.clock.first() == Some(&0.0));
    let [min_sec, hour_min] = [span, 60.0 * span].map(|span| (COOK_S[0]..=COOK_S[1]).contains(&span));
    match (min_sec, hour_min) {
        (true, false) => Ok(TimeForm::MinSec),
        (false, true) => Ok(TimeForm::HourMin),
        (true, true) if !begins_at_zero && !has_any(words, &ELAPSED) => {
            Err(NoTimes::Several(vec![TimeForm::MinSec, TimeForm::HourMin]))
        }
        _ => Ok(TimeForm::MinSec),
    }
}

/// From the least time to the largest, in the unit of the second number; a clock goes on after midnight.
fn span_of_two_parts(stamps: &[&Stamp]) -> f64 {
    let (mut least, mut most, mut last, mut days) = (f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0);
    for stamp in stamps {
        let now = stamp.number.unwrap_or_else(|| stamp.clock.iter().fold(0.0, |sum, part| 60.0 * sum + part));
        days += if now + 720.0 < last { 1440.0 } else { 0.0 };
        last = now;
        least = f64::min(least, now + days);
        most = f64::max(most, now + days);
    }
    most - least
}

/// The order of dates in which all of them are dates and the log is shortest.
fn order_of(stamps: &[&Stamp]) -> DateOrder {
    let dated = || stamps.iter().filter(|stamp| !stamp.date.is_empty());
    let span = |order: DateOrder| -> Option<f64> {
        let days: Vec<f64> = dated().map(|stamp| day_of(stamp, order)).collect::<Option<_>>()?;
        Some(days.iter().fold(f64::MIN, |a, b| a.max(*b)) - days.iter().fold(f64::MAX, |a, b| a.min(*b)))
    };
    let spans = DateOrder::ALL.into_iter().filter_map(|order| Some((span(order)?, order)));
    spans.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(DateOrder::Ymd, |(_, order)| order)
}

fn day_of(stamp: &Stamp, order: DateOrder) -> Option<f64> {
    let order = match stamp.month_at {
        Some(0) => DateOrder::Mdy,
        Some(_) if !stamp.is_year_first => DateOrder::Dmy,
        _ if stamp.is_year_first => DateOrder::Ymd,
        _ => order,
    };
    order.day(&stamp.date)
}

/// A field's time in a form [s].
fn raw_s(stamp: &Stamp, form: TimeForm, order: DateOrder) -> Option<f64> {
    match form {
        TimeForm::Dated => {
            let clock = if stamp.clock.is_empty() { 0.0 } else { since_midnight(&stamp.clock, stamp.afternoon)? };
            Some(86_400.0 * day_of(stamp, order)? + clock - stamp.zone_s)
        }
        TimeForm::Epoch => stamp.number.map(seconds_of_epoch),
        TimeForm::WithUnits => stamp.span_s.or(stamp.number),
        TimeForm::Clock | TimeForm::HourMin => match stamp.clock.len() {
            0 => stamp.number,
            // Before its first hour a timer shows minutes and seconds.
            2 if form == TimeForm::Clock => minutes_and_seconds(&stamp.clock),
            _ => since_midnight(&stamp.clock, stamp.afternoon),
        },
        TimeForm::MinSec => stamp.number.or_else(|| minutes_and_seconds(&stamp.clock)),
        _ => stamp.number.map(|number| form.factor() * number),
    }
}

fn minutes_and_seconds(clock: &[f64]) -> Option<f64> {
    let [min, s] = *clock else { return None };
    (s < 60.0).then_some(60.0 * min + s)
}

/// Seconds of a number since 1970 in seconds, milliseconds, microseconds or nanoseconds.
fn seconds_of_epoch(number: f64) -> f64 {
    let thousands = [1e12, 1e15, 1e18].iter().filter(|from| 0.1 * *from < number).count();
    number / 1000_f64.powi(thousands as i32)
}

/// Puts rows in the order of time; times of a clock without a date go on after midnight.
fn ordered(mut raw: Vec<Option<f64>>, form: TimeForm, from_first: bool) -> Result<Times, NoTimes> {
    let has_no_date = matches!(form, TimeForm::Clock | TimeForm::HourMin);
    let given: Vec<f64> = raw.iter().flatten().copied().collect();
    let back = |pair: &&[f64]| {
        let step = pair[1] - pair[0];
        // Without a date, half a day back is midnight.
        if has_no_date && step.abs() > HALF_DAY_S { step > 0.0 } else { step < 0.0 }
    };
    let backs = given.windows(2).filter(back).count();
    let is_newest_first = 2 * backs > given.windows(2).filter(|pair| pair[0] != pair[1]).count();
    if is_newest_first {
        raw.reverse();
    }
    if has_no_date {
        over_midnight(&mut raw);
    }
    if !matches!(form, TimeForm::Dated | TimeForm::Epoch) {
        one_recording(&raw)?;
    }
    let least = raw.iter().flatten().fold(f64::INFINITY, |a, b| a.min(*b));
    let origin = if from_first { least } else { 0.0 };
    let mut at_s: Vec<Option<f64>> = raw.into_iter().map(|at| at.map(|at| at - origin)).collect();
    if is_newest_first {
        at_s.reverse();
    }
    Ok(Times { form, at_s, is_newest_first })
}

fn over_midnight(raw: &mut [Option<f64>]) {
    let (mut last, mut days) = (f64::NEG_INFINITY, 0.0);
    for at in raw.iter_mut().flatten() {
        // Half a day back is midnight; a little is a row that came late.
        if *at + 86_400.0 * days < last - HALF_DAY_S {
            days += 1.0;
        }
        *at += 86_400.0 * days;
        last = *at;
    }
}

/// A time that goes far back begins another recording, which is not mixed into the first.
fn one_recording(raw: &[Option<f64>]) -> Result<(), NoTimes> {
    let given: Vec<(usize, f64)> = raw.iter().enumerate().filter_map(|(row, at)| Some((row, (*at)?))).collect();
    let span = given.iter().map(|(_, at)| *at).fold(f64::MIN, f64::max) - given.first().map_or(0.0, |(_, at)| *at);
    let back = given.windows(2).find(|pair| pair[1].1 < pair[0].1 - OTHER_RECORDING * span);
    back.map_or(Ok(()), |pair| Err(NoTimes::Back(pair[1].0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(header: &str, fields: &[&str]) -> Result<Times, NoTimes> {
        let fields: Vec<String> = fields.iter().map(|field| (*field).to_owned()).collect();
        times_of(header, &fields, None)
    }

    fn last(header: &str, fields: &[&str]) -> (TimeForm, f64) {
        let times = read(header, fields).expect("times");
        (times.form, times.at_s.last().copied().flatten().expect("a time"))
    }

    #[test]
    fn two_numbers_with_a_colon_are_what_spans_a_cook() {
        assert_eq!(last("Time", &["7:03", "7:04", "7:17"]), (TimeForm::HourMin, 840.0), "rows a minute apart");
        assert_eq!(last("Time", &["0:00", "7:00", "14:00"]), (TimeForm::MinSec, 840.0));
        assert_eq!(last("Time", &["25:00", "26:00"]), (TimeForm::MinSec, 1560.0), "no hour is 25");
        assert_eq!(last("Time", &["11:55 PM", "12:05 AM"]), (TimeForm::HourMin, 600.0), "over midnight");
        let several = read("Time", &["1:00", "2:30", "4:00"]);
        assert_eq!(several, Err(NoTimes::Several(vec![TimeForm::MinSec, TimeForm::HourMin])));
    }

    #[test]
    fn plain_numbers_are_what_the_header_says_or_what_spans_a_cook() {
        assert_eq!(last("time_s", &["0", "30", "840"]), (TimeForm::Seconds, 840.0));
        assert_eq!(last("Elapsed (min)", &["0", "0.5", "14"]), (TimeForm::Minutes, 840.0));
        assert_eq!(last("millis", &["0", "30000", "840000"]), (TimeForm::Milliseconds, 840.0));
        assert_eq!(last("Time", &["0", "7.5", "14"]), (TimeForm::Minutes, 840.0), "no cook lasts 14 s, none 14 h");
        assert_eq!(last("Time", &["0", "300000", "840000"]), (TimeForm::Milliseconds, 840.0));
        let (form, end) = last("", &["45752.750000", "45752.755", "45752.7597222"]);
        assert!(form == TimeForm::Days && (end - 840.0).abs() < 0.01, "{end}");
        for first in ["1743876180", "1743876180000", "1743876180000000"] {
            let end = first.replacen("1743876180", "1743877020", 1);
            assert_eq!(last("", &[first, &end]), (TimeForm::Epoch, 840.0), "{first}");
        }
    }

    #[test]
    fn the_whole_column_decides_the_order_of_day_and_month() {
        assert_eq!(last("", &["04/05/25 23:59:30", "05/05/25 00:00:30"]).1, 60.0, "day first");
        assert_eq!(last("", &["04/05/25 23:59:30", "04/06/25 00:00:30"]).1, 60.0, "month first");
        assert_eq!(last("", &["2025/4/5 18:00:00", "2025/4/5 18:00:30"]).1, 30.0);
        assert_eq!(last("", &["5-Apr-25 18:00", "5-Apr-25 18:14"]).1, 840.0);
        assert_eq!(last("", &["2025-11-02T01:59:00-07:00", "2025-11-02T01:00:00-08:00"]).1, 60.0, "summer time ends");
    }

    #[test]
    fn the_newest_row_may_stand_first_and_a_row_may_come_late() {
        let times = read("Time", &["2025-04-05 18:01:00", "2025-04-05 18:00:00"]).expect("times");
        assert_eq!((times.is_newest_first, times.at_s), (true, vec![Some(60.0), Some(0.0)]));
        let late =
            read("Time", &["2025-04-05 18:00:00", "2025-04-05 18:01:00", "2025-04-05 18:00:55", "2025-04-05 18:02:00"]);
        assert_eq!(late.expect("times").at_s[2], Some(55.0));
        let two = read("time_s", &["0", "30", "60", "0", "30", "60"]);
        assert_eq!(two, Err(NoTimes::Back(3)), "a second recording begins");
    }

    #[test]
    fn a_clock_counts_from_its_first_row_and_a_timer_as_it_stands() {
        assert_eq!(last("Time", &["18:03:20", "18:04:20"]), (TimeForm::Clock, 60.0));
        assert_eq!(last("Elapsed", &["0:00:20", "0:01:20"]), (TimeForm::Clock, 80.0));
        assert_eq!(last("Time", &["0:30", "59:30", "1:00:30"]).1, 3630.0, "a timer that gets an hour");
    }
}
