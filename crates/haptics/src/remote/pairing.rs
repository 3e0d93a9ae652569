//! Pairing with a code on the screen: six random digits, compared in constant time, with few attempts.

use std::fmt;
use std::time::{Duration, Instant};

use ring::rand::{SecureRandom, SystemRandom};
use subtle::ConstantTimeEq;

/// Number of digits (chosen: quick to type; twenty attempts guess one code in fifty thousand).
pub const DIGITS: usize = 6;
/// Number of wrong codes after which pairing is closed until the program restarts (chosen: more than a person mistypes).
const MOST_WRONG: u32 = 20;
/// Wait after the first wrong code; each further one doubles it [s] (chosen: a person needs as long to type).
const FIRST_WAIT_S: f64 = 1.0;
/// Longest wait after a wrong code [s] (chosen: a person waits no longer).
const LONGEST_WAIT_S: f64 = 60.0;

/// A pairing code, new at every start.
#[derive(Clone)]
pub struct Pairing {
    code: [u8; DIGITS],
    wrong: u32,
    closed_until: Option<Instant>,
}

/// Result of an attempt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Admission {
    /// The code is correct.
    Paired,
    /// The code is wrong or came too soon after a wrong one; no code is accepted for this time.
    Wait(Duration),
    /// Too many codes were wrong: no code is accepted any more.
    Closed,
}

/// The system provided no random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the system provided no random numbers for a pairing code")]
pub struct NoRandom;

impl Pairing {
    /// Draws a new code.
    pub fn new() -> Result<Self, NoRandom> {
        let random = SystemRandom::new();
        loop {
            let mut bytes = [0; 4];
            random.fill(&mut bytes).map_err(|_| NoRandom)?;
            // Rejection above the largest multiple of a million in 32 bits makes all codes equally likely.
            let number = u32::from_le_bytes(bytes);
            if number < 4_294_000_000 {
                return Ok(Self::of(number % 1_000_000));
            }
        }
    }

    fn of(mut number: u32) -> Self {
        let mut code = [b'0'; DIGITS];
        for digit in code.iter_mut().rev() {
            *digit = b'0' + (number % 10) as u8;
            number /= 10;
        }
        Self { code, wrong: 0, closed_until: None }
    }

    /// Returns the code as the screen shows it.
    pub fn code(&self) -> String {
        self.code.iter().map(|d| *d as char).collect()
    }

    /// Checks a code.
    pub fn try_code(&mut self, given: &str, now: Instant) -> Admission {
        if self.wrong >= MOST_WRONG {
            return Admission::Closed;
        }
        if let Some(left) =
            self.closed_until.and_then(|until| until.checked_duration_since(now)).filter(|d| !d.is_zero())
        {
            return Admission::Wait(left);
        }
        if bool::from(self.code.as_slice().ct_eq(given.trim().as_bytes())) {
            self.wrong = 0;
            return Admission::Paired;
        }
        let wait = (FIRST_WAIT_S * f64::from(1u32 << self.wrong.min(20))).min(LONGEST_WAIT_S);
        self.wrong += 1;
        let wait = Duration::from_secs_f64(wait);
        self.closed_until = Some(now + wait);
        Admission::Wait(wait)
    }
}

impl fmt::Debug for Pairing {
    /// Formats without the code, which must appear on the screen only.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Pairing").field("wrong", &self.wrong).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_right_code_pairs_and_a_wrong_one_makes_even_the_right_one_wait() {
        let mut pairing = Pairing::of(42);
        let now = Instant::now();
        assert_eq!((pairing.code().as_str(), pairing.try_code("000042", now)), ("000042", Admission::Paired));
        assert_eq!(pairing.try_code("000043", now), Admission::Wait(Duration::from_secs(1)));
        assert!(matches!(pairing.try_code("000042", now + Duration::from_millis(900)), Admission::Wait(_)));
        assert_eq!(pairing.try_code("000042", now + Duration::from_millis(1100)), Admission::Paired);
    }

    #[test]
    fn waits_double_and_after_twenty_wrong_codes_none_is_accepted() {
        let mut pairing = Pairing::of(123_456);
        let mut now = Instant::now();
        let mut waits = Vec::new();
        for given in ["", "1", "1234567", "12345", "abcdef", "123 456", "000000"].iter().cycle().take(20) {
            let Admission::Wait(wait) = pairing.try_code(given, now) else { panic!("{given} was accepted") };
            waits.push(wait.as_secs());
            now += wait;
        }
        assert_eq!(waits[..7], [1, 2, 4, 8, 16, 32, 60]);
        assert_eq!(pairing.try_code("123456", now), Admission::Closed);
    }

    #[test]
    fn codes_are_random_and_absent_from_debug_output() {
        let codes: std::collections::BTreeSet<String> =
            (0..50).filter_map(|_| Pairing::new().ok()).map(|p| p.code()).collect();
        assert!(codes.len() > 45 && codes.iter().all(|c| c.len() == 6 && c.bytes().all(|b| b.is_ascii_digit())));
        assert!(!format!("{:?}", Pairing::of(777_777)).contains("777777"));
    }
}
