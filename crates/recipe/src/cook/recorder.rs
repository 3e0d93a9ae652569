//! Time series and extremes of a cook.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::action::ActionKind;
use crate::cook::step_record::{StepRecord, rounded};
use crate::recipe::Group;
use saute_kitchen::kitchen::Kitchen;
use saute_kitchen::{Piece, Place, celsius};

/// One row of the time series.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Row {
    /// Time [s].
    pub time_s: f64,
    /// Electrical power drawn from the mains [W].
    pub hob_drawn_w: f64,
    /// Mean temperature of the pan's floor [°C].
    pub pan_c: f64,
    /// For each food: temperatures of core, top and bottom [°C], mass [g].
    pub foods: Vec<[f64; 4]>,
}

impl Row {
    /// Returns the means over foods: temperatures of core, top and bottom [°C], mass [g].
    pub fn mean(&self, members: &Range<usize>) -> [f64; 4] {
        let foods = &self.foods[members.clone()];
        core::array::from_fn(|k| foods.iter().map(|f| f[k]).sum::<f64>() / foods.len() as f64)
    }
}

/// A piece that came to lie on a face in the pan, or left the pan: by a command, a recipe, a toss or a tool in a hand.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Laid {
    /// The piece.
    pub food: String,
    /// When this was seen [s].
    pub at_s: f64,
    /// True if its upper face is below; none once it is not in the pan.
    pub upside_down: Option<bool>,
    /// True if it lay in the pan on its other face before: it was turned over.
    pub is_turn: bool,
}

/// Time series, turns and extremes of a cook.
///
/// ```
/// use saute_kitchen::Library;
/// use saute_recipe::{Cook, Recipe};
///
/// let library = Library::embedded()?;
/// let text = "[[step]]\nhob_w = 2000\n[[step]]\nat_s = 3\nend = true";
/// let mut cook = Cook::new(Recipe::parse(text, "heat.toml", &library)?, &library)?;
/// while cook.stopped().is_none() {
///     cook.advance()?;
/// }
/// // One row for each second, from 0 to 3 s.
/// let csv = cook.recorder.csv(&[], &[])?;
/// assert!(csv.starts_with("time_s,hob_drawn_w,pan_c\n0.0,"), "{csv}");
/// assert_eq!(csv.lines().count(), 1 + 4);
/// assert!(cook.recorder.pan_peak_c > 20.0, "{} °C", cook.recorder.pan_peak_c);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct Recorder {
    /// Rows, one for each second and for each step; of a long cook fewer, evenly spaced.
    pub rows: Vec<Row>,
    /// How the pieces were laid, in order.
    laid: Vec<Laid>,
    /// Highest pan temperature [°C].
    pub pan_peak_c: f64,
    /// Pan temperature at the first `put` [°C].
    pub pan_at_first_put_c: Option<f64>,
    /// Lowest pan temperature after the first `put` [°C].
    pub pan_lowest_after_c: Option<f64>,
    /// Number of times that every second row was dropped [-].
    halvings: u32,
}

impl Recorder {
    /// Records the kitchen after a tick, or at time 0.
    pub fn observe(&mut self, kitchen: &Kitchen) {
        let pan = celsius(kitchen.pan_temperature());
        self.pan_peak_c = if kitchen.tick() == 0 { pan } else { self.pan_peak_c.max(pan) };
        if let Some(lowest) = &mut self.pan_lowest_after_c {
            *lowest = lowest.min(pan);
        }
        self.note_faces(kitchen);
        if kitchen.tick().is_multiple_of(TICKS_PER_ROW << self.halvings) {
            self.write_row(kitchen);
        }
    }

    /// Turns of the pieces, in order.
    pub fn turns(&self) -> impl DoubleEndedIterator<Item = &Laid> + Clone {
        self.laid.iter().filter(|laid| laid.is_turn)
    }

    /// How often a piece was turned over [-].
    pub fn turns_of(&self, food: &str) -> usize {
        self.turns().filter(|turn| turn.food == food).count()
    }

    /// Returns the series, turns included, as it was at a time [s]; the extremes stay.
    #[must_use]
    pub fn until(mut self, time_s: f64) -> Self {
        self.rows.retain(|row| row.time_s < time_s);
        self.laid.retain(|laid| laid.at_s < time_s);
        self
    }

    fn note_faces(&mut self, kitchen: &Kitchen) {
        for piece in kitchen.pieces() {
            let before = self.laid.iter().rfind(|laid| laid.food == piece.id).and_then(|laid| laid.upside_down);
            let Some(upside_down) = face_below(piece, before) else { continue };
            let is_turn = before.is_some() && upside_down.is_some();
            self.laid.push(Laid { food: piece.id.clone(), at_s: kitchen.time_s(), upside_down, is_turn });
        }
    }

    /// Records the pan's temperature at the first `put`.
    pub fn on_put(&mut self, kitchen: &Kitchen) {
        let pan = celsius(kitchen.pan_temperature());
        self.pan_at_first_put_c.get_or_insert(pan);
        self.pan_lowest_after_c.get_or_insert(pan);
    }

    /// Records the steps that fired now.
    pub fn on_steps(&mut self, kitchen: &Kitchen, fired: &[StepRecord]) {
        if fired.iter().any(|step| step.action.kind() == ActionKind::Put) {
            self.on_put(kitchen);
        }
        if !fired.is_empty() {
            self.write_row(kitchen);
        }
    }

    /// Adds a row for the present time; it replaces a row of the same time.
    pub fn write_row(&mut self, kitchen: &Kitchen) {
        let food = |p: &saute_kitchen::Piece| {
            [celsius(p.core()), celsius(p.face(false)), celsius(p.face(true)), 1e3 * p.mass()]
        };
        let row = Row {
            time_s: rounded(kitchen.time_s()),
            hob_drawn_w: kitchen.hob_drawn_w(),
            pan_c: celsius(kitchen.pan_temperature()),
            foods: kitchen.pieces().iter().map(food).collect(),
        };
        if self.rows.last().is_some_and(|last| last.time_s == row.time_s) {
            self.rows.pop();
        }
        self.rows.push(row);
        self.thin();
    }

    /// Drops every second row of a full series but the last; new rows then come half as often.
    fn thin(&mut self) {
        let Some(last) = self.rows.last() else { return };
        let numbers = self.rows.len() * (ROW_NUMBERS + last.foods.len() * FOOD_COLUMNS.len());
        if numbers <= MOST_NUMBERS {
            return;
        }
        let newest = self.rows.len() - 1;
        let mut at = 0;
        self.rows.retain(|_| {
            let is_kept = at % 2 == 0 || at == newest;
            at += 1;
            is_kept
        });
        self.halvings += 1;
    }

    /// Returns the series as CSV: columns for each food by its id, then for the means of each group. The number of
    /// decimals is fixed, so the same cook gives the same bytes.
    pub fn csv(&self, ids: &[&str], groups: &[Group]) -> Result<String, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let names = ids.iter().copied().chain(groups.iter().map(|g| g.id.as_str()));
        let columns = names.flat_map(|id| FOOD_COLUMNS.map(|column| format!("{id}.{column}")));
        writer.write_record(COLUMNS.map(str::to_owned).into_iter().chain(columns))?;
        for row in &self.rows {
            let own = [format!("{:.1}", row.time_s), format!("{:.0}", row.hob_drawn_w), format!("{:.3}", row.pan_c)];
            let means = groups.iter().map(|g| row.mean(&g.members));
            let foods = row.foods.iter().copied().chain(means).flat_map(|[core, top, bottom, mass]| {
                [format!("{core:.3}"), format!("{top:.3}"), format!("{bottom:.3}"), format!("{mass:.4}")]
            });
            writer.write_record(own.into_iter().chain(foods))?;
        }
        let bytes = writer.into_inner().map_err(|e| e.into_error())?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

/// Least share of a piece's thickness that points up where it lies on a face [-] (chosen: within 60° of flat).
const FLAT: f64 = 0.5;

/// Which face of a piece is below, if that is another than before; in a hand, in the air or on an edge it is as before.
fn face_below(piece: &Piece, before: Option<bool>) -> Option<Option<bool>> {
    if matches!(piece.place, Place::Held) {
        return None;
    }
    if !piece.in_pan() {
        return before.is_some().then_some(None);
    }
    let now = Some(piece.upside_down());
    let is_other = now != before && piece.up()[2].abs() > FLAT;
    (is_other && piece.is_near_pan()).then_some(now)
}

/// Columns of the pan and the hob.
pub const COLUMNS: [&str; 3] = ["time_s", "hob_drawn_w", "pan_c"];
/// Columns of each food and of the mean of each group, after the id and a dot.
pub const FOOD_COLUMNS: [&str; 4] = ["core_c", "top_c", "bottom_c", "mass_g"];

/// Ticks between two rows: one second.
const TICKS_PER_ROW: u64 = 10;
/// Size of a row without foods, in numbers of eight bytes [-].
const ROW_NUMBERS: usize = 6;
/// Largest size of the series, in numbers of eight bytes [-] (chosen: 24 MB, so that a day takes less than 64 MB with any
/// number of foods; a cook of one food reaches it after three days, one of 23 foods after eight hours).
const MOST_NUMBERS: usize = 3_000_000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_series_is_thinned_evenly_and_keeps_its_ends() {
        let mut recorder = Recorder::default();
        let row = |time_s: f64| Row { time_s, hob_drawn_w: 0.0, pan_c: 20.0, foods: vec![[0.0; 4]; 99] };
        let full = MOST_NUMBERS / (ROW_NUMBERS + 4 * 99);
        for second in 0..=2 * full {
            if second.is_multiple_of(1 << recorder.halvings) {
                recorder.rows.push(row(second as f64));
                recorder.thin();
                assert!(recorder.rows.len() <= full);
            }
        }
        assert_eq!(recorder.halvings, 1 + 1);
        let times: Vec<f64> = recorder.rows.iter().map(|row| row.time_s).collect();
        assert!(times[0] == 0.0 && times.windows(2).all(|w| w[1] - w[0] <= 4.0 && w[1] > w[0]), "{times:?}");
        assert!(times.len() > full / 3 && times[times.len() - 1] >= 2.0 * full as f64 - 4.0);
    }
}
