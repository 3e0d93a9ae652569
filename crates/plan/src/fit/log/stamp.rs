//! What one field states about a time, before the column has decided how to read it.

use super::clock_words::{half_of_day, month_of, says_nothing, zone_s};

/// Parts of a time as written.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Stamp {
    /// A plain number.
    pub number: Option<f64>,
    /// A time with units [s]: `5m 30s`.
    pub span_s: Option<f64>,
    /// Numbers of a date, in their order.
    pub date: Vec<i64>,
    /// Place of the month in the date, where its name is there.
    pub month_at: Option<usize>,
    /// True if the date's first number has four digits.
    pub is_year_first: bool,
    /// Numbers of a clock, in their order.
    pub clock: Vec<f64>,
    /// True for the afternoon.
    pub afternoon: Option<bool>,
    /// How far its zone is ahead of Greenwich [s].
    pub zone_s: f64,
}

impl Stamp {
    /// Reads a field; none if it is no time.
    pub fn of(text: &str) -> Option<Self> {
        let text = text.trim().trim_matches(['"', '\'']).trim();
        if let Some(number) = number_of(text) {
            return Some(Self { number: Some(number), ..Self::default() });
        }
        if let Some(span_s) = span_of(text) {
            return Some(Self { span_s: Some(span_s), ..Self::default() });
        }
        let mut stamp = Self::default();
        for token in tokens_of(text) {
            stamp.take(&token)?;
        }
        let is_date = matches!(stamp.date.len(), 0 | 3);
        let is_clock = matches!(stamp.clock.len(), 0 | 2..=4);
        (is_date && is_clock && stamp.date.len() + stamp.clock.len() > 0).then_some(stamp)
    }

    fn take(&mut self, token: &str) -> Option<()> {
        if let Some(half) = half_of_day(token) {
            self.afternoon = Some(half);
        } else if let Some(month) = month_of(token).filter(|_| self.month_at.is_none()) {
            self.month_at = Some(self.date.len());
            self.date.push(month);
        } else if let Some(zone) = zone_s(token).filter(|_| !self.clock.is_empty()) {
            self.zone_s = zone;
        } else if token.contains(':') {
            self.take_clock(token)?;
        } else if token.starts_with(|c: char| c.is_ascii_digit()) {
            self.take_date(token)?;
        } else if !says_nothing(token) {
            return None;
        }
        Some(())
    }

    /// A clock, with a zone or a half of the day at its end or without.
    fn take_clock(&mut self, token: &str) -> Option<()> {
        let digits = token.find(|c: char| !c.is_ascii_digit() && !":.,".contains(c)).unwrap_or(token.len());
        let (clock, rest) = token.split_at(digits);
        for part in clock.trim_end_matches(':').split(':') {
            self.clock.push(part.replace(',', ".").parse::<f64>().ok().filter(|n| n.is_finite())?);
        }
        if rest.is_empty() { Some(()) } else { self.take(rest) }
    }

    /// A date, or one number of it, or eight digits without signs between them.
    fn take_date(&mut self, token: &str) -> Option<()> {
        let token = token.trim_end_matches(['.', ',', '-', '/']);
        for (at, part) in token.split(['-', '/', '.']).enumerate() {
            if let Some(month) = month_of(part) {
                self.month_at = Some(self.date.len());
                self.date.push(month);
                continue;
            }
            let digits: String = part.chars().take_while(char::is_ascii_digit).collect();
            let rest = &part[digits.len()..];
            if !["", "st", "nd", "rd", "th"].contains(&rest) {
                return None;
            }
            if digits.len() == 8 {
                let (year, month_day) = digits.split_at(4);
                self.date = vec![year.parse().ok()?, month_day[..2].parse().ok()?, month_day[2..].parse().ok()?];
                self.is_year_first = true;
                continue;
            }
            if digits.len() == 6 && self.date.len() == 3 {
                self.clock = [0, 2, 4].map(|from| digits[from..from + 2].parse().unwrap_or(f64::NAN)).to_vec();
                continue;
            }
            self.is_year_first |= at == 0 && self.date.is_empty() && digits.len() == 4;
            self.date.push(digits.parse().ok()?);
        }
        Some(())
    }
}

/// Words of a time, with the letters of Japanese dates and clocks as signs.
fn tokens_of(text: &str) -> Vec<String> {
    let text = text.replace(['年', '月'], "-").replace('日', " ").replace(['時', '分'], ":").replace('秒', " ");
    let text = text.replace("午前", " AM ").replace("午後", " PM ");
    let letters: Vec<char> = text.chars().collect();
    let is_digit = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_digit);
    let parted: String = letters
        .iter()
        .enumerate()
        .map(|(at, letter)| match letter {
            'T' | 't' if is_digit(at.checked_sub(1)) && is_digit(Some(at + 1)) => ' ',
            // A comma before the fraction of a second stays.
            ',' if !(is_digit(at.checked_sub(1)) && is_digit(Some(at + 1))) => ' ',
            '_' if is_digit(at.checked_sub(1)) => ' ',
            letter => *letter,
        })
        .collect();
    parted.split_whitespace().filter(|token| !["-", "at", "um", "à"].contains(token)).map(str::to_owned).collect()
}

/// A number with a point or a comma.
pub(super) fn number_of(text: &str) -> Option<f64> {
    if !text.starts_with(|c: char| c.is_ascii_digit() || "+-.,".contains(c)) {
        return None;
    }
    let number = if text.contains(',') { text.replacen(',', ".", 1).parse::<f64>() } else { text.parse() };
    number.ok().filter(|number| number.is_finite())
}

/// A time with units [s]: `90 s`, `5m 30s`, `1h02m`, `5.5 min`, `PT5M30S`.
fn span_of(text: &str) -> Option<f64> {
    let text = text.to_lowercase();
    let mut rest = text.trim_start_matches("pt").trim_start();
    let (mut sum, mut count) = (0.0, 0);
    while !rest.is_empty() {
        let number_end = rest.find(|c: char| !c.is_ascii_digit() && !".,".contains(c))?;
        let number: f64 = rest[..number_end].replace(',', ".").parse().ok()?;
        rest = rest[number_end..].trim_start();
        let unit_end = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
        let factor = match &rest[..unit_end] {
            "ms" | "msec" => 1e-3,
            "s" | "sec" | "secs" | "second" | "seconds" | "sek" => 1.0,
            "m" | "min" | "mins" | "minute" | "minutes" => 60.0,
            "h" | "hr" | "hrs" | "hour" | "hours" | "std" => 3600.0,
            _ => return None,
        };
        sum += factor * number;
        count += 1;
        rest = rest[unit_end..].trim_start();
    }
    (count > 0).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stamp(text: &str) -> Stamp {
        Stamp::of(text).expect(text)
    }

    #[test]
    fn numbers_and_times_with_units_are_read() {
        for (text, value) in [("90", 90.0), ("0,5", 0.5), ("-3.5", -3.5), ("1743876180", 1_743_876_180.0)] {
            assert_eq!(stamp(text).number, Some(value), "{text}");
        }
        for (text, value) in
            [("90 s", 90.0), ("5m 30s", 330.0), ("1h02m", 3720.0), ("5.5 min", 330.0), ("PT5M30S", 330.0)]
        {
            assert_eq!(stamp(text).span_s, Some(value), "{text}");
        }
    }

    #[test]
    fn dates_and_clocks_are_read_in_the_forms_of_programs_and_people() {
        for text in [
            "2025-04-05T18:03:30",
            "2025/4/5 18:03:30",
            "20250405T180330",
            "2025年4月5日 18時03分30秒",
            "2025.04.05, 18:03:30",
        ] {
            let stamp = stamp(text);
            assert_eq!((&stamp.date[..], &stamp.clock[..]), (&[2025, 4, 5][..], &[18.0, 3.0, 30.0][..]), "{text}");
            assert!(stamp.is_year_first, "{text}");
        }
        for text in ["Apr 5, 2025 6:03:30 PM", "Sat Apr 5 2025 6:03:30pm", "April 5th, 2025 06:03:30 p.m."] {
            let stamp = stamp(text);
            assert_eq!(
                (&stamp.date[..], stamp.month_at, stamp.afternoon),
                (&[4, 5, 2025][..], Some(0), Some(true)),
                "{text}"
            );
        }
        assert_eq!(stamp("05-Apr-25 18:03").date, [5, 4, 25]);
        assert_eq!(stamp("4/5/25 18:03").clock, [18.0, 3.0]);
        assert_eq!(stamp("午後6:03").afternoon, Some(true));
    }

    #[test]
    fn a_zone_is_no_part_of_the_clock() {
        for (text, zone) in [
            ("2025-04-05T18:03:00-07:00", -25_200.0),
            ("2025-04-05T18:03:00.123Z", 0.0),
            ("2025-04-05 18:03:00 +0200", 7200.0),
            ("2025-04-05 18:03:00 CEST", 0.0),
            ("2025-04-05 18:03:00 (America/New_York)", 0.0),
        ] {
            let stamp = stamp(text);
            assert_eq!((stamp.zone_s, stamp.clock.len()), (zone, 3), "{text}");
        }
    }

    #[test]
    fn other_text_is_no_time() {
        for text in ["", "ten", "-", "T1", "Cooking", "1:", "10:xx", "12/5", "Probe 1", "nan"] {
            assert_eq!(Stamp::of(text), None, "{text}");
        }
    }
}
