//! Pictures and time lapses that are made in the background, with their own graphics device.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use saute_kitchen::Library;
use saute_picture::still::animation::{FRAMES_PER_S, Format, animation};
use saute_picture::still::headless::{Gather, Gpu, picture};
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::series::Series;
use saute_picture::still::shot::ShotOptions;
use saute_recipe::{Cook, Recording};
use saute_scene::input::SceneInput;
use saute_scene::light::gathered::LightSample;
use saute_scene::quality::Quality;
use saute_scene::renderer::SampleProgress;

use crate::desktop::files::write_picture;

/// Frames of a time lapse at most (chosen: it lasts ten seconds).
const FRAMES: u32 = 10 * FRAMES_PER_S as u32;
/// Simulated time between two frames at least [s] (chosen: nothing slower than food moves faster).
const LEAST_EVERY_S: f64 = 0.5;
/// Size of a time lapse [pixels] (chosen: can be sent; a GIF of 1280 × 720 fills tens of megabytes).
const LAPSE_SIZE: [u32; 2] = [640, 360];

/// A picture or a time lapse in the making; it ends when it is dropped.
#[derive(Debug)]
pub struct Making {
    done: Arc<AtomicU32>,
    all: u32,
    stopped: Arc<AtomicBool>,
    answer: Receiver<Result<PathBuf, String>>,
}

impl Making {
    /// How much is done (0–1).
    pub fn progress(&self) -> f32 {
        self.done.load(Ordering::Relaxed) as f32 / self.all as f32
    }

    /// The file that was made, or why it could not be; none while it is in the making.
    pub fn made(&self) -> Option<Result<PathBuf, String>> {
        match self.answer.try_recv() {
            Ok(made) => Some(made),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err("the drawing broke off".to_owned())),
        }
    }
}

impl Drop for Making {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
    }
}

/// What the thread sends to the window.
#[derive(Clone)]
struct Executor {
    done: Arc<AtomicU32>,
    stopped: Arc<AtomicBool>,
    ctx: egui::Context,
    folder: PathBuf,
}

impl Executor {
    /// Writes a file into the folder of pictures under a name that is free.
    fn save(&self, ending: &str, bytes: &[u8]) -> Result<PathBuf, String> {
        write_picture(&self.folder, ending, bytes)
    }

    /// One more part is done; returns false if nobody waits any more.
    fn goes_on(&self) -> bool {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.ctx.request_repaint();
        !self.stopped.load(Ordering::Relaxed)
    }
}

/// Begins to make something.
pub struct Maker {
    /// The window, which is drawn again when something is done.
    pub ctx: egui::Context,
    /// Where the file will be.
    pub folder: PathBuf,
}

impl Maker {
    /// A picture of a scene at the best quality.
    pub fn photo(self, scene: Arc<SceneInput>, size: [u32; 2]) -> std::io::Result<Making> {
        self.begin(LightSample::KEPT, move |executor| {
            let gpu = Gpu::open().map_err(|error| error.to_string())?;
            let counting = executor.clone();
            let told: SampleProgress = Box::new(move |_, _| _ = counting.goes_on());
            let drawn =
                picture(&gpu, &scene, size, Quality::Best, Gather { samples: LightSample::KEPT, told: Some(told) });
            executor.save("png", &png_bytes(&drawn).map_err(|error| error.to_string())?)
        })
    }

    /// A time lapse of a cook from its beginning to the instant that is shown.
    pub fn time_lapse(
        self,
        recording: Recording,
        library: Arc<Library>,
        options: ShotOptions,
    ) -> std::io::Result<Making> {
        let until_s = recording.moment().time_s();
        let every_s = (until_s / f64::from(FRAMES)).max(LEAST_EVERY_S);
        let count = (until_s / every_s + 1e-9).floor() as u32 + 1;
        self.begin(count, move |executor| {
            let cook = Cook::again(recording, library).map_err(|error| error.to_string())?;
            let mut series = Series::of(cook, options, LAPSE_SIZE).map_err(|error| error.to_string())?;
            let mut frames = Vec::new();
            for k in 0..count {
                let frame = series.at(f64::from(k) * every_s).map_err(|error| error.to_string())?;
                frames.extend(frame);
                if !executor.goes_on() {
                    return Err("the window was closed".to_owned());
                }
            }
            executor.save("gif", &animation(Format::Gif, &frames).map_err(|error| error.to_string())?)
        })
    }

    fn begin(
        self,
        all: u32,
        make: impl FnOnce(&Executor) -> Result<PathBuf, String> + Send + 'static,
    ) -> std::io::Result<Making> {
        let (send, answer) = channel();
        let (done, stopped) = (Arc::default(), Arc::default());
        let making = Making { done: Arc::clone(&done), all, stopped: Arc::clone(&stopped), answer };
        let executor = Executor { done, stopped, ctx: self.ctx, folder: self.folder };
        std::thread::Builder::new().name("photo".to_owned()).spawn(move || {
            // Nobody waits for the answer once the window is closed.
            let _ = send.send(make(&executor));
            executor.ctx.request_repaint();
        })?;
        Ok(making)
    }
}
