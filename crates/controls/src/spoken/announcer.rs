//! What is announced of a cook, once each: what happened to food, what is to be done, smoke and fire, and notices.

use std::collections::BTreeMap;
use std::fmt::Display;

use saute_kitchen::advice::SMOKE_SEEN_MG_S;
use saute_kitchen::{Piece, Place};
use saute_session::permits::Permit;
use saute_words::language::Language;
use saute_words::piece_words::{group_of, place};

use crate::session::Session;
use crate::spoken::notice::Notice;

/// Share of the smoke that is seen below which it has ended [-] (chosen: what flickers about the limit is announced once).
const ENDED: f64 = 0.5;

/// How a piece lies: where, on which face, and in how many parts.
#[derive(Clone, Debug, PartialEq)]
struct Lies {
    place: &'static str,
    is_turned: bool,
    is_halved: bool,
}

/// Remembers what was announced.
#[derive(Clone, Debug, Default)]
pub struct Announcer {
    /// How pieces lay; none before the first look and while time is turned: where they lie then is no news.
    pieces: Option<BTreeMap<String, Lies>>,
    /// The order that was announced last, until somebody does something.
    order: Option<String>,
    smokes: bool,
    burns: bool,
    notice: u64,
}

impl Announcer {
    /// Sentences that were not announced before; `order` is what is to be done now: a verb, and the sentence with its reason.
    pub fn news(
        &mut self,
        session: &Session,
        order: Option<&(String, String)>,
        notice: &Notice,
        l: Language,
    ) -> Vec<String> {
        let mut said = self.fire_and_smoke(session, l);
        said.extend(self.moved(session, l));
        said.extend(self.ordered(order));
        for one in notice.after(self.notice) {
            self.notice = one.number;
            said.push(one.text);
        }
        said
    }

    fn fire_and_smoke(&mut self, session: &Session, l: Language) -> Vec<String> {
        let pan = session.kitchen.pan_state();
        let mut said = Vec::new();
        let (burns, smoke) = (pan.liquids.smoke.burning, pan.smoke_mg_s());
        if burns && !self.burns {
            said.push(l.text("pour.fire").to_owned());
        }
        let least = if self.smokes { ENDED * SMOKE_SEEN_MG_S } else { SMOKE_SEEN_MG_S };
        let smokes = smoke >= least;
        // Where readings are hidden, a study contains questions about what is seen.
        if smokes != self.smokes && !burns && session.permits.allow(&[Permit::ReadOuts]) {
            said.push(l.text(if smokes { "told.smokes" } else { "told.smokes_no_more" }).to_owned());
        }
        (self.burns, self.smokes) = (burns, smokes);
        said
    }

    /// What happened to pieces: those of a group in one sentence.
    fn moved(&mut self, session: &Session, l: Language) -> Vec<String> {
        if session.is_travelling() {
            self.pieces = None;
            return Vec::new();
        }
        let before = |id: &str| self.pieces.as_ref().and_then(|pieces| pieces.get(id));
        // On its way in a hand it still counts as where it was: a flip is one sentence.
        let of = |p: &Piece| match p.place {
            Place::Held => before(&p.id).cloned().unwrap_or_else(|| lies(p, l)),
            _ => lies(p, l),
        };
        let now: BTreeMap<String, Lies> = session.kitchen.pieces().iter().map(|p| (p.id.clone(), of(p))).collect();
        let mut said: Vec<String> = Vec::new();
        for (id, lies) in &now {
            let Some(key) = before(id).and_then(|before| changed(before, lies)) else { continue };
            let parts: [(&str, &dyn Display); 2] =
                [("name", &session.name_of(group_of(id), l)), ("place", &lies.place)];
            let sentence = l.fill(key, &parts);
            if !said.contains(&sentence) {
                said.push(sentence);
            }
        }
        if !said.is_empty() {
            self.order = None;
        }
        self.pieces = Some(now);
        said
    }

    fn ordered(&mut self, order: Option<&(String, String)>) -> Option<String> {
        let (verb, sentence) = order?;
        if self.order.as_ref() == Some(verb) {
            return None;
        }
        self.order = Some(verb.clone());
        Some(sentence.clone())
    }
}

fn lies(piece: &Piece, l: Language) -> Lies {
    Lies { place: place(piece, l), is_turned: piece.upside_down(), is_halved: piece.halved().is_some() }
}

/// Key of the sentence about what has changed.
fn changed(before: &Lies, now: &Lies) -> Option<&'static str> {
    if before.is_halved != now.is_halved {
        Some("told.halved")
    } else if before.place != now.place {
        Some("told.place")
    } else if before.is_turned != now.is_turned {
        Some("told.turned")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use saute_kitchen::{Command, Library};

    use super::*;
    use saute_session::permits::Permits;

    /// Promise: smoke is announced once when it begins and once when it ends, and not where readings are hidden.
    #[test]
    fn smoke_is_said_once() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session = Session::new(library, &Default::default()).expect("sets out");
        session.command(&Command::Hob(2000.0)).expect("hob");
        let (mut announcer, mut blind, notice) = (Announcer::default(), Announcer::default(), Notice::default());
        let hidden = Permits::only(&Permit::ALWAYS);
        let mut said = Vec::new();
        for k in 0..30_000 {
            session.tick().expect("ticks");
            if k % 20 > 0 {
                continue;
            }
            said.extend(announcer.news(&session, None, &notice, Language::ENGLISH));
            let seen = std::mem::replace(&mut session.permits, hidden);
            assert!(blind.news(&session, None, &notice, Language::ENGLISH).is_empty(), "where readings are hidden");
            session.permits = seen;
            match said.len() {
                0 => {}
                1 => session.command(&Command::Hob(0.0)).expect("off"),
                _ => break,
            }
        }
        assert_eq!(said, ["The oil smokes.", "The smoke has stopped."]);
    }

    /// Promise: what happens is announced once, in the order in which it happens, and nothing is announced of what stays as it is.
    #[test]
    fn events_orders_and_notices_are_said_once() {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let mut session = Session::new(library, &Default::default()).expect("sets out");
        let (mut announcer, notice, l) = (Announcer::default(), Notice::default(), Language::ENGLISH);
        let order = |verb: &str| Some((verb.to_owned(), format!("{verb}: now.")));
        let mut news = |session: &Session, order: Option<&(String, String)>| announcer.news(session, order, &notice, l);
        assert!(news(&session, None).is_empty(), "what lies there at first is no news");
        assert_eq!(news(&session, order("Put it in").as_ref()), ["Put it in: now."]);
        assert!(news(&session, order("Put it in").as_ref()).is_empty());
        session.command(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("puts");
        (0..50).for_each(|_| session.tick().expect("ticks"));
        assert_eq!(news(&session, None), ["steak: in the pan."]);
        session.command(&Command::Flip { food: "steak".into() }).expect("flips");
        let said: Vec<String> = (0..60)
            .flat_map(|_| {
                (0..10).for_each(|_| session.tick().expect("ticks"));
                news(&session, None)
            })
            .collect();
        assert_eq!(said.iter().filter(|text| *text == "steak: turned over.").count(), 1, "{said:?}");
        notice.say("one");
        notice.say("two");
        assert_eq!(news(&session, None), ["one", "two"]);
        assert!(news(&session, None).is_empty());
        assert_eq!(
            news(&session, order("Put it in").as_ref()),
            ["Put it in: now."],
            "an order comes again after a deed"
        );
    }
}
