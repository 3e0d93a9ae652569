//! `saute list`.

use std::process::ExitCode;
use std::sync::Arc;

use saute_controls::spoken::view_words::ViewWords;
use saute_kitchen::Library;
use saute_kitchen::data::goals::GoalDescription;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::food::{FoodDescription, Scale};
use saute_picture::View;
use saute_recipe::Recipe;
use saute_study::Protocol;
use saute_study::class::Scenario;
use saute_words::speech::Speech;
use serde::Serialize;

use super::list_actions;
use crate::args::{ListArgs, Listed};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::{json, stderr, stdout};
use crate::wording;

/// One line of a list.
#[derive(Debug, Serialize)]
struct ListRow {
    id: String,
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    size_mm: Option<Sizes>,
    #[serde(skip_serializing_if = "Option::is_none")]
    class: Option<Vec<ClassEntry>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    goal: Option<GoalEntry>,
}

impl ListRow {
    fn new(id: &str, name: &str) -> Self {
        Self { id: id.to_owned(), name: name.to_owned(), size_mm: None, class: None, source: None, goal: None }
    }
}

/// A class of a scale of doneness.
#[derive(Debug, Serialize)]
struct ClassEntry {
    name: String,
    /// Lower bound of the highest temperature; the first class has none [°C].
    #[serde(skip_serializing_if = "Option::is_none")]
    from_c: Option<f64>,
    /// Lower bound of the share of a change, instead [%].
    #[serde(skip_serializing_if = "Option::is_none")]
    from_pct: Option<f64>,
    /// The range as text.
    #[serde(skip)]
    range: String,
}

/// What a goal requires.
#[derive(Debug, Serialize)]
struct GoalEntry {
    kinetics: Vec<String>,
    /// Scale of its class; none if it applies to every one.
    scale: Option<String>,
    class: Option<String>,
    least_share_pct: f64,
    crust_pct: f64,
    most_charred_pct: f64,
}

impl GoalEntry {
    fn new(goal: &GoalDescription) -> Self {
        Self {
            kinetics: goal.kinetics.clone(),
            scale: goal.scale.clone(),
            class: goal.class.clone(),
            least_share_pct: goal.least_share_pct,
            crust_pct: goal.crust_pct,
            most_charred_pct: goal.most_charred_pct,
        }
    }

    fn text(&self) -> String {
        let what = match (&self.class, &self.scale) {
            (Some(class), Some(scale)) => format!("{class} on {scale}"),
            (Some(class), None) => class.clone(),
            (None, _) => "browned".to_owned(),
        };
        let (kinds, share, crust, charred) =
            (self.kinetics.join(", "), self.least_share_pct, self.crust_pct, self.most_charred_pct);
        format!(" ({kinds}: {share} % {what}, crust {crust} %, charred at most {charred} %)")
    }
}

/// Allowed lengths, widths and thicknesses of a food [mm].
#[derive(Debug, Serialize)]
struct Sizes {
    default: Vec<f64>,
    min: Vec<f64>,
    max: Vec<f64>,
}

/// Prints a list, for people or for programs.
pub fn run(args: &ListArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let entries = match args.what {
        Listed::Foods => foods(&data.library),
        Listed::Pans => pans(&data.library),
        Listed::Hobs => hobs(&data.library),
        Listed::Recipes => recipes(data)?,
        Listed::Scales => {
            data.scales(DEFAULT_SCALE)?;
            scales(&data.library)
        }
        Listed::Goals => goals(&data.library),
        Listed::Studies => studies(&data.library)?,
        Listed::Scenarios => scenarios(&data.library)?,
        Listed::Views => views(),
        Listed::Actions => return list_actions::run(args.json),
    };
    let text = if args.json { json::text(&entries)? } else { table(&entries) };
    stdout::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

fn foods(library: &Library) -> Vec<ListRow> {
    let sizes = |f: &FoodDescription| Sizes {
        default: f.size.default_mm.clone(),
        min: f.size.min_mm.clone(),
        max: f.size.max_mm.clone(),
    };
    library.foods.iter().map(|(id, f)| ListRow { size_mm: Some(sizes(f)), ..ListRow::new(id, &f.name) }).collect()
}

fn pans(library: &Library) -> Vec<ListRow> {
    library.pans.iter().map(|(id, p)| ListRow::new(id, &p.name)).collect()
}

fn hobs(library: &Library) -> Vec<ListRow> {
    library.hobs.iter().map(|(id, hob)| ListRow::new(id, &hob.name)).collect()
}

/// Lists the recipes. One that is broken, or needs a broken file, is named on stderr and left out.
fn recipes(data: &DataLibrary) -> Result<Vec<ListRow>, CliError> {
    let mut entries = Vec::new();
    for (id, text) in &data.library.recipes {
        match Recipe::parse(text, &data.recipe_place(id), &data.library) {
            Ok(recipe) => entries.push(ListRow::new(id, &recipe.title)),
            Err(error) if data.has_own_files() => stderr::say(format!("warning: {error}")),
            Err(error) => return Err(error.into()),
        }
    }
    Ok(entries)
}

fn studies(library: &Library) -> Result<Vec<ListRow>, CliError> {
    let entry = |(id, text): (&str, &str)| Ok(ListRow::new(id, &Protocol::parse(text, id, library)?.title));
    saute_study::shipped::SHIPPED.into_iter().map(entry).collect()
}

fn scenarios(library: &Library) -> Result<Vec<ListRow>, CliError> {
    let entry = |(id, text): (&str, &str)| Ok(ListRow::new(id, &Scenario::parse(text, id, library)?.title.en));
    saute_study::class::shipped::SHIPPED.into_iter().map(entry).collect()
}

fn scales(library: &Library) -> Vec<ListRow> {
    let class = |scale: &Scale, place: usize| ClassEntry {
        name: scale.class[place].name.clone(),
        from_c: scale.class[place].from_c,
        from_pct: scale.class[place].from_pct,
        range: wording::class_range(scale, place),
    };
    let entry = |scale: &Arc<Scale>| ListRow {
        class: Some((0..scale.class.len()).map(|place| class(scale, place)).collect()),
        source: Some(scale.source.clone()),
        ..ListRow::new(&scale.id, &scale.name)
    };
    library.scales.iter().map(entry).collect()
}

fn goals(library: &Library) -> Vec<ListRow> {
    let entry = |goal: &Arc<GoalDescription>| ListRow {
        goal: Some(GoalEntry::new(goal)),
        source: Some(goal.source.clone()),
        ..ListRow::new(&goal.id, &goal.name)
    };
    library.goals.iter().map(entry).collect()
}

fn views() -> Vec<ListRow> {
    View::ALL.into_iter().map(|view| ListRow::new(view.spec().id, &view.meaning(Speech::default()))).collect()
}

fn table(entries: &[ListRow]) -> String {
    let width = entries.iter().map(|e| e.id.chars().count()).max().unwrap_or(0);
    let more = |e: &ListRow| {
        e.size_mm.as_ref().map_or(String::new(), sizes)
            + &e.class.as_ref().map_or(String::new(), |c| classes(c))
            + &e.goal.as_ref().map_or(String::new(), GoalEntry::text)
    };
    entries.iter().map(|e| format!("{:width$}  {}{}\n", e.id, e.name, more(e))).collect()
}

fn classes(classes: &[ClassEntry]) -> String {
    let ranges: Vec<String> = classes.iter().map(|c| format!("{} {}", c.name, c.range)).collect();
    format!(" ({})", ranges.join(", "))
}

fn sizes(sizes: &Sizes) -> String {
    let ranges: Vec<String> = sizes.min.iter().zip(&sizes.max).map(|(low, high)| format!("{low}–{high}")).collect();
    format!(" ({} mm)", ranges.join(" × "))
}
