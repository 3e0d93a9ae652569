//! `--wav FILE`: the sound of a cook as 16-bit stereo, written while it cooks and given its name when it is complete.

use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

use saute_kitchen::Kitchen;
use saute_session::hearing::Sound;
use saute_sound::RATES;

use crate::error::CliError;
use crate::output::out_file::OutPlace;
use saute_files::LockedFile;

/// Example of the option's value, for messages.
const EXAMPLE: &str = "FILE.wav";
/// Bytes of the header, of which those of the file's length do not count in it.
const HEADER: u32 = 44;
const UNCOUNTED: u32 = 8;
/// Channels, and bytes of a sample.
const CHANNELS: u16 = 2;
const SAMPLE: u16 = 2;

/// A WAV file that grows with a cook. An unfinished one is removed on drop.
pub struct WavOut {
    place: OutPlace,
    unfinished: LockedFile,
    sound: Sound,
    rate: u32,
    /// Bytes of samples so far.
    length: u32,
    bytes: Vec<u8>,
}

impl WavOut {
    /// Locks the place and begins the sound of a kitchen at a sample rate [Hz].
    pub fn begin(path: &Path, rate: u32, kitchen: &Kitchen) -> Result<Self, CliError> {
        if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("wav")) {
            let place = format!("--wav {}", path.display());
            return Err(CliError::place(place, "has the wrong ending", format!("write --wav {EXAMPLE}")));
        }
        let (place, unfinished) = OutPlace::lock("--wav", path, EXAMPLE)?;
        let sound = Sound::new(kitchen, rate);
        let mut wav = Self { place, unfinished, sound, rate, length: 0, bytes: Vec::new() };
        wav.unfinished.file().set_len(0).and_then(|()| wav.write_header()).map_err(|e| wav.place.error(&e))?;
        Ok(wav)
    }

    /// Writes the sound of the tick that has just ended.
    pub fn on_tick(&mut self, kitchen: &Kitchen) -> Result<(), CliError> {
        self.bytes.clear();
        let samples = self.sound.follow(kitchen).iter().flatten();
        self.bytes.extend(samples.flat_map(|x| pcm(*x).to_le_bytes()));
        let more = u32::try_from(self.bytes.len()).unwrap_or(u32::MAX);
        let Some(length) = self.length.checked_add(more).filter(|length| *length <= u32::MAX - HEADER) else {
            let message = format!("a WAV file holds 4 GB, which is {:.1} hours at {} Hz", self.hours(), self.rate);
            return Err(CliError::place(
                &self.place,
                message,
                "ask for a lower --wav-rate, or let the cook end earlier",
            ));
        };
        self.length = length;
        self.unfinished.file().write_all(&self.bytes).map_err(|e| self.place.error(&e))
    }

    /// Completes the file and gives it its name.
    pub fn finish(mut self) -> Result<(), CliError> {
        let written = self.write_header().and_then(|()| self.unfinished.file().sync_all());
        let Self { place, unfinished, .. } = self;
        written.and_then(|()| unfinished.rename(place.path())).map_err(|e| place.error(&e))
    }

    /// Hours that fit into a file at this rate [h].
    fn hours(&self) -> f64 {
        f64::from(u32::MAX) / (f64::from(self.rate) * f64::from(CHANNELS * SAMPLE)) / 3600.0
    }

    fn write_header(&mut self) -> io::Result<()> {
        let header = header(self.rate, self.length);
        let file = self.unfinished.file();
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&header)?;
        file.seek(SeekFrom::End(0)).map(drop)
    }
}

/// A sample as 16 bits.
fn pcm(x: f32) -> i16 {
    (x * f32::from(i16::MAX)).round() as i16
}

/// The header of a WAV file with so many bytes of samples.
fn header(rate: u32, length: u32) -> Vec<u8> {
    let frame = CHANNELS * SAMPLE;
    let words = [16u16, 0, 1, CHANNELS].map(u16::to_le_bytes).concat();
    [
        b"RIFF".as_slice(),
        &(length + HEADER - UNCOUNTED).to_le_bytes(),
        // The format's length (16), PCM (1) and the channels.
        b"WAVEfmt ",
        &words,
        &rate.to_le_bytes(),
        &(rate * u32::from(frame)).to_le_bytes(),
        &frame.to_le_bytes(),
        &(8 * SAMPLE).to_le_bytes(),
        b"data",
        &length.to_le_bytes(),
    ]
    .concat()
}

/// Reads a sample rate [Hz].
pub fn wav_rate(text: &str) -> Result<u32, String> {
    let (low, high) = (RATES.start(), RATES.end());
    text.parse()
        .ok()
        .filter(|rate| RATES.contains(rate))
        .ok_or_else(|| format!("write whole samples a second from {low} to {high}, as in 44100"))
}
