//! The core's curve goes on into the future: as it is, and if the piece is taken out now.

use egui::Color32;
use egui_plot::{FilledArea, LineStyle, PlotPoint, PlotTransform, PlotUi};
use saute_kitchen::{FRAME_S, celsius};
use saute_plan::forecast::Question;

use crate::panels::curve::Curve;
use crate::ui::palette::Palette;
use saute_controls::ahead_words::are_shown;
use saute_controls::context::PanelContext;
use saute_session::forecasts::AgedForecast;

/// How strongly a band is drawn, and what no longer applies [-] (chosen: behind the curves).
const BAND_SEEN: f32 = 0.25;
const STALE_SEEN: f32 = 0.45;

/// A core to come, with its band.
pub(crate) struct Future {
    /// The curve.
    pub(crate) curve: Curve,
    /// Half the width of the band at each of its points, in the chosen unit.
    half: Vec<f64>,
    /// The highest point, with its words, where it is marked.
    peak: Option<([f64; 2], String)>,
}

/// The cores to come of the piece that the panels show.
pub(crate) fn futures(state: &PanelContext, palette: &Palette) -> Vec<Future> {
    let l = state.settings.language;
    let looks = [
        (Question::AsItIs, "ahead.curve_as_it_is", palette.curves[1], 5.0),
        (Question::TakeOut, "ahead.curve_out", palette.text, 9.0),
    ];
    let of = |(question, name, colour, length): (Question, &'static str, Color32, f32)| {
        let standing = state.session.foreseen(question).filter(|_| are_shown(state))?;
        let colour = if standing.is_current { colour } else { colour.gamma_multiply(STALE_SEEN) };
        let style = LineStyle::Dashed { length };
        let (points, half) = points(state, &standing, question).into_iter().unzip();
        let curve = Curve { name: l.text(name).to_owned(), mark: String::new(), colour, style, width: 1.8, points };
        let peak =
            (question == Question::TakeOut && !standing.answer.outlook.still_warms()).then(|| peak(state, &standing));
        Some(Future { curve, half, peak })
    };
    looks.into_iter().filter_map(of).collect()
}

/// Minutes and degrees from the shown instant on, each with half the width of the band. The full model has none.
fn points(state: &PanelContext, standing: &AgedForecast, question: Question) -> Vec<([f64; 2], f64)> {
    let (settings, now_s) = (state.settings, state.session.kitchen.time_s());
    let begun_s = |frame: u64| frame as f64 * FRAME_S;
    let point = |time_s: f64, core: f64, half: f64| {
        let core = celsius(core);
        let degrees = settings.degrees(core);
        ([time_s / 60.0, degrees], settings.degrees(core + half) - degrees)
    };
    let exact = state.session.foreseen_exactly().filter(|_| question == Question::AsItIs);
    let exact_begun_s = exact.map_or(0.0, |answer| begun_s(answer.outlook.frame));
    let of_exact = exact.into_iter().flat_map(|answer| &answer.outlook.samples);
    let of_exact = of_exact.map(|sample| (exact_begun_s + sample.after_s, sample.core, 0.0));
    let exact_until_s = of_exact.clone().next_back().map_or(now_s, |(at_s, ..)| at_s);
    let from_s = begun_s(standing.answer.outlook.frame);
    let coarse = standing.answer.outlook.samples.iter();
    let coarse = coarse.map(|sample| (from_s + sample.after_s, sample.core, standing.band.core_at(sample.after_s)));
    let ahead = of_exact.chain(coarse.filter(|(at_s, ..)| *at_s > exact_until_s)).filter(|(at_s, ..)| *at_s > now_s);
    let core_now = state.session.shown_piece().map(|piece| (now_s, piece.core(), 0.0)).filter(|_| standing.is_current);
    core_now.into_iter().chain(ahead).map(|(at_s, core, half)| point(at_s, core, half)).collect()
}

fn peak(state: &PanelContext, standing: &AgedForecast) -> ([f64; 2], String) {
    let outlook = &standing.answer.outlook;
    let at_s = outlook.frame as f64 * FRAME_S + outlook.peak.after_s;
    let shown = state.settings.temperature(celsius(outlook.peak.core));
    let words = state.settings.language.fill("ahead.curve_peak", &[("peak", &shown)]);
    ([at_s / 60.0, state.settings.degrees(celsius(outlook.peak.core))], words)
}

impl Future {
    /// Draws the band and the curve.
    pub(crate) fn draw<'a>(&'a self, plot: &mut PlotUi<'a>) {
        let Curve { points, colour, name, .. } = &self.curve;
        let minutes: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let edge = |sign: f64| -> Vec<f64> {
            points.iter().zip(&self.half).map(|(point, half)| point[1] + sign * half).collect()
        };
        let band = FilledArea::new(name.clone(), &minutes, &edge(-1.0), &edge(1.0));
        plot.add(band.fill_color(colour.gamma_multiply(BAND_SEEN)));
        plot.line(self.curve.line(points, *colour));
    }

    /// Marks the highest point.
    pub(crate) fn mark(&self, ui: &egui::Ui, transform: &PlotTransform) {
        let Some((at, words)) = &self.peak else { return };
        let frame = transform.frame();
        let at = transform.position_from_point(&PlotPoint::from(*at));
        let painter = ui.painter().with_clip_rect(frame.intersect(ui.clip_rect()));
        painter.circle_filled(at, 3.0, self.curve.colour);
        let font = egui::FontId::proportional(11.5);
        let text = painter.layout_no_wrap(words.clone(), font, self.curve.colour);
        let left = (at.x - 0.5 * text.size().x).clamp(frame.left() + 2.0, frame.right() - text.size().x - 2.0);
        painter.galley(egui::pos2(left, at.y - text.size().y - 5.0), text, self.curve.colour);
    }
}
