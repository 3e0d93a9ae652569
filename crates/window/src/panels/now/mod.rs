//! The line that states what to do now, over the foot of the scene: a verb, its reason or the time that is left, and the one button
//! that does it. While a plan, the tutorial, a lesson or a study leads, its words are shown there instead, and what else it shows below
//! them.

pub mod control_place;
mod guide;
mod led;
mod taught;

use std::sync::Arc;

use egui::{Align2, Area, Color32, FontId, Galley, Id, Rect, Stroke, StrokeKind, Ui, UiBuilder, Vec2, pos2, vec2};
use saute_kitchen::celsius;
use saute_kitchen::food::change::doneness::Measure;

use self::led::Lead;
use crate::ui::layout::{GAP, Layout};
use crate::ui::theme::{self, TOUCH};
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;
use saute_controls::now::now_memory::NowMemory;
use saute_controls::now::now_state::NowState;
use saute_controls::now::now_words::{Deed, NowWords};
use saute_controls::now::time_left::TimeLeft;
use saute_session::guided::Guided;

/// Its size over the scene [points].
const SIZE: Vec2 = vec2(520.0, 64.0);
/// Its height in the drawer of a narrow window [points].
const DRAWER_HEIGHT: f32 = 60.0;
/// Width below which the words of a plan get the room of the core, and their height then [points].
const TIGHT: f32 = 460.0;
const TIGHT_HEIGHT: f32 = 76.0;
/// Width of the column of the core [points].
const CORE_WIDTH: f32 = 76.0;
/// Distance of the words from the edge, and of columns from each other [points].
const PAD: f32 = 12.0;
/// Time for which a pointer's click on a button that has become another one is not meant for it [wall s] (chosen: a hand takes a third of a
/// second from seeing to clicking, and twice that with a way to go; the clicks of two newcomers on "400 W" flipped the steak).
const REACTION_S: f64 = 0.8;
/// Sizes among which a line takes the first in which it fits [points].
const VERB_SIZES: [f32; 4] = [20.0, 18.0, 16.0, 14.0];
const WHY_SIZES: [f32; 3] = [14.0, 13.0, 12.0];

/// Shows the line over the scene; a narrow window has it in the drawer, unless that is hidden.
pub fn show(state: &NowState, memory: &mut NowMemory, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    let in_drawer = layout.narrow && !layout.tiny && !state.settings.hides_panels();
    let lead = Lead::of(state);
    let beside_ways = layout.ways.is_some() && !matches!(lead, Some(Lead::Tutorial(_) | Lead::Guided(_)));
    if in_drawer || beside_ways {
        return;
    }
    let now = Now::of(state, lead.as_ref(), &mut memory.left);
    memory.order = now.as_ref().and_then(|now| now.order(state));
    let Some(now) = now else { return };
    let width = SIZE.x.min(layout.free.width() - 2.0 * GAP);
    let size = vec2(width, now.height(SIZE.y, width) + now.below(ui, width));
    let rect = place(state, layout, size);
    Area::new(Id::unique("now")).fixed_pos(rect.min).pivot(Align2::LEFT_TOP).show(ui.ctx(), |ui| {
        now.show(state, ui, acts, (size, now.height(SIZE.y, width)));
    });
    now.light(state, ui);
}

/// Shows the line in the drawer of a narrow window.
pub fn in_drawer(state: &NowState, memory: &mut NowMemory, ui: &mut Ui, acts: &mut Acts) {
    let lead = Lead::of(state);
    let now = Now::of(state, lead.as_ref(), &mut memory.left);
    memory.order = now.as_ref().and_then(|now| now.order(state));
    let Some(now) = now else { return };
    let width = ui.available_width();
    let upper = now.height(DRAWER_HEIGHT, width);
    now.show(state, ui, acts, (vec2(width, upper + now.below(ui, width)), upper));
    if lead.is_some() {
        now.light(state, ui);
    }
}

/// What the line shows, and who leads.
struct Now<'a> {
    words: NowWords,
    lead: Option<&'a Lead<'a>>,
    /// True if the words are those of the lead.
    is_led: bool,
}

/// Where the line is: at the foot of the free part, clear of the legend and of the buttons of the eye.
fn place(state: &PanelContext, layout: &Layout, size: Vec2) -> Rect {
    let free = layout.free;
    let left = free.center().x - 0.5 * size.x;
    let beside = layout.tiny || left + size.x + GAP <= layout.eye.left();
    let corner = if beside { 0.0 } else { 2.0 * GAP + layout.eye.height() };
    let foot = free.bottom() - PAD - corner.max(crate::panels::badge::held_height(state));
    Rect::from_min_size(pos2(left, foot - size.y), size)
}

impl<'a> Now<'a> {
    /// What the line shows; nothing where readings are hidden and nobody else leads, nor while the card of a lesson or a study contains a question.
    fn of(state: &NowState, lead: Option<&'a Lead<'a>>, memory: &mut TimeLeft) -> Option<Self> {
        if state.guided.is_some_and(Guided::asks) {
            return None;
        }
        let advice = state.advice.first().filter(|_| state.reads_out()).copied();
        let led = lead.and_then(|lead| lead.words(advice, state));
        let is_led = led.is_some();
        let is_moved = state.reads_out() && state.session.kitchen.has_task();
        let moved = is_moved.then(|| NowWords::while_moved(state.settings.language));
        let words = led.or(moved).or_else(|| Some(NowWords::of(advice?, state, memory)))?;
        Some(Self { words, lead, is_led })
    }

    /// What is to be done now, if anything is.
    fn order(&self, state: &PanelContext) -> Option<(String, String)> {
        let NowWords { verb, why, is_due, .. } = &self.words;
        let sentence = || state.settings.language.fill("now.spoken", &[("verb", verb), ("why", why)]);
        is_due.then(|| (verb.clone(), sentence()))
    }

    /// Returns true if a narrow line has the words of a plan, which are long: they get the room of the core.
    fn is_tight(&self, width: f32) -> bool {
        width < TIGHT && matches!(self.lead, Some(Lead::Plan(_)))
    }

    /// Height of verb and reason in a width [points].
    fn words_height(&self, ui: &Ui, width: f32) -> f32 {
        let height = |text: &str, sizes: &[f32]| fitted(ui, text, sizes, width, Color32::PLACEHOLDER).size().y;
        height(&self.words.verb, &VERB_SIZES) + height(&self.words.why, &WHY_SIZES)
    }

    /// Height of the upper part, which is `usual` high as a rule [points].
    fn height(&self, usual: f32, width: f32) -> f32 {
        if self.is_tight(width) { TIGHT_HEIGHT } else { usual }
    }

    /// Height of what the lead shows below it [points].
    fn below(&self, ui: &Ui, width: f32) -> f32 {
        self.lead.and_then(|lead| lead.height(ui, width)).map_or(0.0, |height| PAD + height)
    }

    /// Core, verb and reason, button: the upper part, of a height; below it what the lead shows.
    fn show(&self, state: &PanelContext, ui: &mut Ui, acts: &mut Acts, (size, height): (Vec2, f32)) {
        let (words, palette) = (&self.words, theme::of(ui));
        let (whole, ground) = ui.allocate_exact_size(size, egui::Sense::click_and_drag());
        ground.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &words.spoken));
        let edge = if words.is_due { Stroke::new(2.0, palette.accent) } else { Stroke::new(1.0, palette.line) };
        ui.painter().rect(whole, theme::CORNER, palette.solid, edge, StrokeKind::Inside);
        let (rect, below) = whole.split_top_bottom_at_y(whole.top() + height);
        if let Some(lead) = self.lead {
            let room = Rect::from_min_max(below.min + vec2(PAD, 0.0), below.max - vec2(PAD, PAD));
            lead.show(self.is_led, state, &mut ui.new_child(UiBuilder::new().max_rect(room)), acts);
        }
        let mut room = rect.shrink2(vec2(PAD, 8.0));
        match &words.deed {
            Some(deed) => room.max.x -= button(ui, acts, deed, room) + PAD,
            None => forget_button(ui),
        }
        let beside_core = room.width() - CORE_WIDTH - PAD;
        let has_room = size.x >= TIGHT || self.words_height(ui, beside_core) <= room.height();
        if let Some([core, goal]) = core(state).filter(|_| has_room && !self.is_tight(size.x)) {
            let column = Rect::from_min_size(room.min, vec2(CORE_WIDTH, room.height()));
            two_lines(ui, column, [(&core, &[24.0, 20.0], palette.text), (&goal, &WHY_SIZES, palette.quiet)]);
            room.min.x += CORE_WIDTH + PAD;
        }
        let verb = if words.is_due { palette.accent } else { palette.text };
        two_lines(ui, room, [(&words.verb, &VERB_SIZES, verb), (&words.why, &WHY_SIZES, palette.quiet)]);
    }

    /// Lights the control of the button's act, or that the tutorial means. Behind a card nothing is to be pressed.
    fn light(&self, state: &NowState, ui: &Ui) {
        if state.card_is_open {
            return;
        }
        let act = match &self.words.deed {
            // Powers have a mark on the slider.
            Some(deed) => {
                Some(&deed.act).filter(|act| deed.is_lit && !matches!(act, Act::Cook(CookAct::HobSet(_)))).cloned()
            }
            None => self.lead.filter(|_| self.words.is_due).and_then(|lead| lead.control(state)),
        };
        if let Some(act) = act {
            control_place::light(ui, &act);
        }
    }
}

/// Two lines over each other, each in the first of its sizes in which it fits the width.
fn two_lines(ui: &Ui, room: Rect, lines: [(&str, &[f32], Color32); 2]) {
    let galleys = lines.map(|(text, sizes, colour)| fitted(ui, text, sizes, room.width(), colour));
    let height: f32 = galleys.iter().map(|galley| galley.size().y).sum();
    let mut at = pos2(room.left(), room.center().y - 0.5 * height);
    for (galley, (_, _, colour)) in galleys.into_iter().zip(lines) {
        let down = galley.size().y;
        ui.painter().galley(at, galley, colour);
        at.y += down;
    }
}

/// The text in the first size in which it fits, else wrapped in the smallest.
fn fitted(ui: &Ui, text: &str, sizes: &[f32], width: f32, colour: Color32) -> Arc<Galley> {
    let painter = ui.painter();
    let font = |size: f32| FontId::proportional(size);
    let whole = |size: &f32| painter.layout_no_wrap(text.to_owned(), font(*size), colour);
    let fits = sizes.iter().map(whole).find(|galley| galley.size().x <= width);
    let smallest = sizes.last().copied().unwrap_or(12.0);
    fits.unwrap_or_else(|| painter.layout(text.to_owned(), font(smallest), colour, width))
}

/// The button at the right end; returns its width.
fn button(ui: &mut Ui, acts: &mut Acts, deed: &Deed, room: Rect) -> f32 {
    let palette = theme::of(ui);
    let words = egui::RichText::new(&deed.text).size(16.0).strong();
    let button = if deed.is_lit {
        egui::Button::new(words.color(palette.on_accent)).fill(palette.accent)
    } else {
        egui::Button::new(words)
    };
    let button = button.min_size(vec2(96.0, TOUCH));
    let width = 24.0 + fitted(ui, &deed.text, &[16.0], f32::INFINITY, palette.on_accent).size().x;
    let width = width.max(96.0);
    let place = Rect::from_min_size(pos2(room.right() - width, room.center().y - 0.5 * TOUCH), vec2(width, TOUCH));
    // In its own ui: what comes below the line begins below all of it.
    let response = ui.new_child(UiBuilder::new().max_rect(place)).put(place, button);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &deed.spoken));
    let before = just_before(ui, deed);
    if response.clicked() {
        match before.filter(|_| ui.input(|i| i.pointer.any_click())) {
            None => acts.push(deed.act.clone()),
            // A power that was meant is set; what else was meant may be wrong by now.
            Some(act @ Act::Cook(CookAct::HobSet(_))) => acts.push(act),
            Some(_) => {}
        }
    }
    width
}

/// A button as it was shown last.
#[derive(Clone)]
struct Shown {
    spoken: String,
    act: Act,
    /// Since when [wall s], and what it did before.
    since_s: f64,
    before: Option<Act>,
}

/// What the button did before it has become another one, for a moment: a finger that was on its way meant that.
fn just_before(ui: &Ui, deed: &Deed) -> Option<Act> {
    let (id, now_s) = (Id::unique("now-deed"), ui.input(|i| i.time));
    let shown = match ui.ctx().data(|data| data.get_temp::<Shown>(id)) {
        Some(shown) if shown.spoken == deed.spoken => shown,
        last => Shown {
            spoken: deed.spoken.clone(),
            act: deed.act.clone(),
            since_s: now_s,
            before: last.map(|last| last.act),
        },
    };
    let before = shown.before.clone().filter(|_| now_s - shown.since_s < REACTION_S);
    ui.ctx().data_mut(|data| data.insert_temp(id, shown));
    before
}

/// Notes that there is no button.
fn forget_button(ui: &Ui) {
    ui.ctx().data_mut(|data| data.remove::<Shown>(Id::unique("now-deed")));
}

/// The temperature of the core, large, and the goal below it; none where doneness is determined by something else, or nothing is read
/// out.
fn core(state: &PanelContext) -> Option<[String; 2]> {
    let scale = state.scale().filter(|scale| scale.measure() == Measure::Peak && state.reads_out())?;
    let piece = state.session.shown_piece()?;
    let goal = state.settings.temperature(state.settings.goal(&scale));
    let core = state.settings.temperature(celsius(piece.core()));
    Some([core, state.settings.language.fill("now.goal", &[("temperature", &goal)])])
}

#[cfg(test)]
mod tests {
    use egui::{Context, RawInput};

    use super::*;

    #[test]
    fn a_click_just_after_the_button_has_become_another_one_means_what_it_was() {
        let ctx = Context::default();
        let deed = |spoken: &str, act: CookAct| Deed {
            text: String::new(),
            spoken: spoken.to_owned(),
            act: Act::Cook(act),
            is_lit: true,
        };
        let before = |at_s: f64, spoken: &str, act: CookAct| {
            let mut before = None;
            let input = RawInput { time: Some(at_s), ..RawInput::default() };
            let _ = ctx.run_ui(input, |ui| before = just_before(ui, &deed(spoken, act.clone())));
            before
        };
        assert!(before(0.0, "400 W", CookAct::HobSet(400.0)).is_none(), "nothing was there before");
        let meant = Some(Act::Cook(CookAct::HobSet(400.0)));
        assert!(before(1.0, "flip", CookAct::Flip) == meant && before(1.7, "flip", CookAct::Flip) == meant);
        assert!(before(1.9, "flip", CookAct::Flip).is_none(), "time enough to have seen it");
        let _ = ctx.run_ui(RawInput { time: Some(2.0), ..RawInput::default() }, |ui| forget_button(ui));
        assert!(before(2.1, "400 W", CookAct::HobSet(400.0)).is_none());
    }
}
