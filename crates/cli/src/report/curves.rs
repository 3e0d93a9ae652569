//! Temperatures, power and mass against time.

use saute_recipe::recorder::Row;
use saute_recipe::summary::Told;
use saute_recipe::{Cook, Summary};

use super::markup::escaped;
use super::plot::{Panel, Scale, marks, nice_range, nice_step};
use crate::wording;

/// Curves of a food: class in the style sheet, name, place in a row's numbers.
const CURVES: [(&str, &str, usize); 3] = [("bottom", "bottom", 2), ("top", "top", 1), ("core", "core", 0)];

/// Widths of the picture for a desk and for a phone [px]: scaled letters would be too small to read.
const WIDTHS: [(&str, f64); 2] = [("wide", 760.0), ("narrow", 350.0)];

/// Rows beyond this many are thinned out (chosen: twice the pixels).
const MOST_ROWS: usize = 1600;

/// Changes larger than this are never thinned out [K]: a flip is a jump.
const JUMP: f64 = 2.0;

/// A figure for each food; of a group the means.
pub fn section(cook: &Cook, summary: &Summary) -> String {
    let rows = thinned(&cook.recorder.rows);
    let figures: String = summary.told().iter().map(|told| figure(&rows, summary, told)).collect();
    format!("<section><h2>Temperatures</h2>{figures}</section>")
}

fn figure(rows: &[&Row], summary: &Summary, told: &Told) -> String {
    let id = escaped(&told.food.id);
    let names = [("pan", "pan, mean of the floor".to_owned())]
        .into_iter()
        .chain(CURVES.iter().rev().map(|(class, name, _)| (*class, format!("{name} of {id}"))));
    let legend: String = names
        .map(|(class, name)| format!("<li><svg viewBox=\"0 0 28 8\" aria-hidden=\"true\"><path class=\"curve {class}\" d=\"M1 4H27\"/></svg>{name}</li>"))
        .collect();
    let pictures: String =
        WIDTHS.iter().map(|(class, width)| Drawing::new(rows, summary, told, *width).svg(class)).collect();
    format!(
        "<figure class=\"plot\"><ul class=\"legend\">{legend}</ul>{pictures}\
         <figcaption>Top and bottom are means of the face that lies above or below at that moment, so they change places at a flip.</figcaption></figure>"
    )
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
    told: &'a Told<'a>,
    width: f64,
}

/// Edges of the panels [px]: top and bottom of temperatures, power, mass.
const PANELS: [[f64; 2]; 3] = [[46.0, 306.0], [344.0, 394.0], [432.0, 502.0]];
const HEIGHT: f64 = 540.0;
const LEFT: f64 = 40.0;
const RIGHT: f64 = 8.0;

impl<'a> Drawing<'a> {
    fn new(rows: &'a [&'a Row], summary: &'a Summary, told: &'a Told<'a>, width: f64) -> Self {
        Self { rows, summary, told, width }
    }

    fn svg(&self, class: &str) -> String {
        let moments: Vec<(f64, String, String)> = self.summary.steps.iter().filter_map(|s| self.moment(s)).collect();
        let lines = marks(self.time(), self.width, [PANELS[0][0] - 18.0, PANELS[2][1]], &moments);
        let label = format!("Temperatures, power of the hob and mass against time for {}", escaped(&self.told.food.id));
        format!(
            "<svg class=\"{class}\" viewBox=\"0 0 {} {HEIGHT}\" role=\"img\" aria-label=\"{label}\">{lines}{}{}{}</svg>",
            self.width,
            self.temperatures(),
            self.power(),
            self.mass()
        )
    }

    /// Steps that concern this food, or all.
    fn moment(&self, step: &saute_recipe::step_record::StepRecord) -> Option<(f64, String, String)> {
        let members = &self.summary.foods[self.told.members.clone()];
        let mine = step.target.is_none() || members.iter().any(|f| step.foods.contains(&f.id));
        let full = format!("{}: {}", wording::duration(step.time_s), escaped(&wording::step(step)));
        wording::mark(step).filter(|_| mine).map(|name| (step.time_s, name.to_owned(), full))
    }

    /// Core, top, bottom [°C] and mass [g] of a row.
    fn readings(&self, row: &Row) -> [f64; 4] {
        row.mean(&self.told.members)
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
            .map(|(class, _, k)| panel.curve(class, self.rows.iter().map(|r| (r.time_s, self.readings(r)[*k]))))
            .collect();
        panel.y_axis(range, step, "°C") + &pan + &food
    }

    fn power(&self) -> String {
        let highest = self.rows.iter().map(|r| r.hob_w).fold(100.0, f64::max);
        let (range, step) = nice_range(0.0, highest, 2.0);
        let panel = self.panel(PANELS[1], range);
        let pairs = self.rows.windows(2).flat_map(|w| [(w[0].time_s, w[0].hob_w), (w[1].time_s, w[0].hob_w)]);
        panel.y_axis(range, step, "hob [W]")
            + &panel.curve("hob", pairs.chain(self.rows.last().map(|r| (r.time_s, r.hob_w))))
    }

    fn mass(&self) -> String {
        let grams = || self.rows.iter().map(|r| (r.time_s, self.readings(r)[3]));
        let (low, high) = grams().fold((f64::MAX, f64::MIN), |(l, h), (_, g)| (l.min(g), h.max(g)));
        let (range, step) = nice_range(low, high, 3.0);
        let panel = self.panel(PANELS[2], range);
        let end = self.summary.simulated_s;
        let (unit, per) = if end > 180.0 { ("time [min]", 60.0) } else { ("time [s]", 1.0) };
        let most = (self.width / 60.0).floor();
        let x_axis = panel.x_axis(end, nice_step(end / per, most) * per, per, unit);
        panel.y_axis(range, step, "mass [g]") + &panel.curve("mass", grams()) + &x_axis
    }
}
