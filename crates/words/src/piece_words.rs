//! The state of a piece in few words.

use saute_kitchen::doneness::core_class;
use saute_kitchen::food::Scale;
use saute_kitchen::{Library, Piece, Place, RestOn};

use crate::doneness_words::class;
use crate::language::Language;

/// The group that a piece belongs to: its name up to the number, its own name where there is none.
pub fn group_of(id: &str) -> &str {
    match id.rsplit_once('.') {
        Some((group, number)) if number.parse::<u32>().is_ok() => group,
        _ => id,
    }
}

/// How done it is: the class of its core in its own words, or how far the last of its changes has come.
pub fn doneness(scale: Option<&Scale>, piece: &Piece, l: Language) -> String {
    if let Some(scale) = scale {
        return class(scale, core_class(piece, scale), l).to_owned();
    }
    let (names, fields) = (piece.model.kinetics().names(), &piece.state.changed);
    match (names.last(), fields.last()) {
        (Some(name), Some(field)) => change(l, name, piece.model.volume_mean(field)),
        _ => String::new(),
    }
}

/// What heat has changed, and how far it has come.
pub fn change(l: Language, name: &str, share: f64) -> String {
    l.fill("doneness.change", &[("name", &l.called("change", name)), ("percent", &format!("{:.0}", 100.0 * share))])
}

/// Where it is.
pub fn place(piece: &Piece, l: Language) -> &'static str {
    l.text(match piece.place {
        Place::Waiting => "place.waiting",
        Place::Pan(_) => "place.pan",
        Place::Held => "place.held",
        Place::Rest(RestOn::Board) => "place.board",
        Place::Rest(RestOn::Rack) => "place.rack",
        Place::Rest(RestOn::Foil) => "place.foil",
        Place::Glass => "place.glass",
        Place::Table => "place.table",
    })
}

/// Name of a piece or a group: that of its food or our own in the language, with the number of the group from the second on,
/// and that of the piece in its group; names of a user's own as they are.
pub fn name(id: &str, library: &Library, l: Language) -> String {
    let group = group_of(id);
    let numbered = group.rsplit_once('-').filter(|(_, number)| number.parse::<u32>().is_ok());
    let base = numbered.map_or(group, |(base, _)| base);
    let of_food = library.foods.iter().find(|(kind, food)| food.piece_id(kind) == base);
    let known = of_food.and_then(|(_, food)| food.piece_in(l.code())).or_else(|| l.known("id", base));
    let of_kind = match known {
        None => group.to_owned(),
        Some(name) => numbered.map_or_else(|| name.to_owned(), |(_, number)| format!("{name} {number}")),
    };
    match id.strip_prefix(group).and_then(|rest| rest.strip_prefix('.')) {
        Some(number) => l.fill("piece.numbered", &[("name", &of_kind), ("number", &number)]),
        None => of_kind,
    }
}

/// Its mass, with as many places as it takes to see it change.
pub fn grams(piece: &Piece) -> String {
    let mass = 1e3 * piece.mass();
    if mass < 50.0 { format!("{mass:.1} g") } else { format!("{mass:.0} g") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_spoken_of_by_names_and_not_by_ids() {
        let library = Library::embedded().expect("embedded data");
        let said = |id| name(id, &library, Language::ENGLISH);
        assert_eq!([said("steak"), said("steak-2")], ["steak", "steak 2"]);
        assert_eq!(said("carrot-coin.3"), "carrot coin no. 3");
        assert_eq!(said("carrot-coin-2.3"), "carrot coin 2 no. 3");
        assert_eq!(said("grandmas-roast"), "grandmas-roast", "a name of the user's own");
    }
}
