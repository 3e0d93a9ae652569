//! The guide of a cook that follows a plan, on the line: the next step with its time; below it its cue, a bell and a way out; in the
//! end what it gave next to what was promised.

use egui::{RichText, Ui, vec2};
use saute_plan::goal::Outcome;
use saute_plan::schedule::Deed as Task;
use saute_plan::schedule::follow::{Followed, LATE_S, Left};
use saute_plan::schedule::senses::Sense;
use saute_plan::schedule::voice::Keeping;

use crate::panels::learn::hear;
use crate::ui::bell::{self, Bell};
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card, LearnAct, TimeAct};
use saute_controls::context::PanelContext;
use saute_controls::now::now_words::{Deed, NowWords};
use saute_controls::plan::PlanAct;
use saute_session::hearing::example::Example;
use saute_session::plan::live::{Guidance, Live, READY_S};
use saute_words::clock::clock;
use saute_words::language::Language;
use saute_words::speech::capitalised;
use saute_words::{cue_words, plan_words};

/// Height of the cue, which has the buttons beside it [points]: always the same, so that nothing moves when the words change.
const CUE: f32 = 48.0;
/// Height of the cue in a line that is narrower than a width, and of the row of buttons below it [points].
const NARROW_CUE: f32 = 54.0;
const NARROW: f32 = 460.0;
const ROW: f32 = 30.0;
/// Height of the bell [points].
const BELL: f32 = 24.0;

/// The guide of a cook that follows a plan.
pub(super) struct Guide<'a> {
    live: &'a Live,
    guidance: Guidance,
}

impl<'a> Guide<'a> {
    /// Its words now.
    pub fn of(live: &'a Live, state: &PanelContext) -> Self {
        Self { live, guidance: live.guidance(state.session) }
    }

    /// Returns true once the rest is over.
    pub fn is_over(&self) -> bool {
        self.live.gave().is_some()
    }

    /// Words for the next step, or for the end.
    pub fn words(&self, state: &PanelContext) -> NowWords {
        self.live.gave().map_or_else(|| self.next(state), |gave| self.end(gave, state))
    }

    fn next(&self, state: &PanelContext) -> NowWords {
        let l = state.settings.language;
        NowWords::told(self.step(l), self.said(l), self.deed(state), self.is_due(), l)
    }

    /// What comes next, and when.
    fn step(&self, l: Language) -> String {
        let deeds = capitalised(&cue_words::deeds(&self.guidance.next, l));
        l.fill("plan.deed_when", &[("deed", &deeds), ("when", &self.when(l))])
    }

    fn end(&self, gave: &Outcome, state: &PanelContext) -> NowWords {
        let l = state.settings.language;
        let (verb, why) = (l.text("plan.over").to_owned(), self.line(gave, "plan.was_reached", state));
        let result = Deed::called(l.text("result.title"), Act::App(AppAct::Open(Card::Result)), true);
        NowWords::told(verb, why, Some(result), false, l)
    }

    fn due_in_s(&self) -> f64 {
        self.guidance.due_in_s().unwrap_or_default()
    }

    fn is_due(&self) -> bool {
        self.guidance.due_in_s().is_some_and(|in_s| in_s <= 0.0)
    }

    /// A step that is done early is none of the plan.
    fn can_do(&self) -> bool {
        self.is_due() && self.guidance.next.iter().any(|f| f.step.deed != Task::Serve)
    }

    /// The button: does what is due, starts the clock, or lets it run up to the next step.
    fn deed(&self, state: &PanelContext) -> Option<Deed> {
        let l = state.settings.language;
        if self.can_do() {
            return Some(self.do_it(l));
        }
        // Doing the step starts the clock too: there is one way to go on.
        let (key, act, is_lit) = if state.session.paused {
            ("plan.start", Act::Time(TimeAct::Pause), self.due_in_s() > 0.0)
        } else if self.due_in_s() > READY_S && state.session.speed < 20.0 {
            ("plan.hurry", Act::Learn(LearnAct::Plan(PlanAct::Hurry)), false)
        } else {
            return None;
        };
        Some(Deed::called(l.text(key), act, is_lit))
    }

    fn do_it(&self, l: Language) -> Deed {
        let deeds = cue_words::deeds(&self.guidance.next, l);
        Deed {
            text: l.text("plan.do_it_short").to_owned(),
            spoken: l.fill("plan.do_it", &[("deed", &deeds)]),
            act: Act::Learn(LearnAct::Plan(PlanAct::DoStep)),
            is_lit: true,
        }
    }

    /// In how long, now, or how late.
    fn when(&self, l: Language) -> String {
        match self.due_in_s() {
            s if s > 0.0 => l.fill("plan.in", &[("time", &clock(s.ceil()))]),
            s if s > -LATE_S => l.text("plan.now").to_owned(),
            s => l.fill("plan.late_by", &[("seconds", &format!("{:.0}", -s))]),
        }
    }

    /// Where one is in the plan; that time slowed down, else whether the last step was early or late and that the others keep their times.
    fn said(&self, l: Language) -> String {
        let [step, all] = self.guidance.place();
        let place = l.fill("plan.step_of", &[("step", &step), ("all", &all)]);
        // After the last step time is stopped.
        let said = match self.live.returns_to().filter(|_| step < all) {
            Some(speed) => l.fill("plan.returns_to", &[("speed", &format!("{speed:.0}"))]),
            None => last_words(&self.guidance, l),
        };
        format!("{place} {said}")
    }

    /// What was promised or reached.
    fn line(&self, outcome: &Outcome, key: &'static str, state: &PanelContext) -> String {
        let (l, settings) = (state.settings.language, state.settings);
        let [share, crust] = [outcome.target_share_pct, outcome.crust_pct].map(|pct| format!("{pct:.0}"));
        let core = settings.fine_temperature(outcome.core_peak_c);
        let class = plan_words::class(self.live.goal(), l);
        l.fill(key, &[("core", &core), ("share", &share), ("class", &class), ("crust", &crust)])
    }

    /// Height of what is below a line of a width [points].
    pub fn height(ui: &Ui, width: f32) -> f32 {
        if width < NARROW { NARROW_CUE + ui.spacing().item_spacing.y + fingers::height(ui, ROW) } else { CUE }
    }

    /// Shows the bell, the cue and the way out; where the line shows the advice, the step and its button too.
    pub fn show(&self, has_word: bool, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        if ui.available_height() <= CUE {
            ui.with_layout(from_right, |ui| {
                self.ways_out(has_word, state, ui, acts);
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    self.bell(state, ui);
                    self.cue(has_word, state, ui);
                });
            });
            return;
        }
        ui.allocate_ui(vec2(ui.available_width(), NARROW_CUE), |ui| {
            ui.set_min_height(NARROW_CUE);
            self.cue(has_word, state, ui);
        });
        ui.horizontal(|ui| {
            ui.set_height(fingers::height(ui, ROW));
            self.bell(state, ui);
            ui.with_layout(from_right, |ui| self.ways_out(has_word, state, ui, acts));
        });
    }

    fn bell(&self, state: &PanelContext, ui: &mut Ui) {
        if !self.is_over() {
            let (l, rings) = (state.settings.language, self.is_due());
            let spoken = l.text(if rings { "plan.bell_rings" } else { "plan.bell_waits" });
            bell::show(ui, &Bell { size: BELL, spoken, rings, moves: !crate::ui::display::moves_less(state.settings) });
        }
    }

    /// How the plan was left, else what there is to see at the step, or what was promised.
    fn cue(&self, has_word: bool, state: &PanelContext, ui: &mut Ui) {
        let (l, palette) = (state.settings.language, theme::of(ui));
        let sense = |followed| Some(cue_words::sense(&self.sense(state, followed)?, state.settings.speech()));
        let senses = || self.guidance.next.iter().filter_map(sense).collect::<Vec<_>>().join(" ");
        let (words, ink) = match (self.is_over(), self.left(state)) {
            (true, _) => (self.line(&self.live.plan().promised, "plan.was_promised", state), palette.quiet),
            (false, Some(left)) => (left_words(left, l), palette.accent),
            (false, None) if !has_word => (self.step(l), palette.text),
            (false, None) => (senses(), palette.quiet),
        };
        ui.add(egui::Label::new(RichText::new(words).size(12.5).color(ink)).wrap());
    }

    fn sense(&self, state: &PanelContext, followed: &Followed) -> Option<Sense> {
        // Of food that is out there is nothing to feel.
        let followed = Some(followed).filter(|followed| followed.left != Left::Hob)?;
        self.live.plan().sense(&followed.step, &state.session.library)
    }

    /// The sound of the step that comes next, where its cue is one to hear.
    fn hiss(&self, state: &PanelContext) -> Option<Example> {
        self.guidance.next.iter().find_map(|followed| match self.sense(state, followed)? {
            Sense::Face { hiss, .. } => Some(Example::of_hiss(hiss)),
            _ => None,
        })
    }

    fn left(&self, state: &PanelContext) -> Option<Keeping> {
        Some(self.live.keeping(state.session)).filter(|keeping| *keeping != Keeping::Kept)
    }

    /// Ends the guide; where the line shows the advice, the guide's button is here.
    fn ways_out(&self, has_word: bool, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
        let (l, palette, size) = (state.settings.language, theme::of(ui), vec2(44.0, fingers::height(ui, ROW)));
        let leave = palette.button(l.text("plan.leave"), false).min_size(size);
        if ui.add(leave).on_hover_text(l.text("plan.leave_hint")).clicked() {
            acts.push(Act::Learn(LearnAct::Plan(PlanAct::Leave)));
        }
        if !self.is_over() && self.left(state).is_none() {
            hear::button(state, self.hiss(state), ui, acts);
        }
        if has_word || self.is_over() {
            return;
        }
        let Some(Deed { text, spoken, act, .. }) = self.deed(state) else { return };
        let response = ui.add(palette.button(&text, false).min_size(size));
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &spoken));
        if response.clicked() {
            acts.push(act);
        }
    }
}

/// How the plan was left, and who leads then.
fn left_words(keeping: Keeping, l: Language) -> String {
    match keeping {
        Keeping::Kept => String::new(),
        Keeping::Missed(deed) => l.fill("plan.missed", &[("deed", &cue_words::deed(&deed, l))]),
        Keeping::OtherPower(w) => l.fill("plan.other_power", &[("power", &format!("{w:.0}"))]),
    }
}

fn last_words(guidance: &Guidance, l: Language) -> String {
    guidance.last.map_or_else(
        || l.text("plan.begin_how").to_owned(),
        |(deed, late_s)| {
            let seconds = format!("{:.0}", late_s.abs());
            let key = match late_s {
                s if s > LATE_S => "plan.was_late",
                s if s < -LATE_S => "plan.was_early",
                _ => "plan.was_right",
            };
            l.fill(key, &[("deed", &cue_words::deed(&deed, l)), ("seconds", &seconds)])
        },
    )
}
