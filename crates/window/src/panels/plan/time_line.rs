//! The time line of a plan as a picture: powers as steps, what a hand does as marks, the rest hatched.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Sense, Stroke, Ui, pos2, vec2};
use saute_plan::schedule::{Deed, Plan};

use crate::ui::palette::Palette;
use crate::ui::theme;
use saute_controls::context::PanelContext;
use saute_words::clock::clock;
use saute_words::cue_words;

/// Height of the picture, of the marks above the powers, and of the times below them [points].
const HEIGHT: f32 = 96.0;
const ABOVE: f32 = 24.0;
const BELOW: f32 = 18.0;
/// Distance between times below the line [points] (chosen: they do not touch).
const TIME_APART: f32 = 64.0;

/// Shows the time line.
pub fn show(state: &PanelContext, plan: &Plan, ui: &mut Ui) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
    let l = state.settings.language;
    let told: Vec<String> = plan
        .steps()
        .iter()
        .map(|step| format!("{} {}", clock(f64::from(step.at_s)), cue_words::deed(&step.deed, l)))
        .collect();
    let spoken = l.fill("plan.line_spoken", &[("steps", &told.join(l.text("doneness.list_joint")))]);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, &spoken));
    let schedule = &plan.schedule;
    let line = Line {
        rect: Rect::from_min_max(rect.min + vec2(10.0, ABOVE), rect.max - vec2(10.0, BELOW)),
        end_s: f64::from(schedule.pull_s + schedule.rest_s).max(1.0),
        most_w: schedule.powers.iter().map(|p| p.hob_w).fold(1.0, f64::max),
    };
    let (painter, palette) = (ui.painter(), theme::of(ui));
    line.powers(painter, palette, plan);
    line.rest(painter, palette, plan);
    line.marks(painter, palette, plan);
    line.times(painter, palette);
}

/// The picture as it is laid out.
struct Line {
    rect: Rect,
    end_s: f64,
    most_w: f64,
}

impl Line {
    fn x(&self, at_s: f64) -> f32 {
        self.rect.left() + self.rect.width() * (at_s / self.end_s) as f32
    }

    /// The powers as filled steps, each with its number where there is room.
    fn powers(&self, painter: &Painter, palette: &Palette, plan: &Plan) {
        painter.rect_filled(self.rect, 4.0, palette.sunken);
        let schedule = &plan.schedule;
        let ends = schedule.powers.iter().skip(1).map(|p| p.at_s).chain([schedule.pull_s]);
        for (power, until) in schedule.powers.iter().zip(ends) {
            let height = self.rect.height() * (0.25 + 0.75 * power.hob_w / self.most_w) as f32;
            let [left, right] = [power.at_s, until].map(|s| self.x(f64::from(s)));
            let bar = Rect::from_min_max(pos2(left, self.rect.bottom() - height), pos2(right, self.rect.bottom()));
            painter.rect_filled(bar, 0.0, palette.pressed);
            painter.line_segment([bar.left_top(), bar.right_top()], Stroke::new(2.0, palette.chosen));
            let text = painter.layout_no_wrap(format!("{} W", power.hob_w), FontId::proportional(12.0), palette.text);
            if text.size().x + 6.0 < bar.width() {
                let at = pos2(bar.center().x - 0.5 * text.size().x, bar.bottom() - text.size().y - 2.0);
                painter.galley(at, text, palette.text);
            }
        }
    }

    /// The rest on the board.
    fn rest(&self, painter: &Painter, palette: &Palette, plan: &Plan) {
        let from = self.x(f64::from(plan.schedule.pull_s));
        let rest = Rect::from_min_max(pos2(from, self.rect.top()), self.rect.max);
        let painter = painter.with_clip_rect(rest.intersect(painter.clip_rect()));
        let mut x = rest.left() - rest.height();
        while x < rest.right() {
            let ends = [pos2(x, rest.bottom()), pos2(x + rest.height(), rest.top())];
            painter.line_segment(ends, Stroke::new(1.0, palette.line));
            x += 8.0;
        }
    }

    /// What a hand does: into the pan, over, out.
    fn marks(&self, painter: &Painter, palette: &Palette, plan: &Plan) {
        for step in plan.steps() {
            let at = pos2(self.x(f64::from(step.at_s)), self.rect.top() - 12.0);
            if matches!(step.deed, Deed::Power(_)) {
                continue;
            }
            let foot = pos2(at.x, self.rect.bottom());
            painter.line_segment([at + vec2(0.0, 8.0), foot], Stroke::new(1.0, palette.quiet));
            mark(painter, at, &step.deed, palette.text);
        }
    }

    /// Whole minutes below the line.
    fn times(&self, painter: &Painter, palette: &Palette) {
        let least = f64::from(TIME_APART / self.rect.width()) * self.end_s;
        let every = [30.0, 60.0, 120.0, 300.0, 600.0].into_iter().find(|s| *s >= least).unwrap_or(1200.0);
        let mut at_s = 0.0;
        while at_s <= self.end_s {
            let at = pos2(self.x(at_s), self.rect.bottom() + 3.0);
            let align = if at_s == 0.0 { Align2::LEFT_TOP } else { Align2::CENTER_TOP };
            painter.text(at, align, clock(at_s), FontId::proportional(12.0), palette.quiet);
            at_s += every;
        }
    }
}

/// The mark of a deed: an arrow down, a turn, an arrow up, a dot.
fn mark(painter: &Painter, at: Pos2, deed: &Deed, ink: Color32) {
    let stroke = Stroke::new(2.0, ink);
    let arrow = |from: Pos2, to: Pos2| {
        let along = (to - from).normalized();
        painter.line_segment([from, to], stroke);
        for side in [along.rot90(), -along.rot90()] {
            painter.line_segment([to, to - 4.5 * along + 4.0 * side], stroke);
        }
    };
    let up = vec2(0.0, 7.0);
    match deed {
        Deed::Put => arrow(at - up, at + up),
        Deed::Pull => arrow(at + up, at - up),
        Deed::Flip(_) => {
            let around = |k: u8| at + 6.0 * egui::Vec2::angled(std::f32::consts::PI * (1.0 + f32::from(k) / 10.0));
            let way: Vec<Pos2> = (0..=9).map(around).collect();
            painter.add(egui::Shape::line(way, stroke));
            arrow(around(8), around(10) + vec2(0.0, 4.0));
        }
        Deed::Serve | Deed::Power(_) => drop(painter.circle_filled(at, 4.0, ink)),
    }
}
