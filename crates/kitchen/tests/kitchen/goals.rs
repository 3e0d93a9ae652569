//! Promise: goals are data that are checked like all others: what cannot be judged is refused with line and remedy.

use saute_kitchen::Library;

/// The error of a library whose goals differ from the shipped ones.
fn refused(from: &str, to: &str) -> String {
    let shipped = &Library::embedded_files()["goals.toml"];
    assert!(shipped.contains(from), "{from}");
    let own = [("goals.toml".to_owned(), shipped.replacen(from, to, 1))];
    Library::with(&own).expect_err("is refused").to_string()
}

#[test]
fn a_goal_that_cannot_be_judged_is_refused_with_its_line_and_what_there_is() {
    let cases = [
        ("least_share_pct = 40.0", "least_share_pct = 140.0", "least_share_pct"),
        ("kinetics = [\"beef\"]", "kinetics = [\"beef\", \"dumpling\"]", "\"dumpling\" is unknown"),
        ("scale = \"paper-2013\"", "scale = \"paper-1913\"", "paper-1913 has no class \"medium\""),
        ("class = \"medium\"\n", "class = \"pink\"\n", "paper-2013 has no class \"pink\""),
        ("counts = \"faces\"\n", "counts = \"section\"\n", "write class"),
        ("id = \"rare\"", "id = \"study-2013\"", "another goal \"study-2013\""),
        ("source = \"chosen: the core in its class", "sauce = \"chosen: the core in its class", "sauce"),
    ];
    for (from, to, words) in cases {
        let error = refused(from, to);
        assert!(error.starts_with("goals.toml:") && error.contains(words), "{error}");
    }
}

#[test]
fn every_shipped_food_has_a_goal_that_fits_it() {
    let library = Library::embedded().expect("embedded data");
    for (id, food) in &library.foods {
        assert!(library.goals_for(food).count() > 0, "{id}");
    }
    let beef = &library.foods["beef-lean"];
    assert!(library.goals_for(beef).any(|goal| goal.id == "study-2013"));
    assert!(library.goals_for(beef).all(|goal| goal.id != "shrimp"));
}
