//! Scales of doneness and their classes by name: a food's own words first, then those of the program.

use saute_kitchen::food::Scale;

use crate::language::Language;

/// Label of a scale.
pub fn label(scale: &Scale, l: Language) -> &str {
    l.named("scale", &scale.name, &scale.names)
}

/// Name of a class of a scale, given the class's name in its file.
pub fn class<'a>(scale: &'a Scale, name: &'a str, l: Language) -> &'a str {
    let class = scale.class.iter().find(|class| class.name == name);
    class.map_or_else(|| l.called("class", name), |class| l.named("class", name, &class.names))
}

#[cfg(test)]
mod tests {
    use saute_kitchen::advice::advise;
    use saute_kitchen::advice::coaching::Coaching;
    use saute_kitchen::doneness::fitting;
    use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
    use saute_kitchen::{Command, Kitchen, Library, PieceOrder, kelvin};

    use super::*;
    use crate::{piece_words, plan_words};

    /// A food with its own noun, its own words of doneness and a goal for its core.
    const TURKEY: &str = r#"
name = "Turkey breast"
kinetics = "beef"
form = "steak"

[words.en]
noun = "turkey"

[words.ja]
name = "鶏むね肉"
noun = "鶏むね"
piece = "一枚の鶏むね"

[doneness]
id = "turkey"
name = "Turkey"
names = { ja = "鶏肉" }
class = [
  { name = "raw", from_c = 0.0 },
  { name = "juicy", names = { ja = "しっとり" }, from_c = 65.0 },
  { name = "stringy", names = { ja = "ぱさぱさ" }, from_c = 78.0 },
]
for_change = "myosin"
goal = 68.0
source = "chosen: for this test"
confidence = "low"

"#;

    /// The shipped library with that food, whose flesh is that of a steak.
    fn library() -> Library {
        let steak = &Library::embedded_files()["foods/beef-lean.toml"];
        let flesh = &steak[steak.find("[size]").expect("a size")..];
        Library::with(&[("foods/turkey-breast.toml".to_owned(), format!("{TURKEY}{flesh}"))]).expect("is sound")
    }

    fn set_out(library: &Library, kind: &str) -> Kitchen {
        let food = &library.foods[kind];
        let order = PieceOrder {
            id: food.piece_id(kind),
            kind: kind.to_owned(),
            size: [0.08, 0.06, 0.02],
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 3.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Plain,
        };
        let mut kitchen = Kitchen::new(library, "carbon-steel-26", kelvin(20.0)).expect("a kitchen");
        kitchen.add(library, &order).expect("a piece");
        kitchen
    }

    #[test]
    fn a_food_is_spoken_of_in_the_words_of_its_own_file() {
        let library = library();
        let [en, ja] = ["en", "ja"].map(|code| Language::of_code(code).expect("is known"));
        let food = &library.foods["turkey-breast"];
        assert_eq!([en, ja].map(|l| food.name_in(l.code())), ["Turkey breast", "鶏むね肉"]);
        assert_eq!([en, ja].map(|l| food.noun_in(l.code())), ["turkey", "鶏むね"]);
        let kitchen = set_out(&library, "turkey-breast");
        let piece = &kitchen.pieces()[0];
        assert_eq!(piece.id, "turkey");
        assert_eq!([en, ja].map(|l| piece_words::name(&piece.id, &library, l)), ["turkey", "一枚の鶏むね"]);
        let fits = fitting(&library.scales, &piece.model);
        assert_eq!(fits.iter().map(|scale| scale.id.as_str()).collect::<Vec<_>>(), ["turkey"]);
        let scale: &Scale = fits[0];
        assert_eq!([en, ja].map(|l| label(scale, l)), ["Turkey", "鶏肉"]);
        assert_eq!([en, ja].map(|l| class(scale, "juicy", l)), ["juicy", "しっとり"]);
        assert_eq!([en, ja].map(|l| piece_words::doneness(Some(scale), piece, l)), ["raw", "生"], "our own word");
        let wish = "stringy".parse().expect("a wish");
        let goal = saute_plan::goal::Goal::new(&wish, scale, 0.0).expect("a goal");
        let speech = |language| crate::speech::Speech { language, ..Default::default() };
        assert_eq!([en, ja].map(|l| plan_words::target(&goal, speech(l))), ["stringy", "ぱさぱさ"]);
    }

    #[test]
    fn the_coach_speaks_of_a_food_of_files_alone_in_every_language() {
        let library = library();
        let mut kitchen = set_out(&library, "turkey-breast");
        for command in [Command::Hob(900.0), Command::Put { food: "turkey".into(), at: [0.0; 2], heap: false }] {
            kitchen.apply(&command).expect("is done");
        }
        (0..600).for_each(|_| kitchen.step());
        let piece = &kitchen.pieces()[0];
        let advice = advise(&kitchen, piece, None);
        let coaching = Coaching::of(&kitchen, piece, &advice).expect("something happens");
        let said = ["en", "ja"].map(|code| {
            let language = Language::of_code(code).expect("is known");
            crate::coach_words::happening(&coaching, crate::speech::Speech { language, ..Default::default() })
        });
        assert!(said.iter().all(|words| !words.is_empty()) && said[0] != said[1], "{said:?}");
    }

    #[test]
    fn the_words_of_one_food_are_no_others() {
        let library = library();
        for kind in ["beef-lean", "beef-marbled"] {
            let kitchen = set_out(&library, kind);
            let fits = fitting(&library.scales, &kitchen.pieces()[0].model);
            assert_eq!(fits.iter().map(|s| s.id.as_str()).collect::<Vec<_>>(), ["paper-2013", "chefs", "academic"]);
        }
    }
}
