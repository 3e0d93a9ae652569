//! Advice as a verb, a reason and a deed.

use saute_kitchen::advice::{Advice, BROWN, HALF_WAY, Situation, TURNS_S};

use super::now_state::NowState;
use super::time_left::{Course, TimeLeft};
use crate::act::{Act, AppAct, Card, CookAct};
use crate::now::advice_words::{advice_words, class_now, do_it_words, resting_words};
use saute_session::Forecast;
use saute_words::clock::{clock, whole_minutes};
use saute_words::language::Language;
use saute_words::speech::capitalised;

/// Share of the goal's temperature from which the pace of the core shows how long it takes [-] (chosen: before, it still follows the
/// first heat of the pan, and a cook was told 5 min and then 12).
const STEADY: f64 = 0.5;

/// How long before food is taken out somebody gets ready for it [s] (chosen: the time to reach for board and tongs).
const READY_S: f64 = 30.0;

/// The button of the line.
pub struct Deed {
    /// Its text.
    pub text: String,
    /// What it is called.
    pub spoken: String,
    /// What it does.
    pub act: Act,
    /// True if somebody should press it now.
    pub is_lit: bool,
}

impl Deed {
    /// A button whose name is its text.
    pub fn called(text: &str, act: Act, is_lit: bool) -> Self {
        Self { text: text.to_owned(), spoken: text.to_owned(), act, is_lit }
    }
}

/// What the line shows.
pub struct NowWords {
    /// The verb, or what goes on.
    pub verb: String,
    /// Why, or how long.
    pub why: String,
    /// Both in one sentence, for those who hear it.
    pub spoken: String,
    /// The button.
    pub deed: Option<Deed>,
    /// True if somebody should act now.
    pub is_due: bool,
}

impl NowWords {
    /// Words of another lead: what is heard is what is seen.
    pub fn told(verb: String, why: String, deed: Option<Deed>, is_due: bool, l: Language) -> Self {
        let spoken = l.fill("now.spoken", &[("verb", &verb), ("why", &why)]);
        Self { verb, why, spoken, deed, is_due }
    }

    /// Words while the food is moved: an order that was given is not given again.
    pub fn while_moved(l: Language) -> Self {
        let [verb, why] = ["now.one_moment", "now.is_moved"].map(|key| l.text(key).to_owned());
        Self::told(verb, why, None, false, l)
    }

    /// Words for an advice about the hob, which contain no time.
    pub fn without_time(advice: Advice, state: &NowState) -> Self {
        Self::of(advice, state, &mut TimeLeft::default())
    }

    /// Words for the most urgent advice.
    pub fn of(advice: Advice, state: &NowState, memory: &mut TimeLeft) -> Self {
        let [verb, why] = Words { state }.of(advice, memory);
        let deed = deed(advice, state);
        // Once it has rested the result waits to be looked at.
        let is_due = advice.is_due() || deed.as_ref().is_some_and(|deed| deed.is_lit);
        Self { verb, why, spoken: advice_words(advice, state), deed, is_due }
    }
}

/// What the button does, where there is something to do.
fn deed(advice: Advice, state: &NowState) -> Option<Deed> {
    let l = state.settings.language;
    let of = |text: String, act: Act| {
        let spoken = l.fill("advice.do", &[("deed", &text)]);
        Some(Deed { text, spoken, act, is_lit: true })
    };
    match advice {
        Advice::PutIn { .. } => of(l.text("hob.food_in").to_owned(), Act::Cook(CookAct::Put)),
        Advice::Flip => of(l.text("hob.flip").to_owned(), Act::Cook(CookAct::Flip)),
        Advice::TakeOut { .. } | Advice::Ready { .. } => {
            let deed = of(l.text("hob.take_out").to_owned(), Act::Cook(CookAct::Out))?;
            Some(Deed { spoken: l.text("coach.take_out_spoken").to_owned(), ..deed })
        }
        // Near its highest the core decides nothing any more, though it takes minutes until it cools.
        Advice::Resting { .. } if state.rise.is_some() => None,
        Advice::Resting { .. } | Advice::Rested { .. } => {
            of(l.text("result.title").to_owned(), Act::App(AppAct::Open(Card::Result)))
        }
        about_hob => {
            let watts = about_hob.hob_w()?;
            let text = if watts == 0.0 { l.text("now.off").to_owned() } else { format!("{watts:.0} W") };
            Some(Deed { text, spoken: do_it_words(watts, state), act: Act::Cook(CookAct::HobSet(watts)), is_lit: true })
        }
    }
}

/// The words of a state of the window.
struct Words<'a> {
    state: &'a NowState<'a>,
}

impl Words<'_> {
    /// Verb and reason.
    fn of(&self, advice: Advice, memory: &mut TimeLeft) -> [String; 2] {
        let now = self.state.session.kitchen.time_s();
        match advice {
            Advice::TurnOn { power_w } => [self.text("now.turn_on"), self.with_power("now.heats_it", power_w)],
            Advice::TurnOff => [self.text("now.turn_off"), self.text("now.nothing_left")],
            Advice::TooCold { .. } => {
                let is_off = self.state.session.kitchen.hob_w() == 0.0;
                [self.text(if is_off { "now.turn_on" } else { "now.turn_up" }), self.text("now.too_cold")]
            }
            Advice::TooHot { smokes: true, .. } => [self.text("now.turn_down"), self.text("now.smokes")],
            Advice::TooHot { hottest_c, .. } => {
                [self.text("now.turn_down"), self.with_temperature("now.too_hot", hottest_c)]
            }
            Advice::BothBrown { .. } => [self.text("now.turn_down"), self.text("now.both_brown")],
            Advice::TurnDown { .. } => [self.text("now.turn_down"), self.text("now.hot_enough")],
            Advice::Heating { pan_c, until_c: enough_c } => {
                let left = memory.until(Course::Pan, now, pan_c, enough_c).filter(|_| pan_c >= STEADY * enough_c);
                [self.in_time("now.in_soon", "now.heating", left), self.heating_from(pan_c, enough_c)]
            }
            Advice::PutIn { pan_c } => [self.of_food("now.put_in"), self.pan_is_hot(pan_c)],
            Advice::Flip => [self.of_food("now.flip"), self.text(self.why_flip())],
            Advice::TakeOut { peak_c } => [self.of_food("now.take_out"), self.ahead("now.rests_up", peak_c)],
            Advice::Ready { .. } => [self.of_food("now.take_out"), self.class("now.core_is")],
            Advice::WouldPeak { peak_c, wet } => self.frying(peak_c, wet, memory),
            Advice::NotReady { share_pct, until_pct } => {
                let [share, goal] = [share_pct, until_pct].map(|pct| format!("{pct:.0}"));
                let why = self.fill("now.changed", &[("percent", &share), ("goal", &goal)]);
                [self.class("now.core_is"), why]
            }
            Advice::Wet { .. } => [self.text("now.frying"), self.text("now.wet")],
            Advice::Browns { .. } => [self.text("now.frying"), self.text("now.browns")],
            Advice::Resting { .. } => match self.state.rise {
                Some(Forecast { peak_c, in_s }) => {
                    [self.in_time("now.rests_for", "now.resting", Some(in_s)), self.ahead("now.rises_to", peak_c)]
                }
                None => [self.text("now.has_rested"), self.text("now.at_highest")],
            },
            Advice::Rested { peak_c } => [self.text("now.rested"), resting_words("now.reached", peak_c, self.state)],
        }
    }

    /// What the core will reach, where it may be told.
    fn ahead(&self, key: &'static str, peak_c: f64) -> String {
        if self.state.foretells() { self.with_temperature(key, peak_c) } else { self.text("now.cooks_on") }
    }

    /// When to flip or to take out, whichever comes first.
    fn frying(&self, peak_c: f64, wet: bool, memory: &mut TimeLeft) -> [String; 2] {
        let now = self.state.session.kitchen.time_s();
        let goal = self.state.scale().map_or(peak_c, |scale| self.state.settings.goal(&scale));
        let out = memory.until(Course::Core, now, peak_c, goal).filter(|_| peak_c >= STEADY * goal);
        let flip = self.flip_in(peak_c, goal, memory).filter(|flip| out.is_none_or(|out| *flip + READY_S < out));
        // Far from the goal nobody thinks of taking it out.
        let would = match wet {
            _ if peak_c >= STEADY * goal && self.state.foretells() => self.with_temperature("now.would_peak", peak_c),
            true => self.text("now.wet"),
            false => self.text("now.is_browning"),
        };
        match (flip, out) {
            (Some(flip), Some(out)) => [
                self.in_time("now.flip_soon", "now.frying", Some(flip)),
                self.in_time("now.out_after", "now.frying", Some(out)),
            ],
            (Some(flip), None) => [self.in_time("now.flip_soon", "now.frying", Some(flip)), would],
            // So near, the forecast is rounded to the goal, and would seem to contradict the wait.
            (None, Some(out)) if out <= READY_S => {
                [self.in_time("now.out_soon", "now.frying", Some(out)), self.text("now.get_ready")]
            }
            (None, out) => [self.in_time("now.out_soon", "now.frying", out), would],
        }
    }

    /// In how long the advice requests a flip, where that can be determined: once the side below is brown or half of the heat is in; from then on
    /// the sides take turns.
    fn flip_in(&self, peak_c: f64, goal: f64, memory: &mut TimeLeft) -> Option<f64> {
        let session = &self.state.session;
        let (now, at) = (session.kitchen.time_s(), Situation::of(&session.kitchen, session.shown_piece()?));
        let [below, above] = at.browning;
        let browns = memory.until(Course::Brown, now, below, BROWN).filter(|_| below >= STEADY * BROWN);
        let brown = if below >= BROWN { Some(0.0) } else { browns };
        let left_s = match at.since_flip_s {
            None => {
                let half = at.room_c + HALF_WAY * (goal - at.room_c);
                let by_core = memory.until(Course::Core, now, peak_c, half).filter(|_| peak_c >= STEADY * half);
                [brown, by_core].into_iter().flatten().min_by(f64::total_cmp)
            }
            Some(since_s) if above >= BROWN => Some((TURNS_S - since_s).max(brown.unwrap_or_default())),
            Some(_) => brown,
        };
        left_s.filter(|left_s| *left_s > 0.0)
    }

    /// How hot the pan is and should be, and how long the whole cook takes where its food is judged by its core.
    fn heating_from(&self, pan_c: f64, enough_c: f64) -> String {
        let [temperature, until] = [pan_c, enough_c].map(|c| self.state.settings.temperature(c));
        let Some(whole_s) = self.state.whole_time_s() else {
            return self.fill("now.heating_from", &[("temperature", &temperature), ("until", &until)]);
        };
        let parts: [(&str, &dyn std::fmt::Display); 3] =
            [("temperature", &temperature), ("until", &until), ("minutes", &whole_minutes(whole_s))];
        self.fill("now.heating_and_all", &parts)
    }

    /// How hot the pan is, and how much oil is in it, which nobody pours before the first food.
    fn pan_is_hot(&self, pan_c: f64) -> String {
        let temperature = self.state.settings.temperature(pan_c);
        let oil_g = 1e3 * self.state.session.kitchen.pan_state().oil_mass();
        match oil_g.round() {
            0.0 => self.fill("now.pan_is_hot", &[("temperature", &temperature)]),
            grams => self.fill("now.pan_and_oil_are_hot", &[("temperature", &temperature), ("grams", &grams)]),
        }
    }

    /// Why it is time to flip.
    fn why_flip(&self) -> &'static str {
        let session = &self.state.session;
        match session.shown_piece().map(|piece| Situation::of(&session.kitchen, piece).browning.map(|b| b >= BROWN)) {
            Some([true, true]) => "now.turns",
            Some([true, false]) => "now.brown_below",
            _ => "now.half_way",
        }
    }

    fn text(&self, key: &'static str) -> String {
        self.state.settings.language.text(key).to_owned()
    }

    fn fill(&self, key: &'static str, parts: &[(&str, &dyn std::fmt::Display)]) -> String {
        self.state.settings.language.fill(key, parts)
    }

    fn with_temperature(&self, key: &'static str, celsius: f64) -> String {
        self.fill(key, &[("temperature", &self.state.settings.temperature(celsius))])
    }

    fn with_power(&self, key: &'static str, watts: f64) -> String {
        self.fill(key, &[("power", &format!("{watts:.0} W"))])
    }

    fn of_food(&self, key: &'static str) -> String {
        let l = self.state.settings.language;
        l.fill(key, &[("food", &self.state.session.noun(l))])
    }

    fn class(&self, key: &'static str) -> String {
        self.fill(key, &[("class", &class_now(self.state))])
    }

    /// In how long, to ten seconds; what goes on where that is not known.
    fn in_time(&self, key: &'static str, otherwise: &'static str, left_s: Option<f64>) -> String {
        let Some(left_s) = left_s else { return self.text(otherwise) };
        let l = self.state.settings.language;
        let time = clock(10.0 * (0.1 * left_s).ceil());
        l.fill(key, &[("food", &capitalised(&self.state.session.noun(l))), ("time", &time)])
    }
}
