//! The cook in a few sentences, for those who do not see it.

use std::fmt::Display;

use saute_kitchen::{Piece, celsius};

use crate::input::pouring::in_the_pan;
use crate::session::Session;
use crate::settings::Settings;
use saute_session::permits::Permit;
use saute_words::clock::clock;
use saute_words::piece_words::{doneness, place};

/// Pieces that are described one by one (chosen: more are not kept apart by ear).
const MOST: usize = 6;

/// What is on the hob, how each piece is, and how time runs.
pub fn told(session: &Session, settings: &Settings) -> String {
    let (kitchen, l) = (&session.kitchen, settings.language);
    let pan = settings.temperature(celsius(kitchen.pan_temperature()));
    let (hob, liquids) = (format!("{:.0}", kitchen.hob_w()), in_the_pan(kitchen, l));
    let parts: [(&str, &dyn Display); 3] = [("pan", &pan), ("hob", &hob), ("liquids", &liquids)];
    let pan = match (session.permits.allow(&[Permit::ReadOuts]), settings.skill_mode) {
        (false, _) => "told.hob_alone",
        (true, true) => "told.hob",
        (true, false) => "told.pan",
    };
    let mut sentences = vec![l.fill(pan, &parts)];
    sentences.extend(kitchen.pieces().iter().take(MOST).map(|piece| one(piece, session, settings)));
    let further = kitchen.pieces().len().saturating_sub(MOST);
    if further > 0 {
        sentences.push(l.fill("told.further", &[("count", &further)]));
    }
    let time = clock(session.shown_s());
    sentences.push(match session.paused {
        true => l.fill("told.paused", &[("time", &time)]),
        false => l.fill("told.runs", &[("time", &time), ("speed", &format!("{:.0}", session.speed))]),
    });
    sentences.join(l.text("told.joint"))
}

/// True if what is measured is not stated: in skill mode, and where a study or a lesson does not allow it.
fn is_hidden(session: &Session, settings: &Settings) -> bool {
    settings.skill_mode || !session.permits.allow(&[Permit::ReadOuts])
}

fn one(piece: &Piece, session: &Session, settings: &Settings) -> String {
    let l = settings.language;
    if is_hidden(session, settings) {
        let parts: [(&str, &dyn Display); 2] = [("name", &session.name_of(&piece.id, l)), ("place", &place(piece, l))];
        return l.fill("told.place", &parts);
    }
    let shown = |kelvin: f64| settings.temperature(celsius(kelvin));
    let scale = session.scales(&settings.scale).of(&piece.model).cloned();
    let (name, done) = (session.name_of(&piece.id, l), doneness(scale.as_deref(), piece, l));
    let (core, below, above) = (shown(piece.core()), shown(piece.face(true)), shown(piece.face(false)));
    let parts: [(&str, &dyn Display); 6] = [
        ("name", &name),
        ("place", &place(piece, l)),
        ("core", &core),
        ("below", &below),
        ("above", &above),
        ("done", &done),
    ];
    l.fill("told.piece", &parts)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use saute_kitchen::{Command, Library};

    use super::*;
    use saute_session::permits::Permits;
    use saute_words::language::Language;

    #[test]
    fn a_cook_is_told_in_both_languages() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session = Session::new(library, &Default::default()).expect("sets out");
        session.command(&Command::Hob(1400.0)).expect("hob");
        session.command(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("puts");
        (0..50).for_each(|_| session.tick().expect("ticks"));
        let english = told(&session, &Settings::default());
        let expected = ["Pan ", "1400 W", "steak: in the pan, core 5 °C", "Time 0:05"];
        assert!(expected.iter().all(|part| english.replace('\u{a0}', " ").contains(part)), "{english}");
        let japanese =
            told(&session, &Settings { language: Language::of_code("ja").expect("Japanese"), ..Settings::default() });
        assert!(japanese.contains("フライパン") && !japanese.contains('{'), "{japanese}");
        session.permits = Permits::only(&Permit::ALWAYS);
        let hidden = told(&session, &Settings::default());
        assert!(!hidden.contains("°C") && !hidden.contains(" g ") && hidden.contains("in the pan"), "{hidden}");
        session.set_paused(true);
        assert!(told(&session, &Settings::default()).contains("stands still"));
    }
}
