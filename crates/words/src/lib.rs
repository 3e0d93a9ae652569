//! What the program writes for people, in every one of its languages: texts, numbers and times, and the sentences about a cook.
//!
//! [`language`] finds texts by their keys; [`speech`] adds the unit of temperatures. The other modules put the results of the core into
//! sentences. This crate computes nothing about food and draws nothing.

pub mod act_words;
pub mod clock;
pub mod coach_words;
pub mod cue_words;
pub mod doneness_words;
pub mod guided_words;
pub mod judgement_words;
pub mod language;
mod language_files;
pub mod mark_words;
pub mod next_step;
pub mod piece_words;
pub mod plan_words;
pub mod planned_words;
pub mod refusal;
pub mod speech;
