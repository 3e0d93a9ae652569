//! Words within times: months, halves of the day, zones.

/// Returns the number of a month from the first letters of its name, in English, German, French or Spanish.
pub(super) fn month_of(word: &str) -> Option<i64> {
    const MONTHS: [&[&str]; 12] = [
        &["jan", "ene"],
        &["feb", "fév"],
        &["mar", "mär"],
        &["apr", "avr", "abr"],
        &["may", "mai"],
        &["jun", "juin"],
        &["jul", "juil"],
        &["aug", "aoû", "ago"],
        &["sep"],
        &["oct", "okt"],
        &["nov"],
        &["dec", "dez", "déc", "dic"],
    ];
    let word = word.to_lowercase();
    let is = |names: &&[&str]| word.chars().count() >= 3 && names.iter().any(|name| word.starts_with(name));
    MONTHS.iter().position(is).map(|at| at as i64 + 1)
}

/// Returns true for the afternoon, false for the morning, of `PM`, `a.m.`.
pub(super) fn half_of_day(word: &str) -> Option<bool> {
    match word.replace('.', "").to_lowercase().as_str() {
        "am" | "a" => Some(false),
        "pm" | "p" => Some(true),
        _ => None,
    }
}

/// Returns true for words that give no information about the time between two rows: days of the week, names of zones.
pub(super) fn says_nothing(word: &str) -> bool {
    let word = word.trim_matches(['(', ')', '[', ']', '.']);
    let days = ["mon", "tue", "wed", "thu", "fri", "sat", "sun", "die", "mit", "don", "fre", "sam", "son"];
    let is_day = days.iter().any(|day| word.to_lowercase().starts_with(day));
    let is_zone = (1..=5).contains(&word.len()) && word.chars().all(|c| c.is_ascii_uppercase());
    word.is_empty()
        || is_day
        || is_zone
        || word.contains('/') && word.chars().all(|c| c.is_alphabetic() || "/_".contains(c))
}

/// Returns how far a zone is ahead of Greenwich [s], of `+02:00`, `-0700`, `Z`.
pub(super) fn zone_s(word: &str) -> Option<f64> {
    if word.eq_ignore_ascii_case("z") {
        return Some(0.0);
    }
    let (sign, rest) = match word.split_at_checked(1)? {
        ("+", rest) => (1.0, rest),
        ("-", rest) => (-1.0, rest),
        _ => return None,
    };
    let digits: String = rest.chars().filter(|c| *c != ':').collect();
    let number = |text: &str| text.parse::<u32>().ok();
    let (hours, minutes) = match digits.len() {
        2 => (number(&digits)?, 0),
        4 => {
            let (hours, minutes) = digits.split_at_checked(2)?;
            (number(hours)?, number(minutes)?)
        }
        _ => return None,
    };
    (hours <= 14 && minutes < 60).then_some(sign * (3600.0 * f64::from(hours) + 60.0 * f64::from(minutes)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zones_have_two_or_four_digits() {
        assert_eq!(["Z", "+02", "-0730", "+05:30"].map(zone_s), [0.0, 7200.0, -27_000.0, 19_800.0].map(Some));
        for none in ["+1ÿ1", "+ÿÿ", "+2500", "+0160", "02:00", "+1"] {
            assert_eq!(zone_s(none), None, "{none}");
        }
    }
}
