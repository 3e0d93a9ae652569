//! Kitchens and sessions as bytes.

use std::sync::LazyLock;

use saute_kitchen::bytes::{Models, sealed};
use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
use saute_kitchen::{Command, Kitchen, PieceOrder, kelvin};
use saute_recipe::session::session_file;
use saute_recipe::{Recipe, Recording};

use crate::kitchen_files::LIBRARY;

/// Bytes of one edit of a stored kitchen: a place and a mask [-].
const EDIT: usize = 5;
/// A recipe with which the attacked sessions begin.
const RECIPE: &str = "[[step]]\nhob_w = 900\n[[step]]\nat_s = 60\nend = true\n";

/// A small kitchen that fries, with its models: its bytes without their header.
pub(crate) static SOUND: LazyLock<(Vec<u8>, Models)> = LazyLock::new(|| {
    let mut kitchen = Kitchen::new(&LIBRARY, "carbon-steel-26", kelvin(180.0)).expect("the pan is shipped");
    let order = PieceOrder {
        id: "coin".into(),
        kind: "carrot-coin".into(),
        size: [0.026, 0.026, 0.006],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 1.0,
        mesh: MeshSize::Paper2013,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
    };
    kitchen.add(&LIBRARY, &order).expect("the food is shipped");
    for command in [
        Command::Oil { kind: None, mass: 0.01 },
        Command::Put { food: order.id, at: [0.0; 2], heap: false },
        Command::Toss { height: 0.1 },
    ] {
        kitchen.apply(&command).expect("carried out");
        kitchen.step();
    }
    let head = sealed(&[]).len();
    (kitchen.to_bytes().split_off(head), Models::of(&kitchen))
});

/// The file of a session in which nothing was done yet.
static BEGINNING: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let recipe = Recipe::parse(RECIPE, "recipe.toml", &LIBRARY).expect("the recipe is sound");
    Recording::begin(&recipe, true, &LIBRARY).to_file()
});

/// Bytes as a stored kitchen; and a stored kitchen whose bytes are changed at places that the input names, under a valid
/// checksum.
pub fn kitchen(bytes: &[u8]) {
    restore(bytes);
    let mut body = SOUND.0.clone();
    for edit in bytes.chunks_exact(EDIT) {
        let (place, mask) = edit.split_at(EDIT - 1);
        let place = u32::from_le_bytes([place[0], place[1], place[2], place[3]]) as usize % body.len();
        body[place] ^= mask[0];
    }
    restore(&sealed(&body));
}

/// Restores a kitchen, unless it is refused, and stores it again.
fn restore(bytes: &[u8]) {
    if let Ok(kitchen) = Kitchen::from_bytes_with(bytes, &LIBRARY, &mut SOUND.1.clone()) {
        assert!(!kitchen.to_bytes().is_empty());
    }
}

/// A session file, or else a record after a sound beginning, under a valid checksum.
pub fn session(bytes: &[u8]) {
    if session_file::is_session(bytes) {
        return open(bytes);
    }
    let mut file = BEGINNING.clone();
    file.extend_from_slice(&(bytes.len() as u32).to_le_bytes());
    file.extend_from_slice(&crc32fast::hash(bytes).to_le_bytes());
    file.extend_from_slice(bytes);
    open(&file);
}

/// Reads a session, unless it is refused, and writes it again.
fn open(bytes: &[u8]) {
    let Ok(opened) = Recording::from_file(bytes) else { return };
    let again = Recording::from_file(&opened.recording.to_file()).expect("a session that was written opens");
    assert_eq!(again.damage, None);
    assert_eq!(again.recording.entries().len(), opened.recording.entries().len());
    opened.recording.marks().for_each(drop);
}
