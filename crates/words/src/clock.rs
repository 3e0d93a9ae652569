//! Times as minutes and seconds.

/// Returns a time [s] as minutes and seconds: `4:05`.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0) as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

#[cfg(test)]
mod tests {
    use super::clock;

    #[test]
    fn seconds_have_two_digits_and_what_is_before_the_beginning_is_the_beginning() {
        assert_eq!([0.0, 59.9, 61.0, 3600.0, -3.0].map(clock), ["0:00", "0:59", "1:01", "60:00", "0:00"]);
    }
}
