//! What people hand in: logs of thermometers, results of a class, links, and commands.

use std::io::Write as _;
use std::sync::LazyLock;

use data_encoding::BASE64URL_NOPAD;
use saute_kitchen::bytes::Models;
use saute_kitchen::{Command, Kitchen};
use saute_plan::fit::log::log_file::LogFile;
use saute_plan::fit::log::logger::loggers;
use saute_plan::fit::log::reading::Choices;
use saute_session::kept::link;
use saute_study::class::{ClassSummary, from_csv, to_csv};

use crate::kitchen_files::LIBRARY;
use crate::stored::SOUND;
use crate::ten_ticks::check;
use crate::text;

/// A thermometer's log, read by its own header and by the preset of one maker, drawn by its bytes: times rise, temperatures are some of
/// a kitchen.
pub fn log(bytes: &[u8]) {
    let Ok(log) = LogFile::parse("log.csv", bytes) else { return };
    let drawn = crc32fast::hash(bytes) as usize % loggers().len();
    for logger in [None, loggers().get(drawn)] {
        let Ok(reading) = log.read(&Choices { logger, ..Choices::default() }) else { continue };
        for curve in [reading.core, reading.pan].into_iter().flatten() {
            assert!(curve.points.windows(2).all(|pair| pair[0].0 < pair[1].0), "times rise");
            assert!(curve.points.iter().all(|(at, kelvin)| at.is_finite() && (200.0..1300.0).contains(kelvin)));
        }
    }
}

/// Results of a class: what is written of them is read again.
pub fn class_result(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let Ok(rows) = from_csv("class.csv", text) else { return };
    let (merged, _) = ClassSummary::of(&rows);
    let written = to_csv(&merged);
    assert!(from_csv("class.csv", &written).is_ok(), "what was written can be read");
}

/// The fragment of an address; and bytes as what such a fragment packs, under a valid checksum.
pub fn link(bytes: &[u8]) {
    let _ = text(bytes).map(link::read);
    let mut sealed = crc32fast::hash(bytes).to_le_bytes().to_vec();
    // Memory takes all that is written.
    let _ = sealed.write_all(bytes);
    let _ = link::read(&format!("cook=1.{}", BASE64URL_NOPAD.encode(&sealed)));
}

/// A kitchen that fries, as it was stored.
static FRYING: LazyLock<(Kitchen, Models)> = LazyLock::new(|| {
    let (body, models) = &*SOUND;
    let mut models = models.clone();
    let bytes = saute_kitchen::bytes::sealed(body);
    (Kitchen::from_bytes_with(&bytes, &LIBRARY, &mut models).expect("it is sound"), models)
});

/// Commands, one after the other, each followed by a tick: each is refused or carried out, and the balances close.
pub fn command(bytes: &[u8]) {
    let mut kitchen = FRYING.0.clone();
    let mut rest = bytes;
    for _ in 0..8 {
        let Ok((command, left)) = postcard::take_from_bytes::<Command>(rest) else { break };
        rest = left;
        let _ = kitchen.apply(&command);
        kitchen.step();
    }
    check(&kitchen);
}
