//! One device that is connected: its loop, its simulator where it has one, and the file of its calibration.

use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

use saute_files::{regular_file, write_whole};
use saute_haptics::control::control_loop::{LoopError, LoopReport, LoopState};
use saute_haptics::strings::kept_calibration::{CalibrationMemory, CalibrationNews};
use saute_haptics::strings::simulator::open_or_simulate;
use saute_haptics::{
    Access, Capabilities, ContactModel, ControlLoop, HapticDevice, KeptCalibration, Named, OpenError, Simulator,
    StringRig, library,
};
use saute_schema::InputError;

/// Errors of connecting a device.
#[derive(Debug, thiserror::Error)]
pub enum ConnectError {
    /// It cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// Its loop cannot be run.
    #[error("{0}\n  remedy: close other programs and try again")]
    Loop(#[from] LoopError),
    /// A file of the program's data or of a calibration cannot be used.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A file that cannot be read or written.
    #[error("{file}: {source}\n  remedy: name another file: --calibration FILE")]
    File {
        /// Which one.
        file: String,
        /// What went wrong.
        source: std::io::Error,
    },
    /// A turner needs place and turning.
    #[error(
        "{name}: senses {dof} degrees of freedom\n  remedy: a turner needs a device that senses 6: saute haptics list"
    )]
    TooFew {
        /// Which device.
        name: String,
        /// How many it senses.
        dof: u8,
    },
}

/// A device at work.
pub struct Connected {
    /// As it was named.
    pub name: String,
    /// Its capabilities.
    pub capabilities: Capabilities,
    /// How to reach it; empty for a device in memory or a simulated one.
    pub access: Option<Access>,
    /// Its strings as drawn.
    pub strings: Option<StringRig>,
    control: ControlLoop,
    state: LoopState,
    news: CalibrationNews,
    file: Option<PathBuf>,
    /// What its driver reports, such as why a message is rejected; none from a device that reports nothing.
    notices: Option<Receiver<String>>,
    /// The last of them.
    reported: Option<String>,
    /// The simulator's process; it ends after the loop.
    simulator: Option<Simulator>,
}

impl Connected {
    /// Opens a device by NAME[@PLACE], simulated where it is of strings and has no place. Its calibration is read from
    /// a file and kept there.
    pub fn open(text: &str, pairing: u32, file: Option<PathBuf>) -> Result<Self, ConnectError> {
        let named = Named::parse(text)?;
        let (opened, simulator) = open_or_simulate(&named, pairing, None)?;
        let access = simulator.is_none().then_some(opened.access);
        let connected = Self::start(text, opened.device, file)?;
        Ok(Self { access, simulator, notices: opened.notices, ..connected })
    }

    /// Runs the loop of a device.
    pub fn start(name: &str, mut device: Box<dyn HapticDevice>, file: Option<PathBuf>) -> Result<Self, ConnectError> {
        let known = file.as_deref().map(kept).transpose()?.flatten();
        let (memory, news) = CalibrationMemory::new(known);
        device.remember(memory);
        let (capabilities, strings) = (device.capabilities().clone(), device.strings());
        let control = ControlLoop::start(device, &library::feel()?, 0)?;
        let state = LoopState::default();
        let name = name.to_owned();
        let (access, notices, reported, simulator) = (None, None, None, None);
        Ok(Self { name, capabilities, access, strings, control, state, news, file, notices, reported, simulator })
    }

    /// Reads the state of the loop and what the driver reports.
    pub fn update(&mut self) -> &LoopState {
        self.state = self.control.state();
        if let Some(last) = self.notices.iter().flat_map(Receiver::try_iter).last() {
            self.reported = Some(last);
        }
        &self.state
    }

    /// State of the loop when it was read last.
    pub fn state(&self) -> &LoopState {
        &self.state
    }

    /// What its driver reported last, such as why a message is rejected.
    pub fn reported(&self) -> Option<&str> {
        self.reported.as_deref()
    }

    /// Publishes what the hand feels.
    pub fn send(&mut self, model: &ContactModel) {
        self.control.publish(*model);
    }

    /// Stops the device; it stays stopped until `resume`.
    pub fn stop(&self) {
        self.control.emergency_stop();
    }

    /// Lets a stopped device make forces again.
    pub fn resume(&self) {
        self.control.resume();
    }

    /// Returns true if it is simulated in its own process.
    pub fn is_simulated(&self) -> bool {
        self.simulator.is_some()
    }

    /// Writes the calibration that the jig has sent since the last call; returns the file.
    pub fn keep_calibration(&mut self) -> Result<Option<PathBuf>, ConnectError> {
        let (Some(found), Some(file)) = (self.news.take(), &self.file) else { return Ok(None) };
        let written = found.text().map_err(std::io::Error::other).and_then(|text| {
            file.parent().map_or(Ok(()), std::fs::create_dir_all)?;
            write_whole(file, text.as_bytes())
        });
        written.map_err(|source| unusable(file, source))?;
        Ok(Some(file.clone()))
    }

    /// Ends the loop; returns a report of the run.
    pub fn end(self) -> Result<LoopReport, ConnectError> {
        Ok(self.control.end()?)
    }
}

fn unusable(file: &Path, source: std::io::Error) -> ConnectError {
    ConnectError::File { file: file.display().to_string(), source }
}

/// Largest calibration that is read [MiB] (chosen: a usual one has 1 kB).
const LARGEST_MIB: u64 = 1;

/// What a file keeps; nothing where there is no file yet.
fn kept(file: &Path) -> Result<Option<KeptCalibration>, ConnectError> {
    match regular_file::read_text(file, LARGEST_MIB) {
        Ok(text) => Ok(Some(KeptCalibration::parse(&text, &file.display().to_string())?)),
        Err(unread) if unread.is_missing() => Ok(None),
        Err(unread) => Err(unusable(file, std::io::Error::other(unread))),
    }
}
