//! Times as minutes and seconds.

/// Returns a time [s] as minutes and seconds: `4:05`.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

/// Returns a time [s] in whole minutes, rounded up: `16`.
pub fn whole_minutes(seconds: f64) -> String {
    format!("{:.0}", (seconds / 60.0).ceil())
}

#[cfg(test)]
mod tests {
    use super::{clock, whole_minutes};

    #[test]
    fn a_minute_that_has_begun_counts() {
        assert_eq!([0.0, 1.0, 60.0, 61.0].map(whole_minutes), ["0", "1", "1", "2"]);
    }

    #[test]
    fn seconds_have_two_digits_and_what_is_before_the_beginning_is_the_beginning() {
        assert_eq!([0.0, 59.9, 61.0, 3600.0, -3.0].map(clock), ["0:00", "0:59", "1:01", "60:00", "0:00"]);
    }
}
