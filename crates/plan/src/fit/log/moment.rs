//! Moments of a calendar.

/// Order of the numbers of a date.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DateOrder {
    /// Year, month, day.
    Ymd,
    /// Day, month, year.
    Dmy,
    /// Month, day, year.
    Mdy,
}

impl DateOrder {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Ymd, Self::Dmy, Self::Mdy];

    /// Returns the number of a date's day in the Gregorian calendar; none if it is no date in this order.
    pub fn day(self, date: &[i64]) -> Option<f64> {
        let [a, b, c] = *date else { return None };
        let (year, month, day) = match self {
            Self::Ymd => (a, b, c),
            Self::Dmy => (c, b, a),
            Self::Mdy => (c, a, b),
        };
        // A year of two digits is of this century (chosen: no thermometer logged before it).
        day_number(if (0..100).contains(&year) { year + 2000 } else { year }, month, day)
    }
}

/// Number of a day in the Gregorian calendar.
fn day_number(year: i64, month: i64, day: i64) -> Option<f64> {
    let is_date = (1900..=2200).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    if !is_date {
        return None;
    }
    // Years begin in March, so that the leap day is the last one.
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days = 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day;
    Some(days as f64)
}

/// Returns the time since midnight [s] of hours, minutes and seconds, in the half of the day that is named.
pub(super) fn since_midnight(clock: &[f64], afternoon: Option<bool>) -> Option<f64> {
    let (h, min, s) = match *clock {
        [h, min] => (h, min, 0.0),
        [h, min, s] => (h, min, s),
        [d, h, min, s] => (24.0 * d + h, min, s),
        _ => return None,
    };
    let h = match afternoon {
        Some(is_after) if h <= 12.0 => h % 12.0 + if is_after { 12.0 } else { 0.0 },
        Some(_) => return None,
        None => h,
    };
    (min < 60.0 && s < 60.0).then_some(3600.0 * h + 60.0 * min + s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_day_after_is_one_day_later() {
        let day = |date: [i64; 3]| DateOrder::Ymd.day(&date).expect("a date");
        for [before, after] in [
            [[2026, 11, 24], [2026, 11, 25]],
            [[2026, 11, 30], [2026, 12, 1]],
            [[2028, 2, 28], [2028, 2, 29]],
            [[2026, 12, 31], [2027, 1, 1]],
        ] {
            assert_eq!(day(after) - day(before), 1.0, "{before:?}");
        }
        assert_eq!(DateOrder::Mdy.day(&[4, 5, 25]), DateOrder::Ymd.day(&[2025, 4, 5]));
        assert_eq!(DateOrder::Mdy.day(&[13, 5, 25]), None);
        assert_eq!(DateOrder::Ymd.day(&[i64::MAX, 1, i64::MIN]), None);
    }

    #[test]
    fn noon_and_midnight_are_twelve() {
        assert_eq!(since_midnight(&[12.0, 0.0], Some(true)), Some(43_200.0));
        assert_eq!(since_midnight(&[12.0, 30.0, 0.0], Some(false)), Some(1800.0));
        assert_eq!(since_midnight(&[18.0, 75.0], None), None);
    }
}
