//! Sessions: what happened in a kitchen, kept as commands with their frames, and played again bit by bit.
//!
//! A [`Recording`] contains what a session began with (a recipe's text; [`set_out`] writes one for a choice of food and pan), each
//! command of a person or a device with the frame at which it took effect, foods that were added or removed, and a hash of the
//! kitchen's state every ten simulated seconds. A [`Replay`] plays it and states where it departs. [`file`](self::session_file) encodes a
//! recording as a `.saute` file that grows by appending.
//!
//! # How to record
//!
//! The owner of a live kitchen calls, in this order:
//! 1. [`Recording::begin`], then [`Recording::observe`] at frame 0, and [`Kitchen::listen`](saute_kitchen::Kitchen::listen) if devices
//!    give commands to the kitchen themselves;
//! 2. before each tick, if a recipe plays: [`Runner::poll`](crate::Runner::poll), then [`Recording::on_steps`];
//! 3. after a command of a person that the kitchen carried out: [`Recording::push`], which stops the recipe; of a kitchen that listens,
//!    [`Recording::take_over`] and [`Recording::take`] instead. For foods [`Recording::add`] and [`Recording::remove`];
//! 4. before each frame, of a kitchen that listens: [`Recording::take`], which leaves the recipe playing;
//! 5. after each frame, [`Recording::observe`].
//!
//! # Time travel
//!
//! A [`Moment`] is a frame, with the entries that were carried out in it so far. [`Recording::moment`] is the present one,
//! [`Recording::moment_at`] the beginning of a frame, [`Recording::before`] the instant before an entry. [`Recording::truncate`] undoes
//! everything after a moment (keep the longer one to redo), [`Recording::fork`] returns a branch that ends there.
//!
//! A [`Replay`] is also a keyframe: [`Replay::at`] makes one of a live kitchen, a clone keeps it, and [`Replay::run_to`] goes on from it to
//! a later moment. Its parts ([`Replay::into_parts`]) go on living.
//!
//! [`Cook::again`](crate::Cook::again) plays a session with all numbers of a cook.
//!
//! ```
//! use saute_kitchen::{Command, Library};
//! use saute_recipe::{Recipe, Recording, Replay};
//!
//! let library = Library::embedded()?;
//! let text = "[[step]]\nhob_w = 1200\n[[step]]\nafter_s = 60\nend = true\n";
//! let recipe = Recipe::parse(text, "warm.toml", &library)?;
//! let mut recording = Recording::begin(&recipe, true, &library);
//! let mut live = Replay::begin(&recording, &library)?;
//! recording.observe(&live.kitchen);
//! let keyframe = live.clone();
//! // A person turns the hob off after two seconds.
//! for frame in 0..180 {
//!     if frame == 120 {
//!         let off = Command::Hob(0.0);
//!         live.kitchen.apply(&off)?;
//!         recording.push(&live.kitchen, off);
//!     }
//!     if live.kitchen.is_between_ticks() && !recording.is_taken_over() {
//!         live.runner.poll(&mut live.kitchen)?;
//!         recording.on_steps(&mut live.kitchen);
//!     }
//!     live.kitchen.advance_frame();
//!     recording.observe(&live.kitchen);
//! }
//! let mut replay = keyframe;
//! replay.run_to(&recording, &library, recording.moment());
//! assert_eq!(replay.departure(), None);
//! assert_eq!(replay.kitchen.state_hash(), live.kitchen.state_hash());
//!
//! // What if the hob had stayed on?
//! let undone = recording.before(0).expect("the command");
//! let fork = recording.fork(undone);
//! assert_eq!(fork.entries().len(), 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod beginning;
mod done;
mod entry;
mod moment;
pub(crate) mod playhead;
mod recording;
mod replay;
pub mod session_file;
mod stored_entries;
mod to_recipe;

pub use beginning::{Beginning, FoodDetail, SetOutFood, set_out};
pub use done::Done;
pub use entry::{Deed, Entry};
pub use moment::Moment;
pub use playhead::{Departure, DepartureCause, Played};
pub use recording::{FRAMES_PER_HASH, Recording};
pub use replay::{Replay, ReplayError};
pub use session_file::{Damage, Opened, SessionError};
pub use stored_entries::{MOST_ACTS, MOST_ADDED, MOST_ENTRIES, limits};
pub use to_recipe::{ToRecipe, ToRecipeError, Told};
