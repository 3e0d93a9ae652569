//! An order about the hob stays as it was given until a hand has carried it out. A number that changes meanwhile is never met, and an
//! order that follows at once on one that was obeyed reads as if it had been wrong.

use saute_kitchen::advice::Advice;

/// Wall time for which an order remains valid, whatever the pan does meanwhile [s] (chosen: to read it, to reach the dial and to turn it).
const STANDS_S: f64 = 20.0;
/// Time after an order was obeyed in which none follows for a small difference [simulated s] (chosen: a pan takes a minute to follow
/// its hob), and up to which it is small [W].
const FOLLOWS_S: f64 = 60.0;
const SMALL_W: f64 = 200.0;

/// The moment of an order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment {
    /// Power of the hob [W].
    pub hob_w: f64,
    /// Time of the cook [s].
    pub time_s: f64,
    /// Speed of time [-].
    pub speed: f64,
}

/// The order that is valid.
#[derive(Clone, Copy, Debug)]
struct Given {
    advice: Advice,
    /// Power of the hob when it was given [W].
    hob_w: f64,
    /// When it was given [s].
    at_s: f64,
}

/// What was ordered of the hob, and what was obeyed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct KeptOrder {
    given: Option<Given>,
    /// When the last one was obeyed [s].
    obeyed_s: Option<f64>,
}

impl KeptOrder {
    /// Returns the advice with the valid order about the hob.
    pub fn keep(&mut self, mut advice: Vec<Advice>, now: Moment) -> Vec<Advice> {
        self.note(now);
        let Some(place) = advice.iter().position(|one| one.hob_w().is_some()) else {
            if let Some(given) = self.given.filter(|given| now.time_s - given.at_s < STANDS_S * now.speed) {
                let waits = advice.iter().position(|one| !one.is_due()).unwrap_or(advice.len());
                advice.insert(waits, given.advice);
            }
            return advice;
        };
        let ordered = advice[place];
        match self.given {
            Some(given) if is_alike(given.advice, ordered, now.hob_w) => advice[place] = given.advice,
            _ if self.follows_too_soon(ordered, now) => {
                advice.remove(place);
            }
            _ => self.given = Some(Given { advice: ordered, hob_w: now.hob_w, at_s: now.time_s }),
        }
        advice
    }

    /// An order ends once the hob is set, to the ordered power or to another one, or when time was turned back.
    fn note(&mut self, now: Moment) {
        self.obeyed_s = self.obeyed_s.filter(|at_s| *at_s <= now.time_s);
        let Some(given) = self.given else { return };
        if given.at_s > now.time_s {
            self.given = None;
        } else if given.hob_w != now.hob_w {
            let is_obeyed = given.advice.hob_w() == Some(now.hob_w);
            self.obeyed_s = if is_obeyed { Some(now.time_s) } else { self.obeyed_s };
            self.given = None;
        }
    }

    fn follows_too_soon(&self, ordered: Advice, now: Moment) -> bool {
        let is_small = ordered.hob_w().is_some_and(|w| (w - now.hob_w).abs() <= SMALL_W && w > 0.0);
        is_small && self.obeyed_s.is_some_and(|at_s| now.time_s - at_s < FOLLOWS_S)
    }
}

/// True of two orders to turn down, or up, from the power that the hob has; off is a separate order.
fn is_alike(one: Advice, other: Advice, hob_w: f64) -> bool {
    let [one_w, other_w] = [one, other].map(|advice| advice.hob_w().unwrap_or(hob_w));
    one_w > 0.0 && other_w > 0.0 && (one_w < hob_w) == (other_w < hob_w)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn down(to_w: f64) -> Advice {
        Advice::TooHot { hottest_c: 280.0, smokes: false, to_w }
    }

    fn at(time_s: f64, hob_w: f64) -> Moment {
        Moment { hob_w, time_s, speed: 1.0 }
    }

    #[test]
    fn an_order_keeps_its_number_until_the_hob_is_set() {
        let mut kept = KeptOrder::default();
        assert_eq!(kept.keep(vec![down(600.0), Advice::Flip], at(10.0, 1100.0)), [down(600.0), Advice::Flip]);
        assert_eq!(kept.keep(vec![down(400.0)], at(12.0, 1100.0)), [down(600.0)]);
        // The reason may go: the order remains for a while, behind what is due.
        assert_eq!(kept.keep(vec![Advice::Flip], at(15.0, 1100.0)), [Advice::Flip, down(600.0)]);
        assert_eq!(kept.keep(vec![Advice::Flip], at(31.0, 1100.0)), [Advice::Flip]);
        // Set to something else, it is thought over.
        assert_eq!(kept.keep(vec![down(500.0)], at(32.0, 800.0)), [down(500.0)]);
    }

    #[test]
    fn who_has_obeyed_is_not_corrected_at_once_but_for_a_large_difference() {
        let mut kept = KeptOrder::default();
        kept.keep(vec![down(600.0)], at(10.0, 1100.0));
        assert!(kept.keep(vec![down(500.0)], at(20.0, 600.0)).is_empty());
        assert_eq!(kept.keep(vec![down(300.0)], at(21.0, 600.0)), [down(300.0)]);
        let mut kept = KeptOrder::default();
        kept.keep(vec![down(600.0)], at(10.0, 1100.0));
        kept.keep(Vec::new(), at(20.0, 600.0));
        assert_eq!(kept.keep(vec![down(500.0)], at(81.0, 600.0)), [down(500.0)]);
    }

    #[test]
    fn off_and_the_other_direction_are_orders_of_their_own_and_time_that_is_turned_back_forgets() {
        let mut kept = KeptOrder::default();
        kept.keep(vec![down(600.0)], at(10.0, 1100.0));
        assert_eq!(kept.keep(vec![Advice::TurnOff], at(11.0, 1100.0)), [Advice::TurnOff]);
        let up = Advice::TooCold { power_w: 1400.0 };
        assert_eq!(kept.keep(vec![up], at(12.0, 1100.0)), [up]);
        assert!(kept.keep(vec![Advice::Flip], at(5.0, 1100.0)) == [Advice::Flip]);
    }
}
