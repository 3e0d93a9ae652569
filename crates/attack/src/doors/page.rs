//! The table of the doors as a page of the guides.

use std::fmt::Write;

use saute_schema::number_text::number_text;

use super::{CHANGES, Part, Range, STARTS, STREAMED, Start, Streamed};

const HEAD: &str = "# Doors\n\n\
A kitchen is changed through a few doors. This page lists what each can say and which numbers it takes. A number beyond its range, or one \
that is none (nan, inf), is refused with the name of its key and its range. A streamed pose is held at the reach of the hand instead; \
one that is none is dropped, and the hand stays where it was. A test hands such numbers to every door and cooks on.\n\n\
- **Recipe**: a [recipe file](formats/recipe.md), also as the text that a page's script hands over.\n\
- **Session**: a [session file](sessions.md), a link, what a page keeps, and a stored cook of another version. All hold the same entries. \
A stored kitchen (`Kitchen::to_bytes`) of another version is refused: it is no door.\n\
- **Python**: the calls of a [kitchen](python.md).\n\
- **Phone**, **OSC** and **device**: [networked devices](network-devices.md) and string devices. They say poses only.\n\n\
\"What fits\" stands for the hob's power, the room in the pan, the reach of an arm or the size of the food. The instant that a \
page's script asks for is 0 to the end of its cook. Speed and pause are no changes: no file states them; `step(n)` of Python and the controls of window and page do.\n";

/// Returns the page.
pub fn page() -> String {
    let mut text = HEAD.to_owned();
    changes(&mut text);
    starts(&mut text);
    streams(&mut text);
    text
}

fn changes(text: &mut String) {
    *text += "\n## What hands change\n\n\
              | change | recipe | session | Python | phone, OSC, device |\n|---|---|---|---|---|\n";
    for change in CHANGES {
        let recipe = change.recipe.map_or("no".to_owned(), |way| range(way.range));
        let entry = change.entry.map_or("no".to_owned(), |way| range(way.range));
        let python = change.python.map_or("no".to_owned(), |(call, taken)| format!("`{call}` {}", range(taken)));
        let posed = if change.posed { "pose only" } else { "no" };
        let _ = writeln!(text, "| {} | {recipe} | {entry} | {python} | {posed} |", change.name);
    }
}

fn starts(text: &mut String) {
    *text += "\n## What a kitchen begins with\n\n\
              Python hands it over as a recipe; a session holds the text of its recipe.\n\n\
              | start | recipe, Python | session |\n|---|---|---|\n";
    for Start { name, recipe } in STARTS {
        let taken = range(recipe.range);
        let own = if matches!(recipe.write, Part::Home(_)) { "`--data`, `data=`" } else { &taken };
        let _ = writeln!(text, "| {name} | {own} | {taken} |");
    }
}

fn streams(text: &mut String) {
    *text += "\n## Numbers of streams\n\n| number | taken | beyond it |\n|---|---|---|\n";
    for number in STREAMED {
        let beyond = if matches!(number.message, Streamed::Device(_)) { "dropped" } else { "refused" };
        let _ = writeln!(text, "| {} | {} | {beyond} |", number.name, range(number.range));
    }
}

fn range(range: Range) -> String {
    match range {
        Range::Plain => "yes".to_owned(),
        Range::Within(low, high) => format!("{} to {}", number_text(low), number_text(high)),
        Range::Fitting => "what fits".to_owned(),
        Range::Reach => "finite".to_owned(),
    }
}
