//! Cook cases: validation cases that cook a recipe and compare its results with expected bands and trends.
//!
//! A band (`[[expect]]`) is a number of the summary, by its JSON pointer, `less` another one if given. It is judged at the
//! end of the cook, at a time (`at = { s = 150 }`), or when a step has fired, or some time after it
//! (`at = { step = "flip", nth = 2, after_s = 60 }`). `against` is a second recipe for bands that `compare` both.
//!
//! `[sweep]` cooks the recipe once for each value of a mark in its text, and judges each band for each value. A `[[trend]]`
//! promises that a number never falls, or never rises, along those values: the largest change against the direction, from
//! the best value before it, is at most `slack` in the number's unit, or `slack_pct` percent of that value. `while_below`
//! leaves out the cooks in which a second number is at its limit or beyond; fewer than two cooks fail. `[each]` repeats the
//! sweep for each value of a second mark:
//!
//! ```
//! use saute_lab::CookCase;
//!
//! let text = r#"
//! name = "a hotter hob heats a pan faster"
//! source = "energy balance"
//! evidence = "exact"
//! recipe = '''
//! [[step]]
//! hob_w = @hob_w@
//! [[step]]
//! at_s = 3
//! end = true
//! '''
//! [sweep]
//! replace = "@hob_w@"
//! values = [500, 1000, 2000]
//! [[trend]]
//! quantity = "pan"
//! pointer = "/pan_c/end"
//! unit = "°C"
//! direction = "not_falling"
//! slack = 0
//! [[expect]]
//! quantity = "pan when the hob was set"
//! pointer = "/pan_c/end"
//! at = { step = "hob_w" }
//! unit = "°C"
//! low = 10
//! high = 30
//! "#;
//! let library = saute_kitchen::Library::embedded()?;
//! let verdicts = CookCase::parse(text, "hob.toml", &library)?.verdicts(&library)?;
//! assert_eq!(verdicts.len(), 4);
//! assert!(verdicts.iter().all(|v| v.pass == Some(true)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod case;
mod check;
mod cooked;
mod course;
mod file;
mod moment;
mod sweep;

pub use case::CookCase;
pub use course::{Coordinate, Course};
pub use file::{Seen, SeenAt};
