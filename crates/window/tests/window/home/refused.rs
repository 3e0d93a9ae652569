//! Promise: what cannot be planned or fitted is refused in the language of the window.

use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, AppAct, Card, LearnAct, Setting};
use saute_controls::at_home::AtHomeAct;
use saute_controls::plan::PlanAct;
use saute_session::FoodChoice;
use saute_words::language::Language;

use super::plan::{WIDE, act};
use crate::harness::{save, steps, window};

#[test]
fn refusals_of_a_search_and_of_a_fit_speak_both_languages() {
    let words = [
        (Language::ENGLISH, "this food cannot be set out like this", "nothing was entered that can be compared"),
        (crate::harness::japanese(), "この食材はこのままでは用意できません", "比べられる値がありません"),
    ];
    for (language, of_search, of_fit) in words {
        let mut harness = window(WIDE);
        act(&mut harness, Act::App(AppAct::Set(Setting::Language(language))));
        act(&mut harness, Act::App(AppAct::Open(Card::AtHome)));
        act(&mut harness, Act::Learn(LearnAct::AtHome(AtHomeAct::Fit)));
        steps(&mut harness, 10);
        harness.get_by_label_contains(of_fit);
        let choice = FoodChoice { size_mm: vec![750.0, 80.0, 25.0], ..FoodChoice::default() };
        act(&mut harness, Act::App(AppAct::Set(Setting::Choice(choice))));
        // The card's sliders bring the size back: it is requested before.
        act(&mut harness, Act::App(AppAct::Shut(Card::AtHome)));
        act(&mut harness, Act::Learn(LearnAct::Plan(PlanAct::Find)));
        act(&mut harness, Act::App(AppAct::Open(Card::Plan)));
        steps(&mut harness, 6);
        save(&mut harness, &format!("plan-refused-{language:?}"));
        harness.get_by_label_contains(of_search);
    }
}
