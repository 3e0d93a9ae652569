//! What a speaker needs of a sound card.

/// Length of the blocks in which a speaker makes samples [samples]: 5 ms at 48 kHz (chosen: short against a picture).
pub const BLOCK: usize = 256;

/// Why nothing is heard.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Trouble {
    /// The system has no library of sound that is known here.
    #[error("this system has no ALSA (libasound.so.2)")]
    NoLibrary,
    /// The library has not what is needed of it.
    #[error("libasound.so.2 lacks {0}")]
    OldLibrary(&'static str),
    /// A device cannot be opened or does not play.
    #[error("{0}")]
    Device(String),
    /// The system gives no thread.
    #[error("no thread: {0}")]
    NoThread(String),
}

impl Trouble {
    /// Returns true if it may pass: a device that was unplugged comes back, a library does not come.
    pub fn may_pass(&self) -> bool {
        matches!(self, Self::Device(_))
    }
}

/// A sound card that plays.
pub trait Device {
    /// Sample rate [Hz].
    fn rate(&self) -> u32;

    /// Plays samples after those of the last call, left and right [-]; waits while its buffer is full.
    ///
    /// # Errors
    ///
    /// If it does not play any more, as when it is unplugged.
    fn play(&mut self, block: &[[f32; 2]]) -> Result<(), Trouble>;
}
