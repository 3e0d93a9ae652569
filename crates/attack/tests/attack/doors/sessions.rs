//! The door of sessions: files of commands, added foods and kitchens at home; links and stored cooks of another version hold the same.

use saute_attack::doors::{Before, CHANGES, Change, Part, Range, STARTS, Way};
use saute_attack::kitchen_files::LIBRARY;
use saute_kitchen::{Command, Refused, RestOn};
use saute_recipe::session::{Deed, DepartureCause, Entry};
use saute_recipe::{Recipe, Recording, Replay};
use saute_session::kept::link;

use super::other_version::of_another_version;
use super::{hostile, is_taken, names, sound};

/// What the sessions begin with; they only set it out.
const RECIPE: &str = "[pan]\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nsize_mm = [60, 50, 15]\n\
                      coarseness = 4\n[[step]]\nend = true\n";
/// Frames after a change: ten ticks [-].
const AFTER: u64 = 60;

pub(super) fn begun() -> Recording {
    let recipe = Recipe::parse(RECIPE, "door.toml", &LIBRARY).expect("is sound");
    Recording::begin(&recipe, false, &LIBRARY)
}

fn entry(frame: u64, deed: Deed) -> Entry {
    Entry { frame, after_steps: false, deed }
}

/// A session in which food came where a change needs it, and the frame at which the change follows.
fn prepared(before: Before) -> (Recording, u64) {
    let mut recording = begun();
    let food = || "steak".to_owned();
    let put = Deed::Command(Command::Put { food: food(), at: [0.0; 2], heap: false });
    let rest = Deed::Command(Command::Rest { food: food(), on: RestOn::Board });
    let entries = match before {
        Before::Waiting => vec![],
        Before::InPan => vec![entry(0, put)],
        Before::OnBoard => vec![entry(0, put), entry(60, rest)],
    };
    let due = if before == Before::OnBoard { 480 } else { 60 };
    entries.into_iter().for_each(|entry| recording.restore(entry));
    (recording, due)
}

/// The bytes of a session, which hold numbers that are none, as no comparison does.
fn bytes(recording: &Recording) -> Vec<u8> {
    recording.without_hashes().to_file()
}

/// Hands a session through its file, its link and the file of another version; returns what the file held.
fn through_the_doors(recording: &Recording, case: &str) -> Recording {
    let file = recording.to_file();
    let opened = Recording::from_file(&file).expect("a session that was written opens");
    assert_eq!(opened.damage, None, "{case}");
    assert_eq!(bytes(&opened.recording), bytes(recording), "{case}");
    let linked = link::read(&link::fragment(recording)).expect("a link that was made opens").expect("is a cook");
    assert_eq!(bytes(&linked), bytes(recording), "{case}: the link holds the same");
    let (other, version) = of_another_version(&file);
    let older = Recording::from_file(&other).expect("opens").recording;
    assert_eq!((older.beginning().program.as_str(), older.entries().len()), (&*version, recording.entries().len()));
    opened.recording
}

fn tried(change: &Change, way: &Way<fn(f64) -> Deed>) {
    let (prepared, due) = prepared(change.before);
    let mut base = Replay::begin(&prepared, &LIBRARY).expect("begins");
    (0..due).for_each(|_| drop(base.advance_frame(&prepared, &LIBRARY)));
    for v in hostile(way.range) {
        let case = format!("session: {} with {v}", change.name);
        let mut recording = prepared.clone();
        recording.restore(entry(due, (way.write)(v)));
        let read = through_the_doors(&recording, &case);
        let mut replay = base.clone();
        (0..AFTER).for_each(|_| drop(replay.advance_frame(&read, &LIBRARY)));
        judge(&replay, way, v, &case);
        sound(&replay.kitchen, &case);
    }
}

/// Panics unless a number beyond its range was refused by name.
fn judge(replay: &Replay, way: &Way<fn(f64) -> Deed>, v: f64, case: &str) {
    let taken = is_taken(way.range, v);
    let Some(departure) = replay.departure() else {
        assert_ne!(taken, Some(false), "{case} is taken");
        return;
    };
    let said = departure.to_string();
    match &departure.cause {
        DepartureCause::Refused(Refused::DoesNotFit { .. } | Refused::Occupied { .. }) => {}
        DepartureCause::Refused(_) | DepartureCause::Setup(_) => {
            assert_ne!(taken, Some(true), "{case}: {said}");
            names(&said, way.named, way.range, case);
        }
        DepartureCause::Hash { .. } => panic!("{case}: {said}"),
    }
}

#[test]
fn an_entry_with_a_bad_number_is_refused_with_its_key_and_range_or_cooks_in_every_session_file_and_link() {
    for change in CHANGES {
        change.entry.iter().for_each(|way| tried(change, way));
    }
}

#[test]
fn a_kitchen_at_home_with_a_bad_number_is_refused_by_name_before_the_session_begins() {
    for start in STARTS {
        let Part::Home(text) = start.recipe.write else { continue };
        for v in hostile(start.recipe.range) {
            let case = format!("session: {} with {v}", start.name);
            let number = if v.is_nan() { "nan".to_owned() } else { format!("{v:e}") };
            let home = format!("{}\nsource = \"x\"\nconfidence = \"low\"\n", text.replace('#', &number));
            let begun = in_kitchen(&home);
            match Replay::begin(&begun, &LIBRARY) {
                Ok(mut replay) => {
                    assert_ne!(is_taken(start.recipe.range, v), Some(false), "{case} is taken");
                    (0..AFTER).for_each(|_| drop(replay.advance_frame(&begun, &LIBRARY)));
                    sound(&replay.kitchen, &case);
                }
                Err(error) => {
                    assert_ne!(is_taken(start.recipe.range, v), Some(true), "{case}: {error}");
                    names(&error.to_string(), start.recipe.named, Range::Fitting, &case);
                }
            }
        }
    }
}

/// A session that was recorded in a kitchen at home, as its file states it.
fn in_kitchen(home: &str) -> Recording {
    /// Number of the record of the kitchen at home.
    const HOME: u32 = 5;
    let mut file = begun().to_file();
    // The last record states how far it came; the kitchen at home follows the beginning.
    file.truncate(super::other_version::record_end(&file));
    let body = postcard::to_allocvec(&(HOME, home)).expect("can be written");
    file.extend_from_slice(&(body.len() as u32).to_le_bytes());
    file.extend_from_slice(&crc32fast::hash(&body).to_le_bytes());
    file.extend_from_slice(&body);
    let opened = Recording::from_file(&file).expect("opens");
    assert_eq!((opened.damage, opened.recording.beginning().home.as_deref()), (None, Some(home)));
    opened.recording
}
