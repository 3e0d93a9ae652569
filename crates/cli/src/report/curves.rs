//! Temperatures, power and mass against time.

use maud::{Markup, html};
use saute_recipe::recorder::Row;
use saute_recipe::step_record::StepRecord;
use saute_recipe::summary::FoodOrGroup;
use saute_recipe::{Cook, Summary};

use crate::chart::axis::{Panel, Ticks};
use crate::chart::figure::Figure;
use crate::chart::moments::{Moment, moments};
use crate::chart::scale::{Scale, nice_range, nice_step};
use crate::wording;

/// Curves of a food: class in the style sheet and name, place in a row's numbers.
const CURVES: [(&str, usize); 3] = [("bottom", 2), ("top", 1), ("core", 0)];

/// What a reader needs to read the curves.
const CAPTION: &str =
    "Top and bottom are means of the face that lies above or below at that moment, so they change places at a flip.";

/// Largest number of rows that are drawn; longer series are thinned (chosen: twice the pixels).
const MOST_ROWS: usize = 1600;

/// Larger changes between two rows are kept when a series is thinned [K] (chosen: a flip is a jump).
const JUMP: f64 = 2.0;

/// Returns a figure for each food, for groups of the means.
pub fn section(cook: &Cook, summary: &Summary) -> Markup {
    let rows = thinned(&cook.recorder.rows);
    html! {
        section {
            h2 { "Temperatures" }
            @for entry in summary.foods_and_groups() { (figure(&rows, summary, &entry)) }
        }
    }
}

fn figure(rows: &[&Row], summary: &Summary, entry: &FoodOrGroup) -> Markup {
    let pan = ("pan", "pan, mean of the floor".to_owned());
    let curves = CURVES.iter().rev().map(|(name, _)| (*name, format!("{name} of {}", entry.food.id)));
    let legend: Vec<(&str, String)> = std::iter::once(pan).chain(curves).collect();
    let label = format!("Temperatures, power of the hob and mass against time for {}", entry.food.id);
    let figure = Figure { legend: &legend, label: &label, title: None, height: HEIGHT };
    figure.markup(|width| Drawing { rows, summary, entry, width }.svg(), Some(CAPTION))
}

fn thinned(rows: &[Row]) -> Vec<&Row> {
    let stride = rows.len().div_ceil(MOST_ROWS).max(1);
    let jumps = |i: usize| {
        i > 0
            && rows[i]
                .foods
                .iter()
                .zip(&rows[i - 1].foods)
                .any(|(a, b)| a.iter().zip(b).any(|(a, b)| (a - b).abs() > JUMP))
    };
    let kept = |i: &usize| {
        i.is_multiple_of(stride) || i + 1 == rows.len() || jumps(*i) || (*i + 1 < rows.len() && jumps(*i + 1))
    };
    (0..rows.len()).filter(kept).map(|i| &rows[i]).collect()
}

/// One picture: three panels above each other on one time axis.
struct Drawing<'a> {
    rows: &'a [&'a Row],
    summary: &'a Summary,
    entry: &'a FoodOrGroup<'a>,
    width: f64,
}

/// Edges of the panels [px]: top and bottom of temperatures, power, mass.
const PANELS: [[f64; 2]; 3] = [[46.0, 306.0], [344.0, 394.0], [432.0, 502.0]];
const HEIGHT: f64 = 540.0;
const LEFT: f64 = 40.0;
const RIGHT: f64 = 8.0;

impl Drawing<'_> {
    fn svg(&self) -> String {
        let steps: Vec<Moment> = self.summary.steps.iter().filter_map(|s| self.moment(s)).collect();
        let lines = moments(self.time(), self.width, [PANELS[0][0] - 18.0, PANELS[2][1]], &steps);
        [lines, self.temperatures(), self.power(), self.mass()].concat()
    }

    /// Returns the moment of a step that concerns this food or no single food.
    fn moment(&self, step: &StepRecord) -> Option<Moment> {
        let members = &self.summary.foods[self.entry.members.clone()];
        let concerns = step.action.target().is_none() || members.iter().any(|f| step.foods.contains(&f.id));
        let name = wording::mark(step).filter(|_| concerns)?.to_owned();
        let tooltip = format!("{}: {}", wording::duration(step.time_s), wording::step(step));
        Some(Moment { at: step.time_s, name, tooltip })
    }

    /// Returns core, top, bottom [°C] and mass [g] of a row.
    fn readings(&self, row: &Row) -> [f64; 4] {
        row.mean(&self.entry.members)
    }

    fn time(&self) -> Scale {
        Scale::new([0.0, self.summary.simulated_s.max(1.0)], [LEFT, self.width - RIGHT])
    }

    fn panel(&self, [top, bottom]: [f64; 2], range: [f64; 2]) -> Panel {
        Panel { x: self.time(), y: Scale::new(range, [bottom, top]), edges: [LEFT, self.width - RIGHT, top, bottom] }
    }

    fn temperatures(&self) -> String {
        let values = self.rows.iter().flat_map(|r| {
            let [core, top, bottom, _] = self.readings(r);
            [r.pan_c, core, top, bottom]
        });
        let (low, high) = values.fold((0.0_f64, 50.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        let (range, step) = nice_range(low, high, 6.0);
        let panel = self.panel(PANELS[0], range);
        let pan = panel.curve("pan", self.rows.iter().map(|r| (r.time_s, r.pan_c)));
        let food: String = CURVES
            .iter()
            .map(|(class, k)| panel.curve(class, self.rows.iter().map(|r| (r.time_s, self.readings(r)[*k]))))
            .collect();
        panel.y_axis(range, step, "°C") + &pan + &food
    }

    fn power(&self) -> String {
        let highest = self.rows.iter().map(|r| r.hob_drawn_w).fold(100.0, f64::max);
        let (range, step) = nice_range(0.0, highest, 2.0);
        let panel = self.panel(PANELS[1], range);
        let pairs =
            self.rows.windows(2).flat_map(|w| [(w[0].time_s, w[0].hob_drawn_w), (w[1].time_s, w[0].hob_drawn_w)]);
        panel.y_axis(range, step, "hob [W]")
            + &panel.curve("hob", pairs.chain(self.rows.last().map(|r| (r.time_s, r.hob_drawn_w))))
    }

    fn mass(&self) -> String {
        let grams = || self.rows.iter().map(|r| (r.time_s, self.readings(r)[3]));
        let (low, high) = grams().fold((f64::MAX, f64::MIN), |(l, h), (_, g)| (l.min(g), h.max(g)));
        let (range, step) = nice_range(low, high, 3.0);
        let panel = self.panel(PANELS[2], range);
        let end = self.summary.simulated_s;
        let (unit, per) = if end > 180.0 { ("time [min]", 60.0) } else { ("time [s]", 1.0) };
        let most = (self.width / 60.0).floor();
        let ticks = Ticks { range: [0.0, end], step: nice_step(end / per, most) * per };
        let x_axis = panel.x_axis(ticks, |time_s| (time_s / per).to_string(), unit);
        panel.y_axis(range, step, "mass [g]") + &panel.curve("mass", grams()) + &x_axis
    }
}
