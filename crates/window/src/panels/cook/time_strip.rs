//! The strip of time: what was done and when; it is dragged to turn time back and forth.

use egui::{Color32, EventFilter, FontId, Key, Pos2, Rect, Response, Sense, Stroke, Ui, pos2, vec2};

use crate::panels::ways::way_words;
use crate::ui::aloud::{spoken_range, spoken_value};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, TimeAct, ViewAct};
use saute_controls::context::PanelContext;
use saute_session::Mark;
use saute_words::act_words::act_words;
use saute_words::clock::clock;

/// Ends of the strip [s]: the first that the cook fits in is shown, so that marks stay where they are while time passes.
const SPANS: [f64; 8] = [120.0, 300.0, 600.0, 1200.0, 1800.0, 3600.0, 7200.0, 14_400.0];
/// Time by which an arrow key turns it [s] (chosen: seen at once, and fine enough for a flip).
const KEY_STEP: f64 = 1.0;
/// A click this near to a mark goes to the mark [points] (chosen: a finger's slack at the size of the mark).
const NEAR: f32 = 6.0;
/// Width of the line, radius of a mark and of the handle [points].
const LINE: f32 = 4.0;
const MARK: f32 = 3.5;
const HANDLE: f32 = 7.0;
/// Room for a time at either end of the strip [points], and its size.
const END: f32 = 40.0;
const END_SIZE: f32 = 12.0;

/// Shows the strip with a size.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, size: egui::Vec2) {
    if state.hides(&Act::Time(TimeAct::Scrub(0.0))) {
        return;
    }
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let strip = Strip::new(state, rect);
    let l = state.settings.language;
    response.widget_info(|| egui::WidgetInfo::slider(true, strip.shown_s, l.text("strip.name")));
    spoken_value(ui, &response, clock(strip.shown_s));
    acts.extend(
        spoken_range(ui, &response, 0.0..=strip.end_s, strip.shown_s).map(|to_s| Act::Time(TimeAct::Scrub(to_s))),
    );
    strip.turn_by_pointer(&response, acts);
    strip.turn_by_keys(ui, &response, acts);
    strip.paint(ui, &response);
    let hovered = response.hover_pos().filter(|_| !response.dragged());
    let text = hovered.map(|at| match strip.mark_near(at) {
        Some(mark) => {
            let parts: [(&str, &dyn std::fmt::Display); 2] =
                [("what", &act_words(&mark.done, l)), ("time", &clock(mark.time_s))];
            l.fill("strip.mark", &parts)
        }
        None => l.fill("strip.hint", &[("time", &clock(strip.time_at(at)))]),
    });
    if let Some(text) = text {
        response.on_hover_text_at_pointer(text);
    }
}

/// Shows undo and redo.
pub fn undo_and_redo(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    undo(state, ui, acts);
    step_button(state, ui, acts, ["strip.redo", "strip.redo_hint"], state.session.can_redo(), TimeAct::Redo);
}

/// Shows undo.
pub fn undo(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    step_button(state, ui, acts, ["strip.undo", "strip.undo_hint"], state.session.can_undo(), TimeAct::Undo);
}

fn step_button(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, keys: [&'static str; 2], can: bool, act: TimeAct) {
    let [name, hint] = keys.map(|key| state.settings.language.text(key));
    let (height, act) = (ui.spacing().interact_size.y, Act::Time(act));
    if state.hides(&act) {
        return;
    }
    let button = theme::of(ui).button(name, false).min_size(vec2(height, height));
    if ui.add_enabled(can && !state.forbids(&act), button).on_hover_text(hint).clicked() {
        acts.push(act);
    }
}

/// Shows the other ways that the cook went, if there are any.
pub fn branches(state: &PanelContext, side_by_side: bool, ui: &mut Ui, acts: &mut Acts) {
    if !state.session.has_branches() {
        return;
    }
    let l = state.settings.language;
    let others = state.session.all_ways().count() - 1;
    let text = egui::RichText::new(l.fill("strip.ways", &[("count", &others)])).size(13.0);
    ui.spacing_mut().button_padding = vec2(7.0, 0.0);
    let shown = ui.menu_button(text, |ui| {
        if ui.selectable_label(side_by_side, l.text("ways.side_by_side")).clicked() {
            acts.push(Act::View(ViewAct::SideBySide));
            ui.close();
        }
        ui.separator();
        ui.label(egui::RichText::new(l.text("strip.ways_title")).size(13.0).color(theme::of(ui).quiet));
        for (place, name) in state.session.branches().iter().enumerate() {
            if ui.button(way_words(name, l)).clicked() {
                acts.push(Act::Time(TimeAct::Branch(place)));
                ui.close();
            }
        }
    });
    shown.response.on_hover_text(l.text("strip.ways_hint"));
}

/// The strip as it is laid out in one frame.
struct Strip<'a> {
    rect: Rect,
    /// Time at its right end [s].
    span_s: f64,
    shown_s: f64,
    end_s: f64,
    marks: &'a [Mark],
}

impl<'a> Strip<'a> {
    fn new(state: &PanelContext<'a>, rect: Rect) -> Self {
        let end_s = state.session.end_s();
        let fits = |span: &f64| *span >= end_s;
        let span_s = SPANS.into_iter().find(fits).unwrap_or(end_s);
        let (shown_s, marks) = (state.session.shown_s(), state.session.all_marks());
        Self { rect, span_s, shown_s, end_s, marks }
    }

    fn ends(&self) -> [f32; 2] {
        [self.rect.left() + END, self.rect.right() - END]
    }

    fn at(&self, time_s: f64) -> Pos2 {
        let [left, right] = self.ends();
        pos2(left + (right - left) * (time_s / self.span_s) as f32, self.rect.center().y)
    }

    /// The time at a point, within what was cooked [s].
    fn time_at(&self, at: Pos2) -> f64 {
        let [left, right] = self.ends();
        (f64::from((at.x - left) / (right - left)) * self.span_s).clamp(0.0, self.end_s)
    }

    fn mark_near(&self, at: Pos2) -> Option<&'a Mark> {
        let away = |mark: &Mark| (self.at(mark.time_s).x - at.x).abs();
        let nearest = self.marks.iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(nearest) <= NEAR).then_some(nearest)
    }

    fn turn_by_pointer(&self, response: &Response, acts: &mut Acts) {
        if response.drag_started() {
            acts.push(Act::Time(TimeAct::HoldTime(true)));
        }
        if let Some(at) = response.interact_pointer_pos() {
            if response.dragged() {
                acts.push(Act::Time(TimeAct::Scrub(self.time_at(at))));
            } else if response.clicked() {
                acts.push(Act::Time(TimeAct::Scrub(
                    self.mark_near(at).map_or_else(|| self.time_at(at), |mark| mark.time_s),
                )));
            }
        }
        if response.drag_stopped() {
            acts.push(Act::Time(TimeAct::HoldTime(false)));
        }
    }

    /// Left and right turn time by a second, up and down to the mark before or after.
    fn turn_by_keys(&self, ui: &Ui, response: &Response, acts: &mut Acts) {
        if !response.has_focus() {
            return;
        }
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
        let times = |key| ui.input(|i| i.num_presses(key)) as f64;
        let by = times(Key::ArrowRight) - times(Key::ArrowLeft);
        if by != 0.0 {
            acts.push(Act::Time(TimeAct::Scrub((self.shown_s + by * KEY_STEP).clamp(0.0, self.end_s))));
        }
        let apart = 0.5 * saute_kitchen::TICK_S;
        let is_before = |mark: &&Mark| mark.time_s < self.shown_s - apart;
        let is_after = |mark: &&Mark| mark.time_s > self.shown_s + apart;
        if times(Key::ArrowDown) > 0.0 {
            acts.extend(self.marks.iter().rev().find(is_before).map(|mark| Act::Time(TimeAct::Scrub(mark.time_s))));
        } else if times(Key::ArrowUp) > 0.0 {
            acts.extend(self.marks.iter().find(is_after).map(|mark| Act::Time(TimeAct::Scrub(mark.time_s))));
        }
    }

    fn paint(&self, ui: &Ui, response: &Response) {
        let (palette, painter) = (theme::of(ui), ui.painter());
        let line = |from: f64, to: f64, colour: Color32| {
            let ends = [self.at(from), self.at(to)];
            painter.line_segment(ends, Stroke::new(LINE, colour));
        };
        for (at, time_s) in [(self.rect.left_center(), 0.0), (self.rect.right_center(), self.span_s)] {
            let text = painter.layout_no_wrap(clock(time_s), FontId::proportional(END_SIZE), palette.quiet);
            let left = if time_s > 0.0 { at.x - text.size().x } else { at.x };
            painter.galley(pos2(left, at.y - 0.5 * text.size().y), text, palette.quiet);
        }
        line(0.0, self.span_s, palette.raised);
        line(0.0, self.end_s, palette.pressed);
        line(0.0, self.shown_s, palette.chosen);
        for mark in self.marks {
            // What is ahead is hollow.
            let done = mark.time_s <= self.shown_s;
            let fill = if done { palette.text } else { palette.sunken };
            painter.circle(self.at(mark.time_s), MARK, fill, Stroke::new(1.0, palette.quiet));
        }
        let handle = self.at(self.shown_s);
        let active = response.hovered() || response.dragged() || response.has_focus();
        let ring = if active { palette.text } else { palette.quiet };
        painter.circle(handle, HANDLE, palette.chosen, Stroke::new(1.5, ring));
        if response.dragged() {
            let text = painter.layout_no_wrap(clock(self.shown_s), FontId::proportional(15.0), palette.text);
            let ground = Rect::from_center_size(handle - vec2(0.0, 26.0), text.size() + vec2(14.0, 6.0));
            let over = ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Tooltip, response.id));
            over.rect_filled(ground, 6.0, palette.solid);
            over.galley(ground.min + vec2(7.0, 3.0), text, palette.text);
        }
    }
}
