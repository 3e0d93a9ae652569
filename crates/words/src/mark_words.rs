//! The mark of a cook in words: its grade, and how it is counted.

use saute_kitchen::data::goals::Counted;
use saute_plan::goal::Goal;
use saute_plan::goal::mark::{Bound, Grade, Mark, Part};

use crate::language::Language;

/// A row of the table of the mark: what, how much of it is reached, its weight and its points.
pub type TermRow = [String; 4];

/// The grade with the points: "Just right · 86".
pub(crate) fn mark_words(mark: &Mark, l: Language) -> String {
    let key = match mark.grade() {
        Grade::JustRight => "grade.just_right",
        Grade::Nearly => "grade.nearly",
        Grade::NotYet => "grade.not_yet",
    };
    l.fill("grade.of_100", &[("grade", &l.text(key)), ("points", &whole(mark))])
}

/// The points without a fraction.
pub(crate) fn whole(mark: &Mark) -> String {
    format!("{:.0}", mark.points())
}

/// How it is counted: heads, a row for each part that the goal judges, and what limits the sum where it does.
pub(crate) fn table(mark: &Mark, goal: &Goal, l: Language) -> (TermRow, Vec<TermRow>) {
    let heads = ["result.term", "result.value", "result.weight", "result.points"].map(|key| l.text(key).to_owned());
    let rows = mark.parts.iter().filter(|(.., weight)| *weight > 0.0);
    let mut rows: Vec<TermRow> =
        rows.map(|(part, reached, weight)| row(name(*part, goal), (*reached, *weight), l)).collect();
    if (mark.points() - mark.sum()).abs() >= 0.05 {
        let key = match mark.bound {
            Bound::Met => "grade.met",
            Bound::Missed => "grade.missed",
            Bound::Fire => "grade.fire",
        };
        rows.push([l.text(key).to_owned(), String::new(), String::new(), format!("{:.1}", mark.points())]);
    }
    (heads, rows)
}

fn row(name: &'static str, (reached, weight): (f64, f64), l: Language) -> TermRow {
    let of = format!("{:.0}\u{a0}%", 100.0 * reached);
    [l.text(name).to_owned(), of, format!("× {weight:.0}"), format!("{:.1}", reached * weight)]
}

fn name(part: Part, goal: &Goal) -> &'static str {
    match part {
        Part::Core => "grade.core",
        Part::Even if goal.counts == Counted::Faces => "grade.faces",
        Part::Even => "grade.even",
        Part::Crust => "grade.crust",
        Part::Care => "grade.care",
    }
}
