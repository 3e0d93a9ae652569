//! Texts in the window's languages.

pub mod act_words;
pub mod coach_words;
pub mod cue_words;
pub mod guided_words;
pub mod judgement_words;
pub mod language;
pub(crate) mod next_step;
pub(crate) mod piece_words;
pub mod plan_words;
pub mod planned_words;
pub mod refusal;
pub mod told;
pub mod view_words;
