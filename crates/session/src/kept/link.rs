//! A cook as the fragment of an address: what it began with and every command, packed, with a version and a checksum.

use data_encoding::BASE64URL_NOPAD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use saute_recipe::Recording;
use saute_recipe::session::Opened;
use std::io::{Read, Write};

/// What a fragment with a cook begins with; a version and a dot follow.
const NAME: &str = "cook=";

/// The version of such fragments that this program writes, and the latest that it reads.
const VERSION: u32 = 1;

/// The longest fragment that is offered to be sent [characters] (chosen: programs that carry messages cut longer addresses, and
/// browsers of all kinds open these).
pub const LONGEST: usize = 8000;

/// The longest fragment that is opened [characters] (chosen: ten times the longest that is offered, for programs of other versions).
const MOST_CHARACTERS: usize = 100_000;

/// The longest session that a fragment is unpacked to [bytes] (chosen: far above what packs into the longest; a longer one is no cook).
const MOST_BYTES: u64 = 4 << 20;

/// Why a fragment contains no cook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkError {
    /// It was cut off or changed on its way.
    Damaged,
    /// A newer program wrote it.
    Newer,
    /// It is longer than any that is opened, or contains a longer session.
    TooLong,
}

impl LinkError {
    /// Key of the words for it.
    pub fn words(self) -> &'static str {
        match self {
            Self::Damaged => "link.damaged",
            Self::Newer => "link.newer",
            Self::TooLong => "link.longer",
        }
    }
}

/// The fragment of a cook, without `#`.
pub fn fragment(recording: &Recording) -> String {
    let packed = packed(&recording.without_hashes().to_file());
    let sealed: Vec<u8> = crc32fast::hash(&packed).to_le_bytes().into_iter().chain(packed).collect();
    format!("{NAME}{VERSION}.{}", BASE64URL_NOPAD.encode(&sealed))
}

/// The cook in a fragment, with or without `#`; none if it is about something else.
///
/// # Errors
///
/// If it is damaged, newer than this program or too long.
pub fn read(fragment: &str) -> Result<Option<Recording>, LinkError> {
    let Some(link) = fragment.trim_start_matches('#').strip_prefix(NAME) else { return Ok(None) };
    if link.len() > MOST_CHARACTERS {
        return Err(LinkError::TooLong);
    }
    let (version, text) = link.split_once('.').ok_or(LinkError::Damaged)?;
    let version: u32 = version.parse().map_err(|_| LinkError::Damaged)?;
    if version > VERSION {
        return Err(LinkError::Newer);
    }
    let sealed = BASE64URL_NOPAD.decode(text.as_bytes()).map_err(|_| LinkError::Damaged)?;
    let (checksum, packed) = sealed.split_first_chunk::<4>().ok_or(LinkError::Damaged)?;
    if crc32fast::hash(packed).to_le_bytes() != *checksum {
        return Err(LinkError::Damaged);
    }
    let Opened { recording, damage } = Recording::from_file(&unpacked(packed)?).map_err(|_| LinkError::Damaged)?;
    match damage {
        None => Ok(Some(recording)),
        Some(damage) if damage.is_beyond => Err(LinkError::TooLong),
        Some(_) => Err(LinkError::Damaged),
    }
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    // Memory takes all that is written.
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).unwrap_or_default()
}

fn unpacked(packed: &[u8]) -> Result<Vec<u8>, LinkError> {
    let mut bytes = Vec::new();
    let read = DeflateDecoder::new(packed).take(MOST_BYTES + 1).read_to_end(&mut bytes);
    let read = read.map_err(|_| LinkError::Damaged)?;
    if read as u64 <= MOST_BYTES { Ok(bytes) } else { Err(LinkError::TooLong) }
}

#[cfg(test)]
mod tests {
    use saute_kitchen::{Command, Library};
    use saute_recipe::{Recipe, Replay};

    use super::*;

    fn cook(commands: u32) -> Recording {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(&library.recipes["medium"], "medium", &library).expect("parses");
        let mut recording = Recording::begin(&recipe, true, &library);
        let mut live = Replay::begin(&recording, &library).expect("begins");
        recording.observe(&live.kitchen);
        for command in 0..commands {
            let hob = Command::Hob(f64::from(command.wrapping_mul(2_654_435_761) >> 21));
            live.kitchen.apply(&hob).expect("is taken");
            recording.push(&live.kitchen, hob);
            live.kitchen.advance_frame();
            recording.observe(&live.kitchen);
        }
        recording
    }

    #[test]
    fn a_cook_comes_back_from_its_link() {
        let recording = cook(20);
        let link = fragment(&recording);
        println!("20 commands: {} characters", link.len());
        assert!(link.len() < 1000 && link.chars().all(|c| c.is_ascii_alphanumeric() || "=.-_".contains(c)), "{link}");
        for link in [link.clone(), format!("#{link}")] {
            let read = read(&link).expect("holds").expect("is a cook");
            assert_eq!((read.entries(), read.moment()), (recording.entries(), recording.moment()));
            assert_eq!(read.beginning(), recording.beginning());
        }
        assert!(fragment(&cook(8000)).len() > LONGEST, "a long cook is too long");
    }

    /// A fragment with bytes.
    fn holding(bytes: &[u8]) -> String {
        let packed = packed(bytes);
        let sealed: Vec<u8> = crc32fast::hash(&packed).to_le_bytes().into_iter().chain(packed).collect();
        format!("{NAME}{VERSION}.{}", BASE64URL_NOPAD.encode(&sealed))
    }

    #[test]
    fn a_link_that_is_too_long_or_unpacks_to_too_much_is_refused_as_such() {
        let long = format!("{NAME}{VERSION}.{}", "A".repeat(MOST_CHARACTERS));
        assert_eq!(read(&long), Err(LinkError::TooLong));
        let bomb = holding(&vec![0; 8 * MOST_BYTES as usize]);
        assert!(bomb.len() < MOST_CHARACTERS, "{} characters", bomb.len());
        assert_eq!(read(&bomb), Err(LinkError::TooLong));
    }

    #[test]
    fn a_link_that_is_cut_changed_or_newer_is_refused() {
        let link = fragment(&cook(3));
        for cut in NAME.len()..link.len() {
            assert_eq!(read(&link[..cut]), Err(LinkError::Damaged), "{cut}");
        }
        let body = link.find('.').expect("a dot") + 1;
        for at in body..link.len() {
            let other = if link.as_bytes()[at] == b'A' { "B" } else { "A" };
            let changed = format!("{}{other}{}", &link[..at], &link[at + 1..]);
            assert_eq!(read(&changed), Err(LinkError::Damaged), "{at}");
        }
        assert_eq!(read(&link.replace("cook=1.", "cook=2.")), Err(LinkError::Newer));
        assert_eq!(read(&link.replace("cook=1.", "cook=x.")), Err(LinkError::Damaged));
        assert_eq!(read("").map(|read| read.is_none()), Ok(true));
        assert_eq!(read("#top").map(|read| read.is_none()), Ok(true));
    }
}
