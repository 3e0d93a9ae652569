//! Checks a cook case file and parses its recipes.

use std::cmp::Ordering;

use saute_kitchen::data::library::Library;
use saute_recipe::recipe::Recipe;
use saute_schema::{InputError, InputText};
use toml::Spanned;

use crate::cook_case::file::CookCaseFile;
use crate::cook_case::sweep::{Sweep, TrendEntry};

/// A recipe with the label of its values in the sweep; empty without a sweep.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    pub label: String,
    pub recipe: Recipe,
}

/// Reads the file and checks it.
pub(super) fn checked(input: InputText) -> Result<CookCaseFile, InputError> {
    let raw: CookCaseFile = input.parse(
        "a cook case has name, source, evidence, recipe, [[expect]], [[seen]] and [[course]], or [sweep] and [[trend]]",
    )?;
    for band in &raw.expect {
        let b = band.get_ref();
        if b.compare.is_some() && raw.against.is_none() {
            let remedy = "add against = \"…\" with the second recipe, or leave compare out";
            return input.error(band.span().start, "compare needs a second recipe", remedy);
        }
        if b.low.partial_cmp(&b.high).is_none_or(Ordering::is_gt) {
            let message = format!("the band {} to {} is empty", b.low, b.high);
            return input.error(band.span().start, message, "write low = … and high = … with low below high");
        }
    }
    raw.trend.iter().try_for_each(|trend| check_trend(input, &raw, trend))?;
    check_sweep(input, &raw)?;
    Ok(raw)
}

fn check_trend(input: InputText, raw: &CookCaseFile, trend: &Spanned<TrendEntry>) -> Result<(), InputError> {
    let at = trend.span().start;
    if raw.sweep.is_none() {
        let remedy = "write [sweep] with replace = \"@hob_w@\" and values = [500, 1100]";
        return input.error(at, "a trend needs a sweep", remedy);
    }
    let is_slack = |slack: f64| slack.is_finite() && slack >= 0.0;
    match (trend.get_ref().slack, trend.get_ref().slack_pct) {
        (Some(slack), None) | (None, Some(slack)) if is_slack(slack) => Ok(()),
        _ => input.error(at, "a trend has one of slack and slack_pct, from 0", "write slack_pct = 1 or slack = 2"),
    }
}

fn check_sweep(input: InputText, raw: &CookCaseFile) -> Result<(), InputError> {
    for (name, sweep) in [("sweep", &raw.sweep), ("each", &raw.each)] {
        let Some(sweep) = sweep else { continue };
        let (at, own) = (sweep.span().start, sweep.get_ref());
        if own.replace.is_empty() || !raw.recipe.get_ref().contains(&own.replace) {
            let message = format!("{name}: the recipe does not contain replace = \"{}\"", own.replace);
            return input.error(at, message, format!("write {:?} into the recipe where the value stands", "@hob_w@"));
        }
        if own.values.len() < 2 {
            return input.error(at, format!("{name} has fewer than two values"), "write values = [500, 1100]");
        }
    }
    let Some(sweep) = &raw.sweep else {
        return match &raw.each {
            Some(each) => input.error(each.span().start, "each needs a sweep", "write [sweep], or [sweep] for [each]"),
            None => Ok(()),
        };
    };
    if raw.against.is_some() || !raw.seen.is_empty() || !raw.course.is_empty() {
        let remedy = "write them into a case of their own";
        return input.error(sweep.span().start, "a sweep has no against, [[seen]] and [[course]]", remedy);
    }
    if raw.trend.is_empty() && raw.expect.is_empty() {
        return input.error(sweep.span().start, "the sweep expects nothing", "write a [[trend]] or an [[expect]]");
    }
    Ok(())
}

/// Returns the recipes: for each value of `each`, those along the sweep.
pub(super) fn recipes(raw: &CookCaseFile, file: &str, library: &Library) -> Result<Vec<Vec<Variant>>, InputError> {
    let parse = |(label, text): (String, String)| {
        let name = if label.is_empty() { format!("{file}, recipe") } else { format!("{file}, recipe with {label}") };
        Ok(Variant { recipe: Recipe::parse(&text, &name, library)?, label })
    };
    let along = |(outer, text): (String, String)| {
        let inner = variants(raw.sweep.as_ref(), &text).into_iter();
        let labelled = inner.map(|(label, text)| {
            let parts = [outer.as_str(), label.as_str()];
            (parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", "), text)
        });
        labelled.map(parse).collect()
    };
    variants(raw.each.as_ref(), raw.recipe.get_ref()).into_iter().map(along).collect()
}

/// Returns the text for each value after its label; the text as it is without a sweep.
fn variants(sweep: Option<&Spanned<Sweep>>, text: &str) -> Vec<(String, String)> {
    sweep.map_or_else(|| vec![(String::new(), text.to_owned())], |sweep| sweep.get_ref().variants(text))
}
