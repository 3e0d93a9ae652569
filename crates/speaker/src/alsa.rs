//! ALSA's library of sound, opened at run time: seven of its functions. The only module of the simulator that calls code of the system.
//!
//! Neither headers nor packages of ALSA are needed to build it, and none of its files to start it. The functions are those of ALSA 1.0
//! (2004) and later, whose types have not changed since.
#![allow(unsafe_code, reason = "a library that is opened at run time has C functions")]

use std::ffi::{CStr, CString, c_char, c_int, c_long, c_uint, c_ulong, c_void};
use std::ptr::null_mut;

use libloading::Library;

use crate::device::{BLOCK, Device, Trouble};

/// Name of the library's file.
pub const LIBRARY: &str = "libasound.so.2";
/// The device that the person's own configuration of ALSA names; with PipeWire or PulseAudio theirs.
pub const DEFAULT: &str = "default";

/// Length of the device's own buffer [µs] (chosen: a desktop's mixer holds it without gaps).
const BUFFER_US: c_uint = 40_000;
/// Rates that are requested, in this order until one is available [Hz] (chosen: those of sound cards, the usual ones first).
const RATES: [u32; 6] = [48_000, 44_100, 96_000, 88_200, 192_000, 32_000];
/// Tries to go on after an interruption, as by a sleep of the machine [-] (chosen).
const TRIES: u32 = 3;

/// A device of ALSA.
type Pcm = *mut c_void;
/// What is called with the library's own messages.
type OnMessage = unsafe extern "C" fn(*const c_char, c_int, *const c_char, c_int, *const c_char, *mut c_void);

/// The functions.
struct Functions {
    open: unsafe extern "C" fn(*mut Pcm, *const c_char, c_int, c_int) -> c_int,
    set_params: unsafe extern "C" fn(Pcm, c_int, c_int, c_uint, c_uint, c_int, c_uint) -> c_int,
    write: unsafe extern "C" fn(Pcm, *const c_void, c_ulong) -> c_long,
    recover: unsafe extern "C" fn(Pcm, c_int, c_int) -> c_int,
    close: unsafe extern "C" fn(Pcm) -> c_int,
    message: unsafe extern "C" fn(c_int) -> *const c_char,
    /// The functions are those of this library for as long as it is open.
    _library: Library,
}

impl Functions {
    fn load(library: &str) -> Result<Self, Trouble> {
        // SAFETY: the library is a system's file, which runs no code when it is opened.
        let library = unsafe { Library::new(library) }.map_err(|_| Trouble::NoLibrary)?;
        // SAFETY: each type is that of the function in alsa/pcm.h and alsa/error.h.
        unsafe {
            let quiet: unsafe extern "C" fn(Option<OnMessage>) -> Option<OnMessage> =
                function(&library, "snd_lib_error_set_local")?;
            quiet(Some(say_nothing));
            Ok(Self {
                open: function(&library, "snd_pcm_open")?,
                set_params: function(&library, "snd_pcm_set_params")?,
                write: function(&library, "snd_pcm_writei")?,
                recover: function(&library, "snd_pcm_recover")?,
                close: function(&library, "snd_pcm_close")?,
                message: function(&library, "snd_strerror")?,
                _library: library,
            })
        }
    }

    /// What an error of the library means, with what was tried.
    fn trouble(&self, tried: &str, error: c_long) -> Trouble {
        // SAFETY: the text is constant, or lasts until the next call in this thread.
        let text = unsafe { CStr::from_ptr((self.message)(error as c_int)) };
        Trouble::Device(format!("{tried}: {}", text.to_string_lossy()))
    }
}

/// Finds a function.
///
/// # Safety
///
/// `F` must be the type of the function.
unsafe fn function<F: Copy>(library: &Library, name: &'static str) -> Result<F, Trouble> {
    // SAFETY: as the caller promises.
    let found = unsafe { library.get::<F>(name.as_bytes()) };
    found.map(|symbol| *symbol).map_err(|_| Trouble::OldLibrary(name))
}

/// What the library would print on a machine without a sound card is reported once, in the window.
unsafe extern "C" fn say_nothing(
    _: *const c_char,
    _: c_int,
    _: *const c_char,
    _: c_int,
    _: *const c_char,
    _: *mut c_void,
) {
}

/// Forms of samples, by ALSA's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// 32-bit floating point.
    Float,
    /// 16-bit integers.
    Short,
}

impl Form {
    const ALL: [Self; 2] = [Self::Float, Self::Short];

    fn number(self) -> c_int {
        let is_big = c_int::from(cfg!(target_endian = "big"));
        match self {
            Self::Float => 14 + is_big,
            Self::Short => 2 + is_big,
        }
    }
}

/// What the library answers where there is no card: ENOENT and ENODEV of Linux, negative.
const NONE_THERE: [c_int; 2] = [-2, -19];

/// A device that is open.
pub struct Alsa {
    functions: Functions,
    pcm: Pcm,
    rate: u32,
    form: Form,
    shorts: Vec<[i16; 2]>,
}

impl Alsa {
    /// Opens a device by its name in ALSA.
    ///
    /// # Errors
    ///
    /// If there is no ALSA, no such device, or it plays no stereo.
    pub fn open(name: &str) -> Result<Self, Trouble> {
        Self::open_with(LIBRARY, name)
    }

    /// As [`Self::open`], with a library's file.
    ///
    /// # Errors
    ///
    /// As [`Self::open`].
    pub fn open_with(library: &str, name: &str) -> Result<Self, Trouble> {
        let functions = Functions::load(library)?;
        let name = CString::new(name).map_err(|error| Trouble::Device(error.to_string()))?;
        let mut pcm: Pcm = null_mut();
        // SAFETY: the pointers are valid; 0 and 0 are playback that waits.
        let opened = unsafe { (functions.open)(&raw mut pcm, name.as_ptr(), 0, 0) };
        if NONE_THERE.contains(&opened) {
            return Err(Trouble::Device("no sound card".to_owned()));
        }
        if opened < 0 {
            return Err(functions.trouble("the sound card does not open", c_long::from(opened)));
        }
        let mut device = Self { functions, pcm, rate: 0, form: Form::Float, shorts: Vec::with_capacity(BLOCK) };
        device.agree()?;
        Ok(device)
    }

    /// Agrees with the device on form and rate.
    fn agree(&mut self) -> Result<(), Trouble> {
        let mut refused = 0;
        for (form, rate) in RATES.into_iter().flat_map(|rate| Form::ALL.map(|form| (form, rate))) {
            // SAFETY: the device is open; 3 is interleaved, then two channels, and the library may change the rate for the card.
            refused = unsafe { (self.functions.set_params)(self.pcm, form.number(), 3, 2, rate, 1, BUFFER_US) };
            if refused == 0 {
                (self.form, self.rate) = (form, rate);
                return Ok(());
            }
        }
        Err(self.functions.trouble("the sound card takes no stereo", c_long::from(refused)))
    }

    /// Writes what is left of a block; returns how many samples the device took.
    fn write(&mut self, from: usize, block: &[[f32; 2]]) -> c_long {
        let left = (block.len() - from) as c_ulong;
        let data: *const c_void = match self.form {
            Form::Float => block[from..].as_ptr().cast(),
            Form::Short => self.shorts[from..].as_ptr().cast(),
        };
        // SAFETY: the device is open, and there are that many samples of its form.
        unsafe { (self.functions.write)(self.pcm, data, left) }
    }

    /// Goes on after an interruption.
    fn recover(&self, error: c_long) -> Result<(), Trouble> {
        // SAFETY: the device is open; 1 prints nothing.
        let gone = unsafe { (self.functions.recover)(self.pcm, error as c_int, 1) };
        if gone < 0 { Err(self.functions.trouble("the sound card does not play", c_long::from(gone))) } else { Ok(()) }
    }
}

impl Device for Alsa {
    fn rate(&self) -> u32 {
        self.rate
    }

    fn play(&mut self, block: &[[f32; 2]]) -> Result<(), Trouble> {
        if self.form == Form::Short {
            self.shorts.clear();
            self.shorts.extend(block.iter().map(|frame| frame.map(|x| (x * f32::from(i16::MAX)) as i16)));
        }
        let (mut done, mut tries) = (0, 0);
        while done < block.len() {
            let taken = self.write(done, block);
            if taken > 0 {
                done += taken as usize;
                continue;
            }
            tries += 1;
            if tries > TRIES {
                return Err(self.functions.trouble("the sound card does not play", taken));
            }
            self.recover(taken)?;
        }
        Ok(())
    }
}

impl Drop for Alsa {
    fn drop(&mut self) {
        // SAFETY: the device is open, and nothing uses it afterwards. What it cannot close it has lost.
        unsafe { (self.functions.close)(self.pcm) };
    }
}
