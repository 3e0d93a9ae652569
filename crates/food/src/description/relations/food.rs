//! Relations in food files.

use crate::description::{Composition, FoodDescription, Form};

use saute_schema::{DataFile, Format, LibraryError};

/// Largest deviation of a sum of mass fractions from 1 [-] (chosen: the rounding of food tables).
const FRACTIONS_OFF: f64 = 0.005;
/// Largest dimension of a piece [mm], as the range of its keys.
const LARGEST_MM: f64 = 300.0;

type Checked = Result<(), LibraryError>;

impl Format for FoodDescription {
    fn relations(&self, file: &DataFile) -> Checked {
        shape(self, file)?;
        spine(self, file)?;
        poured(self, file)?;
        corners(self, file)?;
        tissues(self, file)?;
        natural(self, file)?;
        sizes(self, file)?;
        feel(self, file)?;
        let core = self.core.as_ref().and_then(|c| c.tissue.as_ref());
        let sheaths = self.sheaths.as_ref().and_then(|s| s.tissue.as_ref());
        let tissues = [
            ("lean", Some(&self.lean)),
            ("adipose", self.adipose.as_ref()),
            ("core.tissue", core),
            ("sheaths.tissue", sheaths),
            ("yolk.tissue", self.yolk.as_ref().and_then(|y| y.tissue.as_ref())),
        ];
        tissues.into_iter().try_for_each(|(table, tissue)| tissue.map_or(Ok(()), |t| composition(table, t, file)))
    }
}

/// Sizes and outline belong to all forms but "mesh", which has its own table.
fn shape(food: &FoodDescription, file: &DataFile) -> Checked {
    if food.form == Form::Mesh {
        return mesh(food, file);
    }
    let error = |path: &str, message: &str| Err(file.error(path, message));
    match (&food.mesh, food.size.is_set(), food.outline.is_set()) {
        (Some(_), ..) => error("mesh", "[mesh] belongs to form = \"mesh\": leave it out, or write form = \"mesh\""),
        (_, false, _) => error("form", "a table [size] is missing: write default_mm, min_mm and max_mm"),
        (.., false) => error("form", "a table [outline] is missing: write exponent and ripple"),
        _ => Ok(()),
    }
}

fn mesh(food: &FoodDescription, file: &DataFile) -> Checked {
    let Some(mesh) = &food.mesh else {
        return Err(file.error("form", "form = \"mesh\" needs a table [mesh]: write file = \"my-piece.obj\""));
    };
    if food.outline.is_set() {
        return Err(file.error("outline", "[outline] does not go with form = \"mesh\": leave it out"));
    }
    if mesh.fibres.is_some_and(|f| f.iter().all(|v| *v == 0.0)) {
        let message = "fibres has no direction: write [x, y, z], for instance [0.0, 0.0, 1.0]";
        return Err(file.error("mesh.fibres", message));
    }
    Ok(())
}

/// Shrimps have a spine, and nothing else has.
fn spine(food: &FoodDescription, file: &DataFile) -> Checked {
    match (&food.spine, food.form == Form::Shrimp) {
        (Some(_), false) => Err(file.error("spine", "[spine] belongs to form = \"shrimp\": leave it out")),
        (None, true) => {
            let message = "form = \"shrimp\" needs a table [spine] with turn_deg, turn_varies_deg and flattening";
            Err(file.error("form", message))
        }
        _ => Ok(()),
    }
}

/// An outline of its own belongs to steaks; its corners go round a simple polygon, counter-clockwise.
fn corners(food: &FoodDescription, file: &DataFile) -> Checked {
    let corners = &food.outline.corners;
    if corners.is_empty() {
        return Ok(());
    }
    let error = |message: &str| Err(file.error("outline.corners", message));
    if food.form != Form::Steak {
        return error("corners belong to form = \"steak\": leave them out");
    }
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let doubled: f64 = (0..corners.len()).map(|i| corners[i][0] * next(i)[1] - next(i)[0] * corners[i][1]).sum();
    if doubled < LEAST_DOUBLED {
        return error("these corners span no area counter-clockwise: list three or more of them in that order");
    }
    let short = |i: usize| libm::hypot(next(i)[0] - corners[i][0], next(i)[1] - corners[i][1]) < SHORTEST;
    if (0..corners.len()).any(short) {
        return error("two corners lie on each other: leave one of them out");
    }
    let sides = |i: usize, j: usize| crosses([corners[i], next(i)], [corners[j], next(j)]);
    let apart = |i: usize, j: usize| j > i + 1 && (i > 0 || j + 1 < corners.len());
    let crossing = (0..corners.len()).any(|i| (i + 1..corners.len()).any(|j| apart(i, j) && sides(i, j)));
    if crossing { error("the outline crosses itself: list its corners in order") } else { Ok(()) }
}

/// Twice the least area of an outline of its own, relative to half of length and width [-] (chosen: an eighth of the box).
const LEAST_DOUBLED: f64 = 1.0;

/// Shortest side of such an outline [-] (chosen: a hundredth of the box).
const SHORTEST: f64 = 0.02;

/// Returns true if two sides cross or touch.
fn crosses([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let turn = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}

/// What is poured has a yolk and states how it runs, and nothing else does.
fn poured(food: &FoodDescription, file: &DataFile) -> Checked {
    let is_poured = food.form == Form::Poured;
    for (table, stated, keys) in [
        ("yolk", food.yolk.is_some(), "share, height_mm and colour"),
        ("pour", food.pour.is_some(), "thick_share, thick_height_mm, edge_mm, viscosity_mpa_s and sets_by"),
    ] {
        match (stated, is_poured) {
            (true, false) => {
                return Err(file.error(table, format!("[{table}] belongs to form = \"poured\": leave it out")));
            }
            (false, true) => {
                return Err(file.error("form", format!("form = \"poured\" needs a table [{table}] with {keys}")));
            }
            _ => {}
        }
    }
    match &food.natural {
        Some(_) if is_poured => {
            Err(file.error("natural", "[natural] does not go with form = \"poured\": leave it out"))
        }
        _ => Ok(()),
    }
}

/// Swept forms alone have a natural form; a fat cap lies on a steak with one, and its tissue is stated.
fn natural(food: &FoodDescription, file: &DataFile) -> Checked {
    if food.natural.is_some() && food.form == Form::Mesh {
        return Err(file.error("natural", "[natural] does not go with form = \"mesh\": leave it out"));
    }
    if food.fat_cap.is_none() {
        return Ok(());
    }
    let message = match (food.form == Form::Steak, food.natural.is_some(), food.adipose.is_some()) {
        (false, ..) => "[fat_cap] belongs to form = \"steak\": leave it out",
        (_, false, _) => "[fat_cap] needs a table [natural]: a plain steak has no cap",
        (.., false) => "[fat_cap] needs a table [adipose]: what the fat tissue consists of",
        _ => return Ok(()),
    };
    Err(file.error("fat_cap", message))
}

/// A food has at most one second tissue, and a form that may hold it.
fn tissues(food: &FoodDescription, file: &DataFile) -> Checked {
    let table = match (&food.core, &food.sheaths) {
        (Some(_), Some(_)) => {
            return Err(file.error("sheaths", "[core] and [sheaths] exclude each other: keep one of them"));
        }
        (Some(_), None) => "core",
        (None, Some(_)) => "sheaths",
        (None, None) => return Ok(()),
    };
    if food.form.may_hold_tissues() {
        return Ok(());
    }
    Err(file.error(table, format!("[{table}] cannot lie in form = \"{}\": leave it out", food.form.name())))
}

/// There are as many sizes as the form has dimensions, ascending from the smallest to the largest.
fn sizes(food: &FoodDescription, file: &DataFile) -> Checked {
    if food.form == Form::Mesh && !food.size.is_set() {
        return Ok(());
    }
    let names = food.form.dimensions();
    let range = &food.size;
    let mut low: Option<&[f64]> = None;
    for (key, size) in [("min_mm", &range.min_mm), ("default_mm", &range.default_mm), ("max_mm", &range.max_mm)] {
        let path = format!("size.{key}");
        if size.len() != names.len() {
            let message = format!("{key} needs the {} of this form: write {key} = [{}]", names.len(), names.join(", "));
            return Err(file.error(&path, message));
        }
        if let Some(low) = low {
            low.iter().zip(size).try_for_each(|(low, size)| file.within(&path, *size, *low, LARGEST_MM))?;
        }
        low = Some(size);
    }
    Ok(())
}

/// The temperatures of the words for the feel ascend.
fn feel(food: &FoodDescription, file: &DataFile) -> Checked {
    for (language, words) in &food.words {
        if !words.feel.is_sorted_by(|a, b| a.from_c < b.from_c) {
            let message = "feel needs ascending temperatures: write the entry with the lowest from_c first";
            return Err(file.error(&format!("words.{language}.feel"), message));
        }
    }
    Ok(())
}

/// Mass fractions add up to 1.
fn composition(table: &str, tissue: &Composition, file: &DataFile) -> Checked {
    let total = tissue.total();
    if (total - 1.0).abs() <= FRACTIONS_OFF {
        return Ok(());
    }
    let message =
        format!("the mass fractions of [{table}] add up to {total:.4}; they must add up to 1 (± {FRACTIONS_OFF})");
    Err(file.error(&format!("{table}.water"), message))
}
