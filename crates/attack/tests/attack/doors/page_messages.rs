//! The door of a page's script: conditions as JSON. Its links are those of the sessions.

use saute_attack::doors::Range;
use saute_attack::kitchen_files::LIBRARY;
use saute_controls::pose::Pose;
use saute_kitchen::hands::ranges::MAX_S;
use saute_recipe::Recipe;

use super::{hostile, is_taken, names};

const RECIPE: &str = "[[step]]\nhob_w = 900\n[[step]]\nend = true\n";

#[test]
fn a_condition_that_no_cook_reaches_is_refused_with_its_range_before_anything_is_cooked() {
    let recipe = Recipe::parse(RECIPE, "pose.toml", &LIBRARY).expect("is sound");
    let range = Range::Within(0.0, MAX_S.default);
    for v in hostile(range) {
        let case = format!("page: at_s = {v}");
        // JSON has no words for numbers that are none.
        let read = serde_json::from_str::<Pose>(&format!("{{\"at_s\":{v:?}}}"));
        let refused = match read {
            Ok(pose) => pose.check(&recipe).err(),
            Err(error) => {
                assert!(!v.is_finite(), "{case}: {error}");
                continue;
            }
        };
        assert_eq!(Some(refused.is_none()), is_taken(range, v), "{case}: {refused:?}");
        refused.iter().for_each(|said| names(said, &["at_s"], range, &case));
    }
}

#[test]
fn a_condition_with_the_text_of_a_bad_recipe_is_refused_as_the_recipe_is() {
    let pose: Pose = serde_json::from_str(r#"{"recipe":"[[step]]\nhob_w = nan\n","at_s":1}"#).expect("is read");
    let refused = Recipe::parse(&pose.recipe, "pose.toml", &LIBRARY).expect_err("no power").to_string();
    assert!(refused.contains("pose.toml:2") && refused.contains("use 0 to 3500"), "{refused}");
}
