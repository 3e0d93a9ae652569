//! What a person saves of a cook as a file.

use std::collections::BTreeSet;

use saute_recipe::session::session_file::ENDING;
use saute_recipe::session::{Deed, Entry, ToRecipe, ToRecipeError, Told};
use saute_words::language::Language;

use crate::Session;
use crate::hands::Hands;

/// Columns of each food after its id and a dot: temperatures [°C] and mass [g].
const FOOD_COLUMNS: [&str; 4] = ["core_c", "top_c", "bottom_c", "mass_g"];

/// A file that is made of a cook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The session: it can be gone on with.
    Cook,
    /// What was done as the steps of a recipe.
    Recipe,
    /// Temperatures and masses as a table.
    Readings,
}

/// Why there is nothing to save.
#[derive(Clone, Debug, thiserror::Error)]
#[error(transparent)]
pub struct NoRecipe(#[from] saute_recipe::session::ToRecipeError);

impl Export {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Cook, Self::Recipe, Self::Readings];

    /// How the name of its file ends.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Cook => ENDING,
            Self::Recipe => "toml",
            Self::Readings => "csv",
        }
    }

    /// A name for its file.
    pub fn file_name(self, l: Language) -> String {
        let name = if self == Self::Recipe { "pantry.recipe_file" } else { "pantry.cook_file" };
        format!("{}.{}", l.text(name), self.ending())
    }

    /// Its type, as browsers call it.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Cook => "application/octet-stream",
            Self::Recipe => "application/toml",
            Self::Readings => "text/csv",
        }
    }

    /// Key of the words on its button.
    pub fn words(self) -> &'static str {
        match self {
            Self::Cook => "pantry.save_cook",
            Self::Recipe => "pantry.save_recipe",
            Self::Readings => "pantry.save_readings",
        }
    }
}

impl<H: Hands> Session<H> {
    /// The file of the cook that is shown, and true if it leaves something out; a session contains what is ahead of the shown
    /// instant, too.
    ///
    /// # Errors
    ///
    /// If what was done breaks a rule of recipes.
    pub fn exported(&self, what: Export) -> Result<(Vec<u8>, bool), NoRecipe> {
        Ok(match what {
            Export::Cook => (self.whole_recording().to_file(), false),
            Export::Recipe => {
                let made = self.as_recipe_file()?;
                (made.text.into_bytes(), !made.left_out.is_empty())
            }
            Export::Readings => (self.readings().into_bytes(), false),
        })
    }

    /// What was done up to the shown instant, as a recipe: steps of a recipe that played, then those of hands, at their times.
    fn as_recipe_file(&self) -> Result<ToRecipe, ToRecipeError> {
        let played = self.marks.iter().map(|mark| (mark.time_s, mark.step.clone()));
        let by_hand = self.recording().entries().iter().filter_map(Entry::as_step);
        let mut steps: Vec<(f64, String)> = played.chain(by_hand.map(|step| (step.time_s, step.as_text()))).collect();
        steps.sort_by(|a, b| a.0.total_cmp(&b.0));
        let recipe = self.recording().beginning().recipe(&self.library)?;
        let told = Told {
            recording: self.recording(),
            begun: &recipe,
            steps: steps.into_iter().map(|(_, step)| step).collect(),
            end_s: self.shown_s(),
        };
        told.to_recipe(&self.library)
    }

    /// A row each second; a food that was not there yet, or no longer, leaves its columns empty.
    fn readings(&self) -> String {
        let lists = self.piece_lists();
        let all: Vec<&String> = lists.iter().flat_map(|(_, ids)| ids).collect::<BTreeSet<_>>().into_iter().collect();
        let columns = all.iter().flat_map(|id| FOOD_COLUMNS.map(|column| format!("{id}.{column}")));
        let head = ["time_s", "hob_drawn_w", "pan_c"].map(str::to_owned).into_iter().chain(columns);
        let lines = self.recorder.rows.iter().map(|row| {
            let fits = |(at_s, ids): &&(f64, Vec<String>)| *at_s <= row.time_s && ids.len() == row.foods.len();
            let ids = lists.iter().rev().find(fits).map_or(&[][..], |(_, ids)| ids);
            let own = [format!("{:.1}", row.time_s), format!("{:.0}", row.hob_drawn_w), format!("{:.3}", row.pan_c)];
            let food = |id: &&String| ids.iter().position(|there| there == *id).map(|place| row.foods[place]);
            let cells = |food: Option<[f64; 4]>| food.map_or_else(Default::default, |of| of.map(|v| format!("{v:.3}")));
            own.into_iter().chain(all.iter().map(food).flat_map(cells)).collect::<Vec<_>>().join(",")
        });
        let mut text = std::iter::once(head.collect::<Vec<_>>().join(",")).chain(lines).collect::<Vec<_>>().join("\n");
        text.push('\n');
        text
    }

    /// The pieces in their order, from each time on at which they changed [s].
    fn piece_lists(&self) -> Vec<(f64, Vec<String>)> {
        let recipe = self.recording().beginning().recipe(&self.library);
        let mut ids: Vec<String> =
            recipe.map(|r| r.foods.iter().map(|food| food.id.clone()).collect()).unwrap_or_default();
        let mut lists = vec![(0.0, ids.clone())];
        for entry in self.recording().entries() {
            match &entry.deed {
                Deed::Add(order) => ids.push(order.id.clone()),
                Deed::Remove(gone) => ids.retain(|id| id != gone),
                _ => continue,
            }
            lists.push((entry.time_s(), ids.clone()));
        }
        lists
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use saute_kitchen::{Command, Library};
    use saute_recipe::Recipe;

    use super::*;

    /// What a hand did, and what a recipe did before it took over, is in the recipe that is saved, at its time.
    #[test]
    fn a_cook_is_saved_as_a_recipe_that_does_the_same() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session: Session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
        let text = "[[step]]\nhob_w = 1100\n[[step]]\nafter_s = 3\noil_g = 4\n[[step]]\nafter_s = 60\nend = true\n";
        session.play(Recipe::parse(text, "own.toml", &library).expect("parses")).expect("plays");
        let tick = |session: &mut Session, s: usize| (0..10 * s).for_each(|_| session.tick().expect("ticks"));
        tick(&mut session, 5);
        let own = session.exported(Export::Recipe).expect("a recipe");
        assert_eq!(own, (text.as_bytes().to_vec(), false), "nobody interfered");
        session.command(&Command::Hob(700.0)).expect("hob");
        tick(&mut session, 2);
        session.command(&Command::HoldPan { pose: saute_kitchen::dynamics::Pose::at(0.0, 0.0, 0.1) }).expect("held");
        tick(&mut session, 1);
        let (bytes, leaves_out) = session.exported(Export::Recipe).expect("a recipe");
        assert!(leaves_out, "the hand on the pan");
        let text = String::from_utf8(bytes).expect("text");
        let again = Recipe::parse(&text, "again.toml", &library).expect("parses");
        let words: Vec<String> = again.steps.iter().map(|step| step.action.name().to_owned()).collect();
        assert_eq!(words, ["hob_w", "oil_g", "hob_w", "end"], "{text}");
        session.play(again).expect("plays");
        tick(&mut session, 9);
        assert_eq!(session.kitchen.hob_w(), 700.0);
    }

    #[test]
    fn readings_keep_each_food_in_its_own_columns() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session: Session = Session::new(library, &Default::default()).expect("sets out");
        let tick = |session: &mut Session, s: usize| (0..10 * s).for_each(|_| session.tick().expect("ticks"));
        tick(&mut session, 2);
        let group = session.add(&Default::default(), 1).expect("adds");
        tick(&mut session, 2);
        session.remove(&["steak".to_owned()]);
        tick(&mut session, 2);
        let text = String::from_utf8(session.exported(Export::Readings).expect("readings").0).expect("text");
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(
            rows[0][3..],
            ["steak.core_c", "steak.top_c", "steak.bottom_c", "steak.mass_g"]
                .into_iter()
                .map(str::to_owned)
                .chain(FOOD_COLUMNS.map(|c| format!("{group}.{c}")))
                .collect::<Vec<_>>()[..]
        );
        assert!(rows.iter().all(|row| row.len() == 11), "{text}");
        let (first, last) = (&rows[1], &rows[rows.len() - 1]);
        assert!(first[3] == "5.000" && first[7].is_empty(), "{text}");
        assert!(last[3].is_empty() && last[7] == "5.000", "{text}");
        assert_eq!(last[0], "6.0");
    }
}
