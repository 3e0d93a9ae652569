//! Promise: a mistake in a protocol or a scenario is named with file, line, key and remedy; participants are balanced over conditions.

use saute_kitchen::Library;
use saute_schema::InputError;
use saute_study::class::Scenario;
use saute_study::{Participant, Protocol, shipped};

fn library() -> Library {
    Library::embedded().expect("embedded data")
}

pub const SMALL: &str = r#"id = "small"
title = "Small"
consent = "Agree?"
[[condition]]
id = "A"
information = "shown"
[[condition]]
id = "B"
information = "hidden"
[[phase]]
title = "Before"
[phase.simulate]
recipe = "medium"
goal = "study-2013"
trials = 1
speed = 20
max_s = 10
[[phase]]
[phase.cook_for_real]
instructions = "Cook."
goal = "study-2013"
enter = ["core_c", "class"]
[[phase]]
[phase.simulate]
recipe = "medium"
goal = "study-2013"
trials = 1
speed = 20
max_s = 10
[[phase]]
[phase.questionnaire]
[[phase.questionnaire.item]]
id = "fun"
text = "Was it fun?"
answer = "likert"
"#;

fn wrong(from: &str, to: &str) -> InputError {
    assert!(SMALL.contains(from), "{from}");
    Protocol::parse(&SMALL.replacen(from, to, 1), "mine.toml", &library()).expect_err(to)
}

#[test]
fn mistakes_in_a_protocol_are_named_with_line_key_and_remedy() {
    Protocol::parse(SMALL, "mine.toml", &library()).expect("is right as it is");
    let cases = [
        ("speed = 20", "speed = 40", 16, "speed = 40", "1 to 20"),
        ("trials = 1", "trials = 0", 15, "trials = 0", "1 to 50"),
        ("goal = \"study-2013\"", "goal = \"pink\"", 14, "goal = \"pink\"", "study-2013"),
        ("goal = \"study-2013\"", "goal = \"shrimp\"", 14, "does not fit the food", "study-2013"),
        ("recipe = \"medium\"", "recipe = \"soup\"", 13, "recipe = \"soup\"", "medium"),
        ("recipe = \"medium\"", "scenario = \"soup\"", 13, "scenario = \"soup\"", "first-steak"),
        ("recipe = \"medium\"\n", "", 12, "recipe and scenario", "recipe = "),
        ("id = \"B\"", "id = \"A\"", 8, "condition.id = \"A\" is there twice", "its own id"),
        ("id = \"small\"", "id = \"sm all\"", 1, "id = \"sm all\"", "letters"),
        ("answer = \"likert\"", "answer = \"text\"", 35, "personal data", "allow_free_text"),
        ("answer = \"likert\"", "answer = \"number\"", 35, "range", "range = ["),
        (
            "[phase.questionnaire]\n",
            "[phase.questionnaire]\ncolour = 1\n",
            32,
            "colour is no key",
            "there are: intro, item",
        ),
        ("information = \"hidden\"", "information = \"some\"", 9, "information = \"some\" is unknown", "shown"),
    ];
    for (from, to, line, message, remedy) in cases {
        let error = wrong(from, to);
        assert_eq!(error.file, "mine.toml");
        assert!(error.message.contains(message) && error.remedy.contains(remedy), "{to}: {error}");
        assert!(error.line.abs_diff(line) <= 1, "{to}: line {} of {line}: {error}", error.line);
    }
    assert!(Protocol::parse(" ", "mine.toml", &library()).expect_err("empty").message.contains("empty"));
}

#[test]
fn shipped_protocols_and_scenarios_are_right_and_bear_their_ids() {
    for (id, text) in shipped::SHIPPED {
        assert_eq!(Protocol::parse(text, id, &library()).expect("parses").id, id);
    }
    for (id, text) in saute_study::class::shipped::SHIPPED {
        let scenario = Scenario::parse(text, id, &library()).expect("parses");
        assert!(
            scenario.id == id && scenario.title.others.contains_key("ja") && scenario.intro.others.contains_key("ja"),
            "{id}"
        );
        assert!(
            scenario.predictions.iter().all(|predict| predict.text.en.is_empty() == predict.text.others.is_empty())
        );
    }
}

/// Sound shows how dry a face is: a study plays it only where its protocol states it, and that of 2013 had none.
#[test]
fn a_study_is_silent_unless_its_protocol_states_sound() {
    let library = library();
    let sounds = |text: &str| Protocol::parse(text, "small.toml", &library).expect("parses").sound;
    assert!(!sounds(SMALL) && !sounds(shipped::text("2013").expect("is shipped")));
    assert!(sounds(&format!("sound = true\n{SMALL}")));
}

#[test]
fn consecutive_participants_are_balanced_over_the_conditions_in_an_order_that_is_not_their_number() {
    let text = shipped::text("2013").expect("is shipped");
    let protocol = Protocol::parse(text, "2013", &library()).expect("parses");
    let of = |number: u32| format!("P{number:02}").parse::<Participant>().expect("a code").condition(&protocol);
    let conditions: Vec<usize> = (1..=40).map(of).collect();
    for count in 1..=40 {
        let in_a = conditions[..count].iter().filter(|condition| **condition == 0).count();
        assert!((2 * in_a).abs_diff(count) <= 2, "{in_a} of {count}");
    }
    assert!(conditions.chunks(2).all(|block| block[0] != block[1]), "each block holds both");
    assert!(conditions.chunks(2).any(|block| block[0] == 1) && conditions.chunks(2).any(|block| block[0] == 0));
    assert_eq!(conditions, (1..=40).map(of).collect::<Vec<_>>(), "the same each time");
}

#[test]
fn a_code_is_a_code_and_no_name() {
    for code in ["P07", "a", "team-3", "123456789012"] {
        assert!(code.parse::<Participant>().is_ok(), "{code}");
    }
    for code in ["", "-", "P 07", "Änne", "1234567890123", "../P07", "P07,x", "=P07"] {
        assert!(code.parse::<Participant>().is_err(), "{code}");
    }
}

#[test]
fn mistakes_in_a_scenario_are_named_with_line_key_and_remedy() {
    let text = saute_study::class::shipped::text("first-steak").expect("is shipped");
    for (from, to, message, remedy) in [
        ("food = \"beef-lean\"", "food = \"beef\"", "food = \"beef\"", "beef-lean"),
        ("goal = \"study-2013\"", "goal = \"crusty\"", "goal = \"crusty\"", "crust"),
        ("ask = \"core_in\"", "ask = \"core\"", "ask = \"core\" is unknown", "core_in"),
        ("in_s = 120", "in_s = 2", "in_s = 2", "5 to 1200"),
        ("after = \"put\"\n", "", "when", "at_s, core_c and after"),
        ("speed = 5", "speed = 0.5", "speed = 0.5", "1 to 20"),
    ] {
        assert!(text.contains(from), "{from}");
        let error = Scenario::parse(&text.replacen(from, to, 1), "mine.toml", &library()).expect_err(to);
        assert!(error.line > 1 && error.message.contains(message) && error.remedy.contains(remedy), "{error}");
    }
}
