//! Heavy work off the frame: orders as bytes that go away, answers as bytes that come back.
//!
//! Each [`WorkKind`] has its own worker, so that none waits behind another. The window hires a [`Helper`] for a kind from
//! its [`Agency`], gives it orders and goes on drawing. On the other side an [`Executor`](self::executor::Executor) does the work in slices:
//! on a thread in the native window, in a second instance of the program in a page's worker, or, where there is neither, in the
//! window's own thread between frames. Nothing is shared: what an order needs is in its bytes, or in the embedded library. A page has
//! no threads within a worker: for what takes long, two workers get the same order, begin at opposite ends of each round and tell each
//! other what they have done ([`WorkKind::is_shared`]).
//!
//! To add a kind of work: a variant of [`WorkKind`] with its name, and a [`Worker`](self::worker::Worker) in [`executor`]. The page's
//! scripts take the name as it is. An order replaces the one before and an empty one ends the work, so answers state the number of
//! their order: some of an earlier one may still be on their way.

pub mod executor;
pub mod in_frames;
pub mod job;
#[cfg(not(target_arch = "wasm32"))]
pub mod thread;
pub mod worker;

use std::sync::Arc;

use saute_kitchen::Library;
pub use saute_plan::End;

/// A kind of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum WorkKind {
    /// A recorded cook is played.
    Play,
    /// Forecasts from the present of a cook.
    Forecast,
    /// A plan is searched for.
    Plan,
    /// A kitchen at home is fitted.
    Fit,
}

impl WorkKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Play, Self::Forecast, Self::Plan, Self::Fit];

    /// Its name, under which a page's scripts find it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Play => "play",
            Self::Forecast => "forecast",
            Self::Plan => "plan",
            Self::Fit => "fit",
        }
    }

    /// The kind with a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// True if two executors, each on a core of its own, do an order together in less time.
    pub fn is_shared(self) -> bool {
        matches!(self, Self::Plan | Self::Fit)
    }

    /// Rest after work, as a share of the time that it took [-].
    fn rest_share(self) -> f64 {
        match self {
            // Half of one core at most.
            Self::Forecast => 1.0,
            Self::Play | Self::Plan | Self::Fit => 0.0,
        }
    }
}

/// A worker elsewhere. It may be slow; it gets a new order when another result is needed.
pub trait Helper {
    /// Takes an order in place of the one before; an empty one ends the work.
    fn ask(&mut self, order: Vec<u8>);

    /// Answers that have come since the last call; none once the helper is of no use any more.
    fn answers(&mut self) -> Option<Vec<Vec<u8>>>;

    /// Returns true if it works only when it is polled for answers: the window draws frames for it.
    fn needs_frames(&self) -> bool {
        false
    }
}

/// Who finds helpers.
pub trait Agency {
    /// A helper for a kind of work. Where nobody else is free, it works in frames.
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper>;
}
