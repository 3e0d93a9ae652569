//! A specification joined with the texts that it varies: its values with their places, its design, its size.

use std::collections::BTreeSet;

use saute_schema::{InputError, InputText};

use crate::design::{Design, DesignKind};
use crate::documents::Documents;
use crate::manifest::{MOST_ROWS, PART_ROWS};
use crate::place::Place;
use crate::spec::spec_file::SpecFile;
use crate::spec::varied::Levels;

/// Fewest and most rows of a part unless the file states it [-] (chosen: a killed program loses little, and a folder has few files).
const PART: [u64; 2] = [16, 4096];
/// Parts of a sweep of middle size [-] (chosen as above).
const PARTS: u64 = 64;
/// A value that varies.
#[derive(Clone, Debug)]
pub(crate) struct Factor {
    pub(crate) path: String,
    pub(crate) place: Place,
    pub(crate) levels: Levels,
}

/// Returns the varied values in the order of the file.
pub(crate) fn factors(input: InputText, spec: &SpecFile, documents: &Documents) -> Result<Vec<Factor>, InputError> {
    let mut entries: Vec<_> = spec.vary.iter().collect();
    entries.sort_by_key(|(path, _)| path.span().start);
    let kind = spec.design.get_ref().kind;
    let mut factors = Vec::new();
    let mut places = BTreeSet::new();
    for (key, value) in entries {
        let (path, at) = (key.get_ref(), key.span().start);
        let levels = Levels::read(input, at, path, value.get_ref(), kind)?;
        let place = Place::find(path, documents).or_else(|(message, remedy)| input.error(at, message, remedy))?;
        if !places.insert((place.document.clone(), format!("{:?}", place.steps))) {
            return input.error(at, format!("\"{path}\" varies twice"), "leave one of the lines out");
        }
        factors.push(Factor { path: path.clone(), place, levels });
    }
    if factors.is_empty() {
        let remedy = "write a line such as \"pan.initial_c\" = [20, 40] under [vary]";
        return input.error(spec.design.span().start, "nothing varies: [vary] is empty", remedy);
    }
    Ok(factors)
}

/// Returns the design of the rows.
pub(crate) fn design(input: InputText, spec: &SpecFile, factors: &[Factor]) -> Result<Design, InputError> {
    let (entry, at) = (spec.design.get_ref(), spec.design.span().start);
    let n = match (&entry.n, entry.kind) {
        (None, DesignKind::Grid) => 0,
        (Some(n), DesignKind::Grid) => {
            let remedy = "leave n out: a grid has every combination of the levels";
            return input.error(n.span().start, "n is no key of a grid", remedy);
        }
        (Some(n), _) if *n.get_ref() >= 1 => n.get_ref().unsigned_abs(),
        (Some(n), _) => {
            let message = format!("n = {} is out of range", n.get_ref());
            return input.error(n.span().start, message, "write a whole number of 1 or more");
        }
        (None, _) => return input.error(at, "[design] has no n", "write, for instance, n = 64"),
    };
    let levels = factors.iter().map(|f| f.levels.count()).collect();
    let design = Design { kind: entry.kind, n, seed: u64::from(entry.seed.unwrap_or(1)), levels };
    if !design.has_dimensions() {
        let message = format!("{} values vary, for which a Sobol' sequence has too few dimensions", factors.len());
        let remedy = "vary fewer, or use kind = \"morris\" or \"latin-hypercube\"";
        return input.error(at, message, remedy);
    }
    Ok(design)
}

/// Returns the number of rows and of rows in a part.
pub(crate) fn size(input: InputText, spec: &SpecFile, design: &Design) -> Result<[u64; 2], InputError> {
    let Some(rows) = design.rows().filter(|rows| *rows <= MOST_ROWS) else {
        let message = format!("the design has more than {MOST_ROWS} rows");
        let n = spec.design.get_ref().n.as_ref();
        let remedy = if n.is_some() { "write a smaller n" } else { "vary fewer values, or fewer levels of them" };
        return input.error(n.map_or(spec.design.span().start, |n| n.span().start), message, remedy);
    };
    let part = match &spec.rows_per_part {
        None => (rows / PARTS).clamp(PART[0], PART[1]),
        Some(part) if *part.get_ref() > 0 && PART_ROWS.contains(&part.get_ref().unsigned_abs()) => {
            part.get_ref().unsigned_abs()
        }
        Some(part) => {
            return input.error(
                part.span().start,
                "rows_per_part is out of range",
                "write a whole number of 1 to 100000",
            );
        }
    };
    Ok([rows, part])
}
