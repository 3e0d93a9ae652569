//! Times as thermometers write them.

/// Returns a time [s], and whether it is that of a clock, whose beginning means nothing: seconds (`90`, `90.5`), min:s (`1:30`), and
/// with two colons a clock (`18:03:20`), with a date before it or without.
pub fn seconds(text: &str) -> Option<(f64, bool)> {
    let text = text.trim().trim_end_matches(['Z', 's']);
    let (day, time) = match text.split_once(['T', ' ']) {
        Some((date, time)) => (days(date)?, time),
        None => (0.0, text),
    };
    let time = time.split(['+']).next().unwrap_or(time);
    let mut parts = Vec::new();
    for part in time.split(':') {
        parts.push(part.trim().replace(',', ".").parse::<f64>().ok().filter(|n| n.is_finite() && *n >= 0.0)?);
    }
    match parts[..] {
        [s] if day == 0.0 => Some((s, false)),
        [min, s] if s < 60.0 && day == 0.0 => Some((60.0 * min + s, false)),
        [h, min] if day > 0.0 && min < 60.0 => Some((86_400.0 * day + 3600.0 * h + 60.0 * min, true)),
        [h, min, s] if min < 60.0 && s < 60.0 => Some((86_400.0 * day + 3600.0 * h + 60.0 * min + s, true)),
        _ => None,
    }
}

/// Number of a day in the Gregorian calendar, of `2026-11-24`, `24.11.2026` or `11/24/2026`.
fn days(date: &str) -> Option<f64> {
    let parts: Vec<i64> = date.split(['-', '.', '/']).map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let [a, b, c] = parts[..] else { return None };
    let (year, month, day) = match date.chars().find(|c| !c.is_ascii_digit()) {
        Some('-') => (a, b, c),
        Some('/') => (c, a, b),
        _ => (c, b, a),
    };
    let is_date = (1900..=2200).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    // Years begin in March, so that the leap day is the last one.
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days = 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day;
    is_date.then_some(days as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_loggers_are_read() {
        let cases = [
            ("90", 90.0, false),
            ("90.5", 90.5, false),
            ("1:30", 90.0, false),
            ("00:01:30", 90.0, true),
            ("2026-11-24T18:00:10Z", 740_250.0 * 86_400.0 + 64_810.0, true),
        ];
        for (text, value, clock) in cases {
            assert_eq!(seconds(text), Some((value, clock)), "{text}");
        }
        for text in ["", "ten", "-5", "1:75", "nan", "1:2:3:4"] {
            assert_eq!(seconds(text), None, "{text}");
        }
    }

    #[test]
    fn midnight_is_a_minute_after_the_minute_before() {
        let at = |text: &str| seconds(text).expect("a time").0;
        for [before, after] in [
            ["2026-11-24", "2026-11-25"],
            ["2026-11-30", "2026-12-01"],
            ["2028-02-28", "2028-02-29"],
            ["2026-12-31", "2027-01-01"],
        ] {
            assert_eq!(at(&format!("{after} 00:00:30")) - at(&format!("{before} 23:59:30")), 60.0, "{before}");
        }
    }
}
