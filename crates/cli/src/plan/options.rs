//! The options of `saute plan`, and the order that they make.

use std::path::PathBuf;

use saute_kitchen::Library;
use saute_kitchen::advice::usual_powers_w;
use saute_kitchen::doneness::fitting;
use saute_kitchen::food::{FoodDescription, FoodModel, Scale};
use saute_plan::goal::{Goal, Wish};
use saute_plan::schedule::{JobError, Order, PLAIN_FLIPS};

use crate::error::CliError;
use crate::input::data_library::DataLibrary;

/// `saute plan`.
#[derive(Debug, clap::Args)]
pub struct PlanArgs {
    /// Food, see `saute list foods`.
    #[arg(long, value_name = "FOOD")]
    pub food: String,
    /// Its dimensions [mm]: length, width, thickness of a steak; diameter, thickness of a disc [default: the food's own].
    #[arg(long, value_name = "MM", value_delimiter = ',')]
    pub size_mm: Vec<f64>,
    /// Temperature at which it goes into the pan [°C].
    #[arg(long, value_name = "C", default_value_t = 5.0, allow_negative_numbers = true)]
    pub initial_c: f64,
    /// Number of pieces [default: one].
    #[arg(long, value_name = "N")]
    pub count: Option<u32>,
    /// Hob, see `saute list hobs` [default: that of the kitchen at home].
    #[arg(long, value_name = "HOB")]
    pub hob_kind: Option<String>,
    /// Pan, see `saute list pans`.
    #[arg(long, value_name = "PAN", default_value = "carbon-steel-26")]
    pub pan: String,
    /// Target: a class of the scale of doneness (medium), or a temperature of the core (core=54).
    #[arg(long, value_name = "CLASS|core=C")]
    pub target: String,
    /// Scale of doneness of the target, see `saute list scales` [default: chefs, or the food's own].
    #[arg(long, value_name = "SCALE")]
    pub scale: Option<String>,
    /// Share of each face that is to be browned [%] [default: 60 for steaks and patties, else 0].
    #[arg(long, value_name = "PCT")]
    pub crust_pct: Option<f64>,
    /// Largest number of flips [default: 12; of a plain plan 3].
    #[arg(long, value_name = "N")]
    pub max_flips: Option<usize>,
    /// A plan that is easily followed: one power to heat the pan and one to fry.
    #[arg(long)]
    pub plain: bool,
    /// Powers that the hob has [W] [default: those of its dial, and the one at which the coach fries].
    #[arg(long, value_name = "W,W,…", value_delimiter = ',')]
    pub hob: Vec<f64>,
    /// Recipe file to write, for `saute cook`.
    #[arg(long, value_name = "RECIPE.toml")]
    pub out: Option<PathBuf>,
    /// Page for the kitchen wall to write, ready to print: times, and what to look, listen and feel for.
    #[arg(long, value_name = "CARD.html")]
    pub card: Option<PathBuf>,
    /// Prints the plan as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The scale of flesh that several scales apply to, unless another is named.
const USUAL_SCALE: &str = "chefs";
/// Flips at most unless another number is given [-] (chosen: more hardly raise the share).
const USUAL_FLIPS: usize = 12;
/// Largest number of flips of a plan [-] (chosen: one every 20 s of a long cook).
const MOST_FLIPS: usize = 60;
/// Largest number of powers [-] (chosen: as many as a hob has levels).
const MOST_POWERS: usize = 20;

/// Returns the order of the options.
pub fn order(args: &PlanArgs, data: &DataLibrary) -> Result<Order, CliError> {
    let library = &data.library;
    let food = food(&args.food, library)?;
    let size_mm = if args.size_mm.is_empty() { food.size.default_mm.clone() } else { args.size_mm.clone() };
    if !library.pans.contains_key(&args.pan) {
        let remedy = format!("use one of: {}", Library::names(&library.pans));
        return Err(wrong(format!("--pan {}", args.pan), library.absence("pans", &args.pan, "is not a pan"), remedy));
    }
    let crust_pct = args.crust_pct.unwrap_or_else(|| food.crust_pct());
    ranged("--crust-pct", crust_pct, [0.0, 100.0], "%")?;
    let most_flips =
        args.max_flips.unwrap_or_else(|| food.most_flips(if args.plain { PLAIN_FLIPS } else { USUAL_FLIPS }));
    ranged("--max-flips", most_flips as f64, [0.0, MOST_FLIPS as f64], "flips")?;
    let wish: Wish = args.target.parse().map_err(|error| of_target(args, &error))?;
    let mut order = Order {
        food: args.food.clone(),
        size_mm,
        initial_c: args.initial_c,
        count: args.count,
        hob: args.hob_kind.clone(),
        pan: args.pan.clone(),
        hob_w: powers(args, library)?,
        most_flips,
        most_rest_s: food.most_rest_s(),
        pan_c: food.plan_pan_c(),
        plain: args.plain,
        // Replaced below: only a food that was built states which scales fit it.
        goal: Goal::new(&Wish::Core(60.0), &Scale::clone(&library.scales[0]), crust_pct)
            .map_err(|e| of_target(args, &e))?,
    };
    let model = order.check(library, 1.0).map_err(|error| of_job(error, args))?;
    order.goal = Goal::new(&wish, scale(args, &model, data)?, crust_pct).map_err(|error| of_target(args, &error))?;
    Ok(order)
}

fn food<'a>(id: &str, library: &'a Library) -> Result<&'a FoodDescription, CliError> {
    library.foods.get(id).ok_or_else(|| {
        let remedy = format!("use one of: {}", Library::names(&library.foods));
        wrong(format!("--food {id}"), library.absence("foods", id, "is not a food"), remedy)
    })
}

/// Returns the powers of the hob, ascending, without 0.
fn powers(args: &PlanArgs, library: &Library) -> Result<Vec<f64>, CliError> {
    let given = if args.hob.is_empty() { usual_powers_w(&library.hob) } else { args.hob.clone() };
    for power in &given {
        ranged("--hob", *power, [0.0, library.hob.largest_w()], "W")?;
    }
    let mut powers: Vec<f64> = given.iter().copied().filter(|w| *w > 0.0).collect();
    powers.sort_by(f64::total_cmp);
    powers.dedup();
    if powers.is_empty() || powers.len() > MOST_POWERS {
        let message = format!("{} powers above 0 W", powers.len());
        return Err(wrong("--hob", message, format!("write 1 to {MOST_POWERS} powers, as in --hob 400,1100,2000")));
    }
    Ok(powers)
}

/// Returns the scale of the target: the named one, else that of chefs where it fits the food, else the first that does.
fn scale<'a>(args: &PlanArgs, model: &FoodModel, data: &'a DataLibrary) -> Result<&'a Scale, CliError> {
    let fitting = fitting(&data.library.scales, model);
    let by_id = |id: &str| fitting.iter().find(|scale| scale.id == id).copied();
    if let Some(id) = &args.scale {
        let known: Vec<&str> = fitting.iter().map(|scale| scale.id.as_str()).collect();
        return by_id(id).map(AsRef::as_ref).ok_or_else(|| {
            let is_known = data.library.scale(id).is_some();
            let message = if is_known { format!("does not fit {}", args.food) } else { "is not a scale".to_owned() };
            wrong(format!("--scale {id}"), message, format!("use one of: {}", known.join(", ")))
        });
    }
    by_id(USUAL_SCALE).or(fitting.first().copied()).map(AsRef::as_ref).ok_or_else(|| {
        let remedy = "write a temperature of the core, as in --target core=60".to_owned();
        wrong(format!("--target {}", args.target), format!("no scale of doneness fits {}", args.food), remedy)
    })
}

fn ranged(option: &str, value: f64, [low, high]: [f64; 2], unit: &str) -> Result<(), CliError> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(wrong(format!("{option} {value}"), "is out of range", format!("write {low} to {high} {unit}")))
}

fn of_target(args: &PlanArgs, error: &saute_plan::goal::TargetError) -> CliError {
    let remedy = "write a class of the scale (saute list scales), or a temperature of the core, as in core=54";
    wrong(format!("--target {}", args.target), error.to_string(), remedy)
}

/// Returns the error of an order that makes no recipe, with the option that is at fault.
pub fn of_job(error: JobError, args: &PlanArgs) -> CliError {
    let JobError::Input(input) = error else { return CliError::place("saute plan", error.to_string(), OTHER_SIZE) };
    let sizes: Vec<String> = args.size_mm.iter().map(f64::to_string).collect();
    let count = || args.count.map_or(String::new(), |count| count.to_string());
    let start = |key: &str| input.message.starts_with(key);
    match () {
        () if start("size_mm") => {
            let remedy = input.remedy.replace("size_mm = ", "--size-mm ").replace(['[', ']'], "");
            wrong(format!("--size-mm {}", sizes.join(",")), input.message, remedy)
        }
        () if start("food.initial_c") => wrong(format!("--initial-c {}", args.initial_c), input.message, input.remedy),
        () if start("count") => wrong(format!("--count {}", count()), input.message, input.remedy),
        () if start("not all of") => {
            wrong(format!("--count {}", count()), input.message, "choose fewer or smaller pieces")
        }
        () => CliError::Input(input),
    }
}

const OTHER_SIZE: &str = "choose another size or kind of food or pan: saute list foods, saute list pans";

fn wrong(option: impl std::fmt::Display, message: impl Into<String>, remedy: impl Into<String>) -> CliError {
    CliError::place(option, message, remedy)
}
