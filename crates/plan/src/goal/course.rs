//! How a cook went, as far as it states what would have made it better.

use saute_recipe::Recorder;

/// Time before the food comes out over which the rise of its core is read [s] (chosen: longer than what a flip disturbs).
const RISE_OVER_S: f64 = 60.0;

/// How a cook of a piece went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// Number of flips.
    pub flips: usize,
    /// Temperature of the pan's floor when food first went in [°C]; none if it is not known.
    pub pan_at_put_c: Option<f64>,
    /// Lowest temperature of the pan's floor after that [°C].
    pub pan_lowest_c: Option<f64>,
    /// Rise of the core in the last minute in the pan [K/s]; none if it is not known.
    pub rise_k_s: Option<f64>,
    /// Mean power that the hob drew while the food was in the pan [W]; none if it is not known.
    pub power_w: Option<f64>,
}

impl Course {
    /// Reads it from a series, given the place of the piece in its rows, when it went into the pan and came out [s], and the number
    /// of its flips.
    pub fn of(recorder: &Recorder, food: usize, [put_s, out_s]: [Option<f64>; 2], flips: usize) -> Self {
        let out_s = out_s.unwrap_or(f64::INFINITY);
        let in_pan = |time: f64| put_s.is_some_and(|put| time >= put) && time <= out_s;
        let rows: Vec<_> = recorder.rows.iter().filter(|row| in_pan(row.time_s)).collect();
        let core = |row: &saute_recipe::recorder::Row| Some((row.time_s, row.foods.get(food)?[0]));
        let last = rows.last().and_then(|row| core(row));
        let first = last.and_then(|(end, _)| rows.iter().find(|row| row.time_s >= end - RISE_OVER_S));
        let rise = first.and_then(|row| core(row)).zip(last).filter(|((from, _), (to, _))| to > from);
        Self {
            flips,
            pan_at_put_c: recorder.pan_at_first_put_c,
            pan_lowest_c: recorder.pan_lowest_after_c,
            rise_k_s: rise.map(|((from, cold), (to, warm))| (warm - cold) / (to - from)),
            power_w: (!rows.is_empty())
                .then(|| rows.iter().map(|row| row.hob_drawn_w).sum::<f64>() / rows.len() as f64),
        }
    }
}

#[cfg(test)]
mod tests {
    use saute_recipe::recorder::Row;

    use super::*;

    #[test]
    fn the_rise_is_that_of_the_last_minute_in_the_pan() {
        let row = |second: u32| {
            let (time_s, in_pan) = (f64::from(second), (10..=100).contains(&second));
            let core = if in_pan { 20.0 + 0.2 * time_s } else { 5.0 };
            Row { time_s, hob_drawn_w: if in_pan { 700.0 } else { 1500.0 }, pan_c: 180.0, foods: vec![[core; 4]] }
        };
        let mut recorder = Recorder::default();
        recorder.rows.extend((0..200).map(row));
        let course = Course::of(&recorder, 0, [Some(10.0), Some(100.0)], 3);
        assert!((course.rise_k_s.unwrap_or_default() - 0.2).abs() < 1e-9 && course.flips == 3);
        assert_eq!(course.power_w, Some(700.0));
        assert_eq!(Course::of(&recorder, 1, [None; 2], 0).rise_k_s, None);
    }
}
