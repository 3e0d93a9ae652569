//! What a person enters about a cook at home: a log with its columns, rows by hand, and what was cooked.

use saute_kitchen::Library;
use saute_kitchen::food::ZERO_C;
use saute_plan::fit::log::log_error::LogError;
use saute_plan::fit::observed::{END, Observed, Quantity};
use saute_recipe::Recipe;
use saute_schema::InputError;

use super::open_log::OpenLog;

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// Temperature of the pan.
    Pan,
    /// Temperature of the core.
    Core,
    /// Weight of the food [g].
    Weight,
    /// Class of the core on the cut, at the end.
    Class,
}

impl Seen {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Pan, Self::Core, Self::Weight, Self::Class];

    /// Key of its name.
    pub fn words(self) -> &'static str {
        match self {
            Self::Pan => "athome.pan",
            Self::Core => "athome.core",
            Self::Weight => "athome.weight",
            Self::Class => "athome.class",
        }
    }
}

/// One value by hand, as it was typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is about.
    pub seen: Seen,
    /// Time since the hob was switched on: `90` or `1:30`; the end if it is empty.
    pub time: String,
    /// The value: a temperature, a weight, or a class.
    pub value: String,
}

/// What was cooked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cooked {
    /// What was done in the window.
    #[default]
    Shown,
    /// The plan.
    Plan,
    /// A recipe from a file.
    File,
}

impl Cooked {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Shown, Self::Plan, Self::File];

    /// Key of its name.
    pub fn words(self) -> &'static str {
        match self {
            Self::Shown => "athome.cooked_shown",
            Self::Plan => "athome.cooked_plan",
            Self::File => "athome.cooked_file",
        }
    }
}

/// Everything that was entered.
#[derive(Debug, Default)]
pub struct Entered {
    /// The log.
    pub log: Option<OpenLog>,
    /// Values by hand.
    pub rows: Vec<Row>,
    /// What was cooked.
    pub cooked: Cooked,
    /// A recipe from a file, with its name.
    pub recipe: Option<(String, String)>,
}

/// What of it cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EnteredError {
    /// The log cannot be read.
    #[error(transparent)]
    Log(#[from] LogError),
    /// A row means nothing: its number from 1.
    #[error("{0}")]
    Row(usize),
    /// There is no recipe of that kind.
    #[error("no recipe")]
    NoRecipe,
    /// The recipe cannot be read.
    #[error(transparent)]
    Recipe(#[from] InputError),
}

impl Entered {
    /// Takes a log.
    ///
    /// # Errors
    ///
    /// If it is no table.
    pub fn take_log(&mut self, name: &str, bytes: &[u8]) -> Result<(), LogError> {
        self.log = Some(OpenLog::open(name, bytes)?);
        Ok(())
    }

    /// Returns what was observed in a recipe's cook; temperatures by hand are in °F if `fahrenheit` is true.
    ///
    /// # Errors
    ///
    /// If the log or a row cannot be read.
    pub fn observed(
        &mut self,
        recipe: &Recipe,
        library: &Library,
        scale: &str,
        fahrenheit: bool,
    ) -> Result<Observed, EnteredError> {
        let mut observed = Observed::default();
        if let Some(log) = &mut self.log {
            log.add(recipe, &mut observed)?;
        }
        let mut curves = [(Quantity::Pan, Vec::new()), (Quantity::Core, Vec::new())];
        for (at, row) in self.rows.iter().enumerate() {
            let wrong = || EnteredError::Row(at + 1);
            let at_s = time_of(&row.time).ok_or_else(wrong)?;
            match row.seen {
                Seen::Pan | Seen::Core => {
                    let kelvin = kelvin_of(&row.value, fahrenheit).filter(|_| at_s != END).ok_or_else(wrong)?;
                    curves[usize::from(row.seen == Seen::Core)].1.push((at_s, kelvin));
                }
                Seen::Weight => observed.add_weight(at_s, 1e-3 * grams_of(&row.value).ok_or_else(wrong)?),
                Seen::Class => {
                    let known = library.scale(scale).is_some_and(|scale| observed.add_class(at_s, scale, &row.value));
                    known.then_some(()).ok_or_else(wrong)?;
                }
            }
        }
        curves.iter().filter(|(_, curve)| !curve.is_empty()).for_each(|(q, curve)| observed.add_curve(*q, curve));
        Ok(observed)
    }

    /// Returns the recipe of what was cooked, given what the window shows and the plan.
    ///
    /// # Errors
    ///
    /// If there is none of that kind, or it cannot be read.
    pub fn recipe(
        &self,
        library: &Library,
        shown: Option<String>,
        plan: Option<String>,
    ) -> Result<Recipe, EnteredError> {
        let (name, text) = match self.cooked {
            Cooked::Shown => ("cook".to_owned(), shown),
            Cooked::Plan => ("plan".to_owned(), plan),
            Cooked::File => {
                let (name, text) = self.recipe.clone().ok_or(EnteredError::NoRecipe)?;
                (name, Some(text))
            }
        };
        Ok(Recipe::parse(&text.ok_or(EnteredError::NoRecipe)?, &name, library)?)
    }
}

/// A time as it is typed [s]: `90`, `1:30`; the end if nothing is.
fn time_of(text: &str) -> Option<f64> {
    let text = text.trim();
    if text.is_empty() {
        return Some(END);
    }
    let number = |part: &str| part.trim().replace(',', ".").parse::<f64>().ok().filter(|n| (0.0..1e5).contains(n));
    match text.split_once(':') {
        Some((minutes, seconds)) => Some(60.0 * number(minutes)? + number(seconds).filter(|s| *s < 60.0)?),
        None => number(text),
    }
}

/// A temperature as it is typed [K].
fn kelvin_of(text: &str, fahrenheit: bool) -> Option<f64> {
    let number: f64 = text.trim().trim_end_matches(['°', 'C', 'F', ' ']).replace(',', ".").parse().ok()?;
    let celsius = if fahrenheit { (number - 32.0) / 1.8 } else { number };
    (-40.0..800.0).contains(&celsius).then_some(celsius + ZERO_C)
}

/// A weight as it is typed [g].
fn grams_of(text: &str) -> Option<f64> {
    let number = text.trim().trim_end_matches(['g', ' ']).replace(',', ".").parse().ok()?;
    (1.0..=1e4).contains(&number).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::super::open_log::Columns;
    use super::*;
    use saute_plan::fit::log::reading::{Choices, Pick};
    use saute_plan::fit::log::unit::Unit;

    const RECIPE: &str = "[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [40, 30, 14]\ninitial_c = 5\n[[step]]\nat_s = 5\n\
                          put = \"steak\"\n[[step]]\nat_s = 60\nend = true\n";

    fn row(seen: Seen, time: &str, value: &str) -> Row {
        Row { seen, time: time.into(), value: value.into() }
    }

    fn kitchen() -> (Library, Recipe) {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(RECIPE, "steak.toml", &library).expect("a recipe");
        (library, recipe)
    }

    #[test]
    fn rows_are_read_as_people_type_them_and_a_wrong_one_is_named() {
        let (library, recipe) = kitchen();
        let rows = vec![
            row(Seen::Core, "5:00", "30,5"),
            row(Seen::Pan, "90", "210 °C"),
            row(Seen::Weight, "", "180 g"),
            row(Seen::Class, "", "medium"),
        ];
        let mut entered = Entered { rows, ..Entered::default() };
        let samples = entered.observed(&recipe, &library, "chefs", false).expect("is read").samples();
        let read: Vec<(Quantity, f64)> = samples.iter().map(|s| (s.quantity, s.at_s)).collect();
        assert_eq!(read[..2], [(Quantity::Pan, 90.0), (Quantity::Core, 300.0)]);
        assert!((samples[1].value - 303.65).abs() < 1e-9 && samples.len() == 4);
        let fahrenheit = entered.observed(&recipe, &library, "chefs", true).expect("is read").samples();
        assert!(fahrenheit[1].value < 275.0, "30.5 °F is about freezing");
        for wrong in [row(Seen::Core, "", "30"), row(Seen::Pan, "1:75", "30"), row(Seen::Class, "", "blue")] {
            entered.rows[1] = wrong.clone();
            let refused = entered.observed(&recipe, &library, "chefs", false);
            assert_eq!(refused, Err(EnteredError::Row(2)), "{wrong:?}");
        }
    }

    #[test]
    fn a_log_is_compared_from_the_put_on_as_it_reads_and_as_is_chosen() {
        let (library, recipe) = kitchen();
        let mut entered = Entered::default();
        entered.take_log("log.csv", b"Time,Probe (\xc2\xb0F),Other\n0:00,70,400\n1:10,41,410\n").expect("a table");
        let observed = |entered: &mut Entered| {
            let samples = entered.observed(&recipe, &library, "chefs", false).expect("is read").samples();
            samples.iter().map(|s| (s.quantity, s.at_s, s.value)).collect::<Vec<_>>()
        };
        assert_eq!(observed(&mut entered), [(Quantity::Core, 70.0, 278.15)], "before the put the probe is in the air");
        let choices = Choices { pan: Pick::Column(2), core: Pick::No, unit: Some(Unit::Celsius), ..Choices::default() };
        entered.log.as_mut().expect("a log").choose(Columns { choices, shift_s: -5.0 });
        assert_eq!(
            observed(&mut entered),
            [(Quantity::Pan, 65.0, 410.0 + ZERO_C)],
            "what was before the cook is left out"
        );
        assert!(entered.take_log("empty.csv", b"").is_err());
    }
}
