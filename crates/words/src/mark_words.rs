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

/// Share of a part from which it went well [-] (chosen: nothing that a person would see is missing).
const WELL: f64 = 0.95;
/// Marks that are given, the last at the end (chosen: what the eye takes in at once).
const TOLD: usize = 5;

/// What went well: the parts that are as good as whole; empty where none is.
pub(crate) fn good_words(mark: &Mark, l: Language) -> String {
    let key = |part| match part {
        Part::Core => "grade.good_core",
        Part::Even => "grade.good_even",
        Part::Crust => "grade.good_crust",
        Part::Care => "grade.good_care",
    };
    // A core that misses its class by a little is not right.
    let enough = |part: Part| if part == Part::Core { 1.0 } else { WELL };
    let well = mark.parts.iter().filter(|(part, reached, weight)| *weight > 0.0 && *reached >= enough(*part));
    let well: Vec<&str> = well.map(|(part, ..)| l.text(key(*part))).collect();
    if well.is_empty() { String::new() } else { l.fill("grade.good", &[("what", &well.join(l.text("grade.joint")))]) }
}

/// The best of all marks, the last at the end, and, once there are several, the last ones; empty before there are any.
pub(crate) fn best_words(marks: &[f64], l: Language) -> String {
    let points = |mark: &f64| format!("{mark:.0}");
    let Some(best) = marks.iter().copied().max_by(f64::total_cmp) else { return String::new() };
    if marks.len() == 1 {
        return l.fill("grade.best", &[("best", &points(&best))]);
    }
    let last: Vec<String> = marks[marks.len().saturating_sub(TOLD)..].iter().map(points).collect();
    l.fill("grade.best_and_last", &[("best", &points(&best)), ("last", &last.join(", "))])
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_mark_is_told_with_the_last_ones() {
        let l = Language::ENGLISH;
        assert_eq!(best_words(&[], l), "");
        assert_eq!(best_words(&[61.6], l), "Your best: 62");
        assert_eq!(
            best_words(&[50.0, 10.0, 91.0, 70.0, 80.0, 85.4], l),
            "Your best: 91 (the last ones: 10, 91, 70, 80, 85)"
        );
    }

    #[test]
    fn what_went_well_is_named_and_nothing_else() {
        let parts =
            [(Part::Core, 1.0, 30.0), (Part::Even, 0.4, 40.0), (Part::Crust, 0.0, 0.0), (Part::Care, 0.97, 10.0)];
        let mark = Mark { parts, bound: Bound::Missed };
        assert_eq!(good_words(&mark, Language::ENGLISH), "Good: the core is right, and the pan never got too hot.");
        let nothing = Mark { parts: parts.map(|(part, _, weight)| (part, 0.0, weight)), bound: Bound::Missed };
        assert_eq!(good_words(&nothing, Language::ENGLISH), "");
    }
}
